//! The long texts of `--help`.

pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the run failed: a stage equation did not converge, a state is not finite, all tops of a sweep
     failed, or disk or memory is full; what was computed until then is kept as FILE.partial, or,
     where there is a FILE.checkpoint or no room, as the run had it; the message says where
  2  the request is wrong, or another run is writing the output; nothing was written
  130  interrupted by Ctrl-C, or asked to end by SIGTERM; simulate, section and sweep go on with
     --resume, of the others nothing is left

Files appear under their name only when they are complete. Until then they are locked: a second run
on the same output is refused. A run that was killed keeps nobody out. (Some network file systems
have no locks; there runs must be kept apart.)";

pub(crate) const REPRODUCE: &str = "\
Reproduce the paper's figures: Kovalevskaya's top with four integrators.

The top has m = g = l = I3 = 1, I1 = I2 = 2 and its centre of mass along e1 (SI units throughout);
Π(0) = (2, 3, 4) and Γ(0) = (1/2, 0, √3/2). It is followed by the implicit and by the explicit
midpoint rule, each applied collectively, on T*C², and directly, to the six equations of the top.

Written into the folder, the figures each as .svg and .png:
  fig1a fig1b fig1c fig1d  h, f1, f2 and K: explicit midpoint collectively (blue) and directly
                           (green), implicit midpoint collectively (red)
  fig2a fig2b              h and K: implicit midpoint directly (gray) and collectively (red)
  trajectories.csv         all states: formulation,scheme,t,Pi1,...,Gamma3,h,f1,f2,K
  summary.csv              the largest deviation of h, f1, f2 and K from the initial value over all
                           steps; also printed";

pub(crate) const REPRODUCE_EXAMPLES: &str = "\
Examples:
  heavytop reproduce                              # the paper's Figures 1 and 2, in ./figures
  heavytop reproduce --out half --step 0.01       # half the step
  heavytop reproduce --out long --end 1000        # ten times as long";

pub(crate) const SIMULATE: &str = "\
Simulate a top and write its states and invariants.

Columns: t (s), Pi1,Pi2,Pi3 (kg m²/s, body frame), Gamma1,Gamma2,Gamma3 (the upward vertical, body
frame), h (J), f1 = |Γ|², f2 = Π·Γ (kg m²/s), then K ((kg m²/s)⁴) for a Kovalevskaya top, G
((kg m²/s)³) for a Goryachev–Chaplygin top, then where asked for the attitude qw,qx,qy,qz: the unit
quaternion of the rotation R from the body frame to the spatial one, Γ = Rᵀe3, which starts with the
shortest rotation that has it. Row 0 is the initial state. Each number reads back as the same 64-bit
number.

Formats, by the file's ending:
  .csv      text
  .npz      for NumPy, the arrays t, Pi, Gamma, h, f1, f2, ... with a row for each time, q for the
            attitude, and the string metadata, in JSON: version and configuration
  .parquet  the columns of the CSV; version and configuration are in its key-value metadata
Memory does not grow with the run. While it goes on the rows are in FILE.partial for .csv, and in
FILE.rows for the others, 8 bytes for each number, until the file is made of them at the end.

A run that is interrupted, by Ctrl-C (which needs a moment) or by a power cut, leaves
FILE.checkpoint; with --resume FILE.checkpoint it goes on, and the file equals that of an
uninterrupted run byte for byte. A configuration need not be given again; if it is, it must be the
same, as must the version of the program. Where there is a checkpoint a run without --resume is
refused, unless --restart discards it. A checkpoint is possible after every 1024th step.

Before a run that needs more room than the disk has, or more than 100 GB, there is a question. Where
nobody can be asked, since stdin or stderr is no terminal, it is refused; --yes answers the question.
--dry-run writes nothing, tries the run for a fifth of a second, and prints what it would write.";

pub(crate) const SIMULATE_EXAMPLES: &str = "\
Presets, for --preset; a configuration given as well is put over it, key by key:
  kovalevskaya         the paper's top, the values below
  lagrange             a symmetric top let go while it spins: its nutation has cusps
  euler                a free body that turns nearly about its middle axis, and tumbles
  goryachev-chaplygin  I1 = I2 = 4 I3, centre of mass on e1, Π·Γ = 0
  multibody-benchmark  the fast top on which multibody codes are compared: 15 kg, 150 rad/s, 2 s;
                       the height of its centre of mass at the end, Gamma2, is -0.67302226956 m

