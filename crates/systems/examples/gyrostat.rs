//! Integrates a free gyrostat: a body with a spinning rotor inside, without weight.
//!
//! ```text
//! cargo run --release -p systems-examples --bin gyrostat -- [PICTURE]
//! ```
//!
//! A body turns unstably about its middle axis. A rotor along this axis makes the rotation stable ("dual spin"; P. S.
//! Krishnaprasad, Nonlinear Analysis 9 (1985)): the energy has a minimum there on the sphere of momenta |Π| = 1 kg m²/s if
//! ℓ is large enough. Prints, without and with the rotor, how far the momentum leaves the middle axis from 1° beside it up to
//! t = 100 s, and the largest deviations of the energy and of |Π|. The program fails if they are not conserved, or if
//! the rotor does not keep the momentum within 3° of the axis. With a PICTURE (a path ending in .png or .svg), draws
//! trajectories on the sphere of momenta, solid on the side of the reader and pale on the other side.

mod pictures;

use collective_integrators::{LiftFree, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, Pair, Se3Dual, larger};
use lie_poisson_systems::Gyrostat;
use momentum_map::DualQuaternions;
use nalgebra::{Rotation3, Vector3};
use pictures::arguments::Arguments;
use pictures::canvas::{self, Area, PIXEL, TEXT, text};
use pictures::colours::{BLUE, DARK, GREY, RED};
use pictures::curves::draw_key;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;
use std::path::Path;

const STEP: f64 = 0.1;
const STEPS: usize = 1000;
/// The bound of round-off over the run.
const ROUND_OFF: f64 = 1e-12;
const MOMENTS: Vector3<f64> = Vector3::new(1.0, 2.0, 2.5);

/// The momenta on a trajectory, and the largest deviations of the energy and of |Π|.
type Run = (Vec<Vector3<f64>>, [f64; 2]);

/// Returns the momenta on a trajectory, and the largest deviations of the energy and of |Π|.
fn run(gyrostat: &Gyrostat, pi: Vector3<f64>, steps: usize) -> Result<Run, Box<dyn Error>> {
    let start = Se3Dual::new(pi, Vector3::z());
    let gauss = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, *gyrostat);
    let (energy, mut largest, mut momenta) = (gyrostat.value(&start), [0.0; 2], Vec::new());
    for sample in gauss.trajectory(&start, STEP)?.take(steps + 1) {
        let mu = sample?.momentum;
        let Covector(Pair(now, _)) = mu;
        let changes = [gyrostat.value(&mu) - energy, now.norm() - pi.norm()];
        largest = std::array::from_fn(|i| larger(largest[i], changes[i].abs()));
        momenta.push(now);
    }
    Ok((momenta, largest))
}

/// Draws a sphere seen from the direction (1, 1, 0.7), with trajectories through points at equal angles from all axes.
fn sphere(area: &Area, title: &str, gyrostat: &Gyrostat) -> Result<(), Box<dyn Error>> {
    let turn = Rotation3::face_towards(&Vector3::new(1.0, 1.0, 0.7), &Vector3::z()).inverse();
    let (width, height) = area.dim_in_pixel();
    let (middle, radius) =
        ((width as i32 / 2, height as i32 / 2 + 14 * PIXEL), 215.0 * f64::from(PIXEL));
    // x to the right, y up, z towards the reader
    let place = |x: &Vector3<f64>| {
        let seen = turn * x;
        ((middle.0 + (radius * seen.x) as i32, middle.1 - (radius * seen.y) as i32), seen.z > 0.0)
    };
    let style = text(TEXT, &BLACK, (HPos::Center, VPos::Center));
    area.draw(&Text::new(title, (middle.0, 14 * PIXEL), style))?;
    area.draw(&Circle::new(middle, radius as i32, GREY.stroke_width(PIXEL as u32)))?;
    let axes: [Vector3<f64>; 3] = [Vector3::x(), Vector3::y(), Vector3::z()];
    for axis in axes.iter().flat_map(|axis| [*axis, -axis]) {
        let colour = if axis.y.abs() > 0.5 { RED } else { BLUE };
        for degrees in [10.0_f64, 23.0, 36.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            // Two points for each angle, since curves on both sides of a separatrix differ.
            for i in [1, 2] {
                let aside = Vector3::from_fn(|j, _| axis[(j + i) % 3]);
                let (momenta, _) = run(gyrostat, axis * cos + aside * sin, 600)?;
                curve(area, &momenta, place, colour)?;
            }
        }
    }
    for (axis, name) in axes.iter().zip(["Π₁", "Π₂", "Π₃"]) {
        let ((x, y), _) = place(axis);
        area.draw(&Circle::new((x, y), 4 * PIXEL, DARK.filled()))?;
        let ground = [(x + 5 * PIXEL, y - 20 * PIXEL), (x + 28 * PIXEL, y - 2 * PIXEL)];
        area.draw(&Rectangle::new(ground, WHITE.filled()))?;
        let style = text(TEXT, &DARK, (HPos::Left, VPos::Center));
        area.draw(&Text::new(name, (x + 6 * PIXEL, y - 11 * PIXEL), style))?;
    }
    Ok(())
}

