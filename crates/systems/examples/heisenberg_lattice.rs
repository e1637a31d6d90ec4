//! Integrates a vortex and an antivortex in a plane lattice of spins with an easy plane, by the spherical midpoint method.
//!
//! ```text
//! cargo run --release -p systems-examples --bin heisenberg_lattice -- \
//!     [SIZE [EXCHANGE [ANISOTROPY [FIELD [END]]]]] [PICTURE]
//! ```
//!
//! The lattice is periodic, with SIZE × SIZE spins (default 20), the EXCHANGE J (1) of nearest neighbours, the
//! ANISOTROPY K (−0.2, negative: the plane is easy) along z and a FIELD B (0) along z, up to the time END (30). The middles
//! of vortex and antivortex point up and down. Then the spins cover the sphere once: the pair cannot annihilate, and
//! turns about its middle.
//!
//! Prints the largest deviations of the energy h, of the lengths |s_i| and of the component S_z of the total spin, and how
//! often the spins cover the sphere, at the start and at the end: the charge of Berg & Lüscher (Nucl. Phys. B 190 (1981)), a
//! whole number, which changes only where a vortex slips through between the cells. The program fails if lengths or S_z
//! change by more than rounding errors or h by more than the method of order 2 allows, if the charge is not whole, or if it
//! changes for the defaults. With a PICTURE (a path ending in .png or .svg), draws the spins at the start and at the end,
//! s_z by colour and the other components by arrows.

mod pictures;

use collective_integrators::{Integrator, SphericalMidpoint, VectorField};
use lie_poisson::{Covector, Sites, SitesHamiltonian, larger};
use lie_poisson_systems::HeisenbergLattice;
use nalgebra::{Vector2, Vector3};
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::colours::diverging;
use pictures::curves::{Axes, axes};
use pictures::raster;
use plotters::prelude::*;
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;

/// The angle by which the fastest spin turns in a step: sweeps for the midpoint converge for angles below 1.
const ANGLE: f64 = 0.85;
/// Half of the distance of the vortices, as a part of the size of the lattice.
const APART: f64 = 0.18;
/// The radius of the middles of the vortices in cells.
const MIDDLE: f64 = 2.0;

type Spins = Covector<Sites<Vector3<f64>>>;

/// Returns the spin in a cell at the start.
///
/// The periodic functions f and g of the place vanish together at the two middles alone.
fn start(size: usize, [x, y]: [usize; 2]) -> Vector3<f64> {
    let unit = TAU / size as f64;
    let apart = TAU * APART;
    let [x, y] = [x, y].map(|i| (i as f64 + 0.5) * unit - PI);
    let (f, g) = (x.cos() + y.cos() - 1.0 - apart.cos(), y.sin());
    let from = |middle: f64| Vector2::new(x - middle, y).norm_squared() / (MIDDLE * unit).powi(2);
    let up = (-from(-apart)).exp() - (-from(apart)).exp();
    Vector3::new(f, g, up * apart.sin()).normalize()
}

/// Returns how often the spins cover the sphere: the sum over all triangles of neighbours of the area of the spherical
/// triangle between their spins, divided by 4π.
fn charge(size: usize, s: &Spins) -> f64 {
    let area = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [s.0[a], s.0[b], s.0[c]];
        2.0 * a.dot(&b.cross(&c)).atan2(1.0 + a.dot(&b) + b.dot(&c) + c.dot(&a))
    };
    let index = |x: usize, y: usize| x % size + size * (y % size);
    let cells = (0..size).flat_map(|x| (0..size).map(move |y| (x, y)));
    let areas = cells.map(|(x, y)| {
        let [a, b, c, d] = [index(x, y), index(x + 1, y), index(x + 1, y + 1), index(x, y + 1)];
        area(a, b, c) + area(a, c, d)
    });
    areas.sum::<f64>() / (4.0 * PI)
}

fn lattice(
    size: usize,
    [exchange, anisotropy, field]: [f64; 3],
) -> Result<HeisenbergLattice, Box<dyn Error>> {
    let lattice = HeisenbergLattice::new([size, size, 1])?
        .with_exchange([1, 0, 0], exchange)?
        .with_exchange([0, 1, 0], exchange)?
        .with_anisotropy(Vector3::z(), anisotropy)?;
    Ok(lattice.with_field(Vector3::z() * field)?)
}

/// The largest deviations of h, of |s_i| and of S_z, and the largest sum of the squares of the rates |ds_i/dt|.
type Deviations = [f64; 4];

fn run(
    lattice: &HeisenbergLattice,
    start: &Spins,
    (step, steps): (f64, usize),
) -> Result<(Deviations, Spins), Box<dyn Error>> {
    let midpoint = SphericalMidpoint::new(lattice.clone());
    let mut run = midpoint.trajectory_from(start.clone(), step);
    let up = |s: &Spins| s.0.iter().map(|spin| spin.z).sum::<f64>();
    let (energy, total) = (lattice.value(start), up(start));
    let [mut change, mut length, mut along, mut speed] = [0.0; 4];
    for _ in 0..steps {
        let rates = lattice.at(run.state());
        speed = larger(speed, rates.0.iter().map(|rate| rate.norm_squared()).sum());
        let s = run.advance(1)?;
        change = larger(change, (lattice.value(s) - energy).abs());
        let longest = s.0.iter().map(|spin| (spin.norm() - 1.0).abs()).fold(0.0, larger);
        length = larger(length, longest);
        along = larger(along, (up(s) - total).abs());
    }
    Ok(([change, length, along, speed], run.state().clone()))
}

