// The Poincaré section, which fills as the top moves.

const ORBIT_COLORS = ["--third", "--first", "--second", "--momentum", "--tip", "--ink"];

const SECTION_HELP = "Each passage is a point; a higher speed fills the section sooner. Click or tap in it, or press “New orbit”, "
  + "to throw the top from another point with the same energy and Π·Γ.";

const SECTION_WITH_FRICTION = "With friction the energy falls, so that the points of an orbit lie on no curve. They move to where the top comes to rest.";

/** The least bound with a short half that is not below. */
function roundBound(least) {
  const power = 10 ** Math.floor(Math.log10(least || 1));
  return power * [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((digit) => digit * power >= least);
}

class SectionChart {
  constructor(canvas) {
    this.canvas = canvas;
    this.margin = { left: 58, right: 12, top: 12, bottom: 36 };
    this.clear(5);
  }

  /** Forgets the points; the coordinate with this number is 0 on the surface from now on. */
  clear(coordinate) {
    this.coordinate = coordinate;
    [this.drawn, this.bound, this.stale] = [0, 0, true];
  }

  say(text) {
    byId("section-says").textContent = text;
  }

  /** The names of the two coordinates of the plane. */
  get names() {
    const axis = "₁₂₃"[this.coordinate % 3];
    return [`angle of Γ about e${axis}, rad`, this.coordinate < 3 ? `Γ${axis}` : `Π${axis}, kg m²/s`];
  }

  /** Draws the points that are new; all of them where the scale, the size or the colours have changed. */
  draw(points) {
    const count = points.length / 3;
    let largest = 0;
    for (let i = this.drawn; i < count; i++) largest = Math.max(largest, Math.abs(points[3 * i + 1]));
    const { paint, width, height, changed } = sized(this.canvas);
    Object.assign(this, { paint, width, height });
    if (largest > this.bound) {
      this.bound = this.coordinate < 3 ? 1 : roundBound(1.02 * largest);
      this.stale = true;
    }
    if (changed || this.stale) {
      paint.clearRect(0, 0, width, height);
      this.axes();
      [this.drawn, this.stale] = [0, false];
    }
    const size = count > 20000 ? 1 : count > 4000 ? 1.5 : 2.2;
    let orbit;
    for (let i = this.drawn; i < count; i++) {
      const [x, y, number] = [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
      if (number !== orbit) paint.fillStyle = colorOf(ORBIT_COLORS[number % ORBIT_COLORS.length]);
      orbit = number;
      paint.fillRect(this.x(x) - size / 2, this.y(y) - size / 2, size, size);
    }
    this.drawn = count;
  }

  x(angle) {
    return this.margin.left + (this.width - this.margin.left - this.margin.right) * angle / (2 * Math.PI);
  }

  y(value) {
    const { top, bottom } = this.margin;
    return top + (this.height - top - bottom) * (1 - value / (this.bound || 1)) / 2;
  }

  /** The point of the plane at a place of the picture, in pixels. */
  pointAt(x, y) {
    const { left, right, top, bottom } = this.margin;
    const share = (y - top) / (this.height - top - bottom);
    return [2 * Math.PI * (x - left) / (this.width - left - right), (this.bound || 1) * (1 - 2 * share)];
  }

  axes() {
    const { paint, margin, width, height } = this;
    paint.strokeStyle = colorOf("--rule");
    paint.lineWidth = 1;
    paint.strokeRect(margin.left + 0.5, margin.top + 0.5, width - margin.left - margin.right, height - margin.top - margin.bottom);
    paint.fillStyle = colorOf("--quiet");
    paint.textAlign = "center";
    paint.textBaseline = "top";
    ["0", "π/2", "π", "3π/2", "2π"].forEach((text, i) => {
      paint.fillText(text, this.x(i * Math.PI / 2), height - margin.bottom + 5);
    });
    paint.textAlign = "right";
    paint.textBaseline = "middle";
    const bound = this.bound || 1;
    for (const value of [-1, -0.5, 0, 0.5, 1]) {
      paint.fillText(readable(value * bound, 3), margin.left - 6, this.y(value * bound));
    }
  }
}
