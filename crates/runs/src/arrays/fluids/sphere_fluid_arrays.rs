//! A fluid on the sphere as a system of arrays.

use super::fluid_start::fluid_start;
use super::sphere_fluid::SphereFluid;
use crate::arrays::any_arrays::{ArrayShape, Arrays, Started};
use crate::arrays::arguments::Given;
use crate::arrays::open::array_terms::ArrayTerms;
use crate::arrays::open::opened::Opening;
use crate::arrays::open::opened_fluid::OpenedFluid;
use crate::arrays::renewed::{Renewed, resumable_after};
use crate::error::RunFailure;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, Direct, VectorField,
};
use core::f64::consts::PI;
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use lie_poisson::State;
use lie_poisson_systems::ZeitlinCoordinates;
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, IsospectralRungeKutta, LargeSkewHermitian,
};

impl Arrays for SphereFluid {
    fn algebra_name(&self) -> String {
        format!("u({})", self.size())
    }

    fn hamiltonian(&self) -> &'static str {
        "-∫ψω/2"
    }

    fn arrays(&self) -> Vec<ArrayShape> {
        let n = self.size();
        vec![ArrayShape { name: "omega", shape: vec![n, n], block: n * n }]
    }

    /// h, the enstrophy Z, and the angular momentum, or its third component on a sphere that rotates.
    fn invariant_names(&self) -> Vec<String> {
        let all = ["h", "Z", "M3", "M1", "M2"].map(String::from);
        if self.0.rotates() { all[..3].to_vec() } else { all.to_vec() }
    }

    fn invariants(&self, state: &[f64], values: &mut Vec<f64>) {
        let w = self.matrix(state);
        let [x, y, z] = self.0.angular_momentum(&w);
        values.extend([self.0.energy(&w), self.0.enstrophy(&w), z]);
        if !self.0.rotates() {
            values.extend([x, y]);
        }
    }

    fn differential(&self, state: &[f64]) -> Vec<f64> {
        let (w, n) = (self.matrix(state), self.size());
        let mut p = LargeSkewHermitian::zeros(n);
        self.0.stream_into(&w, &mut p);
        // h = (2π/N) tr P(W − F), of which P is half of the slope.
        let scale = -4.0 * PI / n as f64;
        (0..n * n).map(|i| scale * p.coordinate(i)).collect()
    }

    fn rate(&self, state: &[f64]) -> Vec<f64> {
        let rate = CommutatorField::new(&self.0).at(&self.matrix(state));
        (0..rate.dimension()).map(|i| rate.coordinate(i)).collect()
    }

    /// A fluid turns by half of its vorticity, here by that of three times its root mean square.
    fn fastest_rate(&self, state: &[f64]) -> f64 {
        1.5 * (self.0.enstrophy(&self.matrix(state)) / (4.0 * PI)).sqrt()
    }

    fn formulations(&self) -> &'static [Formulation] {
        &[Formulation::Reduced, Formulation::Direct]
    }

    fn offers(&self, formulation: Formulation, scheme: SchemeName) -> bool {
        formulation.offers(scheme)
    }

    fn integrator(&self, method: &Method) -> Result<AnyIntegrator, RunFailure> {
        let (formulation, name) = (method.formulation(), method.scheme());
        let impossible = || MethodError::NoSuchPair { formulation, scheme: name };
        let scheme = name.runge_kutta(method.tolerance())?.ok_or_else(impossible)?;
        let period = resumable_after(self.size() * self.size());
        let zero = LargeSkewHermitian::zeros(self.size());
        Ok(match formulation {
            Formulation::Reduced => {
                let reduced = IsospectralRungeKutta::new(scheme, self.0.clone());
                AnyIntegrator::of_states(Renewed { integrator: reduced, period }, &zero, &zero)
            }
            _ => {
                let direct = Direct::new(ByPointer(scheme), CommutatorField::new(self.0.clone()));
                AnyIntegrator::of_states(Renewed { integrator: direct, period }, &zero, &zero)
            }
        })
    }

    /// The direct formulation alone has tangent vectors: those of isospectral steps are not computed.
    fn tangent_integrator(
        &self,
        method: &Method,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        if method.formulation() != Formulation::Direct {
            return Err(RunFailure::NoTangents { kind: "sphere-fluid", has: Formulation::Direct });
        }
        let (formulation, name) = (method.formulation(), method.scheme());
        let impossible = || MethodError::NoSuchPair { formulation, scheme: name };
        let scheme = name.runge_kutta(method.tolerance())?.ok_or_else(impossible)?;
        let state = AnyState::from_slice(&vec![0.0; self.size() * self.size()]);
        let period = resumable_after(self.size() * self.size());
        let direct = Direct::new(ByPointer(scheme), ZeitlinCoordinates(self.0.clone()));
        let renewed = Renewed { integrator: direct, period };
        Ok(AnyIntegrator::of_states_with_tangents(renewed, &state, &state))
    }

    fn opened(&self, terms: &ArrayTerms, step: f64) -> Option<Opening> {
        match terms {
            ArrayTerms::Fluid(terms) => Some(OpenedFluid::of(self, terms, step)),
            ArrayTerms::Lattice(_) => None,
        }
    }

    fn start(&self, given: &Given<'_>) -> Started {
        fluid_start(self, given)
    }

    fn present(&self, state: &mut [f64]) {
        let omega = self.0.coefficients(&self.matrix(state));
        self.write(&omega, state);
    }

    fn on_circle(&self, given: &[f64], colatitude: f64, count: usize) -> Option<Vec<f64>> {
        Some(self.read(given).values_on_circle(colatitude, count))
    }

    fn understand(&self, given: &mut [f64]) {
        let w = self.0.vorticity(&self.read(given));
        given.iter_mut().enumerate().for_each(|(i, x)| *x = w.coordinate(i));
    }
}
