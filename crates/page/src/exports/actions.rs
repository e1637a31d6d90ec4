//! The functions that change the top. Each returns 0, or 1 if it fails, with its message as the [text](super::texts::text).
#![allow(unsafe_code, reason = "names without mangling are the interface of a WebAssembly module")]

use crate::error::PageError;
use crate::exports::desk::{Desk, attempt, with};
use crate::motions::page_method::PageMethod;
use crate::simulation::running_top::Simulation;
use heavytop::{Body, Coordinate, HeavyTop};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;

/// Returns the address of the 13 parameters of a throw: I₁, I₂, I₃ (kg m²), m g l (N m), c, Π (kg m²/s) and Γ.
///
/// c is scaled to the length 1; it is e₃ where it is 0.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn parameters() -> *mut f64 {
    with(std::ptr::null_mut(), |desk| desk.parameters.as_mut_ptr())
}

/// Throws the top with the [`parameters`], a method of [`PageMethod::ALL`] by its number, and a step in s.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn throw_top(number: u32, step: f64) -> u32 {
    attempt(|desk| {
        let (top, start) = thrown(desk)?;
        desk.simulation = Some(Simulation::new(top, &start, method(number)?, step)?);
        Ok(())
    })
}

/// Replaces the method from a time in s on, which lies within the last step.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn change_method(number: u32, time: f64) -> u32 {
    attempt(|desk| desk.thrown()?.change_method(method(number)?, time))
}

/// Replaces the coefficient of the friction, in N m s, from a time in s on, which lies within the last step.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn change_friction(coefficient: f64, time: f64) -> u32 {
    attempt(|desk| desk.thrown()?.change_friction(coefficient, time))
}

/// Replaces the step, in s.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn change_step(step: f64) -> u32 {
    attempt(|desk| desk.thrown()?.change_step(step))
}

/// Replaces the section by that of a coordinate: Π₁, Π₂, Π₃, Γ₁, Γ₂, Γ₃ are 0 to 5.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn change_section(number: u32) -> u32 {
    attempt(|desk| {
        let coordinate = Coordinate::ALL.get(number as usize);
        let coordinate = coordinate.ok_or(PageError::Unknown { kind: "coordinate", number })?;
        desk.thrown()?.change_section(*coordinate)
    })
}

/// Throws the top from a point of the section.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn begin_orbit(x: f64, y: f64) -> u32 {
    attempt(|desk| desk.thrown()?.begin_orbit(x, y))
}

/// Measures deviations from now on.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn measure_anew() -> u32 {
    attempt(|desk| desk.thrown()?.measure_anew())
}

/// Makes steps until the time is reached, in s, but no more than `most`.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn advance(until: f64, most: u32) -> u32 {
    attempt(|desk| desk.thrown()?.advance(until, most).map(|_| ()))
}

fn method(number: u32) -> Result<PageMethod, PageError> {
    let method = PageMethod::ALL.get(number as usize).copied();
    method.ok_or(PageError::Unknown { kind: "method", number })
}

/// Returns the top and the start that the parameters describe.
fn thrown(desk: &Desk) -> Result<(HeavyTop, Se3Dual), PageError> {
    let [i1, i2, i3, weight_moment, c1, c2, c3, pi1, pi2, pi3, gamma1, gamma2, gamma3] =
        desk.parameters;
    let center = Vector3::new(c1, c2, c3);
    let top = HeavyTop::new(&Body {
        inertia: Vector3::new(i1, i2, i3),
        mass: 1.0,
        gravity: weight_moment,
        length: 1.0,
        center_of_mass: center.try_normalize(0.0).unwrap_or(center),
    })?;
    Ok((top, Se3Dual::new(Vector3::new(pi1, pi2, pi3), Vector3::new(gamma1, gamma2, gamma3))))
}
