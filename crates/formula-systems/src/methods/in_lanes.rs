//! The integrators whose stages are computed side by side: [`Integration::make_in_lanes`].

use super::integration::Integration;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::realisations::collective::{RealisedCollective, RealisedField};
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{
    AnyIntegrator, AnyState, Collective, Composition, Direct, FieldInLanes, HamiltonianField,
    RungeKutta, Scheme, StagesInLanes, Start,
};
use core::ops::RangeInclusive;
use heavytop::SpinorRealisation;
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::{LiePoisson, Se3, So3, Vector};
use momentum_map::HOPF;
use std::sync::Arc;

/// The numbers of stages for which there are registers, and something to put into them.
const STAGES: RangeInclusive<u8> = 2..=8;

/// An integrator, or `None` where the stages are computed one by one.
type MadeInLanes = Result<Option<AnyIntegrator>, FormulaSystemError>;

/// A scheme that is applied to the field on the space of momenta.
type Along = StagesInLanes<Direct<Composition<RungeKutta>, RealisedField>>;

impl Integration<'_> {
    /// Makes the integrator that evaluates the formula for several stages at once, which are in the lanes of a register. It is
    /// `None` where there is none: the scheme has no such stages, or the state is one of many sites.
    pub(super) fn make_in_lanes(&self) -> MadeInLanes {
        match self.method.scheme() {
            SchemeName::Gauss(stages) if STAGES.contains(&stages) => {}
            _ => return Ok(None),
        }
        if let Some((momenta, is_plus)) = self.momenta() {
            return self.realised_in_lanes(momenta, is_plus);
        }
        let algebra = self.system.algebra();
        match (self.method.formulation(), algebra.family) {
            (Formulation::Collective, Family::Rotations) => {
                let hamiltonian = self.hamiltonian::<So3>()?;
                Ok(Some(self.in_lanes(Collective::new(self.scheme()?, HOPF, hamiltonian))))
            }
            (Formulation::Collective, Family::Motions) => {
                let hamiltonian = self.hamiltonian::<Se3>()?;
                let collective = Collective::new(self.scheme()?, SpinorRealisation, hamiltonian);
                Ok(Some(self.in_lanes(collective)))
            }
            (Formulation::Collective, Family::ManyRotations) => self.spinors_in_lanes(),
            (Formulation::Direct, Family::Motions) => {
                let space = LiePoisson::minus(Se3::default());
                let hamiltonian = self.hamiltonian::<Se3>()?;
                let field = HamiltonianField { space, hamiltonian };
                Ok(Some(self.in_lanes(Direct::new(self.scheme()?, field))))
            }
            (Formulation::Direct, _) => match algebra.width() {
                3 => self.completed_in_lanes::<3>(),
                6 => self.completed_in_lanes::<6>(),
                // A body in two fields and three spins have as many, and are common.
                9 => self.completed_in_lanes::<9>(),
                _ => self.table_in_lanes(),
            },
            _ => Ok(None),
        }
    }

    /// Applies the scheme to the equations on an algebra of any dimension.
    fn table_in_lanes(&self) -> MadeInLanes {
        let direct = self.side_by_side(Direct::new(self.scheme()?, self.table_field()));
        let momentum = self.momentum_of_any_size();
        Ok(Some(AnyIntegrator::of_states(direct, &momentum, &momentum)))
    }

    /// Applies the scheme to the equations, on the algebra that is completed to the dimension N.
    fn completed_in_lanes<const N: usize>(&self) -> MadeInLanes {
        Ok(Some(self.in_lanes(Direct::new(self.scheme()?, self.completed_field::<N>()?))))
    }

    /// Applies the scheme along the momenta of spinors. Their steps descend, and need no guard.
    fn spinors_in_lanes(&self) -> MadeInLanes {
        let momenta = Arc::new(QuadraticMomenta::of_rotations(self.start.len() / 3));
        let (motion, point) = (self.along(&momenta, true)?, origin(&momenta));
        let collective = RealisedCollective { motion, momenta };
        Ok(Some(AnyIntegrator::of_states(collective, &point, &self.momentum_of_any_size())))
    }

    /// Applies the scheme along quadratic momenta.
    fn realised_in_lanes(&self, momenta: Arc<QuadraticMomenta>, is_plus: bool) -> MadeInLanes {
        let (motion, point) = (self.along(&momenta, is_plus)?, origin(&momenta));
        let guarded = self.guarded(motion, momenta, self.scheme()?.order())?;
        Ok(Some(AnyIntegrator::of_states(guarded, &point, &self.momentum_of_any_size())))
    }

    /// Applies the scheme to the field on the space of the momenta.
    fn along(
        &self,
        momenta: &Arc<QuadraticMomenta>,
        is_plus: bool,
    ) -> Result<Along, FormulaSystemError> {
        let field = self.realised_field(momenta, is_plus)?;
        Ok(self.side_by_side(Direct::new(self.scheme()?, field)))
    }

    /// Computes the stages of an integrator side by side, without a measurement if wide registers are known to pay.
    fn side_by_side<I: FieldInLanes>(&self, integrator: I) -> StagesInLanes<I> {
        if self.system.motion().pays_in_wide_registers() {
            StagesInLanes::detected(integrator)
        } else {
            StagesInLanes::widest(integrator)
        }
    }

    /// Computes the stages of an integrator side by side, and hides its type.
    fn in_lanes<I>(&self, integrator: I) -> AnyIntegrator
    where
        I: FieldInLanes + Start<State: Vector, Momentum: Vector> + Send + Sync + 'static,
    {
        AnyIntegrator::new(self.side_by_side(integrator), self.system.algebra().dimension())
    }
}

/// Returns the origin of the space of momenta.
fn origin(momenta: &QuadraticMomenta) -> AnyState {
    AnyState::from_slice(&vec![0.0; momenta.size()])
}
