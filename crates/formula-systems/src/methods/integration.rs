//! The integrator of a system: one type for each algebra and formulation.

use super::formula_of_sites::FormulaOfSites;
use super::invariant_guard::InvariantGuard;
use super::offers::refusal;
use super::table_field::TableField;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::realisations::collective::{RealisedCollective, RealisedField};
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, Collective, CollectiveSites, Composition,
    Direct, HamiltonianField, Integrator, LiftFree, LiftFreeSites, RungeKutta, Scheme, Start,
    TangentIntegrator,
};
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, Method};
use lie_poisson::{
    Covector, LieAlgebra, LiePoisson, Momentum, Se3, Sites, So3, State, StructureConstants, Vector,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian, structure_constants};
use momentum_map::{DualQuaternions, HOPF, Lift, Quaternions};
use nalgebra::Vector3;
use std::sync::Arc;

/// A system with the method of its integration, for runs from a state.
pub(super) struct Integration<'a> {
    pub(super) method: &'a Method,
    pub(super) system: &'a FormulaSystem,
    pub(super) start: &'a [f64],
}

/// The integrator of a system.
type Made = Result<AnyIntegrator<dyn AnyTangents>, FormulaSystemError>;

/// The equations on an algebra of a dimension that the compiler knows.
type CompletedField<const N: usize> =
    HamiltonianField<LiePoisson<StructureConstants<N>>, FormulaHamiltonian<StructureConstants<N>>>;

/// Any scheme, whose type is one: a step is a composition of one substep.
type AnyScheme = Composition<RungeKutta>;

