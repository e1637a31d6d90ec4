//! Points of T∗C² with the rounding error of their last sum.

use super::row::{Row, Stages, WIDTH};
use crate::paper::spinor_realisation::SpinorPoint;
use core::hint::black_box;
use lie_poisson::{Covector, Pair, nearest_power_of_two};
use momentum_map::Cotangent;
use nalgebra::Vector2;
use num_complex::Complex;

/// The coordinates z = (q₁, …, q₄, p₁, …, p₄), and the part that rounding removed from the last sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CompensatedPoint {
    pub(super) z: Row,
    pub(super) carry: Row,
}

impl CompensatedPoint {
    pub(super) const ZERO: Self = Self { z: Row::ZERO, carry: Row::ZERO };

    #[inline]
    pub(super) fn from_state(state: &Pair<SpinorPoint, SpinorPoint>) -> Self {
        Self { z: coordinates(&state.0), carry: coordinates(&state.1) }
    }

    #[inline]
    pub(super) fn state(&self) -> Pair<SpinorPoint, SpinorPoint> {
        Pair(spinor_point(&self.z), spinor_point(&self.carry))
    }

    /// Returns whether both are the same; NaN is not.
    ///
    /// Without branches, this is one comparison of registers.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn is(&self, other: &Self) -> bool {
        let mut same = true;
        for c in 0..WIDTH {
            same &= self.z.0[c] == other.z.0[c];
            same &= self.carry.0[c] == other.carry.0[c];
        }
        same
    }

    #[cfg_attr(optimised, inline(always))]
    pub(super) fn is_finite(&self) -> bool {
        let mut finite = true;
        for c in 0..WIDTH {
            finite &= self.z.0[c].is_finite() & self.carry.0[c].is_finite();
        }
        finite
    }

    /// Returns z + Σ_j ℓ_j, by compensated summation.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn plus_sum(&self, stages: &Stages) -> Self {
        // The numbers are read from memory, as in the loops of the solver.
        let stages = black_box(stages);
        let mut end = *self;
        for (c, Row(x)) in stages.iter().enumerate() {
            let sum = ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
            let change = sum + self.carry.0[c];
            end.z.0[c] = self.z.0[c] + change;
            end.carry.0[c] = change - (end.z.0[c] - self.z.0[c]);
        }
        end
    }

    /// Returns the overlap Re(ψ∗χ).
    #[cfg_attr(optimised, inline(always))]
    fn overlap(&self) -> f64 {
        let [q1, q2, q3, q4, p1, p2, p3, p4] = self.z.0;
        (q1 * p1 + q2 * p2) + (q3 * p3 + q4 * p4)
    }

    /// Returns the squared norm ‖ψ‖².
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn square(&self) -> f64 {
        let [.., p1, p2, p3, p4] = self.z.0;
        (p1 * p1 + p2 * p2) + (p3 * p3 + p4 * p4)
    }

    /// Returns the squared norm ‖χ‖².
    #[cfg_attr(optimised, inline(always))]
    fn chi_square(&self) -> f64 {
        let [q1, q2, q3, q4, ..] = self.z.0;
        (q1 * q1 + q2 * q2) + (q3 * q3 + q4 * q4)
    }

    /// Returns ‖χ‖‖ψ‖, the size of the products of which Π is the sum.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn products(&self) -> f64 {
        self.chi_square().sqrt() * self.square().sqrt()
    }

    /// Returns whether χ is far along the fibre: Re(ψ∗χ)² > ‖χ⊥‖²‖ψ‖² + r‖ψ‖², with χ⊥ = χ − ψ Re(ψ∗χ)/‖ψ‖².
    ///
    /// Here √r is the Π that the torque produces in the time in which it turns the top. Without it, a top
    /// that sometimes comes to rest would slide at every step.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn has_drifted(&self, reach: f64) -> bool {
        let overlap = self.overlap();
        2.0 * overlap * overlap > (self.chi_square() + reach) * self.square()
    }

    /// Slides back along the fibre to χ + bψ, and returns b.
    ///
    /// The number b is a power of two, usually ±1, so that bψ is not rounded.
    #[cold]
    pub(super) fn slide(&mut self) -> f64 {
        let along = nearest_power_of_two(-self.overlap() / self.square());
        if !along.is_finite() {
            return 0.0;
        }
        let (z, carry) = (&mut self.z.0, &mut self.carry.0);
        for c in 0..4 {
            let change = along * z[c + 4];
            let moved = z[c] + change;
            // Either of the two numbers may be the larger one.
            let part = moved - z[c];
            let rounding = (z[c] - (moved - part)) + (change - part);
            carry[c] += along * carry[c + 4] + rounding;
            z[c] = moved;
        }
        along
    }
}

