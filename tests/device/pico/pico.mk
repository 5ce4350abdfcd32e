# A Raspberry Pi Pico in the emulator rp2040js, an npm package: its panels by SPI
# with a DMA and by I2C, touch, a button and an encoder that bounce. It comes from
# an npm registry on the first run, and stays in PICO_NPM. Not each machine that
# runs `make check` reaches one, so it is a target of its own beside it.

PICO_HERE := tests/device/pico
PICO := $(BUILD)/pico
PICO_BUILD := cortex-m0plus-O2
PICO_SCENE := $(PICO_HERE)/scene.c $(BUILD)/examples/fixed_10x20.c \
    $(BUILD)/examples/fixed_6x13.c
PICO_PORT := $(wildcard port/rp2040/*.c) port/spi_dma/rp2040.c
PICO_HEADERS := $(PICO_HERE)/scene.h $(wildcard port/rp2040/*.[hi]* drivers/*.h) \
    port/spi_dma/spi_dma.inc

$(PICO)/board.elf: $(PICO_HERE)/board.c $(PICO_SCENE) $(PICO_PORT) \
    $(BUILD)/mcu/$(PICO_BUILD)/libdrivers.a $(BUILD)/mcu/$(PICO_BUILD)/libpel.a \
    $(PICO_HEADERS) port/rp2040/rp2040.ld | need-arm
	@mkdir -p $(@D)
	$(MCU_COMPILE_$(PICO_BUILD)) -I$(BUILD)/examples $(MCU_LDFLAGS) \
	    -T port/rp2040/rp2040.ld -T port/cortex_m/sections.ld \
	    $(filter %.c %.a,$^) -o $@
$(PICO)/board.bin: $(PICO)/board.elf
	arm-none-eabi-objcopy -O binary $< $@

$(PICO)/glass: $(PICO_HERE)/glass.c $(PICO_SCENE) $(BUILD)/tests/host/libsupport.a \
    $(BUILD)/tests/host/libpel.a $(PICO_HEADERS)
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(TEST_FLAGS_host) -I$(BUILD)/examples \
	    $(filter %.c %.a,$^) -lcmocka -o $@

PICO_LIST := $(addprefix $(PICO_HERE)/,package.json package-lock.json .npmrc)
PICO_NPM := $(PICO)/node_modules/rp2040js/package.json
$(PICO_NPM): $(PICO_LIST)
	@command -v node >/dev/null && command -v npm >/dev/null || { echo \
	    "missing: node or npm, of the Debian packages nodejs and npm" >&2; exit 1; }
	@mkdir -p $(PICO) && cp $(PICO_LIST) $(PICO)
	@cd $(PICO) && npm ci --ignore-scripts --prefer-offline --no-audit \
	    --no-fund --fetch-retries=1 >npm.txt 2>&1 || { head -n 3 npm.txt; \
	    echo "check-pico: npm did not bring rp2040js (see above): is there a" \
	        "network, and does the npm registry answer?"; exit 1; } >&2
	@touch $@

.PHONY: check-pico
check-pico: $(PICO)/board.bin $(PICO)/glass $(PICO_NPM) ## panels, touch, button and encoder of a Raspberry Pi Pico, in an emulator
	@node $(PICO_HERE)/run.mjs $(PICO)/board.bin $(PICO)
	@$(PICO)/glass $(PICO)
	@arm-none-eabi-size $(PICO)/board.elf
