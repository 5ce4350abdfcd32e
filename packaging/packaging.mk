# What leaves this tree: core in one source, an installed library with its
# program and manual, and the packages of build systems.

.PHONY: amalgamation install check-packages

PEL_VERSION := $(shell awk '/^\#define PEL_VERSION_/ { printf "%s%s", dot, $$3; \
    dot = "." }' core/pel.h)
# Until 1.0.0 a minor version may change the interface.
PEL_SONAME := libpel.so.$(basename $(PEL_VERSION))

ONE := $(BUILD)/amalgamation
# The folder is a library of the Arduino IDE, too; drivers and examples find
# <pel/pel.h> in it.
amalgamation: $(ONE)/pel.c $(ONE)/pel.h ## core as pel.c and pel.h: build/amalgamation
	@mkdir -p $(ONE)/pel
	echo '#include "../pel.h"' >$(ONE)/pel/pel.h
	cp LICENSE packaging/library.properties $(ONE)
$(ONE)/pel.c: packaging/amalgamate.awk $(CORE) $(wildcard core/*/*.h core/*/*.inc)
	@mkdir -p $(@D)
	@awk -f $< $(CORE) >$@
$(ONE)/pel.h: packaging/amalgamate.awk $(wildcard core/*.h core/*/*.h)
	@mkdir -p $(@D)
	@awk -f $< -v header=1 >$@

$(BUILD)/libpel.so.$(PEL_VERSION): $(ONE)/pel.c $(ONE)/pel.h
	$(CC) $(PEL_CFLAGS) $(CFLAGS) -fPIC -shared $(LDFLAGS) \
	    -Wl,-soname,$(PEL_SONAME) $< -o $@

$(BUILD)/man/pel.1: packaging/man.sh $(BUILD)/pel
	@mkdir -p $(@D)
	packaging/man.sh $(BUILD)/pel $(PEL_VERSION) >$@
$(BUILD)/man/pel.3: packaging/pel.3 core/pel.h
	@mkdir -p $(@D)
	sed 's/@VERSION@/$(PEL_VERSION)/' $< >$@

PREFIX ?= /usr/local
to = $(DESTDIR)$(PREFIX)
define PEL_PC
prefix=$(PREFIX)
Name: pel
Description: Exact triangles and circles in any framebuffer
Version: $(PEL_VERSION)
Cflags: -I$${prefix}/include
Libs: -L$${prefix}/lib -lpel
endef

install: $(BUILD)/libpel.a $(BUILD)/libpel.so.$(PEL_VERSION) $(BUILD)/pel \
    $(BUILD)/man/pel.1 $(BUILD)/man/pel.3 ## library, headers, pel.pc, program, manual: PREFIX, DESTDIR
	install -d $(to)/bin $(to)/lib/pkgconfig $(to)/share/man/man1 $(to)/share/man/man3
	set -e; for f in $$(cd core && ls *.h */*.h); do \
	    install -D -m 644 core/$$f $(to)/include/pel/$$f; done
	install -m 644 $(BUILD)/libpel.a $(to)/lib
	install $(BUILD)/libpel.so.$(PEL_VERSION) $(to)/lib
	ln -sf libpel.so.$(PEL_VERSION) $(to)/lib/$(PEL_SONAME)
	ln -sf $(PEL_SONAME) $(to)/lib/libpel.so
	$(file >$(BUILD)/pel.pc,$(PEL_PC))
	install -m 644 $(BUILD)/pel.pc $(to)/lib/pkgconfig
	install $(BUILD)/pel $(to)/bin
	install -m 644 $(BUILD)/man/pel.1 $(to)/share/man/man1
	install -m 644 $(BUILD)/man/pel.3 $(to)/share/man/man3

CHECK_EXTRA += check-packages
PACKAGE_ROOT := $(abspath $(BUILD)/package)
check-packages: amalgamation ## projects of their own, one for every way to use Pel
	@tests/tools/need.sh cmake:cmake groff:groff-base pkg-config:pkg-config
	@rm -rf $(PACKAGE_ROOT)
	@$(MAKE) --no-print-directory -s install DESTDIR=$(PACKAGE_ROOT) PREFIX=/opt/pel
	PEL=$(BUILD)/pel tests/package/check.sh $(BUILD) $(PACKAGE_ROOT) $(PEL_VERSION)
