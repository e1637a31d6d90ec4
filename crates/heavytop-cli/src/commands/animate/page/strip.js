// The conserved quantities against time, one below the other, with a marker that moves.

const PANEL = 54;
const AXIS = 24;
const LEFT = 150;
const RIGHT = 14;

class Strip {
  constructor(canvas, motion) {
    Object.assign(this, { canvas, motion });
    this.still = document.createElement("canvas");
    this.height = PANEL * motion.invariants.length + AXIS;
    canvas.style.height = `${this.height}px`;
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

  panel({ symbol, unit }, index) {
    const paint = this.still.getContext("2d");
    const middle = PANEL * (index + 0.5);
    const name = pretty(symbol);
    paint.strokeStyle = this.color("--rule");
    paint.lineWidth = 1;
    paint.beginPath();
    paint.moveTo(LEFT, middle);
    paint.lineTo(this.width - RIGHT, middle);
    paint.stroke();
    paint.textAlign = "left";
    paint.textBaseline = "middle";
    paint.fillStyle = this.color("--ink");
    paint.font = "600 13px system-ui, 'DejaVu Sans', sans-serif";
    paint.fillText(`${name} − ${name}(0)`, 0, middle - 9);
    paint.fillStyle = this.color("--quiet");
    paint.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    paint.fillText(`± ${scientific(this.largest[index])} ${unit}`, 0, middle + 9);

    // The least and the largest value of the frames of each pixel.
    const scale = 0.4 * PANEL / (this.largest[index] || 1);
    const ranges = new Map();
    for (let i = 0; i < this.motion.frames; i++) {
      const value = this.motion.deviation(i, index);
      if (!Number.isFinite(value)) continue;
      const pixel = Math.round(this.place(this.motion.time(i)));
      const range = ranges.get(pixel) || [value, value, value];
      ranges.set(pixel, [Math.min(range[0], value), Math.max(range[1], value), value]);
    }
    paint.strokeStyle = this.color(["--third", "--second", "--first", "--momentum", "--tip"][index % 5]);
    paint.lineWidth = 1.3;
    paint.lineJoin = "round";
    paint.beginPath();
    for (const [pixel, range] of ranges) for (const value of range) paint.lineTo(pixel, middle - scale * value);
    paint.stroke();
  }

  axis() {
    const paint = this.still.getContext("2d");
    const top = this.height - AXIS;
    paint.fillStyle = paint.strokeStyle = this.color("--quiet");
    paint.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    paint.textAlign = "center";
    paint.textBaseline = "top";
    paint.beginPath();
    const spacing = roundSpacing(this.motion.end / 8);
    for (let k = 0; k * spacing <= this.motion.end * (1 + 1e-9); k++) {
      const x = this.place(k * spacing);
      paint.moveTo(x, top);
      paint.lineTo(x, top + 5);
      paint.fillText(String(Number((k * spacing).toPrecision(6))), x, top + 8);
    }
    paint.moveTo(LEFT, top);
    paint.lineTo(this.width - RIGHT, top);
    paint.lineWidth = 1;
    paint.stroke();
    paint.textAlign = "left";
    paint.fillText("t in s", 0, top + 8);
  }

  place(time) {
    return LEFT + (this.width - LEFT - RIGHT) * time / (this.motion.end || 1);
  }

  /** The time at a place, x in pixels. */
  timeAt(x) {
    const share = (x - LEFT) / (this.width - LEFT - RIGHT);
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
    paint.moveTo(x, 2);
    paint.lineTo(x, this.height - AXIS);
    paint.stroke();
    invariants.forEach((value, index) => {
      const deviation = value - this.motion.number(0, 11 + index);
      if (!Number.isFinite(deviation)) return;
      const y = PANEL * (index + 0.5) - 0.4 * PANEL * deviation / (this.largest[index] || 1);
      paint.beginPath();
      paint.arc(x, y, 3.5, 0, 2 * Math.PI);
      paint.fill();
    });
  }
}

/** The least of 1, 2, 5 times a power of ten that is not below. */
function roundSpacing(least) {
  const power = 10 ** Math.floor(Math.log10(least || 1));
  return power * [1, 2, 5, 10].find((digit) => digit * power >= least * 0.999);
}

/** A symbol with its digit as a subscript. */
function pretty(symbol) {
  return symbol.replace(/[0-9]/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}

/** A number in two digits and a power of ten. */
function scientific(value) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return String(value);
  const [digits, power] = value.toExponential(1).split("e");
  const raised = Math.abs(Number(power)).toString().replace(/[0-9]/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
  return `${digits} · 10${Number(power) < 0 ? "⁻" : ""}${raised}`.replace("-", "−");
}
