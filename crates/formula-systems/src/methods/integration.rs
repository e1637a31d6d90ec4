//! The integrator of a system: one type for each algebra and formulation.

use super::clebsch::clebsch_maps::{ClebschMap, clebsch_map};
use super::clebsch::invariant_guard::InvariantGuard;
use super::formula_of_sites::FormulaOfSites;
use super::offers::refusal;
use super::table_field::TableField;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::realisations::collective::{RealisedCollective, RealisedField};
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, Collective, CollectiveSites, Composition,
    Direct, HamiltonianField, LiftFree, LiftFreeSites, RungeKutta, Scheme, Start,
    TangentIntegrator,
};
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, Method};
use lie_poisson::{
    Covector, LieAlgebra, LiePoisson, Momentum, Se3, Sites, So3, State, StructureConstants, Vector,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian, structure_constants};
use momentum_map::{DualQuaternions, HOPF, Lift, PoissonMap, Quaternions};
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
        let own = self.system.algebra().realisation().is_some();
        (has_lift && !own).then(collective).transpose()
    }

    /// Returns the scheme of the method.
    pub(super) fn scheme(&self) -> Result<Composition<RungeKutta>, FormulaSystemError> {
        let scheme = self.method.scheme().runge_kutta(self.method.tolerance())?;
        scheme.ok_or_else(|| self.impossible())
    }

    fn with(&self, scheme: AnyScheme) -> Made {
        let algebra = self.system.algebra();
        if let Some((momenta, is_plus)) = self.momenta()? {
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
            (Formulation::Collective, Family::Other) => {
                return match algebra.width() {
                    3 => self.clebsch::<3>(scheme),
                    _ => self.clebsch::<6>(scheme),
                };
            }
            // `require` has refused every such pair.
            _ => return Err(self.impossible()),
        })
    }

    /// Applies the scheme on T∗V, read through the Clebsch map, on the algebra that is completed to the dimension N.
    fn clebsch<const N: usize>(&self, scheme: AnyScheme) -> Made {
        let hamiltonian: FormulaHamiltonian<StructureConstants<N>> = of(self.system.motion())?;
        let (map, order) = (self.clebsch_map::<N>()?, scheme.order());
        // A step of these costs so much that calls cost nothing.
        let collective = Collective::new(ByPointer(scheme), map, hamiltonian);
        Ok(self.any(InvariantGuard::new(collective, order, self.system)))
    }

    /// Applies the scheme along momenta of one's own.
    fn realised(&self, scheme: AnyScheme, momenta: Arc<QuadraticMomenta>, is_plus: bool) -> Made {
        let (order, point) = (scheme.order(), AnyState::from_slice(&vec![0.0; momenta.size()]));
        let motion = Direct::new(ByPointer(scheme), self.realised_field(&momenta, is_plus)?);
        let guarded = self.guarded(RealisedCollective { motion, momenta }, order)?;
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

    /// Guards a collective integrator along momenta of one's own.
    ///
    /// # Errors
    /// If the start has no lift. That is for the start of a run to say; here it is refused early.
    pub(super) fn guarded<I: Start<Momentum = AnyState>>(
        &self,
        collective: I,
        order: usize,
    ) -> Result<InvariantGuard<I>, FormulaSystemError> {
        collective.start(&self.momentum_of_any_size())?;
        Ok(InvariantGuard::new(collective, order, self.system))
    }

    /// Returns the start.
    pub(super) fn momentum_of_any_size(&self) -> AnyState {
        AnyState::from_slice(self.start)
    }

    /// Returns the momenta along which the collective method goes, and whether their bracket is the plus bracket: one's own, or
    /// those of a Clebsch map of a large algebra.
    pub(super) fn momenta(
        &self,
    ) -> Result<Option<(Arc<QuadraticMomenta>, bool)>, FormulaSystemError> {
        let algebra = self.system.algebra();
        Ok(match (self.method.formulation(), algebra.realisation(), algebra.family) {
            (Formulation::Collective, Some((momenta, verdict)), _) => {
                Some((Arc::clone(momenta), verdict.is_plus))
            }
            (Formulation::Collective, None, Family::Other)
                if ![3, 6].contains(&algebra.width()) =>
            {
                Some((Arc::new(QuadraticMomenta::clebsch(algebra.table())?), true))
            }
            _ => None,
        })
    }

    /// Returns whether the steps of affine schemes descend to 𝔤∗ along the map that [`clebsch`](Self::clebsch) uses.
    pub(super) fn descends(&self) -> Result<bool, FormulaSystemError> {
        let algebra = self.system.algebra();
        if let (Formulation::Collective, Some(verdict)) =
            (self.method.formulation(), algebra.verdict())
        {
            return Ok(verdict.descends());
        }
        match (self.method.formulation(), algebra.family, algebra.width()) {
            (Formulation::Collective, Family::Other, 3) => self.clebsch_descends::<3>(),
            (Formulation::Collective, Family::Other, 6) => self.clebsch_descends::<6>(),
            (Formulation::Collective, Family::Other, _) => {
                QuadraticMomenta::clebsch_descends(algebra.table())
            }
            _ => Ok(true),
        }
    }

    fn clebsch_descends<const N: usize>(&self) -> Result<bool, FormulaSystemError> {
        Ok(self.clebsch_map::<N>()?.equivariant_maps_descend())
    }

    /// Returns the Clebsch map of the adjoint representation. If the start has no lift, it is that of the coadjoint
    /// representation.
    fn clebsch_map<const N: usize>(&self) -> Result<ClebschMap<N>, FormulaSystemError> {
        let algebra = (self.table::<N>()?, self.system.algebra().dimension());
        clebsch_map(algebra, &self.momentum::<N>(), || self.impossible())
    }

    /// Returns the start as a momentum; coordinates that complete it are zero.
    fn momentum<const N: usize>(&self) -> Momentum<StructureConstants<N>> {
        Vector::from_coordinates(|i| self.start.get(i).copied().unwrap_or(0.0))
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
        let space = LiePoisson::minus(self.table::<N>()?);
        let hamiltonian = of(self.system.motion())?;
        Ok(self.any(Direct::new(scheme, HamiltonianField { space, hamiltonian })))
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

    fn table<const N: usize>(&self) -> Result<StructureConstants<N>, FormulaSystemError> {
        let entries = self.system.algebra().entries();
        structure_constants::<N>(entries).map_err(FormulaSystemError::Structure)
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
