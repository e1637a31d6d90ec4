//! The law suites of [`Representation`] and [`GroupRepresentation`].

use super::{NoSamples, Report, regimes};
use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use crate::representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
use generic_scalars::{Covector, DualNumber, Vector, derivative_part, map_coordinates};

/// Evaluates the laws of a representation on samples of 𝔤 and V.
///
/// The laws are `commutator` [ξ, η] v = ξηv − ηξv, `transpose` ⟨ξᵀα, v⟩ = ⟨α, ξv⟩ and `diamond` ⟨v ◇ α, η⟩ = ⟨α, ηv⟩.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn representation<R: Representation>(
    representation: &R,
    elements: &[RepresentedElement<R>],
    vectors: &[R::Space<f64>],
) -> Result<Report, NoSamples> {
    let (elements, vectors) =
        (regimes("algebra elements", elements)?, regimes("vectors", vectors)?);
    let mut report = Report::default();
    let act = |xi: &RepresentedElement<R>, v: &R::Space<f64>| representation.act::<f64>(xi, v);
    for xi in &elements {
        for v in &vectors {
            for eta in &elements {
                let bracket = representation.algebra().bracket::<f64>(xi, eta);
                let commutator = act(&bracket, v) - act(xi, &act(eta, v)) + act(eta, &act(xi, v));
                let scale = xi.max_abs() * eta.max_abs() * v.max_abs();
                report.note("commutator", commutator.max_abs(), scale);
            }
            for alpha in &vectors {
                let alpha: Covector<R::Space<f64>> = map_coordinates(alpha, |x| x);
                let expected = alpha.pairing(&act(xi, v));
                let transpose = representation.transpose_act::<f64>(xi, &alpha).pairing(v);
                let diamond = representation.diamond::<f64>(v, &alpha).pairing(xi);
                let scale = xi.max_abs() * v.max_abs() * alpha.max_abs();
                report.note("transpose", (transpose - expected).abs(), scale);
                report.note("diamond", (diamond - expected).abs(), scale);
            }
        }
    }
    Ok(report)
}

/// Evaluates the laws of a group representation on samples of 𝔤 and V.
///
/// The laws are `homomorphism` (gh) v = g (hv), `derivative` d/ds exp(sξ) v = ξv, and `exp integral` ξ ∫₀¹
/// exp(σξ) v dσ = exp(ξ) v − v.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn group_representation<R: GroupRepresentation>(
    representation: &R,
    elements: &[RepresentedElement<R>],
    vectors: &[R::Space<f64>],
) -> Result<Report, NoSamples> {
    let (elements, vectors) =
        (regimes("algebra elements", elements)?, regimes("vectors", vectors)?);
    let (group, mut report) = (representation.group(), Report::default());
    let turn = |g: &<R::Group as LieGroup>::Element<f64>, v: &R::Space<f64>| {
        representation.transform::<f64>(g, v)
    };
    for xi in &elements {
        let g = group.exp::<f64>(xi);
        for v in &vectors {
            let size = g.max_abs() * g.max_abs() * v.max_abs();
            for eta in &elements {
                let h = group.exp::<f64>(eta);
                let difference = turn(&group.compose::<f64>(&g, &h), v) - turn(&g, &turn(&h, v));
                report.note("homomorphism", difference.max_abs(), size * h.max_abs().max(1.0));
            }
            let along: RepresentedElement<R, DualNumber> =
                map_coordinates(xi, |x| DualNumber::new(0.0, x));
            let slope: R::Space<f64> = derivative_part(&representation.transform::<DualNumber>(
                &group.exp::<DualNumber>(&along),
                &map_coordinates(v, DualNumber::constant),
            ));
            let velocity = slope - representation.act::<f64>(xi, v);
            report.note("derivative", velocity.max_abs(), xi.max_abs() * v.max_abs());
            let integral = representation.exp_integral::<f64>(xi, v);
            let difference = representation.act::<f64>(xi, &integral) - (turn(&g, v) - *v);
            report.note("exp integral", difference.max_abs(), size * xi.max_abs().max(1.0));
        }
    }
    Ok(report)
}
