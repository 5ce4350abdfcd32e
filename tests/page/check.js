"use strict";
// check.js PEL FOLDER EXAMPLE... : the page in FOLDER, opened from its file and from
// a server in Chromium, typed into and clicked: what it shows is what PEL and the
// examples draw.
const { execFileSync } = require("node:child_process");
const { createServer } = require("node:http");
const { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } =
  require("node:fs");
const path = require("node:path");
const { Browser } = require("./browser.js");

const [pel, folder, ...examples] = process.argv.slice(2);
const file = path.resolve(folder, "index.html");
const work = mkdtempSync(path.join(require("node:os").tmpdir(), "page-"));
const browser = new Browser(path.join(work, "profile"));
let failed = 0, passed = 0;

function check(ok, what) {
  ok ? passed++ : failed++;
  if (!ok)
    console.error("FAILED: " + what);
}

// A PPM: width, height and R, G, B.
function picture_of(bytes) {
  const [head, width, height] = /^P6\n(?:#.*\n)*(\d+) (\d+)\s255\n/.exec(
    bytes.subarray(0, 400).toString("latin1"));
  return { width: Number(width), height: Number(height),
    rgb: bytes.subarray(head.length) };
}

// What PEL writes of a script.
function drawn(script, ...options) {
  const ppm = path.join(work, "drawn.ppm");
  execFileSync(pel, ["run", script, "-o", ppm, ...options]);
  return picture_of(readFileSync(ppm));
}

// The same of an ImageData of the page.
async function image(expression) {
  const picture = await browser.value(`((image) => {
    let text = "";
    for (let i = 0; i < image.data.length; i++)
      if (i % 4 < 3) text += String.fromCharCode(image.data[i]);
    return { width: image.width, height: image.height, text: btoa(text) };
  })(${expression})`);
  return { ...picture, rgb: Buffer.from(picture.text, "base64") };
}
const shown = () => image(`((c) =>
  c.getContext("2d").getImageData(0, 0, c.width, c.height))(
    document.getElementById("picture"))`);
const same = (a, b) => a.width === b.width && a.height === b.height &&
  a.rgb.equals(b.rgb);

// Does something, and waits until it is drawn.
async function does(work_of) {
  const before = await browser.value("document.body.dataset.drawn");
  await work_of();
  await browser.until(`document.body.dataset.drawn > ${before}`);
}
// What the pointer asks for is told a little later.
const settled = () => new Promise((done) => setTimeout(done, 500));
const text_of = (id) => browser.value(`document.getElementById("${id}").textContent`);

const script = `canvas 80 60 rgb565_le
clear #102030
paint radial 40 30 36 0 #ffcc00 1 #aa0066
circle 40.25 30.5 24.75
option smooth on
paint flat #80c0ff90
triangle 4.5 50 70.25 8 76 55
`;

async function check_editor() {
  const own = path.join(work, "own.pel");
  writeFileSync(own, script);
  await does(() => browser.type("#source", script));
  check(await browser.value("document.getElementById('source').value") === script,
    "what is typed is not in the field");
  check(same(await shown(), drawn(own)), "another picture than pel run");
  await browser.choose("#zoom", 1);
  const shot = path.join(work, "shot.png");
  writeFileSync(shot, await browser.screen(await browser.box("#picture")));
  drawn(own);
  try {
    execFileSync(pel, ["compare", shot, path.join(work, "drawn.ppm")]);
    check(true);
  } catch (e) {
    check(false, "the screen: " + e.stdout);
  }

  await browser.choose("#zoom", 4);
  const box = await browser.box("#picture");
  await browser.click(box.x + 4 * 31 + 2, box.y + 4 * 22 + 1);
  const words = execFileSync(pel, ["explain", own, "31", "22"]).toString();
  await settled();
  check(await text_of("explain") === words, "another explanation than pel explain");
  check(await browser.value(
    "[...document.querySelectorAll('#gutter b')].map((b) => b.textContent.trim()).join()")
    === [...words.matchAll(/^line (\d+):/gm)].map((m) => m[1]).join(),
  "lines that have painted the pixel are not marked");
  await browser.mouse("mouseMoved", box.x + 9, box.y + 9);
  await settled();
  check(await text_of("explain") === words, "a click does not hold the pixel");
  check(await browser.value(`(() => {
    const c = document.getElementById("lens");
    const d = c.getContext("2d").getImageData(0, 0, 272, 272).data;
    return new Set(new Uint32Array(d.buffer)).size;
  })()`) > 4, "an empty lens");

  await does(() => browser.choose("#format", 13));
  const name = await browser.value("document.getElementById('format').selectedOptions[0].text");
  check(same(await shown(), drawn(own, "--format", name)), "another picture in " + name);
  await does(() => browser.choose("#format", -1));
  await does(() => browser.value("document.getElementById('heat').click()"));
  const { rgb } = await shown();
  const counts = new Set();
  for (let i = 0; i < rgb.length; i += 3)
    counts.add(rgb.subarray(i, i + 3).toString("hex"));
  check([...counts].sort().join() === "0000ff,00c0ff,00e000", "painted once, " +
    "twice, three times: " + [...counts]);
  await does(() => browser.value("document.getElementById('heat').click()"));
  await does(() => browser.value("document.getElementById('bands').click()"));
  check(!same(await shown(), drawn(own)), "no bands");
  await does(() => browser.value("document.getElementById('bands').click()"));
  check(same(await shown(), drawn(own)), "the picture is not as before");

  await does(() => browser.type("#source", script + "circle 1 2\n"));
  check(/^line 8: circle: /.test(await text_of("error")), "no error: " +
    await text_of("error"));
  check(same(await shown(), drawn(own)), "an error takes the picture away");
  for (const size of ["30000 30000", "16000 16000"]) {
    await does(() => browser.type("#source", `canvas ${size} xrgb8888\n`));
    check(/memory|too m/.test(await text_of("error")), "too large: " +
      await text_of("error"));
  }
}

