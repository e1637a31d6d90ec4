//! The long texts of `--help` of the commands that follow many starts or tops.

pub(crate) const EVENTS: &str = "\
Find when functions of the state and the time pass zero along a run, of a top or of another system.

The run is that of simulate. An event is where a function goes to zero and changes its sign, found
to the accuracy of the integrator. A touch is none; neither are a jump, a pole, and a start on zero.
A function that is an atan2 is an angle: it is zero once per turn. A function is evaluated at the
steps: one that goes to zero and back within a step may be missed, so take a step that resolves it.
The names in a formula of a top are Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3 and the vectors Pi, Gamma:
the inclination θ of e3 is acos(Gamma3), and Omega1 is Pi1 divided by the moment. The name t is the
time, and [inputs] have theirs.

Written: a table with the columns event, the number of the function, from 1, and those of simulate,
a row for each event, in the order in which they happen. The closing line says how many there are
of each function, and how far apart; --json also tells the first and the last.";

pub(crate) const EVENTS_EXAMPLES: &str = "\
Configuration: as of simulate, and
  [events]
  functions = [\"Gamma3 - 0.5\"]      # formulas in coordinates and t; of a system also parameters
  direction = \"both\"               # up, down or both: the sign changes that count, along the run
  terminal = 3                       # the run ends with the third event of a function; without it,
                                     # with the last step
Examples:
  heavytop events top.toml --out events.csv
  heavytop events --preset euler --set 'events.functions=[\"Pi2\"]' --out flips.csv
  heavytop events top.toml --out - --quiet";

pub(crate) const ENSEMBLE: &str = "\
Follow many paths of a motion with noise, and write means, deviations and quantiles.

The run is that of simulate, with the table [noise]. Path i has the number noise.path + i, so that
simulate with this number shows it alone. The paths are followed on all threads; the table does not
depend on their number. No path is kept: quantiles are estimated by the P² algorithm, from the paths
one after the other.

Written: a table with the columns paths, the number of paths, t, and of each column X of simulate
  X_mean, X_error       the mean over the paths, and its standard error
  X_deviation           the standard deviation of X
  X_q0.05, ...          the quantiles
An error of the mean by the step is beside the standard error: of weak order 1 in the step, or 2
with noise.rule = \"alternating\", and a scheme of order 4 or more if noise.fields name coordinates.
Half the step shows it.";

pub(crate) const ENSEMBLE_EXAMPLES: &str = "\
Configuration: as of simulate, with [noise], of a top, a system, a spin-lattice, a sphere-fluid
Examples:
  heavytop ensemble spin.toml --out means.csv
  heavytop ensemble spin.toml --paths 10000 --quantiles 0.01,0.99 --out means.csv
  heavytop ensemble spin.toml --set integrator.step=0.05 --out half.csv";

pub(crate) const SECTION: &str = "\
Draw a Poincaré section of a top, or of another Lie–Poisson system (at the end of this help).

On the states with h = energy, Π·Γ = vertical_momentum and |Γ| = 1 starts are spread evenly over a
surface, and followed from crossing to crossing. The surface fixes one coordinate, Γ_i or Π_i, or
the angle of Γ about e_i; the section is drawn over

  x   the angle of Γ about e_i, rad; where that is fixed, the inclination of Γ to e_i, rad
  y   Π_i (kg m²/s) where Γ_i is fixed, Γ_i where Π_i is fixed; where the angle is, Π·n (kg m²/s)
      with n = e_i × Γ/|e_i × Γ|

Where Γ_i or the angle is fixed these are canonical: areas are conserved from crossing to crossing.
An angle is passed where it is the level, or differs from it by turns of 2π; its jump from π to -π
is no crossing. Starts are coloured by the mean of |y| over their points, which is the same all over
an invariant curve or a chaotic sea. The axes fit the points, and an angle has the whole turn where
points are all around; limits (below) fix them, and the caption counts the points outside.

The closing lines, error_estimate of the summary and the metadata have an estimate of the error at
the last return, relative to the state, of eight orbits or all: the largest, which is 1 where an
orbit is chaotic and long. A warning says where it is above 1e-3.

Crossings are located to the accuracy of the integrator. The start is no crossing; neither is a
touch, where the sign does not change. Starts are followed in parallel; no bit depends on the number
of threads (--threads).

Written into the folder:
  section.svg .png  the picture
  section.csv       start,crossing,t,Pi1,...,Gamma3,x,y; crossing 0 is the start itself
  section.parquet   the same columns; version and configuration, with all that was left out, are in
                    its key-value metadata

What is finished, a start or some 256 points at a time, is kept in DIR/section.partial until all is.
After an interruption, by Ctrl-C (which needs a moment; a second one ends at once), a kill or a full
disk, --resume continues from there, to the same bytes, and --restart starts anew; one of them is
needed. Where there is nothing to go on from, both begin. --resume is refused with another
configuration or version. No more points are held than those of the picture. --dry-run writes
nothing, tries some starts for a fifth of a second, and prints what would be written, and the time;
it takes every start to have all its returns.";

pub(crate) const SECTION_EXAMPLES: &str = "\
Configuration: [body] and [initial] as of simulate, and
  [section]
  energy = 11.75                     # h, J; without it that of [initial]
  vertical_momentum = 4.46           # Π·Γ, kg m²/s; without it that of [initial]
  surface = \"Gamma3\"                 # or Gamma1, Gamma2, Pi1, Pi2, Pi3, or an angle, rad:
                                     # atan2(Gamma2, Gamma1) about e3,
                                     # atan2(Gamma3, Gamma2) about e1,
                                     # atan2(Gamma1, Gamma3) about e2
  level = 0.0                        # its value on the surface
  direction = \"up\"                   # the crossings that count: up, down or both; the two sheets
                                     # of both are drawn over one another
  starts = 60                        # 1 or more
  crossings = 500                    # of each start, 1 or more
  longest = 10000.0                  # s; no start is followed longer
  seed = 0                           # which starts
  limits = { x = [0, 3], y = [-1, 1] } # what the picture shows, one axis or both; the tables have
                                     # all points

  [integrator]                       # as of simulate; of end the sign alone plays a part: backward
                                     # in time if it or the step is negative
What [integrator] leaves out: reduced, gauss-8, a step in which no body on the energy level turns by
more than 0.5 rad.

Another Lie–Poisson system instead of a top: [system] as of simulate, and
  [section]
  energy = 1.0                       # h; without it that of the initial state
  surface = \"P1 - P2\"              # any formula in the coordinates
  axes = [\"Pi1\", \"Pi2\"]            # what is drawn: two formulas; without them the first coordinates
  states = [{ Pi = [1, 0, 2], ... }] # motions to follow, each on its own level; without them random
                                     # starts with the h and the Casimirs of the initial state
A surface that is an atan2, or an atan2 and a function without one, is an angle: it is passed where
the angle is the level, or differs from it by turns of 2π. Half a turn, as of arctan, is no angle.
Jumps and poles of a surface are no crossings.

Each state is followed to the surface, and its first point there is crossing 0: the state itself if
it lies on the surface and leaves it in the direction that counts. The columns are
start,crossing,t, the coordinates,x,y. What [integrator] leaves out: reduced where there is one, or
as for simulate; gauss-8; the step of simulate.

Forces, beside [body] or [system] as of simulate: surface and axes are formulas in the coordinates,
t and the inputs, of a top, too. sin(w*t) is passed upwards once in a period: a stroboscopic
section. With noise there is no other one, and start n has the path n - 1 after that of [noise].
There is no level of an energy. The starts are states, or the initial state and random ones on its
coadjoint orbit; each is followed from t = 0 to its first point there, which is crossing 0. Inputs
reach to the time longest. What [integrator] leaves out is that of simulate.

Examples:
  heavytop section --out section                  # the paper's top
  heavytop section --preset euler --out section
  heavytop section top.toml --out section --json
  heavytop section top.toml --out section --resume   # after an interruption
  heavytop section top.toml --out section --restart  # or all anew";

pub(crate) const SWEEP: &str = "\
Follow many tops at once, or many motions of another Lie–Poisson system (at the end of this help),
and map what becomes of them.

Each axis varies one number of [body] or [initial], over a grid or at random; the observables are

  final-state         (Π, Γ) at the end: Pi1,Pi2,Pi3 (kg m²/s), Gamma1,Gamma2,Gamma3
  invariant-drift     largest deviations over all steps: drift_h (J), drift_f1, drift_f2 (kg m²/s)
  relative-drift      these relative to the size of each invariant, without a unit:
                      relative_drift_h, relative_drift_f1, relative_drift_f2
  lyapunov            the maximal Lyapunov exponent so far, 1/s
  megno               mean exponential growth factor of nearby orbits: about 2 in order, λt/2 in
                      chaos
  sali                smaller alignment index of two tangent vectors: round-off in chaos
  rotation-number     mean advance of Γ about the line of the centre of mass, seen from the body,
                      from one maximum of its height to the next, in turns; null with fewer than two
                      maxima
  nutation-amplitude  range of the angle between that line and the vertical, rad

Where axes vary the body, and its mass and length are given, a warning counts the members that no
body is, as of simulate, and names the first of them.

Tangent vectors are those of the states that the integrator advances: under collective those of
T*C², fibres included; use reduced.

Written into the folder:
  sweep.parquet   a row for each top: index, the parameters by their paths, with the values that are
                  run (components of a unit vector after scaling), the observables, failure;
                  a top that could not be followed has nulls and the reason there, no other has;
                  if all fail, the table is kept as sweep.parquet.partial, and the exit code is 1
  NAME.svg .png   for a grid with two axes and at most 4096 × 4096 tops, a map of each column: the
                  first axis is the abscissa; values of both signs are blue and red about white, 0;
                  MEGNO is white at 2, regular motion, and red in chaos; gray has no value. Of the
                  half percent of values at either end those that would widen the scale by more than
                  a tenth lie beyond it: the bar of colours ends in a point, and the caption counts
                  them;
                  for a single axis and at most 65536 tops, a curve of each column, with gaps where
                  there is no value, or dots where the axis is random
  sweep.csv       where there are curves, the table of sweep.parquet as text: an empty cell for a
                  null, and the reason in quotes if it has commas or quotes

Tops are followed in parallel (--threads, by default all processors); top number n depends on the
configuration and n alone, so that no bit depends on the number of threads, processes or tops. What
is finished is kept, 256 tops at a time, in DIR/sweep.partial until all is; after an interruption,
by Ctrl-C (a second one ends at once), a kill or a full disk, --resume continues from there, to the
same bytes, and --restart starts anew; one of them is needed. --resume is refused with another
configuration or version. But for the pictures memory does not grow with the number of tops.
--dry-run writes nothing, tries some tops for a fifth of a second, and prints what would be written,
and the time.

A program built with the feature mpi shares the work among the processes of an MPI job. DIR must be
on a file system that all of them see. A process that fails says why and ends the job.";

pub(crate) const SWEEP_EXAMPLES: &str = "\
Configuration: [body] and [initial] as of simulate, and
  [sweep]
  observables = [\"megno\"]            # one or more
  count = 10000                      # how many tops; where the axes are random, and only there
  seed = 0                           # which random numbers

  [[sweep.axes]]                     # a grid; where there are several the last one runs fastest
  parameter = \"body.inertia[1]\"     # see below
  from = 1.0
  to = 3.0
  count = 512

  [[sweep.axes]]                     # or random: the axes are all grids or all random
  parameter = \"initial.vertical[0]\"
  uniform = [-1.0, 1.0]              # least and largest value; or
  # normal = [0.0, 0.5]              # mean and standard deviation
  normalise = true                   # scale the unit vector to length 1 afterwards; default false

  [integrator]                       # as of simulate
What [integrator] leaves out: reduced, gauss-8, step 0.1 s, end 100 s. Where a top may turn by more
than 1 rad in such a step, by its energy, the step is one in which none that is tried may turn by
more than 0.5 rad, and an end that is left out comes after as many steps.

Parameters:
  body.inertia[i], body.mass, body.gravity, body.length, body.weight_moment, body.center_of_mass[i],
  initial.angular_momentum[i], initial.angular_velocity[i], initial.vertical[i]       i = 0, 1, 2
  body.center_of_mass.inclination, body.center_of_mass.azimuth,
  initial.inclination, initial.azimuth, which may be written as
  initial.vertical.inclination, initial.vertical.azimuth              rad, or as in \"30 deg\"
with the unit vector (sin i cos a, sin i sin a, cos i) of inclination i and azimuth a.

Another Lie–Poisson system instead of a top: [system] as of simulate, and
  [[sweep.axes]]
  parameter = \"system.parameters.k\" # a number of [system.parameters]; of a vector, such as I[0]
  from = 0.0
  to = 1.0
  count = 100

  [[sweep.axes]]
  parameter = \"system.initial.Pi[2]\" # or system.initial.Pi3: a coordinate of the initial state
  from = -1.0
  to = 1.0
  count = 100
Axes must be given. The observables are final-state, with the coordinates as columns;
invariant-drift, with drift_h, and drift_c1, drift_c2, ... of the Casimirs, which are those of each
run if an axis varies a parameter of the brackets, and empty where a Casimir is no polynomial;
relative-drift, with relative_drift_h, relative_drift_c1, ...; lyapunov, megno and sali. What
[integrator] leaves out: reduced where there is one, or as for simulate; gauss-8, step 0.1 s, end
100 s, both shortened as for tops.

With forces, as of simulate, an axis may also vary damping.friction, noise.temperature,
noise.strength or a value of an input, inputs.u.values[2]. The observables are final-state;
invariant-drift, which tells the change of what the motion does not keep; lyapunov, megno and sali.
All members are on the same path of the noise; heavytop ensemble averages over paths. The
formulation is as for simulate.

Examples:
  heavytop sweep --out sweep                      # a small map about the paper's top
  heavytop sweep map.toml --out map
  heavytop sweep map.toml --out map --resume      # after an interruption
  heavytop sweep map.toml --out map --restart     # or all anew
  mpirun -n 4 heavytop sweep map.toml --out map   # built with --features mpi";
