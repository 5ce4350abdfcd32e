# Pel. `make help` lists the targets.

.DEFAULT_GOAL := all

.PHONY: setup
setup: ## install the Debian packages of packages.txt (sudo when not root)
	tests/tools/setup.sh

# What is installed is looked for when the Makefile is read: goals beside setup
# get a make of their own, after it.
OTHER_GOALS := $(filter-out setup,$(MAKECMDGOALS))
ifneq ($(and $(filter setup,$(MAKECMDGOALS)),$(OTHER_GOALS)),)
.PHONY: $(OTHER_GOALS)
$(OTHER_GOALS): setup
	$(MAKE) --no-print-directory $@
else

CC ?= cc
BUILD := build
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow \
            -Wundef
CFLAGS ?= -O2 -g
# WERROR is -Werror in our own checks alone: a compiler of tomorrow warns of more.
PEL_CFLAGS = -std=c99 $(WARNINGS) $(WERROR) -I. -MMD -MP

CORE := $(sort $(wildcard core/*/*.c))
CORE_OBJECTS := $(CORE:%.c=$(BUILD)/%.o)

.PHONY: all help clean
all: $(BUILD)/libpel.a ## build/libpel.a and the host program build/pel

-include sim/sim.mk
-include bench/bench.mk
-include tests/tests.mk

$(BUILD)/libpel.a: $(CORE_OBJECTS)
	rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/core/%.o: core/%.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(CFLAGS) -c $< -o $@

EXAMPLES := $(sort $(wildcard examples/*.c))
EXAMPLE_PROGRAMS := $(EXAMPLES:%.c=$(BUILD)/%)

$(BUILD)/examples/%: examples/%.c $(BUILD)/libpel.a
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -I$(@D) $(CFLAGS) $(filter %.c %.a,$^) -o $@

$(BUILD)/examples/letters.c: sim/scenes/letters.bdf $(BUILD)/pel
	@mkdir -p $(@D)
	$(BUILD)/pel import $< -o $@
$(BUILD)/examples/paints: $(BUILD)/examples/letters.c

CHECK_EXTRA += examples
.PHONY: examples
examples: $(EXAMPLE_PROGRAMS) ## build and run the examples
	$(BUILD)/examples/bands
	@set -e; for e in $(filter-out %/bands,$(EXAMPLE_PROGRAMS)); do \
	    $$e >$$e.ppm; echo "$$e.ppm"; done

clean: ## remove build/
	rm -rf $(BUILD)

help: ## this list
	@grep -hE '^[a-z-]+:.*##' $(filter-out %.d,$(MAKEFILE_LIST)) | sort | \
	    sed -E 's/^([a-z-]+):.*## /\1\t/' | awk -F '\t' '{printf "%-20s %s\n", $$1, $$2}'

-include $(CORE_OBJECTS:.o=.d)

endif
