//! The vortices at a start.

use super::sites_arrays::SitesArrays;
use super::sites_system::{SitesSystem, momenta, numbers};
use crate::arrays::any_arrays::Started;
use crate::arrays::arguments::Given;
use crate::arrays::directions::Directions;
use core::f64::consts::PI;
use nalgebra::Vector3;

/// The largest distance of a vortex from the unit sphere, that of positions with six digits.
const ON_SPHERE: f64 = 1e-5;

/// Returns the vortices at the positions that are given, or at random ones.
pub(in crate::arrays) fn vortex_start(vortices: &SitesArrays, given: &Given<'_>) -> Started {
    let SitesSystem::Vortices(system) = &vortices.system else { return Ok(Vec::new()) };
    let count = system.strengths().len();
    let times_strengths = |positions: &[Vector3<f64>]| {
        numbers(&positions.iter().zip(system.strengths()).map(|(x, k)| x * *k).collect::<Vec<_>>())
    };
    let name = if given.has("m") { "m" } else { "positions" };
    let values = given.values(name);
    if !given.has(name) {
        if !given.has("seed") {
            return Err(given.refused(name, "given, or m, or the seed of random ones".into()));
        }
        let random = Directions::new(given.seed()?);
        return Ok(times_strengths(&apart(count, random)));
    }
    given.require_alone(name, if name == "m" { &["positions", "seed"] } else { &["seed"] })?;
    if values.len() != 3 * count {
        let needed = format!("three numbers for each of {count} vortices, got {}", values.len());
        return Err(given.refused(name, needed));
    }
    let vectors: Vec<_> = values.as_chunks::<3>().0.iter().map(|x| Vector3::from(*x)).collect();
    let scale = |i: usize| if name == "m" { system.strengths()[i].abs() } else { 1.0 };
    for (i, x) in vectors.iter().enumerate() {
        let length = x.norm() / scale(i);
        if (length - 1.0).abs() > ON_SPHERE {
            let what = format!("the distance of number {} is {length}", i + 1);
            return Err(given.refused(name, format!("points of the unit sphere; {what}")));
        }
    }
    let m = if name == "m" { values.to_vec() } else { times_strengths(&vectors) };
    match vortices.system.energy(&momenta(&m)).is_finite() {
        true => Ok(m),
        false => Err(given.refused(name, "apart; two vortices are at one place".into())),
    }
}

/// Returns so many points of the sphere without a pattern, none nearer to another than √(2/N), so that no pair turns much
/// faster than the others.
fn apart(count: usize, mut random: Directions) -> Vec<Vector3<f64>> {
    let least = 2.0 / count as f64;
    let mut positions: Vec<Vector3<f64>> = Vec::with_capacity(count);
    while positions.len() < count {
        let next = random.within(PI, &Vector3::z());
        if positions.iter().all(|x| (x - next).norm_squared() >= least) {
            positions.push(next);
        }
    }
    positions
}
