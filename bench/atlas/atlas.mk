# pel-atlas: figures of every method against an exact reference.

ATLAS := $(BENCH)/pel-atlas
ATLAS_SOURCES := $(wildcard bench/atlas/*.c bench/methods/*.c) bench/timing.c \
    tests/support/reference.c tests/support/exact_area.c
ATLAS_FAST := $(wildcard bench/methods/*.c) bench/atlas/sheet.c
ATLAS_OBJECTS := $(ATLAS_SOURCES:%.c=$(BENCH)/host/%.o) \
    $(BENCH)/scene/methods.o $(BUILD)/libpel.a

# Filled runs as fast as Pel's: a compiler may vectorise them, and the counts of
# a sheet.
$(ATLAS_FAST:%.c=$(BENCH)/host/%.o): $(BENCH)/host/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -O3 -c $< -o $@

$(ATLAS): $(ATLAS_OBJECTS)
	$(CC) $(LDFLAGS) $^ -lm -o $@

-include $(ATLAS_SOURCES:%.c=$(BENCH)/host/%.d)

CHECK_EXTRA += check-methods
tests: $(ATLAS)
.PHONY: check-methods
check-methods: $(ATLAS) $(BUILD)/pel ## check Pel's promises in the atlas
	tests/tools/methods.sh $(ATLAS) $(BUILD)/pel

# The same methods on a Cortex-M0+ and an M4.
ATLAS_BOARDS := m0plus m4
ATLAS_MCU := bench/atlas/mcu/main.c bench/mcu/report.c \
    $(wildcard bench/methods/fill_*.c)
define atlas_mcu
$(BENCH)/atlas/$1.elf: $(ATLAS_MCU:%.c=$(BUILD)/cpus/gcc-$1-O2/%.o) \
    $(CORE:%.c=$(BUILD)/cpus/gcc-$1-O2/%.o)
	@mkdir -p $$(@D)
	@$(CPU_PREFIX_$1)-gcc $(CPU_FLAGS_$1) $$^ $(CPU_LINK_$1) -o $$@
endef
$(foreach b,$(ATLAS_BOARDS),$(eval $(call atlas_mcu,$b)))

.PHONY: damage-mcu
damage-mcu: $(BENCH)/atlas/damage-mcu.csv ## instructions of all ways to fill a triangle, M0+ and M4
$(BENCH)/atlas/damage-mcu.csv: $(ATLAS_BOARDS:%=$(BENCH)/atlas/%.elf)
	printf '%s\n' $(foreach b,$(ATLAS_BOARDS),\
	    '$(MCU_BENCH_$b) $(BENCH)/atlas/$b.elf $(CPU_RUN_$b)') | \
	    bench/mcu/run.sh >$(@:csv=tsv)
	bench/atlas/damage_mcu.sh $(@:csv=tsv) >$@
