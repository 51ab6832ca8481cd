# make              the library and the command          make demo    a cloud becomes a closed surface, from nothing
# make test         units, properties, golden rows       make check   all tests (installs what they need)
# make audit        every public name in every room      make bench   speed, as ratios to named peers
# make fuzz F=NAME T=60   fuzz one property              make install DESTDIR= PREFIX=/usr/local
# make P=asan ...   the same under sanitizers: profiles release, debug, asan, fuzz, cover, native

P       ?= release
BUILD   ?= build
B       := $(BUILD)/$(P)
ROOMS   ?= base spline net som fit refine io cli
VERSION := 0.1.0
PREFIX  ?= /usr/local

CC_release = gcc
CC_native  = gcc
CC_debug   = gcc
CC_asan    = clang
CC_fuzz    = clang
CC_cover   = gcc
CXX_release = g++
CXX_native  = g++
CXX_debug   = g++
CXX_asan    = clang++
CXX_fuzz    = clang++
CXX_cover   = g++
FLAGS_release = -O2
FLAGS_native  = -O3 -march=native
FLAGS_debug   = -O0
FLAGS_asan    = -O1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FLAGS_fuzz    = -O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
FLAGS_cover   = -O0 --coverage
CC     := $(CC_$(P))
CXX    := $(CXX_$(P))
COMMON := -g -ffp-contract=off -ffile-prefix-map=$(CURDIR)=. -Wall -Wextra -Wshadow -Wconversion -Werror -Iinclude -Isrc
CFLAGS   = -std=c99 -pedantic-errors -Wstrict-prototypes -Wvla $(COMMON) $(FLAGS_$(P)) -D_POSIX_C_SOURCE=200809L
CXXFLAGS = -std=c++17 $(COMMON) $(FLAGS_$(P)) -isystem /usr/include/eigen3
LDLIBS = -lceres -lglog -llapacke -llapack -lblas -lgsl -lgslcblas -ljansson -lstdc++ -lm

SRC  := $(foreach r,$(filter-out cli,$(ROOMS)),$(wildcard src/$(r)/*.c) $(wildcard src/$(r)/*.cpp))
CLI  := $(if $(filter cli,$(ROOMS)),$(wildcard src/cli/*.c))
TEST := $(wildcard tests/*.c) $(foreach r,$(ROOMS),$(wildcard tests/$(r)/test_*.c))
LIBO  := $(addprefix $(B)/,$(addsuffix .o,$(SRC)))
CLIO  := $(addprefix $(B)/,$(addsuffix .o,$(CLI)))
TESTO := $(addprefix $(B)/,$(addsuffix .o,$(TEST)))
MAINO := $(B)/tests/check.c.o

all: $(B)/libetalon.a $(if $(CLI),$(B)/etalon)

$(B)/libetalon.a: $(LIBO)
	rm -f $@ && ar rcsD $@ $^
$(B)/etalon: $(CLIO) $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(B)/%.c.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(if $(filter tests/% fuzz/%,$<),-Itests) -MMD -MP -c -o $@ $<
$(B)/%.cpp.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) -MMD -MP -c -o $@ $<
-include $(LIBO:.o=.d) $(CLIO:.o=.d) $(TESTO:.o=.d)

# The list of properties and of golden checks is read off the tests' own definitions.
$(B)/registry.c: $(TEST) tests/registry.sh
	@mkdir -p $(@D)
	sh tests/registry.sh $(TEST) > $@.new && mv $@.new $@
$(B)/registry.o: $(B)/registry.c
	$(CC) $(CFLAGS) -Itests -c -o $@ $<
$(B)/check: $(TESTO) $(B)/registry.o $(B)/libetalon.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

test: $(B)/check
	$(B)/check

clean:
	rm -rf $(BUILD)
.PHONY: all test clean
