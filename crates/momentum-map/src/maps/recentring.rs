//! The search for a point of a fibre near the origin: [`RecentringWorkspace`].

use lie_poisson::{DualNumber, Mask, Real, Vector, derivative_part, seed, solve_linear};

/// The ratio of the terms of a momentum to the momentum itself; z is moved if the ratio is larger.
///
/// For a map such as z ↦ |z|², which loses no digits, the ratio is up to a dozen.
const LOST: f64 = 32.0;

/// The number of iterations that move z, each of which halves the remaining distance along the fibre.
const PULLS: usize = 8;

/// The number of iterations that only restore M(z), each of which squares its error.
const CORRECTIONS: usize = 6;

/// The number added to the diagonal of the matrix of the iteration, whose entries there are 1.
///
/// M may reach only a part of its target, as with Π·Γ = 0. Then the matrix is singular without the damping. The next
/// iteration restores what the damping removes in the present one.
const DAMPING: f64 = 1e-12;

/// The fraction to which Σ (z_d/w_d)² must shrink for z to be moved where M(z) has lost digits.
const WORTHWHILE: f64 = 0.8;

/// The same fraction for [`Far::Length`], the square of 4/5.
const SHORTER: f64 = 0.64;

/// The greatest change of a coordinate of M, relative to the sum of the sizes of its terms at z. M(z) is not known to a
/// higher accuracy.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// The greatest growth of the terms of a coordinate of M in a move. Larger terms would cost digits that M(z) has, such
/// as those of a coordinate that decays while others grow.
const LARGER_TERMS: f64 = 4.0;

/// Which points of a fibre of M are so far from the origin that they are moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Far {
    /// Those at which M has lost five bits by cancellation. This is enough for a method whose steps descend, since
    /// their images do not depend on the point of the fibre.
    #[default]
    Digits,
    /// Those for which a point of at most four fifths of the length is found. This is for methods whose steps do not
    /// descend. The errors of their images grow with powers of the length, and so does the derivative of their stage
    /// equations.
    Length,
}

/// The working memory of [`PoissonMap::recentred`](crate::PoissonMap::recentred), allocated when it is
/// first needed.
#[derive(Clone, Debug)]
pub struct RecentringWorkspace<T> {
    far: Far,
    /// The tangent map T_z M, row by row.
    tangent: Vec<T>,
    /// The matrix T_z M W² (T_z M)ᵀ of the linear equations of an iteration.
    gram: Vec<T>,
    multipliers: Vec<T>,
}

impl<T> Default for RecentringWorkspace<T> {
    fn default() -> Self {
        Self::new(Far::default())
    }
}

impl<T> RecentringWorkspace<T> {
    /// Creates an empty memory for moves of the points that count as far.
    #[must_use]
    pub const fn new(far: Far) -> Self {
        Self { far, tangent: Vec::new(), gram: Vec::new(), multipliers: Vec::new() }
    }

    /// Returns which points count as far.
    #[must_use]
    pub const fn far(&self) -> Far {
        self.far
    }
}

/// The magnitudes of the coordinates of z with which the search measures it.
pub(crate) struct Sizes<V> {
    /// The units w_d of the length Σ (z_d/w_d)².
    pub(crate) units: V,
    /// The sizes of the coordinates in the terms of M(z).
    pub(crate) factors: V,
}

/// The map M over the scalar of z and over dual numbers, as the search needs it.
pub(crate) struct Both<F, G> {
    /// The function z ↦ M(z).
    pub(crate) apply: F,
    /// The function z + ε v ↦ M(z + ε v) over dual numbers.
    pub(crate) apply_dual: G,
}

