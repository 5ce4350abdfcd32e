// Scripts are drawn and examples run beside the page, which can be typed into
// meanwhile: in a worker, which is ended to stop them.

// What the worker does: its text is all that it has, with that of Host.
function work() {
  let files, module, host; // host: of the script that is shown

  // A host of its own for each drawing: whatever happens in it is forgotten.
  async function draw({ source, format, heat }) {
    const own = new Map(files);
    own.set("script.pel", new TextEncoder().encode(source));
    host = null;
    const next = await new Host(own).start(module), call = next.exports;
    const bytes = call.page_read(format) && call.page_draw(heat);
    const text = next.taken(2).trim();
    if (!bytes)
      return { text };
    host = next;
    const width = call.page_width(), height = call.page_height();
    return { text, width, height, bands: call.page_bands(),
      bytes: next.bytes(bytes, width * height * 4).slice() };
  }

  // The pixels around one, and what is said of it.
  function look({ x, y }) {
    if (!host)
      return null;
    const call = host.exports, side = call.page_lens_side();
    const bytes = host.bytes(call.page_lens(x, y), side * side * 4).slice();
    call.page_explain(x, y);
    return { side, bytes, text: host.taken(1) };
  }

  async function play({ i }) {
    const frames = [];
    const own = await new Host(files, (f) => frames.push(f)).start(module);
    own.exports.page_play(i);
    return frames;
  }

  const jobs = { draw, look, play };
  onmessage = async ({ data }) => {
    if (data.module) {
      ({ files, module } = data);
      return;
    }
    try {
      postMessage({ done: await jobs[data.job](data) });
    } catch (e) {
      postMessage({ error: "this is too much for a page: " + e.message });
    }
  };
}

// One job at a time.
class Helper {
  constructor(page) {
    this.page = page; // files, module
    const text = [Host, work].map(String).join("\n");
    this.url = URL.createObjectURL(new Blob([`"use strict";\n${text}\nwork();`]));
    this.start();
  }
  start() {
    this.worker = new Worker(this.url);
    this.worker.onerror = (e) => { // of what work() does not catch
      e.preventDefault();
      this.failed = { error: "the worker of the page failed: " + e.message };
      this.end(this.failed);
    };
    this.worker.onmessage = ({ data }) => this.end(data);
    this.worker.postMessage(this.page);
  }
  end(answer) {
    this.answer?.(answer);
    this.answer = null;
  }
  // What became of it: done, or an error; null: it was stopped.
  ask(job) {
    return new Promise((answer) => {
      this.answer = answer;
      if (this.failed)
        this.end(this.failed);
      else
        this.worker.postMessage(job);
    });
  }
  stop() {
    if (!this.answer && !this.failed)
      return;
    this.worker.terminate();
    this.end(null);
    this.failed = null;
    this.start();
  }
}
