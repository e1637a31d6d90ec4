//! The interaction of every two of many vortices, on SIMD lanes: [`Interaction`].

use crate::vortices::sources::{BLOCK, Sources};
use lie_poisson::Real;
use lie_poisson::generic_scalars::{LaneTask, Lanes};
use nalgebra::Vector3;

/// The sums S_i = Σ_j m_j/(1 − x_i·x_j), j ≠ i, of consecutive vortices i, with one vortex in each SIMD lane.
///
/// Every sum goes through j in ascending order, so that its bits depend neither on the lanes nor on the threads, but
/// only on whether products and sums are fused.
pub(crate) struct Interaction<'a, R> {
    /// The positions and moments of all vortices.
    pub(crate) sources: &'a Sources,
    /// The first vortex i, a multiple of [`BLOCK`].
    pub(crate) first: usize,
    /// Where the sums of this vortex and of those after it are written.
    pub(crate) sums: &'a mut [Vector3<R>],
}

impl<R: Real> LaneTask for Interaction<'_, R> {
    type Output = ();

    #[cfg_attr(optimised, inline(always))]
    fn run<T: Lanes>(self) {
        let mut first = self.first;
        for sums in self.sums.chunks_mut(T::COUNT) {
            let sum = sums_of::<T>(self.sources, first);
            for (lane, sums) in sums.iter_mut().enumerate() {
                for component in 0..3 {
                    sums[component] = R::from_f64(sum[component].lane(lane));
                }
            }
            first += T::COUNT;
        }
    }
}

/// Returns the sums of the vortices in the lanes, of which `first` is the first.
#[cfg_attr(optimised, inline(always))]
fn sums_of<T: Lanes>(sources: &Sources, first: usize) -> [T; 3] {
    let rows = sources.rows();
    let start = first - first % BLOCK;
    let (before, rest) = rows.split_at(start.min(rows.len()));
    let (near, after) = rest.split_at(BLOCK.min(rest.len()));
    let x = sources.positions::<T>(first);
    let mut sum = [T::from_f64(0.0); 3];
    add_others(&x, before, &mut sum);
    add_neighbours(&x, near, first - start, &mut sum);
    add_others(&x, after, &mut sum);
    sum
}

/// Adds the terms of vortices that are in none of the lanes.
#[cfg_attr(optimised, inline(always))]
fn add_others<T: Lanes>(x: &[T; 3], rows: &[[f64; 6]], sum: &mut [T; 3]) {
    for row in rows {
        add(T::from_f64(1.0) / distance(x, row), row, sum);
    }
}

/// Adds the terms of the vortices in one block, except that of each vortex with itself. The lanes begin with the given
/// vortex of the block.
#[cfg_attr(optimised, inline(always))]
fn add_neighbours<T: Lanes>(x: &[T; 3], rows: &[[f64; 6]], first: usize, sum: &mut [T; 3]) {
    // An infinite distance from itself makes that term zero.
    let mut infinite = [0.0; 3 * BLOCK];
    infinite[BLOCK] = f64::INFINITY;
    for (j, row) in rows.iter().enumerate() {
        let itself = T::load(infinite.get(BLOCK + first - j..).unwrap_or_default());
        add(T::from_f64(1.0) / (distance(x, row) + itself), row, sum);
    }
}

/// Returns 1 − x_i·x_j, half the square of the distance of two points of the unit sphere.
#[cfg_attr(optimised, inline(always))]
fn distance<T: Lanes>(x: &[T; 3], row: &[f64; 6]) -> T {
    let mut rest = T::from_f64(1.0);
    for component in 0..3 {
        rest = x[component].negative_multiply_add(T::from_f64(row[component]), rest);
    }
    rest
}

/// Adds a multiple of m_j.
#[cfg_attr(optimised, inline(always))]
fn add<T: Lanes>(factor: T, row: &[f64; 6], sum: &mut [T; 3]) {
    for component in 0..3 {
        let moment = T::from_f64(row[3 + component]);
        sum[component] = factor.multiply_add(moment, sum[component]);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use lie_poisson::generic_scalars::{InstructionSet, Width, dispatch};

    fn position(i: usize) -> Vector3<f64> {
        let x = i as f64;
        Vector3::new((2.3 * x).sin(), (1.7 * x).cos(), (0.9 * x + 0.2).sin()).normalize()
    }

    fn sums(count: usize, set: InstructionSet, width: Width) -> Vec<Vector3<f64>> {
        let mut sources = Sources::default();
        sources.fill((0..count).map(|i| (position(i), position(i) * (1.0 + i as f64))));
        let mut sums = vec![Vector3::zeros(); count];
        // in two tasks, as on two threads
        let (before, after) = sums.split_at_mut(BLOCK.min(count));
        for (first, sums) in [(0, before), (BLOCK, after)] {
            dispatch(Interaction { sources: &sources, first, sums }, set, width).unwrap();
        }
        sums
    }

    #[test]
    fn every_width_and_instruction_set_returns_the_same_sums() {
        for count in [0, 1, 2, 3, 15, 16, 17, 31, 32, 33, 40] {
            let plain = sums(count, InstructionSet::Portable, Width::Single);
            for width in Width::ALL {
                assert_eq!(sums(count, InstructionSet::Portable, width), plain, "{count}");
            }
            let fused = |set| Width::ALL.map(|width| sums(count, set, width));
            let sets = InstructionSet::available().filter(|set| *set != InstructionSet::Portable);
            let fused: Vec<_> = sets.flat_map(fused).collect();
            assert!(fused.windows(2).all(|two| two[0] == two[1]), "{count}");
            for (i, plain) in plain.iter().enumerate() {
                let distance = |j: &usize| 1.0 - position(i).dot(&position(*j));
                let others = || (0..count).filter(|j| *j != i);
                let size = |j: usize| (1.0 + j as f64) / distance(&j);
                let exact = others()
                    .fold(Vector3::zeros(), |sum: Vector3<f64>, j| sum + position(j) * size(j));
                // Six roundings of a distance, and one of each partial sum.
                let bound: f64 = others().map(|j| size(j) * (6.0 / distance(&j) + 40.0)).sum();
                for sum in fused.iter().map(|sums| sums[i]).chain([*plain]) {
                    assert!((sum - exact).amax() <= bound * f64::EPSILON, "{count} {i}");
                }
                // Control: the bound is far below a term.
                assert!(others().all(|j| size(j) > 1e3 * bound * f64::EPSILON), "{count} {i}");
            }
        }
    }
}
