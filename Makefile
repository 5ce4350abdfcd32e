# Pel. `make help` lists the targets.

CC ?= cc
BUILD := build
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow \
            -Wundef -Werror
CFLAGS ?= -O2 -g
PEL_CFLAGS := -std=c99 $(WARNINGS) -I. -MMD -MP

CORE := $(sort $(wildcard core/*/*.c))
CORE_OBJECTS := $(CORE:%.c=$(BUILD)/%.o)

.PHONY: all help setup clean
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

setup: ## install the Debian packages of packages.txt (sudo when not root)
	tests/tools/setup.sh

clean: ## remove build/
	rm -rf $(BUILD)

help: ## this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sort | \
	    sed -E 's/^([a-z-]+):.*## /\1\t/' | awk -F '\t' '{printf "%-12s %s\n", $$1, $$2}'

-include $(CORE_OBJECTS:.o=.d)
