# How a test comes to run. Its file is enough: C files named tests/unit/test_*.c,
# tests/property/, tests/exhaustive/ and tests/sim/ are found by `wildcard`, and so
# are the scripts tests/sim/test_*.sh. Each C file is one cmocka program, linked
# with tests/support and the drivers. For each of TEST_BUILDS, a set of flags,
# TEST_PROGRAMS_build says which of them are built with these. A fragment of make
# with tests of another kind adds a target to CHECK_EXTRA.
#
# `make check` builds all that (target `tests`), writes CHECK_LINES into a file, a
# line for each test, its name and its command, and tests/support/run.sh runs them
# side by side. `make deep` runs the same programs for longer.

-include tests/tools/tools.mk
-include tests/device/linux/linux.mk
-include tests/device/lcd/lcd.mk
-include tests/device/pico/pico.mk

T := $(BUILD)/tests
TAB := $(shell printf '\t')

TEST_SANITIZE := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all

# host      as the user builds it
# portable  without the walk and the vectors of 64-bit CPUs
# short     the same with -Os and the short stack of 32-bit CPUs, and sanitizers
# san       address and undefined-behaviour sanitizers, and batches of few rows
# assert    the sanitizers, and PEL_ASSERT counts
# small     the portable walk as for the least code, and the least buffers
# large     the portable walk with long products, and the largest buffers
TEST_FLAGS_host := -O2 -g
TEST_FLAGS_portable := -O2 -g -DPEL_64BIT=0 -DPEL_VECTORS=0
TEST_FLAGS_short := $(TEST_SANITIZE) -Os -DPEL_64BIT=0 -DPEL_VECTORS=0
TEST_FLAGS_san := $(TEST_SANITIZE) -DPEL_BATCH_ROWS=5
TEST_FLAGS_assert := $(TEST_SANITIZE) \
    -DPEL_CONFIG_FILE='"tests/support/assert_config.h"'
TEST_FLAGS_small := -O2 -DPEL_64BIT=0 -DPEL_LONG_MULTIPLY=0 \
    -DPEL_SMALL_CODE=1 -DPEL_BATCH_ROWS=4 -DPEL_BUFFER_PIXELS=4
TEST_FLAGS_large := -O2 -DPEL_64BIT=0 -DPEL_LONG_MULTIPLY=1 \
    -DPEL_BATCH_ROWS=255 -DPEL_BUFFER_PIXELS=255
TEST_BUILDS := host portable short san assert small large

