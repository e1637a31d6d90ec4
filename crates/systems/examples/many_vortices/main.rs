//! Integrates point vortices on the unit sphere, as many as a file contains, by the spherical midpoint method.
//!
//! ```text
//! cargo run --release -p systems-examples --bin many_vortices -- [FILE.csv [END]] [PICTURE]
//! ```
//!
//! The FILE has the header `strength,x,y,z` or `strength,latitude,longitude`, and one vortex a line: the strength in m²/s,
//! and a point of the sphere of radius 1 m, or latitude and longitude in degrees. Without a FILE, two rows of 32 vortices
//! of opposite signs start on the parallels of 25° with a small wave; each row rolls up into four large vortices.
//!
//! Prints the largest deviations up to the END (4 s without it) of the energy h, of the distances |x_i| from the centre and
//! of the moment of vorticity Σ k_i x_i. The program fails if they are too large for rounding errors, or h changes more than
//! the method of order 2 allows. With a PICTURE (a path ending in .png or .svg), draws the start (left) and the end with the
//! paths of the last tenth of the time (right) in Mollweide's projection, red disks for positive and blue rings for
//! negative strengths.

mod vortex_table;
#[path = "../pictures/mod.rs"]
mod pictures;

use collective_integrators::{Integrator, SphericalMidpoint};
use lie_poisson::{Covector, Sites, SitesHamiltonian, larger};
use lie_poisson_systems::ManyVortices;
use nalgebra::Vector3;
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::colours::{BLUE, RED};
use pictures::curves::draw_key;
use pictures::mollweide::Map;
use plotters::style::{Color, RGBColor};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use vortex_table::VortexTable;

const STEP: f64 = 0.02;
/// The number of vortices in each row of the start.
const ROW: usize = 32;
const WAVES: f64 = 4.0;

/// Returns two rows of vortices of opposite signs, with a small wave.
fn rows() -> VortexTable {
    let mut table = VortexTable { strengths: Vec::new(), positions: Vec::new() };
    for side in [1.0, -1.0] {
        for i in 0..ROW {
            let longitude = TAU * (i as f64 + 0.25 * side) / ROW as f64 - PI;
            let latitude = side * 25.0 + 1.5 * (WAVES * longitude + side).sin();
            let (sin, cos) = latitude.to_radians().sin_cos();
            table.strengths.push(side * TAU / ROW as f64);
            table.positions.push(Vector3::new(cos * longitude.cos(), cos * longitude.sin(), sin));
        }
    }
    table
}

/// What is conserved, and how fast the nearest two vortices turn about each other.
struct Deviations {
    energy: f64,
    distance: f64,
    moment: f64,
    /// The largest angular velocity of two vortices about each other, (|k_i| + |k_j|)/(2π |x_i − x_j|²), 1/s.
    rate: f64,
}

/// Returns the largest angular velocity of two vortices about each other.
fn largest_rate(strengths: &[f64], x: &[Vector3<f64>]) -> f64 {
    let mut most = 0.0;
    for i in 0..x.len() {
        for j in 0..i {
            let both = strengths[i].abs() + strengths[j].abs();
            most = larger(most, both / (TAU * (x[i] - x[j]).norm_squared()));
        }
    }
    most
}

/// The positions at the time of each step.
type Paths = Vec<Vec<Vector3<f64>>>;

fn run(table: &VortexTable, steps: usize) -> Result<(Deviations, Paths), Box<dyn Error>> {
    let vortices = ManyVortices::new(table.strengths.clone())?;
    let m = vortices.momentum(table.positions.iter().copied())?;
    let midpoint = SphericalMidpoint::new(vortices.clone());
    let moment = |m: &Covector<Sites<Vector3<f64>>>| m.0.iter().sum::<Vector3<f64>>();
    let (energy, start) = (vortices.value(&m), moment(&m));
    let mut most = Deviations { energy: 0.0, distance: 0.0, moment: 0.0, rate: 0.0 };
    let mut paths = vec![table.positions.clone()];
    let mut run = midpoint.trajectory_from(m, STEP);
    for _ in 0..steps {
        let m = run.advance(1)?;
        let x: Vec<_> = vortices.positions(m).collect();
        most.energy = larger(most.energy, (vortices.value(m) - energy).abs());
        most.moment = larger(most.moment, (moment(m) - start).norm());
        most.rate = larger(most.rate, largest_rate(&table.strengths, &x));
        for x in &x {
            most.distance = larger(most.distance, (x.norm() - 1.0).abs());
        }
        paths.push(x);
    }
    Ok((most, paths))
}

fn draw(path: &Path, table: &VortexTable, paths: &Paths) -> Result<(), Box<dyn Error>> {
    let end = (paths.len() - 1) as f64 * STEP;
    let first = format!("{} point vortices on the sphere", table.strengths.len());
    let heading = [&first, "spherical midpoint method, steps of 0.02 s"];
    let style = |k: f64| -> (RGBColor, bool) { if k > 0.0 { (RED, true) } else { (BLUE, false) } };
    canvas::save(path, heading, [1280, 410], |area| {
        let key = [("positive (disk)", RED), ("negative (ring)", BLUE)];
        draw_key(area, &key, (465 * PIXEL, 6 * PIXEL))?;
        let (_, maps) = area.split_vertically(16 * PIXEL);
        let tail = paths.len() - paths.len() / 10;
        let titles = ["t = 0 s".to_owned(), format!("t = {end} s, and paths of the last tenth")];
        let shown = [&paths[..1], &paths[tail..]];
        for ((panel, paths), title) in maps.split_evenly((1, 2)).iter().zip(shown).zip(&titles) {
            let map = Map::new(panel);
            map.draw(panel, title)?;
            for (i, &k) in table.strengths.iter().enumerate() {
                let (colour, full) = style(k);
                let line = colour.stroke_width(PIXEL as u32);
                map.path(panel, paths.iter().map(|x| x[i]), line)?;
                if let Some(x) = paths.last() {
                    map.dot(panel, &x[i], 3, colour, full)?;
                }
            }
        }
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(2)?;
    let table =
        arguments.text(0).map_or_else(|| Ok(rows()), |file| VortexTable::read(file.as_ref()))?;
    let end: f64 = arguments.number(1, "END", 4.0)?;
    let steps = (end / STEP).ceil() as usize;
    let (most, paths) = run(&table, steps)?;
    if let Some(path) = &arguments.picture {
        draw(path, &table, &paths)?;
    }
    let count = table.strengths.len();
    println!("{count} vortices, {steps} steps of {STEP} s, largest deviations and their bounds");
    // Each step rounds each vector by a few ε of its length.
    let distance = 4.0 * f64::EPSILON * steps as f64;
    let total: f64 = table.strengths.iter().map(|k| k.abs()).sum();
    // A method of order 2 changes the energy of a pair that turns at the rate ω by (hω)² of k²/4π.
    let squares: f64 = table.strengths.iter().map(|k| k * k).sum();
    let energy = (STEP * most.rate).powi(2) * squares / (4.0 * PI) + distance * squares;
    let rows = [
        ("h (m⁴/s²)", most.energy, energy),
        ("|x_i| (m)", most.distance, distance),
        ("Σ k_i x_i (m³/s)", most.moment, distance * total),
    ];
    for (name, deviation, bound) in rows {
        println!("{name:>18} {deviation:>10.2e} {bound:>10.2e}");
    }
    let lost: Vec<_> = rows
        .iter()
        .filter(|(_, deviation, bound)| deviation.is_nan() || deviation > bound)
        .collect();
    if lost.is_empty() { Ok(()) } else { Err(format!("not conserved: {lost:?}").into()) }
}
