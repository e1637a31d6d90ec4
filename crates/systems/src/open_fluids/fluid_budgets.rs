//! The rates at which viscosity and forces change what an ideal fluid conserves.

use crate::open_fluids::viscous_forcing::ViscousForcing;
use isospectral_flows::num_complex::Complex;
use isospectral_flows::{LargeMatrix, LargeSkewHermitian, Products};

/// The budgets of a fluid: with the torque R = F − λ(ω − f) of this forcing, the ideal fluid drops out of each.
impl ViscousForcing {
    /// Returns dh/dt = −∫ψR, the rate of the [energy](crate::Zeitlin::energy) by viscosity, drag and force.
    ///
    /// # Example
    /// A drag alone takes the energy at the rate −2αh:
    /// ```
    /// use lie_poisson_systems::num_complex::Complex;
    /// use lie_poisson_systems::prelude::*;
    /// let fluid = Zeitlin::new(8)?;
    /// let w = fluid.vorticity(&VorticityCoefficients::from_fn(8, |l, m| match l {
    ///     0 => Complex::ZERO,
    ///     _ => Complex::new((l + m) as f64, 1.0) / (l * l) as f64,
    /// }));
    /// let drag = ViscousForcing::new(fluid.clone()).with_drag(0.1)?;
    /// assert!((drag.energy_rate(&w) + 0.2 * fluid.energy(&w)).abs() < 1e-13 * fluid.energy(&w));
    /// # Ok::<(), SystemError>(())
    /// ```
    #[must_use]
    pub fn energy_rate(&self, w: &LargeSkewHermitian) -> f64 {
        let mut p = LargeSkewHermitian::zeros(w.size());
        self.fluid().stream_into(w, &mut p);
        -4.0 * std::f64::consts::PI / w.size() as f64 * p.scalar_product(&self.torque(w))
    }

    /// Returns 2∫ωR, the rate of the [enstrophy](crate::Zeitlin::enstrophy).
    #[must_use]
    pub fn enstrophy_rate(&self, w: &LargeSkewHermitian) -> f64 {
        8.0 * std::f64::consts::PI / w.size() as f64 * w.scalar_product(&self.torque(w))
    }

    /// Returns the rates k (4π/N) tr((−iW)ᵏ⁻¹ (−iR)) of the [Casimirs](crate::Zeitlin::casimirs), for k = 1 … `most`.
    #[must_use]
    pub fn casimir_rates(&self, w: &LargeSkewHermitian, most: usize) -> Vec<f64> {
        let (n, torque) = (w.size(), self.torque(w));
        let hermitian_of = |w: &LargeSkewHermitian| {
            LargeMatrix::from_fn(n, |j, k| -Complex::<f64>::I * w.at(j, k))
        };
        let (hermitian, torque) = (hermitian_of(w), hermitian_of(&torque));
        let mut power = LargeMatrix::from_fn(n, |j, k| match j == k {
            true => Complex::ONE,
            false => Complex::ZERO,
        });
        let (mut next, mut products) = (power.clone(), Products::default());
        (1..=most)
            .map(|k| {
                if k > 1 {
                    products.multiply_hermitian(&power, &hermitian, &mut next);
                    core::mem::swap(&mut power, &mut next);
                }
                let pairs = power.real().iter().zip(torque.real());
                let imaginary = power.imaginary().iter().zip(torque.imaginary());
                // Both matrices are Hermitian: the trace of their product is the scalar product of their entries.
                let trace = pairs.chain(imaginary).map(|(x, y)| x * y).sum::<f64>();
                k as f64 * 4.0 * std::f64::consts::PI / n as f64 * trace
            })
            .collect()
    }
}
