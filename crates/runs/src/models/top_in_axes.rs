//! The model of a heavy top: [`TopInAxes`].

use super::conserved::Conserved;
use super::model::Model;
use crate::error::RunFailure;
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::methods::{Method, SchemeName};
use heavytop::{HeavyTop, Invariant, PrincipalAxes, SpinorRealisation, attitude_of_vertical};
use lie_poisson::{Quaternion, Se3Dual, State, Vector};
use momentum_map::Lift;

/// A heavy top, and the axes of the body in which users give and read its states (Π, Γ). It moves in its principal axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TopInAxes {
    /// The top in its principal axes.
    pub top: HeavyTop,
    /// The principal axes, in the axes of the users.
    pub axes: PrincipalAxes,
    /// The attitude at the start, in the axes of the users; `None` for the shortest rotation of Γ to the vertical. Only
    /// its turn about the vertical counts, since (Π, Γ) determines the rest.
    pub initial_attitude: Option<Quaternion>,
}

impl TopInAxes {
    /// Returns (Π, Γ) of its coordinates; those that are missing are no numbers.
    #[must_use]
    pub fn state(coordinates: &[f64]) -> Se3Dual {
        Vector::from_coordinates(|i| coordinates.get(i).copied().unwrap_or(f64::NAN))
    }

    /// Returns the coordinates of (Π, Γ).
    #[must_use]
    pub fn coordinates(mu: &Se3Dual) -> [f64; 6] {
        core::array::from_fn(|i| mu.coordinate(i))
    }

    /// Returns the warning about a method whose steps do not descend to se(3)∗, whatever the top is.
    #[must_use]
    pub fn method_warning(method: &Method) -> Option<String> {
        matches!(method.scheme(), SchemeName::Partitioned(_)).then(|| {
            format!(
                "warning: {} does not descend from T*C² to se(3)*: what comes out depends on the lift, \
                 and f1 and f2 are not conserved",
                method.scheme()
            )
        })
    }

    /// Returns the method that makes the steps of another one from a start in the least time.
    fn fastest(method: &Method, start: &[f64]) -> Method {
        let has_lift = SpinorRealisation.lift(&Self::state(start)).is_ok();
        if has_lift { method.fastest() } else { *method }
    }

    /// Returns the turn about the vertical from the shortest attitude in the principal axes to the attitude at a start.
    pub(crate) fn turn_about_vertical(&self, start: &Se3Dual) -> Quaternion {
        let given = self.axes.state_from_principal(start);
        let shortest = self.axes.attitude_from_principal(&attitude_of_vertical(&start.0.1));
        let initial = self.initial_attitude.unwrap_or_else(|| attitude_of_vertical(&given.0.1));
        initial * shortest.conjugate()
    }

    /// Returns (Π, Γ) in the axes of the users.
    #[must_use]
    pub fn given(&self, mu: &Se3Dual) -> Se3Dual {
        if self.axes.is_aligned() { *mu } else { self.axes.state_from_principal(mu) }
    }
}

impl From<HeavyTop> for TopInAxes {
    /// Returns the top whose states are given and read in its principal axes.
    fn from(top: HeavyTop) -> Self {
        Self { top, axes: PrincipalAxes::aligned(top.inertia()), initial_attitude: None }
    }
}

impl SystemScales for TopInAxes {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.top.blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.top.differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.top.fastest_rate(mu)
    }
}

impl Model for TopInAxes {
    fn algebra_name(&self) -> String {
        "se(3)".into()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        let vector = |name: &str| (name.into(), (1..=3).map(|i| format!("{name}{i}")).collect());
        vec![vector("Pi"), vector("Gamma")]
    }

    fn conserved(&self, start: &[f64]) -> Box<dyn Conserved + '_> {
        let list = self.top.invariants_from(&Self::state(start));
        Box::new(Invariants { top: &self.top, list })
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        _start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Ok(method.tangent_integrator(&self.top)?)
    }

    /// Kernels, which have no tangent maps, make the same steps faster.
    fn integrator(&self, method: &Method, start: &[f64]) -> Result<AnyIntegrator, RunFailure> {
        Ok(Self::fastest(method, start).integrator(&self.top)?)
    }

    fn integrator_with_attitude(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator, RunFailure> {
        let formulation = method.formulation();
        let integrator = Self::fastest(method, start).integrator_with_attitude(&self.top)?;
        integrator.ok_or(RunFailure::NoAttitude { formulation })
    }

    /// Checks that a thin rod does not turn about itself.
    fn start(&self, given: &[f64]) -> Result<Vec<f64>, RunFailure> {
        self.require_dimension(given)?;
        let mu = self.axes.state_to_principal(&Self::state(given));
        self.top.require_state(&mu)?;
        Ok(Self::coordinates(&mu).to_vec())
    }

    fn present(&self, momentum: &mut [f64]) {
        if !self.axes.is_aligned() {
            let given = self.axes.state_from_principal(&Self::state(momentum));
            momentum.iter_mut().zip(Self::coordinates(&given)).for_each(|(x, given)| *x = given);
        }
    }

    /// Turns the attitude about the vertical, so that in the axes of the users it begins as the given one, or else as the
    /// shortest one, as it does in the principal axes.
    fn present_attitude(&self, start: &[f64]) -> Box<dyn Fn(Quaternion) -> Quaternion + '_> {
        if self.axes.is_aligned() && self.initial_attitude.is_none() {
            return Box::new(|attitude| attitude);
        }
        let turn = self.turn_about_vertical(&Self::state(start));
        Box::new(move |attitude| turn * self.axes.attitude_from_principal(&attitude))
    }

    /// f₃ is a component of Π in principal axes.
    fn is_coordinate(&self, conserved: &str) -> bool {
        conserved == Invariant::AxialMomentum.symbol()
            && self.axes.is_aligned()
            && self.top.axial_component().is_some()
    }

    fn descends(&self, method: &Method, _start: &[f64]) -> Result<bool, RunFailure> {
        Ok(Self::method_warning(method).is_none())
    }

    fn warning(&self, method: &Method, _start: &[f64]) -> Result<Option<String>, RunFailure> {
        Ok(Self::method_warning(method))
    }
}

/// The invariants of a top.
struct Invariants<'a> {
    top: &'a HeavyTop,
    list: Vec<Invariant>,
}

impl Conserved for Invariants<'_> {
    fn names(&self) -> Vec<String> {
        self.list.iter().map(|invariant| invariant.symbol().into()).collect()
    }

    fn append(&self, _time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        let mu = TopInAxes::state(momentum);
        values.extend(self.list.iter().map(|invariant| invariant.value(self.top, &mu)));
    }

    fn without_value(&self, _time: f64, momentum: &[f64]) -> String {
        let mu = TopInAxes::state(momentum);
        let is_infinite = |f: &&Invariant| !f.value(self.top, &mu).is_finite();
        let symbol = self.list.iter().find(is_infinite).map_or("h", |f| f.symbol());
        format!("the invariant {symbol} is not finite")
    }
}
