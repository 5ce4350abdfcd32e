# Boards of QEMU without an operating system, one for each CPU: compiler, flags,
# memory, emulator. picolibc, which the package picolibc-PREFIX brings, has
# start-up code and semihosting for all of them. Their memory holds whole
# screens. Included by whoever needs it; once is enough.
ifndef BOARDS

.PHONY: need-boards

BOARDS := m0plus m4 m7 m33 arm926 rv32 a53 lx106

CPU_PREFIX_m0plus := arm-none-eabi
CPU_PREFIX_m4 := arm-none-eabi
CPU_PREFIX_m7 := arm-none-eabi
CPU_PREFIX_m33 := arm-none-eabi
CPU_PREFIX_arm926 := arm-none-eabi
CPU_PREFIX_rv32 := riscv64-unknown-elf
CPU_PREFIX_a53 := aarch64-linux-gnu
CPU_PREFIX_lx106 := xtensa-lx106-elf

# The library as it was built for speed: the other one copies byte by byte.
BOARD_LIBRARY := --specs=picolibc.specs --picolibc-buildtype=release
CPU_FLAGS_m0plus := -mcpu=cortex-m0plus -mthumb $(BOARD_LIBRARY)
CPU_FLAGS_m4 := -mcpu=cortex-m4 -mthumb $(BOARD_LIBRARY)
CPU_FLAGS_m7 := -mcpu=cortex-m7 -mthumb $(BOARD_LIBRARY)
CPU_FLAGS_m33 := -mcpu=cortex-m33 -mthumb $(BOARD_LIBRARY)
CPU_FLAGS_arm926 := -mcpu=arm926ej-s -marm $(BOARD_LIBRARY)
# -misa-spec: with counters, as the manual of before 2019 has them
CPU_FLAGS_rv32 := -march=rv32imc -misa-spec=2.2 -mabi=ilp32 $(BOARD_LIBRARY)
# Data in memory without a map need not be aligned in QEMU 7.
CPU_FLAGS_a53 := -mcpu=cortex-a53 --specs=picolibc.specs
# An ESP8266's, whose gcc has picolibc by itself.
CPU_LIBRARY_lx106 := libc.a
CPU_FLAGS_lx106 := -mlongcalls -mtext-section-literals

# $1 start of code, $2 its bytes, $3 start of data, $4 its bytes
board_link = --oslib=semihost --crt0=hosted -Wl,--defsym=__flash=$1 \
    -Wl,--defsym=__flash_size=$2 -Wl,--defsym=__ram=$3 \
    -Wl,--defsym=__ram_size=$4
CPU_LINK_m0plus := $(call board_link,0,4M,0x20000000,4M)
CPU_LINK_m4 := $(CPU_LINK_m0plus)
CPU_LINK_m7 := $(CPU_LINK_m0plus)
CPU_LINK_m33 := $(call board_link,0x10000000,4M,0x38000000,2M)
CPU_LINK_arm926 := $(call board_link,0x10000,4M,0x410000,4M)
CPU_LINK_rv32 := $(call board_link,0x80000000,4M,0x80400000,4M)
CPU_LINK_a53 := -static -l:release/libc.a \
    $(call board_link,0x40080000,4M,0x40480000,4M)
CPU_LINK_lx106 := -nostdlib -T port/lx106/sim.ld -std=gnu99 -O2 \
    port/lx106/start.c port/lx106/rom.c -Wl,--start-group -lc -lgcc -Wl,--end-group

# $1 architecture, $2 machine
board_run = qemu-system-$1 -M $2 -display none -monitor none -serial none \
    -chardev stdio,id=out \
    -semihosting-config enable=on,target=native,chardev=out -kernel
CPU_RUN_m0plus := $(call board_run,arm,mps2-an386)
CPU_RUN_m4 := $(CPU_RUN_m0plus)
CPU_RUN_m7 := $(call board_run,arm,mps2-an500)
CPU_RUN_m33 := $(call board_run,arm,mps2-an505)
# The board has a sound chip, which looks for one of the host.
CPU_RUN_arm926 := env QEMU_AUDIO_DRV=none $(call board_run,arm,versatilepb)
CPU_RUN_rv32 := $(call board_run,riscv32,virt -bios none)
CPU_RUN_a53 := $(call board_run,aarch64,virt -cpu cortex-a53)
CPU_RUN_lx106 := qemu-system-xtensa -M sim -cpu lx106 -display none \
    -monitor none -semihosting -kernel

# Boards with the memory of products. They run the code of the CPU that is named;
# a Cortex-M3 and an M0 run that of an M0+.
SMALL_BOARDS := microbit stm32vldiscovery lm3s6965evb sifive_e
SMALL_CPU_microbit := m0plus
SMALL_CPU_stm32vldiscovery := m0plus
SMALL_CPU_lm3s6965evb := m0plus
SMALL_CPU_sifive_e := rv32
SMALL_EXAMPLES_microbit := board oled mesh selftest
SMALL_EXAMPLES_stm32vldiscovery := board oled
SMALL_EXAMPLES_lm3s6965evb := board oled mesh selftest
SMALL_EXAMPLES_sifive_e := board oled mesh selftest
CPU_LINK_microbit := $(call board_link,0,256K,0x20000000,16K)
CPU_LINK_stm32vldiscovery := $(call board_link,0x08000000,128K,0x20000000,8K)
CPU_LINK_lm3s6965evb := $(call board_link,0,256K,0x20000000,64K)
CPU_LINK_sifive_e := $(call board_link,0x20400000,512K,0x80000000,16K)
CPU_RUN_microbit := $(call board_run,arm,microbit)
CPU_RUN_stm32vldiscovery := $(call board_run,arm,stm32vldiscovery)
CPU_RUN_lm3s6965evb := $(call board_run,arm,lm3s6965evb)
CPU_RUN_sifive_e := $(call board_run,riscv32,sifive_e)

need-boards:
	@tests/tools/need.sh qemu-system-arm:qemu-system-arm \
	    qemu-system-riscv32:qemu-system-misc \
	    qemu-system-xtensa:qemu-system-misc \
	    $(foreach b,$(BOARDS),$(CPU_PREFIX_$b)-gcc:gcc-$(CPU_PREFIX_$b:%-lx106-elf=%-lx106))
	@$(foreach b,$(BOARDS),test -f \
	    "$$($(CPU_PREFIX_$b)-gcc -print-file-name=$(or \
	        $(CPU_LIBRARY_$b),picolibc.specs))" || \
	    tests/tools/need.sh picolibc.specs:picolibc-$(CPU_PREFIX_$b);)

endif
