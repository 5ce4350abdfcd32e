# The LCD controllers of Arm in QEMU, and panels on a bus: what the screen shows
# is the reference of tests/device/linux, which Pel has no part in.

LCD_HERE := tests/device/lcd
LCD := $(BUILD)/lcd
LCD_BOARDS := versatilepb realview-pbx-a9 integratorcp
LCD_FLAGS_versatilepb := -DUART=0x101F1000 -DLCD=0x10120000 -DKIND=PEL_PL110_VERSATILE
LCD_FLAGS_realview-pbx-a9 := -DUART=0x10009000 -DLCD=0x10020000 -DKIND=PEL_PL111
LCD_FLAGS_integratorcp := -DUART=0x16000000 -DLCD=0xC0000000 -DKIND=PEL_PL110

# $1 board: the code of the ARM926 runs on all of them.
define lcd_board
$(LCD)/$1.elf: $(LCD_HERE)/main.c $(LCD_HERE)/guest.c drivers/display_pl11x.c \
    drivers/display_pl11x.h $(LCD_HERE)/guest.h $(BUILD)/cpus/gcc-arm926-O2/scenes
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_arm926)-gcc $(CPU_FLAGS_arm926) $$(PEL_CFLAGS) -O2 \
	    $(LCD_FLAGS_$1) $$(filter %.c,$$^) \
	    $(CORE:%.c=$(BUILD)/cpus/gcc-arm926-O2/%.o) $(CPU_LINK_arm926) -o $$@
endef
$(foreach b,$(LCD_BOARDS),$(eval $(call lcd_board,$b)))

# Panels on a bus, by boards with a Cortex-M3, which runs the code of an M0+.
OLED_BOARDS := lm3s811evb lm3s6965evb
OLED_LINK_lm3s811evb := $(call board_link,0,64K,0x20000000,8K)
OLED_LINK_lm3s6965evb := $(CPU_LINK_lm3s6965evb)

# $1 board
define oled_board
$(LCD)/$1.elf: $(LCD_HERE)/$1.c $(LCD_HERE)/oled.c $(LCD_HERE)/guest.c \
    $(wildcard drivers/panel*.c) $(LCD_HERE)/oled.h $(LCD_HERE)/guest.h \
    drivers/panel.h drivers/panel_chip.h $(BUILD)/cpus/gcc-m0plus-O2/scenes
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_m0plus)-gcc $(CPU_FLAGS_m0plus) $$(PEL_CFLAGS) -Os \
	    -DUART=0x4000C000 -fdata-sections -Wl,--gc-sections $$(filter %.c,$$^) \
	    $(CORE:%.c=$(BUILD)/cpus/gcc-m0plus-O2/%.o) $(OLED_LINK_$1) -o $$@
endef
$(foreach b,$(OLED_BOARDS),$(eval $(call oled_board,$b)))

.PHONY: check-lcd
check-lcd: $(LCD_BOARDS:%=$(LCD)/%.elf) $(OLED_BOARDS:%=$(LCD)/%.elf) $(filter %/vm %/screen_check %/reference,$(LINUX_TOOLS))
	@$(LCD_HERE)/check.sh $(BUILD) $(LCD_BOARDS) $(OLED_BOARDS)
