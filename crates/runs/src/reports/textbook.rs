//! The lines of a report, with the formulas of textbooks.
//!
//! Sources: L. D. Landau & E. M. Lifshitz, *Mechanics*, 3rd ed., §33, §35, §37; H. Goldstein, *Classical Mechanics*, 2nd ed.
//! (1980), §5-6, §5-7.

use super::measured_motion::MeasuredMotion;
use super::report_line::ReportLine;
use core::f64::consts::TAU;
use heavytop::{EulerSolution, HeavyTop, LagrangeNutation, RigidBody};
use lie_poisson::{Se3Dual, euclidean_norm};

/// The part of the momentum along the middle axis from which a body without weight flips.
const FLIPPING: f64 = 0.9;

/// Returns the lines about Lagrange's top, whose centre of mass is on e₃, on the side of its head.
pub(super) fn of_lagrange(
    top: &HeavyTop,
    start: &Se3Dual,
    motion: &MeasuredMotion,
) -> Vec<ReportLine> {
    let (inertia, weight) = (top.inertia(), top.weight_moment());
    let (across, along) = (inertia.x, inertia.z);
    let axial = start.0.0.z;
    let exact = LagrangeNutation::new(top, start).ok();
    let heights = exact.map_or((f64::NAN, f64::NAN), |exact| exact.turning_points());
    let cosine = (motion.inclination[0].cos() + motion.inclination[1].cos()) / 2.0;
    // The slow root of I₁ r² cos θ − I₃ω₃ r + m g l = 0, without cancellation.
    let discriminant = axial * axial - 4.0 * across * weight * cosine;
    let steady = 2.0 * weight / (axial + discriminant.sqrt().copysign(axial));
    let [least, largest] = motion.inclination;
    vec![
        ReportLine::new("spin about the axis, ω₃", Some(axial / along), "rad/s").with(
            "2√(I₁ m g l)/I₃, above which it sleeps upright",
            2.0 * (across * weight).sqrt() / along,
        ),
        ReportLine::new("precession, mean dφ/dt", motion.precession, "rad/s")
            .with("m g l/(I₃ω₃), of a fast top", weight / axial)
            .with("without nutation, at the mean cos θ", steady),
        ReportLine::new("nutation, 2π/period", motion.period.map(|period| TAU / period), "rad/s")
            .with(
                "I₃ω₃/I₁, of a fast top",
                if axial == 0.0 { f64::NAN } else { axial.abs() / across },
            )
            .with(
                "closed form, by an elliptic integral",
                exact.map_or(f64::NAN, |exact| TAU / exact.period()),
            ),
        ReportLine::new("spin, mean dψ/dt", motion.spin, "rad/s").with(
            "ω₃ − dφ/dt cos θ, at the mean cos θ",
            motion.precession.map_or(f64::NAN, |rate| axial / along - rate * cosine),
        ),
        ReportLine::new("least inclination θ", Some(least.to_degrees()), "deg")
            .with("closed form", heights.1.acos().to_degrees()),
        ReportLine::new("largest inclination θ", Some(largest.to_degrees()), "deg")
            .with("closed form", heights.0.acos().to_degrees()),
    ]
}

/// Returns the lines about any other heavy top, by the line from the support to the centre of mass.
pub(super) fn of_heavy(motion: &MeasuredMotion) -> Vec<ReportLine> {
    let [least, largest] = motion.inclination.map(f64::to_degrees);
    vec![
        ReportLine::new("precession, mean dφ/dt", motion.precession, "rad/s"),
        ReportLine::new(
            "nutation, mean 2π/period",
            motion.period.map(|period| TAU / period),
            "rad/s",
        ),
        ReportLine::new("spin, mean dψ/dt", motion.spin, "rad/s"),
        ReportLine::new("least inclination θ", Some(least), "deg"),
        ReportLine::new("largest inclination θ", Some(largest), "deg"),
    ]
}

/// Returns the lines about a body without weight that goes round a principal axis.
pub(super) fn of_free(
    top: &HeavyTop,
    start: &Se3Dual,
    motion: &MeasuredMotion,
    axis: usize,
) -> Vec<ReportLine> {
    let (inertia, pi) = (top.inertia(), start.0.0);
    let size = euclidean_norm(&pi);
    let [x, y] = [(axis + 1) % 3, (axis + 2) % 3];
    let [least, largest] = motion.inclination.map(f64::to_degrees);
    let mut lines = vec![
        ReportLine::new("angular momentum L", Some(size), "kg m²/s"),
        ReportLine::new("precession about L, mean dφ/dt", motion.precession, "rad/s"),
        ReportLine::new("spin, mean dψ/dt", motion.spin, "rad/s"),
        ReportLine::new("least inclination from L", Some(least), "deg"),
        ReportLine::new("largest inclination from L", Some(largest), "deg"),
    ];
    if inertia[x] == inertia[y] {
        let spin = pi[axis].abs() * (inertia[x] - inertia[axis]) / (inertia[axis] * inertia[x]);
        lines[1] = lines[1].clone().with("L/I₁", size / inertia[x]);
        lines[2] = lines[2].clone().with("ω₃ (I₁ − I₃)/I₁", spin);
        return lines;
    }
    let exact = RigidBody::new(inertia).and_then(|body| EulerSolution::new(&body, pi));
    let period = exact.ok().and_then(|exact| exact.period()).unwrap_or(f64::NAN);
    lines.push(
        ReportLine::new(
            "period of the motion of L in the body",
            motion.period.map(|nod| 2.0 * nod),
            "s",
        )
        .with("4K(m)/λ, by an elliptic integral", period),
    );
    if motion.inclination[1].sin() > FLIPPING {
        lines.push(
            ReportLine::new("time from flip to flip", motion.period, "s")
                .with("2K(m)/λ", period / 2.0),
        );
    }
    lines
}
