//! An ideal fluid on the sphere, by Zeitlin's model: many vortices merge into a few large ones.
//!
//! ```text
//! cargo run --release -p lie-poisson-systems --example sphere_fluid -- [SIZE [END [PICTURE]]]
//! ```
//!
//! The start has harmonics of degree 2 to 10 with coefficients without a pattern, no angular momentum and a root mean square
//! vorticity of 1. Prints the largest changes of energy and Casimirs up to the end (default: SIZE 48, END 60). With a
//! PICTURE, writes a PNG with the vorticity at the start (left) and at the end (right) in Mollweide's projection, blue
//! for negative and red for positive values, on one scale. The program fails if the spectrum is not conserved.

use collective_integrators::Integrator;
use lie_poisson::State;
use lie_poisson_systems::isospectral_flows::{GaussMagnus, LargeSkewHermitian};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fs::File;
use std::io::BufWriter;

const STEP: f64 = 0.2;

const DEGREES: std::ops::RangeInclusive<usize> = 2..=10;

/// The numbers of rows and columns of one map, in pixels.
const ROWS: usize = 240;
const COLUMNS: usize = 480;

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

/// Returns the values of a function on a map in Mollweide's projection, row by row, and `None` outside of the ellipse.
///
/// With x and y from −1 to 1, sin α = y, the latitude is asin((2α + sin 2α)/π) and the longitude πx/cos α.
fn mollweide(omega: &VorticityCoefficients) -> Vec<Option<f64>> {
    let mut map = Vec::with_capacity(ROWS * COLUMNS);
    for row in 0..ROWS {
        let angle = (1.0 - 2.0 * (row as f64 + 0.5) / ROWS as f64).asin();
        let latitude = ((2.0 * angle + (2.0 * angle).sin()) / PI).asin();
        let circle = omega.values_on_circle(FRAC_PI_2 - latitude, 2 * COLUMNS);
        for column in 0..COLUMNS {
            let x = (2.0 * (column as f64 + 0.5) / COLUMNS as f64 - 1.0) / angle.cos();
            let index = ((x + 1.0) * COLUMNS as f64) as usize;
            map.push((x.abs() < 1.0).then(|| circle[index % (2 * COLUMNS)]));
        }
    }
    map
}

/// Returns the colour of a number from −1 to 1: blue, white, red.
fn colour(value: f64) -> [u8; 3] {
    let (low, high) = ([33.0, 102.0, 172.0], [178.0, 24.0, 43.0]);
    let end: [f64; 3] = if value < 0.0 { low } else { high };
    let part = value.abs().min(1.0);
    end.map(|c| (247.0 + part * (c - 247.0)).round() as u8)
}

fn draw(path: &str, maps: &[Vec<Option<f64>>; 2]) -> Result<(), Box<dyn Error>> {
    let values = maps.iter().flatten().flatten();
    let most = values.fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut pixels = Vec::with_capacity(6 * ROWS * COLUMNS);
    for row in 0..ROWS {
        for map in maps {
            let line = &map[row * COLUMNS..(row + 1) * COLUMNS];
            pixels
                .extend(line.iter().flat_map(|value| value.map_or([255; 3], |v| colour(v / most))));
        }
    }
    let mut encoder =
        png::Encoder::new(BufWriter::new(File::create(path)?), 2 * COLUMNS as u32, ROWS as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let size: usize = arguments.first().map_or(Ok(48), |size| size.parse())?;
    let end: f64 = arguments.get(1).map_or(Ok(60.0), |end| end.parse())?;
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
    if let Some(path) = arguments.get(2) {
        draw(path, &[&start, &w].map(|w| mollweide(&fluid.coefficients(w))))?;
    }
    // Each step rounds the entries of W, of the size of 1, by ε; a Casimir of degree k sums k times N products of them.
    let allowed = f64::EPSILON * steps as f64 * (6 * size) as f64;
    if change < allowed { Ok(()) } else { Err("the spectrum is not conserved".into()) }
}
