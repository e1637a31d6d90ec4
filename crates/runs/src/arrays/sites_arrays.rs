//! Spins and vortices as a system of arrays: [`SitesArrays`].

use super::any_arrays::{ArrayShape, Arrays};
use super::arguments::Given;
use super::directions::{Directions, on_cone};
use super::sites::{SitesSystem, momenta, numbers, total};
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents, VectorField};
use core::f64::consts::{PI, TAU};
use core::fmt;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_formula_systems::FormulaSystemError;
use nalgebra::Vector3;

/// The largest number of periods of a wave along an axis.
const MOST_PERIODS: f64 = 1e6;

/// The result of a start.
pub(super) type Started = Result<Vec<f64>, FormulaSystemError>;

/// A system on (so(3)∗)ᴺ, whose state is one array of N vectors.
pub(super) struct SitesArrays {
    pub(super) system: SitesSystem,
    /// The name of the array.
    pub(super) name: &'static str,
    pub(super) hamiltonian: &'static str,
    /// The shape of the array, without the three components.
    pub(super) shape: Vec<usize>,
    /// The factors of m_i in the Casimir C = Σ |w_i m_i|²; all 1 if there are none.
    pub(super) weights: Option<Vec<f64>>,
    /// The axis along which Σ m_i is conserved: `None` for all axes, and 0 for none.
    pub(super) symmetry: Option<Vector3<f64>>,
    pub(super) start: fn(&Self, &Given<'_>) -> Started,
}

impl fmt::Debug for SitesArrays {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "SitesArrays({:?}, {:?})", self.name, self.shape)
    }
}

impl SitesArrays {
    fn count(&self) -> usize {
        self.shape.iter().product()
    }
}

impl Arrays for SitesArrays {
    fn algebra_name(&self) -> String {
        format!("so(3)^{}", self.count())
    }

    fn hamiltonian(&self) -> &'static str {
        self.hamiltonian
    }

    fn arrays(&self) -> Vec<ArrayShape> {
        let shape = [&self.shape[..], &[3]].concat();
        vec![ArrayShape { name: self.name, shape, block: 3 }]
    }

    /// h, the components of Σ m_i that are conserved, and the Casimir C.
    fn invariant_names(&self) -> Vec<String> {
        let mut names = vec!["h".to_owned()];
        match self.symmetry {
            None => names.extend((1..=3).map(|i| format!("M{i}"))),
            Some(axis) if axis != Vector3::zeros() => names.push("M".into()),
            Some(_) => {}
        }
        names.push("C".into());
        names
    }

    fn invariants(&self, state: &[f64], values: &mut Vec<f64>) {
        let m = momenta(state);
        let sum = total(&m.0);
        values.push(self.system.energy(&m));
        match self.symmetry {
            None => values.extend(sum.iter()),
            Some(axis) if axis != Vector3::zeros() => {
                values.push(sum.dot(&(axis / axis.amax()).normalize()))
            }
            Some(_) => {}
        }
        values.push(match &self.weights {
            None => m.0.iter().map(Vector3::norm_squared).sum(),
            Some(weights) => m.0.iter().zip(weights).map(|(m, w)| (m * *w).norm_squared()).sum(),
        });
    }

    fn differential(&self, state: &[f64]) -> Vec<f64> {
        self.system.differential(&momenta(state))
    }

    fn rate(&self, state: &[f64]) -> Vec<f64> {
        numbers(&self.system.at(&momenta(state)).0)
    }

    fn fastest_rate(&self, state: &[f64]) -> f64 {
        self.system.fastest_rate(&momenta(state))
    }

    fn formulations(&self) -> &'static [Formulation] {
        SitesSystem::FORMULATIONS
    }

    fn offers(&self, formulation: Formulation, scheme: SchemeName) -> bool {
        SitesSystem::offers(formulation, scheme)
    }

    fn integrator(&self, method: &Method) -> Result<AnyIntegrator, RunFailure> {
        self.system.integrator(method, self.count())
    }

    fn tangent_integrator(
        &self,
        method: &Method,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        self.system.tangent_integrator(method, self.count())
    }

    fn start(&self, given: &Given<'_>) -> Started {
        (self.start)(self, given)
    }
}

/// Returns spins of these shape: those that are given as S, or unit vectors along a direction, on the cone of a wave, and
/// tilted at random.
pub(super) fn spin_start(shape: &[usize], given: &Given<'_>, random: &mut Directions) -> Started {
    let count: usize = shape.iter().product();
    let spins = given.values("S");
    if given.has("S") {
        given.require_alone("S", &["direction", "waves", "cone", "tilt", "seed"])?;
        if spins.len() != 3 * count {
            let needed = format!(
                "{} numbers, an array of shape {:?}, got {}",
                3 * count,
                [shape, &[3]].concat(),
                spins.len()
            );
            return Err(given.refused("S", needed));
        }
        if let Some(i) = spins.as_chunks::<3>().0.iter().position(|s| *s == [0.0; 3]) {
            return Err(given.refused("S", format!("spins other than 0; number {} is 0", i + 1)));
        }
        return Ok(spins.to_vec());
    }
    let direction = given.vector("direction");
    if direction == Vector3::zeros() {
        return Err(given.refused("direction", "different from 0".into()));
    }
    let axis = (direction / direction.amax()).normalize();
    let (waves, cone, tilt) = (given.values("waves"), given.number("cone"), given.number("tilt"));
    if given.has("waves") && waves.len() != shape.len() {
        let needed = format!("a number for each of {} axes, got {}", shape.len(), waves.len());
        return Err(given.refused("waves", needed));
    }
    if let Some(wave) = waves.iter().find(|wave| wave.abs() > MOST_PERIODS) {
        return Err(given.refused("waves", format!("at most {MOST_PERIODS:e}, got {wave:e}")));
    }
    for (name, angle) in [("cone", cone), ("tilt", tilt)] {
        if !(0.0..=PI).contains(&angle) {
            return Err(given.refused(name, format!("from 0 to pi, got {angle}")));
        }
    }
    let spin = |i: usize| {
        // The last index is the fastest.
        let (mut rest, mut turns) = (i, 0.0);
        for (count, wave) in shape.iter().zip(waves).rev() {
            turns += (rest % count) as f64 * wave / *count as f64;
            rest /= count;
        }
        let on_wave = on_cone(&axis, cone, TAU * turns.fract());
        if tilt == 0.0 { on_wave } else { random.within(tilt, &on_wave) }
    };
    Ok(numbers(&(0..count).map(spin).collect::<Vec<_>>()))
}
