//! Points of a fibre near the origin.

use crate::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use lie_poisson::{DualNumber, Mask, Real, Vector, derivative_part, seed, solve_linear};

/// Where the terms of a momentum are this much larger than itself, z is moved. Those of a map like z ↦ |z|², which
/// loses nothing, are up to a dozen times larger.
const LOST: f64 = 32.0;

/// Iterations that move z, each of which halves what is left along the fibre.
const PULLS: usize = 8;

/// Iterations that only bring M(z) back, each of which squares what it is off.
const CORRECTIONS: usize = 6;

/// Added to the matrix 1 + … of the iteration: M may reach only a part of its target, as Π·Γ = 0, and its tangent map
/// has a kernel then. What it takes from a step, the next one brings.
const DAMPING: f64 = 1e-12;

/// z is moved if Σ |z_b|² shrinks to this part of itself, in units in which each block begins with size 1.
const WORTHWHILE: f64 = 0.8;

/// How far M may move, in roundings of its terms at z: M(z) itself is known no better.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// The storage of [`PoissonMap::recentred`]; empty until it is needed.
#[derive(Clone, Debug)]
pub struct RecentringSpace<T> {
    /// T_z M, row by row.
    tangent: Vec<T>,
    /// T_z M W² (T_z M)ᵀ
    gram: Vec<T>,
    multipliers: Vec<T>,
}

impl<T> Default for RecentringSpace<T> {
    fn default() -> Self {
        Self { tangent: Vec::new(), gram: Vec::new(), multipliers: Vec::new() }
    }
}

/// The body of [`PoissonMap::recentred`]: minimises ½ Σ (z_d/w_d)² at constant M(z), w_d the size of the block of d,
/// by steps
///
/// ```text
/// δz = −τ z + W² Aᵀ (A W² Aᵀ)⁻¹ (τ A z + μ − M(z)),    A = T_z M,  τ = ½, then 0
/// ```
pub(crate) fn recentred<M: PoissonMap, T: Real>(
    map: &M,
    z: &SourcePoint<M, T>,
    space: &mut RecentringSpace<T>,
) -> SourcePoint<M, T> {
    let mu = map.apply::<T>(z);
    tangent(map, z, space);
    let units = block_sizes(z);
    let terms = terms::<M, T>(&units, space);
    let far = within(&terms, &block_sizes(&mu), LOST).not();
    if !far.any() {
        return *z;
    }
    let mut moved = *z;
    let mut regular = far;
    for n in 0..PULLS + CORRECTIONS {
        if n > 0 {
            tangent(map, &moved, space);
        }
        let pull = if n < PULLS { 0.5 } else { 0.0 };
        let missing = mu - map.apply::<T>(&moved);
        regular = regular.and(improve::<M, T>(&mut moved, &missing, &units, pull, space));
    }
    let size = |z: &SourcePoint<M, T>| square_in(z, &units);
    let nearer = size(&moved).at_most(size(z) * WORTHWHILE);
    let same = within(&(map.apply::<T>(&moved) - mu), &terms, ROUNDINGS);
    Vector::select(regular.and(nearer).and(same), &moved, z)
}

/// Writes T_z M.
fn tangent<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>, space: &mut RecentringSpace<T>) {
    let (rows, columns) = dimensions::<M, T>();
    space.tangent.resize(rows * columns, T::zero());
    space.gram.resize(rows * rows, T::zero());
    space.multipliers.resize(rows, T::zero());
    for d in 0..columns {
        let moved: SourcePoint<M, DualNumber<T>> = seed(z, &Vector::basis(d));
        let column: TargetPoint<M, T> = derivative_part(&map.apply::<DualNumber<T>>(&moved));
        for r in 0..rows {
            space.tangent[r * columns + d] = column.coordinate(r);
        }
    }
}

