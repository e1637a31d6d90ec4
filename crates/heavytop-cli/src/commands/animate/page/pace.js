// How fast the page shows the motion: so that what happens in it takes some ten seconds.

/** The seconds of watching for what happens. */
const WATCHED = 10;
/** The largest rate at which the body turns on the screen, rad/s; a faster one only flickers. */
const FASTEST = 25;

/**
 * What happens in a motion, in words, and how long it takes, s: the first precession of a top; a tumble of a free body,
 * after which the angular momentum has its first direction in the body again; a swing of what neither precesses nor
 * tumbles, or a turn.
 */
function happening(motion) {
  const rate = motion.meanRate();
  const events = [
    ["The first precession", () => (motion.weight > 0 ? precession(motion) : undefined)],
    ["A tumble", () => (motion.weight > 0 ? undefined : firstReturn(motion, 1))],
    ["A swing", () => (motion.weight > 0 ? firstReturn(motion, 4) : undefined)],
    ["A turn", () => (rate * motion.end >= 2 * Math.PI ? 2 * Math.PI / rate : undefined)],
  ];
  for (const [name, find] of events) {
    const seconds = find();
    if (seconds > 0) return { name, seconds };
  }
  return { name: "The run", seconds: motion.end };
}

/**
 * The time after which the centre of mass has gone around the vertical, or would have if the run, which shows a radian of it at
 * least, went on; undefined if it does not go round, or comes too near to the vertical.
 */
function precession(motion) {
  let [angle, last] = [0, undefined];
  for (let frame = 0; frame < motion.frames; frame++) {
    const [x, y] = motion.tip(frame);
    if (Math.hypot(x, y) < 1e-3) return undefined;
    const azimuth = Math.atan2(y, x);
    if (last !== undefined) {
      const step = azimuth - last;
      const turn = step - 2 * Math.PI * Math.round(step / (2 * Math.PI));
      // A pendulum has passed the vertical.
      if (Math.abs(turn) > 2) return undefined;
      angle += turn;
    }
    last = azimuth;
    if (Math.abs(angle) >= 2 * Math.PI) return motion.time(frame);
  }
  return Math.abs(angle) >= 1 ? motion.end * 2 * Math.PI / Math.abs(angle) : undefined;
}

/** The time at which the vector in three columns first comes back near its start; undefined if it hardly leaves it. */
function firstReturn(motion, column) {
  const vector = (frame) => motion.columns(frame, column, column + 3);
  const start = vector(0);
  const distance = (frame) => norm(vector(frame).map((value, i) => value - start[i]));
  let farthest = 0;
  for (let frame = 0; frame < motion.frames; frame++) farthest = Math.max(farthest, distance(frame));
  if (!(farthest > 1e-3 * norm(start))) return undefined;
  let [left, nearest, found] = [false, Infinity, undefined];
  for (let frame = 0; frame < motion.frames; frame++) {
    const now = distance(frame);
    left ||= now > farthest / 2;
    if (!left) continue;
    if (now < farthest / 4 && now < nearest) [nearest, found] = [now, motion.time(frame)];
    else if (found !== undefined && now > farthest / 4) return found;
  }
  return found;
}

/** The speed, of two digits, at which something that takes so many seconds is shown in ten, and the body does not flicker. */
function pace(motion, seconds) {
  const speed = Math.min(seconds / WATCHED, FASTEST / (motion.meanRate() || 1e-300));
  return speed > 0 && Number.isFinite(speed) ? Number(speed.toPrecision(2)) : 1;
}
