//! Dual numbers over any scalar, for exact first derivatives: [`DualNumber`].

use crate::numbers::real::Real;

/// A dual number x + ε x′ with ε² = 0, which carries a value and its exact first derivative.
///
/// Evaluating a function at `x + ε v` gives f(x) + ε Df(x)·v, exact to round-off. Dual numbers can be
/// nested, for second derivatives, and can be used over [`DefaultLanes`](crate::DefaultLanes), four SIMD
/// lanes.
///
/// Two dual numbers are equal if both their values and their derivatives are equal.
///
/// The two parts can be read, by [`value_without_derivative`](Self::value_without_derivative) and
/// [`derivative`](Self::derivative), but a formula should not take them apart: a function of the value alone is a
/// constant and loses the derivative. All functions of [`Real`] act on the whole number.
///
/// Source: W. K. Clifford, *Preliminary sketch of biquaternions*, Proc. London Math. Soc. 4 (1873).
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, Real};
/// let x = DualNumber::variable(4.0);
/// assert_eq!(Real::sqrt(x), DualNumber::new(2.0, 0.25));
/// ```
/// The fields are private, so that the value is not mistaken for the whole number:
/// ```compile_fail
/// use generic_scalars::{DualNumber, Real};
/// fn root(x: DualNumber) -> DualNumber {
///     DualNumber::constant(x.value.sqrt()) // x.sqrt() is meant
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualNumber<T = f64> {
    pub(super) value: T,
    pub(super) derivative: T,
}

impl<T> DualNumber<T> {
    /// Creates x + ε x′ from its value x and its derivative x′.
    #[inline]
    pub const fn new(value: T, derivative: T) -> Self {
        Self { value, derivative }
    }
}

impl<T: Real> DualNumber<T> {
    /// Creates the constant x + 0 ε, whose derivative is zero.
    #[cfg_attr(optimised, inline(always))]
    pub fn constant(value: T) -> Self {
        Self { value, derivative: T::zero() }
    }

    /// Creates x + 1 ε, the variable with respect to which a function is differentiated.
    #[cfg_attr(optimised, inline(always))]
    pub fn variable(value: T) -> Self {
        Self { value, derivative: T::one() }
    }

    /// Returns the value x of x + ε x′ without its derivative, for the end of a computation.
    ///
    /// Anything computed from the value alone loses the derivative. Where a formula asks for `f64` and has a dual number,
    /// the remedy is a formula over all scalars, and not this method:
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// let x = DualNumber::variable(4.0);
    /// assert_eq!(DualNumber::constant(x.value_without_derivative().sqrt()).derivative(), 0.0);
    /// assert_eq!(x.sqrt().derivative(), 0.25);
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn value_without_derivative(self) -> T {
        self.value
    }

    /// Returns the derivative x′ of x + ε x′, the coefficient of ε.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn derivative(self) -> T {
        self.derivative
    }

    /// Applies the chain rule: returns f(x) + ε f′(x) x′ for the given value f(x) and slope f′(x).
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn chain(self, value: T, slope: T) -> Self {
        Self { value, derivative: slope * self.derivative }
    }
}
