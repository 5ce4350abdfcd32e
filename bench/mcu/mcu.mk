# Instructions on microcontrollers and small CPUs, counted in an emulator: exact,
# and the same on every machine.
include port/boards.mk

.PHONY: bench-mcu

MCU_BENCH := $(sort $(wildcard bench/mcu/*.c))
MCU_BENCH_ELFS := $(BOARDS:%=$(BUILD)/bench/mcu/%.elf)

# As the tables name the CPUs; and -icount of QEMU (stopwatch.h).
MCU_BENCH_m0plus := cortex-m0plus shift=6
MCU_BENCH_m4 := cortex-m4 shift=6
MCU_BENCH_m7 := cortex-m7 shift=6
MCU_BENCH_m33 := cortex-m33 shift=6
MCU_BENCH_arm926 := arm926 shift=6
MCU_BENCH_rv32 := rv32imc shift=0
MCU_BENCH_a53 := cortex-a53 shift=6

# The objects are those of the golden scenes (tests/tools/cpus.mk).
# $1 board
define mcu_bench
$(BUILD)/bench/mcu/$1.elf: $(MCU_BENCH:%.c=$(BUILD)/cpus/gcc-$1-O2/%.o) \
    $(CORE:%.c=$(BUILD)/cpus/gcc-$1-O2/%.o)
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_$1)-gcc $(CPU_FLAGS_$1) $$^ $(CPU_LINK_$1) -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call mcu_bench,$b)))

bench-mcu: $(MCU_BENCH_ELFS) ## instructions on small CPUs: build/bench/mcu.tsv; ACCEPT=1 keeps them
	printf '%s\n' $(foreach b,$(BOARDS),\
	    '$(MCU_BENCH_$b) $(BUILD)/bench/mcu/$b.elf $(CPU_RUN_$b)') | \
	    bench/mcu/run.sh >$(BUILD)/bench/mcu.tsv
	bench/mcu/table.sh $(BUILD)/bench/mcu.tsv $(ACCEPT)
