//! The search for a point (q, p) with a given image under a Clebsch map.

use super::equations::{PseudoInverse, least_solution};
use crate::maps::fibre::LiftError;
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{Mask, Real, Representation, RepresentedElement, State, Vector, larger};
use nalgebra::DMatrix;

/// The number of points q that are tried.
const STARTS: usize = 8;

/// The number of iterations from each point that shorten z.
const PULLS: usize = 12;

/// The number of Newton iterations after them.
const ITERATIONS: usize = 40;

/// The residual, relative to μ, at which a momentum is reached: the round-off of the sums in J.
const CONVERGED: f64 = 1e-14;

/// The largest residual, relative to μ, of a momentum that is in the image.
pub(super) const ACCEPTED: f64 = 1e-11;

/// The search for a solution of J(q, p)/c = μ, with the data of the representation that it needs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Search {
    /// The linear maps p ↦ J(q, p)/c of generic points q, the best one first.
    starts: Vec<Start>,
    /// The number 1/c, for the largest matrix element c of the representation.
    inverse_scale: f64,
}

/// A point q with the inverse of p ↦ J(q, p)/c.
#[derive(Clone, Debug, PartialEq)]
struct Start {
    seed: usize,
    inverse: PseudoInverse,
}

impl Search {
    /// Prepares the search for a lift.
    ///
    /// # Errors
    /// Returns [`LiftError`] if a matrix element of the representation is not finite, or if the largest one has no
    /// finite reciprocal.
    pub(super) fn new<R: Representation>(r: &R) -> Result<Self, LiftError> {
        let scale = largest_element(r);
        let scale = if scale == 0.0 { 1.0 } else { scale };
        let inverse_scale = scale.recip();
        if !scale.is_finite() || !inverse_scale.is_finite() {
            let reason =
                "the largest matrix element must be a finite number with a finite reciprocal";
            return Err(LiftError { quantity: "ξq", value: scale, reason });
        }
        let start = |seed: usize| {
            let q = generic::<R::Space<f64>>(seed);
            let matrix = DMatrix::from_fn(dimension::<R>(), R::Space::<f64>::DIM, |i, j| {
                // ⟨J(q, e_j), e_i⟩ = ⟨e_j, e_i q⟩
                r.act::<f64>(&Vector::basis(i), &q).coordinate(j) * inverse_scale
            });
            Start { seed, inverse: PseudoInverse::of(matrix) }
        };
        let mut starts: Vec<Start> = (0..STARTS).map(start).collect();
        let quality = |start: &Start| (start.inverse.rank, start.inverse.condition);
        starts.sort_by(|a, b| {
            let ((rank_a, condition_a), (rank_b, condition_b)) = (quality(a), quality(b));
            rank_b.cmp(&rank_a).then(condition_b.total_cmp(&condition_a))
        });
        Ok(Self { starts, inverse_scale })
    }

    /// Returns the number 1/c.
    pub(super) const fn inverse_scale(&self) -> f64 {
        self.inverse_scale
    }

    /// Returns the dimension of the image of p ↦ J(q, p) for the best start.
    pub(super) fn rank(&self) -> usize {
        self.starts.first().map_or(0, |start| start.inverse.rank)
    }

    /// Returns J(z)/c of the left action.
    fn image<R: Representation, T: Real>(
        &self,
        r: &R,
        z: &Cotangent<R::Space<T>>,
    ) -> RepresentedElement<R, T> {
        r.diamond::<T>(&z.q, &z.p).0.scaled(T::from_f64(self.inverse_scale))
    }

    /// Returns a point with J(z)/c = μ, with its residual, by linear equations for p.
    fn linear<R: Representation, T: Real>(
        &self,
        r: &R,
        start: &Start,
        mu: &RepresentedElement<R, T>,
    ) -> (Cotangent<R::Space<T>>, T) {
        let q = generic::<R::Space<f64>>(start.seed);
        let q = R::Space::<T>::from_coordinates(|i| T::from_f64(q.coordinate(i)));
        let solution = |y: &RepresentedElement<R, T>| {
            Vector::from_coordinates(|i| start.inverse.coordinate(i, |j| y.coordinate(j)))
        };
        let mut z = Cotangent { q, p: solution(mu) };
        // The residual of the first solution is its rounding error.
        z.p += solution(&(*mu - self.image(r, &z)));
        let residual = (*mu - self.image(r, &z)).max_norm();
        (z, residual)
    }

