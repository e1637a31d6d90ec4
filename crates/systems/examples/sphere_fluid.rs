//! An ideal fluid on the sphere, by Zeitlin's model: many vortices merge into a few large ones.
//!
//! ```text
//! cargo run --release -p systems-examples --bin sphere_fluid -- [SIZE [END]] [PICTURE]
//! ```
//!
//! The start has harmonics of degree 2 to 10 with coefficients without a pattern, no angular momentum and a root mean square
//! vorticity of 1. Prints the largest changes of energy and Casimirs up to the end (default: SIZE 48, END 60). With a
//! PICTURE (a path ending in .png or .svg), draws the vorticity at the start (left) and at the end (right) in Mollweide's
//! projection, blue for negative and red for positive values, on one scale that ends at 3/s. The program fails if the
//! spectrum is not conserved.

mod pictures;

use collective_integrators::Integrator;
use lie_poisson::State;
use lie_poisson_systems::isospectral_flows::{GaussMagnus, LargeSkewHermitian};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::colours::diverging;
use pictures::mollweide::{self, Map};
use pictures::raster;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;
use svg_pictures::SvgElement;

const STEP: f64 = 0.2;

const DEGREES: std::ops::RangeInclusive<usize> = 2..=10;

/// The numbers of rows and columns of one map, in pixels.
const ROWS: usize = 240;
const COLUMNS: usize = 480;

/// The end of the scale of colours, in multiples of the root mean square of the vorticity.
const MOST: f64 = 3.0;

fn start(fluid: &Zeitlin, size: usize) -> LargeSkewHermitian {
    let omega = VorticityCoefficients::from_fn(size, |l, m| {
        let x = (11 * l + m) as f64;
        let value = Complex::new((3.1 * x * x).sin(), (5.3 * x * x).cos());
        if DEGREES.contains(&l) { value } else { Complex::ZERO }
    });
    let mut w = fluid.vorticity(&omega);
    let mean = (fluid.enstrophy(&w) / (4.0 * PI)).sqrt();
    w.scale_in_place(1.0 / mean);
    w
}

/// Returns the values of the vorticity on a map in Mollweide's projection, row by row, and `None` outside of it.
fn values(omega: &VorticityCoefficients) -> Vec<Option<f64>> {
    let mut map = Vec::with_capacity(ROWS * COLUMNS);
    for row in 0..ROWS {
        let (latitude, width) = mollweide::parallel(1.0 - 2.0 * (row as f64 + 0.5) / ROWS as f64);
        let circle = omega.values_on_circle(FRAC_PI_2 - latitude, 2 * COLUMNS);
        for column in 0..COLUMNS {
            let x = (2.0 * (column as f64 + 0.5) / COLUMNS as f64 - 1.0) / width;
            // The circle begins at the longitude 0, and the map at −180°.
            let index = ((x + 2.0) * COLUMNS as f64) as usize;
            map.push((x.abs() < 1.0).then(|| circle[index % (2 * COLUMNS)]));
        }
    }
    map
}

/// Draws the vorticity at the start and at the end on one scale.
fn draw(
    path: &Path,
    [size, end]: [&str; 2],
    maps: &[Vec<Option<f64>>; 2],
) -> Result<(), Box<dyn Error>> {
    let method = format!(
        "Zeitlin's model, N = {size}; Gauss–Magnus method of order 4, steps of {STEP} s; root mean square 1/s"
    );
    let heading = ["The vorticity of an ideal fluid on the sphere", &method];
    canvas::save(path, heading, [1280, 400], |area| {
        let (panels, bar) = area.split_horizontally(1170 * PIXEL);
        let titles = ["t = 0 s".to_owned(), format!("t = {end} s")];
        for ((panel, map), title) in panels.split_evenly((1, 2)).iter().zip(maps).zip(&titles) {
            let frame = Map::new(panel);
            let [left, top, right, bottom] = frame.corners();
            let colours = map.iter().map(|value| value.map_or([255; 3], |v| diverging(v / MOST)));
            let size = [COLUMNS, ROWS].map(|count| count as u32);
            let corners = [(left, top), (right, bottom)];
            panel.draw(&SvgElement::cells(corners, size, colours)?)?;
            frame.draw(panel, title)?;
        }
        raster::scale(&bar, "ω (1/s)", MOST, [50 * PIXEL, 290 * PIXEL])?;
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(2)?;
    let size: usize = arguments.number(0, "SIZE", 48)?;
    let end: f64 = arguments.number(1, "END", 60.0)?;
    let fluid = Zeitlin::new(size)?;
    let start = start(&fluid, size);
    let method = GaussMagnus::new(2, &fluid)?.with_tolerance(1e-6);
    let (mut w, mut workspace) = (start.clone(), method.workspace());
    let steps = (end / STEP).ceil() as u64;
    for _ in 0..steps {
        method.step_in_place(&mut w, STEP, &mut workspace)?;
    }
    let energy = fluid.energy(&start);
    let (before, after) = (fluid.casimirs(&start, 6), fluid.casimirs(&w, 6));
    // of the size of ∫|ω|ᵏ, since the root mean square of ω is 1
    let scale = fluid.enstrophy(&start);
    let change = before
        .iter()
        .zip(&after)
        .map(|(a, b)| (a - b).abs() / scale)
        .fold(0.0, lie_poisson::larger);
    println!("N = {size}, t = {end}, step {STEP}");
    println!("relative change of the energy:   {:9.1e}", fluid.energy(&w) / energy - 1.0);
    println!("largest change of a Casimir:     {change:9.1e}");
    if let Some(path) = &arguments.picture {
        let maps = [&start, &w].map(|w| values(&fluid.coefficients(w)));
        draw(path, [&size.to_string(), &end.to_string()], &maps)?;
    }
    // Each step rounds the entries of W, of the size of 1, by ε; a Casimir of degree k sums k times N products of them.
    let allowed = f64::EPSILON * steps as f64 * (6 * size) as f64;
    if change < allowed { Ok(()) } else { Err("the spectrum is not conserved".into()) }
}