/// Draws the pieces of a curve on the near side solid, and the others pale.
fn curve(
    area: &Area,
    points: &[Vector3<f64>],
    place: impl Fn(&Vector3<f64>) -> ((i32, i32), bool),
    colour: RGBColor,
) -> Result<(), Box<dyn Error>> {
    let places: Vec<_> = points.iter().map(place).collect();
    for near in [false, true] {
        let style = if near { colour.mix(1.0) } else { colour.mix(0.12) };
        for piece in places.split(|place| place.1 != near).filter(|piece| piece.len() > 1) {
            let line: Vec<_> = piece.iter().map(|place| place.0).collect();
            area.draw(&PathElement::new(line, style.stroke_width(PIXEL as u32 * 3 / 2)))?;
        }
    }
    Ok(())
}

fn draw(path: &Path, gyrostats: [&Gyrostat; 2]) -> Result<(), Box<dyn Error>> {
    let heading = [
        "The sphere |Π| = 1 kg m²/s of a free gyrostat, I = 1, 2, 2.5 kg m²",
        "Gauss method of order 6 without a lift, steps of 0.1 s, 60 s of each trajectory",
    ];
    canvas::save(path, heading, [1100, 640], |area| {
        let key = [("starts near the middle axis Π₂", RED), ("starts near the other axes", BLUE)];
        draw_key(area, &key, (240 * PIXEL, 10 * PIXEL))?;
        let (_, below) = area.split_vertically(26 * PIXEL);
        let titles =
            ["without rotor: Π₂ is unstable", "rotor ℓ = (0, 0.5, 0) kg m²/s: Π₂ is stable"];
        for ((panel, gyrostat), title) in
            below.split_evenly((1, 2)).iter().zip(gyrostats).zip(titles)
        {
            sphere(panel, title, gyrostat)?;
        }
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    let gyrostat = |rotor: f64| Gyrostat::new(MOMENTS, 0.0, Vector3::zeros(), Vector3::y() * rotor);
    let [alone, with_rotor] = [gyrostat(0.0)?, gyrostat(0.5)?];
    if let Some(path) = &arguments.picture {
        draw(path, [&alone, &with_rotor])?;
    }
    let tilt = 1.0_f64.to_radians();
    let start = Vector3::new(tilt.sin(), tilt.cos(), 0.0);
    println!(
        "{:>10} {:>22} {:>10} {:>14}",
        "ℓ (kg m²/s)", "farthest from Π₂ (°)", "Δh (J)", "Δ|Π| (kg m²/s)"
    );
    let mut farthest = [0.0; 2];
    for (far, (gyrostat, rotor)) in farthest.iter_mut().zip([(alone, 0.0), (with_rotor, 0.5)]) {
        let (momenta, [energy, length]) = run(&gyrostat, start, STEPS)?;
        let angles = momenta.iter().map(|pi| pi.angle(&Vector3::y()).to_degrees());
        *far = angles.fold(0.0, larger);
        println!("{rotor:>10} {far:>22.2} {energy:>10.2e} {length:>14.2e}");
        // An error of order 6 in the step, for numbers of the size of 1.
        if !(energy <= STEP.powi(6) && length <= ROUND_OFF) {
            return Err("the energy or |Π| is not conserved".into());
        }
    }
    if farthest[0] > 90.0 && farthest[1] < 3.0 {
        Ok(())
    } else {
        Err(format!("{farthest:?}").into())
    }
}
