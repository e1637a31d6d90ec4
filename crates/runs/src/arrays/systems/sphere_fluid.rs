//! An ideal fluid on the sphere.

use crate::arrays::any_arrays::{ArrayShape, Arrays, Made};
use crate::arrays::arguments::{Given, whole};
use crate::arrays::directions::Directions;
use crate::arrays::renewed::{Renewed, resumable_after};
use crate::arrays::sites_arrays::Started;
use crate::arrays::systems::spin_lattice::seed;
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents, Direct, VectorField};
use core::f64::consts::PI;
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use lie_poisson::State;
use lie_poisson_formula_systems::Parameter;
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};

pub(in crate::arrays) const NAME: &str = "sphere-fluid";

pub(in crate::arrays) const PARAMETERS: &[Parameter] = &[
    Parameter::number("size", "N: harmonics of degree below N are kept, 2 to 2048"),
    Parameter::number("rotation", "angular velocity of the sphere about the third axis").or(&[0.0]),
];

pub(in crate::arrays) const START: &[Parameter] = &[
    Parameter::list(
        "coefficients",
        "rows [l, m, re, im] of the absolute vorticity, m from 0 to l; added to a random one",
    )
    .or(&[]),
    Parameter::list("omega", "all coefficients as in the output, instead").or(&[]),
    Parameter::list("degrees", "the least and the largest degree of a random vorticity, instead")
        .or(&[]),
    Parameter::number("rms", "root mean square of a random vorticity").or(&[1.0]),
    Parameter::number("seed", "of a random vorticity, a whole number").or(&[0.0]),
];

/// Makes Zeitlin's model dW/dt = [P, W]/ħ of the vorticity ω on N×N matrices W.
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let size = given.whole("size", [2, 2048])?;
    let fluid = Zeitlin::new(size).and_then(|fluid| fluid.with_rotation(given.number("rotation")));
    Ok(Box::new(SphereFluid(fluid.map_err(|error| given.refused("size", error.to_string()))?)))
}

#[derive(Debug)]
struct SphereFluid(Zeitlin);

impl SphereFluid {
    fn size(&self) -> usize {
        self.0.size()
    }

    /// Returns the matrix of a state.
    fn matrix(&self, state: &[f64]) -> LargeSkewHermitian {
        let mut w = LargeSkewHermitian::zeros(self.size());
        w.set_coordinates(|i| state.get(i).copied().unwrap_or(f64::NAN));
        w
    }

    /// Writes coefficients as an array of N rows: Re ω_lm at [l, m], and Im ω_lm at [m − 1, l].
    fn write(&self, omega: &VorticityCoefficients, to: &mut [f64]) {
        let n = self.size();
        for (l, m) in (0..n).flat_map(|l| (0..=l).map(move |m| (l, m))) {
            let value = omega.at(l, m);
            to[n * l + m] = value.re;
            if m > 0 {
                to[n * (m - 1) + l] = value.im;
            }
        }
    }

    fn read(&self, from: &[f64]) -> VorticityCoefficients {
        let n = self.size();
        let imaginary = |l, m| if m > 0 { from[n * (m - 1) + l] } else { 0.0 };
        VorticityCoefficients::from_fn(n, |l, m| Complex::new(from[n * l + m], imaginary(l, m)))
    }
}

impl Arrays for SphereFluid {
    fn algebra_name(&self) -> String {
        format!("u({})", self.size())
    }