// A script that takes minutes: the page goes on, it is stopped by a click, and by
// what is typed next.
async function check_stop() {
  const own = path.join(work, "own.pel");
  const slow = "canvas 4000 4000 xrgb8888\noption smooth on\n" +
    "paint conic 2000 2000 0 0 #ff000080 1 #0000ff80\n" +
    "circle 2000 2000 1990\n".repeat(200);
  const drawing = "!document.getElementById('drawing').hidden";
  const begun = Date.now();
  await browser.type("#source", slow);
  await browser.until(drawing);
  await does(() => browser.value("document.getElementById('stop').click()"));
  check(/^stopped/.test(await text_of("error")), "not stopped: " + await text_of("error"));
  check(!await browser.value(drawing), "drawing goes on");
  await browser.type("#source", slow);
  await browser.until(drawing);
  await does(() => browser.type("#source", script));
  check(same(await shown(), drawn(own)), "another picture after a slow script");
  check(await text_of("error") === "", "an error: " + await text_of("error"));
  check(Date.now() - begun < 20000, "the page was held up");
}

// A worker that fails is told of, now and whenever it is asked again.
async function check_failure() {
  for (let i = 0; i < 2; i++)
    check(/worker/.test((await browser.value(`(() => {
      if (globalThis.broken)
        return broken.ask({});
      globalThis.broken = Object.create(Helper.prototype);
      broken.url = URL.createObjectURL(new Blob(["throw new Error()"]));
      broken.start();
      return broken.ask({});
    })()`)).error), "a worker that failed is waited for");
}

async function check_scenes() {
  const names = await browser.value(
    "[...document.querySelectorAll('#scene option')].map((o) => o.value)");
  check(names.length > 10, "few scenes");
  for (const name of names) {
    await does(() => browser.choose("#scene", name));
    const from = name === "first.pel" ? "page/" : "sim/scenes/";
    check(same(await shown(), drawn(from + name)), name + ": another picture");
    check(await text_of("error") === "", name + ": " + await text_of("error"));
  }
}

async function check_rest() {
  const players = "document.querySelectorAll('#players figure')";
  await browser.until(players + ".length === " + examples.length);
  for (const [i, example] of examples.entries())
    check(same(await image(`${players}[${i}].player.frames.at(-1)`),
      picture_of(execFileSync(example))), example + " ends with another picture");
  const counts = () => browser.value(
    "[...document.querySelectorAll('#ways span')].map((s) => s.textContent).join()");
  const before = await counts();
  check(/^exact here,.*differ/.test(before), "all methods are exact: " + before);
  const box = await browser.box("#ways canvas");
  const at = (v) => v / 22 * box.width;
  await browser.mouse("mouseMoved", box.x + at(20), box.y + at(4));
  await browser.mouse("mousePressed", box.x + at(20), box.y + at(4), 1);
  await browser.mouse("mouseMoved", box.x + at(12.25), box.y + at(2.25), 1);
  await browser.mouse("mouseReleased", box.x + at(12.25), box.y + at(2.25));
  check(await counts() !== before, "a corner cannot be moved");
  check(/^exact here/.test(await counts()), "Pel is not exact");
}

async function main() {
  check(statSync(file).size < 400000, "the page has " + statSync(file).size + " bytes");
  await browser.open("file://" + file);
  await browser.until("document.body && document.body.dataset.drawn");
  await check_editor();
  await check_stop();
  await check_failure();
  await check_scenes();
  await check_rest();
  const server = createServer((request, answer) => {
    answer.setHeader("Content-Type", "text/html");
    answer.end(request.url === "/" ? readFileSync(file) : "");
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  await browser.open(`http://127.0.0.1:${server.address().port}/`);
  await browser.until("location.protocol === 'http:' && document.body.dataset.drawn");
  check(same(await shown(), drawn("page/first.pel")), "another picture from a server");
  server.close();
  server.closeAllConnections();
  check(browser.wrong.length === 0, "the console: " + browser.wrong.join("\n"));
}

const late = setTimeout(() => { throw new Error("not done in five minutes"); }, 300000);
main().catch((e) => check(false, e.stack)).finally(() => {
  clearTimeout(late);
  browser.process.on("exit", () => setTimeout(() => rmSync(work,
    { recursive: true, force: true, maxRetries: 10, retryDelay: 200 }), 500));
  browser.close();
  console.log(`the page: ${passed} passed, ${failed} failed`);
  process.exitCode = failed ? 1 : 0;
});
