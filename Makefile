# make              the library and the command          make demo    a cloud becomes a closed surface, from nothing
# make test         units, properties, golden rows       make check   all tests (installs what they need)
# make audit        every public name in every room      make floors  nobody includes from above
# make golden       golden rows made again, and compared make golden-accept   and put in place
# make fuzz T=60 [F=NAME] [ENGINE=afl]   fuzz all properties, or one          make fuzz-min   what that found, into fuzz/corpus
# make cover        line and branch coverage
# make accuracy     bounds beside the worst errors seen    make bits    the same bits everywhere
# make faults       no memory, no room on the disk     make conformance other libraries judged: docs/scoreboard.md
# make mutants      small faults put into the code: which do the tests notice?  ROOMS="som fit" FILES=param.c SAMPLE=1/10
# make proofs       everything that is proved, proved again: proofs/README.md
# make bench        speed, as ratios to named peers      make install DESTDIR= PREFIX=/usr/local
# make P=asan ...   the same under another profile: release, native, clang, debug, asan, fuzz, afl, cover

comma := ,
P       ?= release
BUILD   ?= build
B       := $(BUILD)/$(P)
ROOMS   ?= base spline net som fit refine exact io conform cli
VERSION := 0.1.0
PREFIX  ?= /usr/local
T       ?= 10

CC_release = gcc
CC_native  = gcc
CC_clang   = clang
CC_debug   = gcc
CC_asan    = clang
CC_fuzz    = clang
CC_afl     = afl-clang-fast
CC_cover   = gcc
CXX_release = g++
CXX_native  = g++
CXX_clang   = clang++
CXX_debug   = g++
CXX_asan    = clang++
CXX_fuzz    = clang++
CXX_afl     = afl-clang-fast++
CXX_cover   = g++
FLAGS_release = -O2
FLAGS_native  = -O3 -march=native
FLAGS_clang   = -O3
FLAGS_debug   = -O0
FLAGS_asan    = -O1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FLAGS_fuzz    = -O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
FLAGS_afl     = -O1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FLAGS_cover   = -O0 --coverage -fprofile-update=atomic
OMP_release = -fopenmp
OMP_native  = -fopenmp
OMP_cover   = -fopenmp
include tests/bits/profiles.mk
CC     := $(CC_$(P))
CXX    := $(CXX_$(P))
# Threads where the compiler has them: a pragma more or less never changes a bit of a result.
OMP    := $(if $(OMP_$(P)),$(shell echo 'int main(void){return 0;}' | $(CC) -fopenmp -x c -o /dev/null - 2>/dev/null && echo -fopenmp))
COMMON := -g -ffp-contract=off -fno-math-errno -ffile-prefix-map=$(CURDIR)=. -Wall -Wextra -Wshadow -Wconversion -Wno-unknown-pragmas -Werror -Iinclude -Isrc
CFLAGS   = -std=c99 -pedantic-errors -Wstrict-prototypes -Wvla $(COMMON) $(FLAGS_$(P)) $(OMP) -D_POSIX_C_SOURCE=200809L
# Eigen's types have another layout under -march=native than in the Ceres that is installed.
CXXFLAGS = -std=c++17 $(COMMON) $(filter-out -march=native,$(FLAGS_$(P))) -isystem /usr/include/eigen3 $(if $(filter asan fuzz afl,$(P)),-fno-sanitize=vptr)
LDFLAGS ?= -Wl,--as-needed
# A program that leaves by _exit has to tell first what it has reached.
LEAVING := $(if $(filter cover,$(P)),$(B)/tests/cover/exit.c.o)
override LDFLAGS += $(if $(LEAVING),-Wl$(comma)--wrap=_exit)
LIBS   := -lceres -lglog -llapacke -llapack -lblas -ljansson -lflint-arb -lflint -lmpfr -lgmp -lstdc++ -lm
LDLIBS  = $(filter-out $(LEFT_OUT_LIBS),$(LIBS))
# GSL and SISL are second opinions: tests and peers only.
GSL    := -lgsl -lgslcblas -lsisl

