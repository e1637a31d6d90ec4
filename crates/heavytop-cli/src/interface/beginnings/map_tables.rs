//! The tables that a configuration of a section or of a sweep begins with: [`MapTable`].

use clap::ValueEnum;

/// The command that a configuration is for, which makes many motions of a top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MapTable {
    /// A Poincaré section, by heavytop section.
    Section,
    /// Many tops at once, by heavytop sweep.
    Sweep,
}

impl MapTable {
    /// Returns the name of the command.
    pub(super) const fn command(self) -> &'static str {
        match self {
            Self::Section => "section",
            Self::Sweep => "sweep",
        }
    }

    /// Returns the table, with comments.
    pub(super) const fn text(self) -> &'static str {
        match self {
            Self::Section => {
                "
[section]
surface = \"Gamma3\"                             # or Pi1, ..., or an angle such as atan2(Gamma2, Gamma1)
level = 0.0                                    # its value on the surface
direction = \"up\"                               # the crossings that count: up, down or both
starts = 60                                    # motions with the energy and Π·Γ of [initial]
crossings = 500                                # of each
# energy = 11.75                               # h, J, instead of that of [initial]
# vertical_momentum = 4.46                     # Π·Γ, kg m²/s, instead of that of [initial]
# limits = { x = [0.0, 3.0], y = [-1.0, 1.0] } # what the picture shows, instead of all points
"
            }
            Self::Sweep => {
                "
[sweep]
observables = [\"megno\"]                        # 2 for regular motion; or lyapunov, final-state, ...

[[sweep.axes]]                                 # one axis draws a curve, two draw a map
parameter = \"initial.angular_momentum[0]\"      # or body.inertia[1], initial.inclination, ...
from = 0.0
to = 3.0
count = 32

[[sweep.axes]]
parameter = \"initial.angular_momentum[2]\"
from = 0.0
to = 4.0
count = 32
"
            }
        }
    }
}