#[inline]
fn coordinates(z: &SpinorPoint) -> Row {
    let (chi, psi) = (&z.q, &z.p.0);
    Row([chi.x.re, chi.x.im, chi.y.re, chi.y.im, psi.x.re, psi.x.im, psi.y.re, psi.y.im])
}

#[inline]
fn spinor_point(z: &Row) -> SpinorPoint {
    let spinor = |re1, im1, re2, im2| Vector2::new(Complex::new(re1, im1), Complex::new(re2, im2));
    let [q1, q2, q3, q4, p1, p2, p3, p4] = z.0;
    Cotangent::new(spinor(q1, q2, q3, q4), Covector(spinor(p1, p2, p3, p4)))
}

#[cfg(test)]
mod tests {
    use super::{CompensatedPoint, Row};

    /// Returns x as a multiple of 2⁻¹⁰⁰. All numbers here are multiples of it.
    fn units(x: f64) -> i128 {
        (x * 2.0_f64.powi(100)) as i128
    }

    /// The sums χ + bψ need more than 53 digits, of the coordinates and of what was carried over.
    #[test]
    fn a_slide_keeps_what_rounding_removes() {
        let ulp = f64::EPSILON;
        let z = [3.5 + 2.0 * ulp, -7.0, -2.5, -3.75 + ulp, 1.0 + 2.0 * ulp, 2.0, 1.5 + ulp, 1.0];
        let carry = [1.0, -3.0, 5.0, 2.0, -1.0, 2.0, 3.0, -7.0].map(|x| x * 2.0_f64.powi(-90));
        let start = CompensatedPoint { z: Row(z), carry: Row(carry) };
        let mut end = start;
        let along = end.slide();
        assert_eq!(along, 2.0);
        let exact =
            |point: &CompensatedPoint, c: usize| units(point.z.0[c]) + units(point.carry.0[c]);
        for c in 0..4 {
            assert_eq!(exact(&end, c), exact(&start, c) + 2 * exact(&start, c + 4));
            assert_eq!((end.z.0[c + 4], end.carry.0[c + 4]), (z[c + 4], carry[c + 4]));
        }
        // Control: the sums are not numbers of 53 digits.
        assert!((0..4).any(|c| units(end.z.0[c]) != units(z[c]) + 2 * units(z[c + 4])));
    }

    #[test]
    fn products_are_those_of_the_norms() {
        let point =
            CompensatedPoint { z: Row([1.0, 2.0, 2.0, 4.0, 2.0, 0.0, 0.0, 0.0]), carry: Row::ZERO };
        assert_eq!((point.chi_square(), point.square(), point.products()), (25.0, 4.0, 10.0));
    }

    #[test]
    fn one_coordinate_that_is_no_number_is_noticed() {
        let finite = CompensatedPoint { z: Row([1.0; 8]), carry: Row([-1e-20; 8]) };
        assert!(finite.is_finite() && finite.is(&finite));
        for c in 0..8 {
            let (mut point, mut carried) = (finite, finite);
            (point.z.0[c], carried.carry.0[c]) = (f64::NAN, f64::INFINITY);
            assert!(!point.is_finite() && !carried.is_finite());
            assert!(!point.is(&finite) && !carried.is(&finite));
        }
    }
}
