//! A fluid on the sphere, with its states as matrices and as coefficients: [`SphereFluid`].

use lie_poisson::State;
use lie_poisson_systems::isospectral_flows::{IsospectralField, LargeSkewHermitian};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};

#[derive(Clone, Debug)]
pub(in crate::arrays) struct SphereFluid(pub(in crate::arrays) Zeitlin);

impl SphereFluid {
    pub(in crate::arrays) fn size(&self) -> usize {
        self.0.size()
    }

    /// Returns the matrix of a state.
    pub(in crate::arrays) fn matrix(&self, state: &[f64]) -> LargeSkewHermitian {
        let mut w = LargeSkewHermitian::zeros(self.size());
        w.set_coordinates(|i| state.get(i).copied().unwrap_or(f64::NAN));
        w
    }

    /// Writes coefficients as an array of N rows: Re ω_lm at [l, m], and Im ω_lm at [m − 1, l].
    pub(super) fn write(&self, omega: &VorticityCoefficients, to: &mut [f64]) {
        let n = self.size();
        for (l, m) in (0..n).flat_map(|l| (0..=l).map(move |m| (l, m))) {
            let value = omega.at(l, m);
            to[n * l + m] = value.re;
            if m > 0 {
                to[n * (m - 1) + l] = value.im;
            }
        }
    }

    pub(super) fn read(&self, from: &[f64]) -> VorticityCoefficients {
        let n = self.size();
        let imaginary = |l, m| if m > 0 { from[n * (m - 1) + l] } else { 0.0 };
        VorticityCoefficients::from_fn(n, |l, m| Complex::new(from[n * l + m], imaginary(l, m)))
    }
}
