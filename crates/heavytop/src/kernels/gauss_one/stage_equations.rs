//! The solution of the stage equations of one step, for SIMD lanes of any width.
//!
//! Loops over coordinates and stages have constant ranges, so that the compiler keeps arrays of registers in
//! registers. [`LaneTask`] explains why there are no closures and iterators.
#![allow(clippy::needless_range_loop)]

use super::compensated_point::CompensatedPoint;
use super::gauss_coefficients::GaussCoefficients;
use super::row::{Row, Stages, WIDTH};
use super::stage_history::StageHistory;
use crate::kernels::infinitesimal_rotation::infinitesimal_rotation;
use core::hint::black_box;
use lie_poisson::{LaneTask, Lanes, Mask};

/// The number of sweeps after which the general solver takes over.
pub(super) const MOST: usize = 48;

/// A change of at most this multiple of the size is the last one.
///
/// The next change, a tenth of it at the step sizes that these methods are used with, is far below a rounding error.
/// But the rest has the same sign in every step. With four times this bound, which saves a tenth of the time, f₁, f₂
/// and h of a single top drifted by up to 6e-20 per step, with eight stages and steps of 1/4.
const FEW_ROUNDINGS: f64 = 0.0625 * f64::EPSILON;

/// A change of at most this multiple of the size is round-off if it is not smaller than the one before it.
const CLOSE: f64 = f64::EPSILON;

/// A change of at most this multiple of the size is round-off if neither it nor the change before it was smaller than
/// its predecessor.
///
/// A single larger change says nothing: where the sweeps contract slowly, by complex factors, their changes rise now
/// and then. Two in succession need a factor above ½, with which [`MOST`] sweeps do not converge.
const ROUND_OFF: f64 = 256.0 * f64::EPSILON;

/// One attempted step from a point, with room for S stages; `None` if the stage equations do not converge.
pub(super) struct Attempt<'a, const S: usize> {
    pub(super) coefficients: &'a GaussCoefficients,
    pub(super) step: f64,
    /// The change of a point, relative to the point, with which the iteration may end before the round-off floor.
    pub(super) tolerance: f64,
    pub(super) start: &'a CompensatedPoint,
    pub(super) history: &'a mut StageHistory,
}

impl<const S: usize> LaneTask for Attempt<'_, S> {
    type Output = Option<(CompensatedPoint, usize)>;

    #[cfg_attr(optimised, inline(always))]
    fn run<T: Lanes>(self) -> Option<(CompensatedPoint, usize)> {
        let Self { coefficients, step, tolerance, start, history } = self;
        let expected = history.recall(start, step);
        let (last, stages) = history.stages();
        let products = start.products();
        let equations = StageEquations { coefficients, step, tolerance, start, products };
        let sweeps = equations.solve::<T, S>(last, stages, expected)?;
        let mut end = start.plus_sum(stages);
        let slid = if end.has_drifted(coefficients.reach) { end.slide() } else { 0.0 };
        history.keep(&end, step, sweeps, slid);
        end.is_finite().then_some((end, sweeps))
    }
}

/// The data of the stage equations of one step.
#[derive(Clone, Copy)]
struct StageEquations<'a> {
    coefficients: &'a GaussCoefficients,
    step: f64,
    tolerance: f64,
    start: &'a CompensatedPoint,
    /// The product ‖χ‖‖ψ‖ at the start.
    products: f64,
}

