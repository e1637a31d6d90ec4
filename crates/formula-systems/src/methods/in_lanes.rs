//! The integrators whose stages are computed side by side: [`Integration::make_in_lanes`].

use super::clebsch::invariant_guard::InvariantGuard;
use super::integration::{Integration, of};
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use collective_integrators::{
    AnyIntegrator, Collective, Direct, FieldInLanes, HamiltonianField, Scheme, StagesInLanes, Start,
};
use core::ops::RangeInclusive;
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::{LiePoisson, Se3, So3, Vector};
use momentum_map::HOPF;

/// The numbers of stages for which there are registers, and something to put into them.
const STAGES: RangeInclusive<u8> = 2..=8;

/// An integrator, or `None` where the stages are computed one by one.
type MadeInLanes = Result<Option<AnyIntegrator>, FormulaSystemError>;

impl Integration<'_> {
    /// Makes the integrator that evaluates the formula for several stages at once, which are in the lanes of a register. It is
    /// `None` where there is none: the scheme has no such stages, or the dimension of the states is known only at run time.
    pub(super) fn make_in_lanes(&self) -> MadeInLanes {
        match self.method.scheme() {
            SchemeName::Gauss(stages) if STAGES.contains(&stages) => {}
            _ => return Ok(None),
        }
        let algebra = self.system.algebra();
        let has_realisation = algebra.realisation().is_some();
        match (self.method.formulation(), algebra.family, algebra.width()) {
            (Formulation::Collective, ..) if has_realisation => Ok(None),
            (Formulation::Collective, Family::Rotations, _) => {
                let hamiltonian = self.hamiltonian::<So3>()?;
                Ok(Some(self.in_lanes(Collective::new(self.scheme()?, HOPF, hamiltonian))))
            }
            (Formulation::Collective, Family::Motions, _) => {
                let hamiltonian = self.hamiltonian::<Se3>()?;
                let collective = Collective::new(self.scheme()?, SpinorRealisation, hamiltonian);
                Ok(Some(self.in_lanes(collective)))
            }
            (Formulation::Collective, Family::Other, 3) => self.clebsch_in_lanes::<3>(),
            (Formulation::Collective, Family::Other, 6) => self.clebsch_in_lanes::<6>(),
            (Formulation::Direct, Family::Motions, _) => {
                let space = LiePoisson::minus(Se3::default());
                let hamiltonian = self.hamiltonian::<Se3>()?;
                let field = HamiltonianField { space, hamiltonian };
                Ok(Some(self.in_lanes(Direct::new(self.scheme()?, field))))
            }
            (Formulation::Direct, _, 3) => self.direct_in_lanes::<3>(),
            (Formulation::Direct, _, 6) => self.direct_in_lanes::<6>(),
            _ => Ok(None),
        }
    }

    fn clebsch_in_lanes<const N: usize>(&self) -> MadeInLanes {
        let (scheme, map) = (self.scheme()?, self.clebsch_map::<N>()?);
        let order = scheme.order();
        let collective = Collective::new(scheme, map, of(self.system.motion())?);
        let guarded = InvariantGuard::new(StagesInLanes::widest(collective), order, self.system);
        Ok(Some(AnyIntegrator::new(guarded, self.system.algebra().dimension())))
    }

    fn direct_in_lanes<const N: usize>(&self) -> MadeInLanes {
        let space = LiePoisson::minus(self.table::<N>()?);
        let field = HamiltonianField { space, hamiltonian: of(self.system.motion())? };
        Ok(Some(self.in_lanes(Direct::new(self.scheme()?, field))))
    }

    /// Computes the stages of an integrator side by side, and hides its type.
    fn in_lanes<I>(&self, integrator: I) -> AnyIntegrator
    where
        I: FieldInLanes + Start<State: Vector, Momentum: Vector> + Send + Sync + 'static,
    {
        AnyIntegrator::new(StagesInLanes::widest(integrator), self.system.algebra().dimension())
    }
}
