// Playing, and what keys and pointers do.

const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10];
const MOST_TRACE = 6000;
const PLAY = "M7 4v16l13-8z";
const PAUSE = "M6 4h4v16H6zm8 0h4v16h-4z";

class Player {
  constructor(motion) {
    this.motion = motion;
    this.scene = new Scene(byId("scene"), motion.inertia, motion.largestMomentum(), motion.weight > 0);
    for (const part of document.querySelectorAll(".of-top, .of-free")) {
      part.hidden = part.classList.contains("of-free") === motion.weight > 0;
    }
    this.strip = new Strip(byId("strip"), motion);
    [this.time, this.playing, this.pending] = [0, false, false];
    byId("description").textContent = motion.description;
    byId("values").textContent = `${motion.top}, 0 to ${readable(motion.direction * motion.end, 6)} s`;
    // The slider counts the part of the motion that has passed; not every browser has room for tiny steps.
    byId("time").max = 1;
    // Four digits, at least two of them decimals.
    const decimals = Math.min(Math.max(4 - Math.ceil(Math.log10(motion.end || 1)), 2), 12);
    const { exponent } = notation(motion.end, 0);
    this.clock = exponent < -3
      ? (time) => `${motion.sign(time)}${shifted(time, exponent).toFixed(4)} · ${powerOfTen(exponent)} s`
      : (time) => `${motion.sign(time)}${time.toFixed(decimals)} s`;
    this.momentum = notation(motion.largestMomentum(), 4);
    this.event = happening(motion);
    const speed = pace(motion, this.event.seconds);
    this.speeds = speeds(speed);
    byId("speed").replaceChildren(...this.speeds.map((speed) => new Option(`${readable(speed, 3)} ×`, speed)));
    byId("speed").selectedIndex = this.speeds.indexOf(speed);
    const traces = [["short", 2], ["long", 15], ["longest", Infinity]];
    byId("trace").replaceChildren(...traces.map(([name, seconds]) => new Option(name, seconds)));
    byId("trace").selectedIndex = 1;
    this.show();
  }

  get speed() {
    return Number(byId("speed").value);
  }

  /** The frames of the trace: so many seconds of watching, and no more than are drawn in time. */
  get traceFrames() {
    const seconds = Number(byId("trace").value) * this.speed;
    return Math.min(Math.ceil(seconds * this.motion.frames / (this.motion.end || 1)), MOST_TRACE);
  }

  go(time) {
    this.time = Math.min(Math.max(time, 0), this.motion.end);
    this.show();
  }

  toggle(playing = !this.playing) {
    if (playing && this.time >= this.motion.end) this.time = 0;
    this.playing = playing;
    this.last = undefined;
    this.show();
  }

