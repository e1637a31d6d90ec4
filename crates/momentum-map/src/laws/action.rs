//! The law suites of [`GroupAction`], of cotangent lifts and of their momentum maps.

use super::{NoSamples, Report, regimes};
use crate::actions::action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
use crate::actions::cotangent_lift::CotangentLift;
use crate::maps::momentum_map::MomentumMap;
use crate::maps::poisson_map::PoissonMap;
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{
    DualNumber, LieAlgebra, LieGroup, Vector, derivative_part, map_coordinates, seed,
};

/// A pair of ξ and exp ξ.
type Moved<A> = (Generator<A>, ActingElement<A>);

/// Returns the group elements of a suite, made by exp.
fn group_elements<A: GroupAction>(
    action: &A,
    samples: &[Generator<A>],
) -> Result<Vec<Moved<A>>, NoSamples> {
    let elements = regimes("algebra elements", samples)?;
    Ok(elements.into_iter().map(|xi| (xi, action.group().exp::<f64>(&xi))).collect())
}

/// Evaluates the laws of an action on samples of points and of the algebra, with group elements made by
/// exp:
///
/// * `identity` Φ_e = id, and `composition` Φ_g ∘ Φ_h = Φ_gh (left) or Φ_hg (right);
/// * `generator`: ξ_Q(q) is the derivative of Φ(exp(sξ), q) at s = 0;
/// * `generators and brackets`: [ξ_Q, η_Q] = ∓[ξ, η]_Q, minus for left actions.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn group_action<A: GroupAction>(
    action: &A,
    elements: &[Generator<A>],
    points: &[ActionPoint<A>],
) -> Result<Report, NoSamples> {
    let (elements, points) = (group_elements(action, elements)?, regimes("points", points)?);
    let (group, mut report) = (action.group(), Report::default());
    for q in &points {
        let still = action.act::<f64>(&group.identity::<f64>(), q) - *q;
        report.note("identity", still.max_abs(), q.max_abs().max(1.0));
        for (xi, g) in &elements {
            let generated = action.infinitesimal_generator::<f64>(xi, q);
            let scale = (1.0 + q.max_abs()) * xi.max_abs().max(1e-300);
            report.note("generator", (slope(action, xi, q) - generated).max_abs(), scale);
            for (eta, h) in &elements {
                let twice = action.act::<f64>(g, &action.act::<f64>(h, q));
                let product = match A::SIDE {
                    Side::Left => group.compose::<f64>(g, h),
                    Side::Right => group.compose::<f64>(h, g),
                };
                let once = action.act::<f64>(&product, q);
                let size = (1.0 + g.max_abs()) * (1.0 + h.max_abs()) * (1.0 + q.max_abs());
                report.note("composition", (twice - once).max_abs(), size);
                let bracket = group.algebra().bracket::<f64>(xi, eta);
                let expected = action.infinitesimal_generator::<f64>(&bracket, q);
                let commutator = commutator(action, xi, eta, q);
                let difference = match A::SIDE {
                    Side::Left => commutator + expected,
                    Side::Right => commutator - expected,
                };
                let scale = scale * eta.max_abs().max(1e-300);
                report.note("generators and brackets", difference.max_abs(), scale);
            }
        }
    }
    Ok(report)
}

/// Returns the derivative of Φ(exp(sξ), q) with respect to s at s = 0.
fn slope<A: GroupAction>(action: &A, xi: &Generator<A>, q: &ActionPoint<A>) -> ActionPoint<A> {
    let along: Generator<A, DualNumber> = map_coordinates(xi, |x| DualNumber::new(0.0, x));
    let g = action.group().exp::<DualNumber>(&along);
    derivative_part(&action.act::<DualNumber>(&g, &map_coordinates(q, DualNumber::constant)))
}