Configuration: every key may be left out, and has then the value below.
  [body]
  inertia = [2.0, 2.0, 1.0]          # principal moments, kg m²
  mass = 1.0                         # kg
  gravity = 1.0                      # m/s²; 0 gives the free rigid body
  length = 1.0                       # m, support to centre of mass
  center_of_mass = [1.0, 0.0, 0.0]   # direction in the body frame; a unit vector
  normalise = false                  # whether to scale center_of_mass to length 1

  [initial]
  angular_momentum = [2.0, 3.0, 4.0]            # Π(0), kg m²/s, body frame
  vertical = [0.5, 0.0, 0.8660254037844386]     # Γ(0), body frame; a unit vector
  normalise = false                             # whether to scale vertical to length 1
  # angular_velocity, Ω(0) in rad/s, instead of angular_momentum: Π(0) = (I1 Ω1, I2 Ω2, I3 Ω3).
  # inclination i and azimuth a (0 by default), rad, instead of vertical:
  # Γ(0) = (sin i cos a, sin i sin a, cos i). i is the angle from e3 to Γ(0): at 0 the axis e3 points
  # up, at π down. a is counted from e1, positive towards e2: at i = π/2, a = 0 the axis e1 points up.

  [integrator]
  formulation = \"collective\"         # or reduced, direct, splitting; see below
  scheme = \"implicit-midpoint\"       # see below
  step = 0.02                        # s
  end = 100.0                        # s; a whole number of steps
  tolerance = 0.0                    # of the stage equations; 0 iterates to the round-off floor

  [output]
  every = 1                          # keep every n-th step; the last step is always kept
  attitude = false                   # whether to write the attitude; direct has none

Formulations:
  collective   on T*C², read through M: T*C² → se(3)*
  reduced      the same maps without a lift, on se(3)* itself
  direct       on the six equations of the top: not Poisson, whatever the scheme
  splitting    exact flows of the free top and of its weight, explicit and Poisson; of the free top
               as three rotors unless I1 = I2

Schemes; the number is the order:
  implicit-midpoint, gauss-4, gauss-6, gauss-8, gauss-10, gauss-12, gauss-16
                                        collective, reduced, direct
  explicit-midpoint, rk4                collective, direct
  symplectic-euler, stormer-verlet, lobatto-iiia-iiib-4
                                        collective, with a warning: they do not descend to se(3)*
  strang, yoshida-4, suzuki-4, yoshida-6, kahan-li-6, kahan-li-8
                                        all: compositions of Strang's splitting under splitting, of
                                        the implicit midpoint rule elsewhere, where strang is that
                                        rule itself

Examples:
  heavytop simulate --out kovalevskaya.csv        # the paper's top
  heavytop simulate top.toml --out top.csv
  heavytop simulate --preset multibody-benchmark --out benchmark.npz
  heavytop simulate --preset lagrange top.toml --out top.parquet   # the preset but for top.toml
  heavytop simulate top.toml --set integrator.end=50 --set integrator.scheme=gauss-4 --out top.csv
  sed s/0.02/0.01/ top.toml | heavytop simulate - --out top.csv    # from standard input
  heavytop simulate top.toml --out top.csv --resume top.csv.checkpoint
  heavytop simulate top.toml --out top.csv --restart               # discard the checkpoint
  heavytop simulate top.toml --out top.csv --dry-run               # rows, size and time only
  heavytop simulate top.toml --out top.csv --json                  # a summary on stdout
  heavytop simulate top.toml --out /dev/stdout | gzip > top.csv.gz";

pub(crate) const COMPARE: &str = "\
Measure work against precision, for every formulation and scheme.

The top of the configuration is followed by each of them with twelve steps, from fifty times the
configured one to a tenth of it. The interval is 500 configured steps, or the whole run if that is
shorter; --end sets another end. Over longer times the errors of a chaotic top say more about the
top than about the integrators. formulation, scheme and output of the configuration play no part; tolerance does.

