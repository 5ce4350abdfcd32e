# Fuzz targets: tests/fuzz/fuzz_NAME.c, with NAME_*.c beside it, and the host
# program's sources when it includes their headers. `make fuzz` runs each with
# libFuzzer; `make check` replays tests/fuzz/corpus/NAME with gcc's sanitizers.

FUZZ_SECONDS ?= 60
FUZZ_RUNS ?= -1
F := $(BUILD)/fuzz
FUZZ_NAMES := $(patsubst tests/fuzz/fuzz_%.c,%,$(sort $(wildcard tests/fuzz/fuzz_*.c)))
FUZZ_SIM := $(patsubst tests/fuzz/fuzz_%.c,%,$(shell \
    grep -l '^#include "sim/' tests/fuzz/fuzz_*.c))

FUZZ_SUPPORT_api := tests/support/any_kinds.c

# clang  with libFuzzer      gcc  with replay.c, and core as test build `san`
FUZZ_CC_clang := clang
FUZZ_CC_gcc := $(CC)
FUZZ_FLAGS_clang := -O1 -g -fno-sanitize-recover=all \
    -fsanitize=fuzzer-no-link,address,undefined
FUZZ_FLAGS_gcc := $(TEST_SANITIZE)
FUZZ_LINK_clang := -fsanitize=fuzzer,address,undefined
FUZZ_LINK_gcc := $(TEST_SANITIZE)

# $1 compiler
define fuzz_build
$(F)/$1/%.o: %.c
	@mkdir -p $$(@D)
	$$(FUZZ_CC_$1) $$(PEL_CFLAGS) -D_POSIX_C_SOURCE=200809L $$(if $$(filter-out core/% tests/%,$$<),\
	    $$(SIM_FLAGS) $$(LINUX_FLAGS)) $$(FUZZ_FLAGS_$1) -c $$< -o $$@
$(F)/$1/libsim.a: $(patsubst $(BUILD)/%,$(F)/$1/%,$(TEST_SIM_OBJECTS))
	rm -f $$@
	$$(AR) rcs $$@ $$^
-include $$(wildcard $(F)/$1/*/*.d $(F)/$1/*/*/*.d)
endef

FUZZ_CORE_clang := $(F)/clang/libpel.a
FUZZ_CORE_gcc := $(T)/san/libpel.a
$(F)/clang/libpel.a: $(CORE:%.c=$(F)/clang/%.o)
	rm -f $@
	$(AR) rcs $@ $^

# $1 compiler, $2 name
define fuzz_program
$(F)/$1/$2: $(patsubst %.c,$(F)/$1/%.o,tests/fuzz/fuzz_$2.c \
    $(wildcard tests/fuzz/$2_*.c) $(FUZZ_SUPPORT_$2) $(if $(filter gcc,$1),tests/fuzz/replay.c)) \
    $(if $(filter $2,$(FUZZ_SIM)),$(F)/$1/libsim.a) $(FUZZ_CORE_$1)
	$$(FUZZ_CC_$1) $$(FUZZ_LINK_$1) $$^ \
	    $(if $(filter $2,$(FUZZ_SIM)),$(SIM_LIBS) $(LINUX_LIBS)) -o $$@
endef
$(foreach c,clang gcc,$(eval $(call fuzz_build,$c)) \
    $(foreach n,$(FUZZ_NAMES),$(eval $(call fuzz_program,$c,$n))))

# What a run finds new stays in build/fuzz/corpus, and what breaks it in
# build/fuzz.
.PHONY: fuzz fuzz-replay
fuzz: $(FUZZ_NAMES:%=$(F)/clang/%) | need-clang ## every fuzz target for FUZZ_SECONDS (60)
	@set -e; for n in $(FUZZ_NAMES); do \
	    mkdir -p $(F)/corpus/$$n; echo "fuzz $$n"; \
	    $(F)/clang/$$n -max_total_time=$(FUZZ_SECONDS) -runs=$(FUZZ_RUNS) \
	        -timeout=10 -max_len=2000 -len_control=0 -artifact_prefix=$(F)/$$n- -print_final_stats=1 \
	        $(F)/corpus/$$n tests/fuzz/corpus/$$n 2>$(F)/$$n.log || \
	        { tail -40 $(F)/$$n.log; exit 1; }; \
	    grep -E '^(stat::number_of_executed|[0-9]+ calls)' $(F)/$$n.log; done

CHECK_EXTRA += fuzz-replay
fuzz-replay: $(FUZZ_NAMES:%=$(F)/gcc/%)
	@set -e; for n in $(FUZZ_NAMES); do $(F)/gcc/$$n tests/fuzz/corpus/$$n/*; done
