// Where the scene is seen from: about the support, e₃ upwards.

/** From the support to the eye; the sphere of directions has the radius 1. */
const DISTANCE = 7;

class Camera {
  constructor() {
    this.reset();
  }

  reset() {
    [this.azimuth, this.elevation, this.zoom] = [-0.95, 0.32, 1];
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(Math.max(this.elevation + elevation, -1.5), 1.5);
  }

  enlarge(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.4), 5);
  }

  /** Prepares a projection onto a picture of this size, in pixels. */
  look(width, height) {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    this.towards = [ce * ca, ce * sa, se];
    this.place = times(DISTANCE, this.towards);
    this.right = [-sa, ca, 0];
    this.up = [-se * ca, -se * sa, ce];
    this.center = [width / 2, height / 2];
    // The longest arrows reach 1.32 from the support, and their names 30 pixels further.
    const size = Math.min(width, height);
    this.scale = Math.min(0.33 * size, (size / 2 - 30) / 1.32) * this.zoom;
  }

  /** The point's place in the picture, its nearness (larger is nearer), and pixels per unit there. */
  project(point) {
    const near = dot(point, this.towards);
    const scale = this.scale * DISTANCE / (DISTANCE - near);
    return {
      x: this.center[0] + scale * dot(point, this.right),
      y: this.center[1] - scale * dot(point, this.up),
      near,
      scale,
    };
  }
}
