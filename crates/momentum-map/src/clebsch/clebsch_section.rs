//! Lifts of Clebsch maps: [`ClebschSection`].

use super::equations::{PseudoInverse, least_solution};
use crate::{
    ClebschMap, Cotangent, Fibres, LiftError, PoissonMap, Realisation, SectionOf, Side,
    SourcePoint, TargetPoint, clebsch_map,
};
use lie_poisson::{
    Mask, Pair, Real, Representation, RepresentedElement, Vector, euclidean_norm, larger,
};
use nalgebra::DMatrix;

/// The number of points q that are tried.
const STARTS: usize = 8;

/// The number of Newton iterations from each point.
const ITERATIONS: usize = 40;

/// The residual, relative to μ, at which a momentum is reached: the round-off of the sums in J.
const CONVERGED: f64 = 1e-14;

/// The largest residual, relative to μ, of a momentum that is in the image.
const ACCEPTED: f64 = 1e-11;

/// A lift of a [`ClebschMap`]: for μ ∈ 𝔤∗ a point (q, p) with J(q, p) = μ and |q| = |p|.
///
/// For a fixed q the map p ↦ J(q, p) is linear. Its Moore–Penrose inverse is computed once, for a generic q. If it is
/// onto the momenta that vanish on the kernel of the representation, then the lift is one product with a constant
/// matrix, and p has the least norm. This is so if ξq = 0 implies that ξ acts trivially. It holds for enough copies of
/// V = 𝔤, often for two.
///
/// Otherwise, as for one copy of 𝔤, where ξ = q is in the way, Newton's iteration changes both q and p. It starts from
/// eight generic points in turn, and takes the least change in each step.
///
/// The lift has the units √(μ/c), where c is the largest matrix element of the representation. So it exists for
/// momenta and structure constants of every size.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Diagonal, InfinitesimalAdjoint, So3};
/// use momentum_map::{Lift, PoissonMap, Side, clebsch_realisation};
/// use nalgebra::Vector3;
/// let mu = Covector(Vector3::new(1e30, -2e30, 0.5e30));
/// let one = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Right)?;
/// let two = clebsch_realisation(Diagonal::<_, 2>(InfinitesimalAdjoint(So3)), Side::Right)?;
/// assert!((one.apply(&one.lift(&mu)?) - mu).0.norm() < 1e-13 * mu.0.norm());
/// assert!((two.apply(&two.lift(&mu)?) - mu).0.norm() < 1e-14 * mu.0.norm());
/// assert_eq!((one.fibres().rank(), two.fibres().rank()), (2, 3));
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ClebschSection {
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

/// A Clebsch map with its lift.
pub type ClebschRealisation<R> = Realisation<ClebschMap<R>, ClebschSection>;

/// Returns the Clebsch map of a representation with its lift, for the left or for the right action.
///
/// # Errors
/// Returns [`LiftError`] if a matrix element of the representation is not finite, or if the largest one has no finite
/// reciprocal.
///
/// # Example
/// From structure constants to a lift, for Heisenberg's algebra [e₁, e₂] = e₀ with its centre e₀:
/// ```
/// use lie_poisson::{Covector, Diagonal, ExtendedAdjoint, InfinitesimalAdjoint, StructureConstants};
/// use momentum_map::{Lift, PoissonMap, Side, clebsch_realisation};
/// use nalgebra::Vector3;
/// let heisenberg = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
///     (1, 2, 0) => 1.0,
///     (2, 1, 0) => -1.0,
///     _ => 0.0,
/// })?;
/// let mu = Covector(Vector3::new(2.0, -1.0, 0.5));
/// let map = clebsch_realisation(ExtendedAdjoint::of(heisenberg.clone())?, Side::Right)?;
/// assert!((map.apply(&map.lift(&mu)?) - mu).0.norm() < 1e-14);
/// // the adjoint representation does not see the centre
/// let adjoint = Diagonal::<_, 3>(InfinitesimalAdjoint(heisenberg));
/// let error = clebsch_realisation(adjoint, Side::Right)?.lift(&mu).unwrap_err();
/// assert!(error.to_string().contains("not in the image"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn clebsch_realisation<R: Representation>(
    representation: R,
    side: Side,
) -> Result<ClebschRealisation<R>, LiftError> {
    let map = clebsch_map(representation, side);
    let section = ClebschSection::new(&map)?;
    Ok(Realisation::new(map, section))
}