TEST_SUPPORT := $(sort $(wildcard tests/support/*.c)) $(DRIVERS)
TEST_UNIT := $(basename $(sort $(wildcard tests/unit/test_*.c)))
TEST_PROPERTY := $(basename $(sort $(wildcard tests/property/test_*.c)))
TEST_EXHAUSTIVE := $(basename $(sort $(wildcard tests/exhaustive/test_*.c)))

# Broken contracts are tested where asserts count, and where there are none.
TEST_ASSERT := tests/unit/test_all_assert
# These name what only the default build has.
TEST_HOST_ONLY := tests/property/test_fast_depth \
    tests/property/test_fast_triangle tests/property/test_fast_flat
# These see what the knobs of core change inside.
TEST_KNOBS := tests/property/test_raster_triangles \
    tests/property/test_all_pictures tests/property/test_scene_numbers \
    tests/property/test_fast_textures \
    tests/property/test_scene_pictures tests/property/test_paint_gradients \
    tests/property/test_round_coverage tests/property/test_smooth_coverage \
    tests/property/test_smooth_round tests/property/test_image_smooth_glyph \
    tests/unit/test_base_product

# $1 build
define test_build
$(T)/$1/%.o: %.c
	@mkdir -p $$(@D)
	$$(CC) $$(PEL_CFLAGS) $$(TEST_FLAGS_$1) -c $$< -o $$@
$(T)/$1/libpel.a: $(CORE:%.c=$(T)/$1/%.o)
	rm -f $$@
	$$(AR) rcs $$@ $$^
$(T)/$1/libsupport.a: $(TEST_SUPPORT:%.c=$(T)/$1/%.o)
	rm -f $$@
	$$(AR) rcs $$@ $$^
$(T)/$1/tests/%: $(T)/$1/tests/%.o $(T)/$1/libsupport.a $(T)/$1/libpel.a
	$$(CC) $$(TEST_FLAGS_$1) $$^ -lcmocka -lm -o $$@
-include $$(wildcard $(T)/$1/*/*.d $(T)/$1/*/*/*.d)
endef
$(foreach b,$(TEST_BUILDS),$(eval $(call test_build,$b)))
include tests/tools/mutants.mk
.SECONDARY:

# Tests of the host program: its sources but for main.
TEST_SIM := $(basename $(sort $(wildcard tests/sim/test_*.c)))
TEST_SCRIPTS := $(sort $(wildcard tests/sim/test_*.sh))
TEST_SIM_OBJECTS := $(filter-out $(BUILD)/sim/main.o,$(SIM_OBJECTS)) $(LINUX_OBJECTS)
$(T)/sim/%.o: tests/sim/%.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(SIM_FLAGS) $(CFLAGS) -c $< -o $@
-include $(wildcard $(T)/sim/*.d)
$(T)/sim/%: $(T)/sim/%.o $(TEST_SIM_OBJECTS) $(T)/host/libsupport.a $(BUILD)/libpel.a
	$(CC) $(CFLAGS) $(LDFLAGS) $^ -lcmocka $(SIM_LIBS) $(LINUX_LIBS) -o $@

include tests/fuzz/fuzz.mk

TEST_PROGRAMS_host := $(TEST_EXHAUSTIVE) $(TEST_PROPERTY) $(TEST_UNIT)
TEST_PROGRAMS_portable := $(filter-out $(TEST_HOST_ONLY),$(TEST_PROPERTY)) \
    tests/exhaustive/test_base_colors
TEST_PROGRAMS_short := $(TEST_KNOBS) tests/property/test_paint_dither \
    tests/property/test_paint_blend tests/property/test_smooth_layer
TEST_PROGRAMS_san := $(TEST_PROPERTY) $(TEST_UNIT)
TEST_PROGRAMS_assert := $(TEST_ASSERT)
TEST_PROGRAMS_small := $(TEST_KNOBS)
TEST_PROGRAMS_large := $(TEST_KNOBS)
TEST_PROGRAMS := $(foreach b,$(TEST_BUILDS),$(TEST_PROGRAMS_$b:%=$(T)/$b/%)) \
    $(TEST_SIM:tests/sim/%=$(T)/sim/%)
TEST_SCENES := $(patsubst %,$(T)/%/tests/golden/scenes,host portable san small large)

# Percentage of the cases that each build runs.
CHECK_SCALE_host := 100
CHECK_SCALE_portable := 20
CHECK_SCALE_short := 3
CHECK_SCALE_san := 3
CHECK_SCALE_assert := 100
CHECK_SCALE_small := 5
CHECK_SCALE_large := 5

# A line of the list of tests/support/run.sh: name, command. Targets of
# CHECK_EXTRA share objects of one folder, so one make at a time runs them, and
# has all CPUs.
TEST_MAKE = $(MAKE) -j$(LINUX_JOBS) --no-print-directory WERROR=-Werror BUILD=$(BUILD)
define NEWLINE


endef
test_line = $1$(TAB)$2$(NEWLINE)
test_lines_of = $(foreach p,$(TEST_PROGRAMS_$1),$(call \
    test_line,$(p:tests/%=%) ($1),PEL_SCALE=$(CHECK_SCALE_$1) $(T)/$1/$p))
test_scripts = $(foreach s,$(TEST_SCRIPTS),$(call \
    test_line,$(s:tests/%=%),PEL=$(BUILD)/pel sh $s))
CHECK_LINES = $(foreach b,$(TEST_BUILDS),$(call test_lines_of,$b)) \
    $(foreach s,$(TEST_SCENES),$(call test_line,$(s:$(T)/%=%),$s | diff \
        tests/golden/scenes.txt -)) \
    $(foreach p,$(TEST_SIM),$(call test_line,$(p:tests/%=%),$(p:tests/%=$(T)/%))) \
    $(test_scripts) \
    $(foreach t,$(CHECK_EXTRA),$(call \
        test_line,make $t,$(TEST_MAKE) $t))

.PHONY: check deep goldens tests
tests deep: WERROR := -Werror
tests: all $(TEST_PROGRAMS) $(TEST_SCENES)

.PHONY: check-build
check-build:
	+@tests/support/build.sh $(MAKE) --no-print-directory tests
check: check-build ## every test; the last line is `N passed, N failed`
	@mkdir -p $(T)/check
	$(file >$(T)/check.list,$(CHECK_LINES))
	@sed 's/^ *//' $(T)/check.list | tests/support/run.sh $(T)/check

# 10^8 triangles through either walk, 10^6 smooth round shapes, ten times the
# cases of all others, and the golden scenes on every CPU by every compiler at
# every level. The seed is another one each time; it is printed, and PEL_SEED=N
# repeats a run.
DEEP_SCALE ?= 1000
DEEP_PARTS := 0 1 2 3 4
DEEP_EXTRA := deep-builds deep-cpus deep-order deep-world
DEEP_PROGRAMS := $(TEST_PROPERTY:%=$(T)/host/%) \
    $(T)/portable/tests/property/test_raster_triangles
deep: $(DEEP_PROGRAMS) ## the long sweeps: 10^8 triangles, all CPUs; half an hour
	@mkdir -p $(T)/deep
	@seed=$${PEL_SEED:-$$(date +%s)}; echo "PEL_SEED=$$seed"; \
	printf '%s\t%s\n' "make $(DEEP_EXTRA)" \
	    "$(TEST_MAKE) -k -Otarget $(DEEP_EXTRA)" >$(T)/deep.list; \
	for b in host portable; do for i in $(DEEP_PARTS); do \
	    printf '%s\t%s\n' "test_raster_triangles $$b $$i" "PEL_SEED=$$seed$$i \
	        PEL_SCALE=1000 $(T)/$$b/tests/property/test_raster_triangles"; \
	done; done >>$(T)/deep.list; \
	for p in $(filter-out %/test_raster_triangles,$(TEST_PROPERTY)); do \
	    case $$p in *smooth_round) scale=2500 ;; *) scale=$(DEEP_SCALE) ;; esac; \
	    printf '%s\t%s\n' "$$p" "PEL_SCALE=$$scale $(T)/host/$$p"; \
	done >>$(T)/deep.list; \
	PEL_SEED=$$seed PEL_TIMEOUT=36000 tests/support/run.sh $(T)/deep \
	    <$(T)/deep.list

