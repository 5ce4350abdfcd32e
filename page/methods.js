// The same triangle by each method of the atlas, beside what is exact.
const GRID = 22;

class Ways {
  constructor(host) {
    this.host = host;
    this.corners = [[20, 4], [4, 20], [0, 7.5]];
    this.ways = [];
    for (let i = 0; host.exports.page_method(i); i++)
      this.add(host.string(host.exports.page_method(i)));
    this.draw();
  }

  add(name) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = GRID * 16;
    const caption = document.createElement("figcaption");
    const title = document.createElement("b");
    const count = document.createElement("span");
    title.textContent = name;
    caption.append(title, count);
    const figure = document.createElement("figure");
    figure.append(canvas, caption);
    document.getElementById("ways").append(figure);
    this.ways.push({ canvas, count });
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      this.held = this.nearest(this.place(e));
    });
    canvas.addEventListener("pointermove", (e) => {
      if (e.buttons && this.held) {
        this.held.splice(0, 2, ...this.place(e));
        this.draw();
      }
    });
  }

  // In pixels of the grid; quarters, so that sides meet centres of pixels.
  place(event) {
    const box = event.target.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width,
      (event.clientY - box.top) / box.height].map((v) =>
      Math.round(Math.min(GRID, Math.max(0, v * GRID)) * 4) / 4);
  }
  nearest([x, y]) {
    const far = (c) => Math.hypot(c[0] - x, c[1] - y);
    return this.corners.reduce((a, b) => far(b) < far(a) ? b : a);
  }

  fill(i) {
    const call = this.host.exports, view = this.host.view;
    const points = call.page_points();
    this.corners.flat().forEach((v, k) =>
      view.setInt32(points + 4 * k, Math.round(v * 256), true));
    const at = call.page_fill(i, GRID);
    return Array.from({ length: GRID * GRID }, (_, k) =>
      this.host.view.getUint32(at + 4 * k, true) !== 0);
  }

  draw() {
    const exact = this.fill(0);
    const style = getComputedStyle(document.body);
    const color = (name) => style.getPropertyValue("--" + name);
    this.ways.forEach(({ canvas, count }, i) => {
      const own = this.fill(i), context = canvas.getContext("2d");
      const cell = canvas.width / GRID;
      let wrong = 0;
      context.clearRect(0, 0, canvas.width, canvas.height);
      for (let k = 0; k < own.length; k++) {
        wrong += own[k] !== exact[k];
        context.fillStyle = color(own[k] === exact[k] ?
          own[k] ? "inside" : "ground" : own[k] ? "extra" : "missing");
        context.fillRect(k % GRID * cell + 1, Math.floor(k / GRID) * cell + 1,
          cell - 1, cell - 1);
      }
      context.strokeStyle = color("mark");
      context.lineWidth = 2;
      context.beginPath();
      for (const [x, y] of [...this.corners, this.corners[0]])
        context.lineTo(x * cell, y * cell);
      context.stroke();
      count.textContent = wrong ? `${wrong} pixels differ` : "exact here";
    });
  }
}
