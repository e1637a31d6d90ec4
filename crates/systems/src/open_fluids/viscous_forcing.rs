//! Viscosity, drag and a constant force on a fluid on the sphere: [`ViscousForcing`].

use crate::error::{SystemError, require_finite, require_not_negative, require_within};
use crate::matrix_hydrodynamics::vorticity_coefficients::VorticityCoefficients;
use crate::matrix_hydrodynamics::zeitlin::Zeitlin;
use crate::open_fluids::harmonic_bands::HarmonicBands;
use collective_integrators::{StepError, TorqueFlow};
use isospectral_flows::LargeSkewHermitian;
use isospectral_flows::num_complex::Complex;
use lie_poisson::State;

/// The least and the largest power of the Laplace operator in a viscosity. The largest one keeps (l(l + 1))ᵖ a finite
/// number for every degree below 60 000.
const POWERS: [f64; 2] = [1.0, 32.0];

/// Viscosity, drag and a constant force on a [fluid on the sphere](Zeitlin), which act on each harmonic by itself:
///
/// ```text
/// dW/dt = [P, W]/ħ + R,    R_lm = F_lm − λ_l (ω_lm − f_lm),    λ_l = α + ν (l(l + 1))ᵖ
/// ```
///
/// The viscosity ν with p = 1 is that of the Laplace operator; with p > 1 it is a hyperviscosity −(−1)ᵖ ν Δᵖ, which
/// damps small eddies alone. The linear drag α damps all degrees alike. Both act on the relative vorticity ω − f, with
/// f = 2Ω x₃ on a sphere that rotates, and α, ν and F/ω are in inverse units of time. (In a Newtonian fluid a rotation
/// of the whole sphere is not damped, and λ_l = ν (l − 1)(l + 2) instead.)
///
/// As a [`TorqueFlow`] it is the exact flow of dW/dt = R, for any size of λ_l times the step:
///
/// ```text
/// ω_lm(t) = ω_lm + (e^(−λt) − 1)(ω_lm − f_lm) + t F_lm (1 − e^(−λt))/(λt)
/// ```
///
/// It takes O(N³) operations, less than a step of the fluid, and memory for N³/6 numbers, which clones share.
/// [`Torqued`](collective_integrators::Torqued) adds it to an isospectral method by Strang splitting, with order 2. The
/// Casimirs change through R alone, and where R = 0 they are conserved to round-off.
///
/// A viscous flow runs forward only: backward in time it amplifies degree l by exp(ν (l(l + 1))ᵖ t). Compositions of
/// order above 2 have steps backward (Sheng 1989; Suzuki 1991), so that the step of a
/// [`Composition`](collective_integrators::Composition) with viscosity is an error. Drag and forces alone run in both
/// directions, and a composition has its order.
///
/// Sources: Cifani, Viviani, Luesink, Modin & Geurts, *Casimir preserving spectrum of two-dimensional turbulence*,
/// Phys. Rev. Fluids 7 (2022); Strang, SIAM J. Numer. Anal. 5 (1968).
///
/// # Example
/// A harmonic is a steady flow of an ideal fluid, so that a viscous one damps it as exp(−ν l(l + 1) t):
/// ```
/// use lie_poisson_systems::num_complex::Complex;
/// use lie_poisson_systems::prelude::*;
/// let fluid = Zeitlin::new(16)?;
/// let mut omega = VorticityCoefficients::zeros(16);
/// omega.set(4, 3, Complex::new(0.3, -0.4));
/// let start = fluid.vorticity(&omega);
/// let viscous = ViscousForcing::new(fluid.clone()).with_viscosity(0.01, 1)?;
/// let method = Torqued::new(ExponentialMidpoint::new(fluid.clone()), viscous);
/// let end = fluid.coefficients(&method.after(&start, 0.1, 20)?.state);
/// let exact = omega.at(4, 3) * (-0.01 * 20.0 * 2.0_f64).exp();
/// assert!((end.at(4, 3) - exact).norm() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ViscousForcing {
    fluid: Zeitlin,
    bands: HarmonicBands,
    viscosity: f64,
    power: u32,
    drag: f64,
    force: VorticityCoefficients,
}

impl ViscousForcing {
    /// Creates the sum of no viscosity, no drag and no force on a fluid.
    #[must_use]
    pub fn new(fluid: Zeitlin) -> Self {
        let force = VorticityCoefficients::zeros(fluid.laplacian().size());
        let bands = HarmonicBands::new(fluid.laplacian());
        Self { fluid, bands, viscosity: 0.0, power: 1, drag: 0.0, force }
    }

