//! Stage equations that are to be solved with one stage in each SIMD lane: [`LaneProblem`].

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::{NEAR, Ratios};
use crate::iteration::prediction::{LARGEST_GROWTH, Prediction};
use crate::iteration::stage_rows::{StageColumns, StageRow, StageRows, WIDTH};
use crate::iteration::stage_scale::{Scale, StageScale, SweepChange};
use crate::iteration::stage_solver::{StageSolver, Unconverged};
use core::hint::black_box;
use lie_poisson::{Lanes, Mask, Real, State};

/// The number of iterations in the solution of stage equations, or the error of the iteration.
pub type Outcome<V> = Result<usize, Unconverged<MaskOf<V>>>;

/// The stage equations k_i = X(z + h Σ_j a_ij k_j) of a step over `f64`, with a guess of their solution.
///
/// A [`VectorField`](crate::VectorField) that wraps another one passes it on to [`VectorField::solve_in_lanes`] of that
/// one.
///
/// [`VectorField::solve_in_lanes`]: crate::VectorField::solve_in_lanes
#[derive(Debug)]
pub struct LaneProblem<'a, V: State> {
    pub(crate) columns: &'a StageColumns,
    pub(crate) solver: &'a StageSolver,
    pub(crate) scale: &'a StageScale<V>,
    pub(crate) z: &'a V,
    pub(crate) step: f64,
    /// The guess unless there is a prediction, and after the iteration the stage derivatives.
    pub(crate) k: &'a mut [V],
    pub(crate) prediction: Option<Prediction<'a, V>>,
    pub(crate) pace: &'a mut Ratios<V::Scalar>,
    /// The number of sweeps of the last step from as good a guess, or 0.
    pub(crate) usual: usize,
    pub(crate) rows: &'a mut StageRows,
}

/// The number of sweeps that are watched before the one with which the iteration is expected to end.
///
/// To measure the changes of a sweep takes as long as the sweep, and those of the first ones say nothing about its end.
const WATCHED: usize = 4;

