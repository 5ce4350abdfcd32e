# Checks of the sources and the objects, and builds for other CPUs: each a target
# of its own, and each one test of `make check`.

CHECK_EXTRA += layers metrics size bench-mcu check-cpus check-mcu check-builds check-examples \
    products check-make check-index check-pictures reference

.PHONY: layers metrics check-make need-clang need-format

# The objects that are looked at have none of the host's own habits: position-
# independent code would move tables of pointers to writable memory.
LAYERS_HOST := $(CORE:%.c=$(BUILD)/layers/host/%.o)
$(BUILD)/layers/host/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -O2 -fno-pie -c $< -o $@
-include $(LAYERS_HOST:.o=.d)

need-clang:
	@tests/tools/need.sh clang:clang clang++:clang g++:g++
need-format:
	@tests/tools/need.sh clang-format:clang-format

include tests/link/link.mk
include tests/tools/cpus.mk

LAYERS_BUILDS := cortex-m0plus-small cortex-m4-Os
layers_objects = $(CORE:%.c=$(BUILD)/mcu/$1/%.o)

# C++ sees core through pel.h, with either compiler.
layers: $(LAYERS_HOST) $(foreach b,$(LAYERS_BUILDS),$(call \
    layers_objects,$b)) $(BUILD)/libpel.a | need-clang ## check what core includes, needs and leaves in RAM
	tests/tools/layers_includes.sh
	tests/tools/layers_source.sh
	@tests/tools/layers_objects.sh size nm $(LAYERS_HOST)
	@$(foreach b,$(LAYERS_BUILDS),tests/tools/layers_objects.sh \
	    arm-none-eabi-size arm-none-eabi-nm $(call layers_objects,$b) &&) :
	tests/tools/layers_headers.sh "$(CC)" $(WARNINGS) -Werror \
	    -Iinclude
	@mkdir -p $(BUILD)/link
	for c in g++ clang++; do \
	    $$c -std=c++11 $(WARNINGS) -Werror -Wold-style-cast -I. tests/link/from_cpp.cpp \
	        $(BUILD)/libpel.a -o $(BUILD)/link/from_cpp && \
	    $(BUILD)/link/from_cpp || exit 1; done
	@echo "layers: all of core and its headers are in order"

metrics: | need-format ## lengths of functions and files, parameters, layout
	tests/tools/metrics.sh

check-make: ## goals of make together and alone, and a tree in a folder of any name
	tests/tools/check_make.sh

# What the public headers say, in one list and as HTML.
.PHONY: index check-index reference
index: ## write docs/index.md anew from the headers
	tests/tools/index.sh $(BUILD) "$(CC)" accept
check-index: ## does docs/index.md say what the headers do?
	tests/tools/index.sh $(BUILD) "$(CC)"
reference: ## the headers as HTML, by doxygen: build/reference
	tests/tools/reference.sh $(BUILD) "$(CC)" $(PEL_VERSION)
	@echo "the reference: $(BUILD)/reference/index.html"

# The pictures of docs, of programs and of the C blocks of the pages.
PICTURE_PROGRAMS = $(patsubst %,$(BUILD)/examples/%,$(PRODUCTS) kiosk mesh)
.PHONY: pictures check-pictures
pictures check-pictures: $(BUILD)/pel $(BUILD)/libpel.a $(PICTURE_PROGRAMS)
pictures: ## write docs/pictures anew, those that differ
	tests/tools/pictures.sh $(BUILD) "$(CC)" accept
check-pictures: ## compile the pages' C, compare every picture of docs
	tests/tools/pictures.sh $(BUILD) "$(CC)"

# The rest of the pages' C.
CHECK_EXTRA += $(SDL_FOUND:%=check-blocks)
.PHONY: check-blocks
check-blocks: $(BUILD)/libpel.a $(BUILD)/libpel_linux.a $(SDL_LIBRARY) ## compile and run the pages' C that draws no picture
	tests/tools/doc_blocks.sh $(BUILD) "$(CC)" $(BUILD)/libpel_linux.a $(SDL_LIBRARY) \
	    $(BUILD)/libpel.a $$(cat $(BUILD)/libpel_linux.libs) $(SDL_LIBS)

# Tests run side by side, each in a make of its own, so that what several of them
# need is built before.
tests: $(LAYERS_HOST) $(MCU_CORE_OBJECTS) $(LINK_ELFS) $(MCU_BENCH_ELFS) \
    $(patsubst %,$(BUILD)/cpus/%/scenes,$(CPU_CHECK) $(MCU_CHECK) $(BUILDS_CHECK)) \
    $(BUILDS_CHECK:%=$(BUILD)/cpus/%/flat) \
    $(LCD_BOARDS:%=$(LCD)/%.elf) $(BOARD_RUNS:%=$(BUILD)/board/%) \
    $(PRODUCT_RUNS:%=$(BUILD)/board/%) $(PRODUCT_ELFS)