# A failing case says what it is made of, and is shown again by one command.
.PHONY: check-replay
CHECK_EXTRA += check-replay
check-replay: $(TEST_PROPERTY:%=$(T)/host/%)
	@tests/tools/replay.sh $^

.PHONY: deep-world
deep-world: $(T)/sim/test_render_world # coarse meshes in the world, all of them
	PEL_WORLD_ALL=1 $<

.PHONY: deep-order
deep-order: all # every mesh of PEL_MODELS, with the painter's order proven or not
	PEL=$(BUILD)/pel PEL_ORDER_ALL=1 sh tests/sim/test_render_order.sh

# What the property tests measure against exact references, random and
# adversarial input: NAME.csv with columns error (upper end of its bin; the unit
# ends the name, or it is a step of a channel) and count.
ERROR_TESTS := $(basename $(shell grep -lw histogram_end tests/property/*.c))
.PHONY: errors
errors: $(ERROR_TESTS:%=$(T)/host/%) ## error histograms of every paint: CSV in build/bench/errors
	@rm -rf $(BUILD)/bench/errors && mkdir -p $(BUILD)/bench/errors
	@set -e; for t in $(ERROR_TESTS); do \
	    PEL_CSV_DIR=$(BUILD)/bench/errors $(T)/host/$$t >$(T)/errors.txt 2>&1 || \
	        { cat $(T)/errors.txt; exit 1; }; \
	    sed -n 's/^\([a-z_0-9]*: [0-9]* values\)/\1/p' $(T)/errors.txt; done

# The pictures' checksums are facts: change them only with a reason, and look at
# the difference that this prints.
goldens: $(T)/host/tests/golden/scenes ## write tests/golden/scenes.txt anew, and show what changed
	$< >$(T)/scenes.txt
	-diff tests/golden/scenes.txt $(T)/scenes.txt
	cp $(T)/scenes.txt tests/golden/scenes.txt
