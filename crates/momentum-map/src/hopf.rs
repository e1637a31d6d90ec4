//! The Hopf map C² → R³.

use lie_poisson::Real;
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;

/// ϖ₂(α) = (2 Re ᾱ₁α₂, 2 Im ᾱ₁α₂, |α₁|² − |α₂|²), with |ϖ₂(α)| = ‖α‖².
///
/// It maps the three-sphere of radius √R onto the two-sphere of radius R, with circles
/// e^{iθ}α as fibres, and is even: ϖ₂(−α) = ϖ₂(α). Source: Ohsawa 2019, eq. (3.1b).
///
/// ```
/// use momentum_map::hopf_map;
/// use nalgebra::{Vector2, Vector3};
/// use num_complex::Complex;
/// let north = Vector2::new(Complex::new(0.6, 0.8), Complex::new(0.0, 0.0));
/// assert!((hopf_map(&north) - Vector3::z()).norm() < 1e-15);
/// ```
#[inline]
pub fn hopf_map<T: Real>(alpha: &Vector2<Complex<T>>) -> Vector3<T> {
    let overlap = alpha.x.conj() * alpha.y;
    Vector3::new(
        overlap.re + overlap.re,
        overlap.im + overlap.im,
        alpha.x.norm_sqr() - alpha.y.norm_sqr(),
    )
}

/// (T_α ϖ₂)ᵀ γ = 2 (γ·σ) α, the gradient of α ↦ γ·ϖ₂(α).
///
/// Source: Ohsawa 2019, Appendix B (its second form of T_α ϖ₂; the first has a sign misprinted).
#[inline]
pub fn hopf_pull_back<T: Real>(
    gamma: &Vector3<T>,
    alpha: &Vector2<Complex<T>>,
) -> Vector2<Complex<T>> {
    pauli(&(gamma + gamma), alpha)
}

/// (v·σ) χ with the Pauli matrices σ = (σ₁, σ₂, σ₃).
#[inline]
pub fn pauli<T: Real>(v: &Vector3<T>, chi: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
    let (a, b) = (chi.x, chi.y);
    Vector2::new(
        Complex {
            re: v.z * a.re + v.x * b.re + v.y * b.im,
            im: v.z * a.im + v.x * b.im - v.y * b.re,
        },
        Complex {
            re: v.x * a.re - v.y * a.im - v.z * b.re,
            im: v.x * a.im + v.y * a.re - v.z * b.im,
        },
    )
}

/// A power of two next to the largest coordinate, by which to divide without rounding; 1 for 0.
fn power_of_two<T: Real>(gamma: &Vector3<T>) -> f64 {
    let exponent = lie_poisson::Vector::max_abs(gamma).log2().floor();
    if exponent.is_finite() { exponent.clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

/// |Γ|, over the whole range of numbers: the square of a tiny or huge Γ would leave it.
#[inline]
pub fn euclidean_norm<T: Real>(gamma: &Vector3<T>) -> T {
    let scale = T::from_f64(power_of_two(gamma));
    let unit = gamma * (T::one() / scale);
    unit.dot(&unit).sqrt() * scale
}

/// A point ψ of the Hopf fibre over Γ: ϖ₂(ψ) = Γ, ‖ψ‖² = |Γ|. Not finite for Γ = 0.
///
/// Two charts, ψ₁ > 0 on the upper half space and ψ₂ > 0 on the lower, so that no direction of Γ
/// is singular.
///
/// ```
/// use momentum_map::{hopf_map, hopf_section};
/// use nalgebra::Vector3;
/// for gamma in [Vector3::z(), -Vector3::z(), Vector3::new(0.6, 0.0, -0.8)] {
///     assert!((hopf_map(&hopf_section(&gamma)) - gamma).norm() < 1e-15);
/// }
/// ```
#[inline]
pub fn hopf_section<T: Real>(gamma: &Vector3<T>) -> Vector2<Complex<T>> {
    let size = euclidean_norm(gamma);
    let large = ((size + gamma.z.select_nonnegative(gamma.z, -gamma.z)) * 0.5).sqrt();
    let small = |im: T| Complex { re: gamma.x / (large + large), im: im / (large + large) };
    let large = Complex { re: large, im: T::zero() };
    let (north, south) = (small(gamma.y), small(-gamma.y));
    let choose = |upper: Complex<T>, lower: Complex<T>| Complex {
        re: gamma.z.select_nonnegative(upper.re, lower.re),
        im: gamma.z.select_nonnegative(upper.im, lower.im),
    };
    Vector2::new(choose(large, south), choose(north, large))
}
