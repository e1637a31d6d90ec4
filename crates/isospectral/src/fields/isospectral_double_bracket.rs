//! Dissipation that conserves the spectrum of a matrix: [`IsospectralDoubleBracket`].

use crate::fields::driven_isospectral_field::DrivenIsospectralField;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::StoragePool;
use lie_poisson::{DissipationError, Sign, State};

/// The double bracket of an isospectral equation with the generator B₀,
///
/// ```text
/// dW/dt = [B, W],    B = B₀ ∓ θ [B₀, W]
/// ```
///
/// with the upper sign for B₀ = −dh, the minus bracket, and the lower one for B₀ = dh, the plus bracket. The energy falls, dh/dt = −θ
/// |[dh, W]|² with |V|² = −tr V², and the spectrum of W stays. The friction θ has the unit of 1/W. The unit matrix has no part in it.
///
/// With [noise](crate::IsotropicIsospectralNoise) in all directions it is Langevin's dynamics.
///
/// Source: Brockett, *Dynamical systems that sort lists, diagonalize matrices, and solve linear programming problems*, Linear Algebra
/// Appl. 146 (1991).
///
/// # Example
/// A linear energy, h = ⟨D, W⟩, sorts the spectrum of W along that of D:
/// ```
/// use collective_integrators::{BrownianPaths, RungeKutta, Start};
/// use isospectral_flows::{IsospectralDoubleBracket, IsospectralField, LargeSkewHermitian, NoisyIsospectral};
/// use lie_poisson::{Pair, PathNumber, Sign, State, Time};
/// use num_complex::Complex;
/// struct Linear(LargeSkewHermitian); // h = ⟨D, W⟩, and B₀ = −D
/// impl IsospectralField for Linear {
///     fn size(&self) -> usize {
///         self.0.size()
///     }
///     fn generator_into(&self, _: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
///         b.assign(&self.0);
///         b.scale_in_place(-1.0);
///     }
/// }
/// let d = LargeSkewHermitian::from_upper(3, |j, k| Complex::new(0.0, if j == k { j as f64 } else { 0.0 }));
/// let damped = IsospectralDoubleBracket::new(Linear(d.clone()), 0.5, Sign::Minus)?;
/// let w = LargeSkewHermitian::from_upper(3, |j, k| Complex::new(0.3, if j == k { 1.0 + j as f64 } else { 0.0 }));
/// let motion = NoisyIsospectral::new(RungeKutta::implicit_midpoint(), damped, Vec::new(), BrownianPaths::new(1, 0.1)?);
/// let end = motion.after(&Pair(w.clone(), Pair(PathNumber(0.0), Time(0.0))), 0.1, 500)?.momentum.0;
/// // ⟨D, W⟩ is least for the reverse order
/// assert!(end.at(0, 1).norm() < 1e-6 && end.at(0, 0).im > end.at(1, 1).im && end.at(1, 1).im > end.at(2, 2).im);
/// assert!((end.norm() - w.norm()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IsospectralDoubleBracket<F> {
    field: F,
    /// The friction with the sign.
    factor: f64,
    storage: StoragePool<(Option<LargeSkewHermitian>, Products)>,
}

impl<F: DrivenIsospectralField> IsospectralDoubleBracket<F> {
    /// Creates the damped equation of an equation, with the friction θ and the sign of the bracket in which it is that of an energy.
    ///
    /// # Errors
    /// Returns [`DissipationError::Friction`] if θ is negative, infinite or NaN.
    pub fn new(field: F, friction: f64, sign: Sign) -> Result<Self, DissipationError> {
        DissipationError::require_friction(friction)?;
        let factor = match sign {
            Sign::Minus => -friction,
            Sign::Plus => friction,
        };
        Ok(Self { field, factor, storage: StoragePool::default() })
    }

    /// Returns the equation that is damped.
    pub const fn field(&self) -> &F {
        &self.field
    }

    /// Returns the friction θ.
    pub const fn friction(&self) -> f64 {
        self.factor.abs()
    }
}

impl<F: DrivenIsospectralField> DrivenIsospectralField for IsospectralDoubleBracket<F> {
    fn size(&self) -> usize {
        self.field.size()
    }

    fn generator_at_into(
        &self,
        w: &LargeSkewHermitian,
        time: f64,
        generator: &mut LargeSkewHermitian,
    ) {
        self.field.generator_at_into(w, time, generator);
        if w.size() != generator.size() {
            return generator.scale_in_place(f64::NAN);
        }
        self.storage.with(|(rate, products)| {
            let rate = rate.get_or_insert_with(|| w.zeros_like());
            products.commutator(generator, w, rate);
            generator.add_multiple(self.factor, rate);
        });
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.field.next_break(time, forward)
    }
}
