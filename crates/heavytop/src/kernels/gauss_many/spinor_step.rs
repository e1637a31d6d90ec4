//! A Gauss step on T∗C² in components, for as many tops as there are SIMD lanes.

// The loops are plain, since iterators over lanes do not inline: see `LaneTask`.
#![allow(clippy::needless_range_loop)]

use crate::kernels::gauss_many::spinor_field::{
    FieldParameters, Spinors, imaginary_overlap, real_overlap, square,
};
use crate::paper::spinor_realisation::{SpinorPoint, SpinorRealisation};
use collective_integrators::MOST_LANES;
use lie_poisson::{Covector, Lanes, Mask, Se3Dual};
use momentum_map::{Lift, PoissonMap};
use nalgebra::Vector2;
use num_complex::Complex;

/// The largest h |change of ½Ω| with which a stage has converged.
///
/// The remaining error is smaller by the factor by which a sweep contracts.
const CONVERGED: f64 = 1.0 / (1_u64 << 49) as f64;

/// The largest next change, expected from the ratio of the last two, with which a stage has converged as well.
const NEXT: f64 = 1.0 / (1_u64 << 53) as f64;

/// The number of sweeps after which a lane that has not converged is left to other methods.
const SWEEPS: usize = 40;

/// The coefficients of a Gauss method with S stages, or these times the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ExtendedTableau<const S: usize> {
    pub(crate) a: [[f64; S]; S],
    pub(crate) b: [f64; S],
    /// The product a W, where W extends the stage derivatives of one step to the next.
    pub(crate) extended: [[f64; S]; S],
}

impl<const S: usize> ExtendedTableau<S> {
    /// Returns the coefficients times the step h.
    pub(crate) fn scaled(mut self, step: f64) -> Self {
        let rows = self.a.iter_mut().chain(&mut self.extended).chain([&mut self.b]);
        rows.flatten().for_each(|weight| *weight *= step);
        self
    }
}

/// Points of T∗C² in SIMD lanes, with the constants of their fibres.
pub(crate) struct SpinorLanes<T: Lanes, const S: usize> {
    z: Spinors<T>,
    /// The constants ‖ψ‖² and Im ψ∗χ of the fibre, and 1/‖ψ‖².
    square: T,
    overlap: T,
    inverse_square: T,
    /// The stage derivatives of the last step.
    k: [Spinors<T>; S],
    /// The lanes in which no step has failed.
    pub(crate) alive: T::Mask,
}