impl<V: State> LaneProblem<'_, V> {
    /// Solves the equations by sweeps with room for S stages side by side, for a field over the lanes `T`, which writes its
    /// value to a vector of the space of `blank`. Returns `None` if what is predicted is too large to be a guess.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn solve<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &mut self,
        blank: W,
        field: impl Fn(&W, &mut W),
    ) -> Option<Outcome<V>> {
        let mut vectors = [blank.clone(), blank.clone(), blank];
        self.rows.fit(self.z.dimension());
        match self.prediction.take() {
            None => self.write_guess(),
            Some(prediction) => {
                if !self.write_prediction::<T, W, S>(prediction, &mut vectors[0]) {
                    return None;
                }
            }
        }
        let mut unwatched = self.usual.saturating_sub(WATCHED).min(self.solver.max_iterations / 2);
        let outcome = loop {
            self.rows.k.clone_from(&self.rows.guess);
            let outcome = self.iterate::<T, W, S>(&field, &mut vectors, unwatched);
            // What has not been watched may have led to another solution, or away from all.
            if unwatched == 0 || outcome.is_ok() && self.stays_near_guess::<T, W, S>(&mut vectors) {
                break outcome;
            }
            unwatched = 0;
        };
        self.read_rows();
        Some(outcome)
    }

    /// Makes sweeps from the guess in the rows until they have converged, the first ones without measuring their changes.
    #[cfg_attr(optimised, inline(always))]
    fn iterate<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &mut self,
        field: &impl Fn(&W, &mut W),
        vectors: &mut [W; 3],
        unwatched: usize,
    ) -> Outcome<V> {
        let Self { columns, solver, scale, z, step, pace, rows, .. } = self;
        let sweep = Sweep { columns, z: *z, step: *step };
        let (none, whole) = (Mask::from_bool(false), Mask::from_bool(columns.low.is_none()));
        let mut left = unwatched;
        let outcome = solver.iterate(
            solver.max_iterations - unwatched,
            (none, whole),
            *scale,
            pace,
            #[cfg_attr(optimised, inline(always))]
            |_, near| {
                // Each number is broadcast from memory, which costs nothing. Without the black box the compiler would
                // take it from the registers in which it was computed, which costs shuffles.
                let rows = black_box(&mut **rows);
                loop {
                    let mut progress =
                        SweepChange { change: BlockSizes::zero(), size: BlockSizes::zero() };
                    let how = (left == 0, near.any());
                    for block in 0..S.div_ceil(T::COUNT) {
                        sweep.advance::<T, W, S>(field, how, block, (rows, vectors), &mut progress);
                    }
                    rows.take_next();
                    if left == 0 {
                        let SweepChange { change, size } = &progress;
                        break SweepChange {
                            change: largest_lanes(change),
                            size: largest_lanes(size),
                        };
                    }
                    left -= 1;
                }
            },
        );
        outcome.map(|watched| unwatched + watched)
    }

    /// Returns whether the stage derivatives in the rows are near the guess, block by block. The vectors are overwritten.
    #[cfg_attr(optimised, inline(always))]
    fn stays_near_guess<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &self,
        [k, guess, _]: &mut [W; 3],
    ) -> bool {
        let (mut apart, mut size) = (BlockSizes::zero(), BlockSizes::zero());
        for block in 0..S.div_ceil(T::COUNT) {
            k.set_coordinates(|c| self.rows.k[c].load(block));
            guess.set_coordinates(|c| self.rows.guess[c].load(block));
            apart.include_difference(k, guess);
            size.include(k);
        }
        let progress = SweepChange { change: largest_lanes(&apart), size: largest_lanes(&size) };
        let (apart, size) = self.scale.compare(&progress);
        apart.at_most(size * NEAR).all()
    }

    /// Writes the guess to the rows.
    #[cfg_attr(optimised, inline(always))]
    fn write_guess(&mut self) {
        let Some(last) = self.k.len().checked_sub(1) else { return };
        for i in 0..WIDTH {
            let k = &self.k[i.min(last)];
            for (c, row) in self.rows.guess.iter_mut().enumerate() {
                row.0[i] = number(k.coordinate(c));
            }
        }
    }

    /// Writes what is predicted to the rows. Returns whether it is modest. The vector is overwritten.
    #[cfg_attr(optimised, inline(always))]
    fn write_prediction<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &mut self,
        Prediction { past, columns }: Prediction<'_, V>,
        guess: &mut W,
    ) -> bool {
        let of_last_step = past.len().saturating_sub(self.columns.stages);
        let (last, mut size) = (BlockSizes::of(&past[of_last_step..]), BlockSizes::zero());
        for block in 0..S.div_ceil(T::COUNT) {
            guess.set_coordinates(
                #[cfg_attr(optimised, inline(always))]
                |c| {
                    let mut sum = T::zero();
                    for (column, k) in columns.iter().zip(past) {
                        sum += column.load::<T>(block) * T::from_f64(number(k.coordinate(c)));
                    }
                    sum
                },
            );
            size.include(guess);
            for (c, row) in self.rows.guess.iter_mut().enumerate() {
                row.store(guess.coordinate(c), block);
            }
        }
        let size: BlockSizes<V> = largest_lanes(&size);
        let modest = size.at_most(
            #[cfg_attr(optimised, inline(always))]
            |block| last.at(block) * LARGEST_GROWTH,
        );
        modest.all()
    }

    /// Reads the stage derivatives from the rows.
    #[cfg_attr(optimised, inline(always))]
    fn read_rows(&mut self) {
        for (i, k) in self.k.iter_mut().enumerate() {
            k.set_coordinates(
                #[cfg_attr(optimised, inline(always))]
                |c| V::Scalar::from_f64(self.rows.k[c].0[i]),
            );
        }
    }
}

/// What does not change from sweep to sweep.
struct Sweep<'a, V> {
    columns: &'a StageColumns,
    z: &'a V,
    step: f64,
}

