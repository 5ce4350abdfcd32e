// run.mjs IMAGE FOLDER : runs the flash image of board.c on an emulated RP2040, as
// the chips that are wired to it and as its user. Panels are not shown here: what
// is sent to them goes to FOLDER/lcd.log and oled.log, the scene of each frame to
// FOLDER/frames.txt, for glass.c.
import fs from 'fs';
import { createRequire } from 'module';
import path from 'path';

const [, , image, folder] = process.argv;
const require = createRequire(path.resolve(folder, 'run.mjs'));
const { Simulator, ConsoleLogger, LogLevel, GPIOPinState } = require('rp2040js');

const simulator = new Simulator();
const chip = simulator.rp2040;
const { clock } = simulator;
const [MS, US] = [1e6, 1e3];
const [BUTTON, A, B] = [14, 12, 13];
const FLASH = 0x10000000, VECTORS = FLASH + 0x100;

function fail(message) {
    throw new Error(`at ${(clock.nanos / MS).toFixed(3)} ms: ${message}`);
}

function expect(name, found, wanted) {
    if (found !== wanted)
        fail(`${name}: expected ${wanted}, got ${found}`);
}

function between(name, found, low, high) {
    if (found < low || found > high)
        fail(`${name}: expected ${low} to ${high}, got ${found}`);
}

let random = 1;
function dice(n) {
    random = Math.imul(random, 1103515245) + 12345 >>> 0;
    return (random >>> 16) % n;
}

// What the emulator has no model of. Anything else that it warns of is a mistake
// of the board's.
const unknown = /IC_SDA_HOLD/;
chip.logger = new ConsoleLogger(LogLevel.Warn, true);
chip.logger.warn = (part, text) => {
    if (!unknown.test(text))
        fail(`${part}: ${text}`);
};

// A log as glass.c reads it.
class Log {
    constructor(name) {
        this.path = `${folder}/${name}`;
        this.entries = [];
    }
    command(byte) { this.entries.push(byte); }
    data(byte) { this.entries.push(0x100 | byte); }
    reset() { this.entries.push(0x200); }
    frame() { this.entries.push(0x400); }
    write() { fs.writeFileSync(this.path, Uint16Array.from(this.entries)); }
}

// A chip at an SPI: `take` gets each byte when its last bit has gone, and answers.
function atSpi(spi, select, most, take) {
    const busy = clock.createAlarm(() => busy.done());
    spi.onTransmit = (byte) => {
        expect('SPI mode', spi.spiMode, 0);
        expect('bits of SPI', spi.dataBits, 8);
        between('SPI clock', spi.clockFrequency, 1, most);
        expect('chip select', chip.gpio[select].outputValue, false);
        const answer = take.start(byte);
        busy.done = () => {
            take.end();
            spi.completeTransmit(answer);
        };
        busy.schedule(8e9 / spi.clockFrequency);
    };
}

// An ST7789: D/C counts with the last bit and must not change before.
const lcd = new Log('lcd.log');
{
    const CS = 17, DC = 20, RST = 21;
    let dc, low = 0;
    atSpi(chip.spi[0], CS, 62.5e6, {
        start(byte) {
            dc = chip.gpio[DC].outputValue;
            expect('RST', chip.gpio[RST].outputValue, true);
            (dc ? lcd.data(byte) : lcd.command(byte));
            return 0;
        },
        end() {
            expect('D/C', chip.gpio[DC].outputValue, dc);
            expect('CS of the panel', chip.gpio[CS].outputValue, false);
        },
    });
    chip.gpio[RST].addListener((now) => {
        if (now === GPIOPinState.Low) {
            low = clock.nanos;
        } else if (low) {
            between('reset, us', (clock.nanos - low) / US, 10, 1e5);
            lcd.reset();
        }
    });
}

// An SSD1306 at address 0x3C: a control byte, then bytes of its kind. It answers
// when it is plugged in.
const oled = new Log('oled.log');
let plugged = false;
{
    const i2c = chip.i2c[0];
    let control;
    const later = (bits, then) => {
        const hertz = chip.clkSys / (i2c.sclHighPeriod + i2c.sclLowPeriod);
        between('I2C clock', hertz, 1, 401e3);
        const alarm = clock.createAlarm(then);
        alarm.schedule(bits * 1e9 / hertz);
    };
    i2c.onStart = () => later(1, () => i2c.completeStart());
    i2c.onConnect = (address) => {
        control = -1;
        later(9, () => i2c.completeConnect(plugged && address === 0x3c));
    };
    i2c.onWriteByte = (byte) => {
        if (control < 0) {
            control = byte;
            expect('control byte', byte & ~0x40, 0);
        } else if (control) {
            oled.data(byte);
        } else {
            oled.command(byte);
        }
        later(9, () => i2c.completeWrite(true));
    };
    i2c.onStop = () => later(1, () => i2c.completeStop());
}

// An XPT2046 below glass that is turned by a quarter and mirrored. The first
// measurement of a kind is off, as the plates still swing.
let finger = null;
{
    const CS = 9;
    let bytes = 0, before = 0, answer = 0, last = { x: 0, y: 0 };
    const value = {
        0xb0: () => (finger ? 1000 : 100),
        0xc0: () => (finger ? 1500 : 3980),
        0xd0: () => Math.round(3700 - 13.9 * last.y + 0.2 * last.x),
        0x90: () => Math.round(350 + 14.3 * last.x),
    };
    chip.gpio[CS].addListener(() => { bytes = 0; });
    atSpi(chip.spi[1], CS, 2e6, {
        start(byte) {
            last = finger ?? last;
            if (bytes++ === 0) {
                if (!value[byte])
                    fail(`touch controller: command ${byte}`);
                answer = value[byte]() + (byte === before ? 0 : dice(200) - 100);
                before = byte;
                return 0;
            }
            expect('byte to the touch controller', byte, 0);
            return bytes === 2 ? answer >> 5 : answer << 3 & 0xff;
        },
        end() {},
    });
}

