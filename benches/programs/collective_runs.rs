//! Makes long collective runs through every realisation of the crates, and through that of `docs/write_your_own.rs`.
//!
//! `cargo run --release -p measurements --bin collective_runs -- [steps] [name]` prints |z| at the beginning,
//! its largest value, the iterations of a step in the first and the last thousand steps, and the largest relative
//! change of the first Casimir. A step that fails ends the program with its error.

use collective_integrators::{Collective, Integrator, RungeKutta};
use heavytop::SpinorRealisation;
use lie_poisson::nalgebra::{Vector2, Vector3};
use lie_poisson::num_complex::Complex;
use lie_poisson::{
    Automatic, Covector, Diagonal, Pair, Power, SL2OnR2, SO3OnR3, Sum, UnitaryAlgebra, Vector,
    larger,
};
use momentum_map::{
    AffineAction, Cotangent, HOPF, MomentumMap, Opposite, PARTICLE, PoissonMap, PowerMap,
    QuadraticMomentumMap, Reversed, Side, SourcePoint, TargetPoint, unitary_realisation,
};
use std::error::Error;
use workspace_tests::Quadratic;
use write_your_own::{Poincare, Rotor};

#[path = "../../docs/write_your_own.rs"]
#[allow(dead_code, missing_docs, unused_imports)]
mod write_your_own;

/// The options of the program: the number of steps, and the realisation.
struct Runs {
    steps: u64,
    wanted: Option<String>,
}

impl Runs {
    /// Runs the midpoint rule for a quadratic Hamiltonian.
    fn quadratic<M: PoissonMap>(
        &self,
        name: &str,
        map: M,
        z: SourcePoint<M>,
        casimir: impl Fn(&TargetPoint<M>) -> f64,
    ) -> Result<(), Box<dyn Error>> {
        let h = Automatic(Quadratic::<M::Target>::default());
        self.run(name, &Collective::new(RungeKutta::implicit_midpoint(), map, h), z, 0.05, casimir)
    }

    fn run<I: Integrator<State: Vector>>(
        &self,
        name: &str,
        integrator: &I,
        z: I::State,
        step: f64,
        casimir: impl Fn(&I::Momentum) -> f64,
    ) -> Result<(), Box<dyn Error>> {
        if self.wanted.as_ref().is_some_and(|wanted| !name.contains(wanted)) {
            return Ok(());
        }
        let first = casimir(&integrator.momentum(&z));
        let (mut largest, mut change, mut iterations) = (0.0, 0.0, [0, 0]);
        for sample in integrator.trajectory_from(z, step).take(self.steps as usize + 1) {
            let sample = sample.map_err(|e| format!("{name}: {e}"))?;
            largest = larger(largest, sample.state.max_abs());
            change = larger(change, (casimir(&sample.momentum) / first - 1.0).abs());
            let ends = [sample.step <= 1000, sample.step + 1000 > self.steps];
            for (sum, counts) in iterations.iter_mut().zip(ends) {
                *sum += if counts { sample.iterations } else { 0 };
            }
        }
        let [begin, end] = iterations.map(|n| n as f64 / 1000.0);
        println!(
            "| {name} | {:.2} | {largest:.2} | {begin:.1} | {end:.1} | {change:.1e} |",
            z.max_abs()
        );
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let steps = arguments.next().map_or(Ok(100_000), |n| n.parse())?;
    let runs = Runs { steps, wanted: arguments.next() };
    println!(
        "{steps} steps\n\n| realisation | \\|z\\| at first | \\|z\\| at most | iterations at first | at the end | change of C |"
    );
    println!("|---|---|---|---|---|---|");
    let c = Complex::new;
    let (u, v) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));

    let gauss = Collective::new(RungeKutta::gauss(3)?, MomentumMap(Poincare), Automatic(Rotor));
    let z = Cotangent::new(Vector2::new(0.4, -0.2), Covector(Vector2::new(0.3, 0.8)));
    runs.run("write_your_own, Gauss-6", &gauss, z, 0.05, |j| j.0.y * j.0.y - j.0.z * j.0.z)?;

    let spinors = Vector2::new(c(0.5, 0.1), c(-0.3, 0.8));
    runs.quadratic("Hopf", HOPF, spinors, |mu| mu.0.norm_squared())?;
    let spins =
        Power([spinors, spinors.map(|x| x * c(0.3, 1.0)), Vector2::new(c(0.0, 1.0), c(1.0, 0.0))]);
    runs.quadratic("three spins", PowerMap::<_, 3>(HOPF), spins, |mu| mu.0.0[0].norm_squared())?;
    let state = Vector3::new(c(1.0, 0.2), c(0.1, -0.5), c(0.5, 0.0));
    runs.quadratic("U(3)", unitary_realisation::<3>(), state, |mu| {
        UnitaryAlgebra.hermitian(mu).trace().re
    })?;

    let plane = Pair(Vector2::new(0.5, 0.3), Vector2::new(-0.4, 0.9));
    let area = |mu: &Covector<Vector3<f64>>| mu.0.x * mu.0.x + 4.0 * mu.0.y * mu.0.z;
    let definite = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Right);
    runs.quadratic("SL(2), definite", definite, plane, area)?;
    let indefinite = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
    runs.quadratic("SL(2), indefinite", indefinite, plane, area)?;

    let z = Cotangent::new(u, Covector(v));
    runs.quadratic("particle", PARTICLE, z, |mu| mu.0.1.norm_squared())?;
    let two = MomentumMap(Opposite(AffineAction(Diagonal(SO3OnR3))));
    let z = Cotangent::new(Power([u, v]), Covector(Power([v + u.cross(&v), u - v])));
    runs.quadratic("body in two fields", two, z, |mu| mu.0.1.0[0].norm_squared())?;
    let z = Cotangent::new(Vector2::new(c(1.0, 0.3), c(-0.4, 0.2)), Covector(spinors));
    runs.quadratic("spinor realisation M", SpinorRealisation, z, |mu| mu.0.1.norm_squared())
}