impl<T: Real> RecentringWorkspace<T> {
    /// Returns a point near the origin on the fibre through z, or z itself.
    ///
    /// The iteration minimises ½ Σ (z_d/w_d)² at constant M(z), for the given units w_d, by the changes
    ///
    /// ```text
    /// δz = −τ z + W² Aᵀ (A W² Aᵀ)⁻¹ (τ A z + μ − M(z)),    A = T_z M,  τ = ½, then 0
    /// ```
    ///
    /// The result is z itself where it is not [far](Far), or where the iteration fails.
    pub(crate) fn recentred<V, W, V2, W2>(
        &mut self,
        map: &Both<impl Fn(&V) -> W, impl Fn(&V2) -> W2>,
        z: &V,
        sizes: Sizes<&V>,
    ) -> V
    where
        V: Vector<Scalar = T>,
        W: Vector<Scalar = T>,
        V2: Vector<Scalar = DualNumber<T>>,
        W2: Vector<Scalar = DualNumber<T>>,
    {
        if V::DIM == 0 || W::DIM == 0 {
            return *z;
        }
        let mu = (map.apply)(z);
        self.differentiate::<V, W, V2, W2>(&map.apply_dual, z);
        let Sizes { units, factors } = sizes;
        let known: W = self.terms(factors);
        let (far, worthwhile) = match self.far {
            Far::Digits => {
                (within(&block_sizes(&known), &block_sizes(&mu), LOST).not(), WORTHWHILE)
            }
            Far::Length => (T::Mask::from_bool(true), SHORTER),
        };
        if !far.any() {
            return *z;
        }
        let (mut moved, mut regular) = (*z, far);
        for n in 0..PULLS + CORRECTIONS {
            if n > 0 {
                self.differentiate::<V, W, V2, W2>(&map.apply_dual, &moved);
            }
            let pull = if n < PULLS { 0.5 } else { 0.0 };
            let missing = mu - (map.apply)(&moved);
            regular = regular.and(self.improve(&mut moved, &missing, units, pull));
        }
        let size = |z: &V| square_in(z, units);
        let nearer = size(&moved).at_most(size(z) * worthwhile);
        let same = within(&((map.apply)(&moved) - mu), &known, ROUNDINGS);
        self.differentiate::<V, W, V2, W2>(&map.apply_dual, &moved);
        let precise = within(&self.terms(&moved), &known, LARGER_TERMS);
        Vector::select(regular.and(nearer).and(same).and(precise), &moved, z)
    }

    /// Returns the sizes of the terms of M(z), with the coordinates of z as their factors.
    pub(crate) fn terms_at<V, W, V2, W2>(&mut self, apply: &impl Fn(&V2) -> W2, z: &V) -> W
    where
        V: Vector<Scalar = T>,
        W: Vector<Scalar = T>,
        V2: Vector<Scalar = DualNumber<T>>,
        W2: Vector<Scalar = DualNumber<T>>,
    {
        self.differentiate::<V, W, V2, W2>(apply, z);
        self.terms(z)
    }

    /// Computes the tangent map A = T_z M.
    fn differentiate<V, W, V2, W2>(&mut self, apply: &impl Fn(&V2) -> W2, z: &V)
    where
        V: Vector<Scalar = T>,
        W: Vector<Scalar = T>,
        V2: Vector<Scalar = DualNumber<T>>,
        W2: Vector<Scalar = DualNumber<T>>,
    {
        self.tangent.resize(W::DIM * V::DIM, T::zero());
        self.gram.resize(W::DIM * W::DIM, T::zero());
        self.multipliers.resize(W::DIM, T::zero());
        for d in 0..V::DIM {
            let moved: V2 = seed(z, &V::basis(d));
            let column: W = derivative_part(&apply(&moved));
            for r in 0..W::DIM {
                self.tangent[r * V::DIM + d] = column.coordinate(r);
            }
        }
    }

