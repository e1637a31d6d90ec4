//! The nutation of any top, its amplitude and its rotation number: [`Nutation`].

use crate::closed_forms::power_of_two::power_of_two;
use crate::tops::top::HeavyTop;
use core::f64::consts::{PI, TAU};
use lie_poisson::{Covector, Pair, Se3Dual, larger};
use nalgebra::Vector3;

/// The nutation of a motion, measured from its samples.
///
/// With the line c from the support to the centre of mass,
///
/// ```text
/// u = Γ·c/|Γ| = cos θ,   θ the angle between c and the upward vertical
/// φ = the angle of Γ about c in the body frame, followed continuously
/// ```
///
/// * The *amplitude* is θ_max − θ_min over the samples, in [0, π]. Between two samples at which du/dt has different
///   signs, u is taken as a cubic, so that its extrema have errors of the fourth order in the step. θ is computed from
///   1 − u and 1 + u, which keep their digits near the vertical: θ_min and θ_max have errors of a few units of
///   round-off of their own size, however small they are.
/// * The *rotation number* is the mean advance of φ, in turns, from one maximum of u to the next: (φ_n −
///   φ_0)/(2πn) over the maxima 0, …, n. Near a torus of dimension 2 it tends, as 1/n, to a ratio of the
///   frequencies of the motion of (Π, Γ).
///
/// The body must turn by less than half a turn from sample to sample. A regular precession has no maxima and
/// therefore no rotation number.
///
/// # Example
/// The amplitude of Lagrange's top is compared with its closed form:
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, Start};
/// use heavytop::{HeavyTop, LagrangeNutation, Nutation};
/// use lie_poisson::Se3Dual;
/// use momentum_map::DualQuaternions;
/// use nalgebra::Vector3;
/// let top = HeavyTop::lagrange(2.0, 1.0, 1.0)?;
/// let start = Se3Dual::new(Vector3::new(0.5, 0.2, 3.0), Vector3::new(0.6, 0.0, 0.8));
/// let gauss = LiftFree::new(RungeKutta::gauss(4)?, DualQuaternions, top);
/// let mut nutation = Nutation::new(&top);
/// for sample in gauss.trajectory(&start, 0.05)?.take(2001) {
///     let sample = sample?;
///     nutation.observe(sample.time, &sample.momentum);
/// }
/// let (lowest, highest) = LagrangeNutation::new(&top, &start)?.turning_points();
/// let exact = lowest.acos() - highest.acos();
/// assert!(nutation.amplitude().is_some_and(|a| (a - exact).abs() < 1e-7));
/// assert!(nutation.rotation_number().is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nutation {
    top: HeavyTop,
    /// The line c and two directions that make a right-handed frame with it.
    frame: [Vector3<f64>; 3],
    last: Option<Instant>,
    /// The least and the largest θ.
    range: [f64; 2],
    /// The angle φ at the first and at the last maximum, counted along the run.
    maxima: Option<[f64; 2]>,
    /// The number n of periods between the two.
    periods: u64,
}

/// The nutation at a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Instant {
    time: f64,
    /// The distances 1 − u and 1 + u from the two vertical positions.
    depths: [f64; 2],
    /// The rate du/dt of the height.
    rate: f64,
    /// The angle φ about c.
    angle: f64,
}

impl Nutation {
    /// Creates an empty record of the nutation of a top, before the first sample.
    #[must_use]
    pub fn new(top: &HeavyTop) -> Self {
        let c = top.center_of_mass().normalize();
        // The basis vector that is furthest from c.
        let other = Vector3::ith(c.iamin(), 1.0);
        let e = other - c * c.dot(&other);
        let e = e * e.dot(&e).sqrt().recip();
        let range = [f64::INFINITY, f64::NEG_INFINITY];
        Self { top: *top, frame: [c, e, c.cross(&e)], last: None, range, maxima: None, periods: 0 }
    }

