// How many frames a second are drawn, and how long they take.

class FrameCounter {
  constructor(output) {
    this.output = output;
    this.restart();
  }

  restart() {
    this.since = undefined;
  }

  /** Counts a frame that took so many milliseconds, after so many steps since the throw. Says once a second how it goes. */
  count(now, taken, steps) {
    if (this.since === undefined || steps < this.steps) {
      Object.assign(this, { since: now, frames: 0, steps, taken: 0, longest: 0 });
      return;
    }
    this.frames += 1;
    this.taken += taken;
    this.longest = Math.max(this.longest, taken);
    if (now - this.since < 1000) return;
    const rate = 1000 * this.frames / (now - this.since);
    this.output.textContent = `${rate.toFixed(0)} frames a second, ${readable((steps - this.steps) / this.frames, 3)} steps a frame; `
      + `a frame takes ${(this.taken / this.frames).toFixed(1)} ms, at most ${this.longest.toFixed(1)} ms.`;
    Object.assign(this, { since: now, frames: 0, steps, taken: 0, longest: 0 });
  }
}
