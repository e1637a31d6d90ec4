// The conserved quantities against time, one below the other, with a marker that moves.

/** The height of a curve. */
const CURVE = 54;
/** The height of a line of text. */
const ROW = 19;
const RIGHT = 14;
/** Below this width labels stand above their curves, not beside them. */
const NARROW = 560;
const BOLD = "600 13px system-ui, 'DejaVu Sans', sans-serif";
const PLAIN = "12px system-ui, 'DejaVu Sans', sans-serif";

class Strip {
  constructor(canvas, motion) {
    Object.assign(this, { canvas, motion });
    this.still = document.createElement("canvas");
    this.largest = motion.invariants.map((_, index) => {
      let largest = 0;
      for (let i = 0; i < motion.frames; i++) {
        const size = Math.abs(motion.deviation(i, index));
        if (size > largest) largest = size;
      }
      return largest;
    });
  }

  /** Draws all but the marker. */
  prepare() {
    const ratio = window.devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.layOut();
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.round(this.width * ratio);
      canvas.height = Math.round(this.height * ratio);
      canvas.getContext("2d").setTransform(ratio, 0, 0, ratio, 0, 0);
    }
    const style = getComputedStyle(document.documentElement);
    this.color = (name) => style.getPropertyValue(name).trim();
    this.motion.invariants.forEach((invariant, index) => this.panel(invariant, index));
    this.axis();
  }

  /** Chooses the places of labels and curves from the width of the labels. */
  layOut() {
    const { invariants } = this.motion;
    const paint = this.still.getContext("2d");
    const widths = invariants.flatMap((invariant, index) => {
      const [name, range] = this.labels(invariant, index);
      paint.font = BOLD;
      const bold = paint.measureText(name).width;
      paint.font = PLAIN;
      return [bold, paint.measureText(range).width];
    });
    const widest = Math.max(0, ...widths);
    this.narrow = this.width < NARROW;
    this.head = this.narrow ? ROW : 0;
    this.left = this.narrow ? 8 : widest + 16;
    this.panelHeight = CURVE + this.head;
    this.axisHeight = this.narrow ? 24 + ROW : 24;
    this.height = this.panelHeight * invariants.length + this.axisHeight;
    this.canvas.style.height = `${this.height}px`;
  }

  labels({ symbol, unit }, index) {
    const name = pretty(symbol);
    return [`${name} − ${name}(0)`, `± ${scientific(this.largest[index])} ${unit}`.trim()];
  }

  middle(index) {
    return this.panelHeight * index + this.head + CURVE / 2;
  }

  panel(invariant, index) {
    const paint = this.still.getContext("2d");
    const middle = this.middle(index);
    const [name, range] = this.labels(invariant, index);
    paint.strokeStyle = this.color("--rule");
    paint.lineWidth = 1;
    paint.beginPath();
    paint.moveTo(this.left, middle);
    paint.lineTo(this.width - RIGHT, middle);
    paint.stroke();
    paint.textAlign = "left";
    paint.textBaseline = "middle";
    paint.fillStyle = this.color("--ink");
    paint.font = BOLD;
    const top = middle - CURVE / 2 - ROW / 2;
    paint.fillText(name, 0, this.narrow ? top : middle - 9);
    const indent = this.narrow ? paint.measureText(name).width + 12 : 0;
    paint.fillStyle = this.color("--quiet");
    paint.font = PLAIN;
    paint.fillText(range, indent, this.narrow ? top : middle + 9);

    // The least and the largest value of the frames of each pixel.
    const scale = 0.4 * CURVE / (this.largest[index] || 1);
    const pixels = new Map();
    for (let i = 0; i < this.motion.frames; i++) {
      const value = this.motion.deviation(i, index);
      if (!Number.isFinite(value)) continue;
      const pixel = Math.round(this.place(this.motion.time(i)));
      const seen = pixels.get(pixel) || [value, value, value];
      pixels.set(pixel, [Math.min(seen[0], value), Math.max(seen[1], value), value]);
    }
    paint.strokeStyle = this.color(["--third", "--second", "--first", "--momentum", "--tip"][index % 5]);
    paint.lineWidth = 1.3;
    paint.lineJoin = "round";
    paint.beginPath();
    for (const [pixel, values] of pixels) for (const value of values) paint.lineTo(pixel, middle - scale * value);
    paint.stroke();
  }

  axis() {
    const paint = this.still.getContext("2d");
    const top = this.height - this.axisHeight;
    const { end } = this.motion;
    paint.fillStyle = paint.strokeStyle = this.color("--quiet");
    paint.font = PLAIN;
    paint.textAlign = "center";
    paint.textBaseline = "top";
    paint.beginPath();
    const { exponent, unit } = notation(end, 0);
    const text = (value) => this.motion.sign(value) + String(Number(shifted(value, exponent).toPrecision(6)));
    // As many ticks as their labels have room, at most eight.
    let spacing = roundSpacing(end / 8);
    const room = () => (this.width - this.left - RIGHT) * spacing / (end || 1);
    const label = () => paint.measureText(text(spacing * Math.floor(end / spacing))).width + 14;
    while (room() < label() && spacing < end) spacing = roundSpacing(1.5 * spacing);
    for (let k = 0; k * spacing <= end * (1 + 1e-9); k++) {
      const x = this.place(k * spacing);
      paint.moveTo(x, top);
      paint.lineTo(x, top + 5);
      const half = paint.measureText(text(k * spacing)).width / 2;
      paint.fillText(text(k * spacing), Math.min(x, this.width - half), top + 8);
    }
    paint.moveTo(this.left, top);
    paint.lineTo(this.width - RIGHT, top);
    paint.lineWidth = 1;
    paint.stroke();
    paint.textAlign = this.narrow ? "center" : "left";
    const middle = (this.left + this.width - RIGHT) / 2;
    paint.fillText(`t in ${unit("s")}`, this.narrow ? middle : 0, top + 8 + (this.narrow ? ROW : 0));
  }

  place(time) {
    return this.left + (this.width - this.left - RIGHT) * time / (this.motion.end || 1);
  }

  /** The time at a place, x in pixels. */
  timeAt(x) {
    const share = (x - this.left) / (this.width - this.left - RIGHT);
    return Math.min(Math.max(share, 0), 1) * this.motion.end;
  }

  draw({ time, invariants }) {
    if (this.width !== this.canvas.clientWidth) this.prepare();
    const paint = this.canvas.getContext("2d");
    paint.clearRect(0, 0, this.width, this.height);
    paint.drawImage(this.still, 0, 0, this.width, this.height);
    const x = this.place(time);
    paint.strokeStyle = paint.fillStyle = this.color("--ink");
    paint.lineWidth = 1;
    paint.beginPath();
    // Over the curves, not over the labels above them.
    invariants.forEach((_, index) => {
      paint.moveTo(x, this.middle(index) - CURVE / 2);
      paint.lineTo(x, this.middle(index) + CURVE / 2);
    });
    paint.stroke();
    invariants.forEach((value, index) => {
      const deviation = value - this.motion.number(0, 11 + index);
      if (!Number.isFinite(deviation)) return;
      const y = this.middle(index) - 0.4 * CURVE * deviation / (this.largest[index] || 1);
      paint.beginPath();
      paint.arc(x, y, 3.5, 0, 2 * Math.PI);
      paint.fill();
    });
  }
}
