# check-linux: a real kernel under QEMU, with real framebuffer and DRM drivers.
# The guest's kernel and first file system are made once and kept in PEL_CACHE.

CHECK_EXTRA += check-linux
LINUX_CHECK := $(BUILD)/linux
LINUX_HERE := tests/device/linux
ifdef XDG_CACHE_HOME
PEL_CACHE ?= $(XDG_CACHE_HOME)/pel
else ifdef HOME
PEL_CACHE ?= $(HOME)/.cache/pel
else
PEL_CACHE ?= $(BUILD)/cache
endif
LINUX_CACHE := $(PEL_CACHE)/linux-vm
LINUX_ROWS := $(shell sed -n 's/^\([a-z0-9_]*\)|.*/\1/p' $(LINUX_HERE)/rows.txt)
LINUX_JOBS ?= $(shell nproc 2>/dev/null || echo 1)

LINUX_TOOLS := $(addprefix $(LINUX_CHECK)/, layout panel_bus panel_paper console_reset \
               input_devices panel_check vm screen_check reference kiosk)
LINUX_GUEST := $(addprefix $(LINUX_CHECK)/guest/, pel pel_no_restore \
               pel_no_draw fb_mode console_state faults frames damage \
               touch_device pel_gpiod2 faults_gpiod2 kiosk)
LINUX_STATIC := $(LINUX_CHECK)/static
LINUX_CFLAGS = -std=gnu99 $(WARNINGS) $(WERROR) -O2 -I. -Iinclude
# The linker warns of getgrgid in a static program: the guest has its files.
LINUX_STATIC_FLAGS := -static
LINUX_FAULTS := open ioctl mmap read write poll fork socketpair signalfd calloc \
    epoll_create1 inotify_init1 timerfd_create
comma := ,

# The guest's programs bring their libraries along; readers of pictures and
# meshes stay out.
.PHONY: check-linux linux-image linux-static
linux-static: $(BUILD)/libpel.a
	@mkdir -p $(LINUX_STATIC)
	@cp -a $(BUILD)/core $(BUILD)/libpel.a $(LINUX_STATIC)/
	+@$(MAKE) --no-print-directory BUILD=$(LINUX_STATIC) SIM_PACKAGES= \
	    LDFLAGS='$(LINUX_STATIC_FLAGS)' $(LINUX_STATIC)/pel

$(LINUX_CHECK)/layout: $(LINUX_HERE)/layout.c $(LINUX_OBJECTS) \
    $(BUILD)/libpel.a
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $^ $(LINUX_LIBS) -o $@

# A test that stands in for some functions of the system: their names.
define LINUX_LINK_WRAPPED
@mkdir -p $(@D)
@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(1:%=-Wl$(comma)--wrap=%) $^ \
    $(LINUX_LIBS) -lcmocka -o $@
endef

LINUX_PANEL_WRAPS := open ioctl fcntl nanosleep pel_gpio_open pel_gpio_close pel_gpio_set pel_gpio_levels
$(LINUX_CHECK)/panel_bus $(LINUX_CHECK)/panel_paper: \
    $(LINUX_CHECK)/%: $(LINUX_HERE)/%.c $(LINUX_HERE)/panel_calls.c $(LINUX_OBJECTS) \
    tests/support/panel_glass.c tests/support/paper_glass.c \
    tests/support/check.c tests/support/main.c $(BUILD)/libpel.a
	$(call LINUX_LINK_WRAPPED,$(LINUX_PANEL_WRAPS))

LINUX_RESET_WRAPS := open close ioctl tcgetattr tcsetattr write
$(LINUX_CHECK)/console_reset: $(LINUX_HERE)/console_reset.c $(LINUX_OBJECTS) \
    tests/support/check.c tests/support/main.c $(BUILD)/libpel.a
	$(call LINUX_LINK_WRAPPED,$(LINUX_RESET_WRAPS))

LINUX_INPUT_WRAPS := access open epoll_ctl libevdev_new_from_fd libevdev_get_fd \
    libevdev_set_clock_id libevdev_next_event pel_gpio_open pel_gpio_close \
    pel_gpio_levels pel_gpio_edges pel_gpio_descriptors
$(LINUX_CHECK)/input_devices: $(LINUX_HERE)/input_devices.c $(LINUX_OBJECTS) \
    tests/support/check.c tests/support/main.c $(BUILD)/libpel.a
	$(call LINUX_LINK_WRAPPED,$(LINUX_INPUT_WRAPS))

$(LINUX_CHECK)/panel_check: $(LINUX_HERE)/panel_check.c \
    tests/support/panel_glass.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $^ -lcmocka -o $@

$(filter-out %/layout %/panel_bus %/panel_paper %/console_reset %/input_devices %/panel_check %/kiosk,$(LINUX_TOOLS)): $(LINUX_CHECK)/%: $(LINUX_HERE)/%.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $< -o $@

