# Instructions on Cortex-M, counted in an emulator: exact, and the same on every
# machine. Both CPUs' code runs on one board, whose memory holds a whole screen;
# SysTick there is 25 MHz, and an instruction takes 64 ns: 1.6 ticks.
include port/cortex_m/cortex_m.mk

.PHONY: bench-mcu

MCU_BENCH := $(wildcard bench/mcu/*.c)

# $1 CPU
define mcu_bench
$(BUILD)/bench/mcu/$1.elf: $(MCU_BENCH:%.c=$(BUILD)/mcu/$1-O2/%.o) \
    $(MCU_PORT:%.c=$(BUILD)/mcu/$1-O2/%.o) $(BUILD)/mcu/$1-O2/libpel.a
	@mkdir -p $$(@D)
	$(MCU_CC) -mcpu=$1 $(MCU_LDFLAGS) $(call mcu_script,mps2_an386) \
	    $$^ -o $$@
endef
$(foreach c,$(MCU_CPUS),$(eval $(call mcu_bench,$c)))

MCU_BENCH_ELFS := $(MCU_CPUS:%=$(BUILD)/bench/mcu/%.elf)

bench-mcu: $(MCU_BENCH_ELFS) | need-qemu-arm ## instructions on Cortex-M: build/bench/mcu.tsv
	bench/mcu/run.sh $(BUILD)/bench "$(MCU_CPUS)" >$(BUILD)/bench/mcu.tsv
	bench/mcu/table.sh $(BUILD)/bench/mcu.tsv $(ACCEPT)
