//! Point vortices on the sphere, more than a formula can have.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::Given;
use crate::arrays::directions::Directions;
use crate::arrays::sites::{SitesSystem, momenta, numbers};
use crate::arrays::sites_arrays::{SitesArrays, Started};
use crate::arrays::systems::spin_lattice::seed;
use core::f64::consts::PI;
use lie_poisson_formula_systems::Parameter;
use lie_poisson_systems::ManyVortices;
use nalgebra::Vector3;

pub(in crate::arrays) const NAME: &str = "vortices";

pub(in crate::arrays) const PARAMETERS: &[Parameter] =
    &[Parameter::list("strengths", "circulation of each vortex, m²/s")];

pub(in crate::arrays) const START: &[Parameter] = &[
    Parameter::list("positions", "[x, y, z] of each vortex on the unit sphere").or(&[]),
    Parameter::list("m", "positions times strengths, instead of positions").or(&[]),
    Parameter::number("seed", "of random positions, none near another, instead of positions")
        .or(&[0.0]),
];

/// The largest distance of a vortex from the unit sphere, that of positions with six digits.
const ON_SPHERE: f64 = 1e-5;

/// Makes N vortices of strengths k_i at the points x_i of the unit sphere, m_i = k_i x_i, with
///
/// ```text
/// h = (1/4π) Σ_(i<j) k_i k_j ln(2 − 2 x_i·x_j)
/// ```
///
/// as [`ManyVortices`].
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let strengths = given.values("strengths").to_vec();
    if strengths.is_empty() {
        return Err(given.refused("strengths", "at least one number, got none".into()));
    }
    let vortices = ManyVortices::new(strengths.clone());
    let vortices = vortices.map_err(|error| given.refused("strengths", error.to_string()))?;
    Ok(Box::new(SitesArrays {
        system: SitesSystem::Vortices(vortices),
        name: "m",
        hamiltonian: "sum(strengths[i]*strengths[j]*ln(2 - 2*m[i]·m[j]/(strengths[i]*strengths[j])), i < j)/(4*pi)",
        shape: vec![strengths.len()],
        weights: Some(strengths.iter().map(|strength| strength.recip()).collect()),
        symmetry: None,
        start,
    }))
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

fn start(vortices: &SitesArrays, given: &Given<'_>) -> Started {
    let SitesSystem::Vortices(system) = &vortices.system else { return Ok(Vec::new()) };
    let count = vortices.shape.iter().product::<usize>();
    let times_strengths = |positions: &[Vector3<f64>]| {
        numbers(&positions.iter().zip(system.strengths()).map(|(x, k)| x * *k).collect::<Vec<_>>())
    };
    let name = if given.has("m") { "m" } else { "positions" };
    let values = given.values(name);
    if !given.has(name) {
        let random = Directions::new(seed(given)?);
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
            let needed =
                format!("points of the unit sphere; the distance of number {} is {length}", i + 1);
            return Err(given.refused(name, needed));
        }
    }
    let m = if name == "m" { values.to_vec() } else { times_strengths(&vectors) };
    match vortices.system.energy(&momenta(&m)).is_finite() {
        true => Ok(m),
        false => Err(given.refused(name, "apart; two vortices are at one place".into())),
    }
}
