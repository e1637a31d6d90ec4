//! The integrator for a formulation and a scheme.

use super::wanted::{Attitude, DIMENSION, Tangents, Wanted, with_attitude};
use super::{ComposedScheme, Formulation, MethodError, PartitionedScheme, SchemeName};
use crate::kernels::gauss_one::collective_gauss::CollectiveGauss;
use crate::kernels::midpoint::top_midpoint::TopMidpoint;
use crate::paper::spinor_realisation::SpinorRealisation;
use crate::splittings::rotors::RotorSplitting;
use crate::splittings::symmetric_top::SymmetricTopSplitting;
use crate::tops::top::HeavyTop;
use collective_integrators::{
    AnyIntegrator, AnyTangents, Collective, Composition, Direct, FirstHalf, HamiltonianField,
    LiftFree, PartitionedRungeKutta, RungeKutta, SchemeError, Splitting, StageSolver,
};
use lie_poisson::{InstructionSet, LiePoisson, MissingInstructions, Quaternion, Se3, Vector};
use momentum_map::DualQuaternions;

/// A formulation, a scheme, and the tolerance of its stage equations: an integrator for every top.
///
/// [The module](super) has an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    formulation: Formulation,
    scheme: SchemeName,
    tolerance: f64,
    /// The instruction set of the kernels; `None` for the one that is fastest here.
    instructions: Option<InstructionSet>,
}

impl Method {
    /// Creates the method from a formulation and a scheme. Stages are solved to `tolerance`; 0 iterates to the
    /// round-off floor.
    ///
    /// # Errors
    /// Returns [`MethodError::NoSuchPair`] if the formulation does not offer the scheme, and
    /// [`MethodError::Tolerance`] for a tolerance that is negative or not finite.
    pub fn new(
        formulation: Formulation,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Self, MethodError> {
        if !formulation.offers(scheme) {
            return Err(MethodError::NoSuchPair { formulation, scheme });
        }
        Self::of_system(formulation, scheme, tolerance)
    }

    /// Creates the method of a system that is no top, and that says itself which schemes it has in which formulation.
    ///
    /// # Errors
    /// Returns [`MethodError::Tolerance`] for a tolerance that is negative or not finite.
    pub fn of_system(
        formulation: Formulation,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Self, MethodError> {
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(MethodError::Tolerance { value: tolerance });
        }
        Ok(Self { formulation, scheme, tolerance, instructions: None })
    }

    /// Replaces the instruction set of the kernels [`CollectiveGauss`] and [`TopMidpoint`], which is otherwise the one
    /// that is fastest on this processor.
    ///
    /// With [`InstructionSet::Portable`] results are bit-identical on every processor. Steps on different sets differ
    /// by round-off.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: Some(set.if_available()?), ..self })
    }