impl StageEquations<'_> {
    /// Solves the stage equations by sweeps and returns their number.
    ///
    /// The first sweep starts from an extrapolation of the last step. Convergence is tested from the sweep
    /// before number `expected` on.
    #[cfg_attr(optimised, inline(always))]
    fn solve<T: Lanes, const S: usize>(
        self,
        last: &Stages,
        stages: &mut Stages,
        expected: usize,
    ) -> Option<usize> {
        let blocks = S.div_ceil(T::COUNT);
        let mut turns = [[T::zero(); 3]; WIDTH];
        let mut changes = [T::from_f64(f64::INFINITY); WIDTH];
        let mut converged = [T::Mask::from_bool(false); WIDTH];
        let mut grew = [T::Mask::from_bool(false); WIDTH];
        for block in 0..blocks {
            let z = self.stage_points::<T, S>(&self.coefficients.guess, last, block);
            turns[block] = self.turn(&z, block);
            store(&self.generator(&turns[block], &z, block), stages, block);
        }
        for sweep in 2..=MOST {
            // Each number of ℓ is broadcast from memory, which costs nothing. Without the black box the
            // compiler would take it from the registers in which it was computed, which costs shuffles.
            let stages = black_box(&mut *stages);
            let watched = sweep + 1 >= expected;
            let mut all = T::Mask::from_bool(true);
            for block in 0..blocks {
                let z = self.stage_points::<T, S>(&self.coefficients.columns, stages, block);
                let turn = self.turn(&z, block);
                let values = self.generator(&turn, &z, block);
                if watched {
                    let change = distance(&turn, &turns[block]);
                    let size = self.size(&turn, block);
                    let grows = changes[block].at_most(change);
                    let floor = round_off(size, grows, grew[block]);
                    let now = change.at_most(floor.maximum(self.accepted(block)));
                    converged[block] = converged[block].or(now);
                    all = all.and(converged[block]);
                    changes[block] = change;
                    grew[block] = grows;
                }
                turns[block] = turn;
                store(&values, stages, block);
            }
            if watched && all.all() {
                return Some(sweep);
            }
        }
        None
    }

    /// Returns the stage points Z_i = z + Σ_j m_ij ℓ_j, adding small numbers first.
    #[cfg_attr(optimised, inline(always))]
    fn stage_points<T: Lanes, const S: usize>(
        self,
        m: &[Row; WIDTH],
        stages: &Stages,
        block: usize,
    ) -> [T; WIDTH] {
        let mut z = [T::zero(); WIDTH];
        for c in 0..WIDTH {
            z[c] = T::from_f64(self.start.carry.0[c]);
        }
        for j in 0..S {
            let column: T = m[j].load(block);
            for c in 0..WIDTH {
                z[c] = column.multiply_add(T::from_f64(stages[c].0[j]), z[c]);
            }
        }
        for c in 0..WIDTH {
            z[c] += T::from_f64(self.start.z.0[c]);
        }
        z
    }

    /// Returns the weighted half velocity (h b/2) Ω = (h b/2) I⁻¹Π, with Π = M(Z).
    #[cfg_attr(optimised, inline(always))]
    fn turn<T: Lanes>(self, z: &[T; WIDTH], block: usize) -> [T; 3] {
        let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
        let [a, b, c] = self.times_step::<T>(&self.coefficients.turn, block);
        let x = q4.negative_multiply_add(p1, q1 * p4) + q2.negative_multiply_add(p3, q3 * p2);
        let y = q1.negative_multiply_add(p3, q3 * p1) + q2.negative_multiply_add(p4, q4 * p2);
        let z = q2.negative_multiply_add(p1, q1 * p2) + q3.negative_multiply_add(p4, q4 * p3);
        [x * a, y * b, z * c]
    }

    /// Returns the stage derivative ℓ = h b ((i/2)(Ω·σ)χ + 2(γ·σ)ψ, (i/2)(Ω·σ)ψ).
    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Lanes>(self, turn: &[T; 3], z: &[T; WIDTH], block: usize) -> [T; WIDTH] {
        let [q1, q2, q3, q4, p1, p2, p3, p4] = *z;
        let [g1, g2, g3] = self.times_step::<T>(&self.coefficients.pull, block);
        let pull = [
            g3.multiply_add(p1, g1.multiply_add(p3, g2 * p4)),
            g3.multiply_add(p2, g2.negative_multiply_add(p3, g1 * p4)),
            g3.negative_multiply_add(p3, g2.negative_multiply_add(p2, g1 * p1)),
            g3.negative_multiply_add(p4, g2.multiply_add(p1, g1 * p2)),
        ];
        let [a, b, c, d] = infinitesimal_rotation(turn, [q1, q2, q3, q4], pull);
        let [e, f, g, h] = infinitesimal_rotation(turn, [p1, p2, p3, p4], [T::zero(); 4]);
        [a, b, c, d, e, f, g, h]
    }

    /// Returns the size of (h b/2) Ω, or that of the products ‖χ‖‖ψ‖ where Π, a difference of them, is
    /// smaller.
    #[cfg_attr(optimised, inline(always))]
    fn size<T: Lanes>(self, turn: &[T; 3], block: usize) -> T {
        let [a, b, c] = self.times_step::<T>(&self.coefficients.turn, block);
        let least = (a + b + c).magnitude() * T::from_f64(self.products);
        least + turn[0].magnitude() + turn[1].magnitude() + turn[2].magnitude()
    }

    /// Returns the largest change of (h b/2) Ω that the tolerance accepts: it moves the stage derivative h b Ẋ by b times that
    /// part of the point.
    #[cfg_attr(optimised, inline(always))]
    fn accepted<T: Lanes>(self, block: usize) -> T {
        self.coefficients.weights.load::<T>(block) * T::from_f64(self.tolerance)
    }

    #[cfg_attr(optimised, inline(always))]
    fn times_step<T: Lanes>(self, rows: &[Row; 3], block: usize) -> [T; 3] {
        let (h, [a, b, c]) = (T::from_f64(self.step), rows);
        [a.load::<T>(block) * h, b.load::<T>(block) * h, c.load::<T>(block) * h]
    }
}

#[cfg_attr(optimised, inline(always))]
fn store<T: Lanes>(values: &[T; WIDTH], stages: &mut Stages, block: usize) {
    for c in 0..WIDTH {
        stages[c].store(values[c], block);
    }
}

/// Returns the distance Σ_k |a_k − b_k|.
#[cfg_attr(optimised, inline(always))]
fn distance<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> T {
    (a[0] - b[0]).magnitude() + (a[1] - b[1]).magnitude() + (a[2] - b[2]).magnitude()
}

/// Returns the largest change that is round-off, lane by lane. The masks say whether it, and the change before it, were not
/// smaller than their predecessors.
#[cfg_attr(optimised, inline(always))]
fn round_off<T: Lanes>(size: T, grows: T::Mask, grew: T::Mask) -> T {
    let [few, close, floor] = [FEW_ROUNDINGS, CLOSE, ROUND_OFF].map(T::from_f64);
    size * T::select(grows, T::select(grew, floor, close), few)
}