  /** Draws once, before the screen is next refreshed; while it plays, again and again. */
  show() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame((now) => {
      this.pending = false;
      if (this.playing) {
        // A page that was hidden goes on where it was.
        const passed = Math.min((now - (this.last ?? now)) / 1000, 0.1);
        this.last = now;
        this.time = Math.min(this.time + passed * this.speed, this.motion.end);
        if (this.time >= this.motion.end) this.playing = false;
      }
      this.draw();
      if (this.playing) this.show();
    });
  }

  draw() {
    const state = this.motion.at(this.time);
    this.scene.draw(state, this.motion.trace(state, this.traceFrames), this.traceFrames < this.motion.frames);
    this.strip.draw(state);
    const clock = this.clock(this.time);
    byId("time").value = this.time / (this.motion.end || 1);
    byId("time").setAttribute("aria-valuetext", clock);
    byId("clock").textContent = `${clock} of ${readable(this.motion.direction * this.motion.end, 6)} s`;
    const { name, seconds } = this.event;
    byId("pace").textContent = `${name} takes ${readable(seconds, 3)} s, and ${readable(seconds / this.speed, 2)} s here, `
      + `at ${readable(this.speed, 3)} × real time.`;
    byId("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
    byId("play").querySelector("path").setAttribute("d", this.playing ? PAUSE : PLAY);
    this.table(state);
  }

  /** The state in numbers, Π and Γ in the body frame. */
  table({ pi, gamma, invariants }) {
    const rows = [
      ...pi.map((value, i) => [`Π${"₁₂₃"[i]}`, this.momentum.text(value), this.momentum.unit("kg m²/s")]),
      ...gamma.map((value, i) => [`Γ${"₁₂₃"[i]}`, value.toFixed(4), ""]),
      ...invariants.map((value, i) => {
        const { symbol, unit } = this.motion.invariants[i];
        return [pretty(symbol), readable(value, 9), unit];
      }),
    ];
    const table = byId("now");
    while (table.rows.length < rows.length) {
      const row = table.insertRow();
      row.append(document.createElement("th"), document.createElement("td"), document.createElement("td"));
      row.cells[0].scope = "row";
    }
    rows.forEach((texts, i) => texts.forEach((text, k) => {
      table.rows[i].cells[k].textContent = text.replace("-", "−");
    }));
  }

  /** What a key does; nothing for most. */
  action({ key, shiftKey }) {
    const { motion, scene: { camera } } = this;
    const frame = (by) => motion.time(Math.min(Math.max(motion.frameAt(this.time) + by, 0), motion.frames - 1));
    const skip = (sign) => () => {
      if (shiftKey) return this.go(this.time + sign * this.speed);
      this.toggle(false);
      this.go(frame(sign));
    };
    const faster = (by) => () => {
      const select = byId("speed");
      select.selectedIndex = Math.min(Math.max(select.selectedIndex + by, 0), this.speeds.length - 1);
      this.show();
    };
    const actions = {
      " ": () => this.toggle(), ArrowRight: skip(1), ArrowLeft: skip(-1), ArrowUp: faster(1), ArrowDown: faster(-1),
      Home: () => this.go(0), End: () => this.go(motion.end),
      ...viewKeys(camera, () => this.show()),
    };
    return actions[key.length === 1 ? key.toLowerCase() : key];
  }

  listen() {
    byId("play").addEventListener("click", () => this.toggle());
    byId("time").addEventListener("input", (event) => this.go(Number(event.target.value) * this.motion.end));
    for (const id of ["speed", "trace"]) byId(id).addEventListener("change", () => this.show());
    document.addEventListener("keydown", (event) => {
      const { target } = event;
      // Lists have their own keys, and so has the button for the space bar.
      const taken = target.tagName === "SELECT" || (target.tagName === "BUTTON" && event.key === " ");
      const action = taken || event.ctrlKey || event.altKey || event.metaKey ? undefined : this.action(event);
      if (action) {
        event.preventDefault();
        action();
      }
    });

    const { canvas } = this.scene;
    viewByPointers(this.scene, () => this.show());
    const seek = (event) => this.go(this.strip.timeAt(event.offsetX));
    this.strip.canvas.addEventListener("pointerdown", seek);
    drag(this.strip.canvas, seek);

    new ResizeObserver(() => this.show()).observe(canvas);
    theme.onChange(() => {
      this.strip.prepare();
      this.show();
    });
  }
}

/** The speeds to choose from, in order: the usual ones, or some about it where these are all too fast or too slow, and it. */
function speeds(speed) {
  const middle = Math.floor(Math.log10(speed));
  const isUsual = speed >= SPEEDS[0] && speed <= 1000;
  const others = isUsual ? SPEEDS : [-1, 0, 1, 2].flatMap((by) => [1, 2, 5].map((digit) => Number(`${digit}e${middle + by}`)));
  return [...new Set([...others, speed])].sort((one, other) => one - other);
}

function start(motion) {
  if (motion.frames === 0) {
    byId("description").textContent = "There are no frames.";
    return;
  }
  const player = new Player(motion);
  player.listen();
  // page.html#t=12.5 shows that moment.
  const asked = /^#t=([-−]?[0-9.]+(?:e[-+]?[0-9]+)?)$/i.exec(location.hash);
  if (asked) player.go(motion.direction * Number(asked[1].replace("−", "-")));
  else if (!matchMedia("(prefers-reduced-motion: reduce)").matches) player.toggle(true);
}

start(new Motion(JSON.parse(byId("motion").textContent)));