    /// Performs one iteration and returns the mask of the lanes in which its equations have a solution.
    fn improve<V, W>(&mut self, z: &mut V, missing: &W, units: &V, pull: f64) -> T::Mask
    where
        V: Vector<Scalar = T>,
        W: Vector<Scalar = T>,
    {
        let Self { tangent, gram, multipliers, .. } = self;
        let square = |d: usize| units.coordinate(d) * units.coordinate(d);
        // Each row is divided by its length, so that the matrix is 1 on its diagonal.
        for (r, row) in tangent.chunks_exact_mut(V::DIM).enumerate() {
            let (mut length, mut right) = (T::zero(), missing.coordinate(r));
            for (d, a) in row.iter().enumerate() {
                length += *a * *a * square(d);
                right += *a * z.coordinate(d) * pull;
            }
            let length = length.sqrt();
            let length = T::select(length.at_most(T::zero()), T::one(), length);
            row.iter_mut().for_each(|a| *a /= length);
            multipliers[r] = right / length;
        }
        for (r, first) in tangent.chunks_exact(V::DIM).enumerate() {
            for (s, second) in tangent.chunks_exact(V::DIM).enumerate() {
                let mut sum = T::from_f64(if r == s { DAMPING } else { 0.0 });
                for (d, (a, b)) in first.iter().zip(second).enumerate() {
                    sum += *a * *b * square(d);
                }
                gram[r * W::DIM + s] = sum;
            }
        }
        let regular = solve_linear(gram, multipliers);
        *z += V::from_coordinates(|d| {
            let mut sum = T::zero();
            for (row, multiplier) in tangent.chunks_exact(V::DIM).zip(multipliers.iter()) {
                sum += row[d] * *multiplier;
            }
            sum * square(d) - z.coordinate(d) * pull
        });
        regular
    }

    /// Returns the size Σ_d |A_rd z_d| of the terms whose sum is M.
    fn terms<V: Vector<Scalar = T>, W: Vector<Scalar = T>>(&self, z: &V) -> W {
        W::from_coordinates(|r| {
            let mut sum = T::zero();
            for d in 0..V::DIM {
                sum += modulus(self.tangent[r * V::DIM + d] * z.coordinate(d));
            }
            sum
        })
    }
}

/// Returns the mask of the lanes in which |v_d| ≤ `factor` |w_d| for all d.
pub(crate) fn within<V: Vector<Scalar = T>, T: Real>(v: &V, w: &V, factor: f64) -> T::Mask {
    let mut all = T::Mask::from_bool(true);
    for d in 0..V::DIM {
        all = all.and(modulus(v.coordinate(d)).at_most(modulus(w.coordinate(d)) * factor));
    }
    all
}

/// Replaces each coordinate by the largest magnitude in its block.
pub(crate) fn block_sizes<V: Vector<Scalar = T>, T: Real>(v: &V) -> V {
    V::from_coordinates(|i| {
        let mut most = T::zero();
        for d in (0..V::DIM).filter(|&d| v.block(d) == v.block(i)) {
            most = most.larger(modulus(v.coordinate(d)));
        }
        most
    })
}

/// Returns |x| with its derivative, which [`Real::magnitude`] drops.
fn modulus<T: Real>(x: T) -> T {
    x.select_nonnegative(x, -x)
}

/// Returns Σ (z_d/w_d)², where a block of zeros has unit 1.
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

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector1, Vector2};

    /// Recentres a point of M(z) = 100 z₁ − 100, which loses digits near z₁ = 1. The fibres are lines along z₂, and
    /// their points of least norm have z₂ = 0.
    fn recentred(z: Vector2<f64>) -> Vector2<f64> {
        let map = Both {
            apply: |z: &Vector2<f64>| Vector1::new(100.0 * z.x - 100.0),
            apply_dual: |z: &Vector2<DualNumber>| Vector1::new(z.x * 100.0 - 100.0),
        };
        RecentringWorkspace::default().recentred(
            &map,
            &z,
            Sizes { units: &block_sizes(&z), factors: &block_sizes(&z) },
        )
    }

    /// A point moves if Σ (z_d/w)² shrinks to four fifths: here from 1.81 or 1.27 to 1, but not from 1.21 or 1.01.
    #[test]
    fn a_point_stays_where_it_gains_little() {
        for (y, moves) in [(0.9, true), (0.52, true), (0.46, false), (0.1, false), (0.0, false)] {
            let z = Vector2::new(1.001, y);
            let moved = recentred(z);
            // Each iteration with a pull halves z₂.
            let expected =
                if moves { Vector2::new(z.x, y * 0.5_f64.powi(PULLS as i32)) } else { z };
            // A few roundings of numbers of size 1.
            assert!((moved - expected).amax() < 1e-14 && (moves || moved == z), "{y}: {moved}");
        }
    }
}
