// The top in space: strokes, faces and balls, drawn from the farthest to the nearest.

const AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const AXIS_NAMES = ["e₁", "e₂", "e₃"];
const FLOOR = -1.22;
const LIGHT = unit([0.35, -0.5, 0.8]);

class Scene {
  /** A body that stands has a post below its support; a free one has none. */
  constructor(canvas, inertia, largestMomentum, stands = true) {
    this.canvas = canvas;
    this.stands = stands;
    this.camera = new Camera();
    this.paint = canvas.getContext("2d");
    this.show(inertia, largestMomentum);
  }

  /** Shows a body with these moments, with an arrow of full length for this angular momentum. */
  show(inertia, largestMomentum) {
    this.faces = ellipsoid(inertia);
    this.momentumScale = 1.3 / (largestMomentum || 1);
  }

  /** Draws a state and the way of the tip up to it, which fades if it began before. */
  draw(state, trace, fades) {
    const { paint, canvas, camera } = this;
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    paint.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint.clearRect(0, 0, width, height);
    paint.lineJoin = "round";
    this.colors = getComputedStyle(document.documentElement);
    camera.look(width, height);
    this.items = [];
    this.labels = [];

    this.surroundings();
    this.body(state);
    this.trace(trace, fades);
    this.arrow(times(1.3, state.vertical), "--ink", "Γ", 3);
    this.arrow(times(this.momentumScale, state.momentum), "--momentum", "Π", 3.5);

    this.items.sort((a, b) => (a.near < b.near ? -1 : a.near > b.near ? 1 : 0));
    for (const item of this.items) item.draw();
    for (const label of this.labels) label();
    paint.globalAlpha = 1;
  }

  color(name) {
    return this.colors.getPropertyValue(name).trim();
  }

  /** A polyline in space. Each piece, up to three segments of a long line, has a nearness and an opacity of its own. */
  stroke(points, name, thickness, opacity) {
    const color = this.color(name);
    const places = points.map((point) => this.camera.project(point));
    const size = Math.min(Math.ceil(places.length / 200), 3);
    // A bit longer than it is, which closes the seams between pieces.
    const beyond = (a, b) => {
      const seam = 0.3 / (Math.hypot(b.x - a.x, b.y - a.y) || 1);
      return [b.x + seam * (b.x - a.x), b.y + seam * (b.y - a.y)];
    };
    for (let first = 0; first < places.length - 1; first += size) {
      const last = Math.min(first + size, places.length - 1);
      const near = (places[first].near + places[last].near) / 2;
      this.items.push({
        near,
        draw: () => {
          const { paint } = this;
          paint.globalAlpha = typeof opacity === "function" ? opacity(near, last / (places.length - 1)) : opacity;
          paint.strokeStyle = color;
          paint.lineWidth = thickness;
          paint.beginPath();
          paint.moveTo(...beyond(places[first + 1], places[first]));
          for (let i = first + 1; i < last; i++) paint.lineTo(places[i].x, places[i].y);
          paint.lineTo(...beyond(places[last - 1], places[last]));
          paint.stroke();
        },
      });
    }
  }

  /** A polyline about the body, as two lines: its farther half behind everything, its nearer half before everything. */
  halves(points, name, thickness, opacities) {
    const places = points.map((point) => this.camera.project(point));
    const color = this.color(name);
    opacities.forEach((opacity, half) => {
      const draw = () => {
        const { paint } = this;
        paint.globalAlpha = opacity;
        paint.strokeStyle = color;
        paint.lineWidth = thickness;
        paint.beginPath();
        let inside = false;
        for (let i = 1; i < places.length; i++) {
          const [a, b] = [places[i - 1], places[i]];
          const belongs = (a.near + b.near > 0) === (half === 1);
          if (belongs && !inside) paint.moveTo(a.x, a.y);
          if (belongs) paint.lineTo(b.x, b.y);
          inside = belongs;
        }
        paint.stroke();
      };
      this.items.push({ near: half === 1 ? Infinity : -Infinity, draw });
    });
  }

  /** The sphere of directions with meridians and parallels, and for a body that stands the support and the floor. */
  surroundings() {
    const circle = (f) => Array.from({ length: 61 }, (_, i) => f(2 * Math.PI * i / 60));
    for (let k = 0; k < 6; k++) {
      const [c, s] = [Math.cos(k * Math.PI / 6), Math.sin(k * Math.PI / 6)];
      this.halves(circle((a) => [c * Math.cos(a), s * Math.cos(a), Math.sin(a)]), "--sphere", 1, [0.13, 0.3]);
    }
    for (let k = -2; k <= 2; k++) {
      const [r, z] = [Math.cos(k * Math.PI / 6), Math.sin(k * Math.PI / 6)];
      this.halves(circle((a) => [r * Math.cos(a), r * Math.sin(a), z]), "--sphere", k === 0 ? 1.4 : 1, [0.13, 0.3]);
    }
    if (!this.stands) return;
    for (const r of [0.2, 0.5]) {
      this.halves(circle((a) => [r * Math.cos(a), r * Math.sin(a), FLOOR]), "--quiet", 1.2, [0.45, 0.45]);
    }
    this.stroke(pieces([0, 0, FLOOR], [0, 0, 0]), "--quiet", 2.5, 0.75);
  }

