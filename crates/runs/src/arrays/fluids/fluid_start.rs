//! The vorticity of a fluid at a start.

use super::sphere_fluid::SphereFluid;
use crate::arrays::any_arrays::Started;
use crate::arrays::arguments::{Given, whole};
use crate::arrays::directions::Directions;
use core::f64::consts::PI;
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_systems::VorticityCoefficients;
use lie_poisson_systems::num_complex::Complex;
use nalgebra::Vector3;

/// Returns the coefficients that are given as an array, or random ones with those that are given one by one.
pub(super) fn fluid_start(fluid: &SphereFluid, given: &Given<'_>) -> Started {
    if given.has("omega") {
        return as_array(fluid, given);
    }
    if given.has("vorticity") {
        return on_grid(fluid, given);
    }
    if !given.has("degrees") && !given.has("coefficients") {
        let needed = "given, or vorticity, degrees of a random one, or omega; nothing is";
        return Err(given.refused("coefficients", needed.into()));
    }
    let mut omega = match given.has("degrees") {
        true => random(fluid, given)?,
        false => VorticityCoefficients::zeros(fluid.size()),
    };
    let refused = |needed| given.refused("coefficients", needed);
    let (rows, rest) = given.values("coefficients").as_chunks();
    if !rest.is_empty() {
        let found = 4 * rows.len() + rest.len();
        return Err(refused(format!("rows of four numbers, [l, m, re, im], got {found} numbers")));
    }
    add(&mut omega, rows).map_err(refused)?;
    let mut state = vec![0.0; fluid.size() * fluid.size()];
    fluid.write(&omega, &mut state);
    Ok(state)
}

fn as_array(fluid: &SphereFluid, given: &Given<'_>) -> Started {
    given.require_alone("omega", &["coefficients", "degrees", "rms", "seed"])?;
    let (n, values) = (fluid.size(), given.values("omega"));
    if values.len() != n * n {
        let count = values.len();
        let needed = format!("{} numbers, an array of shape [{n}, {n}], got {count}", n * n);
        return Err(given.refused("omega", needed));
    }
    Ok(values.to_vec())
}

/// Returns the coefficients of values on a grid.
fn on_grid(fluid: &SphereFluid, given: &Given<'_>) -> Started {
    given.require_alone("vorticity", &["omega", "coefficients", "degrees", "rms", "seed"])?;
    let (n, values) = (fluid.size(), given.values("vorticity"));
    let (rows, least) = ((values.len() / 2).isqrt(), 2 * n - 1);
    if 2 * rows * rows != values.len() || rows < least {
        let found = values.len();
        let grid = format!("a grid of r rows and 2r columns with r at least {least}");
        return Err(given.refused("vorticity", format!("{grid}, got {found} numbers")));
    }
    let mut omega = VorticityCoefficients::of_grid(n, values);
    let mean = omega.at(0, 0).norm();
    let largest = values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    if mean > MEAN * largest {
        let needed = "without a mean: that of a closed sphere is 0; subtract it";
        return Err(given.refused("vorticity", needed.into()));
    }
    omega.set(0, 0, Complex::ZERO);
    let mut state = vec![0.0; n * n];
    fluid.write(&omega, &mut state);
    Ok(state)
}

/// The mean of a vorticity that is zero by the rounding of numbers with five digits, relative to its largest value.
const MEAN: f64 = 1e-5;

/// Returns a random vorticity of some degrees and of a mean square.
fn random(
    fluid: &SphereFluid,
    given: &Given<'_>,
) -> Result<VorticityCoefficients, FormulaSystemError> {
    let n = fluid.size();
    let [least, most] = match given.values("degrees") {
        [least, most] => [*least, *most].map(|l| whole(l, [1, n - 1])),
        _ => [None; 2],
    };
    let (Some(least), Some(most), true) = (least, most, least <= most) else {
        let (last, found) = (n - 1, given.values("degrees"));
        let needed = format!("two whole numbers from 1 to {last}, the least first, got {found:?}");
        return Err(given.refused("degrees", needed));
    };
    let rms = given.number("rms");
    if rms <= 0.0 {
        return Err(given.refused("rms", format!("positive, got {rms}")));
    }
    let mut directions = Directions::new(given.seed()?);
    let mut omega = VorticityCoefficients::zeros(n);
    for (l, m) in (least..=most).flat_map(|l| (0..=l).map(move |m| (l, m))) {
        let direction = directions.within(PI, &Vector3::z());
        omega.set(l, m, Complex::new(direction.x, direction.y));
    }
    let mean = (fluid.0.enstrophy(&fluid.0.vorticity(&omega)) / (4.0 * PI)).sqrt();
    let factor = rms / mean;
    Ok(VorticityCoefficients::from_fn(n, |l, m| omega.at(l, m) * factor))
}

/// Adds the coefficients that are given one by one, as rows l, m, re, im.
///
/// # Errors
/// If they are no such rows: what they must be, and what they are.
pub(in crate::arrays) fn add(
    omega: &mut VorticityCoefficients,
    rows: &[[f64; 4]],
) -> Result<(), String> {
    let last = omega.size() - 1;
    for [l, m, re, im] in rows {
        let degree = whole(*l, [1, last]);
        let order = degree.and_then(|l| whole(*m, [0, l]));
        let (Some(l), Some(m)) = (degree, order) else {
            // The mean vorticity of a sphere is zero: there is no degree 0.
            let range = format!("degrees l from 1 to {last} and orders m from 0 to l");
            return Err(format!("{range}, got l = {l}, m = {m}"));
        };
        if m == 0 && *im != 0.0 {
            return Err(format!("real for m = 0, got im = {im} for l = {l}"));
        }
        omega.set(l, m, omega.at(l, m) + Complex::new(*re, *im));
    }
    Ok(())
}
