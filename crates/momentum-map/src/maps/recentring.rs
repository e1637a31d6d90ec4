//! Points of a fibre near the origin.

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

/// The storage of [`PoissonMap::recentred`](crate::PoissonMap::recentred); empty until it is needed.
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

/// M over the scalar of z and over dual numbers: what the search knows of a map.
pub(crate) struct Both<F, G> {
    /// M(z)
    pub(crate) apply: F,
    /// M(z + ε v)
    pub(crate) apply_dual: G,
}

impl<T: Real> RecentringSpace<T> {
    /// Minimises ½ Σ (z_d/w_d)² at constant M(z), w_d the size of the block of d, by steps
    ///
    /// ```text
    /// δz = −τ z + W² Aᵀ (A W² Aᵀ)⁻¹ (τ A z + μ − M(z)),    A = T_z M,  τ = ½, then 0
    /// ```
    ///
    /// Returns z itself where M(z) has its digits, or where the iteration fails.
    pub(crate) fn recentred<V, W, V2, W2>(
        &mut self,
        map: &Both<impl Fn(&V) -> W, impl Fn(&V2) -> W2>,
        z: &V,
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
        let units = block_sizes(z);
        let terms: W = self.terms(&units);
        let far = within(&terms, &block_sizes(&mu), LOST).not();
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
            regular = regular.and(self.improve(&mut moved, &missing, &units, pull));
        }
        let size = |z: &V| square_in(z, &units);
        let nearer = size(&moved).at_most(size(z) * WORTHWHILE);
        let same = within(&((map.apply)(&moved) - mu), &terms, ROUNDINGS);
        Vector::select(regular.and(nearer).and(same), &moved, z)
    }

    /// Writes A = T_z M.
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

    /// One step of the iteration; returns where the equations have a solution.
    fn improve<V, W>(&mut self, z: &mut V, missing: &W, units: &V, pull: f64) -> T::Mask
    where
        V: Vector<Scalar = T>,
        W: Vector<Scalar = T>,
    {
        let Self { tangent, gram, multipliers } = self;
        let square = |d: usize| units.coordinate(d) * units.coordinate(d);
        // Each row in units of its own length, which makes the matrix 1 on its diagonal.
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

    /// Σ_d |A_rd| w_d, the largest in each block: what M is a sum of, for z with blocks of these sizes.
    fn terms<V: Vector<Scalar = T>, W: Vector<Scalar = T>>(&self, units: &V) -> W {
        let terms = W::from_coordinates(|r| {
            let mut sum = T::zero();
            for d in 0..V::DIM {
                sum += modulus(self.tangent[r * V::DIM + d]) * units.coordinate(d);
            }
            sum
        });
        block_sizes(&terms)
    }
}

/// Where |v_d| ≤ `factor` |w_d| for all d.
fn within<V: Vector<Scalar = T>, T: Real>(v: &V, w: &V, factor: f64) -> T::Mask {
    let mut all = T::Mask::from_bool(true);
    for d in 0..V::DIM {
        all = all.and(modulus(v.coordinate(d)).at_most(modulus(w.coordinate(d)) * factor));
    }
    all
}

/// Each coordinate replaced by the largest magnitude in its block.
fn block_sizes<V: Vector<Scalar = T>, T: Real>(v: &V) -> V {
    V::from_coordinates(|i| {
        let mut most = T::zero();
        for d in (0..V::DIM).filter(|&d| V::block(d) == V::block(i)) {
            most = most.larger(modulus(v.coordinate(d)));
        }
        most
    })
}

/// |x| with the derivative that it has; [`Real::magnitude`] is a constant.
fn modulus<T: Real>(x: T) -> T {
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
