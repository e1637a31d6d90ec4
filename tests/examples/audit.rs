//! One row for every scheme and formulation: claimed against measured.
//!
//! `cargo run --release -p workspace-tests --example audit -- [steps]` prints the tables of
//! `docs/audit-schemes.md`; a fresh run takes a few minutes with 10⁶ steps.
//!
//! The order is the fitted slope of the error at t = 1 against exact values; the Poisson defect
//! ‖DφΛDφᵀ − Λ∘φ‖ is that of one step of 1/10 from the paper's start, by exact tangent maps; the
//! descent defect is |M(Φ(z′)) − M(Φ(z))| over lifts z′ of one momentum; drifts are over a run of
//! steps of 1/50.

use collective_integrators::diagnostics::{Drift, fibre_defects, step_poisson_defect};
use collective_integrators::{
    Collective, Composition, Direct, FirstHalf, HamiltonianField, LiftFree, PartitionedRungeKutta,
    RungeKutta, Scheme, Splitting, Start, Substeps, fitted_order,
};
use heavytop::{HeavyTop, RotorSplitting, SpinorRealisation, SymmetricTopSplitting};
use lie_poisson::{DualNumber, Hamiltonian, LiePoisson, Se3, Se3Dual, Vector, larger};
use momentum_map::{CollectiveHamiltonian, DualQuaternions, Lift};
use std::error::Error;
use workspace_tests::tops;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;
type Partitioned = PartitionedRungeKutta<FirstHalf>;

struct Audit {
    top: HeavyTop,
    exact: Se3Dual,
    steps: usize,
}

impl Audit {
    /// The slope of the error at t = 1; the finest steps of high orders are at round-off.
    fn order<I: Start<f64, Momentum = Se3Dual>>(&self, integrator: &I) -> Outcome<String> {
        let mut points = Vec::new();
        for count in [1_usize, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64, 96] {
            let step = 1.0 / count as f64;
            let mut run = integrator.trajectory(&tops::paper_start(), step)?;
            if let Some(Ok(sample)) = run.nth(count) {
                points.push((step, (sample.momentum - self.exact).max_abs()));
            }
        }
        // Large steps are not in the asymptotic regime: the finest six above the plateau count.
        let usable: Vec<_> = points.into_iter().filter(|(_, error)| *error > 1e-12).collect();
        let finest = &usable[usable.len().saturating_sub(6)..];
        Ok(fitted_order(finest, 1e-12).map_or("too few".into(), |slope| format!("{slope:.2}")))
    }

    fn row<I>(
        &self,
        name: [&str; 2],
        claimed: usize,
        integrator: &I,
        descent: Option<f64>,
    ) -> Outcome
    where
        I: Start<f64, Momentum = Se3Dual> + Start<DualNumber, Momentum = Se3Dual<DualNumber>>,
    {
        let (start, [formulation, scheme]) = (tops::paper_start(), name);
        let space = LiePoisson::minus(Se3::default());
        let poisson = step_poisson_defect(&space, integrator, &start, 0.1)?;
        let casimirs = |mu: &Se3Dual| [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)];
        let (first, mut worst, mut energies) = (casimirs(&start), [0.0; 2], Vec::new());
        let run = Start::<f64>::trajectory(integrator, &start, 0.02)?;
        let mut ended = String::new();
        for sample in run.take(self.steps + 1) {
            let sample = match sample {
                Ok(sample) => sample,
                Err(error) => {
                    ended = format!(" (fails at step {})", error.step);
                    break;
                }
            };
            let now = casimirs(&sample.momentum);
            worst = [0, 1].map(|k| larger(worst[k], (now[k] - first[k]).abs()));
            if sample.step % 100 == 0 {
                energies.push((sample.time, self.top.value(&sample.momentum)));
            }
        }
        let drift = Drift::of(energies)?;
        let descent = descent.map_or("—".into(), |defect| format!("{defect:.1e}"));
        println!(
            "| {formulation} | {scheme}{ended} | {claimed} | {} | {poisson:.1e} | {:.1e}, {:.1e} | {:.1e} | {:.1e} | {descent} |",
            self.order(integrator)?,
            worst[0],
            worst[1],
            drift.largest,
            drift.slope
        );
        Ok(())
    }

    /// The descent defect of a scheme on T*C².
    fn descent<S: Scheme>(&self, scheme: &S) -> Outcome<f64> {
        let system = CollectiveHamiltonian::new(SpinorRealisation, self.top);
        let z = SpinorRealisation.lift::<f64>(&tops::paper_start())?;
        Ok(fibre_defects(scheme, &system, &z, 0.7, 0.02)?.descent)
    }

    fn collective(&self, name: &str, scheme: &RungeKutta) -> Outcome {
        let integrator = Collective::new(scheme.clone(), SpinorRealisation, self.top);
        self.row(["collective", name], scheme.order(), &integrator, Some(self.descent(scheme)?))
    }

    fn partitioned(&self, name: &str, scheme: Partitioned) -> Outcome {
        let (order, descent) = (scheme.order(), self.descent(&scheme)?);
        let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, self.top);
        self.row(["collective", name], order, &integrator, Some(descent))
    }

    fn reduced(&self, name: &str, scheme: &RungeKutta) -> Outcome {
        let integrator = LiftFree::new(scheme.clone(), DualQuaternions, self.top);
        self.row(["reduced", name], scheme.order(), &integrator, None)
    }

    fn direct(&self, name: &str, scheme: &RungeKutta) -> Outcome {
        let space = LiePoisson::minus(Se3::default());
        let field = HamiltonianField { space, hamiltonian: self.top };
        self.row(["direct", name], scheme.order(), &Direct::new(scheme.clone(), field), None)
    }
}

