//! An ideal fluid on the sphere.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::Given;
use crate::arrays::fluids::sphere_fluid::SphereFluid;
use crate::arrays::open::array_terms::FluidTerms;
use lie_poisson_formula_systems::Parameter;
use lie_poisson_systems::Zeitlin;

pub(in crate::arrays) const NAME: &str = FluidTerms::KIND;

pub(in crate::arrays) const PARAMETERS: &[Parameter] = &[
    Parameter::number("size", "N: harmonics of degree below N are kept, 2 to 2048"),
    Parameter::number("rotation", "angular velocity of the sphere about the third axis").or(&[0.0]),
];

pub(in crate::arrays) const START: &[Parameter] = &[
    Parameter::list(
        "coefficients",
        "rows [l, m, re, im] of the absolute vorticity, m from 0 to l; added to a random one",
    )
    .or(&[]),
    Parameter::list("omega", "all coefficients as in the output, instead").or(&[]),
    Parameter::list(
        "vorticity",
        "values on a grid, instead: r rows from the north, at pi (i + 1/2)/r, of 2r longitudes",
    )
    .or(&[]),
    Parameter::list("degrees", "the least and the largest degree of a random vorticity, instead")
        .or(&[]),
    Parameter::number("rms", "root mean square of a random vorticity").or(&[1.0]),
    Parameter::number("seed", "of a random vorticity, a whole number").or(&[0.0]),
];

/// Makes Zeitlin's model dW/dt = [P, W]/ħ of the vorticity ω on N×N matrices W.
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let size = given.whole("size", [2, 2048])?;
    let fluid = Zeitlin::new(size).and_then(|fluid| fluid.with_rotation(given.number("rotation")));
    Ok(Box::new(SphereFluid(fluid.map_err(|error| given.refused("size", error.to_string()))?)))
}
