//! Prints the bits of trajectories by every method, to be compared with those of a browser: `bits [STEP]`, in s.
//!
//! A line for every hundredth step has the name of the method, the number of the step, and Π, Γ and the attitude in
//! hexadecimal digits. The last line of a method is its section where Γ₁ = 0: the number of points, and Π₁ at the last.

use heavytop::{Coordinate, HeavyTop};
use heavytop_page::{PageMethod, Simulation};
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;

/// The number of steps.
const STEPS: u32 = 2000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let step = std::env::args().nth(1).map_or(Ok(0.05), |step| step.parse())?;
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    for method in PageMethod::ALL {
        let mut simulation = Simulation::new(top, &start, method, step)?;
        simulation.change_section(Coordinate::Gamma1)?;
        for step in (100..=STEPS).step_by(100) {
            simulation.advance(f64::INFINITY, 100)?;
            let moment = simulation.at(f64::INFINITY);
            let Covector(Pair(pi, gamma)) = moment.momentum;
            let numbers = pi.iter().chain(&gamma).copied();
            let attitude = [moment.attitude.scalar].into_iter();
            let numbers = numbers.chain(attitude).chain(moment.attitude.vector.iter().copied());
            let digits: Vec<_> = numbers.map(|x| format!("{:016x}", x.to_bits())).collect();
            println!("{} {step} {}", method.name(), digits.join(" "));
        }
        let points = simulation.section_points();
        let last = points.last().map_or(f64::NAN, |point| point.y);
        println!("{} section {} {:016x}", method.name(), points.len(), last.to_bits());
    }
    Ok(())
}
