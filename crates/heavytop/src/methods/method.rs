//! The integrator for a formulation and a scheme.

use super::task::{Plain, TangentTask, Task};
use super::{ComposedScheme, Formulation, MethodError, PartitionedScheme, SchemeName};
use crate::{
    CollectiveGauss, HeavyTop, RotorSplitting, SpinorRealisation, SymmetricTopSplitting,
    TopMidpoint,
};
use collective_integrators::{
    Collective, Composition, Direct, Equivariant, FirstHalf, HamiltonianField, LiftFree,
    PartitionedRungeKutta, RungeKutta, SchemeError, Splitting, StageSolver,
};
use lie_poisson::{InstructionSet, LiePoisson, MissingInstructions, Se3};
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
    /// `reduced`, if their stages are solved to the round-off floor. These fuse multiplications with additions. With
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
    /// let looser = Method::new(Formulation::Collective, SchemeName::Gauss(8), 1e-12)?;
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
        self.tolerance == 0.0
            && matches!(
                (self.formulation, self.scheme),
                (Formulation::Collective, SchemeName::Gauss(1..=8))
                    | (Formulation::Reduced, SchemeName::ImplicitMidpoint)
            )
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

    /// Performs the task with the integrator for this top.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the scheme cannot be made.
    pub fn integrate<K: Task>(&self, top: &HeavyTop, task: K) -> Result<K::Output, MethodError> {
        match self.scheme {
            // These kernels compute the same maps, faster.
            SchemeName::Gauss(stages) if self.has_kernel() => {
                let gauss =
                    CollectiveGauss::new(stages.into(), *top).map_err(|e| self.failed(e))?;
                Ok(task.perform_turning(match self.instructions {
                    Some(set) => gauss.with_instructions(set)?,
                    None => gauss,
                }))
            }
            SchemeName::ImplicitMidpoint if self.has_kernel() => {
                let midpoint = TopMidpoint::new(*top);
                Ok(task.perform_turning(match self.instructions {
                    Some(set) => midpoint.with_instructions(set)?,
                    None => midpoint,
                }))
            }
            _ => self.differentiate(top, Plain(task)),
        }
    }

    /// Performs the task with an integrator for this top that has tangent maps.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the scheme cannot be made.
    pub fn differentiate<K: TangentTask>(
        &self,
        top: &HeavyTop,
        task: K,
    ) -> Result<K::Output, MethodError> {
        match self.scheme {
            SchemeName::ImplicitMidpoint => self.equivariant(self.midpoint(), top, task),
            SchemeName::Gauss(stages) => {
                let gauss = RungeKutta::gauss(stages.into()).map_err(|e| self.failed(e))?;
                self.equivariant(gauss.with_solver(self.solver()), top, task)
            }
            SchemeName::ExplicitMidpoint => {
                self.equivariant(RungeKutta::explicit_midpoint(), top, task)
            }
            SchemeName::Rk4 => self.equivariant(RungeKutta::rk4(), top, task),
            SchemeName::Partitioned(pair) => self.partitioned(pair, top, task),
            SchemeName::Composed(raise) if self.formulation == Formulation::Splitting => {
                self.splitting(raise, top, task)
            }
            SchemeName::Composed(raise) => {
                let substeps = raise.substeps().map_err(|e| self.failed(e))?;
                self.equivariant(Composition::new(self.midpoint(), substeps), top, task)
            }
        }
    }

    fn equivariant<S: Equivariant, K: TangentTask>(
        &self,
        scheme: S,
        top: &HeavyTop,
        task: K,
    ) -> Result<K::Output, MethodError> {
        Ok(match self.formulation {
            Formulation::Collective => {
                task.perform_turning(Collective::new(scheme, SpinorRealisation, *top))
            }
            Formulation::Reduced => {
                task.perform_turning(LiftFree::new(scheme, DualQuaternions, *top))
            }
            Formulation::Direct => {
                let space = LiePoisson::minus(Se3::default());
                task.perform(&Direct::new(scheme, HamiltonianField { space, hamiltonian: *top }))
            }
            // `new` has refused every such pair.
            Formulation::Splitting => return Err(self.impossible()),
        })
    }

    fn partitioned<K: TangentTask>(
        &self,
        pair: PartitionedScheme,
        top: &HeavyTop,
        task: K,
    ) -> Result<K::Output, MethodError> {
        let scheme = match pair {
            PartitionedScheme::SymplecticEuler => {
                PartitionedRungeKutta::<FirstHalf>::symplectic_euler_implicit_in_p()
            }
            PartitionedScheme::StormerVerlet => PartitionedRungeKutta::kick_drift_kick(),
            PartitionedScheme::Lobatto => {
                PartitionedRungeKutta::lobatto_iiia_iiib(3).map_err(|e| self.failed(e))?
            }
        };
        let scheme = scheme.with_solver(self.solver());
        let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, *top);
        Ok(task.perform_turning(integrator))
    }

    fn splitting<K: TangentTask>(
        &self,
        raise: ComposedScheme,
        top: &HeavyTop,
        task: K,
    ) -> Result<K::Output, MethodError> {
        let substeps = raise.substeps().map_err(|e| self.failed(e))?;
        // This splitting is refused unless I₁ = I₂; the rotors suit every top.
        Ok(match SymmetricTopSplitting::new(*top) {
            Ok(flows) => task.perform_turning(Composition::new(Splitting::strang(flows), substeps)),
            Err(_) => {
                let flows = RotorSplitting(*top);
                task.perform_turning(Composition::new(Splitting::strang(flows), substeps))
            }
        })
    }

    fn midpoint(&self) -> RungeKutta {
        RungeKutta::implicit_midpoint().with_solver(self.solver())
    }

    fn solver(&self) -> StageSolver {
        StageSolver { tolerance: self.tolerance, ..StageSolver::default() }
    }

    fn impossible(&self) -> MethodError {
        MethodError::NoSuchPair { formulation: self.formulation, scheme: self.scheme }
    }

    fn failed(&self, reason: SchemeError) -> MethodError {
        MethodError::Scheme { scheme: self.scheme, reason }
    }
}