/// Draws the spins at two times.
fn draw(
    path: &Path,
    size: usize,
    constants: [f64; 3],
    [end, step]: [f64; 2],
    states: [&Spins; 2],
) -> Result<(), Box<dyn Error>> {
    let [exchange, anisotropy, field] = constants;
    let method = format!(
        "J = {exchange}, K = {anisotropy}, B = {field}; spherical midpoint method, steps of {step:.3} (no units)"
    );
    let method = method.replace('-', "−");
    let heading = ["A vortex and an antivortex in a lattice of spins", &method];
    canvas::save(path, heading, [1290, 634], |area| {
        let (panels, bar) = area.split_horizontally(1190 * PIXEL);
        let titles = ["t = 0".to_owned(), format!("t = {end}")];
        for ((panel, s), title) in panels.split_evenly((1, 2)).iter().zip(states).zip(&titles) {
            let range = -0.5..size as f64 - 0.5;
            let frame = Axes {
                title,
                x: ("x (cells)", range.clone()),
                y: ("y (cells)", range),
                grid: false,
            };
            let mut chart = axes(panel, &frame, &[])?;
            let cells = (0..size).rev().flat_map(|y| (0..size).map(move |x| x + size * y));
            let colours = cells.map(|i| diverging(s.0[i].z));
            raster::cells(&mut chart, [size, size], colours)?;
            let each = (size / 24).max(1);
            for (x, y) in
                (0..size).step_by(each).flat_map(|x| (0..size).step_by(each).map(move |y| (x, y)))
            {
                let spin = s.0[x + size * y].xy() * (0.42 * each as f64);
                chart.draw_series([PathElement::new(
                    arrow([x as f64, y as f64], spin),
                    BLACK.stroke_width(PIXEL as u32 * 3 / 2),
                )])?;
            }
        }
        raster::scale(&bar, "s_z", 1.0, [60 * PIXEL, 480 * PIXEL])
    })
}

/// Returns the line of an arrow with its middle at a place.
fn arrow([x, y]: [f64; 2], along: Vector2<f64>) -> Vec<(f64, f64)> {
    let aside = Vector2::new(-along.y, along.x) * 0.35;
    let back = along * 0.3;
    let (tail, head) = (-along, along);
    let points = [tail, head, back + aside, head, back - aside];
    points.map(|point| (x + point.x, y + point.y)).to_vec()
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(5)?;
    let size: usize = arguments.number(0, "SIZE", 20)?;
    let exchange: f64 = arguments.number(1, "EXCHANGE", 1.0)?;
    let anisotropy: f64 = arguments.number(2, "ANISOTROPY", -0.2)?;
    let field: f64 = arguments.number(3, "FIELD", 0.0)?;
    let end: f64 = arguments.number(4, "END", 30.0)?;
    let constants = [exchange, anisotropy, field];
    let lattice = lattice(size, constants)?;
    let first = lattice.state(|[x, y, _]| start(size, [x, y]));
    let rate = 8.0 * exchange.abs() + 2.0 * anisotropy.abs() + field.abs();
    let steps = ((end * rate / ANGLE).ceil() as usize).max(1);
    let step = end / steps as f64;
    let ([change, length, along, speed], last) = run(&lattice, &first, (step, steps))?;
    if let Some(path) = &arguments.picture {
        draw(path, size, constants, [end, step], [&first, &last])?;
    }
    let charges = [charge(size, &first), charge(size, &last)];
    let rounding = 4.0 * f64::EPSILON * steps as f64;
    let count = lattice.count() as f64;
    // The midpoint rule conserves h − (step²/24) D²h(X, X) up to order 4, and D²h is below the rate of the fastest spin.
    let energy = step * step / 12.0 * rate * speed + rounding * count * rate;
    println!(
        "{size} × {size} spins, {steps} steps of {step:.3}, largest deviations and their bounds"
    );
    println!("{:>10} {change:>10.2e} {energy:>10.2e}", "h");
    println!("{:>10} {length:>10.2e} {rounding:>10.2e}", "|s_i|");
    println!("{:>10} {along:>10.2e} {:>10.2e}", "S_z", rounding * count);
    println!("charge {:.12} at the start, {:.12} at the end", charges[0], charges[1]);
    let whole = charges.iter().all(|charge| (charge - charge.round()).abs() < f64::EPSILON * count);
    let conserved = change <= energy && length <= rounding && along <= rounding * count;
    let slipped = arguments.text(0).is_none() && charges[0].round() != charges[1].round();
    if conserved && whole && !slipped {
        Ok(())
    } else {
        Err("an invariant is not conserved".into())
    }
}
