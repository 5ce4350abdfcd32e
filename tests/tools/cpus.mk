# The golden scenes on other CPUs, by other compilers and at other levels: the
# same bytes everywhere. A build is named COMPILER-CPU-LEVEL or, of a variant of
# core, COMPILER-CPU-LEVEL-VARIANT.

.PHONY: check-builds check-cpus check-examples check-mcu deep-builds deep-cpus \
    need-cpus board

# CPUs, each with the prefix of its compiler and its emulator; `host` is this
# machine. s390x and powerpc are big-endian, with 64 and with 32 bits. The
# microcontrollers run on boards without an operating system.
include port/boards.mk
CPUS := host i686 armhf aarch64 s390x powerpc
CPU_PREFIX_i686 := i686-linux-gnu
CPU_PREFIX_armhf := arm-linux-gnueabihf
CPU_PREFIX_aarch64 := aarch64-linux-gnu
CPU_PREFIX_s390x := s390x-linux-gnu
CPU_PREFIX_powerpc := powerpc-linux-gnu
CPU_RUN_i686 := qemu-i386-static
CPU_RUN_armhf := qemu-arm-static
CPU_RUN_aarch64 := qemu-aarch64-static
CPU_RUN_s390x := qemu-s390x-static
CPU_RUN_powerpc := qemu-ppc-static

cpu_cc_gcc = $(if $(CPU_PREFIX_$1),$(CPU_PREFIX_$1)-)gcc
cpu_cc_clang = clang$(if $(CPU_PREFIX_$1), --target=$(CPU_PREFIX_$1))

# WebAssembly, with wasi-libc, run by node.
CPU_PREFIX_wasm := wasm32-wasi
CPU_LINK_wasm := -lc
CPU_RUN_wasm := node --no-warnings tests/tools/wasi.js

# Levels with a name of their own; a variant that is one file.
CPU_LEVEL_flto := -O2 -flto=auto
CPU_ONE := one

# Ways of core that a 64-bit CPU does not take by itself.
CPU_VARIANT_narrow := -DPEL_64BIT=0
CPU_VARIANT_nofill := -DPEL_FAST_FILLS=0
CPU_VARIANT_plain := -DPEL_VECTORS=0
CPU_VARIANT_small := -DPEL_SMALL_CODE=1
# Nor do 32-bit CPUs with -Os.
CPU_VARIANT_deep := -DPEL_SHORT_STACK=0

CPU_CHECK := $(foreach o,O0 Os O3,gcc-host-$o clang-host-$o) \
    gcc-host-O2-narrow gcc-host-O2-nofill clang-host-O2-plain gcc-armhf-O0 \
    $(foreach p,i686 armhf aarch64 s390x,gcc-$p-O2) clang-wasm-O0 clang-wasm-O2
CPU_CHECK_BOARDS := gcc-m4-O0 gcc-m0plus-Os-deep $(BOARDS:%=gcc-%-O2)
CPU_CHECK_SMALL := $(SMALL_BOARDS:%=gcc-%-O2)
CPU_DEEP := $(foreach c,gcc clang,$(foreach o,O0 Os O2 O3,\
    $(foreach p,$(CPUS),$c-$p-$o) \
    $(foreach p,host aarch64,$c-$p-$o-narrow $c-$p-$o-plain))) \
    $(foreach o,O0 Os O2 O3,$(foreach p,$(BOARDS),gcc-$p-$o))

# Every compiler and level, separate files and the amalgamation; of these, twelve
# that have each at least once.
BUILD_CPUS := gcc-host clang-host \
    $(foreach p,m0plus m4 m33 rv32 i686 aarch64 s390x lx106,gcc-$p)
BUILD_LEVELS := O0 Og O1 O2 O3 Os flto
BUILDS_DEEP := $(foreach p,$(BUILD_CPUS),$(foreach o,$(BUILD_LEVELS),\
    $p-$o $p-$o-$(CPU_ONE)))
BUILDS_CHECK := gcc-host-Og gcc-host-flto-one clang-host-O3-one \
    gcc-m0plus-O2-one gcc-m4-Og-one gcc-m33-flto gcc-rv32-O3-one \
    gcc-i686-Os-one gcc-aarch64-Og-one gcc-s390x-O1-one gcc-m4-O0 \
    gcc-lx106-Os-one

cpu_word = $(word $1,$(subst -, ,$2))

# $1 build, $2 compiler, $3 CPU, $4 level, $5 variant
define cpu_build_of
$(BUILD)/cpus/$1/%.o: %.c | $(if $(filter $3,$(BOARDS)),need-boards,need-cpus)
	@mkdir -p $$(@D)
	$$(call cpu_cc_$2,$3) $$(CPU_FLAGS_$3) $$(PEL_CFLAGS) $$(call cpu_level,$4) \
	    $$(CPU_VARIANT_$5) -c $$< -o $$@
