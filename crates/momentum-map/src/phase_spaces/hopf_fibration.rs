//! The Hopf map C² → R³ with its derivative and a section.

use lie_poisson::{Real, squaring_scale};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;

/// Returns the Hopf map ϖ₂(α) = (2 Re α₁∗α₂, 2 Im α₁∗α₂, |α₁|² − |α₂|²), with |ϖ₂(α)| = ‖α‖².
///
/// It maps the three-sphere of radius √R onto the two-sphere of radius R. The fibres are the circles
/// exp(iθ) α, and the map is even: ϖ₂(−α) = ϖ₂(α).
///
/// Source: Ohsawa 2019, eq. (3.1b).
///
/// ```
/// use momentum_map::hopf_map;
/// use nalgebra::{Vector2, Vector3};
/// use num_complex::Complex;
/// let north = Vector2::new(Complex::new(0.6, 0.8), Complex::new(0.0, 0.0));
/// assert!((hopf_map(&north) - Vector3::z()).norm() < 1e-15);
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn hopf_map<T: Real>(alpha: &Vector2<Complex<T>>) -> Vector3<T> {
    let (a, b) = (alpha.x, alpha.y);
    let overlap = Complex { re: a.re * b.re + a.im * b.im, im: a.re * b.im - a.im * b.re };
    Vector3::new(
        overlap.re + overlap.re,
        overlap.im + overlap.im,
        (a.re * a.re + a.im * a.im) - (b.re * b.re + b.im * b.im),
    )
}

/// Returns (T_α ϖ₂)ᵀ γ = 2 (γ·σ) α, the gradient of α ↦ γ·ϖ₂(α).
///
/// Source: Ohsawa 2019, Appendix B (the second form of T_α ϖ₂ there; the first one has a misprinted sign).
#[cfg_attr(optimised, inline(always))]
pub fn hopf_pull_back<T: Real>(
    gamma: &Vector3<T>,
    alpha: &Vector2<Complex<T>>,
) -> Vector2<Complex<T>> {
    pauli(&Vector3::new(gamma.x + gamma.x, gamma.y + gamma.y, gamma.z + gamma.z), alpha)
}

/// Returns (v·σ) χ with the Pauli matrices σ = (σ₁, σ₂, σ₃).
#[cfg_attr(optimised, inline(always))]
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

/// Returns a point ψ of the Hopf fibre over Γ: ϖ₂(ψ) = Γ and ‖ψ‖² = |Γ|.
///
/// The result is not finite for Γ = 0. There are two charts, with ψ₁ > 0 on the upper half-space and ψ₂ > 0 on the
/// lower one, so that no direction of Γ is singular. The result is accurate to the round-off of |Γ| for every finite
/// Γ ≠ 0, however small or large.
///
/// ```
/// use momentum_map::{hopf_map, hopf_section};
/// use nalgebra::Vector3;
/// for gamma in [Vector3::z(), -Vector3::z(), Vector3::new(0.6, 0.0, -0.8)] {
///     assert!((hopf_map(&hopf_section(&gamma)) - gamma).norm() < 1e-15);
/// }
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn hopf_section<T: Real>(gamma: &Vector3<T>) -> Vector2<Complex<T>> {
    let scale = squaring_scale(gamma);
    let unit = gamma * scale;
    let size = unit.dot(&unit).sqrt();
    let large = ((size + unit.z.select_nonnegative(unit.z, -unit.z)) * 0.5).sqrt();
    let back = T::one() / scale.sqrt();
    let small =
        |im: T| Complex { re: unit.x / (large + large), im: im / (large + large) }.scale(back);
    let (north, south) = (small(unit.y), small(-unit.y));
    let large = Complex { re: large * back, im: T::zero() };
    let choose = |upper: Complex<T>, lower: Complex<T>| Complex {
        re: unit.z.select_nonnegative(upper.re, lower.re),
        im: unit.z.select_nonnegative(upper.im, lower.im),
    };
    Vector2::new(choose(large, south), choose(north, large))
}
