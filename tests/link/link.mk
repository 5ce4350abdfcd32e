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
    ellipse_outline arc_outline polygon_outline text smooth_text \
    smooth_outline_text smooth_icon \
    path path_stroke path_dashes polyline hit_path hit_path_stroke hit_path_dashes \
    $(addprefix smooth_,path path_stroke \
    path_dashes polyline triangle polygon rectangle thick_line \
    thick_line_round circle ring sector arc arc_round ellipse \
    rounded_rectangle)
LINK_PAINTS := flat flat_alpha gouraud linear radial conic hue fan nearest \
    nearest_colors bilinear dither blend checker hatch nine_slice user
# Chips of drivers/panel.h, of which every CPU has two.
LINK_COLOR := st7789 st7735 st7796 ili9341 ili9342 ili9488 gc9a01 ssd1351
LINK_MONO := ssd1306 ssd1309 sh1106 sh1107 st7565 pcd8544
LINK_PANELS := $(LINK_COLOR) $(LINK_MONO) ssd0323
LINK_FORMAT_ili9488 := pel_bgr888
LINK_FORMAT_ssd0323 := pel_gray4
LINK_GRAYS := ssd1680_gray2 uc8151_gray2 uc8179_gray2
LINK_PAPERS := ssd1680 ssd1681 il3897 uc8151 uc8179 $(LINK_GRAYS)
link_format = $(or $(LINK_FORMAT_$1),$(if \
    $(filter $1,$(LINK_COLOR)),pel_rgb565_be_fill,pel_mono1_pages))
