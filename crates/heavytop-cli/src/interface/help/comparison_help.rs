//! The long texts of `--help` of the commands that compare integrators.

pub(crate) const COMPARE: &str = "\
Measure work against precision, for every formulation and scheme.

The top of the configuration is followed by each of them with twelve steps, from fifty times the
configured one to a tenth of it. The interval is 500 configured steps, or the whole run if that is
shorter; --end sets another end. Over longer times the errors of a chaotic top say more about the
top than about the integrators. formulation, scheme and output of the configuration play no part;
tolerance does.

The error is that of (Π, Γ) at the end, against a Gauss method of order 16 without a lift at half
the configured step; if that with the whole step differs by more than 1e-11, the command fails. Π
and Γ have different units: the error is the 2-norm of |δΠ| / max |Π| and |δΓ| / max |Γ|, which does
not depend on them. The figure shows the larger of the two, and the table has all three and the
parts. The time is the wall-clock time for one simulated second, (Π, Γ) read after each step, the
best of at least three repetitions; it is of your machine, so let it rest meanwhile.

Written into the folder:
  work-precision.svg .png  error against time: in colour the method of each formulation that is the
                           fastest at the most errors, and the best of the others; these in grey
  work-precision.csv       formulation,scheme,step,end,error,seconds,h,f1,f2, the last three the
                           largest deviations, then error_Pi (kg m²/s), error_Gamma,
                           relative_error; NaN where a step had no result
Printed: for some accuracies the fastest method that reaches them, and the fastest Poisson one.

Of the midpoint rule strang is the rule itself, and is listed as implicit-midpoint.";

pub(crate) const COMPARE_EXAMPLES: &str = "\
Examples:
  heavytop compare --out comparison               # the paper's top
  heavytop compare --preset lagrange --out comparison
  heavytop compare top.toml --end 2 --out comparison
  heavytop compare top.toml --out comparison --json";

pub(crate) const BENCH: &str = "\
Time the integrators on one top and on many.

The configured top is followed to t = 1000 s, and an ensemble of starts about its own to t = 20 s,
by each fast path and by the general one, which serves any system. For each: the least computing
time of several runs (ms), that per top and step (ns), and the error of (Π, Γ) at t = 10 s and at
the end: the larger of that of Π relative to |Π| and that of Γ relative to |Γ|, in an ensemble the
mean over at most 10000 tops. --json also tells the 2-norm of the error in SI units (error_10,
error_end), as in the tables of other programs. References are by the collective Gauss method of
order 16 with step 1/8 s.

A problem file is text: I1 I2 I3 mgl c1 c2 c3 end on the first line (kg m², N m, s), and on each
other line a top: (Π, Γ) at t = 0, t = 10 and end.";

pub(crate) const BENCH_EXAMPLES: &str = "\
Examples:
  heavytop bench                                  # the paper's top
  heavytop bench top.toml --threads 2
  heavytop bench --only midpoint --json
  heavytop bench --only \"splitting of order 4\" --tops 10000000";

pub(crate) const REPORT: &str = "\
Tell the precession, nutation and spin of a top, beside the formulas of textbooks.

The top of the configuration is followed, with its method, to its end; a step that is left out is
0.02 s, or one in which the top turns by 0.5 rad where that turns it by more than 1 rad. The angles
are those of the line from the support to the centre of mass: θ is its inclination from the
vertical, φ its precession and ψ the spin about it. (The column theta of simulate is the inclination
of e3, which is another line where the centre of mass is not on it.) Of a body without weight they
are those of a principal axis about the angular momentum L: the one about which the body goes round.
Means are taken from the first highest point of the line to the last one; where there are no two, or
θ is constant, over the whole run.

Formulas stand where a textbook has them: for a top with an axis of symmetry (Lagrange's) the
precession and nutation of a fast top, and the closed form by an elliptic integral; for a free body
the precession about L, the period of L in the body, and the time from flip to flip.

Steady rotations turn about the vertical, which stands still in the body: Ω = ωΓ. Those with the
vertical angular momentum of the run are listed, with how fast small disturbances grow, and how near
the vertical of the run comes to them. With --json all numbers have every digit.";

pub(crate) const REPORT_EXAMPLES: &str = "\
Examples:
  heavytop report --preset lagrange
  heavytop report my-gyroscope.toml --set integrator.end=10
  heavytop report --preset euler --json";
