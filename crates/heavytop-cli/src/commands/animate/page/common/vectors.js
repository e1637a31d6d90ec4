// Vectors are arrays of three numbers, unit quaternions arrays of four, the scalar first.

const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);
const unit = (a) => times(1 / (norm(a) || 1), a);
const mix = (a, b, s) => a.map((x, i) => x + s * (b[i] - x));

/** R v, for the rotation R of the quaternion. */
function rotate([w, ...u], v) {
  const t = times(2, cross(u, v));
  return plus(plus(v, times(w, t)), cross(u, t));
}

/** The rotation on the shortest way from p to q, s of it gone. q and −q are the same rotation. */
function slerp(p, q, s) {
  let cosine = p.reduce((sum, x, i) => sum + x * q[i], 0);
  const near = cosine < 0 ? q.map((x) => -x) : q;
  cosine = Math.min(Math.abs(cosine), 1);
  const angle = Math.acos(cosine);
  if (angle < 1e-4) return mix(p, near, s);
  const [a, b] = [Math.sin((1 - s) * angle), Math.sin(s * angle)].map((x) => x / Math.sin(angle));
  return p.map((x, i) => a * x + b * near[i]);
}

/** The angle between two rotations, rad. */
function angleBetween(p, q) {
  return 2 * Math.acos(Math.min(1, Math.abs(p.reduce((sum, x, i) => sum + x * q[i], 0))));
}
