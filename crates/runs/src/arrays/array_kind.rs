//! A system of arrays by name: [`ArrayKind`].

use super::any_arrays::Made;
use super::arguments::Given;
use super::systems::{many_vortices, sphere_fluid, spin_lattice, vibrating_lattice};
use heavytop::methods::Formulation;
use lie_poisson_formula_systems::Parameter;

/// A system by name whose states are arrays of any size: what its parameters are, and what a start is given by.
///
/// ```text
/// spin-lattice:      h = −Σ_i ( Σ_o J_o s_i·s_(i+o) + K (a·s_i)² + B·s_i ),              ds_i/dt = dh/ds_i × s_i
/// vibrating-lattice: h = Σ_i [ p_i²/2m + ½κ(qᵢ₊₁ − q_i)² − (J − a(qᵢ₊₁ − q_i)) s_i·sᵢ₊₁ ],  the same, and q, p canonical
/// vortices:          h = (1/4π) Σ_(i<j) k_i k_j ln(2 − 2 x_i·x_j),  m_i = k_i x_i,       dm_i/dt = m_i × dh/dm_i
/// sphere-fluid:      h = −½ ∫ψ(ω − f),                                                   dW/dt = [P, W]/ħ
/// ```
///
/// A lattice has the bonds that go round its periodic axes, and none beyond an open end. Spins have the plus bracket, {s_a, s_b} = ε_abc s_c, and vortices the minus bracket. Spins and their constants are numbers
/// without units, strengths are in m²/s on the unit sphere, and the unit of time of fluids is arbitrary. The sources are those of
/// [`HeisenbergLattice`], [`SpinLattice`], [`ManyVortices`] and [`Zeitlin`].
///
/// [`HeisenbergLattice`]: lie_poisson_systems::HeisenbergLattice
/// [`SpinLattice`]: lie_poisson_systems::SpinLattice
/// [`ManyVortices`]: lie_poisson_systems::ManyVortices
/// [`Zeitlin`]: lie_poisson_systems::Zeitlin
///
/// # Example
/// ```
/// use lie_poisson_runs::{Arguments, ArrayKind};
/// let kind = ArrayKind::named("spin-lattice").ok_or("no such system")?;
/// let lattice = kind.system(&Arguments::new().list("shape", vec![8.0, 8.0]).number("exchange", 1.0))?;
/// let wave = Arguments::new().list("waves", vec![1.0, 0.0]).number("cone", 0.1);
/// assert_eq!(lattice.start_of(&wave)?.len(), 8 * 8 * 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ArrayKind {
    /// The name of the system.
    pub name: &'static str,
    /// What the system is, in a few words.
    pub about: &'static str,
    /// The parameters.
    pub parameters: &'static [Parameter],
    /// What a start is given by.
    pub start: &'static [Parameter],
    /// The formulation of the midpoint rule of the system with friction, forces and noise; `None` if it has none of
    /// them.
    pub opened: Option<Formulation>,
    pub(super) make: fn(&Given<'_>) -> Made,
}

impl ArrayKind {
    /// All systems of arrays by name. Vortices are in the catalogue of systems by formula, too, up to 48.
    pub const ALL: &[Self] = &[
        Self {
            name: sphere_fluid::NAME,
            about: "an ideal fluid on the sphere",
            parameters: sphere_fluid::PARAMETERS,
            start: sphere_fluid::START,
            opened: Some(Formulation::Reduced),
            make: sphere_fluid::make,
        },
        Self {
            name: spin_lattice::NAME,
            about: "classical spins on a lattice of one to three dimensions",
            parameters: spin_lattice::PARAMETERS,
            start: spin_lattice::START,
            opened: Some(Formulation::Direct),
            make: spin_lattice::make,
        },
        Self {
            name: vibrating_lattice::NAME,
            about: "classical spins on a chain of moving atoms",
            parameters: vibrating_lattice::PARAMETERS,
            start: vibrating_lattice::START,
            opened: None,
            make: vibrating_lattice::make,
        },
        Self {
            name: many_vortices::NAME,
            about: "point vortices on the unit sphere",
            parameters: many_vortices::PARAMETERS,
            start: many_vortices::START,
            opened: None,
            make: many_vortices::make,
        },
    ];

    /// Returns the system of this name, if there is one.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|kind| kind.name == name)
    }
}
