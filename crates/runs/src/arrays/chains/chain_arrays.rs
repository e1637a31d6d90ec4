//! Spins on a chain of atoms as a system of arrays.

use super::chain::Chain;
use super::lifted_chain::LiftedChain;
use crate::arrays::any_arrays::{ArrayShape, Arrays, Started};
use crate::arrays::arguments::Given;
use crate::arrays::renewed::{Renewed, resumable_after};
use crate::arrays::sites::sites_system::{momenta, total};
use crate::arrays::sites::spin_start::spin_start;
use crate::error::RunFailure;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, Direct, VectorField,
};
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use lie_poisson::larger;
use nalgebra::Vector3;

impl Arrays for Chain {
    fn algebra_name(&self) -> String {
        format!("so(3)^{0} with the phase space of {0} atoms", self.count)
    }

    fn hamiltonian(&self) -> &'static str {
        "sum(p[i]^2/(2*m) + κ*(q[i+1]-q[i])^2/2 - (J - a*(q[i+1]-q[i]))*S[i]·S[i+1])"
    }

    fn arrays(&self) -> Vec<ArrayShape> {
        let of_atoms = |name| ArrayShape { name, shape: vec![self.count], block: self.count };
        let spins = ArrayShape { name: "S", shape: vec![self.count, 3], block: 3 };
        vec![spins, of_atoms("q"), of_atoms("p")]
    }

    /// h, the total spin, the total momentum, and C = Σ |s_i|².
    fn invariant_names(&self) -> Vec<String> {
        ["h", "M1", "M2", "M3", "P", "C"].map(String::from).to_vec()
    }

    fn invariants(&self, state: &[f64], values: &mut Vec<f64>) {
        let (spins, atoms) = state.split_at(3 * self.count);
        let spins = momenta(spins).0;
        values.push(self.energy(state));
        values.extend(total(&spins).iter());
        values.push(atoms.iter().skip(self.count).sum());
        values.push(spins.iter().map(Vector3::norm_squared).sum());
    }

    fn differential(&self, state: &[f64]) -> Vec<f64> {
        let mut differential = vec![0.0; state.len()];
        Chain::differential(self, state, &mut differential);
        differential
    }

    fn rate(&self, state: &[f64]) -> Vec<f64> {
        self.at(&AnyState::from_slice(state)).as_slice().to_vec()
    }

    /// The fastest spin, or the fastest vibration 2√(κ/m).
    fn fastest_rate(&self, state: &[f64]) -> f64 {
        let differential = Arrays::differential(self, state);
        let spins = differential.get(..3 * self.count).unwrap_or_default();
        let turning = spins.as_chunks::<3>().0.iter().map(|x| Vector3::from(*x).norm());
        turning.fold(2.0 * (self.stiffness / self.mass).sqrt(), larger)
    }

    fn formulations(&self) -> &'static [Formulation] {
        &[Formulation::Collective, Formulation::Direct]
    }

    fn offers(&self, formulation: Formulation, scheme: SchemeName) -> bool {
        !matches!(scheme, SchemeName::Partitioned(_)) && formulation.offers(scheme)
    }

    fn integrator(&self, method: &Method) -> Result<AnyIntegrator, RunFailure> {
        Ok(self.tangent_integrator(method)?.without_tangents())
    }

    fn tangent_integrator(
        &self,
        method: &Method,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        let (formulation, name) = (method.formulation(), method.scheme());
        let impossible = || MethodError::NoSuchPair { formulation, scheme: name };
        let scheme = name.runge_kutta(method.tolerance())?.ok_or_else(impossible)?;
        let period = resumable_after(5 * self.count);
        let state = |numbers: usize| AnyState::from_slice(&vec![0.0; numbers * self.count]);
        Ok(match formulation {
            Formulation::Direct => {
                let direct = Direct::new(ByPointer(scheme), *self);
                AnyIntegrator::of_states_with_tangents(
                    Renewed { integrator: direct, period },
                    &state(5),
                    &state(5),
                )
            }
            _ => {
                let lifted = LiftedChain { scheme: ByPointer(scheme), chain: *self };
                AnyIntegrator::of_states_with_tangents(
                    Renewed { integrator: lifted, period },
                    &state(6),
                    &state(5),
                )
            }
        })
    }

    fn start(&self, given: &Given<'_>) -> Started {
        let mut state = spin_start(&[(self.count, true)], given)?;
        for name in ["q", "p"] {
            let values = given.values(name);
            if given.has(name) && values.len() != self.count {
                let needed =
                    format!("a number for each of {} atoms, got {}", self.count, values.len());
                return Err(given.refused(name, needed));
            }
            state.extend(values);
            state.resize(state.len() + self.count - values.len(), 0.0);
        }
        Ok(state)
    }
}