LIBROOMS := $(filter-out cli,$(ROOMS))
SRC   := $(filter-out $(LEFT_OUT),$(foreach r,$(LIBROOMS),$(wildcard src/$(r)/*.c) $(wildcard src/$(r)/*.cpp)))
CLI   := $(filter-out $(LEFT_OUT),$(if $(filter cli,$(ROOMS)),$(wildcard src/cli/*.c)))
TEST  := $(filter-out $(LEFT_OUT),$(wildcard tests/*.c) $(foreach r,$(ROOMS),$(wildcard tests/$(r)/test_*.c)))
BENCH := $(wildcard tests/bench/bench_*.c tests/bench/*_table.c)
MODULES := $(basename $(notdir $(SRC)))
ROWS    := $(foreach m,$(MODULES),$(wildcard golden/$(m).tsv))
VECTORS := $(if $(filter conform,$(ROOMS)),$(filter-out %/schema.json,$(wildcard golden/conformance/*.json)))
CORPUS  := $(filter-out $(if $(CLI),,fuzz/corpus/search/search_run_checkpoint_raw.%),$(foreach m,$(MODULES),$(wildcard fuzz/corpus/$(m)/*)))
OBJ    = $(addprefix $(B)/,$(addsuffix .o,$(1)))
LIBO  := $(call OBJ,$(filter %.c,$(SRC))) $(call OF,$(filter %.cpp,$(SRC)))
CLIO  := $(call OBJ,$(CLI))
# The command's own readers are tested from inside.
TESTO := $(call OF,$(TEST)) $(call OBJ,$(filter-out src/cli/main.c,$(CLI)))
FUZZO := $(filter-out $(B)/tests/check.c.o,$(TESTO)) $(B)/fuzz/fuzz.c.o $(B)/registry.o
BENCHO := $(call OBJ,$(wildcard tests/bench/*.c))
INPUTO  := $(call OBJ,$(wildcard tests/bench/*_input.c))
BENCHES := $(patsubst tests/bench/%.c,$(B)/%,$(BENCH))
PEERS   := $(addprefix $(B)/,$(basename $(notdir $(wildcard tests/bench/peer_*.c tests/bench/peer_*.cpp))))

all: $(B)/libetalon.a $(if $(CLI),$(B)/etalon)

# The lists of files: a file that is gone is a change, too.
$(shell mkdir -p $(B); for l in 'lib $(LIBO)' 'test $(TEST)'; do set -- $$l; \
	printf '%s\n' "$$l" | cmp -s - $(B)/$$1.list || printf '%s\n' "$$l" > $(B)/$$1.list; done)

$(B)/libetalon.a: $(LIBO) $(B)/lib.list
	rm -f $@ && $(AR) rcsD $@ $(LIBO)
$(B)/etalon: $(CLIO) $(LEAVING) $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(B)/%.c.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(if $(filter tests/% fuzz/%,$<),-Itests $(TEST_FLAGS_$(P))) -MMD -MP -c -o $@ $<
$(B)/%.cpp.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) -MMD -MP -c -o $@ $<
-include $(patsubst %.o,%.d,$(LIBO) $(CLIO) $(TESTO) $(BENCHO) $(B)/tests/conform/frozen.c.o $(B)/fuzz/fuzz.c.o)

# The list of properties and of golden checks is read off the tests' own definitions.
$(B)/registry.c: $(TEST) $(B)/test.list tests/registry.sh
	@mkdir -p $(@D)
	sh tests/registry.sh $(TEST) > $@.new && mv $@.new $@
$(B)/registry.o: $(B)/registry.c
	$(CC) $(CFLAGS) -Itests -c -o $@ $<
$(B)/check: $(TESTO) $(B)/registry.o $(LEAVING) $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o %.a,$^) $(filter-out $(LEFT_OUT_LIBS),$(GSL)) $(LDLIBS)
$(B)/libfuzz.a: $(FUZZO) $(B)/libetalon.a
	rm -f $@ && $(AR) rcsD $@ $(FUZZO)
print-libs:
	@echo $(LDLIBS)
$(B)/fuzzer: $(FUZZO) $(B)/libetalon.a
	$(CC) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $(filter %.o %.a,$^) $(GSL) $(LDLIBS)

# Each prints one line a test and a last line `N passed, N failed`; sum.sh adds them up.
SUM := sh tests/sum.sh
test: $(B)/check $(if $(VECTORS),$(B)/frozen)
	@$(SUM) -j 2 '$(B)/check' $(if $(CORPUS),'$(B)/check --replay $(CORPUS)') $(if $(ROWS),'$(B)/check --golden $(ROWS)') \
	  $(if $(ROWS),$(if $(filter exact,$(ROOMS)),'$(B)/check --truth $(ROWS)')) $(if $(VECTORS),'$(B)/frozen $(VECTORS)')
harness:
	@$(SUM) 'sh tests/harness.sh $(BUILD)/harness $(CC_release)' 'sh tests/harness/rooms.sh $(BUILD)/harness $(CC_release)'
bites: $(B)/check
	@$(B)/check --bite $(ROWS)
# The rows are made again by their generators, and computed by the functions and by the exact layer.
golden: $(B)/check $(if $(VECTORS),$(B)/frozen)
	@$(SUM) '$(MAKE) -s rows' '$(B)/check --golden $(ROWS)' '$(B)/check --truth $(ROWS)' $(if $(VECTORS),'$(B)/frozen $(VECTORS)')
rows:
	@$(SUM) 'sh tests/golden.sh compare $(BUILD)/golden' 'python3 tests/golden/second.py'
golden-accept:
	@sh tests/golden.sh accept $(BUILD)/golden
asan:
	@UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1 $(MAKE) P=asan test
valgrind: $(B)/check
	@ET_RUNS=$${ET_RUNS:-20} OMP_NUM_THREADS=1 valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite $(B)/check
audit: $(B)/libetalon.a
	@$(SUM) 'sh tests/audit.sh $(B)/libetalon.a' 'sh tests/kinds.sh $(B)/libetalon.a'
floors:
	@sh tests/floors.sh '$(CC)'
contracts:
	@sh tests/contracts.sh include
docs: $(B)/libetalon.a
	@sh tests/docs.sh $(B)/libetalon.a $(BUILD) '$(CC) $(OMP) -ffp-contract=off' '-Wl,--as-needed $(LIBS)'
# The worst errors seen in 10^7 cases a degree, beside the bounds, put into docs/accuracy.md (some ten minutes); check tries a few.
accuracy: $(B)/accuracy
	@sh tests/accuracy.sh $(B)/accuracy 10000000 docs/accuracy.md
within: $(B)/accuracy
	@$(B)/accuracy 20000 > /dev/null && echo "ok errors of bases and points stay below their bounds"
# The frozen vectors, against the exact layer and the judge.
$(B)/frozen: $(B)/tests/conform/frozen.c.o $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(B)/accuracy: $(B)/tests/bench/accuracy.c.o $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
bits:
	@sh tests/deps.sh $(PACKAGES_BITS) || echo "what needs them fails below"
	@sh tests/bits.sh $(BUILD) $(PARTS)
# Memory refused at every request, of the functions and of the command; a disk that is full at every write.
WRAP := -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=posix_memalign,--wrap=free,--wrap=_Znwm,--wrap=strdup,--wrap=newlocale,--wrap=et_size_mul,--wrap=linalg_fits,$(subst $() ,$(comma),$(patsubst %,--wrap=LAPACKE_%,dgeqp3 dpotrf dpocon dpotrs dgelsd_work dpbtrf dpbcon dtbcon) \
	$(patsubst %,--wrap=posix_spawn%,_file_actions_init _file_actions_adddup2 _file_actions_addclose attr_init attr_setflags attr_setpgroup attr_setsigdefault attr_setsigmask))
$(B)/memory: $(B)/tests/faults/memory.c.o $(LEAVING) $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) $(WRAP) -o $@ $^ $(LDLIBS)
# No memory, under the sanitizers: what a refusal leaves behind may be wrong without being seen.
refused:
	@ASAN_OPTIONS=allocator_may_return_null=1 $(MAKE) -s P=asan refusing
refusing: $(B)/memory
	@mkdir -p $(B)/faults
	@$(SUM) '$(B)/memory $(B)/faults 2> $(B)/faults/told || { cat $(B)/faults/told >&2; exit 1; }'
faults: $(B)/memory $(B)/etalon
	@mkdir -p $(B)/faults
	@$(SUM) '$(B)/memory $(B)/faults' 'sh tests/faults.sh $(B) $(B)/etalon $(or $(MOST),120)'
left-out:
	@printf '%s: in C++, or uses what is\n' $(sort $(patsubst src/cli/%,src/cli,$(LEFT_OUT)))
$(B)/replay: $(B)/tests/bits/replay.c.o $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
# Each target for T seconds under libFuzzer or, with ENGINE=afl, AFL++; F: one property, or all of a module, or a shell's list of them.
ENGINE ?= fuzz
fuzz:
	@sh tests/deps.sh $(PACKAGES_FUZZ)
	@$(MAKE) -s $(J) P=$(ENGINE) $(BUILD)/$(ENGINE)/fuzzer
	@sh fuzz/fuzz.sh $(BUILD) $(ENGINE) $(T) $(F)
fuzz-min:
	@$(MAKE) -s $(J) P=fuzz $(BUILD)/fuzz/fuzzer
	@sh fuzz/min.sh $(BUILD) $(F)
# The rooms asked for are mutated; the program with the mutants needs all.  Some hours of one processor from nothing; what is known is kept.
mutants:
	@$(MAKE) -s ROOMS='base spline net som fit refine exact io conform cli' MUTANT_ROOMS='$(filter $(MUTABLE),$(ROOMS))' mutate
MUTABLE := spline net som fit refine exact
mutate: $(LIBO) $(TESTO) $(B)/registry.o
	@python3 tests/mutants/mutants.py --build $(BUILD)/mutants --rooms '$(MUTANT_ROOMS)' --files '$(FILES)' --sample '$(or $(SAMPLE),1/1)' \
	  --tables '$(ROWS)' --corpus '$(CORPUS)' --objects '$(LIBO) $(TESTO) $(B)/registry.o' --libs='-Wl,--as-needed $(GSL) $(LDLIBS) $(OMP)' $(MUTANTS)
mutants-self:
	@sh tests/mutants/self.sh $(BUILD)/mutants-self $(CC_release)
# What the tests reach, with memory and disk failing, too; every line they do not reach stands in tests/cover/unreached.tsv with the reason.
cover:
	@$(MAKE) -s $(J) P=cover covering
	@sh tests/cover.sh $(BUILD)
covering: all $(B)/check $(B)/memory

export AFL_QUIET := 1
export AFL_DONT_OPTIMIZE := 1
J := -j$(shell nproc 2> /dev/null || echo 1)
built: all $(B)/check
# The builds one after the other with all processors, then as many of the rest at once; the longest first.
check: deps-test
	@$(SUM) '$(MAKE) -s $(J) built' '$(MAKE) -s $(J) P=clang built' '$(MAKE) -s $(J) P=asan built' '$(MAKE) -s $(J) also' \
	  "$(SUM) -j $$(nproc 2> /dev/null || echo 1) '$(MAKE) -s test' '$(MAKE) -s bits PARTS=\"native s390x fault\"' '$(MAKE) -s end-to-end' 'ET_RUNS=200 $(MAKE) -s asan' 'ET_RUNS=200 $(MAKE) -s P=clang test' \
	  '$(MAKE) -s judged' '$(MAKE) -s faults MOST=12' '$(MAKE) -s refused' 'sh tests/oss-fuzz.sh $(BUILD)/oss-fuzz' '$(MAKE) -s rows' '$(MAKE) -s within' '$(MAKE) -s bites' '$(MAKE) -s harness' '$(MAKE) -s floors' \
	  '$(MAKE) -s contracts' '$(MAKE) -s proofs-quick' '$(MAKE) -s audit' '$(MAKE) -s docs' 'sh tests/install.sh $(BUILD)'"
# What else the tests are made of: built before they run side by side.
also: $(B)/frozen $(B)/memory $(B)/accuracy $(B)/replay adapters-light
end-to-end: all
	@$(SUM) $(foreach s,$(sort $(wildcard tests/cli/*.sh)),'sh $(s) $(B)/etalon')

# Adapters of other libraries for the conformance kit; conformance judges all of them and writes docs/scoreboard.md, check the light ones.
ADAPTERS := $(addprefix $(B)/adapters/,etalon gsl sisl occt)
$(B)/adapters/etalon: tests/adapters/etalon/adapter.c $(B)/libetalon.a
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(B)/adapters/shared.o: tests/adapters/adapter.c tests/adapters/adapter.h
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<
$(B)/adapters/gsl $(B)/adapters/sisl: $(B)/adapters/%: tests/adapters/%/adapter.c $(B)/adapters/shared.o
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(if $(findstring sisl,$@),-lsisl,$(GSL)) -lm
$(B)/adapters/occt: tests/adapters/occt/adapter.cpp $(B)/adapters/shared.o
	$(CXX) $(CXXFLAGS) -isystem /usr/include/opencascade $(LDFLAGS) -o $@ $^ -lTKGeomAlgo -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
adapters: $(ADAPTERS) $(B)/etalon
conformance:
	@sh tests/deps.sh $(PACKAGES) $(PACKAGES_CONFORM)
	@$(MAKE) -s $(J) adapters
	@sh tests/conformance.sh $(B) scoreboard
judged: adapters-light
	@sh tests/conformance.sh $(B) light
adapters-light: $(B)/adapters/etalon $(B)/adapters/gsl $(B)/adapters/sisl $(B)/etalon

# A benchmark is bench_X.c (or X_table.c) with bench.c and X_input.c; a peer is a program of its own, and may be missing.
bench:
	@sh tests/deps.sh $(PACKAGES_BENCH) || echo "peers that are missing are skipped"
	@echo "BLAS: $$(ldconfig -p | sed -n 's/.*libblas\.so\.3 .*=> //p' | head -n 1 | xargs -r readlink -f)"
	@for p in release native; do $(MAKE) -s P=$$p programs && $(MAKE) -s -k P=$$p peers 2> /dev/null; \
	  for b in $(notdir $(BENCHES)); do echo "$$b, $$p:"; BENCH_BIN=$(BUILD)/$$p BENCH_SRC=tests/bench $(BUILD)/$$p/$$b || exit; done; done
programs: $(BENCHES)
peers: $(PEERS)
$(BENCHES): $(B)/%: $(B)/tests/bench/%.c.o $(B)/tests/bench/bench.c.o $(INPUTO) $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(filter-out %_occt %_pagmo,$(PEERS)): $(B)/%: $(B)/tests/bench/%.c.o $(B)/tests/bench/bench.c.o $(INPUTO)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(if $(findstring sisl,$@),-lsisl) $(if $(findstring nlopt,$@),-lnlopt) $(GSL) -lm
$(filter %_occt,$(PEERS)): $(B)/%: tests/bench/%.cpp $(B)/tests/bench/bench.c.o $(INPUTO)
	$(CXX) $(CXXFLAGS) -isystem /usr/include/opencascade $(LDFLAGS) -o $@ $^ -lTKG3d -lTKG2d -lTKMath -lTKernel
$(filter %_pagmo,$(PEERS)): $(B)/%: tests/bench/%.cpp $(B)/tests/bench/bench.c.o $(INPUTO)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lpagmo -ltbb -lboost_serialization
# Yardsticks in plain C are the same in both builds.
$(B)/tests/bench/peer_som_plain.c.o $(B)/tests/bench/peer_dense.c.o: FLAGS_native = -O2

# Debian's packages; with root (or sudo) they are installed, else named.
PACKAGES      := gcc g++ liblapacke-dev libceres-dev libgoogle-glog-dev libeigen3-dev libjansson-dev gnuplot-nox libflint-arb-dev libflint-dev libmpfr-dev libgmp-dev
PACKAGES_TEST := libgsl-dev clang libclang-rt-14-dev valgrind gcovr python3 libsisl-dev libocct-modeling-algorithms-dev libocct-data-exchange-dev admesh afl++ zip
PACKAGES_FUZZ := clang libclang-rt-14-dev libgsl-dev libsisl-dev afl++
PACKAGES_CONFORM := libgsl-dev libsisl-dev libocct-modeling-algorithms-dev python3 python3-scipy
PACKAGES_BITS := libblas3 liblapack3 libopenblas0-pthread libatlas3-base qemu-user-static gcc-aarch64-linux-gnu gcc-s390x-linux-gnu gcc-i686-linux-gnu
PACKAGES_BENCH := libgsl-dev libsisl-dev libocct-modeling-algorithms-dev libpagmo-dev libboost-serialization-dev libtbb-dev python3-scipy r-base-core r-cran-kohonen
PACKAGES_PROOFS := frama-c-base cvc4 cvc5 z3 why3 gappa libcoq-gappa coq libcoq-flocq libcoq-coquelicot libcoq-interval ocaml python3
deps:
	@sh tests/deps.sh $(PACKAGES)
deps-test:
	@sh tests/deps.sh $(PACKAGES) $(PACKAGES_TEST) $(PACKAGES_BITS)
demo: deps
	@$(MAKE) -s $(J) all
	@mkdir -p $(BUILD)/demo
	$(BUILD)/release/etalon generate sphere -o $(BUILD)/demo/sphere.xyz
	$(BUILD)/release/etalon reconstruct $(BUILD)/demo/sphere.xyz --refine ga,de,pso,ceres -o $(BUILD)/demo
	@echo "The pictures are in $(BUILD)/demo (*.png); $(BUILD)/demo/report.md ties them together, $(BUILD)/demo/surface.igs opens in CAD."

# What was proved is remembered in build/proofs, so that a run that was stopped goes on; quick: only what is not the text that was proved.
proofs:
	@sh tests/deps.sh $(PACKAGES_PROOFS)
	@sh proofs/prove.sh $(BUILD)/proofs
proofs-accept:
	@sh proofs/prove.sh --accept $(BUILD)/proofs
proofs-mutants:
	@sh tests/deps.sh $(PACKAGES_PROOFS)
	@sh proofs/mutants.sh $(BUILD)/proofs
proofs-quick:
	@[ -z "$$(sh proofs/prove.sh --changed $(BUILD)/proofs)" ] || sh tests/deps.sh $(PACKAGES_PROOFS)
	@sh proofs/prove.sh --quick $(BUILD)/proofs

install: all $(B)/etalon.pc
	install -d $(DESTDIR)$(PREFIX)/lib/pkgconfig $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/share/man/man1
	install -m 644 $(B)/libetalon.a $(DESTDIR)$(PREFIX)/lib
	install -m 644 $(B)/etalon.pc $(DESTDIR)$(PREFIX)/lib/pkgconfig
	for h in $$(cd include && find . -name '*.h'); do install -D -m 644 include/$$h $(DESTDIR)$(PREFIX)/include/$$h || exit; done
	install -m 755 $(B)/etalon $(DESTDIR)$(PREFIX)/bin
	$(if $(wildcard docs/etalon.1),install -m 644 docs/etalon.1 $(DESTDIR)$(PREFIX)/share/man/man1)
	install -d $(DESTDIR)$(PREFIX)/share/etalon/conformance
	install -m 644 $(wildcard golden/conformance/*.json) golden/LICENSE $(DESTDIR)$(PREFIX)/share/etalon/conformance
$(B)/etalon.pc: src/etalon.pc.in Makefile
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' -e 's|@LIBS@|$(LIBS) $(OMP)|' $< > $@
uninstall:
	rm -rf $(DESTDIR)$(PREFIX)/include/etalon
	rm -f $(DESTDIR)$(PREFIX)/lib/libetalon.a $(DESTDIR)$(PREFIX)/lib/pkgconfig/etalon.pc $(DESTDIR)$(PREFIX)/bin/etalon
	rm -f $(DESTDIR)$(PREFIX)/share/man/man1/etalon.1
	rm -rf $(DESTDIR)$(PREFIX)/share/etalon
clean:
	rm -rf $(BUILD)
.PHONY: proofs proofs-accept proofs-mutants proofs-quick all test golden rows golden-accept harness bites asan valgrind audit floors contracts docs accuracy within bits print-libs fuzz fuzz-min cover covering faults refused refusing built also check end-to-end mutants mutate mutants-self bench programs peers adapters adapters-light conformance judged deps deps-test demo install uninstall clean
