// The frames, and the motion between them.

class Motion {
  constructor({ description, top, inertia, weight, centerOfMass, invariants, numbers }) {
    Object.assign(this, { description, top, inertia, weight, centerOfMass });
    this.invariants = invariants.map(([symbol, unit]) => ({ symbol, unit }));
    this.width = 11 + invariants.length;
    const bytes = Uint8Array.from(atob(numbers), (character) => character.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    this.numbers = Float64Array.from({ length: bytes.length / 8 }, (_, i) => view.getFloat64(8 * i, true));
    this.frames = this.numbers.length / this.width;
    const last = this.frames > 0 ? this.number(this.frames - 1, 0) : 0;
    /** 1, or −1 if the motion goes backward in time. */
    this.direction = last < 0 ? -1 : 1;
    this.end = Math.abs(last);
  }

  number(frame, column) {
    return this.numbers[frame * this.width + column];
  }

  columns(frame, from, to) {
    return Array.from(this.numbers.subarray(frame * this.width + from, frame * this.width + to));
  }

  /** How far the motion has gone until a frame, s: |t|. */
  time(frame) {
    return this.direction * this.number(frame, 0);
  }

  /** The sign of the time t at which the motion has gone so far. */
  sign(time) {
    return this.direction < 0 && time > 0 ? "−" : "";
  }

  attitude(frame) {
    return this.columns(frame, 7, 11);
  }

  /** The last frame that is not after the time. */
  frameAt(time) {
    let [low, high] = [0, this.frames];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time(middle) <= time) low = middle;
      else high = middle;
    }
    return low;
  }

  /** The state at a time, between frames interpolated. */
  at(time) {
    const frame = this.frameAt(time);
    const next = Math.min(frame + 1, this.frames - 1);
    const gap = this.time(next) - this.time(frame);
    const share = gap > 0 ? Math.min((time - this.time(frame)) / gap, 1) : 0;
    const state = mix(this.columns(frame, 1, 7), this.columns(next, 1, 7), share);
    const attitude = slerp(this.attitude(frame), this.attitude(next), share);
    const [pi, gamma] = [state.slice(0, 3), state.slice(3)];
    return {
      time,
      frame,
      attitude,
      pi,
      gamma,
      momentum: rotate(attitude, pi),
      vertical: [0, 0, norm(gamma)],
      tip: rotate(attitude, this.centerOfMass),
      invariants: mix(this.columns(frame, 11, this.width), this.columns(next, 11, this.width), share),
    };
  }

  tip(frame) {
    return rotate(this.attitude(frame), this.centerOfMass);
  }

  /** The way of the tip over so many frames, up to the state. */
  trace({ frame, tip }, frames) {
    const points = [];
    for (let i = Math.max(0, frame - frames); i <= frame; i++) points.push(this.tip(i));
    points.push(tip);
    return points;
  }

  deviation(frame, index) {
    return this.number(frame, 11 + index) - this.number(0, 11 + index);
  }

  largestMomentum() {
    let largest = 0;
    for (let i = 0; i < this.frames; i++) largest = Math.max(largest, norm(this.columns(i, 1, 4)));
    return largest;
  }

  /** How fast the body turns, in the mean, rad/s. */
  meanRate() {
    let angle = 0;
    for (let i = 1; i < this.frames; i++) angle += angleBetween(this.attitude(i - 1), this.attitude(i));
    return this.end > 0 ? angle / this.end : 0;
  }
}