$(BUILD)/cpus/$1/pel.o: $(ONE)/pel.c $(ONE)/pel.h
	@mkdir -p $$(@D)
	$$(call cpu_cc_$2,$3) $$(CPU_FLAGS_$3) $$(PEL_CFLAGS) $$(call cpu_level,$4) \
	    -c $$< -o $$@
$(BUILD)/cpus/$1/scenes: $(BUILD)/cpus/$1/tests/golden/scenes.o
$(BUILD)/cpus/$1/flat: $(BUILD)/cpus/$1/tests/link/flat.o
$(BUILD)/cpus/$1/scenes $(BUILD)/cpus/$1/flat: $(if $(filter $(CPU_ONE),$5), \
    $(BUILD)/cpus/$1/pel.o,$(CORE:%.c=$(BUILD)/cpus/$1/%.o))
	$$(call cpu_cc_$2,$3) $$(CPU_FLAGS_$3) $$(call cpu_level,$4) $$^ \
	    $(or $(CPU_LINK_$3),-static) -o $$@
endef
cpu_level = $(or $(CPU_LEVEL_$1),-$1)
cpu_build = $(call cpu_build_of,$1,$(call cpu_word,1,$1),$(call \
    cpu_word,2,$1),$(call cpu_word,3,$1),$(call cpu_word,4,$1))

# The many rules of the deep builds only where they are asked for; those of
# bench/mcu always.
CPU_BUILDS := $(sort $(CPU_CHECK) $(CPU_CHECK_BOARDS) $(BUILDS_CHECK) \
    $(foreach o,O2 Os Os-small,$(BOARDS:%=gcc-%-$o)) $(if $(filter \
    deep deep-cpus deep-builds,$(MAKECMDGOALS)),$(CPU_DEEP) $(BUILDS_DEEP)))
$(foreach b,$(CPU_BUILDS),$(eval $(call cpu_build,$b)))

# The scenes from the objects of a CPU in the memory of a board, without meshes,
# smooth edges and paths where they do not fit.
SMALL_FLAGS_microbit := -DNO_MESHES
SMALL_FLAGS_stm32vldiscovery := -DNO_MESHES
SMALL_FLAGS_sifive_e := -DNO_MESHES
# $1 board, $2 CPU
define cpu_small_board
$(BUILD)/cpus/gcc-$1-O2/scenes: tests/golden/scenes.c $(BUILD)/cpus/gcc-$2-O2/scenes
	@mkdir -p $$(@D)
	@grep -v $(if $(SMALL_FLAGS_$1),-e '^phong ' -e '^depth ' -e '^smooth_' -e '^paths ',nothing) \
	    tests/golden/scenes.txt >$$(@D)/golden.txt
	@$(CPU_PREFIX_$2)-gcc $(CPU_FLAGS_$2) $$(PEL_CFLAGS) -Os $(SMALL_FLAGS_$1) $$< \
	    $(CORE:%.c=$(BUILD)/cpus/gcc-$2-O2/%.o) $(CPU_LINK_$1) -o $$@
endef
$(foreach b,$(SMALL_BOARDS),$(eval $(call cpu_small_board,$b,$(SMALL_CPU_$b))))

need-cpus: | need-boards
	@tests/tools/need.sh gcc:gcc clang:clang wasm-ld:lld node:nodejs \
	    $(foreach p,$(filter-out host,$(CPUS)),\
	        $(CPU_PREFIX_$p)-gcc:gcc-$(CPU_PREFIX_$p) \
	        $(CPU_RUN_$p):qemu-user-static)

# $1 builds: lines of a build and the emulator that runs it
cpu_lines = $(foreach b,$1,'$b $(CPU_RUN_$(call cpu_word,2,$b))')

# An example on a board without an operating system, which counts instructions.
EXAMPLE ?= board
BOARD ?= m4
# RAM that an example is to run in, 2 KB of stack with it.
BOARD_RAM_board := 4K
BOARD_RAM_oled := 4K
BOARD_RAM_mesh := 8K
EXAMPLES_CHECKED := board game gauge mesh oled selftest watch