The error is the 2-norm of that of (Π, Γ) at the end, against a Gauss method of order 16 without a
lift at half the configured step; if that with the whole step differs by more than 1e-11 of its
size, the command fails. The time is the wall-clock time for one simulated second, (Π, Γ) read after
each step, the best of at least three repetitions; it is of your machine, so let it rest meanwhile.
Π and Γ have different units: the table has their errors apart, and the figure shows the larger of
|δΠ| / max |Π| and |δΓ| / max |Γ|.

Written into the folder:
  work-precision.svg .png  error against time, a panel for each formulation
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

pub(crate) const SECTION: &str = "\
Draw a Poincaré section of a top.

On the states with h = energy, Π·Γ = vertical_momentum and |Γ| = 1 starts are spread evenly over a
surface, and followed from crossing to crossing. The surface fixes one coordinate, Γ_i or Π_i; the
section is drawn over

  x   the angle of Γ about e_i, rad
  y   Π_i (kg m²/s) where Γ_i is fixed, Γ_i where Π_i is fixed

Where Γ_i is fixed these are canonical: areas are conserved from crossing to crossing. Starts are
coloured by the mean of |y| over their points, which is the same all over an invariant curve or a
chaotic sea.

Crossings are located to the accuracy of the integrator; those in the first step after a start are
not seen. Starts are followed in parallel; no bit depends on the number of threads (--threads).

Written into the folder:
  section.svg .png  the picture
  section.csv       start,crossing,t,Pi1,...,Gamma3,x,y; crossing 0 is the start itself
  section.parquet   the same columns; version and configuration, with all that was left out, are in
                    its key-value metadata

What is finished, a start or some 256 points at a time, is kept in DIR/section.partial until all is.
After an interruption, by Ctrl-C (which needs a moment; a second one ends at once), a kill or a full
disk, --resume continues from there, to the same bytes, and --restart starts anew; one of them is
needed. --resume is refused with another configuration or version. No more points are held than
those of the picture.";

pub(crate) const SECTION_EXAMPLES: &str = "\
Configuration: [body] and [initial] as of simulate, and
  [section]
  energy = 11.75                     # h, J; without it that of [initial]
  vertical_momentum = 4.46           # Π·Γ, kg m²/s; without it that of [initial]
  surface = \"Gamma3\"                 # or Gamma1, Gamma2, Pi1, Pi2, Pi3
  level = 0.0                        # its value on the surface
  direction = \"up\"                   # the crossings that count: up, down or both
  starts = 60                        # 1 or more
  crossings = 500                    # of each start, 1 or more
  longest = 10000.0                  # s; no start is followed longer
  seed = 0                           # which starts

  [integrator]                       # as of simulate; end plays no part
What [integrator] leaves out: reduced, gauss-8, a step in which no body on the energy level turns by
more than 0.5 rad.

Examples:
  heavytop section --out section                  # the paper's top
  heavytop section --preset euler --out section
  heavytop section top.toml --out section --json
  heavytop section top.toml --out section --resume   # after an interruption
  heavytop section top.toml --out section --restart  # or all anew";

pub(crate) const ANIMATE: &str = "\
Show a top in motion, on a page for a browser.

The page is one file, which needs neither others nor a network. It shows in space the body, as the
homogeneous ellipsoid about the support that has its principal moments, its principal axes, the
centre of mass with the trace of its direction on the sphere, the angular momentum and the vertical;
and below h, f1, f2 and, where the top has them, f3, K and G against time. Play, pause, go anywhere
in time, choose the speed, drag to turn the view; the page says which keys do it.

The attitude is followed along with (Π, Γ); the direct equations have none. It starts with the shortest
rotation R for which Γ = Rᵀe3.

Every n-th step is a frame, and the last; n is [output] every, or the least multiple of it that gives
at most 20000 frames, some 3.5 MB. Between frames the page interpolates, and there is a warning where
the body turns by more than 1 rad from one to the next.";

pub(crate) const ANIMATE_EXAMPLES: &str = "\
Examples:
  heavytop animate --out kovalevskaya.html        # the paper's top
  heavytop animate top.toml --out top.html
  heavytop animate --preset lagrange --out lagrange.html --json   # a summary on stdout
Open the page in a browser; top.html#t=12.5 shows the moment t = 12.5 s.";

pub(crate) const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  heavytop completions bash > ~/.local/share/bash-completion/completions/heavytop
  heavytop completions zsh > ~/.zfunc/_heavytop
  heavytop completions fish > ~/.config/fish/completions/heavytop.fish";

