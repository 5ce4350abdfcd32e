# check-linux: a real kernel under QEMU, with real framebuffer and DRM drivers.
# The guest's kernel and first file system are made once and kept in PEL_CACHE.

CHECK_EXTRA += check-linux
LINUX_CHECK := $(BUILD)/linux
LINUX_HERE := tests/device/linux
ifdef XDG_CACHE_HOME
PEL_CACHE ?= $(XDG_CACHE_HOME)/pel
else
PEL_CACHE ?= $(HOME)/.cache/pel
endif
PEL_CACHE ?= $(BUILD)/cache
LINUX_CACHE := $(PEL_CACHE)/linux-vm
LINUX_ROWS := $(shell sed -n 's/^\([a-z0-9_]*\)|.*/\1/p' $(LINUX_HERE)/rows.txt)
LINUX_JOBS ?= $(shell nproc 2>/dev/null || echo 1)

LINUX_TOOLS := $(LINUX_CHECK)/vm $(LINUX_CHECK)/screen_check \
               $(LINUX_CHECK)/reference
LINUX_GUEST := $(addprefix $(LINUX_CHECK)/guest/, pel pel_no_restore fb_mode \
               console_state faults frames)
LINUX_STATIC := $(LINUX_CHECK)/static
LINUX_CFLAGS := -std=gnu99 $(WARNINGS) -O2 -I.
# getgrgid in a static program is what the linker warns of: the guest has files.
LINUX_STATIC_FLAGS := -static -Wl,--no-warnings
LINUX_FAULTS := open ioctl mmap read write poll fork socketpair signalfd calloc
comma := ,

# The guest's programs bring their libraries along; readers of pictures and
# meshes stay out.
.PHONY: check-linux linux-image linux-static
linux-static:
	+@$(MAKE) --no-print-directory BUILD=$(LINUX_STATIC) SIM_PACKAGES= LDFLAGS='$(LINUX_STATIC_FLAGS)' \
	    $(LINUX_STATIC)/pel

$(LINUX_TOOLS): $(LINUX_CHECK)/%: $(LINUX_HERE)/%.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $< -o $@

$(LINUX_CHECK)/guest/fb_mode $(LINUX_CHECK)/guest/console_state: \
    $(LINUX_CHECK)/guest/%: $(LINUX_HERE)/%.c
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_STATIC_FLAGS) $< -o $@

$(LINUX_CHECK)/guest/pel: linux-static
	@mkdir -p $(@D)
	@cp $(LINUX_STATIC)/pel $@

LINUX_STATIC_OBJECTS = $(LINUX_OBJECTS:$(BUILD)/%=$(LINUX_STATIC)/%)
LINUX_STATIC_SIM = $(SIM_OBJECTS:$(BUILD)/%=$(LINUX_STATIC)/%)

$(LINUX_CHECK)/guest/pel_no_restore: $(LINUX_HERE)/no_restore.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_STATIC_FLAGS) -Wl,--wrap=pel_console_state_restore $< \
	    $(LINUX_STATIC_SIM) $(LINUX_STATIC_OBJECTS) $(LINUX_STATIC)/libpel.a \
	    $(LINUX_LIBS) -lm -o $@

$(LINUX_CHECK)/guest/frames: $(LINUX_HERE)/frames.c linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) $< $(LINUX_STATIC_OBJECTS) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

$(LINUX_CHECK)/guest/faults: $(LINUX_HERE)/faults.c $(LINUX_HERE)/fault_calls.c \
    linux-static
	@mkdir -p $(@D)
	@$(CC) $(LINUX_CFLAGS) $(LINUX_FLAGS) $(LINUX_STATIC_FLAGS) \
	    $(LINUX_FAULTS:%=-Wl$(comma)--wrap=%) $(LINUX_HERE)/faults.c \
	    $(LINUX_HERE)/fault_calls.c $(LINUX_STATIC_OBJECTS) \
	    $(LINUX_STATIC)/libpel.a $(LINUX_LIBS) -o $@

linux-image:
	@$(LINUX_HERE)/vm_image.sh $(LINUX_CACHE)

check-linux: linux-image $(LINUX_TOOLS) $(LINUX_GUEST) $(BUILD)/pel ## fbdev, DRM and consoles on a real kernel in QEMU
	@mkdir -p $(LINUX_CHECK)/rows
	@printf '%s\n' $(LINUX_ROWS) | xargs -P $(LINUX_JOBS) -n 1 \
	    $(LINUX_HERE)/check_row.sh $(LINUX_CHECK) $(LINUX_CACHE)
