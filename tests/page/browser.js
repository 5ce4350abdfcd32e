"use strict";
// Chromium without a window, driven over a pipe by its DevTools protocol: a page,
// its keyboard and its mouse.
const { spawn } = require("node:child_process");

class Browser {
  constructor(profile) {
    const root = process.getuid() === 0; // who may not have a sandbox
    this.process = spawn("chromium", ["--headless", ...(root ? ["--no-sandbox"] : []),
      "--disable-gpu", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--window-size=1400,1000",
      "--user-data-dir=" + profile, "--remote-debugging-pipe", "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.waits = new Map();
    this.wrong = []; // what the page's console said
    this.number = 0;
    let text = "";
    this.process.stdio[4].on("data", (part) => {
      const messages = (text += part).split("\0");
      text = messages.pop();
      messages.forEach((m) => this.take(JSON.parse(m)));
    });
  }
  take(message) {
    const wait = this.waits.get(message.id);
    this.waits.delete(message.id);
    if (wait)
      message.error ? wait.fail(new Error(message.error.message)) :
        wait.done(message.result);
    else if (/exceptionThrown|consoleAPICalled|entryAdded/.test(message.method))
      this.wrong.push(JSON.stringify(message.params).slice(0, 400));
  }
  send(method, params = {}) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify(
      { id, method, params, sessionId: this.session }) + "\0");
    return new Promise((done, fail) => this.waits.set(id, { done, fail }));
  }

  async open(url) {
    if (!this.session) {
      const { targetInfos } = await this.send("Target.getTargets");
      const page = targetInfos.find((t) => t.type === "page");
      this.session = (await this.send("Target.attachToTarget",
        { targetId: page.targetId, flatten: true })).sessionId;
      await Promise.all(["Page", "Runtime", "Log"].map((d) => this.send(d + ".enable")));
    }
    await this.send("Page.navigate", { url });
  }
  // The value of an expression, a promise's too.
  async value(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails)
      throw new Error(expression + ": " + exceptionDetails.exception.description);
    return result.value;
  }
  async until(expression) {
    for (let i = 0; i < 2400; i++) {
      if (await this.value(`Boolean(${expression})`).catch(() => false))
        return;
      await new Promise((done) => setTimeout(done, 50));
    }
    throw new Error("not within two minutes: " + expression);
  }

  // Where an element is seen, as x, y, width, height.
  box(selector) {
    return this.value(`(() => {
      const e = document.querySelector(${JSON.stringify(selector)});
      e.scrollIntoView({ block: "center" });
      const b = e.getBoundingClientRect();
      return { x: b.x, y: b.y, width: b.width, height: b.height };
    })()`);
  }
  async mouse(type, x, y, buttons = 0) {
    await this.send("Input.dispatchMouseEvent", { type, x, y, buttons,
      button: type === "mouseMoved" ? "none" : "left", clickCount: 1 });
  }
  async click(x, y) {
    await this.mouse("mouseMoved", x, y);
    await this.mouse("mousePressed", x, y, 1);
    await this.mouse("mouseReleased", x, y);
  }
  // Types over all of a field.
  async type(selector, text) {
    const box = await this.box(selector);
    await this.click(box.x + 20, box.y + 20);
    const all = { key: "a", code: "KeyA", windowsVirtualKeyCode: 65, modifiers: 2,
      commands: ["selectAll"] };
    await this.send("Input.dispatchKeyEvent", { type: "rawKeyDown", ...all });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...all });
    await this.send("Input.insertText", { text });
  }
  async choose(selector, value) {
    await this.value(`(() => {
      const e = document.querySelector(${JSON.stringify(selector)});
      e.value = ${JSON.stringify(String(value))};
      e.dispatchEvent(new Event("change"));
    })()`);
  }
  // The screen at a box, as a PNG.
  async screen({ x, y, width, height }) {
    const [left, top] = await this.value("[scrollX, scrollY]");
    const { data } = await this.send("Page.captureScreenshot",
      { clip: { x: x + left, y: y + top, width, height, scale: 1 } });
    return Buffer.from(data, "base64");
  }
  close() { this.process.kill("SIGKILL"); }
}

module.exports = { Browser };
