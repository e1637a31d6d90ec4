//! Integrates Kida's elliptical vortex on so(2, 1)∗, collectively through the Clebsch map T∗so(2, 1) → so(2, 1)∗.
//!
//! ```text
//! cargo run --release -p systems-examples --bin kida_vortex -- [PICTURE]
//! ```
//!
//! Prints the largest relative deviations of the energy h and of the Casimir a²b² up to t = 100 s and t = 1000 s, for steps
//! of 0.1 s. The Gauss method of order 4 conserves the Casimir to round-off, and h does not drift. With the classical
//! Runge–Kutta method of order 4 on the equations both drift in proportion to the time. The program fails if this does not
//! hold. With a PICTURE (a path ending in .png or .svg), draws the ratio of the axes and the angle against time, for an
//! ellipse that turns and one of the same area that swings.

mod pictures;

use collective_integrators::{Collective, Direct, HamiltonianField, RungeKutta, Start};
use lie_poisson::{Casimirs, Covector, Hamiltonian, InfinitesimalAdjoint, LiePoisson, larger};
use lie_poisson_systems::{KidaVortex, So21};
use momentum_map::{Side, clebsch_realisation};
use nalgebra::Vector3;
use pictures::colours::{BLUE, RED};
use pictures::curves::{Curve, curves};
use pictures::{arguments::Arguments, canvas};
use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

const STEP: f64 = 0.1;

/// The steps of the picture, up to t = 60 s.
const DRAWN: usize = 600;

/// Returns the largest relative deviations of h and of the Casimir, up to t = 100 s and up to t = 1000 s.
fn deviations<I>(integrator: &I, vortex: &KidaVortex) -> Result<[[f64; 2]; 2], Box<dyn Error>>
where
    I: Start<Momentum = Covector<Vector3<f64>>>,
{
    let start = KidaVortex::momentum(1.5, 0.5, 0.3)?;
    let quantities = |mu: &_| [vortex.value(mu), So21.casimir(0, mu)];
    let (initial, mut largest, mut early) = (quantities(&start), [0.0; 2], [0.0; 2]);
    for (n, sample) in integrator.trajectory(&start, STEP)?.take(10_001).enumerate() {
        let now = quantities(&sample?.momentum);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] / initial[i] - 1.0).abs()));
        if n <= 1000 {
            early = largest;
        }
    }
    Ok([early, largest])
}

/// Values against time (s).
type Points = Vec<(f64, f64)>;

/// Returns the ratio a/b and the angle, in degrees from −90 to 90, against the time.
fn motion<I>(integrator: &I, start: &Covector<Vector3<f64>>) -> Result<[Points; 2], Box<dyn Error>>
where
    I: Start<Momentum = Covector<Vector3<f64>>>,
{
    let (mut ratios, mut angles, mut angle) = (Vec::new(), Vec::new(), KidaVortex::angle(start));
    for sample in integrator.trajectory(start, STEP)?.take(DRAWN + 1) {
        let sample = sample?;
        let (a, b) = KidaVortex::semi_axes(&sample.momentum);
        // An ellipse has the same angle after half a turn: the curve has a gap there.
        let next = KidaVortex::angle(&sample.momentum);
        if (next - angle).abs() > 0.5 * PI {
            angles.push((sample.time, f64::NAN));
        }
        angle = next;
        ratios.push((sample.time, a / b));
        angles.push((sample.time, angle.to_degrees()));
    }
    Ok([ratios, angles])
}

fn draw<I>(path: &Path, integrator: &I) -> Result<(), Box<dyn Error>>
where
    I: Start<Momentum = Covector<Vector3<f64>>>,
{
    let turning = motion(integrator, &KidaVortex::momentum(1.5, 0.5, 0.3)?)?;
    let swinging = motion(integrator, &KidaVortex::momentum(0.9, 5.0 / 6.0, 0.25 * PI)?)?;
    let heading = [
        "Kida's elliptical vortex in a strain",
        "k = 1 m²/s, e = 0.1 1/s, γ = 0.05 1/s; Gauss method of order 4 through a Clebsch map, steps of 0.1 s",
    ];
    canvas::save(path, heading, [1100, 720], |area| {
        let panels = area.split_evenly((2, 1));
        for (i, (panel, axis)) in panels.iter().zip(["a/b", "angle of a (°)"]).enumerate() {
            // The key of the first panel serves both.
            let curve = |name: &str, colour, points: &[Points; 2]| Curve {
                name: if i == 0 { name.into() } else { String::new() },
                colour,
                points: points[i].clone(),
            };
            let both = [
                curve("a, b = 1.5, 0.5 m at 17°: turns", BLUE, &turning),
                curve("a, b = 0.9, 0.83 m at 45°: swings", RED, &swinging),
            ];
            curves(panel, "", ["t (s)", axis], &both)?;
        }
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    let vortex = KidaVortex::new(1.0, 0.1, 0.05)?;
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left)?;
    let collective = Collective::new(RungeKutta::gauss(2)?, map, vortex);
    let gauss = deviations(&collective, &vortex)?;
    let field = HamiltonianField { space: LiePoisson::plus(So21), hamiltonian: vortex };
    let direct = deviations(&Direct::new(RungeKutta::rk4(), field), &vortex)?;
    println!("largest relative deviations, steps of {STEP} s");
    println!("{:>18} {:>8} {:>10} {:>10}", "scheme", "t (s)", "h", "a²b²");
    for (name, rows) in [("Gauss 4, Clebsch", gauss), ("RK4, direct", direct)] {
        for (time, [energy, casimir]) in [100, 1000].iter().zip(rows) {
            println!("{name:>18} {time:>8} {energy:>10.2e} {casimir:>10.2e}");
        }
    }
    if let Some(path) = &arguments.picture {
        draw(path, &collective)?;
    }
    let conserved = gauss[1][1] < 1e-12 && gauss[1][0] < 1.5 * gauss[0][0];
    let control = direct[1][0] > 5.0 * direct[0][0] && direct[1][1] > 5.0 * direct[0][1];
    if conserved && control { Ok(()) } else { Err(format!("{gauss:?}, {direct:?}").into()) }
}
