//! Integrates a torpedo without fins in an ideal fluid (Kirchhoff's equations). It does not keep moving along its
//! long axis, but turns broadside on, since the fluid that it drags is heavier there.
//!
//! ```text
//! cargo run --release -p systems-examples --bin vehicle -- [PICTURE]
//! ```
//!
//! Prints, every 4 s up to t = 40 s, the angle of the impulse P with the long axis, which grows from 1° beyond 150°
//! and returns. Prints also the deviations of h, |P|² and Π·P, which the collective Gauss method of order 6, in its
//! form without a lift, keeps below 1e-12. The program fails if a deviation is larger, or the angle stays below 90°. With a
//! PICTURE (a path ending in .png or .svg), draws the path of the body, seen from the side, from end-on to broadside on, and
//! the angle over the whole run: without friction the body does not stay there, but swings on.

mod pictures;

use collective_integrators::{LiftFree, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, Pair, Se3Dual, larger};
use lie_poisson_systems::Kirchhoff;
use momentum_map::DualQuaternions;
use nalgebra::{Matrix3, Rotation3, Vector3};
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::colours::{BLUE, GREY, RED};
use pictures::curves::{Axes, Curve, around, axes, curves};
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

const STEP: f64 = 0.05;
const STEPS: usize = 800;
/// The bound of round-off over the run; the error of the method in h is smaller at this step.
const BOUND: f64 = 1e-12;
/// The bound of the error of the attitude (rad), for angular velocities of about 1 rad/s.
const ATTITUDE: f64 = STEP * STEP;

/// A place of the body in space, and its attitude: v in the body frame is `attitude` v in space.
#[derive(Clone, Copy)]
struct Pose {
    place: Vector3<f64>,
    attitude: Rotation3<f64>,
}

/// Returns the poses from the momenta, with dR/dt = R hat(Ω) and dx/dt = Rv at the midpoint of each step.
///
/// # Errors
/// Returns a message if the impulse RP changes its direction in space, which it does not in the exact motion.
fn poses(vehicle: &Kirchhoff, momenta: &[Se3Dual]) -> Result<Vec<Pose>, Box<dyn Error>> {
    let mut pose = Pose { place: Vector3::zeros(), attitude: Rotation3::identity() };
    let mut poses = vec![pose];
    for pair in momenta.windows(2) {
        let [Pair(turning, velocity), Pair(next_turning, next_velocity)] =
            [0, 1].map(|i| vehicle.differential(&pair[i]));
        let half = Rotation3::new((turning + next_turning) * (0.25 * STEP));
        pose.place += pose.attitude * half * (velocity + next_velocity) * (0.5 * STEP);
        pose.attitude = pose.attitude * half * half;
        poses.push(pose);
        let turned = (pose.attitude * pair[1].0.1).angle(&momenta[0].0.1);
        if turned > ATTITUDE {
            return Err(format!("the impulse turns by {turned:e} in space").into());
        }
    }
    Ok(poses)
}

