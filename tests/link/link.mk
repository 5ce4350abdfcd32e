# The smallest programs, linked with core for microcontrollers, and what they
# cost.
include port/boards.mk
include port/cortex_m/cortex_m.mk

.PHONY: size

# One shape of draws.h with a flat paint each, one paint of makes.h each, and the
# programs that have a file.
LINK_SHAPES := triangle triangle_or_line polygon rectangle line thick_line \
    circle ring sector arc ellipse rounded_rectangle triangle_outline \
    rectangle_outline rounded_rectangle_outline circle_outline \
    ellipse_outline arc_outline polygon_outline text
LINK_PAINTS := flat flat_alpha gouraud linear radial conic hue fan nearest \
    nearest_colors bilinear dither user
LINK_FILES := $(filter-out shape paint pairs,$(basename $(notdir $(wildcard \
    tests/link/*.c))))
# All of them for two CPUs, of which other ones differ little.
LINK_WHOLE := cortex-m0plus cortex-m4
LINK_ALL := $(LINK_FILES) $(LINK_SHAPES:%=shape_%) $(LINK_PAINTS:%=paint_%)
$(foreach c,$(MCU_CPUS),$(eval LINK_PROGRAMS_$c := $(if $(filter \
    $c,$(LINK_WHOLE)),$(LINK_ALL),$(LINK_FILES))))

# The M0+ programs run on a Cortex-M0, which traps what a v6-M core cannot do.
LINK_BOARD_cortex-m0plus := microbit
LINK_BOARD_cortex-m4 := mps2_an386
LINK_BOARD_cortex-m7 := mps2_an500
LINK_BOARD_cortex-m33 := mps2_an505
LINK_BOARD_arm926 := versatilepb
LINK_BOARD_rv32imc := virt

# $1 CPU
define link_programs
$(BUILD)/mcu/$1-Os/libdrivers.a: $(DRIVERS:%.c=$(BUILD)/mcu/$1-Os/%.o)
	rm -f $$@
	$(AR) rcs $$@ $$^
$(BUILD)/link/$1/%.elf: $(BUILD)/mcu/$1-Os/tests/link/%.o \
    $(MCU_PORT:%.c=$(BUILD)/mcu/$1-Os/%.o) $(BUILD)/mcu/$1-Os/libdrivers.a \
    $(BUILD)/mcu/$1-Os/libpel.a
	@mkdir -p $$(@D)
	$(MCU_CC_$1) $(MCU_LDFLAGS) -Wl,--wrap=main -Wl,-Map=$$@.map \
	    $(call mcu_script,$(LINK_BOARD_$1)) $$^ -o $$@
$(BUILD)/mcu/$1-Os/tests/link/shape_%.o: tests/link/shape.c | need-arm
	@mkdir -p $$(@D)
	$(MCU_CC_$1) -Os $(MCU_CFLAGS) -DDRAW=draw_$$* -c $$< -o $$@
$(BUILD)/mcu/$1-Os/tests/link/paint_%.o: tests/link/paint.c | need-arm
	@mkdir -p $$(@D)
	$(MCU_CC_$1) -Os $(MCU_CFLAGS) -DMAKE=make_$$* -c $$< -o $$@
endef
$(foreach c,$(MCU_CPUS),$(eval $(call link_programs,$c)))

MCU_CORE_OBJECTS := $(foreach c,$(MCU_CPUS),$(CORE:%.c=$(BUILD)/mcu/$c-Os/%.o))
LINK_ELFS := $(foreach c,$(MCU_CPUS),\
    $(patsubst %,$(BUILD)/link/$c/%.elf,$(LINK_PROGRAMS_$c) \
        $(if $(filter $c,$(LINK_WHOLE)),pairs)))

# Bytes of stack that any shape with any paint may take.
LINK_STACK := 384

# The program of the guide, compiled and linked; its registers are no board's of
# QEMU.
LINK_GUIDE := $(BUILD)/mcu/cortex-m4-Os
$(BUILD)/link/guide.elf: docs/firmware.md tests/link/guide.sh \
    $(LINK_GUIDE)/libdrivers.a $(LINK_GUIDE)/libpel.a
	tests/link/guide.sh $(BUILD)/link/guide $(MCU_CC_cortex-m4) -Os \
	    $(MCU_CFLAGS) $(MCU_LDFLAGS) -Wl,-e,main \
	    $(LINK_GUIDE)/libdrivers.a $(LINK_GUIDE)/libpel.a \
	    -o $@

# With ACCEPT=1 what is measured becomes the new limit.
size: $(MCU_CORE_OBJECTS) $(LINK_ELFS) $(BUILD)/link/guide.elf | need-qemu-arm ## bytes and stack on small CPUs: build/size.tsv
	printf '%s\n' $(foreach c,$(MCU_CPUS),'$c $(LINK_PROGRAMS_$c)') | \
	    tests/link/size.sh $(BUILD) >$(BUILD)/size.tsv
	tests/link/budgets.sh $(BUILD)/size.tsv $(ACCEPT)
	bench/mcu/matrix.sh $(ACCEPT)
	for cpu in $(LINK_WHOLE); do \
	    tests/link/pairs.sh $$cpu $(BUILD)/link/$$cpu/pairs.elf \
	        $(LINK_STACK) >$(BUILD)/stack_$$cpu.tsv || exit 1; \
	done
