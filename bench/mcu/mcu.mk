# Instructions on microcontrollers and small CPUs, counted in an emulator: exact,
# and the same on every machine.
include port/boards.mk

.PHONY: bench-mcu

MCU_BENCH := $(sort $(wildcard bench/mcu/*.c))
# As the tables name the levels; -Os-small has PEL_SMALL_CODE.
MCU_BENCH_LEVELS := O2 Os small
MCU_BENCH_LEVEL_O2 := O2
MCU_BENCH_LEVEL_Os := Os
MCU_BENCH_LEVEL_small := Os-small
MCU_BENCH_ELFS := $(foreach l,$(MCU_BENCH_LEVELS),\
    $(BOARDS:%=$(BUILD)/bench/mcu/%-$l.elf))

# As the tables name the CPUs; and -icount of QEMU (stopwatch.h).
MCU_BENCH_m0plus := cortex-m0plus shift=6
MCU_BENCH_m4 := cortex-m4 shift=6
MCU_BENCH_m7 := cortex-m7 shift=6
MCU_BENCH_m33 := cortex-m33 shift=6
MCU_BENCH_arm926 := arm926 shift=6
MCU_BENCH_rv32 := rv32imc shift=0
MCU_BENCH_a53 := cortex-a53 shift=6
MCU_BENCH_lx106 := lx106 shift=6

# The objects are those of the golden scenes (tests/tools/cpus.mk).
# $1 board, $2 level, $3 its objects
define mcu_bench
$(BUILD)/bench/mcu/$1-$2.elf: $(MCU_BENCH:%.c=$3/%.o) $(CORE:%.c=$3/%.o)
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_$1)-gcc $(CPU_FLAGS_$1) $$^ $(CPU_LINK_$1) -o $$@
endef
$(foreach b,$(BOARDS),$(foreach l,$(MCU_BENCH_LEVELS),$(eval $(call \
    mcu_bench,$b,$l,$(BUILD)/cpus/gcc-$b-$(MCU_BENCH_LEVEL_$l)))))

# CPU-LEVEL, -icount, program, emulator
mcu_bench_line = $(firstword $(MCU_BENCH_$1))-$2 $(lastword $(MCU_BENCH_$1)) \
    $(BUILD)/bench/mcu/$1-$2.elf $(CPU_RUN_$1)

bench-mcu: $(MCU_BENCH_ELFS) ## instructions on small CPUs: build/bench/mcu.tsv; ACCEPT=1 keeps them
	printf '%s\n' $(foreach b,$(BOARDS),$(foreach l,$(MCU_BENCH_LEVELS),\
	    '$(call mcu_bench_line,$b,$l)')) | \
	    bench/mcu/run.sh >$(BUILD)/bench/mcu.tsv
	bench/mcu/table.sh $(BUILD)/bench/mcu.tsv $(ACCEPT)
