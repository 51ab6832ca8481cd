# The builds that tests/bits.sh compares, beside those that the Makefile knows: debug (gcc -O0), release (gcc -O2), native (gcc -O3 -march=native)
# and clang (clang -O3).
CC_gcc-O3       = gcc
FLAGS_gcc-O3    = -O3
CC_clang-O0     = clang
FLAGS_clang-O0  = -O0
CC_clang-O2     = clang
FLAGS_clang-O2  = -O2
CC_clang-native = clang
FLAGS_clang-native = -O3 -march=native
# Planted with a fault, which the comparison must notice.
CC_planted      = gcc
FLAGS_planted   = -O2 -ffast-math

# Other processors.
CROSS        := aarch64 s390x i386
CC_aarch64    = aarch64-linux-gnu-gcc --sysroot=$(SYSROOT)
CC_s390x      = s390x-linux-gnu-gcc --sysroot=$(SYSROOT)
CC_i386       = i686-linux-gnu-gcc --sysroot=$(SYSROOT)
FLAGS_aarch64 = -O2
FLAGS_s390x   = -O2
FLAGS_i386    = -O2 -msse2 -mfpmath=sse
# Tests are compiled fast; their generators draw 64 bits, and sizes are taken of them.
TEST_FLAGS_aarch64 = -O0
TEST_FLAGS_s390x   = -O0
TEST_FLAGS_i386    = -O0 -Wno-conversion -Wno-type-limits
ifneq ($(filter $(CROSS),$(P)),)
SYSROOT ?= $(BUILD)/sysroot/$(P)
AR      := $(patsubst %-gcc,%-ar,$(firstword $(CC_$(P))))
# What is in C++ is left out (Ceres; it has no row of class exact or bits), and what uses it, which is also the command; and SISL, a second opinion.
LEFT_OUT      := $(wildcard src/*/*.cpp) $(wildcard src/cli/*.c tests/cli/test_*.c) $(shell grep -l 'etalon/refine/ceres\.h' tests/*/test_*.c) $(wildcard tests/*/test_*_sisl.c)
LEFT_OUT_LIBS := -lceres -lglog -lstdc++ -lsisl
endif

# BORROW=PROFILE: the tests and what is in C++ are taken from that build, and only the library in C is built again.
OF = $(addprefix $(BUILD)/$(or $(BORROW),$(P))/,$(addsuffix .o,$(1)))
