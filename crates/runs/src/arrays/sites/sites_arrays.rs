//! Spins and vortices as a system of arrays: [`SitesArrays`].

use super::sites_system::{SitesSystem, momenta, numbers, total};
use crate::arrays::any_arrays::{ArrayShape, Arrays, Started};
use crate::arrays::arguments::Given;
use crate::arrays::open::array_terms::ArrayTerms;
use crate::arrays::open::opened::Opening;
use crate::arrays::open::opened_lattice::OpenedLattice;
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents, VectorField};
use core::fmt;
use heavytop::methods::{Formulation, Method, SchemeName};
use nalgebra::Vector3;

/// A system on (so(3)∗)ᴺ, whose state is one array of N vectors.
pub(in crate::arrays) struct SitesArrays {
    pub(in crate::arrays) system: SitesSystem,
    /// The name of the array.
    pub(in crate::arrays) name: &'static str,
    pub(in crate::arrays) hamiltonian: &'static str,
    /// The shape of the array, without the three components.
    pub(in crate::arrays) shape: Vec<usize>,
    /// The factors of m_i in the Casimir C = Σ |w_i m_i|²; all 1 if there are none.
    pub(in crate::arrays) weights: Option<Vec<f64>>,
    /// The axis along which Σ m_i is conserved: `None` for all axes, and 0 for none.
    pub(in crate::arrays) symmetry: Option<Vector3<f64>>,
    pub(in crate::arrays) start: fn(&Self, &Given<'_>) -> Started,
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

    fn opened(&self, terms: &ArrayTerms, step: f64) -> Option<Opening> {
        match (&self.system, terms) {
            (SitesSystem::Spins(lattice), ArrayTerms::Lattice(terms)) => {
                Some(OpenedLattice::of(lattice, terms, step))
            }
            _ => None,
        }
    }

    fn start(&self, given: &Given<'_>) -> Started {
        (self.start)(self, given)
    }
}
