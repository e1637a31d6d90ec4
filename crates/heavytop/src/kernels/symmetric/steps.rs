//! The two flows of a symmetric top in components, for as many tops as there are SIMD lanes.

use crate::kernels::symmetric::axial_turn::AxialTurn;
use crate::kernels::symmetric::drift_polynomials::DriftPolynomials;
use crate::splittings::symmetric_top::SymmetricTopSplitting;
use collective_integrators::MOST_LANES;
use lie_poisson::{Covector, Lanes, Pair, Se3Dual};
use nalgebra::Vector3;

/// The states Π and Γ in the variables in which the flows take the fewest operations.
///
/// They are
///
/// ```text
/// w = hΠ/I₁        by which a step h turns a spherical top
/// v = w·Γ          constant along both flows
/// ```
///
/// in axes turned about e₃ such that the centre of mass has no second component.
#[derive(Clone, Copy)]
pub(crate) struct MomentumLanes<T> {
    w: [T; 3],
    gamma: [T; 3],
    vertical: T,
    /// The sum of the rounding errors of w₃² so far. The next square includes it. Otherwise, if w₃ is constant, all
    /// squares would have the same error, and |Γ|² would drift.
    lost: T,
    /// The largest |w|² or δ²w₃² of all drifts, whose angles are the roots of these numbers times the drift's
    /// time. A NaN may be missing.
    pub(crate) largest: T,
}

/// The parameters of tops that the flows depend on.
#[derive(Clone, Copy)]
pub(crate) struct FlowParameters<T> {
    /// The factor h/I₁ of Π.
    scale: T,
    /// The elongation δ = I₁/I₃ − 1 of the inertia ellipsoid.
    elongation: T,
    /// The force (f₁, f₃) = m g l (c₁, c₃)h²/I₁ in the turned axes.
    force: [T; 2],
    axes: AxialTurn<T>,
}

impl<T: Lanes> MomentumLanes<T> {
    /// Gathers the states of the tops: lane i is f(i).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn from_lanes<'a>(
        top: &FlowParameters<T>,
        f: impl Fn(usize) -> &'a Se3Dual,
    ) -> Self {
        let w = |k: usize| T::from_lanes(|i| f(i).0.0[k]) * top.scale;
        let gamma = |k: usize| T::from_lanes(|i| f(i).0.1[k]);
        let w = top.axes.undo([w(0), w(1), w(2)]);
        let gamma = top.axes.undo([gamma(0), gamma(1), gamma(2)]);
        Self {
            w,
            gamma,
            vertical: dot(&w, &gamma),
            lost: T::from_f64(0.0),
            largest: T::from_f64(0.0),
        }
    }

    /// Returns a function that reads the state in each lane.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn momenta(&self, top: &FlowParameters<T>) -> impl Fn(usize) -> Se3Dual {
        let (w, gamma) = (top.axes.apply(self.w), top.axes.apply(self.gamma));
        let pi = w.map(|w| w / top.scale);
        let vector = |v: &[T; 3], i| Vector3::new(v[0].lane(i), v[1].lane(i), v[2].lane(i));
        move |i| Covector(Pair(vector(&pi, i), vector(&gamma, i)))
    }

    /// Advances by the kick φ_2^ch: w ← w + c Γ×f.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn kick(&mut self, top: &FlowParameters<T>, c: f64) {
        let [first, third] = top.force.map(|f| f * c);
        let g = self.gamma;
        self.w[0] = g[1].multiply_add(third, self.w[0]);
        self.w[1] = g[0].negative_multiply_add(third, g[2].multiply_add(first, self.w[1]));
        self.w[2] = g[1].negative_multiply_add(first, self.w[2]);
    }

    /// Advances by the drift φ_1^ch, with the Stumpff functions c₁, c₂ at c²|w|².
    ///
    /// The flow is
    ///
    /// ```text
    /// Γ ← (1 − c²|w|² c₂) Γ + c² c₂ v w − c c₁ w×Γ,
    /// ```
    ///
    /// and then w and Γ turn about e₃ by −c δ w₃.
    ///
    /// This is Rodrigues' formula with v for w·Γ. A rounding error of w·Γ does not persist, since each flow
    /// moves w·Γ towards v by the factor of the cosine.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn drift(&mut self, top: &FlowParameters<T>, drift: &DriftPolynomials) {
        let (w, g) = (self.w, self.gamma);
        let transverse = cross(&w, &g);
        let rate = -top.elongation * w[2];
        let axial = square(w[2], &mut self.lost);
        let (x, y) = (w[0].multiply_add(w[0], w[1].multiply_add(w[1], axial)), rate * rate);
        self.largest = x.maximum(y.maximum(self.largest));
        let (at_x, (sine, half_tangent)) = drift.at(x, y);
        let (first, leading) = (at_x.sine, at_x.half_square);
        let cosine = x.negative_multiply_add(leading, T::from_f64(1.0));
        let about_w = x.negative_multiply_add(at_x.rest, cosine);
        let along = at_x.rest.multiply_add(self.vertical, leading * self.vertical);
        let turned = |k: usize| {
            let longitudinal = along.multiply_add(w[k], about_w * g[k]);
            first.negative_multiply_add(transverse[k], longitudinal)
        };
        let g = [turned(0), turned(1), turned(2)];
        let turn = AxialTurn { half_tangent: rate * half_tangent, sine: rate * sine };
        (self.w, self.gamma) = (turn.apply(w), turn.apply(g));
    }
}

