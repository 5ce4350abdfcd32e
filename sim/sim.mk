# The host program. Each of these libraries is used where pkg-config finds it;
# without them pel is built all the same, and `pel demo` names what each would
# add.

PKG_CONFIG ?= pkg-config
sim_has = $(shell $(PKG_CONFIG) --exists $(1) 2>/dev/null && echo $(1))
SIM_LIBRARIES := assimp jansson libzip expat sdl2 SDL2_image libpng libjpeg freetype2 \
    harfbuzz
SIM_PACKAGES := $(strip $(foreach p,$(SIM_LIBRARIES),$(call sim_has,$p)))

sim_define_assimp := -DHAVE_ASSIMP
sim_define_sdl2 := -DHAVE_SDL2
sim_define_SDL2_image := -DHAVE_SDL2_IMAGE
sim_define_libpng := -DHAVE_LIBPNG
sim_define_libjpeg := -DHAVE_LIBJPEG
sim_define_jansson := -DHAVE_JANSSON
sim_define_libzip := -DHAVE_LIBZIP
sim_define_expat := -DHAVE_EXPAT
sim_define_freetype2 := -DHAVE_FREETYPE
sim_define_harfbuzz := -DHAVE_HARFBUZZ

SIM_FLAGS := -D_GNU_SOURCE \
             $(shell $(PKG_CONFIG) --version >/dev/null 2>&1 && \
                     echo -DHAVE_PKG_CONFIG) \
             $(foreach p,$(SIM_PACKAGES),$(sim_define_$(p)))
SIM_LIBS := -lm
ifneq ($(SIM_PACKAGES),)
# System headers are not held to our warnings: -isystem for -I.
SIM_FLAGS += $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags \
                                               $(SIM_PACKAGES)))
SIM_LIBS := $(shell $(PKG_CONFIG) --libs $(SIM_PACKAGES)) -lm
endif

include drivers/linux.mk
include port/sdl/sdl.mk

# What nothing calls without a library; another file says that it is missing.
SIM_OF_assimp := sim/mesh/material.c sim/mesh/mend_import.c
SIM_OF_jansson := $(wildcard sim/mesh/gltf_*.c)
SIM_OF_libzip := sim/mesh/mend_3mf_put.c
SIM_OF_expat := $(SIM_OF_libzip) sim/icon/svg_shape.c sim/icon/svg_style.c
SIM_OF_freetype2 := sim/font/kerning.c sim/font/outline.c sim/font/outline_points.c
SIM_OF_sdl2 := port/sdl/window_sdl.c
sim_of = $(foreach p,$1,$(SIM_OF_$p))

# The sources of pel with the libraries $1.
sim_sources = $(filter-out $(call sim_of,$(filter-out $1,$(SIM_LIBRARIES))),\
    $(sort $(wildcard sim/*.c sim/*/*.c)) port/sdl/inspect.c $(SIM_OF_sdl2))
SIM := $(call sim_sources,$(SIM_PACKAGES))
SIM_OBJECTS := $(SIM:%.c=$(BUILD)/%.o)

all: $(BUILD)/pel

$(BUILD)/pel: $(SIM_OBJECTS) $(BUILD)/libpel_linux.a $(BUILD)/libpel.a
	$(CC) $(CFLAGS) $(LDFLAGS) $^ $(SIM_LIBS) $(LINUX_LIBS) -o $@

# Changes only when the flags do, so that a library that was installed later is
# taken by the next make.
$(BUILD)/sim/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(SIM_FLAGS) $(LINUX_FLAGS)' >$@.new; \
	cmp -s $@.new $@ && rm $@.new || mv $@.new $@

$(BUILD)/sim/%.o: sim/%.c $(BUILD)/sim/flags
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(SIM_FLAGS) $(LINUX_FLAGS) $(CFLAGS) -c $< -o $@

$(BUILD)/sim/font/asset.o: sim/scenes/fixed_6x13.bdf

# Scripts that need fonts of a package.
DEMO_FONT := /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
DEMO_TYPE := $(and $(filter freetype2,$(SIM_PACKAGES)),$(wildcard \
    $(DEMO_FONT)),$(sort $(wildcard sim/scenes/fonts/*.pel)))

.PHONY: demo FORCE
demo: $(BUILD)/pel ## the gallery, with the time of each picture, in build/demo
	@$(if $(wildcard $(DEMO_FONT)),:,echo "no type specimen: the package fonts-dejavu-core is missing")
	$(BUILD)/pel demo $(BUILD)/demo $(sort $(wildcard sim/scenes/*.pel)) $(DEMO_TYPE) \
	    $(shell sed -n 's,^\([a-z]*\) .*,docs/pictures/\1.png,p' docs/pictures/list.txt) \
	    docs/PRODUCTS.md
	@echo "the gallery: $(BUILD)/demo/index.html"

-include $(SIM_OBJECTS:.o=.d)