LINK_FILES := $(filter-out shape paint panel panel_times epaper pairs every_smooth,$(basename $(notdir \
    $(wildcard tests/link/*.c)))) panel_st7789 panel_ssd1306
# All of them for two CPUs, of which other ones differ little; at -O2 those of
# docs/MATRIX.md, which has paints of these two.
LINK_WHOLE := cortex-m0plus cortex-m4
LINK_ALL := $(sort $(LINK_FILES) every_smooth $(LINK_SHAPES:%=shape_%) \
    $(LINK_PAINTS:%=paint_%) $(LINK_PANELS:%=panel_%) \
    $(LINK_PAPERS:%=epaper_%))
LINK_MATRIX := flat flat_circle_alpha scene
LINK_BUILDS := $(foreach l,$(MCU_LEVELS),$(MCU_CPUS:%=%-$l))
LINK_WHOLE_BUILDS := $(foreach l,small Os,$(LINK_WHOLE:%=%-$l))
$(foreach b,$(LINK_BUILDS),$(eval LINK_PROGRAMS_$b := $(if $(filter \
    %-O2,$b),$(LINK_MATRIX) $(if $(filter $b,$(LINK_WHOLE:%=%-O2)),\
        $(LINK_PAINTS:%=paint_%)),$(if $(filter \
    $b,$(LINK_WHOLE_BUILDS)),$(LINK_ALL),$(LINK_FILES)))))

# The M0+ programs run on a Cortex-M0, which traps what a v6-M core cannot do.
LINK_BOARD_cortex-m0plus := microbit
LINK_BOARD_cortex-m4 := mps2_an386
LINK_BOARD_cortex-m7 := mps2_an500
LINK_BOARD_cortex-m33 := mps2_an505
LINK_BOARD_arm926 := versatilepb
LINK_BOARD_rv32imc := virt
LINK_BOARD_lx106 := xtensa_sim

# $1 build, $2 CPU
define link_programs
$(BUILD)/mcu/$1/libdrivers.a: $(DRIVERS:%.c=$(BUILD)/mcu/$1/%.o)
	rm -f $$@
	$(AR) rcs $$@ $$^
$(BUILD)/link/$1/%.elf: $(BUILD)/mcu/$1/tests/link/%.o \
    $(patsubst %.c,$(BUILD)/mcu/$1/%.o,$(MCU_PORT) $(MCU_PORT_$2)) $(BUILD)/mcu/$1/libdrivers.a \
    $(BUILD)/mcu/$1/libpel.a
	@mkdir -p $$(@D)
	$(MCU_CC_$2) $(MCU_LDFLAGS) -Wl,--wrap=main -Wl,-Map=$$@.map \
	    $(call mcu_script,$(LINK_BOARD_$2)) $$^ -o $$@
$(BUILD)/mcu/$1/tests/link/shape_%.o: tests/link/shape.c | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -DDRAW=draw_$$* -c $$< -o $$@
$(BUILD)/mcu/$1/tests/link/paint_%.o: tests/link/paint.c | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -DMAKE=make_$$* -c $$< -o $$@
$(BUILD)/mcu/$1/tests/link/panel_%.o: tests/link/panel.c | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -DPANEL=pel_panel_$$* \
	    -DFORMAT=$$(call link_format,$$*) -c $$< -o $$@
$(BUILD)/mcu/$1/tests/link/epaper_%.o: tests/link/epaper.c | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -DPAPER=pel_epaper_$$* \
	    -DFORMAT=pel_$$(if $$(filter $(LINK_GRAYS),$$*),gray2,mono1) \
	    -DIDLE=$$(if $$(filter uc%,$$*),true,false) -c $$< -o $$@
endef
$(foreach c,$(MCU_CPUS),$(foreach l,$(MCU_LEVELS),$(eval $(call \
    link_programs,$c-$l,$c))))

# The levels that firmware is built with.
MCU_CORE_OBJECTS := $(foreach c,$(MCU_CPUS),$(foreach l,small Os,\
    $(CORE:%.c=$(BUILD)/mcu/$c-$l/%.o)))
LINK_ELFS := $(foreach b,$(LINK_BUILDS),\
    $(patsubst %,$(BUILD)/link/$b/%.elf,$(LINK_PROGRAMS_$b) \
        $(if $(filter $b,$(LINK_WHOLE_BUILDS)),pairs)))

# The same from the amalgamation, which takes no more.
LINK_ONE_BUILDS := $(foreach c,cortex-m0plus cortex-m4 rv32imc,\
    $(MCU_LEVELS:%=$c-%))
define link_one
LINK_ONE_$1 := $(filter $(LINK_FILES),$(LINK_PROGRAMS_$1))
$(BUILD)/mcu/$1/one.o: $(ONE)/pel.c $(ONE)/pel.h | need-arm
	@mkdir -p $$(@D)
	$$(MCU_COMPILE_$1) -c $$< -o $$@
$(BUILD)/link/$1/one/%.elf: $(BUILD)/mcu/$1/tests/link/%.o \
    $(MCU_PORT:%.c=$(BUILD)/mcu/$1/%.o) $(BUILD)/mcu/$1/libdrivers.a \
    $(BUILD)/mcu/$1/one.o
	@mkdir -p $$(@D)
	$(MCU_CC_$2) $(MCU_LDFLAGS) -Wl,--wrap=main \
	    $(call mcu_script,$(LINK_BOARD_$2)) $$^ -o $$@
endef
$(foreach b,$(LINK_ONE_BUILDS),$(eval $(call link_one,$b,$(patsubst \
    %-$(lastword $(subst -, ,$b)),%,$b))))
LINK_ELFS += $(foreach b,$(LINK_ONE_BUILDS),\
    $(LINK_ONE_$b:%=$(BUILD)/link/$b/one/%.elf))

# Bytes of stack that any shape with any paint may take, with small code or
# without.
LINK_STACK := 384

# What one would build (docs/PRODUCTS.md). Those of both CPUs run on a board with
# a Cortex-M4, which has memory for whole screens. $1 build, $2 CPU, $3 product
PRODUCTS := badge game gauge globe scope thermostat watch
define product_program
$(BUILD)/link/$1/product_$3.elf: $(call example_sources,$3) tests/link/product.h $(MCU_PORT:%.c=$(BUILD)/mcu/$1/%.o) \
    $(BUILD)/mcu/$1/libdrivers.a $(BUILD)/mcu/$1/libpel.a
	@mkdir -p $$(@D)
	$(MCU_CC_$2) $(MCU_FLAGS_O2) $(MCU_CFLAGS) -I$(BUILD)/examples \
	    -DPANEL_HEADER='"tests/link/product.h"' $(MCU_LDFLAGS) -Wl,--wrap=main \
	    $(call mcu_script,mps2_an386) $$(filter-out %.h,$$^) -o $$@
endef
PRODUCT_ELFS := $(foreach c,$(LINK_WHOLE),$(PRODUCTS:%=$(BUILD)/link/$c-O2/product_%.elf))
$(foreach c,$(LINK_WHOLE),$(foreach p,$(PRODUCTS),$(eval $(call \
    product_program,$c-O2,$c,$p))))

# The program of the guide with the bus of each chip of port/spi_dma, linked; those
# that need a vendor's headers are compiled with stubs of them.
LINK_GUIDES := rp2040 stm32g0 stm32f4 nrf52
LINK_CPU_rp2040 := cortex-m0plus
LINK_CPU_stm32g0 := cortex-m0plus
LINK_CPU_stm32f4 := cortex-m4
LINK_CPU_nrf52 := cortex-m4
LINK_VECTOR_rp2040 := isr_irq11
LINK_VECTOR_stm32g0 := DMA1_Channel1_IRQHandler
LINK_VECTOR_stm32f4 := DMA2_Stream3_IRQHandler
LINK_VECTOR_nrf52 := SPIM2_SPIS2_SPI2_IRQHandler
LINK_STUBS := stm32_hal stm32f4_ll esp_lcd
LINK_STUBS_stm32_hal := hal
LINK_STUBS_stm32f4_ll := ll
LINK_STUBS_esp_lcd := esp

# $1 chip, $2 build
define link_guide
$(BUILD)/link/guide/$1.elf: port/spi_dma/$1.c port/spi_dma/spi_dma.inc \
    docs/firmware.md tests/link/guide.sh $(BUILD)/mcu/$2/libdrivers.a \
    $(BUILD)/mcu/$2/libpel.a
	tests/link/guide.sh $$(@D)/$1 $$(MCU_COMPILE_$2) $$(MCU_LDFLAGS) \
	    -Wl,-e,main -Wl,--require-defined=$(LINK_VECTOR_$1) $$(filter %.c %.a,$$^) -o $$@
endef
$(foreach c,$(LINK_GUIDES),$(eval $(call link_guide,$c,$(LINK_CPU_$c)-Os)))
$(LINK_STUBS:%=$(BUILD)/link/guide/%.o): $(BUILD)/link/guide/%.o: \
    port/spi_dma/%.c port/spi_dma/spi_dma.inc $(wildcard tests/link/stubs/*/*.h \
    tests/link/stubs/*/*/*.h) | need-arm
	@mkdir -p $(@D)
	$(MCU_COMPILE_cortex-m4-Os) -Itests/link/stubs/$(LINK_STUBS_$*) -c $< -o $@
# The parallel bus of bus_8080.h's own words, on memory that a controller maps.
$(BUILD)/link/guide/bus_8080.o: drivers/bus_8080.h drivers/panel.h | need-arm
	@mkdir -p $(@D)
	{ echo '#include "drivers/bus_8080.h"'; echo '#include "drivers/panel.h"'; \
	    echo 'enum pel_status pause(const struct pel_bus_8080 *, bool, uint32_t);'; \
	    echo 'struct pel_panel *mapped(void);'; \
	    sed -n '/\*\//q; s/^ \*     //p' $<; \
	    echo 'struct pel_panel *mapped(void) { return &panel; }'; } >$(@:.o=.c)
	$(MCU_COMPILE_cortex-m4-Os) -c $(@:.o=.c) -o $@
.PHONY: guide
guide: $(LINK_GUIDES:%=$(BUILD)/link/guide/%.elf) $(BUILD)/link/guide/bus_8080.o \
    $(LINK_STUBS:%=$(BUILD)/link/guide/%.o)

# Built for the host: times follow from bytes.
$(BUILD)/link/panel_times: tests/link/panel_times.c $(DRIVERS:%.c=$(BUILD)/%.o) \
    $(BUILD)/libpel.a
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(CFLAGS) $^ -o $@

# With ACCEPT=1 what is measured becomes the new limit.
size: $(MCU_CORE_OBJECTS) $(LINK_ELFS) guide \
    $(BUILD)/link/panel_times | need-qemu-arm ## bytes and stack on small CPUs: build/size.tsv
	printf '%s\n' $(foreach b,$(LINK_BUILDS),'$b $(LINK_PROGRAMS_$b)') | \
	    tests/link/size.sh $(BUILD) >$(BUILD)/size.tsv
	printf '%s\n' $(foreach b,$(LINK_ONE_BUILDS),'$b $(LINK_ONE_$b)') | \
	    tests/link/one.sh $(BUILD)/link
	tests/link/budgets.sh $(BUILD)/size.tsv $(ACCEPT)
	bench/mcu/matrix.sh $(ACCEPT)
	tests/link/panels.sh $(BUILD)/link/panel_times $(ACCEPT)
	$(foreach b,$(LINK_WHOLE_BUILDS),tests/link/pairs.sh $b \
	    $(BUILD)/link/$b/pairs.elf $(LINK_STACK) >$(BUILD)/stack_$b.tsv &&) :