    /// Adds the next sample: the time (s), and the state (Π, Γ). The times increase, or decrease in a run backward in time.
    pub fn observe(&mut self, time: f64, mu: &Se3Dual) {
        let Covector(Pair(pi, gamma)) = mu;
        let [c, e, f] = &self.frame;
        let gamma = gamma / power_of_two(gamma.amax());
        let size = gamma.norm();
        let (normal, height) = (c.cross(&gamma) / size, gamma.dot(c) / size);
        let rate = normal.dot(&self.top.angular_velocity(pi));
        // (1 − u)(1 + u) = sin²θ, for the smaller of the two.
        let (near, far) = (normal.norm_squared() / (1.0 + height.abs()), 1.0 + height.abs());
        let depths = if height > 0.0 { [near, far] } else { [far, near] };
        let mut angle = gamma.dot(f).atan2(gamma.dot(e));
        self.widen(depths);
        if let Some(last) = self.last {
            // The angle is the one nearest to the last one.
            angle = last.angle + ((angle - last.angle + PI).rem_euclid(TAU) - PI);
            let now = Instant { time, depths, rate, angle };
            if (last.rate > 0.0) != (rate > 0.0) {
                self.turn(&last, &now);
            }
        }
        self.last = Some(Instant { time, depths, rate, angle });
    }

    /// Adds the extreme between two samples.
    fn turn(&mut self, from: &Instant, to: &Instant) {
        // The rate, taken as linear, vanishes here.
        let s = from.rate / (from.rate - to.rate);
        if !s.is_finite() {
            return;
        }
        let (r, duration) = (1.0 - s, to.time - from.time);
        let slope = s * r * duration * (r * from.rate - s * to.rate);
        let depth = |i: usize, slope: f64| {
            let ends = r * r * (1.0 + 2.0 * s) * from.depths[i];
            let depth = ends + s * s * (1.0 + 2.0 * r) * to.depths[i] + slope;
            // The cubic may overshoot the vertical.
            if depth < 0.0 { 0.0 } else { depth }
        };
        self.widen([depth(0, -slope), depth(1, slope)]);
        // In a run backward in time the samples come in the other order, and φ returns.
        let sense = duration.signum();
        if from.rate * sense > 0.0 {
            let angle = (r * from.angle + s * to.angle) * sense;
            match &mut self.maxima {
                None => self.maxima = Some([angle; 2]),
                Some([_, latest]) => {
                    *latest = angle;
                    self.periods += 1;
                }
            }
        }
    }

    /// Adds the angle θ with the given 1 − cos θ and 1 + cos θ.
    fn widen(&mut self, [below, above]: [f64; 2]) {
        let angle = 2.0 * below.sqrt().atan2(above.sqrt());
        let [least, most] = self.range;
        self.range = [-larger(-least, -angle), larger(most, angle)];
    }

    /// Returns the amplitude θ_max − θ_min, rad; `None` before the first sample, or if a sample had no direction.
    #[must_use]
    pub fn amplitude(&self) -> Option<f64> {
        let [least, most] = self.range;
        (least.is_finite() && most.is_finite()).then_some(most - least)
    }

