//! Tangent vectors of a state: their steps, their images and the lengths of these.

use super::tangent_scales::TangentScales;
use crate::chaos::tangent_integrator::{DualStateOf, MomentumOf, StateOf, TangentIntegrator};
use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::{BlockScales, DualNumber, State, euclidean_norm, squaring_scale};

/// Makes a step of the tangent vectors of a state, and writes the new ones to `spare`. It is compiled once for any number of
/// them.
#[inline(never)]
pub(super) fn step_tangents<I: TangentIntegrator>(
    integrator: &I,
    (state, units): (&StateOf<I>, BlockScales<StateOf<I>>),
    (tangents, spare): (&[StateOf<I>], &mut [StateOf<I>]),
    (dual, workspace): (&mut DualStateOf<I>, &mut <I as Integrator<DualNumber>>::Workspace),
    size: f64,
) -> Result<(), StepError> {
    for (v, next) in tangents.iter().zip(spare) {
        // The steps are solved to the round-off of the larger of the value and the derivative: they are of one size.
        let factor = power_of_two_near(units.norm(v).recip());
        dual.set_coordinates(|i| DualNumber::new(state.coordinate(i), v.coordinate(i) * factor));
        Integrator::<DualNumber>::step_in_place(integrator, dual, size, workspace)?;
        next.set_coordinates(|i| dual.coordinate(i).derivative() / factor);
    }
    Ok(())
}

/// Divides tangent vectors of a state by the lengths of their images, which it writes to `lengths`. It is compiled once for
/// any number of them.
///
/// # Errors
/// Returns the index and the length of the first image that has no direction.
#[inline(never)]
pub(super) fn normalise_images<I: TangentIntegrator>(
    integrator: &I,
    (state, tangents): (&StateOf<I>, &mut [StateOf<I>]),
    dual: &mut DualStateOf<I>,
    (scales, like): (&TangentScales<StateOf<I>, MomentumOf<I>>, &MomentumOf<I>),
    lengths: &mut [f64],
) -> Result<(), (usize, f64)> {
    for (index, (v, stretch)) in tangents.iter_mut().zip(lengths).enumerate() {
        let mut image = image(integrator, (state, v), dual, scales, like);
        let scale = squaring_scale(&image);
        image.scale_in_place(scale);
        let size = euclidean_norm(&image);
        let length = size / scale;
        // The condition is false for a NaN, which is then an error.
        let has_direction = length > 0.0 && length.is_finite();
        if !has_direction {
            return Err((index, length));
        }
        v.scale_in_place(scale);
        v.scale_in_place(size.recip());
        *stretch = length;
    }
    Ok(())
}

/// Returns the image DM(z) v in units of the scales of the blocks of momenta.
pub(super) fn image<I: TangentIntegrator>(
    integrator: &I,
    (z, v): (&StateOf<I>, &StateOf<I>),
    dual: &mut DualStateOf<I>,
    scales: &TangentScales<StateOf<I>, MomentumOf<I>>,
    like: &MomentumOf<I>,
) -> MomentumOf<I> {
    dual.set_coordinates(|i| DualNumber::new(z.coordinate(i), v.coordinate(i)));
    let moved = Integrator::<DualNumber>::momentum(integrator, dual);
    let mut image = like.clone();
    image.set_coordinates(|i| moved.coordinate(i).derivative() / scales.momentum.at(like.block(i)));
    image
}

/// Returns the power of two next to x > 0, within the range of normal numbers. It is 1 for other x.
fn power_of_two_near(x: f64) -> f64 {
    if x > 0.0 && !x.is_nan() {
        2.0_f64.powi(x.log2().round().clamp(-1000.0, 1000.0) as i32)
    } else {
        1.0
    }
}
