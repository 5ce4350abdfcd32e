// Examples: each runs once, from its begin to its end; its frames are played.
const FRAME_MS = 1000 / 15;

class Player {
  constructor(name, frames) {
    const first = frames[0];
    this.frames = frames.map((f) =>
      new ImageData(new Uint8ClampedArray(f.bytes.buffer), f.width, f.height));
    this.canvas = document.createElement("canvas");
    Object.assign(this.canvas, { width: first.width, height: first.height });
    const most = Math.max(...frames.slice(1).map((f) => f.sent), 0);
    const part = Math.round(100 * most / (first.width * first.height));
    const caption = document.createElement("figcaption");
    const title = document.createElement("b");
    const button = document.createElement("button");
    title.textContent = name;
    caption.append(title, `${first.width} x ${first.height}, at most ${part} % ` +
      "of it sent for a step. ", button);
    this.figure = document.createElement("figure");
    this.figure.player = this;
    this.figure.append(this.canvas, caption);
    button.addEventListener("click", () => this.run(!this.runs, button));
    this.next = 0;
    this.step();
    this.run(!matchMedia("(prefers-reduced-motion: reduce)").matches, button);
  }
  step() {
    this.canvas.getContext("2d").putImageData(this.frames[this.next], 0, 0);
    this.next = (this.next + 1) % this.frames.length;
  }
  run(on, button) {
    this.runs = on;
    button.textContent = on ? "Stop" : "Play";
    clearInterval(this.timer);
    if (on)
      this.timer = setInterval(() => this.step(), FRAME_MS);
  }
}

async function play(page, examples) {
  const helper = new Helper(page);
  for (let i = 0; i < examples.length; i++) {
    const { done, error } = await helper.ask({ job: "play", i });
    if (error)
      throw new Error(examples[i] + ": " + error);
    document.getElementById("players").append(new Player(examples[i], done).figure);
  }
  helper.worker.terminate();
}