    /// Returns (1−τ)z + T⁺(μ − (1−2τ)J(z)/c), a step towards J(z)/c = μ, in the SIMD lanes in which the equations
    /// have a solution. It is Newton's step for τ = 0.
    fn step_towards<R: Representation, T: Real>(
        &self,
        r: &R,
        z: &Cotangent<R::Space<T>>,
        mu: &RepresentedElement<R, T>,
        pull: f64,
    ) -> Cotangent<R::Space<T>> {
        let missing = *mu - self.image(r, z).scaled(T::from_f64(1.0 - 2.0 * pull));
        let start = z.scaled(T::from_f64(1.0 - pull));
        let scale = T::from_f64(self.inverse_scale);
        // ⟨dJ, e_i⟩ = ⟨e_iᵀp, dq⟩ + ⟨dp, e_i q⟩
        let row = |i: usize| {
            let (by_p, by_q) = (
                r.act::<T>(&Vector::basis(i), &z.q),
                r.transpose_act::<T>(&Vector::basis(i), &z.p),
            );
            let d = R::Space::<T>::DIM;
            let entries = (0..2 * d).map(|k| match k.checked_sub(d) {
                None => by_q.coordinate(k) * scale,
                Some(k) => by_p.coordinate(k) * scale,
            });
            entries.collect::<Vec<T>>()
        };
        let rows = (0..dimension::<R>()).map(row).collect();
        let right = (0..dimension::<R>()).map(|i| missing.coordinate(i)).collect();
        let (change, regular) = least_solution::<T>(rows, right);
        let at = |k: usize| change.get(k).copied().unwrap_or_else(T::zero);
        Vector::select(regular, &(start + Vector::from_coordinates(at)), z)
    }

    /// Returns a point with J(z)/c = μ, with its residual, for |μ| = 1 in each SIMD lane.
    pub(super) fn solve<R: Representation, T: Real>(
        &self,
        r: &R,
        mu: &RepresentedElement<R, T>,
    ) -> (Cotangent<R::Space<T>>, T) {
        let bound = |x: f64| T::from_f64(x);
        let mut best = (Vector::zero(), bound(f64::INFINITY));
        for start in &self.starts {
            // A SIMD lane with a solution does not depend on lanes that go on to the next start.
            let before = best;
            let solved = before.1.at_most(bound(ACCEPTED));
            let (z, residual) = self.linear(r, start, mu);
            keep_better(&mut best, z, residual);
            if best.1.at_most(bound(CONVERGED)).all() {
                break;
            }
            // With p = 0 the equations for q would be singular.
            let offset: Cotangent<R::Space<f64>> = generic(start.seed + STARTS);
            let mut z = Cotangent {
                q: z.q,
                p: z.p + Vector::from_coordinates(|i| bound(0.5 * offset.p.coordinate(i))),
            };
            for _ in 0..PULLS {
                z = self.step_towards(r, &z, mu, 0.5);
            }
            for _ in 0..ITERATIONS {
                z = self.step_towards(r, &z, mu, 0.0);
                let residual = (*mu - self.image(r, &z)).max_norm();
                // One more step makes the derivatives of dual numbers converge, too.
                keep_better(&mut best, self.step_towards(r, &z, mu, 0.0), residual);
                if best.1.at_most(bound(CONVERGED)).all() {
                    break;
                }
            }
            best.0 = Vector::select(solved, &before.0, &best.0);
            best.1 = T::select(solved, before.1, best.1);
            if best.1.at_most(bound(ACCEPTED)).all() {
                break;
            }
        }
        best
    }
}

/// Replaces the point in the SIMD lanes in which the new residual is smaller, and not yet small enough.
fn keep_better<V: Vector<Scalar = T>, T: Real>(best: &mut (V, T), z: V, residual: T) {
    let done = best.1.at_most(T::from_f64(CONVERGED));
    let better = residual.at_most(best.1).and(done.not());
    *best = (Vector::select(better, &z, &best.0), T::select(better, residual, best.1));
}

/// Returns the dimension of the algebra.
const fn dimension<R: Representation>() -> usize {
    <RepresentedElement<R> as Vector>::DIM
}

/// Returns the largest matrix element of a representation, or NaN if one of them is NaN.
fn largest_element<R: Representation>(r: &R) -> f64 {
    let of = |i: usize, j: usize| r.act::<f64>(&Vector::basis(i), &Vector::basis(j)).max_abs();
    let indices =
        (0..dimension::<R>()).flat_map(|i| (0..R::Space::<f64>::DIM).map(move |j| (i, j)));
    indices.fold(0.0, |most, (i, j)| larger(most, of(i, j)))
}

/// Returns a vector with coordinates in (−1, 1) that obey no simple relation.
fn generic<V: Vector<Scalar = f64>>(seed: usize) -> V {
    // Multiples of the golden ratio and of √2, modulo 2.
    V::from_coordinates(|i| {
        let (i, seed) = (i as f64 + 1.0, seed as f64 + 1.0);
        let x =
            i * 0.618_033_988_749_895 * seed.sqrt() + i * i * 0.707_106_781_186_547_5 + 0.3 * seed;
        2.0 * x.fract() - 1.0
    })
}
