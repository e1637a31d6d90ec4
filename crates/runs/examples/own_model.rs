//! A system of one's own as a model: a spin with an easy axis in a transverse field, h(s) = −K s₃² − B s₁.
//!
//! Its runs have rows, estimates of their errors, checkpoints and tangent vectors, as those of all models.

use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents, Collective};
use core::ops::Range;
use heavytop::methods::{Method, MethodError};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Real, So3, Vector};
use lie_poisson_runs::{Conserved, Experiment, Model, Pace, RunFailure, Schedule};
use momentum_map::HOPF;
use nalgebra::Vector3;

/// The anisotropy K and the field B.
#[derive(Clone, Copy, Debug)]
struct Spin([f64; 2]);

impl<T: Real> Hamiltonian<LiePoisson<So3>, T> for Spin {
    fn value(&self, Covector(s): &Covector<Vector3<T>>) -> T {
        let [k, b] = self.0.map(T::from_f64);
        -(k * s.z * s.z + b * s.x)
    }

    fn differential(&self, Covector(s): &Covector<Vector3<T>>) -> Vector3<T> {
        let [k, b] = self.0.map(T::from_f64);
        Vector3::new(-b, T::from_f64(0.0), -(k * s.z + k * s.z))
    }
}

impl Spin {
    fn at(s: &[f64]) -> Covector<Vector3<f64>> {
        Vector::from_coordinates(|i| s[i])
    }
}

impl SystemScales for Spin {
    fn blocks(&self) -> Vec<Range<usize>> {
        core::iter::once(0..3).collect()
    }

    fn differential(&self, s: &[f64]) -> Vec<f64> {
        Hamiltonian::differential(self, &Self::at(s)).as_slice().to_vec()
    }

    fn fastest_rate(&self, s: &[f64]) -> f64 {
        Hamiltonian::differential(self, &Self::at(s)).norm()
    }
}

impl Conserved for Spin {
    fn names(&self) -> Vec<String> {
        ["h", "length"].map(String::from).to_vec()
    }

    fn append(&self, _time: f64, s: &[f64], values: &mut Vec<f64>) {
        values.extend([self.value(&Self::at(s)), Self::at(s).0.norm()]);
    }

    fn without_value(&self, _time: f64, s: &[f64]) -> String {
        format!("the spin {s:?} is too long")
    }
}

impl Model for Spin {
    fn algebra_name(&self) -> String {
        "so(3)".into()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        vec![("s".into(), ["s1", "s2", "s3"].map(String::from).to_vec())]
    }

    fn conserved(&self, _start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(*self)
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        _start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        let (formulation, scheme) = (method.formulation(), method.scheme());
        let known = scheme.runge_kutta(method.tolerance())?;
        let known = known.ok_or(MethodError::NoSuchPair { formulation, scheme })?;
        Ok(AnyIntegrator::with_tangents(Collective::new(known, HOPF, *self), 3))
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Spin([1.0, 0.2]);
    let start = model.start(&[0.6, 0.0, 0.8])?;
    let method = Method::new("collective".parse()?, "gauss-8".parse()?, 0.0)?;
    let pace = Pace { schedule: Schedule::new(0.1, 100.0)?, every: 100 };
    let run = Experiment { model, start, method, pace, attitude: false };
    let initial = run.initial()?;
    run.follow(None, |moment| -> Result<(), RunFailure> {
        for (value, first) in moment.row[4..].iter().zip(&initial) {
            assert!((value - first).abs() < 1e-12, "{:?}", moment.row);
        }
        println!("t = {:5.1}: s = {:?}", moment.row[0], &moment.row[1..4]);
        Ok(())
    })?;
    println!("estimated error {:?}", run.accuracy(&|| true)?.error);
    Ok(())
}
