//! Configurations with forces to begin with, which `init --kind` writes beside those of the systems by name.

/// A rigid body at a temperature.
///
/// Source: A. Arnaudon, A. L. De Castro & D. D. Holm, *Noise and dissipation on coadjoint orbits*, J. Nonlinear Sci. 28 (2018).
const STOCHASTIC_RIGID_BODY: &str = r#"# A system for the program heavytop: a free rigid body with friction and noise that keep |Pi|.
# One path:   heavytop simulate FILE --out run.npz
# Draw it:    heavytop plot run.npz --out run.png
# Many paths: heavytop ensemble FILE --paths 1000 --out means.csv

[system]
kind = "rigid-body"

[system.parameters]
moments = [2.5, 1.5, 0.5]    # second moments of the mass along each axis, kg m²: I = (2, 3, 4)

[system.initial]
Pi = [2, 0, 0]               # kg m²/s, about the axis of the least moment: the highest energy

[damping]
friction = 2                 # θ in dΠ/dt = Π × Ω + θ Π × (Π × Ω), s/(kg m²)

[noise]
temperature = 0.2            # kT, J: the states have the weight exp(-h/kT) on the sphere of |Π|, in the end
seed = 1
path = 0                     # another number is another path

[integrator]
scheme = "implicit-midpoint"
step = 0.05                  # s
end = 10

[output]
every = 1                    # keep every n-th step, and the last
"#;

/// A symmetric top with a motor and a brake on its axis.
const DRIVEN_TOP: &str = r#"# A system for the program heavytop: a heavy top that a motor drives and that air brakes.
# Run it:  heavytop simulate FILE --out run.npz
# Draw it: heavytop plot run.npz --out run.png --columns Pi3,Gamma3,h

[body]
inertia = [0.3, 0.3, 0.2]    # principal moments about the support, kg m²: I1, I2 and I3 in formulas
weight_moment = 1            # m g l, N m
center_of_mass = [0, 0, 1]

[initial]
angular_velocity = [0, 0, 5] # rad/s
inclination = "20 deg"

[inputs.motor]               # N m, about the axis of the top
times = [0, 10, 20, 40]      # s
values = [1, 1, 0, 0]
interpolation = "linear"     # or constant, cubic

[torque]                     # N m, in the frame of the body; 0.05 N m s times the angular velocity is the friction
Pi = ["-0.05*Pi1/I1", "-0.05*Pi2/I2", "motor - 0.05*Pi3/I3"]

[integrator]
step = 0.01                  # s
end = 40

[output]
every = 5                    # keep every n-th step, and the last
attitude = true
"#;

/// All of them, by name.
pub(super) const WITH_FORCES: [(&str, &str); 2] =
    [("driven-top", DRIVEN_TOP), ("stochastic-rigid-body", STOCHASTIC_RIGID_BODY)];
