//! The integrator of a system: one type for each algebra, formulation and scheme.

use super::offers::refusal;
use super::system_task::SystemTask;
use crate::algebras::system_algebra::Family;
use crate::{FormulaSystem, FormulaSystemError};
use collective_integrators::{
    Collective, Composition, Direct, Equivariant, HamiltonianField, LiftFree, RungeKutta,
    StageSolver,
};
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, MethodError, Scheme};
use lie_poisson::{
    Diagonal, ExtendedAdjoint, ExtendedCoadjoint, LieAlgebra, LiePoisson, Momentum, Se3, So3,
    StructureConstants, Vector,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian, structure_constants};
use momentum_map::{DualQuaternions, HOPF, Lift, Quaternions, Side, clebsch_realisation};

/// A system with the method of its integration, for runs from a state.
pub(super) struct Integration<'a> {
    pub(super) formulation: Formulation,
    pub(super) scheme: Scheme,
    pub(super) tolerance: f64,
    pub(super) system: &'a FormulaSystem,
    pub(super) start: &'a [f64],
}

/// The result of a task.
type Performed<K> = Result<<K as SystemTask>::Output, FormulaSystemError>;

impl Integration<'_> {
    /// Performs a task with the integrator.
    pub(super) fn perform<K: SystemTask>(&self, task: K) -> Performed<K> {
        let scheme = self.scheme;
        let solver = StageSolver { tolerance: self.tolerance, ..StageSolver::default() };
        let midpoint = || RungeKutta::implicit_midpoint().with_solver(solver);
        let failed = |source| MethodError::Scheme { scheme: scheme.name(), source };
        match scheme {
            Scheme::ImplicitMidpoint => self.with(midpoint(), task),
            Scheme::Gauss(stages) => {
                let gauss = RungeKutta::gauss(stages.into()).map_err(failed)?;
                self.with(gauss.with_solver(solver), task)
            }
            Scheme::ExplicitMidpoint => self.with(RungeKutta::explicit_midpoint(), task),
            Scheme::Rk4 => self.with(RungeKutta::rk4(), task),
            Scheme::Composed(raise) => {
                let substeps = raise.substeps().map_err(failed)?;
                self.with(Composition::new(midpoint(), substeps), task)
            }
            Scheme::Partitioned(_) => Err(self.impossible()),
        }
    }

    fn with<S: Equivariant, K: SystemTask>(&self, scheme: S, task: K) -> Performed<K> {
        let algebra = self.system.algebra();
        Ok(match (self.formulation, algebra.family) {
            (Formulation::Direct, _) => {
                return match algebra.width() {
                    3 => self.direct::<3, S, K>(scheme, task),
                    6 => self.direct::<6, S, K>(scheme, task),
                    10 => self.direct::<10, S, K>(scheme, task),
                    _ => self.direct::<15, S, K>(scheme, task),
                };
            }
            (Formulation::Collective, Family::Rotations) => {
                task.perform(&Collective::new(scheme, HOPF, self.hamiltonian::<So3>()?))
            }
            (Formulation::Reduced, Family::Rotations) => {
                task.perform(&LiftFree::new(scheme, Quaternions, self.hamiltonian::<So3>()?))
            }
            (Formulation::Collective, Family::Motions) => {
                let hamiltonian = self.hamiltonian::<Se3>()?;
                task.perform(&Collective::new(scheme, SpinorRealisation, hamiltonian))
            }
            (Formulation::Reduced, Family::Motions) => {
                task.perform(&LiftFree::new(scheme, DualQuaternions, self.hamiltonian::<Se3>()?))
            }
            (Formulation::Collective, Family::Other) => {
                return match algebra.dimension() {
                    3 => self.clebsch::<3, S, K>(scheme, task),
                    6 => self.clebsch::<6, S, K>(scheme, task),
                    _ => Err(self.impossible()),
                };
            }
            // `require` has refused every such pair.
            _ => return Err(self.impossible()),
        })
    }

    /// Applies the scheme on T∗V, read through the Clebsch map of two copies of the adjoint representation, extended by a
    /// derivation so that it sees the centre. Where the start has no lift, the coadjoint representation is extended.
    fn clebsch<const N: usize, S: Equivariant, K: SystemTask>(
        &self,
        scheme: S,
        task: K,
    ) -> Performed<K> {
        let table = self.table::<N>()?;
        let hamiltonian = self.hamiltonian::<StructureConstants<N>>()?;
        let start: Momentum<StructureConstants<N>> =
            Vector::from_coordinates(|i| self.start.get(i).copied().unwrap_or(0.0));
        let adjoint = ExtendedAdjoint::of(table.clone()).map_err(|_| self.impossible())?;
        let map = clebsch_realisation(Diagonal::<_, 2>(adjoint), Side::Right)?;
        if map.lift(&start).is_ok() {
            return Ok(task.perform(&Collective::new(scheme, map, hamiltonian)));
        }
        let coadjoint = ExtendedCoadjoint::of(table).map_err(|_| self.impossible())?;
        let map = clebsch_realisation(Diagonal::<_, 2>(coadjoint), Side::Right)?;
        Ok(task.perform(&Collective::new(scheme, map, hamiltonian)))
    }

    /// Applies the scheme to the equations, on the algebra that is completed to the dimension N.
    fn direct<const N: usize, S: Equivariant, K: SystemTask>(
        &self,
        scheme: S,
        task: K,
    ) -> Performed<K> {
        let space = LiePoisson::minus(self.table::<N>()?);
        let hamiltonian = of(self.system.completed())?;
        Ok(task.perform(&Direct::new(scheme, HamiltonianField { space, hamiltonian })))
    }

    fn table<const N: usize>(&self) -> Result<StructureConstants<N>, FormulaSystemError> {
        let entries = self.system.algebra().entries();
        structure_constants::<N>(entries).map_err(FormulaSystemError::Structure)
    }

    fn hamiltonian<A: LieAlgebra>(&self) -> Result<FormulaHamiltonian<A>, FormulaSystemError> {
        of(self.system.hamiltonian())
    }

    fn impossible(&self) -> FormulaSystemError {
        refusal(self.system.algebra(), self.formulation, self.scheme)
    }
}

/// Returns the Hamiltonian of a formula.
fn of<A: LieAlgebra>(formula: &Formula) -> Result<FormulaHamiltonian<A>, FormulaSystemError> {
    FormulaHamiltonian::of(formula).map_err(FormulaSystemError::Hamiltonian)
}
