# Pel. `make help` lists the targets.

.DEFAULT_GOAL := all
# What a command has half written is deleted where it fails.
.DELETE_ON_ERROR:

.PHONY: setup clean
setup: ## install the Debian packages of packages.txt (sudo when not root)
	tests/tools/setup.sh

BUILD := build
clean: ## remove build/
	rm -rf $(BUILD)

# What is installed and built is looked for when the Makefile is read: goals
# beside these two get a make of their own, after them.
FIRST_GOALS := $(filter setup clean,$(MAKECMDGOALS))
OTHER_GOALS := $(filter-out setup clean,$(MAKECMDGOALS))
ifneq ($(and $(FIRST_GOALS),$(OTHER_GOALS)),)
.PHONY: $(OTHER_GOALS) other-goals
$(OTHER_GOALS): other-goals ;
other-goals: $(FIRST_GOALS)
	$(MAKE) --no-print-directory $(OTHER_GOALS)
else

CC ?= cc
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow \
            -Wundef
CFLAGS ?= -O2 -g
# WERROR is -Werror in our own checks alone: a compiler of tomorrow warns of more.
PEL_CFLAGS = -std=c99 $(WARNINGS) $(WERROR) -I. -Iinclude -MMD -MP

CORE := $(sort $(wildcard core/*/*.c))
CORE_OBJECTS := $(CORE:%.c=$(BUILD)/%.o)
# Drivers that no platform stands below.
without_linux = $(foreach d,$1,$(if $(findstring linux,$d),,$d))
DRIVERS := $(call without_linux,$(wildcard drivers/*.c))

# Examples, and the C files that pel import makes for them.
EXAMPLE_ASSETS_badge := bold_30 mono_15 portrait
EXAMPLE_ASSETS_gauge := digits_36
EXAMPLE_ASSETS_globe := earth sphere
EXAMPLE_ASSETS_kiosk := sans_17 sans_24 sans_40
EXAMPLE_ASSETS_mesh := vase_small
EXAMPLE_ASSETS_oled := fixed_6x13
EXAMPLE_ASSETS_scope := sans_15
EXAMPLE_ASSETS_thermostat := digits_76 sans_17 drop flame sun
EXAMPLE_ASSETS_watch := digits_20
EXAMPLE_ASSETS_paints := fixed_6x13
EXAMPLES := $(sort $(wildcard examples/*.c))
EXAMPLE_NAMES := $(EXAMPLES:examples/%.c=%)
$(if $(filter board window device,$(MAKECMDGOALS)),$(if \
    $(filter-out $(EXAMPLE_NAMES),$(EXAMPLE)),$(error EXAMPLE=$(EXAMPLE): expected \
    one of $(EXAMPLE_NAMES), or a program of yours in examples/$(EXAMPLE).c)))
# Who runs one wants to see it, not how it is compiled.
ifneq ($(filter board window device demo,$(MAKECMDGOALS)),)
.SILENT:
$(if $(wildcard $(if $(filter demo,$(MAKECMDGOALS)),$(BUILD)/pel, \
    $(BUILD)/board $(BUILD)/window)),,$(info what it takes is compiled now, \
    which may take two minutes))
endif
example_sources = examples/$1.c $(wildcard examples/$1/*.c) \
    $(EXAMPLE_ASSETS_$1:%=$(BUILD)/examples/%.c)

.PHONY: all help
all: $(BUILD)/libpel.a ## build/libpel.a and the host program build/pel

-include sim/sim.mk
-include bench/bench.mk
-include page/page.mk
include packaging/packaging.mk
-include tests/tests.mk

$(BUILD)/libpel.a: $(CORE_OBJECTS)
	rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/core/%.o: core/%.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(CFLAGS) -c $< -o $@

EXAMPLE_PROGRAMS := $(EXAMPLES:%.c=$(BUILD)/%)

define example_program
$(BUILD)/examples/$1: $(call example_sources,$1) $(DRIVERS) $(BUILD)/libpel.a \
    $(wildcard examples/*.h drivers/*.h)
	@mkdir -p $$(@D)
	$$(CC) $$(PEL_CFLAGS) -I$$(@D) $$(CFLAGS) $$(filter %.c %.a,$$^) -o $$@
endef
$(foreach e,$(EXAMPLE_NAMES),$(eval $(call example_program,$e)))

$(BUILD)/examples/fixed_%.c: sim/scenes/fixed_%.bdf $(BUILD)/pel
	@mkdir -p $(@D)
	$(BUILD)/pel import $< -o $@ >/dev/null
# Letters of DejaVu (fonts-dejavu-core), NAME_PX, or without FreeType and it a font
# that is here; pictures, drawn by scripts.
DEJAVU := /usr/share/fonts/truetype/dejavu
EXAMPLE_FONT_sans := DejaVuSans.ttf --codes 32-126,0xB0
EXAMPLE_FONT_digits := DejaVuSans.ttf --chars "0123456789.° "
EXAMPLE_FONT_bold := DejaVuSans-Bold.ttf --codes 32-126 --bits 1
EXAMPLE_FONT_mono := DejaVuSansMono.ttf --codes 32-126,0x201C-0x201D --bits 1
define example_font
$(BUILD)/examples/$1_%.c: $(BUILD)/pel
	@mkdir -p $$(@D)
	$(BUILD)/pel import $$(if $$(and $$(filter freetype2,$$(SIM_PACKAGES)),\
	    $$(wildcard $(DEJAVU)/DejaVuSansMono.ttf)),$(DEJAVU)/$$(EXAMPLE_FONT_$1) \
	    --font-size $$*,sim/scenes/fixed_10x20.bdf) -o $$@ >/dev/null
endef
$(foreach f,sans digits bold mono,$(eval $(call example_font,$f)))
EXAMPLE_PICTURE_earth := --format rgb565_le
EXAMPLE_PICTURE_portrait := --format mono1 --dither diffusion
$(BUILD)/examples/%.c: examples/pictures/%.pel $(BUILD)/pel
	@mkdir -p $(@D)
	$(BUILD)/pel run $< -o $(@:.c=.ppm)
	$(BUILD)/pel import $(@:.c=.ppm) $(or $(EXAMPLE_PICTURE_$*),--format gray4) -o $@ >/dev/null
$(BUILD)/examples/sphere.c: examples/pictures/sphere.awk $(BUILD)/pel
	@mkdir -p $(@D)
	awk -f $< >$(@:.c=.obj)
	$(BUILD)/pel import $(@:.c=.obj) -o $@ >/dev/null
$(BUILD)/examples/vase_small.c: $(BUILD)/pel
	@mkdir -p $(@D)
	$(BUILD)/pel import builtin:vase-small -o $@ >/dev/null

# A copy of core under the name pel is all that a program needs.
$(BUILD)/vendored/user_paint: examples/user_paint.c $(CORE)
	@rm -rf $(@D) && mkdir -p $(@D) && cp -R core $(@D)/pel && cp $< $(@D)
	cd $(@D) && $(CC) -std=c99 $(WARNINGS) $(WERROR) $(CFLAGS) -I. \
	    user_paint.c pel/*/*.c -o $(@F)

.PHONY: examples
examples: $(EXAMPLE_PROGRAMS) $(BUILD)/vendored/user_paint ## build and run the examples
	@for e in $(EXAMPLE_PROGRAMS); do tests/tools/example.sh $$e $$e || exit; done
	@$(BUILD)/vendored/user_paint | cmp - $(BUILD)/examples/user_paint.ppm

help: ## this list
	@grep -hE '^[a-z-]+:.*##' $(filter-out %.d,$(MAKEFILE_LIST)) | sort | \
	    sed -E 's/^([a-z-]+):.*## /\1\t/' | awk -F '\t' '{printf "%-20s %s\n", $$1, $$2}'

# Compilers write what an object depends on; no rule makes it.
$(BUILD)/%.d: ;
-include $(CORE_OBJECTS:.o=.d)

endif
