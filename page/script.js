// A script beside its picture: typed, drawn, looked into.
const BAND_ROWS = 16; // that are shown of a script without bands

class Sheet {
  constructor(page) {
    Object.assign(this, page); // module, files, of
    this.at = null;    // the pixel that is explained: [x, y]
    this.held = false;
    this.turn = 0;
    for (const name of ["source", "picture", "zoom", "bands", "heat", "format",
      "scene", "lens", "gutter", "error", "explain"])
      this[name] = document.getElementById(name);
    this.source.addEventListener("input", () => {
      this.scene.value = ""; // it is another script from now on
      this.draw();
    });
    this.source.addEventListener("scroll", () => {
      this.gutter.scrollTop = this.source.scrollTop;
    });
    for (const control of [this.format, this.heat, this.bands])
      control.addEventListener("change", () => this.draw());
    this.zoom.addEventListener("change", () => {
      this.chosen = true;
      this.size();
    });
    addEventListener("resize", () => this.size());
    this.scene.addEventListener("change", () => this.load(this.scene.value));
    this.picture.addEventListener("pointermove", (e) => {
      if (!this.held)
        this.look(e);
    });
    this.picture.addEventListener("click", (e) => {
      this.held = !this.held;
      this.look(e);
    });
  }

  load(name) {
    const old = "../sim/scenes/"; // a folder that is not here
    this.scene.value = name;
    this.source.value =
      new TextDecoder().decode(this.files.get(name)).replaceAll(old, "");
    this.source.scrollTop = 0;
    this.held = false;
    this.at = null;
    this.chosen = false;
    this.draw();
  }

  // A host of its own for each drawing: whatever happens in it is forgotten.
  async draw() {
    const turn = ++this.turn;
    const files = new Map(this.files);
    files.set("script.pel", new TextEncoder().encode(this.source.value));
    const host = await new Host(files).start(this.module);
    if (turn !== this.turn)
      return;
    try {
      this.show(host);
    } catch (e) {
      this.error.textContent = "this is too much for a page: " + e.message;
    }
    this.number();
    document.body.dataset.drawn = turn;
  }

  show(host) {
    const call = host.exports;
    const bytes = call.page_read(Number(this.format.value)) &&
      call.page_draw(this.heat.checked);
    const text = host.taken(2).trim();
    this.error.textContent = text.replace(/^pel: \/script\.pel:(\d+):/gm, "line $1:");
    this.wrong = Number((/script\.pel:(\d+):/.exec(text) || [])[1]);
    if (!bytes) { // the last picture stays, and what was said of it goes
      this.host = null;
      this.explain.textContent = "";
      this.error.textContent += "\n(the picture is that of the script before)";
      return;
    }
    const width = call.page_width(), height = call.page_height();
    Object.assign(this.picture, { width, height });
    this.host = host;
    this.size();
    const context = this.picture.getContext("2d", { willReadFrequently: true });
    const data = new ImageData(width, height);
    data.data.set(host.bytes(bytes, width * height * 4));
    context.putImageData(data, 0, 0);
    if (this.bands.checked)
      this.tint(context, call.page_bands() || BAND_ROWS);
    this.at ??= [Math.floor(width * .385), Math.floor(height * .54)];
    this.look();
  }

  tint(context, rows) {
    context.fillStyle = "rgb(255 255 255 / 18%)";
    for (let y = 0; y < this.picture.height; y += 2 * rows)
      context.fillRect(0, y, this.picture.width, rows);
  }

  // As large as fits, until someone chooses.
  size() {
    if (!this.chosen)
      this.zoom.value = [4, 3, 2].find((z) =>
        z * this.picture.width <= this.picture.parentElement.clientWidth) || 1;
    this.picture.style.width = this.picture.width * this.zoom.value + "px";
    this.picture.style.height = this.picture.height * this.zoom.value + "px";
  }

  // At the pixel under the pointer, or at the one before.
  look(event) {
    if (event)
      this.at = [event.offsetX, event.offsetY].map((v) =>
        Math.max(0, Math.floor(v / this.zoom.value)));
    if (!this.host)
      return;
    const x = Math.min(this.at[0], this.picture.width - 1);
    const y = Math.min(this.at[1], this.picture.height - 1);
    const call = this.host.exports, side = call.page_lens_side();
    const data = new ImageData(side, side);
    data.data.set(this.host.bytes(call.page_lens(x, y), side * side * 4));
    this.lens.getContext("2d").putImageData(data, 0, 0);
    call.page_explain(x, y);
    this.explain.textContent = this.host.taken(1);
    this.number();
  }

  // Numbers of lines, those that have painted the pixel marked.
  number() {
    const painted = new Set([...this.explain.textContent.matchAll(/^line (\d+):/gm)]
      .map((match) => Number(match[1])));
    const lines = this.source.value.split("\n").map((_, i) => {
      const mark = document.createElement(
        painted.has(i + 1) || this.wrong === i + 1 ? "b" : "span");
      mark.textContent = i + 1 + "\n";
      return mark;
    });
    this.gutter.replaceChildren(...lines);
    this.gutter.scrollTop = this.source.scrollTop;
  }
}
