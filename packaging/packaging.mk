# What leaves this tree: core in one source, an installed library with its
# program and manual, and the packages of build systems.

.PHONY: amalgamation arduino install check-packages

PEL_VERSION := $(shell awk '/^\#define PEL_VERSION_/ { printf "%s%s", dot, $$3; \
    dot = "." }' core/pel.h)
# Until 1.0.0 a minor version may change the interface.
PEL_SONAME := libpel.so.$(basename $(PEL_VERSION))

ONE := $(BUILD)/amalgamation
# Drivers and examples find <pel/pel.h> in the folder, too.
amalgamation: $(ONE)/pel.c $(ONE)/pel.h ## core as pel.c and pel.h: build/amalgamation
	@mkdir -p $(ONE)/pel
	echo '#include "../pel.h"' >$(ONE)/pel/pel.h
	cp LICENSE $(ONE)
$(ONE)/pel.c: packaging/amalgamate.awk $(CORE) $(wildcard core/*/*.h core/*/*.inc)
	@mkdir -p $(@D)
	@awk -f $< $(CORE) >$@
$(ONE)/pel.h: packaging/amalgamate.awk $(wildcard core/*.h core/*/*.h)
	@mkdir -p $(@D)
	@awk -f $< -v header=1 >$@

# Who publishes the library knows its address: URL.
ARDUINO := $(BUILD)/arduino/Pel
arduino: amalgamation ## a library of the Arduino IDE with drivers and examples: build/arduino/Pel
	rm -rf $(ARDUINO)
	mkdir -p $(ARDUINO)/src/drivers $(ARDUINO)/examples
	cp -R $(ONE)/pel.c $(ONE)/pel.h $(ONE)/pel $(ARDUINO)/src
	cp $(DRIVERS) $(call without_linux,$(wildcard drivers/*.h)) \
	    $(ARDUINO)/src/drivers
	cp -R examples/board examples/panel $(ARDUINO)/examples
	cp LICENSE $(ARDUINO)
	sed 's/@VERSION@/$(PEL_VERSION)/' packaging/library.properties \
	    >$(ARDUINO)/library.properties
	$(if $(URL),echo 'url=$(URL)' >>$(ARDUINO)/library.properties)

$(BUILD)/libpel.so.$(PEL_VERSION): $(ONE)/pel.c $(ONE)/pel.h
	$(CC) $(PEL_CFLAGS) $(CFLAGS) -fPIC -shared $(LDFLAGS) \
	    -Wl,-soname,$(PEL_SONAME) $< -o $@

$(BUILD)/man/pel.1: packaging/man.sh $(BUILD)/pel
	@mkdir -p $(@D)
	packaging/man.sh $(BUILD)/pel $(PEL_VERSION) >$@
$(BUILD)/man/pel.3: packaging/pel.3 core/pel.h
	@mkdir -p $(@D)
	sed 's/@VERSION@/$(PEL_VERSION)/' $< >$@

install: export PREFIX ?= /usr/local
install: $(BUILD)/libpel.a $(BUILD)/libpel_linux.a $(SDL_LIBRARY) $(BUILD)/libpel.so.$(PEL_VERSION) $(BUILD)/pel \
    $(BUILD)/man/pel.1 $(BUILD)/man/pel.3 ## libraries, headers, pel.pc, pel-linux.pc, pel-sdl.pc, program, manual: PREFIX, DESTDIR
	packaging/install.sh $(BUILD) $(PEL_VERSION)

CHECK_EXTRA += check-packages
check-packages: all arduino ## projects of their own, one for every way to use Pel
	@tests/tools/need.sh cmake:cmake groff:groff-base pkg-config:pkg-config \
	    i686-linux-gnu-gcc:gcc-i686-linux-gnu
	PEL=$(BUILD)/pel tests/package/check.sh $(BUILD) $(PEL_VERSION)
