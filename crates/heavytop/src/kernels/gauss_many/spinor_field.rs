//! The collective equations on T∗C², and the functions that are constant on fibres, in components.

use crate::kernels::infinitesimal_rotation::infinitesimal_rotation;
use crate::tops::top::HeavyTop;
use lie_poisson::Lanes;

/// The coordinates q₁, …, q₄, p₁, …, p₄ with χ = (q₁ + iq₂, q₃ + iq₄) and ψ = (p₁ + ip₂, p₃ + ip₄).
pub(crate) type Spinors<T> = [T; 8];

/// The parameters of tops that the field depends on, one top in each SIMD lane.
#[derive(Clone, Copy)]
pub(crate) struct FieldParameters<T> {
    /// The diagonal of ¼ I⁻¹.
    quarter_inverse: [T; 3],
    /// The doubled force 2 m g l c of the weight.
    force: [T; 3],
}

impl<T: Lanes> FieldParameters<T> {
    /// Gathers the parameters of the tops: lane i is f(i).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn from_lanes<'a>(f: impl Fn(usize) -> &'a HeavyTop) -> Self {
        let quarter = |k: usize| T::from_lanes(|i| 0.25 * f(i).inverse_inertia()[k]);
        let force =
            |k: usize| T::from_lanes(|i| 2.0 * f(i).weight_moment() * f(i).center_of_mass()[k]);
        Self {
            quarter_inverse: [quarter(0), quarter(1), quarter(2)],
            force: [force(0), force(1), force(2)],
        }
    }

    /// Returns half the angular velocity ½Ω = ½I⁻¹Π(z).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn half_velocity(&self, z: &Spinors<T>) -> [T; 3] {
        let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
        let four = |a: T, b: T, c: T, d: T, e: T, f: T, g: T, h: T| {
            let first = a.multiply_subtract(b, c * d);
            let second = e.multiply_subtract(f, g * h);
            first + second
        };
        let [x, y, z] = self.quarter_inverse;
        [
            x * four(q1, p4, q4, p1, q3, p2, q2, p3),
            y * four(q3, p1, q1, p3, q4, p2, q2, p4),
            z * four(q1, p2, q2, p1, q4, p3, q3, p4),
        ]
    }

    /// Returns the field dχ/dt = (i/2)(Ω·σ)χ + 2(γ·σ)ψ, dψ/dt = (i/2)(Ω·σ)ψ for v = ½Ω.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn field(&self, v: &[T; 3], z: &Spinors<T>) -> Spinors<T> {
        let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
        let f = &self.force;
        let chi = infinitesimal_rotation(v, [q1, q2, q3, q4], [T::zero(); 4]);
        let psi = infinitesimal_rotation(v, [p1, p2, p3, p4], [T::zero(); 4]);
        let pushed = |start: T, a: (T, T), b: (T, T), c: (T, T)| {
            c.0.multiply_add(c.1, b.0.multiply_add(b.1, a.0.multiply_add(a.1, start)))
        };
        [
            pushed(chi[0], (f[2], p1), (f[0], p3), (f[1], p4)),
            pushed(chi[1], (f[2], p2), (f[0], p4), (-f[1], p3)),
            pushed(chi[2], (f[0], p1), (-f[1], p2), (-f[2], p3)),
            pushed(chi[3], (f[0], p2), (f[1], p1), (-f[2], p4)),
            psi[0],
            psi[1],
            psi[2],
            psi[3],
        ]
    }
}

/// Returns the squared norm ‖ψ‖².
#[cfg_attr(optimised, inline(always))]
pub(crate) fn square<T: Lanes>(z: &Spinors<T>) -> T {
    let [.., a, b, c, d] = *z;
    a.multiply_add(a, b * b) + c.multiply_add(c, d * d)
}

/// Returns the real overlap Re ψ∗χ.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn real_overlap<T: Lanes>(z: &Spinors<T>) -> T {
    let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
    p1.multiply_add(q1, p2 * q2) + p3.multiply_add(q3, p4 * q4)
}

/// Returns the imaginary overlap Im ψ∗χ.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn imaginary_overlap<T: Lanes>(z: &Spinors<T>) -> T {
    let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
    p1.multiply_subtract(q2, p2 * q1) + p3.multiply_subtract(q4, p4 * q3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;
    use num_complex::Complex;

    #[test]
    fn overlaps_are_those_of_complex_spinors() {
        let z: Spinors<f64> = [0.3, -1.2, 0.7, 2.1, -0.4, 1.5, 0.9, -0.6];
        let spinor = |x: &[f64]| Vector2::new(Complex::new(x[0], x[1]), Complex::new(x[2], x[3]));
        let (chi, psi) = (spinor(&z[..4]), spinor(&z[4..]));
        let overlap = psi.dotc(&chi);
        assert!((real_overlap(&z) - overlap.re).abs() < 1e-15);
        assert!((imaginary_overlap(&z) - overlap.im).abs() < 1e-15);
        assert!((square(&z) - psi.norm_squared()).abs() < 1e-15);
    }
}
