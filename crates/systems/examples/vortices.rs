//! Integrates four point vortices on the unit sphere, on (so(3)∗)⁴, collectively through one Hopf map each.
//!
//! ```text
//! cargo run --release -p systems-examples --bin vortices -- [PICTURE]
//! ```
//!
//! Prints the largest deviations up to t = 50 s of the energy h, of the distances |x_i| from the centre and of the
//! moment of vorticity Σ k_i x_i. The Gauss method of order 6 conserves distances and moment to round-off, and h to
//! its order. With the explicit midpoint rule the vortices leave the sphere. The program fails if this does not hold.
//! With a PICTURE (a path ending in .png or .svg), draws the paths up to t = 20 s on a map in Mollweide's projection.

mod pictures;

use collective_integrators::{Collective, RungeKutta, Start};
use lie_poisson::{Hamiltonian, larger};
use lie_poisson_systems::PointVortices;
use momentum_map::{HOPF, PowerMap};
use nalgebra::Vector3;
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::colours::CURVES;
use pictures::curves::draw_key;
use pictures::mollweide::Map;
use plotters::style::Color;
use std::error::Error;
use std::path::Path;

const STEP: f64 = 0.1;
const STEPS: usize = 500;
/// The steps of the picture.
const DRAWN: usize = 200;
const STRENGTHS: [f64; 4] = [1.0, -0.7, 1.5, 0.4];

/// The positions of the vortices at the time of each step.
type Paths = Vec<[Vector3<f64>; 4]>;

/// Returns the largest deviations of h, of the distances and of the moment of vorticity, and the paths.
fn run(scheme: RungeKutta) -> Result<([f64; 3], Paths), Box<dyn Error>> {
    let vortices = PointVortices::new(STRENGTHS)?;
    let positions = [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x: Vector3<f64>| x.normalize());
    let start = vortices.momentum(&positions);
    let (energy, moment) = (vortices.value(&start), start.0.0.iter().sum::<Vector3<f64>>());
    let integrator = Collective::new(scheme, PowerMap::<_, 4>(HOPF), vortices);
    let (mut largest, mut paths) = ([0.0; 3], Paths::new());
    for sample in integrator.trajectory(&start, STEP)?.take(STEPS + 1) {
        let m = sample?.momentum;
        let positions = vortices.positions(&m);
        paths.push(positions);
        let distances = positions.map(|x| (x.norm() - 1.0).abs());
        let now = [
            (vortices.value(&m) - energy).abs(),
            distances.into_iter().fold(0.0, larger),
            (m.0.0.iter().sum::<Vector3<f64>>() - moment).norm(),
        ];
        largest = std::array::from_fn(|i| larger(largest[i], now[i]));
    }
    Ok((largest, paths))
}

fn draw(path: &Path, paths: &[[Vector3<f64>; 4]]) -> Result<(), Box<dyn Error>> {
    let heading = [
        "Four point vortices on the sphere, t = 0 to 20 s",
        "Gauss method of order 6 through Hopf maps, steps of 0.1 s; ring: start, disk: end",
    ];
    canvas::save(path, heading, [1000, 580], |area| {
        let names = STRENGTHS.map(|k| format!("k = {k} m²/s").replace('-', "−"));
        let key: Vec<_> = names.iter().map(String::as_str).zip(CURVES).collect();
        draw_key(area, &key, (130 * PIXEL, 16 * PIXEL))?;
        let map = Map::new(area);
        map.draw(area, "")?;
        for (i, colour) in CURVES.iter().take(STRENGTHS.len()).enumerate() {
            map.path(area, paths.iter().map(|x| x[i]), colour.stroke_width(2 * PIXEL as u32))?;
            map.dot(area, &paths[0][i], 4, *colour, false)?;
            map.dot(area, &paths[paths.len() - 1][i], 6, *colour, true)?;
        }
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    println!("largest deviations up to t = 50 s, steps of {STEP} s");
    println!("{:>18} {:>12} {:>10} {:>16}", "scheme", "h (m⁴/s²)", "|x_i| (m)", "Σ k_i x_i (m³/s)");
    let (gauss, paths) = run(RungeKutta::gauss(3)?)?;
    let (explicit, _) = run(RungeKutta::explicit_midpoint())?;
    if let Some(path) = &arguments.picture {
        draw(path, &paths[..=DRAWN])?;
    }
    for (name, [energy, distance, moment]) in [("Gauss 6", gauss), ("explicit midpoint", explicit)]
    {
        println!("{name:>18} {energy:>12.2e} {distance:>10.2e} {moment:>16.2e}");
    }
    // The bounds are round-off over the run, and the order of the method.
    let conserved = gauss[0] < STEP.powi(6) && gauss[1] < 1e-12 && gauss[2] < 1e-12;
    let control = explicit[1] > 1e-9;
    if conserved && control { Ok(()) } else { Err(format!("{gauss:?}, {explicit:?}").into()) }
}
