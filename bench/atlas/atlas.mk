# pel-atlas: figures of every method against an exact reference.

ATLAS := $(BENCH)/pel-atlas
ATLAS_SOURCES := $(wildcard bench/atlas/*.c bench/methods/*.c) bench/timing.c \
    tests/support/reference.c
ATLAS_OBJECTS := $(ATLAS_SOURCES:%.c=$(BENCH)/host/%.o) \
    $(BENCH)/scene/methods.o $(BUILD)/libpel.a

# Filled runs as fast as Pel's: a compiler may vectorise them.
$(BENCH)/host/bench/methods/%.o: bench/methods/%.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -O3 -c $< -o $@

$(ATLAS): $(ATLAS_OBJECTS)
	$(CC) $(LDFLAGS) $^ -lm -o $@

-include $(ATLAS_SOURCES:%.c=$(BENCH)/host/%.d)

CHECK_EXTRA += check-methods
tests: $(ATLAS)
.PHONY: check-methods
check-methods: $(ATLAS) $(BUILD)/pel ## check the atlas's references and Pel's promises
	tests/tools/methods.sh $(ATLAS) $(BUILD)/pel