/// Draws the path of the centre, and the long axis of the body each second, in the plane of the first axis and the impulse,
/// until the axis is at right angles to the impulse; and the angle between them over the whole run.
fn draw(path: &Path, poses: &[Pose], impulse: &Vector3<f64>) -> Result<(), Box<dyn Error>> {
    let forward = impulse.normalize();
    let aside = (Vector3::x() - forward * forward.x).normalize();
    let seen = |x: Vector3<f64>| (x.dot(&forward), x.dot(&aside));
    let ends = |pose: &Pose| {
        let axis = pose.attitude * Vector3::z();
        [pose.place - axis * 0.5, pose.place + axis * 0.5].map(seen)
    };
    let angle = |pose: &Pose| (pose.attitude * Vector3::z()).angle(impulse).to_degrees();
    let broadside = poses.iter().position(|pose| angle(pose) >= 90.0).unwrap_or(poses.len() - 1);
    let turning = &poses[..=broadside];
    let time = broadside as f64 * STEP;
    let when = format!("t = 0 to {time:.1} s: the long axis of the body each second, and its head");
    let heading = [
        "A torpedo in an ideal fluid turns broadside on",
        "Gauss method of order 6 without a lift, steps of 0.05 s",
    ];
    canvas::save(path, heading, [1300, 760], |area| {
        let (above, below) = area.split_vertically(410 * PIXEL);
        let along = around(turning.iter().flat_map(ends).map(|p| p.0));
        // A metre has the same length on both axes: the frame is 1180 pixels wide and 310 high.
        let height = (along.end - along.start) * 310.0 / 1180.0;
        let frame = Axes {
            title: &when,
            x: ("distance along the impulse P (m)", along),
            y: ("sideways (m)", -0.75 * height..0.25 * height),
            grid: true,
        };
        let mut chart = axes(&above, &frame, &[])?;
        let line = turning.iter().map(|pose| seen(pose.place));
        chart.draw_series(LineSeries::new(line, GREY.stroke_width(2 * PIXEL as u32)))?;
        // Backward from the last pose, which is broadside on.
        for pose in turning.iter().rev().step_by(20) {
            let [tail, head] = ends(pose);
            chart
                .draw_series(LineSeries::new([tail, head], BLUE.stroke_width(5 * PIXEL as u32)))?;
            chart.draw_series([Circle::new(head, 7 * PIXEL, RED.filled())])?;
        }
        let curve = |name: &str, colour, points| Curve { name: name.into(), colour, points };
        let points = poses.iter().enumerate().map(|(n, pose)| (n as f64 * STEP, angle(pose)));
        let end = (poses.len() - 1) as f64 * STEP;
        let right = curve("broadside on, 90°", RED, vec![(0.0, 90.0), (end, 90.0)]);
        curves(
            &below,
            "",
            ["t (s)", "angle with P (°)"],
            &[curve("angle of the long axis with the impulse P", BLUE, points.collect()), right],
        )?;
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    // Body and fluid have moments of 2, 2, 1 kg m² and masses of 3, 3, 1.5 kg; the long axis is the third.
    let moments = Matrix3::from_diagonal(&Vector3::new(0.5, 0.5, 1.0));
    let masses = Matrix3::from_diagonal(&Vector3::new(1.0 / 3.0, 1.0 / 3.0, 1.0 / 1.5));
    let vehicle = Kirchhoff::new(moments, Matrix3::zeros(), masses)?;
    let tilt = 1.0_f64.to_radians();
    let start =
        Se3Dual::new(Vector3::new(0.0, 0.0, 0.05), Vector3::new(tilt.sin(), 0.0, tilt.cos()));
    let conserved = |mu: &Se3Dual| {
        let Covector(Pair(pi, p)) = mu;
        [vehicle.value(mu), p.norm_squared(), pi.dot(p)]
    };
    let gauss = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, vehicle);

    println!(
        "{:>6} {:>10} {:>11} {:>16} {:>18}",
        "t (s)", "angle (°)", "Δh (J)", "Δ|P|² (kg²m²/s²)", "ΔΠ·P (kg²m³/s²)"
    );
    let (initial, mut largest, mut widest) = (conserved(&start), [0.0; 3], 0.0);
    let mut momenta = Vec::new();
    for sample in gauss.trajectory(&start, STEP)?.take(STEPS + 1) {
        let sample = sample?;
        momenta.push(sample.momentum);
        let Covector(Pair(_, p)) = sample.momentum;
        let angle = p.angle(&Vector3::z()).to_degrees();
        let values = conserved(&sample.momentum);
        let [h, square, level] = std::array::from_fn(|i| values[i] - initial[i]);
        if sample.step.is_multiple_of(80) {
            println!(
                "{:>6.1} {angle:>10.3} {h:>11.2e} {square:>16.2e} {level:>18.2e}",
                sample.time
            );
        }
        widest = larger(widest, angle);
        for (worst, deviation) in largest.iter_mut().zip([h, square, level]) {
            *worst = larger(*worst, deviation.abs());
        }
    }
    let poses = poses(&vehicle, &momenta)?;
    if let Some(path) = &arguments.picture {
        draw(path, &poses, &start.0.1)?;
    }
    if largest.iter().all(|worst| *worst < BOUND) && widest > 90.0 {
        Ok(())
    } else {
        Err(format!("deviations {largest:?}, bound {BOUND:e}, widest angle {widest}°").into())
    }
}
