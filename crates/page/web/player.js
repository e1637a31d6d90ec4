// Playing: steps within a budget of time, then the pictures.

/** The time for computing in a frame, ms; a frame of 60 in a second has 16.7. */
const BUDGET = 7;
/** The steps between two looks at the clock. */
const CHUNK = 8;
/** The most pieces of a frame: after each the trace gets a point. */
const MOST_PIECES = 32;
/** The most points of the trace of the centre of mass; the least and the most distance between two of them. */
const MOST_TRACE = 500;
const TRACE_SPACING = 0.025;
const MOST_CHORD = 0.8;

/** The opening of a page without wishes in its address: the method changes at a time, s, so that a difference shows at once. */
const OPENING = { time: 2.5, method: "explicit-midpoint" };

class Player {
  constructor(library, form) {
    Object.assign(this, { library, form, playing: false, interrupted: false, pending: false, catchUp: 0, dirty: true });
    this.scene = new Scene(byId("scene"), [1, 1, 1], 1);
    this.deviations = new DeviationChart(byId("chart"));
    this.section = new SectionChart(byId("section"));
    this.table = new InvariantTable(byId("invariants"));
    this.frames = new FrameCounter(byId("frames"));
    this.chartsDrawn = -Infinity;
  }

  /** Throws the top of the form. Returns whether it could be thrown. It moves on if a failure has stopped it. */
  throwTop() {
    const { interrupted } = this;
    return this.trying(() => {
      const parameters = this.form.read();
      try {
        this.form.scaleFriction(parameters);
        this.library.throwTop(parameters, this.form.method, this.form.step, this.form.friction);
      } catch (error) {
        throw new Error(this.form.explain(error.message));
      }
      this.parameters = parameters;
      this.center = unit(parameters.center);
      this.restart();
      this.changeSection();
      if (interrupted) this.toggle(true);
    });
  }

  /** Throws the top from a point of the section, and lets it move. */
  beginOrbit(x, y) {
    this.library.attempt("begin_orbit", x, y);
    this.library.describeInvariants();
    this.restart();
    this.toggle(true);
  }

  /** What begins anew with each throw. */
  restart() {
    this.opens = false;
    Object.assign(this, { shown: 0, tip: [], catchUp: 0, largest: 0 });
    this.changes = [this.change(0)];
    this.scene.show(this.parameters.inertia, 1);
    this.say();
    this.redraw();
  }

  changeMethod(method) {
    this.opens = false;
    this.trying(() => {
      this.library.attempt("change_method", method, this.shown);
      this.noteChange();
    });
  }

  changeFriction(friction) {
    this.opens = false;
    this.trying(() => {
      this.library.attempt("change_friction", friction, this.shown);
      this.library.describeInvariants();
      this.noteChange();
      this.sayOfSection();
    });
  }

  /** The method and the friction from a time on. */
  change(time) {
    return { time, method: this.form.method, friction: this.form.friction > 0 };
  }

  /** Notes the method and the friction from now on, if they are others. */
  noteChange() {
    const change = this.change(this.shown);
    if (this.changes.at(-1).time === this.shown) this.changes.pop();
    const last = this.changes.at(-1);
    if (last?.method !== change.method || last.friction !== change.friction) this.changes.push(change);
  }

  changeStep(step) {
    this.opens = false;
    this.trying(() => this.library.attempt("change_step", step));
  }

  changeSection() {
    this.section.clear(this.form.coordinate);
    [byId("section-x").textContent, byId("section-y").textContent] = this.section.names;
    try {
      this.library.attempt("change_section", this.form.coordinate);
      this.sectionTrouble = undefined;
    } catch (error) {
      // The top moves on without a section.
      this.sectionTrouble = error.message;
    }
    this.sayOfSection();
    this.redraw();
  }

  sayOfSection() {
    this.section.say(this.sectionTrouble ?? (this.form.friction > 0 ? SECTION_WITH_FRICTION : SECTION_HELP));
  }

  measureAnew() {
    this.trying(() => {
      this.library.attempt("measure_anew");
      this.library.describeInvariants();
      this.changes = [this.change(this.library.time)];
    });
  }

  /** Does something that can fail. Then the top stops, and the message is on the page. */
  trying(task) {
    try {
      task();
      this.say();
      this.redraw();
      return true;
    } catch (error) {
      this.interrupt(error.message);
      return false;
    }
  }

  /** Shows a message, or none. */
  say(message = "") {
    byId("trouble").hidden = !message;
    byId("trouble").textContent = message;
  }

