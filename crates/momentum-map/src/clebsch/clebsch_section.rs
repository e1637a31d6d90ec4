//! Lifts of Clebsch maps: [`ClebschSection`].

use super::search::{ACCEPTED, Search};
use crate::actions::action::Side;
use crate::clebsch::clebsch_map::{ClebschMap, clebsch_map};
use crate::maps::fibre::LiftError;
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::maps::recentring::{Both, Far, RecentringWorkspace, Sizes, within};
use crate::phase_spaces::cotangent::Cotangent;
use crate::realisations::{Fibres, Realisation};
use lie_poisson::{
    DualNumber, Mask, Pair, Real, Representation, RepresentedElement, State, Vector,
    euclidean_norm, nearest_power_of_two,
};

/// A lift of a [`ClebschMap`]: it returns for μ ∈ 𝔤∗ a point (q, p) with J(q, p) = μ and |q| = |p|.
///
/// For a fixed q the map p ↦ J(q, p) is linear. Its Moore–Penrose inverse is computed once, for a generic q. If the
/// map is onto the momenta that vanish on the kernel of the representation, then the lift is one product with a
/// constant matrix, and p has the least norm. This is the case if ξq = 0 implies that ξ acts trivially. It holds for
/// enough copies of V = 𝔤, often for two.
///
/// It fails for one copy of 𝔤, since ξ = q satisfies ξq = 0. In such cases Newton's iteration changes both q and p,
/// from eight generic points in turn. With the Moore–Penrose inverse T⁺ of the tangent map T of J at z, its steps are
///
/// ```text
/// z ← ½ z + T⁺ μ    twelve times,    then z ← z + T⁺(μ − J(z))
/// ```
///
/// The first twelve steps lead to a short z. They are Newton's steps with a decay of z, since T z = 2 J(z).
///
/// The lift has the units √(μ/c), where c is the largest matrix element of the representation. It does not depend on
/// these units, as long as 1/c, the coordinates of the lift and the terms of J(q, p) are finite numbers.
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
    search: Search,
    /// Whether J depends on each coordinate of (q, p).
    matters: Vec<bool>,
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
        let r = &map.representation().0;
        Ok(Self { search: Search::new(r)?, matters: on_which_it_depends(r) })
    }

    /// Returns the rank of p ↦ J(q, p), the largest over the generic points q of the lift.
    ///
    /// The map is onto 𝔤∗ if the rank is the dimension of 𝔤. The rank is at most the dimension of 𝔤 minus that of the
    /// kernel of the representation. If it has this value, the lift needs no iteration.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.search.rank()
    }
}

impl ClebschSection {
    /// Returns (q, p) with |q| = |p|, and the residual of J(q, p) = μ relative to μ.
    fn find<R: Representation, T: Real>(
        &self,
        map: &ClebschMap<R>,
        mu: &TargetPoint<ClebschMap<R>, T>,
    ) -> (SourcePoint<ClebschMap<R>, T>, T) {
        let size = largest_coordinate(&mu.0);
        let zero = size.at_most(T::zero());
        let unit = T::one() / T::select(zero, T::one(), size);
        let sign = T::from_f64(match map.side() {
            Side::Left => 1.0,
            Side::Right => -1.0,
        });
        let direction =
            RepresentedElement::<R, T>::from_coordinates(|i| mu.coordinate(i) * unit * sign);
        let (z, residual) = self.search.solve(&map.representation().0, &direction);
        // J is bilinear: q and p take equal parts of the sizes of μ and of the matrix elements.
        let balance = (euclidean_norm(&z.p) / euclidean_norm(&z.q)).sqrt();
        let factor = size.sqrt() * self.search.inverse_scale().sqrt();
        let z = Cotangent { q: z.q.scaled(balance * factor), p: z.p.scaled(factor / balance) };
        (Vector::select(zero, &Vector::zero(), &z), T::select(zero, T::zero(), residual))
    }

    /// Sets the coordinates on which J does not depend to zero where they are larger than the others of q, or of p: those of
    /// p on which no ξq has a component, and those of invariant q. They would hide how the others compare. Smaller ones stay,
    /// so that a z that is near stays the same, and with it what integrators remember of it. What is not finite becomes NaN,
    /// which a step refuses.
    fn without_idle_coordinates<V: Vector>(&self, z: &V) -> V {
        let half = self.matters.len() / 2;
        let largest = |halves: bool, matters: bool| {
            let these = self
                .matters
                .iter()
                .enumerate()
                .filter(|(i, m)| (*i < half) == halves && **m == matters);
            these.fold(V::Scalar::from_f64(0.0), |most, (i, _)| {
                most.larger(z.coordinate(i).magnitude())
            })
        };
        let keeps = [true, false].map(|first| largest(first, false).at_most(largest(first, true)));
        V::from_coordinates(|i| match self.matters.get(i) {
            Some(false) => {
                let [q, p] = keeps;
                let kept = if i < half { q } else { p };
                Real::select(kept, z.coordinate(i), z.coordinate(i) * 0.0)
            }
            _ => z.coordinate(i),
        })
    }