$(LINUX_CHECK)/guest/fb_mode $(LINUX_CHECK)/guest/console_state: \
    $(LINUX_CHECK)/guest/%: $(LINUX_HERE)/%.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_STATIC_FLAGS) $< -o $@

$(LINUX_CHECK)/guest/touch_device: $(LINUX_HERE)/touch_device.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) $< \
	    $(LINUX_LIBS) -o $@

$(LINUX_CHECK)/guest/pel: linux-static
	@mkdir -p $(@D)
	@cp $(LINUX_STATIC)/pel $@

LINUX_STATIC_OBJECTS = $(LINUX_OBJECTS:$(BUILD)/%=$(LINUX_STATIC)/%)
LINUX_STATIC_SIM := $(patsubst %.c,$(LINUX_STATIC)/%.o,$(call sim_sources,))

# The function that a program brings a version of its own of.
LINUX_WRAP_no_restore := pel_console_state_restore
LINUX_WRAP_no_draw := script_draw
$(LINUX_CHECK)/guest/pel_%: $(LINUX_HERE)/%.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_STATIC_FLAGS) \
	    $(LINUX_WRAP_$*:%=-Wl$(comma)--wrap=%) $< $(LINUX_STATIC_SIM) \
	    $(LINUX_STATIC_OBJECTS) $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -lm -o $@

# The same with the other version of libgpiod, or what stands for it.
LINUX_GPIOD2 := port/linux/gpio.c port/linux/gpio_v2.c
LINUX_WRAP_FAULTS = $(LINUX_FAULTS:%=-Wl$(comma)--wrap=%)
$(LINUX_CHECK)/guest/pel_gpiod2: $(LINUX_GPIOD2) linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_STATIC_FLAGS) -I$(LINUX_HERE)/gpiod2 \
	    $(LINUX_GPIOD2) $(LINUX_STATIC_SIM) \
	    $(filter-out %/gpio_v1.o %/gpio.o,$(LINUX_STATIC_OBJECTS)) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -lm -o $@

$(LINUX_CHECK)/guest/faults_gpiod2: $(LINUX_GPIOD2) $(LINUX_HERE)/faults.c \
    $(LINUX_HERE)/fault_calls.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) \
	    -I$(LINUX_HERE)/gpiod2 $(LINUX_WRAP_FAULTS) $(filter %.c,$^) \
	    $(filter-out %/gpio_v1.o %/gpio.o,$(LINUX_STATIC_OBJECTS)) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

# The kiosk of examples/, and what it shows where the same is done to it.
KIOSK_SOURCES = $(filter-out drivers/%,$(call example_sources,kiosk))
$(LINUX_CHECK)/guest/kiosk: linux-static $(BUILD)/examples/kiosk examples/linux.h
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) \
	    -I$(BUILD)/examples '-DPANEL_HEADER="linux.h"' $(KIOSK_SOURCES) \
	    $(LINUX_STATIC_OBJECTS) $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@
$(LINUX_CHECK)/kiosk: $(LINUX_HERE)/kiosk_events.h $(BUILD)/examples/kiosk
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) -I$(BUILD)/examples -include $< $(KIOSK_SOURCES) \
	    drivers/dirty.c $(BUILD)/libpel.a -o $@

$(LINUX_CHECK)/guest/frames: $(LINUX_HERE)/frames.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) \
	    -Wl,--wrap=ioctl $< $(LINUX_STATIC_OBJECTS) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

$(LINUX_CHECK)/guest/damage: $(LINUX_HERE)/damage.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) $< \
	    $(LINUX_STATIC_OBJECTS) $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

$(LINUX_CHECK)/guest/faults: $(LINUX_HERE)/faults.c \
    $(LINUX_HERE)/fault_calls.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) \
	    $(LINUX_WRAP_FAULTS) $(LINUX_HERE)/faults.c \
	    $(LINUX_HERE)/fault_calls.c $(LINUX_STATIC_OBJECTS) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

linux-image:
	@$(LINUX_HERE)/vm_image.sh $(LINUX_CACHE)
	@$(LINUX_HERE)/vm_modules.sh $(LINUX_CACHE)

check-linux: all $(LINUX_TOOLS) $(LINUX_GUEST)
check-linux: linux-image ## fbdev, DRM, consoles and panels on a real kernel in QEMU
	@mkdir -p $(LINUX_CHECK)/rows
	@$(LINUX_CHECK)/layout
	@$(LINUX_CHECK)/panel_bus
	@$(LINUX_CHECK)/panel_paper
	@$(LINUX_CHECK)/console_reset
	@$(LINUX_CHECK)/input_devices
	@$(LINUX_HERE)/jobs.sh $(BUILD)/pel $(LINUX_CHECK)/jobs
	@$(LINUX_HERE)/messages.sh $(abspath $(BUILD)) \
	    $(abspath $(LINUX_CHECK))/messages
	@printf '%s\n' $(LINUX_ROWS) | xargs -P $(LINUX_JOBS) -n 1 \
	    $(LINUX_HERE)/check_row.sh $(LINUX_CHECK) $(LINUX_CACHE)