impl<V: State> Sweep<'_, V> {
    /// Computes the next stage derivatives in a block of lanes, and measures the changes if they are `watched`. If they are
    /// `near` the solution, the sums with the low parts of the coefficients are computed first. The vectors are overwritten.
    #[cfg_attr(optimised, inline(always))]
    fn advance<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &self,
        field: &impl Fn(&W, &mut W),
        how: (bool, bool),
        block: usize,
        (rows, vectors): (&mut StageRows, &mut [W; 3]),
        progress: &mut SweepChange<W>,
    ) {
        // Local variables of a small type stay in registers.
        let mut local;
        let vectors = if size_of::<W::Pool>() == 0 {
            local = vectors.clone();
            &mut local
        } else {
            vectors
        };
        self.advance_with::<T, W, S>(field, how, block, (rows, vectors), progress);
    }

    #[cfg_attr(optimised, inline(always))]
    fn advance_with<T: Lanes, W: State<Scalar = T>, const S: usize>(
        &self,
        field: &impl Fn(&W, &mut W),
        (watched, near): (bool, bool),
        block: usize,
        (StageRows { k, next, small, .. }, [point, value, before]): (&mut StageRows, &mut [W; 3]),
        progress: &mut SweepChange<W>,
    ) {
        if near && let Some(low) = &self.columns.low {
            for (small, k) in small.iter_mut().zip(&*k) {
                small.store(combination::<T, S>(low, k, T::zero(), block), block);
            }
        }
        let dimension = point.dimension();
        let (k, small) = (&k[..dimension], &small[..dimension]);
        let h = T::from_f64(self.step);
        point.set_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |c| {
                let small = small[c].load(block);
                let sum = combination::<T, S>(&self.columns.whole, &k[c], small, block);
                sum * h + T::from_f64(number(self.z.coordinate(c)))
            },
        );
        field(point, value);
        if watched {
            before.set_coordinates(
                #[cfg_attr(optimised, inline(always))]
                |c| k[c].load(block),
            );
            progress.change.include_difference(value, before);
            progress.size.include(value);
        }
        for (c, row) in next[..dimension].iter_mut().enumerate() {
            row.store(value.coordinate(c), block);
        }
    }
}

/// Returns `start` + Σ_j a_ij k_j for the stages i of a block.
#[cfg_attr(optimised, inline(always))]
fn combination<T: Lanes, const S: usize>(
    columns: &[StageRow; WIDTH],
    k: &StageRow,
    start: T,
    block: usize,
) -> T {
    let mut sum = start;
    for (column, &k) in columns[..S].iter().zip(&k.0[..S]) {
        sum += column.load::<T>(block) * T::from_f64(k);
    }
    sum
}

/// Returns a coordinate as a number. There are lanes for `f64` alone.
#[cfg_attr(optimised, inline(always))]
fn number<T: Real>(x: T) -> f64 {
    x.as_f64().unwrap_or(f64::NAN)
}

/// Returns the largest sizes in all lanes.
#[cfg_attr(optimised, inline(always))]
fn largest_lanes<T: Lanes, W: State<Scalar = T>, V: State>(sizes: &BlockSizes<W>) -> BlockSizes<V> {
    let all = |x: T, f: fn(f64, f64) -> f64| (1..T::COUNT).fold(x.lane(0), |y, i| f(x.lane(i), y));
    BlockSizes::from_parts(
        #[cfg_attr(optimised, inline(always))]
        |block| V::Scalar::from_f64(all(sizes.at(block), Real::maximum)),
        V::Scalar::from_f64(all(sizes.sum(), |x, y| x + y)),
    )
}

#[cfg(test)]
mod tests {
    use super::{BlockSizes, largest_lanes};
    use lie_poisson::{DefaultLanes, Lanes, Pair, State, Vector};
    use nalgebra::{Vector1, Vector2};

    type Point<T> = Pair<Vector1<T>, Vector2<T>>;

    /// Returns the sizes of four vectors that were measured side by side.
    fn side_by_side(vectors: &[Point<f64>; 4]) -> BlockSizes<Point<f64>> {
        let lanes: Point<DefaultLanes> =
            Point::from_coordinates(|c| DefaultLanes::from_lanes(|i| vectors[i].coordinate(c)));
        largest_lanes(&BlockSizes::of(&[lanes]))
    }

    /// All numbers are multiples of 1/4, whose sums are exact.
    #[test]
    fn vectors_side_by_side_have_the_sizes_of_the_same_vectors_one_by_one() {
        let vectors =
            [0.25, -8.0, 2.0, -1.0].map(|x| Pair(Vector1::new(x), Vector2::new(3.0 - x, 4.0 * x)));
        let (found, expected) = (side_by_side(&vectors), BlockSizes::of(&vectors));
        assert_eq!([found.at(0), found.at(1)], [8.0, 32.0]);
        assert_eq!([found.at(0), found.at(1)], [expected.at(0), expected.at(1)]);
        assert_eq!(found.sum(), expected.sum());
    }

    #[test]
    fn what_is_not_finite_is_seen_in_each_lane() {
        for lane in 0..4 {
            for fault in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut vectors = [Pair(Vector1::new(1.0), Vector2::new(-2.0, 3.0)); 4];
                vectors[lane].1.x = fault;
                let sizes = side_by_side(&vectors);
                let largest = sizes.largest_of(&BlockSizes::zero(), |_| 0.0);
                assert!(!largest.is_finite(), "{fault} in lane {lane}: {largest}");
            }
        }
    }
}
