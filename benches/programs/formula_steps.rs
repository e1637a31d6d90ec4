//! Makes RK4 steps on se(3)∗ with a Hamiltonian from text or the same one in Rust, to count their instructions:
//!
//! ```text
//! cargo build --release -p measurements --bin formula_steps
//! valgrind --tool=callgrind target/release/formula_steps (text | rust) (top | periodic) (f64 | lanes | avx2) STEPS
//! ```
//!
//! The steps on `lanes` are those of the four trajectories of [`DefaultLanes`], those of `avx2` of an ensemble of four by
//! [`Laned`] on registers of 256 bits.
//!
//! A count is the difference of two runs, divided by the steps that one makes more: what comes before the first step is in
//! both.

use collective_integrators::{
    BatchIntegrator, Direct, HamiltonianField, IntegrationError, Integrator, Laned, RungeKutta,
};
use lie_poisson::{
    Covector, DefaultLanes, Hamiltonian, InstructionSet, Lanes, LiePoisson, Pair, Real, Se3,
    Se3Dual, Vector,
};
use lie_poisson_formulas::{FormulaHamiltonian, Parameters, Vocabulary};
use nalgebra::Vector3;
use std::error::Error;
use std::hint::black_box;

/// A point of se(3)∗.
type Point<T> = Covector<Pair<Vector3<T>, Vector3<T>>>;

/// The heavy top, h = ½ Π·I⁻¹Π + mgl c·Γ, with the differential by hand.
struct Top {
    inverse: Vector3<f64>,
    torque: Vector3<f64>,
}

impl<T: Real> Hamiltonian<LiePoisson<Se3>, T> for Top {
    fn value(&self, Covector(Pair(pi, gamma)): &Point<T>) -> T {
        let kinetic = pi.zip_map(&self.inverse, |x, inverse| x * x * inverse).sum() * 0.5;
        kinetic + gamma.zip_map(&self.torque, |x, c| x * c).sum()
    }

    #[inline(always)]
    fn differential(&self, Covector(Pair(pi, _)): &Point<T>) -> Pair<Vector3<T>, Vector3<T>> {
        Pair(pi.zip_map(&self.inverse, |x, inverse| x * inverse), self.torque.map(T::from_f64))
    }
}

/// A free body in a periodic field, h = ½ Π·I⁻¹Π + a cos(k Γ₁) + b exp(−Γ₃²), with the differential by hand.
struct InPeriodicField {
    inverse: Vector3<f64>,
    a: f64,
    k: f64,
    b: f64,
}

impl<T: Real> Hamiltonian<LiePoisson<Se3>, T> for InPeriodicField {
    fn value(&self, Covector(Pair(pi, gamma)): &Point<T>) -> T {
        let kinetic = pi.zip_map(&self.inverse, |x, inverse| x * x * inverse).sum() * 0.5;
        kinetic + (gamma.x * self.k).cos() * self.a + (-(gamma.z * gamma.z)).exp() * self.b
    }

    #[inline(always)]
    fn differential(&self, Covector(Pair(pi, gamma)): &Point<T>) -> Pair<Vector3<T>, Vector3<T>> {
        let x = (gamma.x * self.k).sin() * (-self.a * self.k);
        let z = (-(gamma.z * gamma.z)).exp() * gamma.z * (-2.0 * self.b);
        Pair(pi.zip_map(&self.inverse, |x, inverse| x * inverse), Vector3::new(x, T::zero(), z))
    }
}

/// The coordinates of the start of the first lane.
const START: [f64; 6] = [2.0, 3.0, 4.0, 0.5, 0.0, 0.866];

/// Makes the steps, from a start that differs from lane to lane.
fn steps<T: Lanes, H>(hamiltonian: H, steps: u64) -> Result<(), Box<dyn Error>>
where
    H: Hamiltonian<LiePoisson<Se3>, T>,
{
    let mut state: Se3Dual<T> =
        Vector::from_coordinates(|i| T::from_lanes(|lane| START[i] + 0.01 * lane as f64));
    let rk4 = rk4(hamiltonian);
    let mut workspace = rk4.workspace();
    for _ in 0..steps {
        state = rk4.step(&state, 0.01, &mut workspace)?.point;
    }
    black_box(state);
    Ok(())
}

/// Returns RK4 on se(3)∗.
fn rk4<H>(hamiltonian: H) -> Rk4<H> {
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian };
    Direct::new(RungeKutta::rk4(), field)
}

/// The integrator of a Hamiltonian.
type Rk4<H> = Direct<RungeKutta, HamiltonianField<LiePoisson<Se3>, H>>;

/// Makes the steps of an ensemble of four.
fn ensemble<H>(hamiltonian: H, steps: u64) -> Result<(), Box<dyn Error>>
where
    Laned<Rk4<H>>: BatchIntegrator<Member = Se3Dual>,
{
    let batch = Laned::new(rk4(hamiltonian)).with_instructions(InstructionSet::Avx2)?;
    let mut members: Vec<Se3Dual> = (0..4)
        .map(|lane| Vector::from_coordinates(|i| START[i] + 0.01 * f64::from(lane)))
        .collect();
    let mut failure: Result<(), IntegrationError> = Ok(());
    let mut failed = |_, error| failure = Err(error);
    batch.advance(&mut members, 0.01, 0..steps, &mut batch.workspace(), &mut failed);
    black_box(members);
    Ok(failure?)
}

/// Makes the steps on numbers or on SIMD lanes (several trajectories in one register).
fn on<H>(scalar: &str, hamiltonian: H, count: u64) -> Result<(), Box<dyn Error>>
where
    H: Hamiltonian<LiePoisson<Se3>, f64> + Hamiltonian<LiePoisson<Se3>, DefaultLanes>,
    Laned<Rk4<H>>: BatchIntegrator<Member = Se3Dual>,
{
    match scalar {
        "avx2" => ensemble(hamiltonian, count),
        "f64" => steps::<f64, H>(hamiltonian, count),
        "lanes" => steps::<DefaultLanes, H>(hamiltonian, count),
        other => Err(format!("no scalar called {other}").into()),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [source, system, scalar, steps] = arguments.as_slice() else {
        return Err(
            "four arguments: (text | rust) (top | periodic) (f64 | lanes | avx2) STEPS".into()
        );
    };
    let steps = steps.parse()?;
    // The parameters are known at run time only, as those of a formula are.
    let inverse = black_box(Vector3::new(1.0 / 2.0, 1.0 / 2.0, 1.0));
    let parameters = Parameters::new().vector("I", &[2.0, 2.0, 1.0])?.number("mgl", 1.0)?;
    let parameters = parameters.vector("c", &[1.0, 0.0, 0.0])?.number("k", 3.0)?;
    let names = Vocabulary::of(&Se3::default(), &parameters)?;
    let text = |text| FormulaHamiltonian::<Se3>::new(text, &names);
    match (source.as_str(), system.as_str()) {
        ("text", "top") => {
            let h = text("0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + mgl*c·Gamma")?;
            on(scalar, h, steps)
        }
        ("rust", "top") => on(scalar, Top { inverse, torque: black_box(Vector3::x()) }, steps),
        ("text", "periodic") => {
            let kinetic = "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)";
            let h = text(&format!("{kinetic} + 0.7*cos(k*Gamma1) + 0.4*exp(-Gamma3^2)"))?;
            on(scalar, h, steps)
        }
        ("rust", "periodic") => {
            let [a, k, b] = black_box([0.7, 3.0, 0.4]);
            on(scalar, InPeriodicField { inverse, a, k, b }, steps)
        }
        _ => Err("no such Hamiltonian".into()),
    }
}
