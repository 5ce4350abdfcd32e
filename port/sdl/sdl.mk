# The window, where pkg-config finds SDL2: build/libpel_sdl.a, and `make window`.
SDL_FOUND := $(filter sdl2,$(SIM_PACKAGES))
SDL_FLAGS := $(if $(SDL_FOUND),$(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) \
    --cflags sdl2)))
SDL_LIBS := $(if $(SDL_FOUND),$(shell $(PKG_CONFIG) --libs sdl2))
SDL_LIBRARY := $(SDL_FOUND:%=$(BUILD)/libpel_sdl.a)
SDL_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(wildcard port/sdl/*.c))
all: $(SDL_LIBRARY)

$(SDL_OBJECTS): $(BUILD)/%.o: %.c $(BUILD)/sim/flags
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(SDL_FLAGS) $(CFLAGS) -c $< -o $@
$(BUILD)/libpel_sdl.a: $(SDL_OBJECTS) $(DRIVERS:%.c=$(BUILD)/%.o)
	rm -f $@
	$(AR) rcs $@ $^
-include $(SDL_OBJECTS:.o=.d)

# An example whose panel is a window; ms from frame to frame, where 33 are not it.
WINDOW_PERIOD_watch := 1000
WINDOW_PERIOD_badge := 1000
WINDOW_PERIOD_thermostat := 200
.PHONY: window need-window
window: $(if $(SDL_FOUND),,need-window) $(BUILD)/window/$(or $(EXAMPLE),watch) ## an example in a window: EXAMPLE=watch
	$<
$(BUILD)/window/%: examples/%.c $(SDL_LIBRARY) $(BUILD)/libpel.a $(BUILD)/examples/%
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -I$(BUILD)/examples $(CFLAGS) '-DPANEL_TITLE="$*"' \
	    -DPANEL_PERIOD=$(or $(WINDOW_PERIOD_$*),33) \
	    '-DPANEL_HEADER="window.h"' $(call example_sources,$*) \
	    $(SDL_LIBRARY) $(BUILD)/libpel.a $(SDL_LIBS) -o $@
need-window:
	@tests/tools/need.sh pkg-config:pkg-config sdl2-config:libsdl2-dev
	@echo "pkg-config does not find sdl2, of the Debian package libsdl2-dev" >&2; false

# The window of a program, and what it shows, on an X server without a screen.
CHECK_EXTRA += $(SDL_FOUND:%=check-window)
.PHONY: check-window
check-window: $(BUILD)/pel $(SDL_FOUND:%=$(BUILD)/window/check/program) $(BUILD)/window/check/screen
	PEL=$(BUILD)/pel sh tests/window/check.sh $(BUILD)/window/check/program \
	    $(BUILD)/window/check/screen
$(BUILD)/window/check/%: tests/window/%.c $(SDL_LIBRARY) $(BUILD)/libpel.a
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(CFLAGS) $^ $(SDL_LIBS) -o $@
