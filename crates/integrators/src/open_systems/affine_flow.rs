//! The flow of an affine field, to round-off: [`affine_flow`].

use crate::error::StepError;
use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use lie_poisson::{Mask, Real, State, Vector};
use momentum_map::{PoissonMap, SourcePoint, TargetDifferential};

/// The part of the largest term below which terms are left out. What they add up to over 10⁷ parts of steps is below round-off,
/// although it always has the same sign.
const LEAST: f64 = 1.0 / (1_u128 << 64) as f64;

/// The number of terms of a sum. For turns by up to 2 radians fewer are enough.
const MOST_TERMS: usize = 30;

/// The number of halvings of the time after which a flow is given up. A field that needs more turns by millions of radians.
const MOST_HALVINGS: i32 = 20;

/// Moves a point along an affine field X(z) = Az + b for a time, to round-off:
///
/// ```text
/// z ↦ z + Σ_k (sᵏ/k!) Aᵏ⁻¹ X(z)
/// ```
///
/// The generator of a constant element of a Lie algebra is such a field for every linear or affine action, and so is Λ(μ)ξ on 𝔤∗:
/// the flow is the action of exp(sξ), and keeps what the action keeps, to a few unbiased rounding errors. The field is evaluated as X(0),
/// X(z) and A v = X(v) − X(0). The sum ends where its terms are below 2⁻⁶⁴ of the largest one, in each block of coordinates by itself. If
/// its terms cancel, as for turns by more than about two radians, the time is halved until they do not. Each lane has the bits that it
/// has alone.
///
/// The closure writes X(v) for a point v. Returns the number of evaluations.
///
/// # Errors
/// [`StepError::NotFinite`] for a point or a field that is not finite, or if no part of the time is short enough.
///
/// # Example
/// A turn by 3 about e₃:
/// ```
/// use collective_integrators::{StepError, affine_flow};
/// use nalgebra::Vector3;
/// let mut z = Vector3::new(1.0, 0.0, 5.0);
/// affine_flow(|v: &Vector3<f64>, rate| *rate = Vector3::z().cross(v), 3.0, &mut z)?;
/// assert!((z - Vector3::new(3.0_f64.cos(), 3.0_f64.sin(), 5.0)).norm() < 1e-15);
/// # Ok::<(), StepError>(())
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn affine_flow<V: State>(
    mut field: impl FnMut(&V, &mut V),
    time: f64,
    z: &mut V,
) -> Result<usize, StepError> {
    let (zero, one) = (V::Scalar::from_f64(0.0), V::Scalar::from_f64(1.0));
    let least = V::Scalar::from_f64(0.5_f64.powi(MOST_HALVINGS));
    let mut sum = Series::like(z);
    // The parts of the time are powers of two, so that what is left is exact.
    let (mut left, mut part, mut evaluations) = (one, one, 0);
    loop {
        let ended = left.at_most(zero);
        if ended.all() {
            return Ok(evaluations);
        }
        if !z.is_finite() || !least.at_most(part).all() {
            return Err(StepError::NotFinite);
        }
        let (converged, made) = sum.of(&mut field, Real::select(ended, zero, part) * time, z);
        evaluations += made;
        let moved = converged.and(ended.not());
        sum.change.add_in_place(z);
        z.replace_where(moved, &sum.change);
        left = Real::select(moved, left - part, left);
        part = Real::select(converged, part, part * 0.5);
    }
}

/// The sum Σ_k (sᵏ/k!) Aᵏ⁻¹ X(z), with its temporaries.
struct Series<V> {
    change: V,
    term: V,
    rate: V,
    origin: V,
    sum: V,
}

impl<V: State> Series<V> {
    #[cfg_attr(optimised, inline(always))]
    fn like(z: &V) -> Self {
        let [change, term, rate, origin, sum] = [(); 5].map(|()| z.zeros_like());
        Self { change, term, rate, origin, sum }
    }

    /// Sums the terms for the time of each lane. Returns the lanes in which the sum is exact to round-off, and the number of
    /// evaluations.
    #[cfg_attr(optimised, inline(always))]
    fn of(
        &mut self,
        field: &mut impl FnMut(&V, &mut V),
        time: V::Scalar,
        z: &V,
    ) -> (MaskOf<V>, usize) {
        let Self { change, term, rate, origin, sum } = self;
        let start = BlockSizes::of(core::slice::from_ref(z));
        let (mut terms, mut converged) = (BlockSizes::zero(), MaskOf::<V>::from_bool(false));
        change.set_zero();
        term.set_zero();
        // The field is called at one place, to be inlined there in wide registers.
        for k in 0..=MOST_TERMS {
            if k == 1 {
                term.assign(z);
            }
            field(term, rate);
            match k {
                0 => {
                    origin.assign(rate);
                    continue;
                }
                1 => {}
                _ => rate.subtract_in_place(origin),
            }
            rate.scale_in_place(time * (k as f64).recip());
            term.move_from(rate);
            sum.assign(change);
            sum.add_in_place(term);
            change.replace_where(converged.not(), sum);
            let size = BlockSizes::of(core::slice::from_ref(term));
            // In a lane that has ended the terms are smaller still.
            terms.include(term);
            let small = size.at_most(
                #[cfg_attr(optimised, inline(always))]
                |block| terms.at(block).maximum(start.at(block)) * LEAST,
            );
            converged = converged.or(small);
            if converged.all() {
                let exact = Self::are_modest(&terms, &start, z, change);
                return (exact, k + 1);
            }
        }
        (converged.and(Self::are_modest(&terms, &start, z, change)), MOST_TERMS + 1)
    }

    /// Returns the lanes in which no terms cancel: none is above twice what the sum begins or ends with, which is finite.
    #[cfg_attr(optimised, inline(always))]
    fn are_modest(terms: &BlockSizes<V>, start: &BlockSizes<V>, z: &V, change: &V) -> MaskOf<V> {
        let mut end = z.clone();
        end.add_in_place(change);
        let end = BlockSizes::of(&[end]);
        let modest = terms.at_most(
            #[cfg_attr(optimised, inline(always))]
            |block| start.at(block).maximum(end.at(block)) * 2.0,
        );
        modest.and(end.at_most(
            #[cfg_attr(optimised, inline(always))]
            |_| V::Scalar::from_f64(f64::MAX),
        ))
    }
}

/// Returns whether the generators of a map are affine, at points whose coordinates obey no simple relation.
pub(crate) fn has_affine_generators<M: PoissonMap>(map: &M) -> bool {
    let [one, other] = [(1.7, 1.0), (2.3, 0.5)].map(|(step, first)| {
        SourcePoint::<M>::from_coordinates(|i| (first + step * i as f64).sin())
    });
    (0..TargetDifferential::<M>::DIM).all(|i| {
        let at = |z: &SourcePoint<M>| map.generator::<f64>(&Vector::basis(i), z);
        let (both, alone) = (at(&(one + other)) + at(&Vector::zero()), at(&one) + at(&other));
        let size = both.max_abs() + alone.max_abs();
        (both - alone).max_abs() <= AFFINE_TOLERANCE * size
    })
}

/// The largest relative deviation from an affine map that is a rounding error.
const AFFINE_TOLERANCE: f64 = 1e-12;