impl<T: Lanes> FlowParameters<T> {
    /// Gathers the parameters of the tops: lane i is f(i).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn from_lanes<'a>(
        step: f64,
        f: impl Fn(usize) -> &'a SymmetricTopSplitting,
    ) -> Self {
        let mut turned = [(AxialTurn::default(), [0.0; 2]); MOST_LANES];
        for (i, turned) in turned.iter_mut().enumerate().take(T::COUNT) {
            let top = f(i).top();
            *turned = AxialTurn::of_axes(&(top.center_of_mass() * top.weight_moment()));
        }
        let scale = T::from_lanes(|i| step / f(i).top().inertia().x);
        let unit = scale * step;
        // A thin rod never turns about itself: any elongation serves.
        let elongation = |inertia: Vector3<f64>| match inertia.z == 0.0 {
            true => 0.0,
            false => (inertia.x - inertia.z) / inertia.z,
        };
        Self {
            scale,
            elongation: T::from_lanes(|i| elongation(f(i).top().inertia())),
            force: [0, 1].map(|k| T::from_lanes(|i| turned[i].1[k]) * unit),
            axes: AxialTurn::from_lanes(|i| &turned[i].0),
        }
    }

    /// Returns an upper bound of |w|² and δ²w₃² for motions with the present energy.
    ///
    /// With e = ½|w|² + ½δw₃² + f·Γ,
    ///
    /// ```text
    /// |w|² ≤ 2(e + |f||Γ|)/min(1, 1 + δ),  w₃² ≤ 2(e + |f||Γ|)/(1 + δ)
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn bound(&self, motion: &MomentumLanes<T>) -> T {
        let one = T::from_f64(1.0);
        let f = [self.force[0], T::from_f64(0.0), self.force[1]];
        let (w, g, d) = (motion.w, motion.gamma, self.elongation);
        let doubled = dot(&w, &w) + d * w[2] * w[2];
        let potential = dot(&f, &g) + (dot(&f, &f) * dot(&g, &g)).sqrt();
        let least = d.select_nonnegative(one, d + 1.0);
        (doubled + potential * 2.0) * (one / least).maximum(d * d / (d + 1.0))
    }
}

/// Returns a² with what former squares have `lost` by rounding, and updates that sum of rounding errors.
#[cfg_attr(optimised, inline(always))]
fn square<T: Lanes>(a: T, lost: &mut T) -> T {
    if T::FUSED {
        let square = a.multiply_add(a, *lost);
        *lost += a.multiply_subtract(a, square);
        return square;
    }
    // Halves of 26 bits, whose products are exact (Dekker 1971).
    let spread = a * T::from_f64(134_217_729.0);
    let upper = spread - (spread - a);
    let lower = a - upper;
    let rounded = a * a;
    let error = (upper * upper - rounded) + upper * lower * 2.0 + lower * lower;
    let missing = *lost + error;
    let square = rounded + missing;
    *lost = missing - (square - rounded);
    square
}

#[cfg_attr(optimised, inline(always))]
fn dot<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].multiply_add(b[0], a[1].multiply_add(b[1], a[2] * b[2]))
}

#[cfg_attr(optimised, inline(always))]
fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].multiply_subtract(b[2], a[2] * b[1]),
        a[2].multiply_subtract(b[0], a[0] * b[2]),
        a[0].multiply_subtract(b[1], a[1] * b[0]),
    ]
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::tops::top::HeavyTop;

    /// With Γ against the force, the energy is kinetic. The bound is then attained by turns about e₃ if I₃ is large or
    /// small, and by those about e₁ in between.
    #[test]
    fn the_bound_of_the_angles_is_attained() {
        for (third, axis) in [(1.5, 2), (1.0, 0), (0.6, 0), (0.25, 2)] {
            let top = HeavyTop::lagrange(1.0, third, 1.0).unwrap();
            let splitting = SymmetricTopSplitting::new(top).unwrap();
            let parameters = FlowParameters::<f64>::from_lanes(0.1, |_| &splitting);
            let force = top.center_of_mass() * top.weight_moment();
            let start = Se3Dual::new(Vector3::ith(axis, 2.0), -force.normalize());
            let motion = MomentumLanes::from_lanes(&parameters, |_| &start);
            let [turn, drift] = [dot(&motion.w, &motion.w), parameters.elongation * motion.w[2]];
            let largest = turn.max(drift * drift);
            let bound = parameters.bound(&motion);
            assert!((bound - largest).abs() < 1e-14 * largest, "{third}: {bound} {largest}");
        }
    }
}
