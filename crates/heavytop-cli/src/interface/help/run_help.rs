//! The long texts of `--help` of the commands that run one top.

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
((kg m²/s)³) for a Goryachev–Chaplygin top with Π·Γ = 0, f3 = Π·c (kg m²/s) for a sphere whose
centre of mass is on no axis, then where asked for the attitude qw,qx,qy,qz: the unit
quaternion of the rotation R from the body frame to the spatial one, Γ = Rᵀe3, which starts with the
shortest rotation that has it, or with the attitude of [initial]. Then the columns that [output]
columns asks for. Row 0 is the initial state. Each number reads back as the same 64-bit number.

Formats, by the file's ending:
  .csv      text; also on standard output, for --out -
  .npz      for NumPy, the arrays t, Pi, Gamma, h, f1, f2, ... with a row for each time, q for the
            attitude, and the string metadata, in JSON: version and configuration
  .parquet  the columns of the CSV, compressed (gzip); version and configuration are in its
            key-value metadata
Memory does not grow with the run. While it goes on the rows are in FILE.partial for .csv, and in
FILE.rows for the others, 8 bytes for each number, until the file is made of them at the end.

A run that is interrupted, by Ctrl-C (which needs a moment) or by a power cut, leaves
FILE.checkpoint; with --resume it goes on, and the file equals that of an uninterrupted run byte for
byte. A configuration need not be given again; if it is, it must be the same, as must the version of
the program. Where there is no checkpoint a run with --resume begins, if it has a configuration.
Where there is a checkpoint a run without --resume is refused, unless --restart discards it. A
checkpoint is possible after every 1024th step.

Conserved quantities do not tell whether a motion is right. The closing line and the key
error_estimate of the summary and of the metadata have an estimate of the error, relative to the
state: the largest over the run, of Π relative to |Π| and of Γ relative to |Γ|; 1 means that nothing
is right. For it the run is repeated with half the step, a long run in its beginning, from which the
error is scaled by its growth. The output does not depend on it. It takes a part of the time of a
long run, and three times that of one of some thousand steps; the guide,
docs/guide/which-integrator.md, says more. There is a warning if a step turns the motion by more
than 1 rad, or if the estimate is above 1e-3; a step that turns it by more than 100 rad from the
start is refused. --check makes the whole run again with half the step and with twice the step, and
says the error at its end and the order, for three and a half times the time. Where forces change
conserved quantities that is no error: --balance says how much of the change they supply, by
quadrature of ⟨dC, F⟩ along the run, and for the energy of ⟨F, dh⟩ + ∂h/∂t, and how much the method
adds, for nine times the time of the run; balance in the summary, with change, supplied and defect.

