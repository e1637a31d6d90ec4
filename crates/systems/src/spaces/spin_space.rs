//! The phase space of N vortices or N spins.

use lie_poisson::{LiePoisson, Momentum, PowerAlgebra, So3};

/// The Lie–Poisson space (so(3)∗)ᴺ of N spins, or of N vortices.
///
/// The sign of the bracket belongs to the value, not to the type: use [`LiePoisson::minus`] for
/// [`PointVortices`](crate::PointVortices), and [`LiePoisson::plus`] for [`HeisenbergChain`](crate::HeisenbergChain).
pub type SpinSpace<const N: usize> = LiePoisson<PowerAlgebra<So3, N>>;

/// A point of (so(3)∗)ᴺ: N vectors of R³.
pub type Spins<const N: usize, T = f64> = Momentum<PowerAlgebra<So3, N>, T>;