fn compositions() -> [(&'static str, Substeps); 6] {
    [
        ("Yoshida 4", Substeps::yoshida4()),
        ("Suzuki 4", Substeps::suzuki4()),
        ("Yoshida 6", Substeps::yoshida6()),
        ("Kahan–Li 6", Substeps::kahan_li6()),
        ("Kahan–Li 8", Substeps::kahan_li8()),
        ("McLachlan 8", Substeps::mclachlan8()),
    ]
}

fn main() -> Outcome {
    let steps = std::env::args().nth(1).map_or(Ok(1_000_000), |text| text.parse())?;
    let audit = Audit { top: tops::paper()?, exact: tops::paper_exact(), steps };
    println!(
        "| formulation | scheme | order claimed | measured | Poisson defect, h = 1/10 | max \\|Δf₁\\|, \\|Δf₂\\| | max \\|Δh\\| | slope of h, 1/s | descent defect |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let gauss = [2, 3, 4, 5, 6, 8].map(|s| Ok::<_, Box<dyn Error>>((2 * s, RungeKutta::gauss(s)?)));
    let mut symplectic = vec![("implicit midpoint".to_owned(), RungeKutta::implicit_midpoint())];
    for scheme in gauss {
        let (order, scheme) = scheme?;
        symplectic.push((format!("Gauss {order}"), scheme));
    }
    symplectic.push(("Qin–Zhang".into(), RungeKutta::qin_zhang()));
    symplectic.push(("Sanz-Serna–Abia".into(), RungeKutta::sanz_serna_abia()));
    let explicit = [
        ("explicit midpoint".to_owned(), RungeKutta::explicit_midpoint()),
        ("RK4".into(), RungeKutta::rk4()),
        ("DOP853".into(), RungeKutta::dop853()),
    ];
    for (name, scheme) in symplectic.iter().chain(&explicit) {
        audit.collective(name, scheme)?;
    }
    audit.partitioned(
        "symplectic Euler, implicit in p",
        Partitioned::symplectic_euler_implicit_in_p(),
    )?;
    audit.partitioned(
        "symplectic Euler, implicit in q",
        Partitioned::symplectic_euler_implicit_in_q(),
    )?;
    audit.partitioned("Störmer–Verlet", Partitioned::kick_drift_kick())?;
    for stages in 2..=4 {
        let scheme = Partitioned::lobatto_iiia_iiib(stages)?;
        audit.partitioned(&format!("Lobatto IIIA–IIIB, {stages} stages"), scheme)?;
    }
    for (name, scheme) in &symplectic {
        audit.reduced(name, scheme)?;
    }
    for (name, substeps) in compositions() {
        let order = substeps.order_over(2, true);
        let scheme = Composition::new(RungeKutta::implicit_midpoint(), substeps);
        let integrator = LiftFree::new(scheme, DualQuaternions, audit.top);
        audit.row(["reduced", name], order, &integrator, None)?;
    }
    for (name, scheme) in symplectic.iter().take(2).chain(&explicit) {
        audit.direct(name, scheme)?;
    }
    let rotors = Splitting::strang(RotorSplitting(audit.top));
    audit.row(["splitting, rotors", "Strang"], 2, &rotors, None)?;
    let symmetric = Splitting::strang(SymmetricTopSplitting::new(audit.top)?);
    audit.row(["splitting, symmetric top", "Strang"], 2, &symmetric, None)?;
    for (name, substeps) in compositions() {
        let order = substeps.order_over(2, true);
        let integrator = Composition::new(symmetric, substeps);
        audit.row(["splitting, symmetric top", name], order, &integrator, None)?;
    }
    Ok(())
}