# $1 board, $2 CPU whose code it runs, $3 example, $4 its RAM
define board_example
$(BUILD)/board/$1/$3: $(call example_sources,$3) \
    $(wildcard examples/*.h) \
    $(patsubst %.c,$(BUILD)/cpus/gcc-$2-O2/%.o,$(CORE) $(DRIVERS))
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_$2)-gcc $(CPU_FLAGS_$2) -std=c99 -O2 -I. -Iinclude \
	    -I$(BUILD)/examples -Wl,--gc-sections $$(filter-out %.h,$$^) $(CPU_LINK_$1) \
	    $(4:%=-Wl,--defsym=__ram_size=%) -o $$@
endef
$(foreach b,$(BOARDS),$(foreach e,$(EXAMPLE_NAMES),$(eval $(call \
    board_example,$b,$b,$e,$(if $(filter a53 lx106,$b),,$(BOARD_RAM_$e))))))
$(foreach b,$(SMALL_BOARDS),$(foreach e,$(SMALL_EXAMPLES_$b),$(eval $(call \
    board_example,$b,$(SMALL_CPU_$b),$e))))

BOARD_CPU = $(or $(SMALL_CPU_$(BOARD)),$(BOARD))
BOARDS_WITH_IT := $(strip $(BOARDS) $(foreach b,$(SMALL_BOARDS),$(if $(filter \
    $(EXAMPLE),$(SMALL_EXAMPLES_$b)),$b)))
$(if $(filter board,$(MAKECMDGOALS)),$(if $(filter $(BOARDS_WITH_IT),$(BOARD)),, \
    $(error BOARD=$(BOARD): expected one of $(BOARDS_WITH_IT))))
board: $(BUILD)/board/$(BOARD)/$(EXAMPLE) ## EXAMPLE=board on BOARD=m4 or another of port/boards.mk, in QEMU
	@tests/tools/example.sh $< $(CPU_RUN_$(BOARD)) $< \
	    -icount $(word 2,$(MCU_BENCH_$(BOARD_CPU))),sleep=off

# The examples are C++ too, and draw on every board, in the RAM above, what they
# draw on the host.
PRODUCT_RUNS := $(foreach b,m0plus m4,$(PRODUCTS:%=$b/%))
BOARD_RUNS := $(filter-out $(PRODUCT_RUNS),$(foreach b,$(BOARDS),\
    $(EXAMPLES_CHECKED:%=$b/%))) $(PRODUCTS:%=rv32/%) \
    $(foreach b,$(SMALL_BOARDS),$(SMALL_EXAMPLES_$b:%=$b/%))
run_boards = printf '%s\n' $(foreach r,$(sort $1),'$r $(CPU_RUN_$(patsubst \
    %/,%,$(dir $r)))') | tests/tools/board_examples.sh $(BUILD)
check-examples: examples need-clang $(BOARD_RUNS:%=$(BUILD)/board/%) ## the examples on every board of QEMU
	@set -e; for c in g++ clang++; do for e in $(EXAMPLES); do \
	    $$c -x c++ -std=gnu++11 -Wall -Wextra -Wno-missing-field-initializers \
	        -Werror -I. -Iinclude -I$(BUILD)/examples -fsyntax-only $$e; \
	done; done
	@$(call run_boards,$(BOARD_RUNS))

.PHONY: products
products: $(PRODUCTS:%=$(BUILD)/examples/%) $(PRODUCT_RUNS:%=$(BUILD)/board/%) $(PRODUCT_ELFS) ## flash, RAM, stack and instructions of products: docs/PRODUCTS.md; ACCEPT=1 keeps them
	@$(call run_boards,$(PRODUCT_RUNS))
	@printf '%s\n' $(PRODUCTS) | tests/tools/products.sh $(BUILD) $(ACCEPT)

check-cpus: $(CPU_CHECK:%=$(BUILD)/cpus/%/scenes) ## the golden scenes on other CPUs and compilers
	printf '%s\n' $(call cpu_lines,$(CPU_CHECK)) | tests/tools/cpus.sh $(BUILD)

MCU_CHECK := $(CPU_CHECK_BOARDS) $(CPU_CHECK_SMALL)
check-mcu: check-lcd
check-mcu: $(MCU_CHECK:%=$(BUILD)/cpus/%/scenes) ## every board of QEMU draws the golden scenes as far as memory goes
	printf '%s\n' $(call cpu_lines,$(MCU_CHECK)) | tests/tools/cpus.sh $(BUILD)

deep-cpus: $(CPU_DEEP:%=$(BUILD)/cpus/%/scenes) ## the same for all CPUs, compilers and levels
	printf '%s\n' $(call cpu_lines,$(CPU_DEEP)) | tests/tools/cpus.sh $(BUILD)

# A 2-D program of each build links, and its scenes are those of all.
check-builds: $(BUILDS_CHECK:%=$(BUILD)/cpus/%/flat)
check-builds: $(BUILDS_CHECK:%=$(BUILD)/cpus/%/scenes) ## twelve compilers, CPUs and levels, files and amalgamation: no warning, all links
	printf '%s\n' $(call cpu_lines,$(BUILDS_CHECK)) | tests/tools/cpus.sh $(BUILD)

deep-builds: $(BUILDS_DEEP:%=$(BUILD)/cpus/%/flat)
deep-builds: $(BUILDS_DEEP:%=$(BUILD)/cpus/%/scenes) ## the same for all compilers, CPUs and levels
	printf '%s\n' $(call cpu_lines,$(BUILDS_DEEP)) | tests/tools/cpus.sh $(BUILD)

-include $(foreach b,$(CPU_BUILDS),$(wildcard $(BUILD)/cpus/$b/*/*/*.d))