    /// Returns the rotation number (φ_n − φ_0)/(2πn), in turns from maximum to maximum; `None` with fewer than two
    /// maxima.
    #[must_use]
    pub fn rotation_number(&self) -> Option<f64> {
        let [first, latest] = self.maxima?;
        let number = (latest - first) / (TAU * self.periods as f64);
        (self.periods > 0 && number.is_finite()).then_some(number)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Γ with u = ½ cos 2t and φ = kt. Π gives its rate under I = 1: it is dΓ/dt × Γ up to a multiple of Γ.
    fn sampled(k: f64, step: f64) -> Nutation {
        let top = HeavyTop::lagrange(1.0, 1.0, 1.0).unwrap();
        let mut nutation = Nutation::new(&top);
        let [_, e, f] = nutation.frame;
        for n in 0..=(50.0 / step.abs()) as u32 {
            let t = f64::from(n) * step;
            let (u, du) = (0.5 * (2.0 * t).cos(), -(2.0 * t).sin());
            let (w, dw) = ((1.0 - u * u).sqrt(), -u * du / (1.0 - u * u).sqrt());
            let (sin, cos) = (k * t).sin_cos();
            let gamma = (e * cos + f * sin) * w + Vector3::z() * u;
            let rate = (e * cos + f * sin) * dw + (f * cos - e * sin) * (w * k) + Vector3::z() * du;
            nutation.observe(t, &Se3Dual::new(rate.cross(&gamma), gamma));
        }
        nutation
    }

    #[test]
    fn a_known_nutation_is_measured() {
        for k in [0.7, -3.0] {
            let nutation = sampled(k, 0.05);
            // The period is π, the advance in it kπ; maxima are located to the second order.
            assert!((nutation.rotation_number().unwrap() - k / 2.0).abs() < 1e-4);
            let exact = (-0.5_f64).acos() - 0.5_f64.acos();
            let backward = sampled(k, -0.05).rotation_number().unwrap();
            assert!((backward - k / 2.0).abs() < 1e-4, "{backward}");
            let error = |step| (sampled(k, step).amplitude().unwrap() - exact).abs();
            // (2h)⁴/384 of u at most, at samples halfway about an extreme
            assert!(error(0.05) < 1e-6 && error(-0.05) < 1e-6, "{}", error(0.05));
            // Control: another motion has another number.
            assert!((sampled(k + 0.1, 0.05).rotation_number().unwrap() - k / 2.0).abs() > 0.04);
        }
    }

    #[test]
    fn a_nutation_next_to_the_vertical_keeps_its_digits() {
        let top = HeavyTop::lagrange(1.0, 1.0, 1.0).unwrap();
        for (side, length) in [(1.0, 1.0), (-1.0, 1.0), (1.0, 1e-200), (-1.0, 1e200)] {
            let mut nutation = Nutation::new(&top);
            for n in 0..1000_u32 {
                let t = f64::from(n) * 0.01;
                // The tilt 1e-9 (1 + ½ sin t) in a fixed plane
                let (tilt, rate) = (1e-9 * (1.0 + 0.5 * t.sin()), 0.5e-9 * t.cos());
                let gamma = Vector3::new(tilt, 0.0, side) * length;
                nutation.observe(t, &Se3Dual::new(-Vector3::y() * (rate * side), gamma));
            }
            // Upright, a part h⁴/384 times a derivative of order four of 1 − u; below, the
            // round-off of π.
            let error = (nutation.amplitude().unwrap() - 1e-9).abs();
            assert!(error < if side > 0.0 { 1e-19 } else { 1e-15 }, "{side} {length}: {error:e}");
        }
    }

    #[test]
    fn what_has_no_value_is_none() {
        let top = HeavyTop::lagrange(1.0, 1.0, 1.0).unwrap();
        let mut nutation = Nutation::new(&top);
        assert_eq!((nutation.amplitude(), nutation.rotation_number()), (None, None));
        let upright = Se3Dual::new(Vector3::z(), Vector3::z());
        (0..10).for_each(|n| nutation.observe(f64::from(n), &upright));
        assert_eq!((nutation.amplitude(), nutation.rotation_number()), (Some(0.0), None));
        nutation.observe(10.0, &Se3Dual::new(Vector3::z(), Vector3::zeros()));
        nutation.observe(11.0, &upright);
        assert_eq!(nutation.amplitude(), None);
    }

    /// Two maxima make a period, whatever is seen of the minima.
    #[test]
    fn a_period_begins_and_ends_at_a_maximum() {
        let top = HeavyTop::lagrange(1.0, 1.0, 1.0).unwrap();
        // u = ½ cos 2t has maxima at 0 and π, and minima at ±½π.
        for (start, end, known) in [(-0.3, 3.5, true), (-1.8, 1.8, false)] {
            let mut nutation = Nutation::new(&top);
            let [_, e, f] = nutation.frame;
            for n in 0..=1000_u32 {
                let t = start + (end - start) * f64::from(n) / 1000.0;
                let (u, du) = (0.5 * (2.0 * t).cos(), -(2.0 * t).sin());
                let w = (1.0 - u * u).sqrt();
                let (sin, cos) = (0.7 * t).sin_cos();
                let gamma = (e * cos + f * sin) * w + Vector3::z() * u;
                let rate = (e * cos + f * sin) * (-u * du / w)
                    + (f * cos - e * sin) * (w * 0.7)
                    + Vector3::z() * du;
                nutation.observe(t, &Se3Dual::new(rate.cross(&gamma), gamma));
            }
            assert_eq!(nutation.rotation_number().is_some(), known);
        }
    }

    /// A spherical top is Lagrange's top for every centre of mass.
    #[test]
    fn the_frame_is_orthonormal_for_every_center_of_mass() {
        for c in [[0.48, 0.6, 0.64], [0.0, -0.6, 0.8], [1.0, 0.0, 0.0]] {
            let body = crate::Body {
                inertia: Vector3::repeat(1.0),
                mass: 1.0,
                gravity: 1.0,
                length: 1.0,
                center_of_mass: Vector3::from(c),
            };
            let [a, b, c] = Nutation::new(&HeavyTop::new(&body).unwrap()).frame;
            for (u, v, product) in
                [(a, a, 1.0), (b, b, 1.0), (c, c, 1.0), (a, b, 0.0), (b, c, 0.0), (c, a, 0.0)]
            {
                assert!((u.dot(&v) - product).abs() < 4.0 * f64::EPSILON, "{u} {v}");
            }
        }
    }
}