Before a run that needs more room than the disk has, or more than 100 GB, there is a question. Where
nobody can be asked, since stdin or stderr is no terminal, it is refused; --yes answers the
question. --dry-run writes nothing, tries the run for a fifth of a second, and prints what it would
write.";

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
  inertia = [2.0, 2.0, 1.0]          # principal moments about the support, kg m²
  inertia_about = \"support\"          # or center-of-mass
  weight_moment = 1.0                # m g l, N m; 0 without gravity
  # instead of it: mass (kg), gravity (m/s², 9.81 on Earth), length (m, support to centre of mass)
  center_of_mass = [1.0, 0.0, 0.0]   # direction in the body frame; a unit vector
  normalise = false                  # whether to scale center_of_mass to length 1

  [initial]
  angular_momentum = [2.0, 3.0, 4.0]            # Π(0), kg m²/s, body frame
  vertical = [0.5, 0.0, 0.8660254037844386]     # Γ(0), body frame; a unit vector
  normalise = false                             # whether to scale vertical to length 1
  # angular_velocity, Ω(0) in rad/s, instead of angular_momentum: Π(0) = (I1 Ω1, I2 Ω2, I3 Ω3).
  # inclination i, from 0 to π or in degrees as in \"30 deg\", and azimuth a, between -2π and 2π or
  # as in \"90 deg\", 0 by default, instead of vertical:
  # Γ(0) = (sin i cos a, sin i sin a, cos i). i is the angle from e3 to Γ(0): at 0 the axis e3 is
  # up, at π down. a is counted from e1, positive towards e2: at i = π/2, a = 0 the axis e1 is up.
  # attitude, a unit quaternion [w, x, y, z] of R, or euler_angles [φ, θ, ψ] in radians or as in
  # \"30 deg\", instead of vertical: R = R3(φ) R1(θ) R3(ψ), Γ = (sin θ sin ψ, sin θ cos ψ, cos θ).

  [integrator]
  formulation = \"collective\"         # or reduced, direct, splitting; see below
  scheme = \"gauss-8\"                 # see below
  step = 0.02                        # s
  end = 100.0                        # s; a whole number of steps, backward in time if negative
  tolerance = 0.0                    # of the stage equations; 0 iterates to the round-off floor
  instructions = \"native\"            # or portable: the same bytes on every processor, slower

  [output]
  every = 1                          # keep every n-th step; the last step is always kept
  attitude = false                   # whether to write the attitude; direct has none
  columns = []                       # more columns, in the axes of [body]:
  # \"Omega\" (rad/s), \"height\" of the centre of mass above the support (m), \"kinetic\" and
  # \"potential\" energy (J); and with the attitude, which is then written, too: \"euler-angles\"
  # phi, theta, psi (rad; R as above) and \"spatial-momentum\" RΠ (kg m²/s).

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

The support is the fixed point. Moments about the centre of mass, as in tables of solids, need
inertia_about = \"center-of-mass\" with mass and length: I_support = I_cm + m l² (1 − ccᵀ). There is a
warning where mass and length are given and no body has the moments. inertia may be a symmetric
matrix, [[I11, I12, I13], [I12, I22, I23], [I13, I23, I33]]: the principal axes are found and told,
and input and output are in the axes of the matrix. One moment may be 0: a thin rod, with the centre
of mass on it and no spin about it.

Where [body] or [initial] is opened, by the file or by --set, the values that are left out of the
two are told at the end, in the summary (left_out) and in the metadata.