// Contacts: low is closed. One that closes or opens bounces for 2 ms at most.
function* contact(pin, closed) {
    for (let i = 2 * dice(4); i > 0; i--) {
        chip.gpio[pin].setInputValue(i % 2 === 1 ? !closed : closed);
        yield 0.02 + dice(250) / 1000;
    }
    chip.gpio[pin].setInputValue(!closed);
}
function* turn(detents) {
    const [first, second] = detents > 0 ? [A, B] : [B, A];
    for (let i = 0; i < Math.abs(detents); i++) {
        for (const closed of [true, false]) {
            yield* contact(first, closed);
            yield 1;
            yield* contact(second, closed);
            yield 1;
        }
    }
}

// What the board says.
const lines = [];
const frames = [];
let shown = {}, text = '';
function take(line) {
    const [word, ...numbers] = line.split(' ');
    const n = numbers.map(Number);
    lines.push(line);
    if (word !== 'frame') {
        if (!/^(panel|oled|cross|map) /.test(line))
            fail(`the board says: ${line}`);
        return;
    }
    shown = { degrees: n[0], presses: n[1], held: n[2], x: n[3], y: n[4] };
    expect('status of a frame', n[5], 0);
    frames.push(numbers.join(' '));
    lcd.frame();
    oled.frame();
}
chip.uart[0].onByte = (byte) => {
    if (byte !== 10) {
        text += String.fromCharCode(byte);
        return;
    }
    take(text);
    text = '';
};

function* until(name, condition, ms) {
    for (const end = clock.nanos + ms * MS; !condition();) {
        if (clock.nanos > end)
            fail(`${name}: not within ${ms} ms; the board said last: ${lines.at(-1)}`);
        yield 0.1;
    }
}
function* scene(wanted) {
    const all = Object.entries(wanted);
    yield* until(JSON.stringify(wanted), () =>
        all.every(([name, value]) => Math.abs(shown[name] - value) <=
            (name === 'x' || name === 'y' ? 1 : 0)), 200);
}
const none = { x: -1, y: -1 };

function* user() {
    for (const pin of [BUTTON, A, B])
        chip.gpio[pin].setInputValue(true);
    yield* until('a panel', () => lines.length === 1, 2000);
    expect('first', lines[0], 'panel 0');

    // a display that does not answer at first
    yield* until('no answer', () => lines.length > 1, 500);
    expect('without a display', lines[1], 'oled -16');
    plugged = true;
    yield* until('an answer', () => lines.includes('oled 0'), 500);

    for (let i = 0; i < 3; i++) {
        const crosses = () => lines.filter((l) => l.startsWith('cross '));
        yield* until('a cross', () => crosses().length === i + 1, 200);
        const [, x, y] = crosses()[i].split(' ').map(Number);
        finger = { x, y };
        yield 60;
        finger = null;
    }
    yield* until('a map', () => lines.includes('map 0'), 200);
    yield* scene({ degrees: 0, presses: 0, held: 0, ...none });

    yield* turn(3);
    yield* scene({ degrees: 30 });
    yield* contact(BUTTON, true);
    yield* scene({ held: 1, presses: 1 });
    yield* turn(14);
    yield* contact(BUTTON, false);
    yield* scene({ degrees: 170, held: 0, presses: 1 });

    // contacts that touch for less than they must hold
    chip.gpio[BUTTON].setInputValue(false);
    yield 3;
    chip.gpio[BUTTON].setInputValue(true);
    yield 30;
    yield* scene({ held: 0, presses: 1 });

    for (const [x, y] of [[60, 60], [61, 200], [230, 9]]) {
        finger = { x, y };
        yield* scene({ x, y });
    }
    yield* turn(-5);
    yield* scene({ degrees: 120, x: 230, y: 9 });
    finger = null;
    yield* scene({ degrees: 120, ...none });
    for (let i = 2; i < 6; i++) {
        yield* contact(BUTTON, true);
        yield 20;
        yield* contact(BUTTON, false);
        yield* scene({ presses: i, held: 0 });
    }
    expect('MHz of the system', chip.clkSys / 1e6, 125);
    expect('MHz of peripherals', chip.clkPeri / 1e6, 125);
}

function run() {
    const story = user();
    const cycle = 1e9 / 125e6;
    let wake = 0;
    while (true) {
        if (clock.nanos >= wake) {
            const { done, value } = story.next();
            if (done)
                return;
            wake = clock.nanos + value * MS;
        }
        if (chip.core.waiting)
            clock.tick(Math.max(clock.nanosToNextAlarm, 1));
        else
            clock.tick(chip.core.executeInstruction() * cycle);
    }
}

// The boot stage would set these registers.
chip.flash.set(fs.readFileSync(image), VECTORS - FLASH);
chip.core.VTOR = VECTORS;
chip.core.SP = chip.readUint32(VECTORS);
chip.core.PC = chip.readUint32(VECTORS + 4) & ~1;
try {
    run();
} catch (error) {
    console.log(`check-pico: ${error.message}`);
    process.exitCode = 1;
}
lcd.write();
oled.write();
fs.writeFileSync(`${folder}/frames.txt`, frames.join('\n') + '\n');
console.log(`${(clock.nanos / MS).toFixed(0)} ms of the board's time`);