/// One step of the iteration; returns where the equations have a solution.
fn improve<M: PoissonMap, T: Real>(
    z: &mut SourcePoint<M, T>,
    missing: &TargetPoint<M, T>,
    units: &SourcePoint<M, T>,
    pull: f64,
    space: &mut RecentringSpace<T>,
) -> T::Mask {
    let (rows, columns) = dimensions::<M, T>();
    let RecentringSpace { tangent, gram, multipliers } = space;
    let square = |d: usize| units.coordinate(d) * units.coordinate(d);
    // Each row in units of its own length, which makes the matrix 1 on its diagonal.
    for r in 0..rows {
        let row = &mut tangent[r * columns..(r + 1) * columns];
        let mut length = T::zero();
        let mut right = missing.coordinate(r);
        for (d, a) in row.iter().enumerate() {
            length += *a * *a * square(d);
            right += *a * z.coordinate(d) * pull;
        }
        let length = length.sqrt();
        let length = T::select(length.at_most(T::zero()), T::one(), length);
        row.iter_mut().for_each(|a| *a /= length);
        multipliers[r] = right / length;
    }
    for (r, s) in (0..rows).flat_map(|r| (0..rows).map(move |s| (r, s))) {
        let mut sum = T::zero();
        for d in 0..columns {
            sum += tangent[r * columns + d] * tangent[s * columns + d] * square(d);
        }
        gram[r * rows + s] = if r == s { sum + DAMPING } else { sum };
    }
    let regular = solve_linear(gram, multipliers);
    let change = SourcePoint::<M, T>::from_coordinates(|d| {
        let mut sum = T::zero();
        for (r, multiplier) in multipliers.iter().enumerate() {
            sum += tangent[r * columns + d] * *multiplier;
        }
        sum * square(d) - z.coordinate(d) * pull
    });
    *z += change;
    regular
}

/// Σ_d |∂_d M_r| w_d, the largest in each block: what M is a sum of, for z with blocks of these sizes.
fn terms<M: PoissonMap, T: Real>(
    units: &SourcePoint<M, T>,
    space: &RecentringSpace<T>,
) -> TargetPoint<M, T> {
    let (_, columns) = dimensions::<M, T>();
    let terms = TargetPoint::<M, T>::from_coordinates(|r| {
        let mut sum = T::zero();
        for d in 0..columns {
            sum += value_of(space.tangent[r * columns + d]) * units.coordinate(d);
        }
        sum
    });
    block_sizes(&terms)
}

/// Where |v_d| ≤ `factor` |w_d| for all d.
fn within<V: Vector<Scalar = T>, T: Real>(v: &V, w: &V, factor: f64) -> T::Mask {
    let mut all = T::Mask::from_bool(true);
    for d in 0..V::DIM {
        all = all.and(value_of(v.coordinate(d)).at_most(value_of(w.coordinate(d)) * factor));
    }
    all
}

/// Each coordinate replaced by the largest magnitude in its block.
fn block_sizes<V: Vector<Scalar = T>, T: Real>(v: &V) -> V {
    V::from_coordinates(|i| {
        let mut most = T::zero();
        for d in (0..V::DIM).filter(|&d| V::block(d) == V::block(i)) {
            most = most.larger(value_of(v.coordinate(d)));
        }
        most
    })
}

/// |x|, of a dual number by its value alone.
fn value_of<T: Real>(x: T) -> T {
    x.select_nonnegative(x, -x)
}

/// Σ (z_d/w_d)²; a block of zeros counts nothing.
fn square_in<V: Vector<Scalar = T>, T: Real>(z: &V, units: &V) -> T {
    let mut sum = T::zero();
    for d in 0..V::DIM {
        let unit = units.coordinate(d);
        let unit = T::select(unit.at_most(T::zero()), T::one(), unit);
        let part = z.coordinate(d) / unit;
        sum += part * part;
    }
    sum
}

/// dim Q and dim P of a map M: P → Q.
fn dimensions<M: PoissonMap, T: Real>() -> (usize, usize) {
    (TargetPoint::<M, T>::DIM, SourcePoint::<M, T>::DIM)
}