/// Returns the Lie bracket [X, Y] = DY·X − DX·Y of the vector fields X = ξ_Q and Y = η_Q.
fn commutator<A: GroupAction>(
    action: &A,
    xi: &Generator<A>,
    eta: &Generator<A>,
    q: &ActionPoint<A>,
) -> ActionPoint<A> {
    let derivative = |xi: &Generator<A>, along: &ActionPoint<A>| -> ActionPoint<A> {
        let constant: Generator<A, DualNumber> = map_coordinates(xi, DualNumber::constant);
        let field = action.infinitesimal_generator::<DualNumber>(&constant, &seed(q, along));
        derivative_part(&field)
    };
    let field = |xi: &Generator<A>| action.infinitesimal_generator::<f64>(xi, q);
    derivative(eta, &field(xi)) - derivative(xi, &field(eta))
}

/// Evaluates the laws of the cotangent lift of an action and of its momentum:
///
/// * `canonical form`: the lift conserves Θ = p dq;
/// * `lifted generator`: it is the derivative of the lift of exp(sξ) at s = 0;
/// * `momentum`: ⟨J(q, p), ξ⟩ = ⟨p, d/ds Φ(exp(sξ), q)⟩ at s = 0.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn cotangent_lift<A: GroupAction>(
    action: &A,
    elements: &[Generator<A>],
    points: &[Cotangent<ActionPoint<A>>],
) -> Result<Report, NoSamples> {
    let lifted = CotangentLift(action.clone());
    let mut report = Report::default();
    for (xi, g) in group_elements(action, elements)? {
        let constant: ActingElement<A, DualNumber> = map_coordinates(&g, DualNumber::constant);
        for z in regimes("points", points)? {
            let generated = action.lifted_generator::<f64>(&xi, &z);
            let scale = (1.0 + z.max_abs()) * xi.max_abs().max(1e-300);
            let difference = slope(&lifted, &xi, &z) - generated;
            report.note("lifted generator", difference.max_abs(), scale);
            let expected = slope(action, &xi, &z.q).pairing(&z.p);
            let difference = action.momentum::<f64>(&z).pairing(&xi) - expected;
            report.note("momentum", difference.abs(), (1.0 + z.max_abs()) * scale);
            let image = lifted.act::<f64>(&g, &z);
            for i in 0..<ActionPoint<A>>::DIM {
                let v = <ActionPoint<A>>::basis(i);
                let pushed: ActionPoint<A> =
                    derivative_part(&action.act::<DualNumber>(&constant, &seed(&z.q, &v)));
                let difference = image.p.pairing(&pushed) - z.p.pairing(&v);
                let scale = image.p.max_abs().max(1.0) * pushed.max_abs().max(1.0);
                report.note("canonical form", difference.abs(), scale);
            }
        }
    }
    Ok(report)
}

/// Evaluates the law `equivariance` of the momentum map of a cotangent-lifted action.
///
/// It is J(g·z) = (`Ad∗_g`)⁻¹ J(z) for left actions and J(g·z) = `Ad∗_g` J(z) for right ones.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn equivariance<A: GroupAction>(
    action: &A,
    elements: &[Generator<A>],
    points: &[Cotangent<ActionPoint<A>>],
) -> Result<Report, NoSamples> {
    let (lifted, map) = (CotangentLift(action.clone()), MomentumMap(action.clone()));
    let (group, mut report) = (action.group(), Report::default());
    for (_, g) in group_elements(action, elements)? {
        let by = match A::SIDE {
            Side::Left => group.inverse::<f64>(&g),
            Side::Right => g,
        };
        for z in regimes("points", points)? {
            let j = map.apply::<f64>(&z);
            let moved = map.apply::<f64>(&lifted.act::<f64>(&g, &z));
            let difference = moved - group.coadjoint::<f64>(&by, &j);
            let scale = (1.0 + g.max_abs() * g.max_abs()) * (1.0 + z.max_abs() * z.max_abs());
            report.note("equivariance", difference.max_abs(), scale);
        }
    }
    Ok(report)
}
