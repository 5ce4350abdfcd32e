# `make mutants`: does a test notice when core is changed a little? See
# mutants.sh; what is changed, and by which tests it is looked at, is in
# mutants_tests.txt.

.PHONY: mutants

# Without debug information, so that equal code makes equal objects. All builds
# stop at undefined behaviour, and all but the portable one at memory that is
# not their own: such a change is noticed, whatever comes of it. Gcc is told
# that the last array of a struct has its length, too.
MUTANT_BOUNDS := $(shell echo | $(CC) -fsanitize=bounds-strict -E - >/dev/null \
    2>&1 && echo -fsanitize=bounds-strict)
TEST_FLAGS_mutant_host := $(filter-out -g,$(TEST_SANITIZE))
TEST_FLAGS_mutant_portable := -O1 -fsanitize=undefined \
    -fno-sanitize-recover=all -DPEL_64BIT=0 -DPEL_VECTORS=0 \
    -DPEL_SMALL_CODE=1 -DPEL_LONG_MULTIPLY=0
TEST_FLAGS_mutant_stack := $(filter-out -g,$(TEST_FLAGS_short)) \
    $(MUTANT_BOUNDS)
MUTANT_BUILDS := mutant_host mutant_portable mutant_stack
MUTANT_TESTS := $(sort $(shell sed -n 's/#.*//; s/^core[^:]*: *//; s/+//g; \
    s/:[0-9]*//g; p' tests/tools/mutants_tests.txt))
MUTANT_HOST_ONLY := $(filter $(TEST_HOST_ONLY),$(MUTANT_TESTS:%=tests/%))
# Those of the files with code for a short stack alone.
MUTANT_STACK_TESTS := test_smooth_arc test_smooth_strip test_smooth_round \
    test_smooth_coverage

$(foreach b,$(MUTANT_BUILDS),$(eval $(call test_build,$b)))

MUTANT_PROGRAMS := $(MUTANT_TESTS:%=$(T)/mutant_host/tests/%) \
    $(filter-out $(MUTANT_HOST_ONLY:%=$(T)/mutant_portable/%),\
        $(MUTANT_TESTS:%=$(T)/mutant_portable/tests/%)) \
    $(MUTANT_STACK_TESTS:%=$(T)/mutant_stack/tests/property/%)

# MUTANTS: names of core's files, all that are listed unless told.
mutants: $(MUTANT_PROGRAMS) ## change core a little, a thousand times: do the tests notice?
	$(foreach b,$(MUTANT_BUILDS),$(file >$(T)/$b/flags,$(TEST_FLAGS_$b)))
	tests/tools/mutants.sh $(T) "$(CC)" $(MUTANTS)