    /// Returns this with the viscosity ν and the power p.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] or [`SystemError::Negative`] for a viscosity that is not finite or is
    /// negative, and [`SystemError::OutOfRange`] for a power that is not 1 … 32 or if ν (N(N − 1))ᵖ is too large for a
    /// number.
    pub fn with_viscosity(self, viscosity: f64, power: u32) -> Result<Self, SystemError> {
        require_not_negative("the viscosity", viscosity)?;
        require_within("the power of the Laplace operator", f64::from(power), POWERS)?;
        let highest = self.fluid.laplacian().size() - 1;
        let most = f64::MAX / eigenvalue_power(highest, power);
        require_within("the viscosity of this power", viscosity, [0.0, most])?;
        Ok(Self { viscosity, power, ..self })
    }

    /// Returns this with the linear drag α.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] or [`SystemError::Negative`] for a drag that is not finite or is negative.
    pub fn with_drag(self, drag: f64) -> Result<Self, SystemError> {
        require_not_negative("the drag", drag)?;
        Ok(Self { drag, ..self })
    }

    /// Returns this with the force F, as the rate of the vorticity.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] for a coefficient that is not finite, and [`SystemError::OutOfRange`] for one
    /// that is not zero and has a degree that is not 1 … N − 1: the mean of a vorticity is zero.
    pub fn with_force(self, force: &VorticityCoefficients) -> Result<Self, SystemError> {
        let size = self.fluid.laplacian().size();
        for (l, m) in (0..force.size()).flat_map(|l| (0..=l).map(move |m| (l, m))) {
            let value = force.at(l, m);
            require_finite("a coefficient of the force", value.re)?;
            require_finite("a coefficient of the force", value.im)?;
            if value != Complex::ZERO {
                require_within("the degree of a force", l as f64, [1.0, size as f64 - 1.0])?;
            }
        }
        Ok(Self { force: VorticityCoefficients::from_fn(size, |l, m| force.at(l, m)), ..self })
    }

    /// Returns the fluid.
    #[must_use]
    pub const fn fluid(&self) -> &Zeitlin {
        &self.fluid
    }

    /// Returns the rate λ_l = α + ν (l(l + 1))ᵖ at which degree l decays.
    #[must_use]
    pub fn decay_rate(&self, l: usize) -> f64 {
        match self.viscosity == 0.0 {
            true => self.drag,
            false => self.drag + self.viscosity * eigenvalue_power(l, self.power),
        }
    }

    /// Returns the torque R: the rate of W by viscosity, drag and force. It is NaN if W does not have the size of the
    /// fluid.
    #[must_use]
    pub fn torque(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        self.linear_change(w, |decay| (-decay, 1.0))
    }

    /// Returns the matrix of a(λ_l) (ω_lm − f_lm) + b(λ_l) F_lm.
    fn linear_change(
        &self,
        w: &LargeSkewHermitian,
        factors: impl Fn(f64) -> (f64, f64),
    ) -> LargeSkewHermitian {
        let rates = (0..self.fluid.laplacian().size()).map(|l| factors(self.decay_rate(l)));
        let rates: Vec<_> = rates.collect();
        self.bands.change(w, |l, m, omega| {
            let (a, b) = rates[l];
            (omega - self.planetary(l, m)) * a + self.force.at(l, m) * b
        })
    }

    /// Returns f_lm, the coefficient of 2Ω x₃ = 2Ω √(4π/3) Y₁₀.
    fn planetary(&self, l: usize, m: usize) -> f64 {
        match (l, m) {
            (1, 0) => 2.0 * self.fluid.rotation() * (4.0 * std::f64::consts::PI / 3.0).sqrt(),
            _ => 0.0,
        }
    }
}

/// Returns (l(l + 1))ᵖ.
fn eigenvalue_power(l: usize, power: u32) -> f64 {
    ((l * (l + 1)) as f64).powf(f64::from(power))
}

impl TorqueFlow<LargeSkewHermitian> for ViscousForcing {
    /// Replaces W by its value after a time.
    ///
    /// # Errors
    /// Returns [`StepError::NoLift`] for a negative time if there is viscosity.
    fn flow(&self, w: &mut LargeSkewHermitian, step: f64) -> Result<(), StepError> {
        if step < 0.0 && self.viscosity > 0.0 {
            let reason = "viscosity runs forward in time only, and this step is negative; compositions of order above \
                          2 have such steps";
            return Err(StepError::NoLift { reason });
        }
        let change = self.linear_change(w, |decay| {
            let lost = (-decay * step).exp_m1();
            (lost, if lost == 0.0 { step } else { -lost / decay })
        });
        w.add_in_place(&change);
        Ok(())
    }
}
