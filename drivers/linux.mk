# The Linux drivers and the thread pool, for the programs that use them. DRM is
# in where pkg-config finds libdrm.
PKG_CONFIG ?= pkg-config
LINUX_SOURCES := $(wildcard port/linux/*.c) \
    $(filter-out drivers/display_linux_drm%, \
                 $(wildcard drivers/display_linux*.c)) \
    $(wildcard drivers/console_linux*.c) drivers/linux_message.c drivers/dirty.c
LINUX_FLAGS := -D_GNU_SOURCE
LINUX_LIBS := -pthread
ifeq ($(shell $(PKG_CONFIG) --exists libdrm 2>/dev/null && echo yes),yes)
LINUX_SOURCES += $(wildcard drivers/display_linux_drm*.c)
LINUX_FLAGS += -DPEL_WITH_DRM=1 \
    $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags libdrm))
LINUX_LIBS += $(shell $(PKG_CONFIG) --libs libdrm)
else
LINUX_FLAGS += -DPEL_WITH_DRM=0
endif
LINUX_OBJECTS := $(LINUX_SOURCES:%.c=$(BUILD)/%.o)

# -pthread belongs to the compiler too.
$(LINUX_OBJECTS): $(BUILD)/%.o: %.c $(BUILD)/linux-flags
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(LINUX_FLAGS) -pthread $(CFLAGS) -c $< -o $@

$(BUILD)/linux-flags: FORCE
	@mkdir -p $(@D)
	@echo '$(LINUX_FLAGS)' | cmp -s - $@ || echo '$(LINUX_FLAGS)' >$@

-include $(LINUX_OBJECTS:.o=.d)