impl Integration<'_> {
    /// Makes the integrator.
    pub(super) fn make(&self) -> Made {
        self.with(self.scheme()?)
    }

    /// Returns the collective method that is the same map as a reduced one, if the start has a lift.
    pub(super) fn with_lift(&self) -> Result<Option<Method>, FormulaSystemError> {
        let at = |i: usize| self.start.get(i).copied().unwrap_or(f64::NAN);
        let has_lift = match (self.method.formulation(), self.system.algebra().family) {
            (Formulation::Reduced, Family::Rotations) => {
                HOPF.lift(&<Momentum<So3>>::from_coordinates(at)).is_ok()
            }
            (Formulation::Reduced, Family::Motions) => {
                SpinorRealisation.lift(&<Momentum<Se3>>::from_coordinates(at)).is_ok()
            }
            _ => false,
        };
        let (scheme, tolerance) = (self.method.scheme(), self.method.tolerance());
        let collective =
            || self.system.algebra().method(Formulation::Collective, scheme, tolerance);
        let own = self.system.algebra().verdict().is_some();
        (has_lift && !own).then(collective).transpose()
    }

    /// Returns the scheme of the method.
    pub(super) fn scheme(&self) -> Result<Composition<RungeKutta>, FormulaSystemError> {
        let scheme = self.method.scheme().runge_kutta(self.method.tolerance())?;
        scheme.ok_or_else(|| self.impossible())
    }

    fn with(&self, scheme: AnyScheme) -> Made {
        let algebra = self.system.algebra();
        if let Some((momenta, is_plus)) = self.momenta() {
            return self.realised(scheme, momenta, is_plus);
        }
        Ok(match (self.method.formulation(), algebra.family) {
            // Π and Γ have units of their own, which the structure constants of an algebra do not tell.
            (Formulation::Direct, Family::Motions) => {
                let space = LiePoisson::minus(Se3::default());
                let hamiltonian = self.hamiltonian::<Se3>()?;
                self.any(Direct::new(scheme, HamiltonianField { space, hamiltonian }))
            }
            (Formulation::Direct, _) => {
                return match algebra.width() {
                    3 => self.direct::<3>(scheme),
                    6 => self.direct::<6>(scheme),
                    _ => Ok(self.direct_of_table(scheme)),
                };
            }
            (Formulation::Collective, Family::Rotations) => {
                self.any(Collective::new(scheme, HOPF, self.hamiltonian::<So3>()?))
            }
            (Formulation::Reduced, Family::Rotations) => {
                self.any(LiftFree::new(scheme, Quaternions, self.hamiltonian::<So3>()?))
            }
            (Formulation::Collective, Family::Motions) => {
                let hamiltonian = self.hamiltonian::<Se3>()?;
                self.any(Collective::new(scheme, SpinorRealisation, hamiltonian))
            }
            (Formulation::Reduced, Family::Motions) => {
                self.any(LiftFree::new(scheme, DualQuaternions, self.hamiltonian::<Se3>()?))
            }
            (Formulation::Collective, Family::ManyRotations) => {
                let collective = CollectiveSites::new(scheme, HOPF, self.formula_of_sites());
                let points = Sites::zeros_of(&(self.start.len() / 3));
                return Ok(AnyIntegrator::of_states_with_tangents(
                    collective,
                    &points,
                    &self.sites(),
                ));
            }
            (Formulation::Reduced, Family::ManyRotations) => {
                let reduced = LiftFreeSites::new(scheme, Quaternions, self.formula_of_sites());
                let (momenta, momentum) = (self.sites(), self.sites());
                return Ok(AnyIntegrator::of_states_with_tangents(reduced, &momenta, &momentum));
            }
            // `require` has refused every such pair.
            _ => return Err(self.impossible()),
        })
    }

    /// Applies the scheme along quadratic momenta.
    fn realised(&self, scheme: AnyScheme, momenta: Arc<QuadraticMomenta>, is_plus: bool) -> Made {
        let (order, point) = (scheme.order(), AnyState::from_slice(&vec![0.0; momenta.size()]));
        let motion = Direct::new(ByPointer(scheme), self.realised_field(&momenta, is_plus)?);
        let guarded = self.guarded(motion, momenta, order)?;
        Ok(AnyIntegrator::of_states_with_tangents(guarded, &point, &self.momentum_of_any_size()))
    }

    /// Returns the field on the space of the momenta.
    pub(super) fn realised_field(
        &self,
        momenta: &Arc<QuadraticMomenta>,
        is_plus: bool,
    ) -> Result<RealisedField, FormulaSystemError> {
        let system = self.system;
        // h or −h, with which the bracket of the momenta makes the motion.
        let hamiltonian = match is_plus == system.has_plus_bracket() {
            true => system.hamiltonian().clone(),
            false => system.hamiltonian().negated().map_err(FormulaSystemError::Hamiltonian)?,
        };
        Ok(RealisedField { momenta: Arc::clone(momenta), hamiltonian })
    }

    /// Makes a collective integrator of one of the [field](Self::realised_field), and guards it.
    ///
    /// # Errors
    /// If the start has no lift. That is for the start of a run to say; here it is refused early.
    pub(super) fn guarded<I: Integrator<State = AnyState>>(
        &self,
        motion: I,
        momenta: Arc<QuadraticMomenta>,
        order: usize,
    ) -> Result<InvariantGuard<RealisedCollective<I>>, FormulaSystemError> {
        momenta.lift(self.start)?;
        Ok(InvariantGuard::new(RealisedCollective { motion, momenta }, order, self.system))
    }

    /// Returns the start.
    pub(super) fn momentum_of_any_size(&self) -> AnyState {
        AnyState::from_slice(self.start)
    }

    /// Returns the momenta along which the collective method goes, and whether their bracket is the plus bracket: one's own, or
    /// those of a Clebsch map.
    pub(super) fn momenta(&self) -> Option<(Arc<QuadraticMomenta>, bool)> {
        let is_collective = self.method.formulation() == Formulation::Collective;
        is_collective.then(|| self.system.algebra().momenta()).flatten()
    }

    fn formula_of_sites(&self) -> FormulaOfSites {
        FormulaOfSites(self.system.motion().clone())
    }

    /// Returns the zero momentum of as many sites as the start has.
    fn sites(&self) -> Covector<Sites<Vector3<f64>>> {
        State::zeros_of(&(self.start.len() / 3))
    }

    /// Applies the scheme to the equations, on the algebra that is completed to the dimension N.
    fn direct<const N: usize>(&self, scheme: AnyScheme) -> Made {
        Ok(self.any(Direct::new(scheme, self.completed_field::<N>()?)))
    }

    /// Returns the equations on the algebra that is completed to the dimension N.
    pub(super) fn completed_field<const N: usize>(
        &self,
    ) -> Result<CompletedField<N>, FormulaSystemError> {
        let table = structure_constants::<N>(self.system.algebra().entries());
        let space = LiePoisson::minus(table.map_err(FormulaSystemError::Structure)?);
        Ok(HamiltonianField { space, hamiltonian: self.hamiltonian()? })
    }

    /// Applies the scheme to the equations on an algebra of any dimension.
    fn direct_of_table(&self, scheme: AnyScheme) -> AnyIntegrator<dyn AnyTangents> {
        let momentum = self.momentum_of_any_size();
        let direct = Direct::new(ByPointer(scheme), self.table_field());
        AnyIntegrator::of_states_with_tangents(direct, &momentum, &momentum)
    }

    pub(super) fn table_field(&self) -> TableField {
        let (algebra, hamiltonian) = (self.system.algebra(), self.system.motion().clone());
        TableField { table: algebra.table().clone(), hamiltonian }
    }

    /// Hides the type of an integrator.
    fn any<I>(&self, integrator: I) -> AnyIntegrator<dyn AnyTangents>
    where
        I: Start<State: Vector, Momentum: Vector> + TangentIntegrator + Send + Sync + 'static,
    {
        AnyIntegrator::with_tangents(integrator, self.system.algebra().dimension())
    }

    pub(super) fn hamiltonian<A: LieAlgebra>(
        &self,
    ) -> Result<FormulaHamiltonian<A>, FormulaSystemError> {
        of(self.system.motion())
    }

    fn impossible(&self) -> FormulaSystemError {
        refusal(self.system.algebra(), self.method.formulation(), self.method.scheme())
    }
}

/// Returns the Hamiltonian of a formula.
fn of<A: LieAlgebra>(formula: &Formula) -> Result<FormulaHamiltonian<A>, FormulaSystemError> {
    FormulaHamiltonian::of(formula).map_err(FormulaSystemError::Hamiltonian)
}
