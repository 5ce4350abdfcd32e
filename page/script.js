// A script beside its picture: typed, drawn, looked into.
const BAND_ROWS = 16; // that are shown of a script without bands
const LATE_MS = 200;  // after which it is said that a script is being drawn

class Sheet {
  constructor(page) {
    this.files = page.files;
    this.helper = new Helper(page);
    this.at = null;    // the pixel that is explained: [x, y]
    this.held = false;
    this.turn = 0;
    for (const name of ["source", "picture", "zoom", "bands", "heat", "format",
      "scene", "lens", "gutter", "error", "explain", "drawing"])
      this[name] = document.getElementById(name);
    this.source.addEventListener("input", () => {
      this.scene.value = ""; // it is another script from now on
      this.draw();
    });
    this.source.addEventListener("scroll", () => {
      this.gutter.scrollTop = this.source.scrollTop;
    });
    document.getElementById("stop").addEventListener("click", () =>
      this.helper.stop());
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

  // What is being drawn is stopped: it is an older script's.
  async draw() {
    const turn = ++this.turn;
    this.helper.stop();
    this.looks = false;
    this.drawing.hidden = true;
    this.number();
    const late = setTimeout(() => { this.drawing.hidden = false; }, LATE_MS);
    const answer = await this.helper.ask({ job: "draw", source: this.source.value,
      format: Number(this.format.value), heat: this.heat.checked });
    clearTimeout(late);
    if (turn !== this.turn)
      return;
    this.drawing.hidden = true;
    this.show(answer || { error: "stopped: it took too long" });
    await this.look();
    document.body.dataset.drawn = turn;
  }

  show({ done, error }) {
    const text = done ? done.text : error;
    this.error.textContent = text.replace(/^pel: \/script\.pel:(\d+):/gm, "line $1:");
    this.wrong = Number((/script\.pel:(\d+):/.exec(text) || [])[1]);
    if (!done || !done.bytes) { // the last picture stays, and what was said of it goes
      this.explain.textContent = "";
      this.error.textContent += "\n(the picture is that of the script before)";
      return;
    }
    const { width, height } = done;
    Object.assign(this.picture, { width, height });
    this.size();
    const context = this.picture.getContext("2d", { willReadFrequently: true });
    context.putImageData(new ImageData(new Uint8ClampedArray(done.bytes.buffer),
      width, height), 0, 0);
    if (this.bands.checked)
      this.tint(context, done.bands || BAND_ROWS);
    this.at ??= [Math.floor(width * .385), Math.floor(height * .54)];
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

  // At the pixel under the pointer, or at the one before. One look at a time: the
  // last place counts.
  async look(event) {
    if (event)
      this.at = [event.offsetX, event.offsetY].map((v) =>
        Math.max(0, Math.floor(v / this.zoom.value)));
    this.again = true;
    if (this.looks || this.helper.answer)
      return;
    const turn = this.turn;
    this.looks = true;
    while (this.again && this.at && turn === this.turn) {
      this.again = false;
      const x = Math.min(this.at[0], this.picture.width - 1);
      const y = Math.min(this.at[1], this.picture.height - 1);
      const answer = await this.helper.ask({ job: "look", x, y });
      if (answer && answer.done && turn === this.turn)
        this.tell(answer.done);
    }
    if (turn !== this.turn)
      return;
    this.looks = false;
    this.number();
  }

  tell({ side, bytes, text }) {
    this.lens.getContext("2d").putImageData(
      new ImageData(new Uint8ClampedArray(bytes.buffer), side, side), 0, 0);
    this.explain.textContent = text;
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
