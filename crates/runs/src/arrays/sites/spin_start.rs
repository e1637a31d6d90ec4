//! The spins at a start.

use super::sites_system::numbers;
use crate::arrays::any_arrays::Started;
use crate::arrays::arguments::Given;
use crate::arrays::directions::{Directions, on_cone};
use core::f64::consts::{PI, TAU};
use lie_poisson_formula_systems::{FormulaSystemError, Parameter};
use nalgebra::Vector3;

/// The largest number of periods of a wave along an axis.
const MOST_PERIODS: f64 = 1e6;

/// What gives the spins at the start.
pub(in crate::arrays) const SPIN_START: [Parameter; 6] = [
    Parameter::list("S", "the components of all spins, those of the last axis of the shape first")
        .or(&[]),
    Parameter::vector("direction", 3, "of the spins, instead of S").or(&[0.0, 0.0, 1.0]),
    Parameter::list("waves", "periods of a spin wave along each axis; it needs a cone").or(&[]),
    Parameter::number("cone", "the angle of its spins from the direction, rad").or(&[0.0]),
    Parameter::number("tilt", "the largest random angle from the direction, or from the wave, rad")
        .or(&[0.0]),
    Parameter::number("seed", "of the random angles, a whole number").or(&[0.0]),
];

/// Returns spins on axes of so many, each of which may be periodic: those that are given as S, or unit vectors along a
/// direction, on the cone of a wave, and tilted at random.
pub(in crate::arrays) fn spin_start(axes: &[(usize, bool)], given: &Given<'_>) -> Started {
    let count: usize = axes.iter().map(|(count, _)| count).product();
    if given.has("S") {
        return as_array(axes, given);
    }
    if !["direction", "waves", "cone", "tilt"].iter().any(|name| given.has(name)) {
        let needed = "given, or direction, or waves with a cone, or tilt; nothing is";
        return Err(given.refused("S", needed.into()));
    }
    let direction = given.vector("direction");
    if direction == Vector3::zeros() {
        return Err(given.refused("direction", "different from 0".into()));
    }
    let axis = (direction / direction.amax()).normalize();
    require_wave(axes, given)?;
    let (waves, cone, tilt) = (given.values("waves"), given.number("cone"), given.number("tilt"));
    let mut random = Directions::new(given.seed()?);
    let spin = |i: usize| {
        // The last index is the fastest.
        let (mut rest, mut turns) = (i, 0.0);
        for ((count, _), wave) in axes.iter().zip(waves).rev() {
            turns += (rest % count) as f64 * wave / *count as f64;
            rest /= count;
        }
        let on_wave = on_cone(&axis, cone, TAU * turns.fract());
        if tilt == 0.0 { on_wave } else { random.within(tilt, &on_wave) }
    };
    Ok(numbers(&(0..count).map(spin).collect::<Vec<_>>()))
}

fn as_array(axes: &[(usize, bool)], given: &Given<'_>) -> Started {
    given.require_alone("S", &["direction", "waves", "cone", "tilt", "seed"])?;
    let shape: Vec<usize> = axes.iter().map(|(count, _)| *count).chain([3]).collect();
    let (count, spins) = (shape.iter().product::<usize>(), given.values("S"));
    if spins.len() != count {
        let found = spins.len();
        let needed = format!("{count} numbers, an array of shape {shape:?}, got {found}");
        return Err(given.refused("S", needed));
    }
    if let Some(i) = spins.as_chunks::<3>().0.iter().position(|s| *s == [0.0; 3]) {
        return Err(given.refused("S", format!("spins other than 0; number {} is 0", i + 1)));
    }
    Ok(spins.to_vec())
}

/// Checks the wave of a start.
fn require_wave(axes: &[(usize, bool)], given: &Given<'_>) -> Result<(), FormulaSystemError> {
    let waves = given.values("waves");
    if given.has("waves") && waves.len() != axes.len() {
        let needed = format!("a number for each of {} axes, got {}", axes.len(), waves.len());
        return Err(given.refused("waves", needed));
    }
    if let Some(wave) = waves.iter().find(|wave| wave.abs() > MOST_PERIODS) {
        return Err(given.refused("waves", format!("at most {MOST_PERIODS:e}, got {wave:e}")));
    }
    let mut periodic = waves.iter().zip(axes).filter(|(_, (_, periodic))| *periodic);
    if let Some((wave, _)) = periodic.find(|(wave, _)| wave.fract() != 0.0) {
        let needed = format!("whole numbers along periodic axes, got {wave}");
        return Err(given.refused("waves", needed));
    }
    if given.has("waves") && given.number("cone") == 0.0 {
        let needed = "larger than 0 beside waves; the spins of a wave are on a cone";
        return Err(given.refused("cone", needed.into()));
    }
    for name in ["cone", "tilt"] {
        let angle = given.number(name);
        if !(0.0..=PI).contains(&angle) {
            return Err(given.refused(name, format!("from 0 to pi, got {angle}")));
        }
    }
    Ok(())
}