  /** Stops the top with a message. The next throw lets it move on if it has moved. */
  interrupt(message) {
    const interrupted = this.playing || this.interrupted;
    this.toggle(false);
    this.interrupted = interrupted;
    this.say(message);
  }

  toggle(playing = !this.playing) {
    Object.assign(this, { playing, interrupted: false, last: undefined });
    this.frames.restart();
    byId("play").textContent = playing ? "Pause" : "Play";
    if (playing) this.say();
    this.redraw();
  }

  redraw() {
    this.dirty = true;
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.pending = false;
    const before = performance.now();
    if (this.playing) {
      // A page that was hidden goes on where it was.
      const passed = Math.min((now - (this.last ?? now)) / 1000, 0.1);
      this.last = now;
      const catchesUp = () => this.catchUp > this.shown;
      try {
        // The way to a time that is asked for goes second by second, so that the trace has points enough.
        do this.proceed(catchesUp() ? Math.min(this.catchUp, this.shown + 1) : this.shown + passed * this.form.speed, before);
        while (catchesUp() && performance.now() - before < BUDGET);
      } catch (error) {
        // After a semicolon the library advises those who write programs.
        const [what] = error.message.split("; ");
        this.interrupt(`${what}. The top has stopped before this step: choose another method, a shorter step or another throw.`);
      }
    }
    if (this.opens && this.shown >= OPENING.time) {
      const method = METHODS.findIndex(({ name }) => name === OPENING.method);
      this.form.choose("method", method);
      this.changeMethod(method);
    }
    this.draw(now);
    if (this.playing) this.frames.count(now, performance.now() - before, this.library.show().steps);
    if (this.shown >= this.pauseAt) {
      this.pauseAt = undefined;
      this.toggle(false);
    }
    if (this.playing) this.redraw();
  }

  /** Makes the steps up to a time, as many as the budget allows, and shows the top there. */
  proceed(target, begin) {
    const { library } = this;
    const pieces = Math.min(Math.max(Math.ceil((target - this.shown) * this.rate / 0.1), 1), MOST_PIECES);
    const from = this.shown;
    for (let k = 1, late = false; k <= pieces && !late; k++) {
      const time = from + (target - from) * k / pieces;
      while (library.time < time && !late) {
        library.attempt("advance", time, CHUNK);
        late = performance.now() - begin > BUDGET;
      }
      this.shown = Math.min(time, library.time);
      this.follow(library.show(this.shown));
    }
  }

  /** How fast the body turns at most, rad/s. */
  get rate() {
    const { pi } = this.state ?? this.library.show();
    return Math.max(...pi.map((x, i) => Math.abs(x / this.parameters.inertia[i])));
  }

  /** Takes a state, unless it is not finite, and adds the tip to the trace. */
  follow(state) {
    if (![...state.pi, ...state.gamma, ...state.attitude].every(Number.isFinite)) throw new Error("the state is not finite");
    this.state = state;
    const tip = rotate(state.attitude, this.center);
    const last = this.tip.at(-1);
    const way = last ? norm(plus(tip, times(-1, last))) : Infinity;
    // Where the top moves too fast for a trace, none is better than a wrong one.
    if (way > MOST_CHORD) this.tip = [];
    if (way > TRACE_SPACING) this.tip.push(tip);
    if (this.tip.length > MOST_TRACE) this.tip.shift();
  }

  draw(now) {
    if (this.shown === undefined) return;
    const state = this.library.show(this.shown);
    if (![...state.pi, ...state.gamma, ...state.attitude].every(Number.isFinite)) return;
    const { attitude, pi, gamma } = state;
    const size = norm(pi);
    // The longest arrow is the largest angular momentum since the throw.
    if (size > this.largest) this.largest = size;
    this.scene.momentumScale = 1.3 / (this.largest || 1);
    // A vertical that has become very long is cut off.
    const vertical = times(Math.min(1, 1.6 / (norm(gamma) || 1)), rotate(attitude, gamma));
    const tip = rotate(attitude, this.center);
    this.scene.draw({ attitude, tip, vertical, momentum: rotate(attitude, pi) }, [...this.tip, tip], true);
    byId("clock").textContent = `t = ${this.shown.toFixed(2)} s`;
    // Charts and numbers ten times a second: faster ones nobody reads.
    if (this.dirty && (now - this.chartsDrawn > 90 || !this.playing)) {
      this.chartsDrawn = now;
      this.dirty = false;
      const { columns, points, values } = state;
      this.deviations.draw(this.library.columns(columns), values.length, this.changes);
      this.section.draw(this.library.points(points));
      byId("section").setAttribute("aria-label", `The Poincaré section with ${points} points.`);
      this.table.draw(this.library.invariants, state);
    }
  }
}
