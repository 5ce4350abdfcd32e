# The page that draws: core, the reader of scripts, the methods of the atlas and
# examples as WebAssembly, in one HTML file.
.PHONY: page check-page

PAGE := $(BUILD)/page
PAGE_OBJECTS := $(BUILD)/wasm
PAGE_CC := clang --target=wasm32-wasi
PAGE_FLAGS := -Os -D_GNU_SOURCE
PAGE_EXAMPLES := watch thermostat scope game globe badge
PAGE_ASSETS := $(sort $(foreach e,$(PAGE_EXAMPLES),$(EXAMPLE_ASSETS_$e)))
PAGE_SOURCES := $(CORE) page/page.c page/parts.c port/sdl/inspect.c \
    sim/view/inspect.c $(wildcard bench/methods/fill_*.c) \
    $(filter-out %/run.c %/shrink.c %/compare.c %/explain_command.c, \
        $(wildcard sim/script/*.c)) \
    $(filter-out %/render.c %/painter.c %/scene_options.c %/scene_pel2d.c, \
        $(wildcard sim/render/*.c)) \
    $(filter-out $(call sim_of,$(SIM_LIBRARIES)), \
        $(wildcard sim/image/*.c sim/font/*.c sim/icon/*.c sim/mesh/*.c)) \
    $(patsubst %,sim/cli/%.c,choice child_data message number text_line) \
    drivers/dirty.c drivers/input.c
PAGE_PARTS := $(PAGE_SOURCES:%.c=$(PAGE_OBJECTS)/%.o) \
    $(PAGE_EXAMPLES:%=$(PAGE_OBJECTS)/examples/%.o) \
    $(PAGE_ASSETS:%=$(PAGE_OBJECTS)/%.o)

$(PAGE_OBJECTS)/%.o: %.c | need-page
	@mkdir -p $(@D)
	$(PAGE_CC) $(PEL_CFLAGS) $(PAGE_FLAGS) -c $< -o $@
$(PAGE_OBJECTS)/page/page.o: PAGE_FLAGS += \
    '-DPAGE_MAINS=$(foreach e,$(PAGE_EXAMPLES),MAIN($e_main))'
$(PAGE_OBJECTS)/examples/%.o: examples/%.c $(PAGE_ASSETS:%=$(BUILD)/examples/%.c) | need-page
	@mkdir -p $(@D)
	$(PAGE_CC) $(PEL_CFLAGS) $(PAGE_FLAGS) -I$(BUILD)/examples -Dmain=$*_main \
	    '-DPANEL_HEADER="page/panel.h"' -c $< -o $@
$(PAGE_OBJECTS)/%.o: $(BUILD)/examples/%.c | need-page
	@mkdir -p $(@D)
	$(PAGE_CC) $(PEL_CFLAGS) $(PAGE_FLAGS) -c $< -o $@
-include $(wildcard $(PAGE_OBJECTS)/*/*.d $(PAGE_OBJECTS)/*/*/*.d)

# A reactor: a program without a main.
$(PAGE_OBJECTS)/pel.wasm: $(PAGE_PARTS)
	$(PAGE_CC) -mexec-model=reactor -Wl,--strip-all -Wl,-z,stack-size=262144 \
	    -Wl,--max-memory=268435456 \
	    $^ -o $@

page: $(PAGE)/index.html ## a page that draws scripts as they are typed: build/page
	@echo "the page: $< ($$(wc -c <$<) bytes)"
$(PAGE)/index.html: page/build.js $(wildcard page/*.html page/*.css page/*.js page/*.pel) \
    $(wildcard sim/scenes/*) $(PAGE_OBJECTS)/pel.wasm
	@mkdir -p $(@D)
	node page/build.js $(PAGE_OBJECTS)/pel.wasm "$(PAGE_EXAMPLES)" >$@

# In Chromium, in ten seconds.
CHECK_EXTRA += check-page
check-page: $(PAGE)/index.html $(BUILD)/pel $(PAGE_EXAMPLES:%=$(BUILD)/examples/%)
	@tests/tools/need.sh chromium:chromium
	node tests/page/check.js $(BUILD)/pel $(PAGE) $(PAGE_EXAMPLES:%=$(BUILD)/examples/%)

.PHONY: need-page
need-page:
	@tests/tools/need.sh clang:clang wasm-ld:lld node:nodejs
