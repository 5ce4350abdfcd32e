# `make atlas`: the figures of speed, accuracy and size as CSV, and a page of
# charts. It goes on where it was stopped; SHARD=2/8 runs the second of eight
# parts, whose CSVs are then copied together, and `make atlas` there draws all.
# `make atlas-page` draws the page again from the figures that are there; with
# ACCEPT=1 it writes the places among peers into docs/ATLAS.md.
ATLAS_OUT := $(BUILD)/atlas$(if $(QUICK),-quick)
ATLAS_PROGRAMS := $(addprefix $(BENCH)/pel-,atlas bench bench-scene matrix count) \
    $(BENCH)/atlas/damage-mcu.csv

# The paints of bench/mcu, with a clock instead of an emulator.
ATLAS_MATRIX := bench/matrix.c bench/mcu/matrix.c bench/mcu/report.c
$(ATLAS_MATRIX:%.c=$(BENCH)/host/%.o): PEL_CFLAGS += -D_POSIX_C_SOURCE=200809L
$(BENCH)/pel-matrix: $(ATLAS_MATRIX:%.c=$(BENCH)/host/%.o) $(BUILD)/libpel.a
	$(CC) $(LDFLAGS) $^ -o $@
-include $(ATLAS_MATRIX:%.c=$(BENCH)/host/%.d)

.PHONY: atlas atlas-page check-atlas need-atlas
need-atlas:
	@tests/tools/need.sh gnuplot:gnuplot-nox valgrind:valgrind
atlas: $(ATLAS_PROGRAMS) | need-atlas ## charts of speed and accuracy: build/atlas/index.html; QUICK=1, SHARD=I/N
	QUICK=$(QUICK) SHARD=$(SHARD) bench/atlas/run.sh $(BUILD) $(ATLAS_OUT)
	$(if $(SHARD),,bench/atlas/page.sh $(ATLAS_OUT))
atlas-page: | need-atlas ## its page again; ACCEPT=1 keeps the places in docs/ATLAS.md
	bench/atlas/page.sh $(ATLAS_OUT) $(ACCEPT)

# The page of a quick run, measured anew, in a browser.
CHECK_EXTRA += check-atlas
tests: $(ATLAS_PROGRAMS)
check-atlas: ## click through the atlas in Chromium
	@tests/tools/need.sh chromium:chromium
	rm -rf $(BUILD)/atlas-quick
	$(MAKE) --no-print-directory atlas QUICK=1
	tests/tools/atlas_page.sh $(BUILD)/atlas-quick/index.html