pub(crate) const INIT_EXAMPLES: &str = "\
Examples:
  heavytop init top.toml                          # the paper's top; no file is overwritten
  heavytop init --preset lagrange top.toml
  heavytop init > top.toml";

pub(crate) const MAN_EXAMPLES: &str = "\
Examples:
  heavytop man | man -l -
  heavytop man simulate > ~/.local/share/man/man1/heavytop-simulate.1";

pub(crate) const BENCH: &str = "\
Time the integrators on one top and on many.

The configured top is followed to t = 1000 s, and an ensemble of starts about its own to t = 20 s, by
each fast path and by the general one, which serves any system. For each: the least computing time of
several runs (ms), that per top and step (ns), and the error of (Π, Γ) at t = 10 s and at the end: its
2-norm, in an ensemble the mean over at most 10000 tops. References are by the collective Gauss
method of order 16 with step 1/8 s.

A problem file is text: I1 I2 I3 mgl c1 c2 c3 end on the first line (kg m², N m, s), and on each other
line a top: (Π, Γ) at t = 0, t = 10 and end.";

pub(crate) const BENCH_EXAMPLES: &str = "\
Examples:
  heavytop bench                                  # the paper's top
  heavytop bench top.toml --threads 2
  heavytop bench --only midpoint --json
  heavytop bench --only \"splitting of order 4\" --tops 10000000";

pub(crate) const SWEEP: &str = "\
Follow many tops at once, and map what becomes of them.

Each axis varies one number of [body] or [initial], over a grid or at random; the observables are

  final-state         (Π, Γ) at the end: Pi1,Pi2,Pi3 (kg m²/s), Gamma1,Gamma2,Gamma3
  invariant-drift     largest deviations over all steps: drift_h (J), drift_f1, drift_f2 (kg m²/s)
  lyapunov            the maximal Lyapunov exponent so far, 1/s
  megno               mean exponential growth factor of nearby orbits: about 2 in order, λt/2 in chaos
  sali                smaller alignment index of two tangent vectors: round-off in chaos
  rotation-number     mean advance of Γ about the centre of mass's line, seen from the body, from one
                      maximum of its height to the next, in turns; null with fewer than two maxima
  nutation-amplitude  range of the angle between that line and the vertical, rad

Tangent vectors are those of the states that the integrator advances: under collective those of
T*C², fibres included; use reduced.

Written into the folder:
  sweep.parquet   a row for each top: index, the parameters by their paths, the observables, failure;
                  a top that could not be followed has nulls and the reason there, and harms no other;
                  if all fail, the table is kept as sweep.parquet.partial, and the exit code is 1
  NAME.svg .png   for a grid with two axes and at most 4096 × 4096 tops, a map of each column: the
                  first axis is the abscissa; the colours span all values but half a percent at
                  either end; gray has no value; the value 2 of MEGNO, regular motion, is marked

Tops are followed in parallel (--threads, by default all processors); top number n depends on the
configuration and n alone, so that no bit depends on the number of threads, processes or tops. What
is finished is kept, 256 tops at a time, in DIR/sweep.partial until all is; after an interruption, by
Ctrl-C (a second one ends at once), a kill or a full disk, --resume continues from there, to the same
bytes, and --restart starts anew; one of them is needed. --resume is refused with another configuration or version. But for
the maps memory does not grow with the number of tops.

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
What [integrator] leaves out: reduced, gauss-8, step 0.1 s, end 100 s.

Parameters:
  body.inertia[i], body.mass, body.gravity, body.length, body.center_of_mass[i],
  initial.angular_momentum[i], initial.vertical[i]                    i = 0, 1, 2
  body.center_of_mass.inclination, body.center_of_mass.azimuth,
  initial.vertical.inclination, initial.vertical.azimuth              rad
with the unit vector (sin i cos a, sin i sin a, cos i) of inclination i and azimuth a.

Examples:
  heavytop sweep --out sweep                      # a small map about the paper's top
  heavytop sweep map.toml --out map
  heavytop sweep map.toml --out map --resume      # after an interruption
  heavytop sweep map.toml --out map --restart     # or all anew
  mpirun -n 4 heavytop sweep map.toml --out map   # built with --features mpi";
