//! The report on the motion of a top: [`TopReport`].

use super::axis_frame::{AxisFrame, frame_about};
use super::measured_motion::measure;
use super::report_line::ReportLine;
use super::steady_rotation::SteadyRotation;
use super::textbook::{of_free, of_heavy, of_lagrange};
use crate::error::RunFailure;
use crate::models::top_in_axes::TopInAxes;
use crate::runs::experiment::Experiment;
use heavytop::{HeavyTop, attitude_of_vertical};
use lie_poisson::{Hamiltonian, Se3Dual, euclidean_norm};
use nalgebra::Vector3;

/// What a physicist wants to know of the motion of a top: its rates and turning points, measured along a run, beside the
/// formulas of textbooks, and the steady rotations near it. Printed, it is a table.
///
/// # Example
/// The rates of a fast top, which are those of the textbook to a few per cent:
/// ```
/// use heavytop::HeavyTop;
/// use heavytop::methods::{Formulation, Method, SchemeName};
/// use lie_poisson::Se3Dual;
/// use lie_poisson_runs::{Experiment, Pace, Schedule, TopInAxes, TopReport};
/// use nalgebra::Vector3;
/// let top = TopInAxes::from(HeavyTop::lagrange(2.0, 1.0, 1.0)?);
/// let start = Se3Dual::new(Vector3::new(0.0, 0.0, 20.0), Vector3::new(0.6, 0.0, 0.8));
/// let run = Experiment {
///     start: TopInAxes::coordinates(&start).to_vec(),
///     method: Method::new(Formulation::Collective, SchemeName::Gauss(4), 0.0)?,
///     pace: Pace { schedule: Schedule::new(0.02, 20.0)?, every: 1 },
///     attitude: true,
///     model: top,
/// };
/// let report = TopReport::new(&run, None)?;
/// let precession = report.lines.iter().find(|line| line.name.starts_with("precession")).ok_or("no line")?;
/// let (_, textbook) = precession.formulas[0];
/// assert!((textbook - 1.0 / 20.0).abs() < 1e-15);
/// assert!(precession.measured.is_some_and(|rate| (rate / textbook - 1.0).abs() < 0.01));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TopReport {
    /// What kind of top it is, and about which line its angles are.
    pub kind: &'static str,
    /// The numbers.
    pub lines: Vec<ReportLine>,
    /// The steady rotations with the vertical momentum of the run, those of least energy first, in the axes of the users; of a
    /// body without weight those with its angular momentum, whose direction then stands for the vertical. None of Lagrange's
    /// top.
    pub steady: Vec<SteadyRotation>,
    /// Whether the body has no weight.
    pub is_free: bool,
    /// The energy h of the run, J.
    pub energy: f64,
}

impl TopReport {
    /// Follows a run, with the attitude, and reports on it. The height of the centre of mass is told if its distance from the
    /// support is given, m.
    ///
    /// # Errors
    /// If a step fails, or the formulation has no attitude.
    pub fn new(run: &Experiment<TopInAxes>, length: Option<f64>) -> Result<Self, RunFailure> {
        let run = Experiment { attitude: true, ..run.clone() };
        let (top, start) = (run.model.top, run.initial_state());
        let initial = attitude_of_vertical(&start.0.1);
        let frame = AxisFrame::new(top, &start, &initial);
        let is_free = top.weight_moment() == 0.0;
        // Of a body without weight these are the rotations about its axes, with the size of its momentum.
        let momentum = if is_free { euclidean_norm(&start.0.0) } else { start.0.0.dot(&start.0.1) };
        // A top with an axis of symmetry keeps its spin about it, which these rotations do not; it has formulas instead.
        let lagrange = if is_free { None } else { upright(&top, &start)? };
        let mut steady = match lagrange {
            Some(_) => Vec::new(),
            None => SteadyRotation::all(&top, momentum),
        };
        let motion = measure(&run, &frame, &mut steady)?;
        let (kind, mut lines) = if is_free {
            let kind = "a body without weight, by a principal axis and its angular momentum L";
            (kind, of_free(&top, &start, &motion, frame.axis().iamax()))
        } else if let Some((top, start)) = &lagrange {
            let kind = "Lagrange's top, by its axis and the vertical";
            (kind, of_lagrange(top, start, &motion))
        } else {
            let kind =
                "a heavy top, by the line from the support to the centre of mass and the vertical";
            (kind, of_heavy(&motion))
        };
        if let (Some(length), false) = (length, is_free) {
            let [least, largest] = motion.inclination.map(|inclination| length * inclination.cos());
            lines.push(ReportLine::new("least height", Some(largest), "m"));
            lines.push(ReportLine::new("largest height", Some(least), "m"));
        }
        for one in &mut steady {
            one.vertical = run.model.axes.from_principal(&one.vertical);
        }
        let energy = Hamiltonian::value(&top, &start);
        Ok(Self { kind, lines, steady, is_free, energy })
    }
}

/// Returns a top with an axis of symmetry, and its start, in axes of the body in which its centre of mass is on e₃; `None` for
/// other tops.
fn upright(top: &HeavyTop, start: &Se3Dual) -> Result<Option<(HeavyTop, Se3Dual)>, RunFailure> {
    let (inertia, frame) = (top.inertia(), frame_about(top.center_of_mass()));
    let is_sphere = inertia.x == inertia.y && inertia.y == inertia.z;
    if top.axial_component().is_none() && !is_sphere {
        return Ok(None);
    }
    let [across, _, along] = frame.map(|axis| inertia.component_mul(&axis).dot(&axis));
    let turned = |v: &Vector3<f64>| Vector3::from(frame.map(|axis| axis.dot(v)));
    let lagrange = HeavyTop::lagrange(across, along, top.weight_moment())?;
    Ok(Some((lagrange, Se3Dual::new(turned(&start.0.0), turned(&start.0.1)))))
}