impl<T: Lanes, const S: usize> SpinorLanes<T, S> {
    /// Creates the minimal lifts of the states f(i). A lane without a lift is not alive.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn lift<'a>(f: impl Fn(usize) -> &'a Se3Dual) -> Self {
        let mut lifted = [[f64::NAN; 8]; MOST_LANES];
        for (i, lane) in lifted.iter_mut().enumerate().take(T::COUNT) {
            *lane = lift(f(i));
        }
        let mut z = [T::from_f64(0.0); 8];
        for c in 0..8 {
            z[c] = T::from_lanes(|i| lifted.get(i).map_or(f64::NAN, |lane| lane[c]));
        }
        let square = square(&z);
        Self {
            z,
            square,
            overlap: imaginary_overlap(&z),
            inverse_square: T::from_f64(1.0) / square,
            k: [z; S],
            alive: square.at_most(T::from_f64(f64::MAX)),
        }
    }

    /// Returns the momentum in lane i.
    pub(crate) fn momentum(&self, i: usize) -> Se3Dual {
        let z = self.z;
        let complex = |c: usize| Complex::new(z[c].lane(i), z[c + 1].lane(i));
        let chi = Vector2::new(complex(0), complex(2));
        let psi = Vector2::new(complex(4), complex(6));
        SpinorRealisation.apply(&SpinorPoint::new(chi, Covector(psi)))
    }

    /// Advances by one step, with coefficients times the step. A lane without a result is no longer alive.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn step(
        &mut self,
        top: &FieldParameters<T>,
        coefficients: &ExtendedTableau<S>,
        step: f64,
        first: bool,
    ) {
        let mut v = [[T::from_f64(0.0); 3]; S];
        if first {
            let rate = top.field(&top.half_velocity(&self.z), &self.z);
            self.k = [rate; S];
        } else {
            self.guess(top, coefficients, &mut v);
        }
        let mut frozen = self.alive.not();
        let mut last = T::from_f64(0.0);
        let step_squared = T::from_f64(step * step);
        for _ in 0..SWEEPS {
            let change = step_squared * self.sweep(top, coefficients, &mut v, frozen);
            let next = (change * change).at_most(last * (NEXT * NEXT));
            frozen = frozen.or(change.at_most(T::from_f64(CONVERGED * CONVERGED))).or(next);
            let finite = change.at_most(T::from_f64(f64::MAX));
            self.alive = self.alive.and(finite);
            last = change;
            if frozen.or(finite.not()).all() {
                break;
            }
        }
        self.alive = self.alive.and(frozen);
        self.finish(coefficients);
    }

    /// Extrapolates the first stages of a step from the derivatives of the last one, all at once.
    #[cfg_attr(optimised, inline(always))]
    fn guess(
        &mut self,
        top: &FieldParameters<T>,
        coefficients: &ExtendedTableau<S>,
        v: &mut [[T; 3]; S],
    ) {
        let past = self.k;
        for i in 0..S {
            let stage = combine(&self.z, &coefficients.extended[i], &past);
            v[i] = top.half_velocity(&stage);
            self.k[i] = top.field(&v[i], &stage);
        }
    }

    /// Computes each stage from the newest derivatives of the others, and returns the squared change of ½Ω.
    ///
    /// Frozen lanes keep their stages.
    #[cfg_attr(optimised, inline(always))]
    fn sweep(
        &mut self,
        top: &FieldParameters<T>,
        coefficients: &ExtendedTableau<S>,
        v: &mut [[T; 3]; S],
        frozen: T::Mask,
    ) -> T {
        let mut change = T::from_f64(0.0);
        let some_frozen = frozen.any();
        for i in 0..S {
            let stage = combine(&self.z, &coefficients.a[i], &self.k);
            let new = top.half_velocity(&stage);
            for c in 0..3 {
                let d = new[c] - v[i][c];
                change = d.multiply_add(d, change);
            }
            v[i] = new;
            let k = top.field(&new, &stage);
            if some_frozen {
                for c in 0..8 {
                    self.k[i][c] = T::select(frozen, self.k[i][c], k[c]);
                }
            } else {
                self.k[i] = k;
            }
        }
        change
    }

    /// Ends the step, slides it along the fibre to the least ‖χ‖, and restores ‖ψ‖² and Im ψ∗χ.
    ///
    /// The derivatives slide with it.
    #[cfg_attr(optimised, inline(always))]
    fn finish(&mut self, coefficients: &ExtendedTableau<S>) {
        let mut z = combine(&self.z, &coefficients.b, &self.k);
        let excess = (self.square - square(&z)) * self.inverse_square * 0.5;
        for p in 4..8 {
            z[p] = excess.multiply_add(z[p], z[p]);
        }
        let re = real_overlap(&z) * self.inverse_square;
        let im = (imaginary_overlap(&z) - self.overlap) * self.inverse_square;
        for (q, p) in [(0, 4), (2, 6)] {
            let (a, b) = (z[p], z[p + 1]);
            z[q] = im.multiply_add(b, re.negative_multiply_add(a, z[q]));
            z[q + 1] = im.negative_multiply_add(a, re.negative_multiply_add(b, z[q + 1]));
        }
        self.z = z;
        for i in 0..S {
            for q in 0..4 {
                self.k[i][q] = re.negative_multiply_add(self.k[i][q + 4], self.k[i][q]);
            }
        }
    }
}

/// Returns the sum z + Σ_j w_j k_j.
#[cfg_attr(optimised, inline(always))]
fn combine<T: Lanes, const S: usize>(
    z: &Spinors<T>,
    weights: &[f64; S],
    k: &[Spinors<T>; S],
) -> Spinors<T> {
    let mut sum = *z;
    for j in 0..S {
        let weight = T::from_f64(weights[j]);
        for c in 0..8 {
            sum[c] = k[j][c].multiply_add(weight, sum[c]);
        }
    }
    sum
}

/// Returns the minimal lift in components, or NaN if there is none.
fn lift(mu: &Se3Dual) -> [f64; 8] {
    match SpinorRealisation.lift(mu) {
        Ok(SpinorPoint { q, p: Covector(p) }) => {
            [q.x.re, q.x.im, q.y.re, q.y.im, p.x.re, p.x.im, p.y.re, p.y.im]
        }
        Err(_) => [f64::NAN; 8],
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::kernels::gauss_many::gauss_batch::coefficients;
    use crate::tops::top::HeavyTop;
    use collective_integrators::Tableau;
    use nalgebra::Vector3;

    /// The distance of the guessed velocities of the third step from those of the stages.
    fn error_of_guess(step: f64) -> f64 {
        let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
        let top = FieldParameters::<f64>::from_lanes(|_| &top);
        let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
        let scaled = coefficients::<4>(&Tableau::gauss(4).unwrap()).scaled(step);
        let mut lanes = SpinorLanes::<f64, 4>::lift(|_| &start);
        lanes.step(&top, &scaled, step, true);
        lanes.step(&top, &scaled, step, false);
        let (mut v, before) = ([[0.0; 3]; 4], lanes.z);
        lanes.guess(&top, &scaled, &mut v);
        let rest = lanes.sweep(&top, &scaled, &mut v, false);
        assert!(lanes.alive && before == lanes.z);
        rest.sqrt()
    }

    /// The polynomial through the four stages of a step leaves an error of order 5 in the next one.
    #[test]
    fn a_guess_continues_the_stages_of_the_last_step() {
        let [coarse, fine] = [0.04, 0.02].map(error_of_guess);
        let order = (coarse / fine).log2();
        assert!((order - 5.0).abs() < 0.4 && fine > 1e-10, "{coarse:e} {fine:e}: {order}");
    }
}
