//! A chain of classical spins.

use crate::error::{SystemError, require_finite};
use crate::spaces::spin_space::{SpinSpace, Spins};
use lie_poisson::{Hamiltonian, Power, Real, Vector, hessian_by_dual_numbers};
use nalgebra::Vector3;

/// A periodic Heisenberg chain of N classical spins s_i in a magnetic field B.
///
/// ```text
/// h(s) = −J Σ_i s_i·sᵢ₊₁ − B·Σ_i s_i
/// ds_i/dt = ∂h/∂s_i × s_i
/// ```
///
/// The spin after the last one is s₁. The bracket is the plus bracket {s_a, s_b} = ε_abc s_c of each spin. The
/// conserved quantities are h, every |s_i| and, without a field, the total spin Σ s_i. In a field only the component of
/// Σ s_i along B is conserved.
///
/// Spins, J and B are numbers without units. For N = 2 the single bond counts twice, and for N = 1 the bond of the spin
/// with itself adds a constant.
///
/// Source: M. Lakshmanan, *The fascinating world of the Landau–Lifshitz–Gilbert equation*, Phil.
/// Trans. R. Soc. A 369 (2011), §4.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Hamiltonian, Power};
/// use lie_poisson_systems::HeisenbergChain;
/// use nalgebra::Vector3;
/// let chain = HeisenbergChain::new(1.0, Vector3::zeros())?;
/// // the ferromagnetic ground state
/// let up = Covector(Power([Vector3::<f64>::z(); 8]));
/// assert_eq!(chain.value(&up), -8.0);
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeisenbergChain<const N: usize> {
    exchange: f64,
    field: Vector3<f64>,
}

impl<const N: usize> HeisenbergChain<N> {
    /// Creates a chain from the exchange constant J (positive: ferromagnetic) and the field B.
    ///
    /// # Errors
    /// Returns [`SystemError`] if a number is not finite.
    pub fn new(exchange: f64, field: Vector3<f64>) -> Result<Self, SystemError> {
        require_finite("exchange", exchange)?;
        for &component in &field {
            require_finite("field", component)?;
        }
        Ok(Self { exchange, field })
    }
}

impl<const N: usize, T: Real> Hamiltonian<SpinSpace<N>, T> for HeisenbergChain<N> {
    fn value(&self, s: &Spins<N, T>) -> T {
        let (spins, field) = (&s.0.0, self.field.map(T::from_f64));
        let bond = |i: usize| spins[i].dot(&spins[(i + 1) % N]) * self.exchange;
        (0..N).fold(T::zero(), |sum, i| sum - bond(i) - field.dot(&spins[i]))
    }

    fn differential(&self, s: &Spins<N, T>) -> Power<Vector3<T>, N> {
        let (spins, field) = (&s.0.0, self.field.map(T::from_f64));
        Power::from_factors(|i| {
            let neighbours = spins[(i + 1) % N] + spins[(i + N - 1) % N];
            neighbours.scaled(T::from_f64(-self.exchange)) - field
        })
    }

    fn hessian(&self, s: &Spins<N, T>, v: &Spins<N, T>) -> Option<Power<Vector3<T>, N>> {
        Some(hessian_by_dual_numbers::<SpinSpace<N>, T, _>(self, s, v))
    }
}
