//! The formulations of the audit, with their schemes.

use super::{Failure, Row, measure};
use crate::tops;
use collective_integrators::{
    Collective, Composition, Direct, FirstHalf, HamiltonianField, LiftFree, PartitionedRungeKutta,
    RungeKutta, Scheme, Splitting, Start, Substeps,
};
use heavytop::{HeavyTop, RotorSplitting, SpinorRealisation, SymmetricTopSplitting};
use lie_poisson::{DualNumber, LiePoisson, Se3, Se3Dual};
use momentum_map::DualQuaternions;

type Partitioned = PartitionedRungeKutta<FirstHalf>;

/// One formulation with one scheme, for the paper's top.
pub struct Method {
    measure: Box<dyn Fn(u64) -> Result<Row, Failure> + Send + Sync>,
}

impl Method {
    /// Measures the row of the table, with drifts over this number of steps.
    ///
    /// # Errors
    /// If there is no lift, or fewer than 100 steps succeed.
    pub fn row(&self, steps: u64) -> Result<Row, Failure> {
        (self.measure)(steps)
    }

    fn new<I>(
        formulation: &str,
        scheme: &str,
        claimed: usize,
        integrator: I,
        descent: Option<f64>,
    ) -> Result<Self, Failure>
    where
        I: Start<f64, Momentum = Se3Dual>
            + Start<DualNumber, Momentum = Se3Dual<DualNumber>>
            + Send
            + Sync
            + 'static,
    {
        let (top, formulation, scheme) =
            (tops::paper()?, formulation.to_owned(), scheme.to_owned());
        let measure = move |steps| {
            let ([short, long], failed) = measure::drifts(&integrator, &top, steps)?;
            Ok(Row {
                formulation: formulation.clone(),
                scheme: scheme.clone(),
                failed,
                claimed,
                order: measure::order(&integrator)?,
                poisson: measure::poisson_defect(&integrator)?,
                short,
                long,
                descent,
            })
        };
        Ok(Self { measure: Box::new(measure) })
    }

    fn collective(name: &str, scheme: RungeKutta, top: HeavyTop) -> Result<Self, Failure> {
        let (order, descent) = (scheme.order(), measure::descent_defect(&scheme, top)?);
        let integrator = Collective::new(scheme, SpinorRealisation, top);
        Self::new("collective", name, order, integrator, Some(descent))
    }

    fn partitioned(name: &str, scheme: Partitioned, top: HeavyTop) -> Result<Self, Failure> {
        let (order, descent) = (scheme.order(), measure::descent_defect(&scheme, top)?);
        let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, top);
        Self::new("collective", name, order, integrator, Some(descent))
    }

    fn reduced(name: &str, scheme: RungeKutta, top: HeavyTop) -> Result<Self, Failure> {
        let order = scheme.order();
        Self::new("reduced", name, order, LiftFree::new(scheme, DualQuaternions, top), None)
    }

    fn direct(name: &str, scheme: RungeKutta, top: HeavyTop) -> Result<Self, Failure> {
        let order = scheme.order();
        let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
        Self::new("direct", name, order, Direct::new(scheme, field), None)
    }
}

/// Returns all methods, in the order of the table.
///
/// # Errors
/// There is none with these coefficients and this top.
pub fn methods() -> Result<Vec<Method>, Failure> {
    let (top, mut methods) = (tops::paper()?, Vec::new());
    let (symplectic, explicit) = (symplectic()?, explicit());
    for (name, scheme) in symplectic.iter().chain(&explicit) {
        methods.push(Method::collective(name, scheme.clone(), top)?);
    }
    for (name, scheme) in partitioned()? {
        methods.push(Method::partitioned(&name, scheme, top)?);
    }
    for (name, scheme) in &symplectic {
        methods.push(Method::reduced(name, scheme.clone(), top)?);
    }
    for (name, substeps) in compositions() {
        let order = substeps.order_over(2, true);
        let scheme = Composition::new(RungeKutta::implicit_midpoint(), substeps);
        let integrator = LiftFree::new(scheme, DualQuaternions, top);
        methods.push(Method::new("reduced", name, order, integrator, None)?);
    }
    for (name, scheme) in symplectic.iter().take(2).chain(&explicit) {
        methods.push(Method::direct(name, scheme.clone(), top)?);
    }
    let rotors = Splitting::strang(RotorSplitting(top));
    methods.push(Method::new("splitting, rotors", "Strang", 2, rotors, None)?);
    let symmetric = Splitting::strang(SymmetricTopSplitting::new(top)?);
    methods.push(Method::new("splitting, symmetric top", "Strang", 2, symmetric, None)?);
    for (name, substeps) in compositions() {
        let order = substeps.order_over(2, true);
        let integrator = Composition::new(symmetric, substeps);
        methods.push(Method::new("splitting, symmetric top", name, order, integrator, None)?);
    }
    Ok(methods)
}

fn symplectic() -> Result<Vec<(String, RungeKutta)>, Failure> {
    let mut schemes = vec![("implicit midpoint".to_owned(), RungeKutta::implicit_midpoint())];
    for stages in [2, 3, 4, 5, 6, 8] {
        schemes.push((format!("Gauss {}", 2 * stages), RungeKutta::gauss(stages)?));
    }
    schemes.push(("Qin–Zhang".into(), RungeKutta::qin_zhang()));
    schemes.push(("Sanz-Serna–Abia".into(), RungeKutta::sanz_serna_abia()));
    Ok(schemes)
}

fn explicit() -> [(String, RungeKutta); 3] {
    [
        ("explicit midpoint".into(), RungeKutta::explicit_midpoint()),
        ("RK4".into(), RungeKutta::rk4()),
        ("DOP853".into(), RungeKutta::dop853()),
    ]
}

fn partitioned() -> Result<Vec<(String, Partitioned)>, Failure> {
    let mut schemes = vec![
        ("symplectic Euler, implicit in p".into(), Partitioned::symplectic_euler_implicit_in_p()),
        ("symplectic Euler, implicit in q".into(), Partitioned::symplectic_euler_implicit_in_q()),
        ("Störmer–Verlet".into(), Partitioned::kick_drift_kick()),
    ];
    for stages in 2..=4 {
        let name = format!("Lobatto IIIA–IIIB, {stages} stages");
        schemes.push((name, Partitioned::lobatto_iiia_iiib(stages)?));
    }
    Ok(schemes)
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
