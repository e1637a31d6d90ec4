// The deviations of the invariants against time, on a logarithmic scale.

/** The least exponent; deviations of 0 are drawn there. */
const FLOOR_EXPONENT = -17;
/** The most points of a curve: each is the largest deviation in its span of time. */
const MOST_CHART_POINTS = 96;

/** Joins neighbouring rows of seven numbers, a time and deviations, until there are few enough. */
function joined(columns) {
  const rows = columns.length / 7;
  const size = Math.ceil(rows / MOST_CHART_POINTS);
  if (size <= 1) return columns;
  const result = new Float64Array(7 * Math.ceil(rows / size));
  columns.forEach((value, i) => {
    const to = 7 * Math.floor(Math.floor(i / 7) / size) + i % 7;
    if (value > result[to]) result[to] = value;
  });
  return result;
}

class DeviationChart {
  constructor(canvas) {
    this.canvas = canvas;
    this.margin = { left: 46, right: 12, top: 26, bottom: 36 };
  }

  /** Draws the columns of so many invariants; `changes` are the times at which a method or a friction began. */
  draw(all, count, changes) {
    const columns = joined(all);
    const { paint, width, height } = sized(this.canvas);
    Object.assign(this, { paint, width, height });
    paint.clearRect(0, 0, width, height);
    const rows = columns.length / 7;
    this.begin = rows ? Math.min(columns[0], changes[0].time) : 0;
    this.end = Math.max(rows ? columns[7 * (rows - 1)] : 0, this.begin + 1);
    let largest = 0;
    for (let i = 0; i < columns.length; i++) if (i % 7 !== 0 && columns[i] > largest) largest = columns[i];
    this.top = Math.max(Math.ceil(Math.log10(largest || 1)), 0);
    this.bands(changes);
    this.axes();
    for (let k = count - 1; k >= 0; k--) this.curve(columns, rows, k);
    paint.setLineDash([]);
  }

  x(time) {
    const { left, right } = this.margin;
    return left + (this.width - left - right) * (time - this.begin) / (this.end - this.begin);
  }

  y(exponent) {
    const { top, bottom } = this.margin;
    return top + (this.height - top - bottom) * (this.top - exponent) / (this.top - FLOOR_EXPONENT);
  }

  /** A band for each method, darker for those that are not Poisson, with its name where it fits. */
  bands(changes) {
    const { paint, margin } = this;
    const bottom = this.height - margin.bottom;
    changes.forEach(({ time, method, friction }, i) => {
      const from = this.x(Math.max(time, this.begin));
      const to = this.x(Math.min(changes[i + 1]?.time ?? this.end, this.end));
      if (!METHODS[method].poisson) {
        paint.globalAlpha = 0.1;
        paint.fillStyle = colorOf("--first");
        paint.fillRect(from, margin.top, to - from, bottom - margin.top);
        paint.globalAlpha = 1;
      }
      paint.strokeStyle = colorOf("--quiet");
      paint.setLineDash([3, 3]);
      paint.lineWidth = 1;
      if (i > 0) {
        paint.beginPath();
        paint.moveTo(from, margin.top - 8);
        paint.lineTo(from, bottom);
        paint.stroke();
      }
      paint.setLineDash([]);
      const label = METHODS[method].label + (friction ? ", with friction" : "");
      if (paint.measureText(label).width + 8 < to - from) {
        paint.textAlign = "left";
        paint.textBaseline = "alphabetic";
        paint.fillStyle = colorOf("--quiet");
        paint.fillText(label, from + 4, margin.top - 9);
      }
    });
  }

  axes() {
    const { paint, margin, width, height } = this;
    paint.fillStyle = colorOf("--quiet");
    paint.strokeStyle = colorOf("--rule");
    paint.lineWidth = 1;
    paint.textAlign = "right";
    paint.textBaseline = "middle";
    // A motion that blows up has numbers up to 10³⁰⁸.
    const gap = 4 * Math.ceil((this.top - FLOOR_EXPONENT) / 28);
    for (let exponent = gap * Math.ceil(FLOOR_EXPONENT / gap); exponent <= this.top; exponent += gap) {
      const y = Math.round(this.y(exponent)) + 0.5;
      paint.beginPath();
      paint.moveTo(margin.left, y);
      paint.lineTo(width - margin.right, y);
      paint.stroke();
      paint.fillText(exponent === 0 ? "1" : powerOfTen(exponent), margin.left - 6, y);
    }
    paint.textAlign = "center";
    paint.textBaseline = "top";
    const spacing = roundSpacing((this.end - this.begin) / Math.max(2, Math.min(8, width / 90)));
    for (let k = Math.ceil(this.begin / spacing); k * spacing <= this.end * (1 + 1e-9); k++) {
      const text = String(Number((k * spacing).toPrecision(6)));
      paint.fillText(text, this.x(k * spacing), height - margin.bottom + 5);
    }
    paint.textAlign = "right";
    paint.fillText("time in s", width - margin.right, height - 15);
  }

  curve(columns, rows, k) {
    const { paint } = this;
    const { color, dash } = CURVES[k % CURVES.length];
    paint.strokeStyle = colorOf(color);
    paint.lineWidth = 1.8;
    paint.setLineDash(dash);
    paint.beginPath();
    for (let row = 0; row < rows; row++) {
      const deviation = columns[7 * row + 1 + k];
      const exponent = deviation > 0 ? Math.max(Math.log10(deviation), FLOOR_EXPONENT) : FLOOR_EXPONENT;
      paint.lineTo(this.x(columns[7 * row]), this.y(exponent));
    }
    paint.stroke();
  }
}