    fn hamiltonian(&self) -> &'static str {
        "-∫ψω/2"
    }

    fn arrays(&self) -> Vec<ArrayShape> {
        let n = self.size();
        vec![ArrayShape { name: "omega", shape: vec![n, n], block: n * n }]
    }

    /// h, the enstrophy Z, and the angular momentum, or its third component on a sphere that rotates.
    fn invariant_names(&self) -> Vec<String> {
        let all = ["h", "Z", "M3", "M1", "M2"].map(String::from);
        if self.0.rotates() { all[..3].to_vec() } else { all.to_vec() }
    }

    fn invariants(&self, state: &[f64], values: &mut Vec<f64>) {
        let w = self.matrix(state);
        let [x, y, z] = self.0.angular_momentum(&w);
        values.extend([self.0.energy(&w), self.0.enstrophy(&w), z]);
        if !self.0.rotates() {
            values.extend([x, y]);
        }
    }

    fn differential(&self, state: &[f64]) -> Vec<f64> {
        let (w, n) = (self.matrix(state), self.size());
        let mut p = LargeSkewHermitian::zeros(n);
        self.0.stream_into(&w, &mut p);
        // h = (2π/N) tr P(W − F), of which P is half of the slope.
        let scale = -4.0 * PI / n as f64;
        (0..n * n).map(|i| scale * p.coordinate(i)).collect()
    }

    fn rate(&self, state: &[f64]) -> Vec<f64> {
        let rate = CommutatorField::new(&self.0).at(&self.matrix(state));
        (0..rate.dimension()).map(|i| rate.coordinate(i)).collect()
    }

    /// A fluid turns by half of its vorticity, here by that of three times its root mean square.
    fn fastest_rate(&self, state: &[f64]) -> f64 {
        1.5 * (self.0.enstrophy(&self.matrix(state)) / (4.0 * PI)).sqrt()
    }

    fn formulations(&self) -> &'static [Formulation] {
        &[Formulation::Reduced, Formulation::Direct]
    }

    fn offers(&self, formulation: Formulation, scheme: SchemeName) -> bool {
        formulation.offers(scheme)
    }

    fn integrator(&self, method: &Method) -> Result<AnyIntegrator, RunFailure> {
        let (formulation, name) = (method.formulation(), method.scheme());
        let impossible = || MethodError::NoSuchPair { formulation, scheme: name };
        let scheme = name.runge_kutta(method.tolerance())?.ok_or_else(impossible)?;
        let period = resumable_after(self.size() * self.size());
        let zero = LargeSkewHermitian::zeros(self.size());
        Ok(match formulation {
            Formulation::Reduced => {
                let reduced = IsospectralRungeKutta::new(scheme, self.0.clone());
                AnyIntegrator::of_states(Renewed { integrator: reduced, period }, &zero, &zero)
            }
            _ => {
                let direct = Direct::new(scheme, CommutatorField::new(self.0.clone()));
                AnyIntegrator::of_states(Renewed { integrator: direct, period }, &zero, &zero)
            }
        })
    }

    fn tangent_integrator(
        &self,
        _method: &Method,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Err(RunFailure::NoTangents { kind: NAME })
    }

    fn start(&self, given: &Given<'_>) -> Started {
        let n = self.size();
        let mut omega = VorticityCoefficients::zeros(n);
        if given.has("omega") {
            given.require_alone("omega", &["coefficients", "degrees", "rms", "seed"])?;
            let values = given.values("omega");
            if values.len() != n * n {
                let needed = format!(
                    "{} numbers, an array of shape [{n}, {n}], got {}",
                    n * n,
                    values.len()
                );
                return Err(given.refused("omega", needed));
            }
            return Ok(values.to_vec());
        }
        if given.has("degrees") {
            let [least, most] = match given.values("degrees") {
                [least, most] => [*least, *most].map(|l| whole(l, [0, n - 1])),
                _ => [None; 2],
            };
            let (Some(least), Some(most), true) = (least, most, least <= most) else {
                let needed = format!(
                    "two whole numbers from 0 to {}, the least first, got {:?}",
                    n - 1,
                    given.values("degrees")
                );
                return Err(given.refused("degrees", needed));
            };
            let mut random = Directions::new(seed(given)?);
            for (l, m) in (least..=most).flat_map(|l| (0..=l).map(move |m| (l, m))) {
                let direction = random.within(PI, &nalgebra::Vector3::z());
                omega.set(l, m, Complex::new(direction.x, direction.y));
            }
            let mean = (self.0.enstrophy(&self.0.vorticity(&omega)) / (4.0 * PI)).sqrt();
            let factor = given.number("rms") / mean;
            omega = VorticityCoefficients::from_fn(n, |l, m| omega.at(l, m) * factor);
        }
        let rows = given.values("coefficients");
        if !rows.len().is_multiple_of(4) || !given.has("degrees") && !given.has("coefficients") {
            let needed =
                format!("rows of four numbers, [l, m, re, im], got {} numbers", rows.len());
            return Err(given.refused("coefficients", needed));
        }
        for [l, m, re, im] in rows.as_chunks::<4>().0 {
            let degree = whole(*l, [0, n - 1]);
            let order = degree.and_then(|l| whole(*m, [0, l]));
            let (Some(l), Some(m)) = (degree, order) else {
                let needed = format!(
                    "degrees l from 0 to {} and orders m from 0 to l, got {l} and {m}",
                    n - 1
                );
                return Err(given.refused("coefficients", needed));
            };
            omega.set(l, m, omega.at(l, m) + Complex::new(*re, *im));
        }
        let mut state = vec![0.0; n * n];
        self.write(&omega, &mut state);
        Ok(state)
    }

    fn present(&self, state: &mut [f64]) {
        let omega = self.0.coefficients(&self.matrix(state));
        self.write(&omega, state);
    }

    fn on_circle(&self, given: &[f64], colatitude: f64, count: usize) -> Option<Vec<f64>> {
        Some(self.read(given).values_on_circle(colatitude, count))
    }

    fn understand(&self, given: &mut [f64]) {
        let w = self.0.vorticity(&self.read(given));
        given.iter_mut().enumerate().for_each(|(i, x)| *x = w.coordinate(i));
    }
}
