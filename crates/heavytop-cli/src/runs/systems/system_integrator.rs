//! The integrator of a system for a formulation and a scheme.

use super::system_algebra::{Family, SystemAlgebra};
use crate::Error;
use crate::errors::SystemError;
use collective_integrators::{
    Collective, Composition, Direct, Equivariant, HamiltonianField, LiftFree, RungeKutta,
    StageSolver, Start,
};
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, MethodError, Scheme};
use lie_poisson::{
    Diagonal, ExtendedAdjoint, ExtendedCoadjoint, LieAlgebra, LiePoisson, Momentum, Se3, So3,
    StructureConstants, Vector,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian, structure_constants};
use momentum_map::{DualQuaternions, HOPF, Lift, Quaternions, Side, clebsch_realisation};

/// The dimensions of the algebras with a Clebsch map.
const CLEBSCH: [usize; 2] = [3, 6];

/// A task to perform with an integrator of a system, whatever its type.
pub(super) trait SystemTask {
    /// The result of the task.
    type Output;

    /// Performs the task.
    fn perform<I>(self, integrator: &I) -> Result<Self::Output, Error>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>;
}

/// A formulation, a scheme and the tolerance of its stage equations, for a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SystemMethod {
    pub formulation: Formulation,
    pub scheme: Scheme,
    pub tolerance: f64,
}

impl SystemMethod {
    /// Checks that the method exists for the algebra.
    pub fn require(&self, algebra: &SystemAlgebra) -> Result<(), SystemError> {
        let Self { formulation, scheme, .. } = *self;
        let partitioned = matches!(scheme, Scheme::Partitioned(_));
        let formulated = match formulation {
            Formulation::Direct => true,
            Formulation::Splitting => false,
            Formulation::Collective => {
                algebra.family != Family::Other || CLEBSCH.contains(&algebra.dimension())
            }
            Formulation::Reduced => algebra.family != Family::Other,
        };
        if formulated && !partitioned && formulation.offers(scheme) {
            return Ok(());
        }
        let has = if formulated {
            let schemes = formulation.schemes().filter(|s| !matches!(s, Scheme::Partitioned(_)));
            let names: Vec<_> = schemes.map(Scheme::name).collect();
            format!("{} has {}", formulation.name(), names.join(", "))
        } else if algebra.family == Family::Other {
            match CLEBSCH.contains(&algebra.dimension()) {
                true => "it has direct and collective".into(),
                false => "write formulation = \"direct\"".into(),
            }
        } else {
            "it has collective, reduced and direct".into()
        };
        Err(SystemError::NoMethod { algebra: algebra.name.clone(), formulation, scheme, has })
    }

    /// Performs a task with the integrator of a Hamiltonian, for runs from a start.
    pub fn integrate<K: SystemTask>(
        &self,
        algebra: &SystemAlgebra,
        hamiltonian: &Formula,
        start: &[f64],
        task: K,
    ) -> Result<K::Output, Error> {
        let solver = StageSolver { tolerance: self.tolerance, ..StageSolver::default() };
        let midpoint = || RungeKutta::implicit_midpoint().with_solver(solver);
        let failed = |source| MethodError::Scheme { scheme: self.scheme.name(), source };
        let system = System { method: self, algebra, hamiltonian, start };
        match self.scheme {
            Scheme::ImplicitMidpoint => system.with(midpoint(), task),
            Scheme::Gauss(stages) => {
                let gauss = RungeKutta::gauss(stages.into()).map_err(failed)?;
                system.with(gauss.with_solver(solver), task)
            }
            Scheme::ExplicitMidpoint => system.with(RungeKutta::explicit_midpoint(), task),
            Scheme::Rk4 => system.with(RungeKutta::rk4(), task),
            Scheme::Composed(raise) => {
                let substeps = raise.substeps().map_err(failed)?;
                system.with(Composition::new(midpoint(), substeps), task)
            }
            Scheme::Partitioned(_) => Err(system.impossible()),
        }
    }
}

/// A Hamiltonian on an algebra, with the method of its integration.
struct System<'a> {
    method: &'a SystemMethod,
    algebra: &'a SystemAlgebra,
    hamiltonian: &'a Formula,
    start: &'a [f64],
}

impl System<'_> {
    fn with<S: Equivariant, K: SystemTask>(&self, scheme: S, task: K) -> Result<K::Output, Error> {
        match (self.method.formulation, self.algebra.family) {
            (Formulation::Direct, _) => match self.algebra.width() {
                3 => self.direct::<3, S, K>(scheme, task),
                6 => self.direct::<6, S, K>(scheme, task),
                10 => self.direct::<10, S, K>(scheme, task),
                _ => self.direct::<15, S, K>(scheme, task),
            },
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
            (Formulation::Collective, Family::Other) => match self.algebra.dimension() {
                3 => self.clebsch::<3, S, K>(scheme, task),
                6 => self.clebsch::<6, S, K>(scheme, task),
                _ => Err(self.impossible()),
            },
            // `require` has refused every such pair.
            _ => Err(self.impossible()),
        }
    }

    /// Applies the scheme on T∗V, read through the Clebsch map of two copies of the adjoint representation, extended by a
    /// derivation so that it sees the centre. Where the start has no lift, the coadjoint representation is extended.
    fn clebsch<const N: usize, S: Equivariant, K: SystemTask>(
        &self,
        scheme: S,
        task: K,
    ) -> Result<K::Output, Error> {
        let table =
            structure_constants::<N>(&self.algebra.entries).map_err(SystemError::Brackets)?;
        let hamiltonian = self.hamiltonian::<StructureConstants<N>>()?;
        let start: Momentum<StructureConstants<N>> =
            Vector::from_coordinates(|i| self.start.get(i).copied().unwrap_or(0.0));
        let adjoint = ExtendedAdjoint::of(table.clone()).map_err(|_| self.impossible())?;
        let map = clebsch_realisation(Diagonal::<_, 2>(adjoint), Side::Right)?;
        if map.lift(&start).is_ok() {
            return task.perform(&Collective::new(scheme, map, hamiltonian));
        }
        let coadjoint = ExtendedCoadjoint::of(table).map_err(|_| self.impossible())?;
        let map = clebsch_realisation(Diagonal::<_, 2>(coadjoint), Side::Right)?;
        task.perform(&Collective::new(scheme, map, hamiltonian))
    }

    /// Applies the scheme to the equations, on the algebra that is completed to the dimension N.
    fn direct<const N: usize, S: Equivariant, K: SystemTask>(
        &self,
        scheme: S,
        task: K,
    ) -> Result<K::Output, Error> {
        let table = structure_constants::<N>(&self.algebra.entries);
        let space = LiePoisson::minus(table.map_err(SystemError::Brackets)?);
        let hamiltonian = self.hamiltonian::<StructureConstants<N>>()?;
        task.perform(&Direct::new(scheme, HamiltonianField { space, hamiltonian }))
    }

    fn hamiltonian<A: LieAlgebra>(&self) -> Result<FormulaHamiltonian<A>, Error> {
        FormulaHamiltonian::of(self.hamiltonian)
            .map_err(|source| SystemError::Formula { key: "hamiltonian".into(), source }.into())
    }

    fn impossible(&self) -> Error {
        self.method.require(self.algebra).err().map_or(
            MethodError::NoSuchPair {
                formulation: self.method.formulation,
                scheme: self.method.scheme,
            }
            .into(),
            Error::from,
        )
    }
}