Another Lie–Poisson system instead of a top, by its algebra and a formula:

  [system]
  algebra = \"se(3)\"                # an expression, as below
  hamiltonian = \"½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃) + mgl*c·Γ\"
  parameters = { I = [2, 2, 1], mgl = 1, c = [1, 0, 0] }
  initial = { Pi = [2, 3, 4], Gamma = [0.6, 0, 0.8] }
  bracket = \"minus\"               # or \"plus\": ds/dt = s × B for h = −B·s on so(3)

  [system]
  algebra = \"so(3)^3\"             # three spins
  coordinates = [\"S\"]             # other symbols than its own: S_1, S_2, S_3
  hamiltonian = \"-sum(S[i]·S[i+1]) - S[1][3]\"
  initial = { S_1 = [1, 0, 0], S_2 = [0, 1, 0], S_3 = [0, 0, 1] }

  [system]
  coordinates = [\"K\", \"H\", \"P\"]    # an algebra of your own, by its brackets
  brackets = { \"K, H\" = \"P\", \"K, P\" = \"H\" }
  hamiltonian = \"K^2/2 + H^2\"
  initial = { K = 0.1, H = 0.3, P = -0.2 }

  [system]
  structure_constants = '''       # or by lines i, j, k, value: [e_i, e_j] has the value at e_k;
  1, 2, 3, 1
  2, 3, 1, 1
  3, 1, 2, 1
  '''                              # a text of one line is the path of a file with such lines,
  hamiltonian = \"|mu|^2 + mu1^2\"   # relative to the configuration
  initial = { mu = [1, 2, 3] }       # without coordinates, they are a vector mu

  [system]
  kind = \"vortices\"              # a system by name, with its algebra and Hamiltonian
  parameters = { strengths = [1, 1, 1] }
  initial = { positions = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }

Kinds, and their parameters (* if they may be left out):
  body-in-fluid       inertia, masses, coupling*; coordinates Pi, P
  body-with-rotors    I, J; coordinates Pi, l
  elliptical-vortex   strength, strain*, rotation*; initial a, b, angle*, or mu, of which
                      mu3 +- |(mu1, mu2)| = a^2, b^2, and (mu1, mu2) has twice the angle
  gyrostat            inertia, weight, center_of_mass, rotor; coordinates Pi, Gamma
  reaction-wheels     I, axes, J; initial Omega*, speeds*, or Pi, l; motors are [torque] l
  rigid-body          moments, of the mass along each of n axes; coordinates Pi, or L12, L13, ...
  satellite           I, n, eccentricity*, mean_anomaly* or true_anomaly*; initial roll*, pitch*,
                      yaw*, relative*, or Pi, Gamma_1, Gamma_2; on an ellipse the Hamiltonian
                      depends on t, and formulas of forces may name orbit_rate and orbit_tide;
                      with axes*, J*, initial speeds* also wheels, as of reaction-wheels
  spin-chain          spins, exchange, anisotropy*, field*, periodic*; coordinates S_1, S_2, ...
  top-on-base         inertia, mass, base_mass, gravity, center_of_mass; coordinates Pi, P, Gamma
  vortices            strengths; initial positions on the unit sphere, or m_1, m_2, ...
A kind without parameters is refused with their meaning and units, and heavytop init --kind NAME
writes a configuration to begin with.

Forces, for simulate, events, section, sweep, ensemble, beside [system] or [body]; t in formulas is
the time:
  [inputs.u]                         # u(t) for formulas, by a table
  times = [0, 10, 20]                # s; from the start of the run to its end
  values = [0, 1, 0]
  interpolation = \"linear\"         # or constant, each value until the next time; or cubic
  # file = \"u.csv\" instead of times and values: a table with the columns time = \"t\" and
  # value = \"u\", or, if they are left out, the first two; relative to the configuration
  [drive]                            # a control, added to dh: it keeps the Casimirs
  Pi = [0, 0, \"u*cos(2*t)\"]        # formulas by coordinates; what is left out is 0
  [damping]                          # a double bracket: it lowers h and keeps the Casimirs
  friction = 0.1
  inner_product = 1                  # a multiple of the unit matrix, a diagonal, or rows; needed
                                     # where there are several vectors, as of a top
  # form = \"gilbert\" of spins, so(3) or sums of it, instead of inner_product: friction is alpha;
  # or \"landau-lifshitz\", one theta for all spins; as of a spin-lattice, below
  [noise]                            # it keeps the Casimirs, in Stratonovich's sense
  temperature = 0.5                  # kT, with a friction above 0; or strength, with or without
                                     # inner_product; or fields = [{ Pi = [0, 0, 1] }, ...]
  seed = 1                           # of the random numbers
  path = 0                           # another number is another path
  rule = \"together\"                # or alternating: weak order 2 instead of 1
  bound = 6                          # of the increments, in standard deviations
  # interval (s): the times that determine a path; the step, if it is left out
  # on so(3), su(2) and se(3) without a torque reduced, implicit-midpoint keeps the Casimirs for
  # any [integrator] tolerance: 1e-6 makes steps faster, and is far below the error of means
  [torque]                           # a rate of the coordinates: it changes the Casimirs, too, and
  Pi = [0, 0, \"-0.1*Pi3\"]          # the formulation is direct. Of a body for Pi alone, in N m;
                                     # I1, I2, I3 are its moments
Beside a spin-lattice, for simulate and ensemble, where the method is direct, implicit-midpoint:
  [drive]                            # it keeps every |s|; h has the field of its time
  field = [\"u*cos(2*t)\", 0, 0]     # B(t), besides field of parameters; with [inputs] as above
  [damping]                          # it lowers h and keeps every |s|
  friction = 0.1                     # theta, or Gilbert's alpha
  form = \"landau-lifshitz\"         # ds/dt = s x H - theta s x (s x H); or gilbert, with
                                     # - (alpha/|s|) s x ds/dt instead
  [noise]                            # temperature, seed, path, bound, interval, as above
  temperature = 0.5                  # kT, with a friction above 0
The columns are h, M1, M2, M3 and C = sum of |s|^2, which alone is kept.

Beside a sphere-fluid, for simulate and ensemble, where the method is reduced, implicit-midpoint:
  [damping]                          # degree l decays at the rate drag + viscosity (l(l + 1))^power
  viscosity = 1e-3                   # 1/t on the unit sphere; it has no way backward in time
  power = 1                          # 1 to 32; above 1 it is a hyperviscosity
  drag = 0.1                         # 1/t
  [torque]                           # a constant force: the rate of the vorticity
  coefficients = [[4, 0, 0.5, 0]]    # rows [l, m, re, im], 1/t^2
  [noise]                            # one or both, in one shell or in an array of shells; and seed,
                                     # path, bound, interval, as above
  transport = { degrees = [8, 10], strength = 0.001 }  # stream functions, 1/sqrt(t): they carry the
                                     # vorticity along, and alone they keep its Casimirs, such as Z
  stirring = { degrees = [8, 10], strength = 0.1 }     # vorticities, 1/(t sqrt(t))

Systems of arrays, of any size, which simulate and sweep follow; * as above. FILE.npz has one array
a quantity, and heavytop plot draws it, heavytop export writes it for ParaView and OOMMF:
  spin-lattice        shape of one to three axes, exchange* (0), bonds*, periodic* (1; 0 for open
                      ends), anisotropy* (0), axis*, field* (0); array S of shape (..., 3);
                      initial S, or direction* (0, 0, 1), waves* with a cone, tilt* (0), seed* (0)
  vibrating-lattice   atoms, exchange, mass* (1), stiffness* (1), coupling* (0); arrays S, q, p;
                      initial as for spin-lattice, and q*, p* (0)
  sphere-fluid        size, rotation* (0); omega of shape (N, N), Re of (l, m) at [l, m], Im at
                      [m-1, l]; initial coefficients, rows [l, m, re, im], or degrees, rms* (1),
                      seed* (0), or vorticity, rows of a grid
  vortices            more than 48 strengths; m of shape (N, 3); initial positions, or seed
initial_file = \"FILE.npz\" instead of initial starts from the last sample of an archive, or from a
file .npy, .ovf or .vti. The default is collective, for fluids reduced; reduced with the scheme
spherical-midpoint is the fastest for large periodic lattices. In CSV, S_34_2 is the second
component of the 34th spin, the last axis running fastest.

Algebras, of up to 256 dimensions, with their coordinates: so(3) Pi; su(2), su(n) mu; sl(2) alpha,
beta, gamma; se(2) Pi, Gamma of two components; se(3) Pi, Gamma; se(3)+R3 Pi, P, Gamma, as of a
body in two fields; so(n), so(p,q) L12, L13, ...; sl(n,R), gl(n) M11, ...; sp(2n,R) Q11, R11, P11,
...; heisenberg(n) q, p, z; galilei, bargmann, poincare(1,n) J, K, P, H; R3 p. Sums a + b, powers
a^4, and semidirect products a |x R3 or a ⋉ (R3 + R3) with vectors Gamma; a |x V with a
representation of your own, [system.representations] V = [matrices, one for each coordinate of a].
representation = [matrices] of the algebra itself, or momenta = [symmetric matrices], gives the
collective steps a realisation of your own.
The columns are t, the coordinates, h and the Casimirs c1, c2, ..., which are found: polynomials
of low degree, named in the summary and in the metadata. Those of so(n), so(p,q), su(n), sl(n,R),
gl(n) and sp(2n,R) of higher degree are tr X^k, tr J X^k (J: the product with i) and Pf X of the
matrix X with tr(X ξ) = <μ, ξ>; those of se(n), so(p,q) |x Rn are |Gamma ∧ L^k|^2, the squares of
wedge products of the vector with the form L = Σ L_ij e_i∧e_j, i < j, and Gamma ∧ L^m, n = 2m + 1;
that of sl(n,R) |x Rn is det(Gamma, Gamma X, ...), of the rows Gamma X^j.
Formulas have + - * / ^, · and × between vectors, |v|, sqrt, cbrt, exp, ln, log10, sin, cos, tan,
arcsin, arccos, arctan, sinh, cosh, tanh, atan2, hypot, if(x >= 1, y, z), sum(S[i]·S[i+1]),
sum(S[i]·S[j], i < j), pi, and Greek letters by name (Gamma1) or as they are (Γ₁); there is no
product without *. A coordinate must not have the name of another column.
so(3), su(2), se(3) and sums of so(3) and su(2) have the formulations
collective, reduced and direct; so(n), so(p,q), sp(2n,R) and gl(n) of dimension 4 to 64
collective, along copies of their matrices, and direct; others without a centre, or with a
derivation or a cocycle that does not vanish there, collective, on T*V by a Clebsch map, with a
warning where its steps are not Poisson, and direct; the others direct, which is not Poisson.
Without the key: collective where there is reduced, too, or along matrices, and direct elsewhere.

Examples:
  heavytop simulate --out kovalevskaya.csv        # the paper's top
  heavytop simulate top.toml --out top.csv
  heavytop simulate --preset multibody-benchmark --out benchmark.npz
  heavytop simulate --preset lagrange top.toml --out top.parquet   # the preset but for top.toml
  heavytop simulate top.toml --set integrator.end=50 --set integrator.scheme=gauss-4 --out top.csv
  sed s/0.02/0.01/ top.toml | heavytop simulate - --out top.csv    # from standard input
  heavytop simulate top.toml --out top.csv --resume                # after an interruption
  heavytop simulate top.toml --out top.csv --restart               # discard the checkpoint
  heavytop simulate top.toml --out top.csv --dry-run               # rows, size and time only
  heavytop simulate top.toml --out top.csv --json                  # a summary on stdout
  heavytop simulate top.toml --out top.csv --check                 # its error and order, too
  heavytop simulate braked.toml --out braked.csv --balance         # what the forces supply
  heavytop simulate top.toml --out - | gzip > top.csv.gz           # to standard output, in CSV";

pub(crate) const ANIMATE: &str = "\
Show a top in motion, on a page for a browser.

The page is one file, which needs neither others nor a network. It shows in space the body, as the
homogeneous ellipsoid about the support that has its principal moments, its principal axes, the
centre of mass with the trace of its direction on the sphere, the angular momentum and the vertical;
and below h, f1, f2 and, where the top has them, f3, K, G and C against time. Play, pause, go
anywhere in time, choose the speed, drag to turn the view; the page says which keys do it.

At first the speed is that at which the first precession, or a tumble of a body without weight,
takes some ten seconds, unless the body then turned too fast for an eye; the page says which. A body
without weight has no post.

The attitude is followed along with (Π, Γ); the direct equations have none. It starts with the
shortest rotation R for which Γ = Rᵀe3.

Every n-th step is a frame, and the last; n is [output] every, or the least multiple of it that
gives at most 20000 frames, some 3.5 MB. Between frames the page interpolates, and there is a
warning where the body turns by more than 1 rad from one to the next.";

pub(crate) const ANIMATE_EXAMPLES: &str = "\
Examples:
  heavytop animate --out kovalevskaya.html        # the paper's top
  heavytop animate top.toml --out top.html
  heavytop animate --preset lagrange --out lagrange.html --json   # a summary on stdout
Open the page in a browser; top.html#t=12.5 shows the moment t = 12.5 s.";
