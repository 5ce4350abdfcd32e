# Core and programs for Cortex-M. Objects of CPU and level: build/mcu/CPU-Os/.
# Included by whoever builds such programs; once is enough.
ifndef MCU_CPUS

.PHONY: need-arm need-qemu-arm

MCU_CPUS := cortex-m0plus cortex-m4
MCU_CC := arm-none-eabi-gcc
MCU_CFLAGS = -std=c99 $(WARNINGS) $(WERROR) -I. -I$(BUILD)/include -MMD -MP -mthumb -mfloat-abi=soft \
              -ffunction-sections -fdata-sections

# memcpy and memset, where a program needs them, are those of newlib-nano; the
# compiler's helpers come from libgcc.
MCU_LDFLAGS := -mthumb -mfloat-abi=soft -nostartfiles --specs=nano.specs \
               -Wl,--gc-sections -Wl,--fatal-warnings
MCU_PORT := $(wildcard port/cortex_m/*.c)
mcu_script = -T port/cortex_m/$1.ld -T port/cortex_m/sections.ld

need-arm:
	@tests/tools/need.sh $(MCU_CC):gcc-arm-none-eabi
	@test -f "$$($(MCU_CC) -print-file-name=libc_nano.a)" || \
	    tests/tools/need.sh newlib-nano:libnewlib-arm-none-eabi
need-qemu-arm:
	@tests/tools/need.sh qemu-system-arm:qemu-system-arm

# $1 CPU, $2 optimisation
define mcu_objects
$(BUILD)/mcu/$1$2/%.o: %.c | need-arm
	@mkdir -p $$(@D)
	$(MCU_CC) -mcpu=$1 $2 $(MCU_CFLAGS) -c $$< -o $$@
$(BUILD)/mcu/$1$2/libpel.a: $(CORE:%.c=$(BUILD)/mcu/$1$2/%.o)
	rm -f $$@
	arm-none-eabi-ar rcs $$@ $$^
endef
$(foreach c,$(MCU_CPUS),$(eval $(call mcu_objects,$c,-Os)))

-include $(wildcard $(BUILD)/mcu/*/*/*.d $(BUILD)/mcu/*/*/*/*.d)
.PRECIOUS: $(BUILD)/mcu/%.o

endif
