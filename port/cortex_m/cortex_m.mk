# Core and programs for CPUs without an operating system. A build is named
# CPU-LEVEL, and its objects are in build/mcu/CPU-LEVEL/. Included by whoever
# builds such programs; once is enough.
ifndef MCU_CPUS

.PHONY: need-arm need-qemu-arm

MCU_CPUS := cortex-m0plus cortex-m4 cortex-m7 cortex-m33 arm926 rv32imc lx106

MCU_LEVELS := O2 Os small
MCU_FLAGS_O2 := -O2
MCU_FLAGS_Os := -Os
MCU_FLAGS_small := -Os -DPEL_SMALL_CODE=1

# memcpy and memset, where a program needs them, are those of newlib-nano, on
# RISC-V and Xtensa of picolibc; the compiler's helpers come from libgcc.
MCU_CC := arm-none-eabi-gcc
MCU_CORTEX := $(MCU_CC) --specs=nano.specs -mthumb -mfloat-abi=soft
MCU_CC_cortex-m0plus := $(MCU_CORTEX) -mcpu=cortex-m0plus
MCU_CC_cortex-m4 := $(MCU_CORTEX) -mcpu=cortex-m4
MCU_CC_cortex-m7 := $(MCU_CORTEX) -mcpu=cortex-m7
MCU_CC_cortex-m33 := $(MCU_CORTEX) -mcpu=cortex-m33
MCU_CC_arm926 := $(MCU_CC) --specs=nano.specs -marm -mcpu=arm926ej-s
MCU_CC_rv32imc := riscv64-unknown-elf-gcc --specs=picolibc.specs \
    -march=rv32imc -mabi=ilp32
MCU_CC_lx106 := xtensa-lx106-elf-gcc -mlongcalls -mtext-section-literals
MCU_CFLAGS = -std=c99 $(WARNINGS) $(WERROR) -I. -Iinclude -MMD -MP \
             -ffunction-sections -fdata-sections
MCU_LDFLAGS := -nostartfiles -Wl,--gc-sections -Wl,--fatal-warnings
MCU_PORT := $(wildcard port/cortex_m/*.c)
MCU_PORT_lx106 := port/lx106/rom.c
mcu_script = -T port/cortex_m/$1.ld -T port/cortex_m/sections.ld

need-arm: | need-boards
	@test -f "$$($(MCU_CC) -print-file-name=libc_nano.a)" || \
	    tests/tools/need.sh newlib-nano:libnewlib-arm-none-eabi
need-qemu-arm:
	@tests/tools/need.sh qemu-system-arm:qemu-system-arm

# $1 build, $2 CPU, $3 level
define mcu_objects
MCU_COMPILE_$1 = $(MCU_CC_$2) $(MCU_FLAGS_$3) $$(MCU_CFLAGS)
$(BUILD)/mcu/$1/%.o: %.c | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -c $$< -o $$@
$(BUILD)/mcu/$1/libpel.a: $(CORE:%.c=$(BUILD)/mcu/$1/%.o)
	rm -f $$@
	$(AR) rcs $$@ $$^
endef
$(foreach c,$(MCU_CPUS),$(foreach l,$(MCU_LEVELS),$(eval $(call \
    mcu_objects,$c-$l,$c,$l))))

-include $(wildcard $(BUILD)/mcu/*/*/*.d $(BUILD)/mcu/*/*/*/*.d)
.PRECIOUS: $(BUILD)/mcu/%.o

endif
