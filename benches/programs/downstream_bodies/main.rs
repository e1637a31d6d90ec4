//! Measures bodies of a downstream crate, whose maps are written by hand: Gauss-4 by [`Collective`] against RK4 by hand,
//! both with steps of 1/100.
//!
//! ```text
//! cargo run --release -p measurements --bin downstream_bodies -- times
//! cargo run --release -p measurements --bin downstream_bodies -- (so4 | two-fields | su3) (gauss-4 | by-hand) STEPS
//! ```
//!
//! The first command prints a line of JSON for each body and method, as the contestants of `benches/peers` do: the best
//! time of several runs, which alternate between the two methods, and the distance between the ends of the two runs. It
//! fails if these do not agree. The second makes the steps, for `benches/instructions` to count their instructions.

use collective_integrators::{Collective, Integrator, RungeKutta};
use lie_poisson::{Hamiltonian, Vector};
use momentum_map::{PoissonMap, SourcePoint};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

mod so4;
mod su3;
mod two_fields;

/// The step of both methods.
const STEP: f64 = 0.01;

/// The number of steps of a run that is timed.
const STEPS: u64 = 100_000;

/// The number of steps after which the two methods must still agree, and to which distance. The error of either is
/// about 1e-8 by then.
const AGREEMENT: (u64, f64) = (1000, 1e-6);

/// A body on 𝔤∗ as a downstream crate has it.
trait Body {
    /// The realisation, by hand.
    type Map: PoissonMap;

    /// The energy, with its differential by hand.
    type Energy: Hamiltonian<<Self::Map as PoissonMap>::Target>;

    /// Returns the integrator, and the point z at which it starts.
    fn gauss4(&self) -> Result<Start<Self>, Box<dyn Error>>;

    /// Makes steps of RK4 on the coordinates of μ, by hand.
    ///
    /// It returns `None` if they have another number.
    fn rk4(&self, mu: &mut [f64], steps: u64) -> Option<()>;
}

/// The collective integrator of a body.
type Gauss<B> = Collective<RungeKutta, <B as Body>::Map, <B as Body>::Energy>;

/// The integrator of a body, and the point z at which it starts.
type Start<B> = (Gauss<B>, SourcePoint<<B as Body>::Map>);

/// Returns the coordinates of a vector.
fn coordinates<V: Vector<Scalar = f64>>(v: &V) -> Vec<f64> {
    (0..V::DIM).map(|i| v.coordinate(i)).collect()
}

/// The coordinates of μ at the end of a run, and the number of sweeps of all steps.
type End = (Vec<f64>, usize);

/// Makes a run by the library.
fn by_library<B: Body>(body: &B, steps: u64) -> Result<End, Box<dyn Error>> {
    let (gauss, mut z) = body.gauss4()?;
    let (mut workspace, mut sweeps) = (gauss.workspace(), 0);
    for _ in 0..steps {
        let next = gauss.step(&z, STEP, &mut workspace)?;
        (z, sweeps) = (next.point, sweeps + next.iterations);
    }
    Ok((coordinates(&gauss.momentum(&z)), sweeps))
}

/// Makes a run by hand.
fn by_hand<B: Body>(body: &B, steps: u64) -> Result<End, Box<dyn Error>> {
    let (gauss, z) = body.gauss4()?;
    let mut mu = coordinates(&gauss.momentum(&z));
    body.rk4(&mut mu, steps).ok_or("another number of coordinates")?;
    Ok((mu, 0))
}

/// Makes steps of RK4, as one writes it for arrays.
#[inline(always)]
fn rk4<const N: usize>(
    mu: &mut [f64],
    steps: u64,
    rate: impl Fn(&[f64; N]) -> [f64; N],
) -> Option<()> {
    let state: &mut [f64; N] = mu.try_into().ok()?;
    let mut y = *state;
    let moved = |y: &[f64; N], by: f64, k: &[f64; N]| -> [f64; N] {
        core::array::from_fn(|i| y[i] + by * k[i])
    };
    for _ in 0..steps {
        let k1 = rate(&y);
        let k2 = rate(&moved(&y, STEP / 2.0, &k1));
        let k3 = rate(&moved(&y, STEP / 2.0, &k2));
        let k4 = rate(&moved(&y, STEP, &k3));
        for i in 0..N {
            y[i] += STEP / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    *state = y;
    Some(())
}

/// Returns a × b.
#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Times the two methods in turn and prints their best times.
fn times<B: Body>(name: &str, body: &B) -> Result<(), Box<dyn Error>> {
    let (steps, bound) = AGREEMENT;
    let ends = by_library(body, steps)?.0.into_iter().zip(by_hand(body, steps)?.0);
    let distance = ends.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    if distance.is_nan() || distance > bound {
        return Err(format!("{name}: the two methods are {distance:e} apart").into());
    }
    let (mut best, mut sweeps) = ([f64::INFINITY; 2], [0; 2]);
    for _ in 0..7 {
        for (i, run) in [by_library::<B>, by_hand::<B>].into_iter().enumerate() {
            let begin = Instant::now();
            sweeps[i] = black_box(run(body, STEPS)?).1;
            best[i] = best[i].min(begin.elapsed().as_secs_f64());
        }
    }
    for (i, who) in ["heavytop any system: Gauss-4", "RK4 by hand"].iter().enumerate() {
        let (seconds, sweeps) = (best[i], sweeps[i] as f64 / STEPS as f64);
        println!(
            "{{\"name\": \"{who}, {name}\", \"setting\": \"h = {STEP}\", \"seconds\": {seconds:e}, \
             \"steps\": {STEPS}, \"sweeps\": {sweeps}, \"apart\": {distance:e}}}"
        );
    }
    Ok(())
}

/// Makes the steps of one method, so that their instructions can be counted.
fn steps<B: Body>(body: &B, method: &str, steps: u64) -> Result<(), Box<dyn Error>> {
    let end = match method {
        "gauss-4" => by_library(body, steps)?,
        "by-hand" => by_hand(body, steps)?,
        other => return Err(format!("no method called {other}").into()),
    };
    black_box(end);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    // What the bodies are is known at run time only.
    let (so4, two_fields, su3) = black_box((
        so4::RigidBody::new(),
        two_fields::BodyInTwoFields::new(),
        su3::BodyOnSu3::new(),
    ));
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        ["times"] => {
            times("rigid body on so(4)", &so4)?;
            times("body in two fields", &two_fields)?;
            times("body on su(3)", &su3)
        }
        ["so4", method, count] => steps(&so4, method, count.parse()?),
        ["two-fields", method, count] => steps(&two_fields, method, count.parse()?),
        ["su3", method, count] => steps(&su3, method, count.parse()?),
        _ => Err("times, or (so4 | two-fields | su3) (gauss-4 | by-hand) STEPS".into()),
    }
}