  /** The ellipsoid, the principal axes, and the rod to the centre of mass. */
  body({ attitude, tip }) {
    const tints = [this.color("--body"), this.color("--body-other")].map(channels);
    for (const face of this.faces) {
      const corners = face.corners.map((corner) => rotate(attitude, corner));
      const normal = rotate(attitude, face.normal);
      // What looks away is hidden by what does not.
      if (dot(normal, this.camera.place) < dot(normal, corners[1])) continue;
      const places = corners.map((corner) => this.camera.project(corner));
      const light = 0.62 + 0.38 * dot(normal, LIGHT);
      const color = `rgb(${tints[face.tint].map((channel) => Math.round(channel * light)).join(",")})`;
      const near = places.reduce((sum, place) => sum + place.near, 0) / places.length;
      this.items.push({ near, draw: () => this.fill(places, color) });
    }
    AXES.forEach((axis, i) => {
      const name = ["--first", "--second", "--third"][i];
      this.arrow(times(0.76, rotate(attitude, axis)), name, AXIS_NAMES[i], 2.5);
    });
    this.stroke(pieces([0, 0, 0], tip), "--tip", 3, 0.9);
    this.ball(tip, 0.05, "--tip");
    this.label(tip, "c", "--tip", true);
    this.ball([0, 0, 0], 0.028, "--ink");
  }

  fill(places, color) {
    const { paint } = this;
    paint.globalAlpha = 1;
    paint.fillStyle = paint.strokeStyle = color;
    // The stroke closes the seams between faces.
    paint.lineWidth = 0.7;
    paint.beginPath();
    for (const { x, y } of places) paint.lineTo(x, y);
    paint.closePath();
    paint.fill();
    paint.stroke();
  }

  /** The way of the tip on the sphere, up to now. */
  trace(points, fades) {
    const opacity = (near, share) => (near > 0 ? 1 : 0.4) * (fades ? share ** 0.8 : 0.8);
    this.stroke(points, "--tip", fades ? 2.2 : 1.5, opacity);
  }

  /** A vector at the support. */
  arrow(vector, name, text, thickness) {
    const [from, to] = [this.camera.project([0, 0, 0]), this.camera.project(vector)];
    this.stroke(pieces([0, 0, 0], vector), name, thickness, 1);
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    if (length > 3) {
      const [ux, uy] = [(to.x - from.x) / length, (to.y - from.y) / length];
      const [long, broad] = [Math.min(4 * thickness, length), 1.55 * thickness];
      const corner = (along, across) => ({ x: to.x + along * ux - across * uy, y: to.y + along * uy + across * ux });
      const corners = [corner(0.3 * long, 0), corner(-long, broad), corner(-long, -broad)];
      const color = this.color(name);
      this.items.push({ near: to.near, draw: () => this.fill(corners, color) });
    }
    this.label(vector, text, name);
  }

  ball(center, radius, name) {
    const place = this.camera.project(center);
    const color = this.color(name);
    const draw = () => {
      const { paint } = this;
      paint.globalAlpha = 1;
      paint.fillStyle = color;
      paint.beginPath();
      paint.arc(place.x, place.y, radius * place.scale, 0, 2 * Math.PI);
      paint.fill();
    };
    // In front of what is inside it.
    this.items.push({ near: place.near + radius, draw });
  }

  /** A name beyond the end of a vector, or beside it, over everything. */
  label(vector, text, name, beside = false) {
    const [from, to] = [this.camera.project([0, 0, 0]), this.camera.project(vector)];
    const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
    const [ux, uy] = [(to.x - from.x) / length, (to.y - from.y) / length];
    const [x, y] = beside ? [to.x - 20 * uy, to.y + 20 * ux] : [to.x + 15 * ux, to.y + 15 * uy];
    const [color, halo] = [this.color(name), this.color("--card")];
    this.labels.push(() => {
      const { paint } = this;
      paint.globalAlpha = 1;
      paint.font = "600 16px system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif";
      paint.textAlign = "center";
      paint.textBaseline = "middle";
      paint.lineWidth = 4;
      paint.strokeStyle = halo;
      paint.strokeText(text, x, y);
      paint.fillStyle = color;
      paint.fillText(text, x, y);
    });
  }
}

/** A straight line in pieces, each of which can be behind something or before it. */
function pieces(from, to, count = 24) {
  return Array.from({ length: count + 1 }, (_, i) => mix(from, to, i / count));
}

/** Red, green and blue of #rrggbb. */
function channels(color) {
  return [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16));
}