    /// Returns the lift of J(z) in the SIMD lanes in which it has at most four fifths of the length of z, and each
    /// coordinate of J(z) to the round-off of its terms at z. Returns z itself in the others.
    ///
    /// A coordinate that decays keeps its digits, and so the sign that tells its orbit, for as long as J(z) knows them.
    fn lifted_anew<R: Representation, T: Real>(
        &self,
        map: &ClebschMap<R>,
        z: &SourcePoint<ClebschMap<R>, T>,
        known: &TargetPoint<ClebschMap<R>, T>,
    ) -> SourcePoint<ClebschMap<R>, T> {
        let mu = map.apply::<T>(z);
        let (near, _) = self.find(map, &mu);
        let shorter = (largest_coordinate(&near) * 1.25).at_most(largest_coordinate(z));
        let same = within(&(map.apply::<T>(&near) - mu), known, ROUND_OFF);
        Vector::select(shorter.and(same), &near, z)
    }
}

/// The greatest change of a coordinate of the momentum in a move to its lift, relative to the sizes of its terms.
const ROUND_OFF: f64 = 64.0 * f64::EPSILON;

impl<R: Representation> Fibres<ClebschMap<R>> for ClebschSection {
    /// Returns (q, p) with J(q, p) = μ and |q| = |p|, and the origin for μ = 0.
    ///
    /// # Errors
    /// Returns [`LiftError`] if μ is not finite, or if the best point found has an image that differs from μ by more
    /// than 10⁻¹¹ |μ|. Then μ is not in the image of J, or only at the edge of the image, or more copies of V are
    /// needed.
    fn lift<T: Real>(
        &self,
        map: &ClebschMap<R>,
        mu: &TargetPoint<ClebschMap<R>, T>,
    ) -> Result<SourcePoint<ClebschMap<R>, T>, LiftError> {
        let mu = LiftError::unless_finite(*mu, "μ", mu.max_abs(), "μ must be finite")?;
        let (z, residual) = self.find(map, &mu);
        if !residual.at_most(T::from_f64(ACCEPTED)).all() {
            let quantity = "μ − J(q, p), relative to μ";
            let reason = "μ is not in the image of the Clebsch map; more copies, or an extension, may reach it";
            return Err(LiftError { quantity, value: residual.max_abs(), reason });
        }
        let range = Pair(z, map.apply::<T>(&z));
        let reason = "μ must be so small that the terms of J(q, p) are numbers";
        Ok(LiftError::unless_finite(range, "μ", mu.max_abs(), reason)?.0)
    }

    /// Returns a point near the origin on the fibre through z, with sizes of q and p within a factor 16 of each other.
    /// Coordinates on which J does not depend are not larger than others.
    ///
    /// The fibre contains all (aq, p/a). A power of two for a balances q and p without rounding errors. The iteration
    /// then has one unit for all coordinates. With a unit for each block the curve would have no point of least length.
    /// Terms of J(q, p) are measured as they are, since the coordinates of q may decay and grow at different rates.
    ///
    /// For [`Far::Length`] the result is the lift of J(z), wherever z is longer by at least a quarter.
    fn recentred<T: Real>(
        &self,
        map: &ClebschMap<R>,
        z: &SourcePoint<ClebschMap<R>, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<ClebschMap<R>, T> {
        let both = Both {
            apply: |z: &SourcePoint<ClebschMap<R>, T>| map.apply::<T>(z),
            apply_dual: |z: &SourcePoint<ClebschMap<R>, DualNumber<T>>| {
                map.apply::<DualNumber<T>>(z)
            },
        };
        let z = balanced(&self.without_idle_coordinates(z));
        if space.far() == Far::Length {
            let known = space.terms_at(&both.apply_dual, &z);
            return self.lifted_anew(map, &z, &known);
        }
        let size = largest_coordinate(&z).magnitude();
        let units = Vector::from_coordinates(|_| size);
        space.recentred(&both, &z, Sizes { units: &units, factors: &z })
    }
}

/// The ratio of |q| and |p| from which they are balanced.
const UNBALANCED: f64 = 16.0;

/// Returns (aq, p/a) for a power of two a such that |q| and |p| are within a factor 3 of each other, or z itself if they
/// are within [`UNBALANCED`].
fn balanced<Q: Vector>(z: &Cotangent<Q>) -> Cotangent<Q> {
    let one = <Q::Scalar as Real>::from_f64(1.0);
    let ratio = (largest_coordinate(&z.p) / largest_coordinate(&z.q)).magnitude();
    let apart = ratio.at_most(one * UNBALANCED).and((one / UNBALANCED).at_most(ratio)).not();
    let some = ratio.at_most(one * f64::MAX).and((one * f64::MIN_POSITIVE).at_most(ratio));
    let a = Real::select(apart.and(some), nearest_power_of_two(ratio.sqrt()), one);
    Cotangent { q: z.q.scaled(a), p: z.p.scaled(one / a) }
}

/// Returns for each coordinate of (q, p) whether J(q, p) depends on it.
fn on_which_it_depends<R: Representation>(r: &R) -> Vec<bool> {
    let dimension = R::Space::<f64>::DIM;
    let columns = (0..RepresentedElement::<R>::DIM).flat_map(|i| {
        (0..dimension).map(move |j| (j, r.act::<f64>(&Vector::basis(i), &Vector::basis(j))))
    });
    let mut matters = vec![false; 2 * dimension];
    for (j, column) in columns {
        for k in (0..dimension).filter(|&k| column.coordinate(k) != 0.0) {
            matters[j] = true;
            matters[dimension + k] = true;
        }
    }
    matters
}

/// Returns the largest |vᵢ| in each SIMD lane, with its derivative.
fn largest_coordinate<V: Vector>(v: &V) -> V::Scalar {
    let zero = <V::Scalar as Real>::from_f64(0.0);
    (0..V::DIM).fold(zero, |most, i| {
        let x = v.coordinate(i);
        most.larger(x.select_nonnegative(x, -x))
    })
}
