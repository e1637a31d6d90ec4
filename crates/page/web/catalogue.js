// The tops and the methods to choose from.

/** The methods, in the order of the library. */
const METHODS = [
  { name: "gauss-4", label: "Gauss, order 4", poisson: true },
  { name: "gauss-6", label: "Gauss, order 6", poisson: true },
  { name: "gauss-8", label: "Gauss, order 8", poisson: true },
  { name: "gauss-12", label: "Gauss, order 12", poisson: true },
  { name: "gauss-16", label: "Gauss, order 16", poisson: true },
  { name: "midpoint", label: "Midpoint rule", poisson: true },
  { name: "strang", label: "Splitting, order 2", poisson: true },
  { name: "suzuki-4", label: "Splitting, order 4", poisson: true },
  { name: "rk4", label: "Runge–Kutta, order 4", poisson: false },
  { name: "explicit-midpoint", label: "Explicit midpoint", poisson: false },
];

/** The tops: moments in kg m², m g l in N m, angles in degrees, Π in kg m²/s; the coordinate of the section. */
const TOPS = [
  {
    name: "kovalevskaya", label: "Kovalevskaya", inertia: [2, 2, 1], weight: 1, center: [1, 0, 0],
    tilt: 30, turn: 0, momentum: [2, 3, 4], section: 3,
    says: "I₁ = I₂ = 2 I₃, and the centre of mass lies at right angles to e₃. K is a fourth invariant.",
  },
  {
    name: "lagrange", label: "Lagrange", inertia: [1, 1, 0.4], weight: 3, center: [0, 0, 1],
    tilt: 35, turn: 0, momentum: [0, 0, 6], section: 3,
    says: "The toy top: symmetric about the axis that carries the centre of mass. The spin f₃ = Π₃ is a fourth invariant.",
  },
  {
    name: "goryachev-chaplygin", label: "Goryachev–Chaplygin", inertia: [4, 4, 1], weight: 1, center: [1, 0, 0],
    tilt: 90, turn: 0, momentum: [0, 2, 1.5], section: 5,
    says: "I₁ = I₂ = 4 I₃. G is a fourth invariant where Π·Γ = 0, as in this throw.",
  },
  {
    name: "euler", label: "Euler", inertia: [1, 2, 2.5], weight: 0, center: [0, 0, 1],
    tilt: 20, turn: 0, momentum: [0.05, 4, 0.05], section: 5,
    says: "No gravity. A spin about the middle axis e₂ is unstable: the body tumbles.",
  },
  {
    name: "own", label: "Your own", inertia: [1, 1.5, 2], weight: 1.5, center: [0.6, 0, 0.8],
    tilt: 60, turn: 40, momentum: [0.5, 1, 1.5], section: 5,
    says: "Three different moments: no fourth invariant, and chaos at most energies. The numbers below are yours to change.",
  },
];

/** The steps of the slider, s. */
const STEPS = [0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1];

/**
 * The frictions of the slider: the share of its angular velocity that the body loses while it turns by 1 rad as fast as at
 * the throw.
 */
const FRICTIONS = [0, 0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5];

/** Seconds of the motion in a second of watching. */
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, 200];

/** What the invariants are called. */
const INVARIANT_NAMES = {
  h: "energy", f1: "|Γ|²", f2: "Π·Γ", f3: "spin Π₃", K: "Kovalevskaya’s", G: "Goryachev–Chaplygin’s",
};

/** The colours of the curves and their dashes, so that no curve is known by its colour alone. */
const CURVES = [
  { color: "--third", dash: [] }, { color: "--second", dash: [7, 3] }, { color: "--first", dash: [2, 3] },
  { color: "--momentum", dash: [9, 3, 2, 3] }, { color: "--tip", dash: [] }, { color: "--quiet", dash: [] },
];

/** The vertical Γ seen from the body: e₃ is tilted from it, and the body is then turned about e₃; degrees. */
function verticalOf(tilt, turn) {
  const [a, b] = [tilt, turn].map((degrees) => degrees * Math.PI / 180);
  return [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)];
}