    /// Returns the instruction set on which the last bits of the steps depend: the narrowest set that gives
    /// bit-identical steps.
    ///
    /// It is the portable set, except for the kernels: Gauss's methods under `collective`, and the midpoint rule under
    /// `reduced` if its stages are solved to the round-off floor. These fuse multiplications with additions. With
    /// more than four stages, a Gauss method also adds up numbers in the order of the lanes.
    ///
    /// # Example
    /// ```
    /// use heavytop::lie_poisson::InstructionSet;
    /// use heavytop::methods::{Formulation, Method, SchemeName};
    /// let portable = InstructionSet::Portable;
    /// let gauss = Method::new(Formulation::Collective, SchemeName::Gauss(8), 0.0)?;
    /// assert_eq!(gauss.instructions(), InstructionSet::detected());
    /// assert_eq!(gauss.with_instructions(portable)?.instructions(), portable);
    /// let looser = Method::new(Formulation::Reduced, SchemeName::ImplicitMidpoint, 1e-12)?;
    /// assert_eq!(looser.instructions(), portable);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn instructions(&self) -> InstructionSet {
        let set = self.instructions.unwrap_or_else(InstructionSet::detected);
        match self.scheme {
            _ if !self.has_kernel() => InstructionSet::Portable,
            SchemeName::Gauss(5..) => set,
            // Registers of 512 bits compute the same as those of 256.
            _ => set.min(InstructionSet::Avx2),
        }
    }

    /// Returns whether there is a kernel that computes the steps of this method faster.
    fn has_kernel(&self) -> bool {
        match (self.formulation, self.scheme) {
            (Formulation::Collective, SchemeName::Gauss(1..=8)) => true,
            (Formulation::Reduced, SchemeName::ImplicitMidpoint) => self.tolerance == 0.0,
            _ => false,
        }
    }

    /// Returns the method that makes the same steps in the least time, from momenta with Γ ≠ 0.
    ///
    /// `collective` and `reduced` are the same map, and the names tell whether there is a lift. A Gauss method is fastest with
    /// the lift, and the midpoint rule without. The lift needs Γ ≠ 0. Steps of the two differ by round-off.
    ///
    /// # Example
    /// ```
    /// use heavytop::methods::{Formulation, Method, SchemeName};
    /// let method = |formulation, scheme| Method::new(formulation, scheme, 0.0);
    /// let (gauss, midpoint) = (SchemeName::Gauss(8), SchemeName::ImplicitMidpoint);
    /// let [collective, reduced] = [Formulation::Collective, Formulation::Reduced];
    /// assert_eq!(method(reduced, gauss)?.fastest(), method(collective, gauss)?);
    /// assert_eq!(method(collective, midpoint)?.fastest(), method(reduced, midpoint)?);
    /// assert_eq!(method(Formulation::Direct, gauss)?.fastest(), method(Formulation::Direct, gauss)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn fastest(&self) -> Self {
        let other = match self.formulation {
            Formulation::Collective => Formulation::Reduced,
            Formulation::Reduced => Formulation::Collective,
            _ => return *self,
        };
        let other = Self { formulation: other, ..*self };
        if !self.has_kernel() && other.has_kernel() { other } else { *self }
    }

    /// Returns the formulation of the method.
    #[must_use]
    pub fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// Returns the scheme of the method.
    #[must_use]
    pub fn scheme(&self) -> SchemeName {
        self.scheme
    }

    /// Returns the tolerance of the stage equations.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the integrator for this top.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the scheme cannot be made.
    ///
    /// # Example
    /// ```
    /// use heavytop::HeavyTop;
    /// use heavytop::collective_integrators::{AnyState, Start};
    /// use heavytop::methods::Method;
    /// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    /// let method = Method::new("reduced".parse()?, "gauss-8".parse()?, 0.0)?;
    /// let start = AnyState::from_slice(&[2.0, 3.0, 4.0, 0.6, 0.0, 0.8]);
    /// let end = method.integrator(&top)?.after(&start, 0.02, 100)?.momentum;
    /// let vertical = |mu: &AnyState| mu.as_slice()[3..].iter().map(|x| x * x).sum::<f64>();
    /// assert!((vertical(&end) - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn integrator(&self, top: &HeavyTop) -> Result<AnyIntegrator, MethodError> {
        match self.scheme {
            // These kernels compute the same maps, faster.
            SchemeName::Gauss(stages) if self.has_kernel() => {
                Ok(AnyIntegrator::new(self.gauss_kernel(stages, top)?, DIMENSION))
            }
            SchemeName::ImplicitMidpoint if self.has_kernel() => {
                Ok(AnyIntegrator::new(self.midpoint_kernel(top)?, DIMENSION))
            }
            _ => Ok(self.tangent_integrator(top)?.without_tangents()),
        }
    }

    /// Returns the integrator for this top that carries the [attitude](crate::WithAttitude) along, whose unit quaternion is in the
    /// last four coordinates of its states. It is `None` for the direct formulation, whose six equations do not determine
    /// the attitude.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the scheme cannot be made.
    pub fn integrator_with_attitude(
        &self,
        top: &HeavyTop,
    ) -> Result<Option<AnyIntegrator>, MethodError> {
        match self.scheme {
            SchemeName::Gauss(stages) if self.has_kernel() => {
                Ok(Some(with_attitude(self.gauss_kernel(stages, top)?)))
            }
            SchemeName::ImplicitMidpoint if self.has_kernel() => {
                Ok(Some(with_attitude(self.midpoint_kernel(top)?)))
            }
            _ => self.make::<Attitude>(top),
        }
    }

    /// Returns an integrator for this top that has tangent maps.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the scheme cannot be made.
    pub fn tangent_integrator(
        &self,
        top: &HeavyTop,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, MethodError> {
        self.make::<Tangents>(top)
    }

    fn gauss_kernel(&self, stages: u8, top: &HeavyTop) -> Result<CollectiveGauss, MethodError> {
        let gauss = CollectiveGauss::new(stages.into(), *top).map_err(|e| self.failed(e))?;
        let gauss = gauss.with_tolerance(self.tolerance);
        Ok(match self.instructions {
            Some(set) => gauss.with_instructions(set)?,
            None => gauss,
        })
    }

    fn midpoint_kernel(&self, top: &HeavyTop) -> Result<TopMidpoint, MethodError> {
        let midpoint = TopMidpoint::new(*top);
        Ok(match self.instructions {
            Some(set) => midpoint.with_instructions(set)?,
            None => midpoint,
        })
    }

    fn make<W: Wanted>(&self, top: &HeavyTop) -> Result<W::Made, MethodError> {
        match self.scheme {
            SchemeName::Partitioned(pair) => self.partitioned::<W>(pair, top),
            SchemeName::Composed(composed) if self.formulation == Formulation::Splitting => {
                self.splitting::<W>(composed, top)
            }
            scheme => match scheme.runge_kutta(self.tolerance)? {
                Some(scheme) => self.equivariant::<W>(scheme, top),
                None => Err(self.impossible()),
            },
        }
    }

    /// Makes the integrator of a Runge–Kutta method.
    fn equivariant<W: Wanted>(
        &self,
        scheme: Composition<RungeKutta>,
        top: &HeavyTop,
    ) -> Result<W::Made, MethodError> {
        Ok(match self.formulation {
            Formulation::Collective => {
                W::of_turning(Collective::new(scheme, SpinorRealisation, *top))
            }
            Formulation::Reduced => W::of_turning(LiftFree::new(scheme, DualQuaternions, *top)),
            Formulation::Direct => {
                let space = LiePoisson::minus(Se3::default());
                W::of(Direct::new(scheme, HamiltonianField { space, hamiltonian: *top }))
            }
            // `new` has refused every such pair.
            Formulation::Splitting => return Err(self.impossible()),
        })
    }

    fn partitioned<W: Wanted>(
        &self,
        pair: PartitionedScheme,
        top: &HeavyTop,
    ) -> Result<W::Made, MethodError> {
        let scheme = match pair {
            PartitionedScheme::SymplecticEuler => {
                PartitionedRungeKutta::<FirstHalf>::symplectic_euler_implicit_in_p()
            }
            PartitionedScheme::StormerVerlet => PartitionedRungeKutta::kick_drift_kick(),
            PartitionedScheme::Lobatto => {
                PartitionedRungeKutta::lobatto_iiia_iiib(3).map_err(|e| self.failed(e))?
            }
        };
        let solver = StageSolver { tolerance: self.tolerance, ..StageSolver::default() };
        let scheme = scheme.with_solver(solver);
        let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, *top);
        Ok(W::of_turning(integrator))
    }

    fn splitting<W: Wanted>(
        &self,
        composed: ComposedScheme,
        top: &HeavyTop,
    ) -> Result<W::Made, MethodError> {
        let substeps = composed.substeps().map_err(|e| self.failed(e))?;
        // This splitting is refused unless I₁ = I₂; the rotors suit every top.
        Ok(match SymmetricTopSplitting::new(*top) {
            Ok(flows) => W::of_turning(Composition::new(Splitting::strang(flows), substeps)),
            Err(_) => {
                let flows = RotorSplitting(*top);
                W::of_turning(Composition::new(Splitting::strang(flows), substeps))
            }
        })
    }

    fn impossible(&self) -> MethodError {
        MethodError::NoSuchPair { formulation: self.formulation, scheme: self.scheme }
    }

    fn failed(&self, reason: SchemeError) -> MethodError {
        MethodError::Scheme { scheme: self.scheme, reason }
    }
}

/// Returns the attitude in the last four coordinates of a state of an
/// [integrator with the attitude](Method::integrator_with_attitude).
#[must_use]
pub fn attitude_of(state: &[f64]) -> Quaternion {
    let at = |i: usize| state.get(state.len().wrapping_sub(4).wrapping_add(i));
    Vector::from_coordinates(|i| at(i).copied().unwrap_or(f64::NAN))
}