impl ClebschSection {
    /// Creates the lift of a Clebsch map.
    ///
    /// # Errors
    /// Returns [`LiftError`] if a matrix element of the representation is not finite, or if the largest one has no
    /// finite reciprocal.
    pub fn new<R: Representation>(map: &ClebschMap<R>) -> Result<Self, LiftError> {
        let representation = &map.representation().0;
        let scale = largest_element(representation);
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
                representation.act::<f64>(&Vector::basis(i), &q).coordinate(j) * inverse_scale
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

    /// Returns the dimension of the momenta J(q, p) for the best of the fixed points q, with p ∈ V∗.
    ///
    /// The map is onto 𝔤∗ if it is the dimension of 𝔤. It is at most the dimension of 𝔤 minus that of the kernel of the
    /// representation. If it has this value, the lift needs no iteration.
    #[must_use]
    pub fn rank(&self) -> usize {
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

    /// Returns z moved by a Newton step towards J(z)/c = μ, in the SIMD lanes in which the equations have a solution.
    fn newton_step<R: Representation, T: Real>(
        &self,
        r: &R,
        z: &Cotangent<R::Space<T>>,
        mu: &RepresentedElement<R, T>,
    ) -> Cotangent<R::Space<T>> {
        let missing = *mu - self.image(r, z);
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
        Vector::select(regular, &(*z + Vector::from_coordinates(at)), z)
    }

    /// Returns a point with J(z)/c = μ, with its residual, for |μ| = 1 in each SIMD lane.
    fn solve<R: Representation, T: Real>(
        &self,
        r: &R,
        mu: &RepresentedElement<R, T>,
    ) -> (Cotangent<R::Space<T>>, T) {
        let bound = |x: f64| T::from_f64(x);
        let mut best = (Vector::zero(), bound(f64::INFINITY));
        for start in &self.starts {
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
            for _ in 0..ITERATIONS {
                z = self.newton_step(r, &z, mu);
                let residual = (*mu - self.image(r, &z)).max_norm();
                // One more step makes the derivatives of dual numbers converge, too.
                keep_better(&mut best, self.newton_step(r, &z, mu), residual);
                if best.1.at_most(bound(CONVERGED)).all() {
                    break;
                }
            }
            if best.1.at_most(bound(ACCEPTED)).all() {
                break;
            }
        }
        best
    }
}

impl<R: Representation> Fibres<ClebschMap<R>> for ClebschSection {}

impl<R: Representation> SectionOf<ClebschMap<R>> for ClebschSection {
    /// Returns (q, p) with J(q, p) = μ and |q| = |p|, and the origin for μ = 0.
    ///
    /// # Errors
    /// Returns [`LiftError`] if μ is not finite, or if the best point found has an image that differs from μ by more
    /// than 10⁻¹¹ |μ|. Then μ is not in the image of J, or only at the edge of it, or more copies of V are needed.
    fn lift<T: Real>(
        &self,
        map: &ClebschMap<R>,
        mu: &TargetPoint<ClebschMap<R>, T>,
    ) -> Result<SourcePoint<ClebschMap<R>, T>, LiftError> {
        let mu = LiftError::unless_finite(*mu, "μ", mu.max_abs(), "μ must be finite")?;
        let size = largest_coordinate(&mu.0);
        let zero = size.at_most(T::zero());
        let unit = T::one() / T::select(zero, T::one(), size);
        let sign = T::from_f64(match map.side() {
            Side::Left => 1.0,
            Side::Right => -1.0,
        });
        let direction =
            RepresentedElement::<R, T>::from_coordinates(|i| mu.coordinate(i) * unit * sign);
        let (z, residual) = self.solve(&map.representation().0, &direction);
        if !residual.at_most(T::from_f64(ACCEPTED)).or(zero).all() {
            let quantity = "μ − J(q, p), relative to μ";
            let reason = "μ is not in the image of the Clebsch map; more copies, or an extension, may reach it";
            return Err(LiftError { quantity, value: residual.max_abs(), reason });
        }
        // J is bilinear: q and p take equal parts of the sizes of μ and of the matrix elements.
        let balance = (euclidean_norm(&z.p) / euclidean_norm(&z.q)).sqrt();
        let factor = size.sqrt() * self.inverse_scale.sqrt();
        let z = Cotangent { q: z.q.scaled(balance * factor), p: z.p.scaled(factor / balance) };
        let z = Vector::select(zero, &Vector::zero(), &z);
        let range = Pair(z, map.apply::<T>(&z));
        let reason = "μ must be so small that the terms of J(q, p) are numbers";
        Ok(LiftError::unless_finite(range, "μ", mu.max_abs(), reason)?.0)
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

/// Returns the largest |vᵢ| in each SIMD lane, with its derivative.
fn largest_coordinate<V: Vector>(v: &V) -> V::Scalar {
    let zero = <V::Scalar as Real>::from_f64(0.0);
    (0..V::DIM).fold(zero, |most, i| {
        let x = v.coordinate(i);
        most.larger(x.select_nonnegative(x, -x))
    })
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
