//! Vorticities, and states of paths.

use lie_poisson_systems::collective_integrators::{BrownianPaths, PathAndTime};
use lie_poisson_systems::isospectral_flows::LargeSkewHermitian;
use lie_poisson_systems::lie_poisson::{Pair, PathNumber, State, Time, larger};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};

pub type Coefficients = VorticityCoefficients;

/// Returns a vorticity with the degrees from the least to the largest one, of about the size 1.
pub fn eddies(size: usize, [least, most]: [usize; 2]) -> Coefficients {
    Coefficients::from_fn(size, |l, m| {
        let x = (7 * l + m) as f64;
        let value = Complex::new((3.1 * x).sin(), (5.3 * x).cos()) / l.max(1) as f64;
        if (least..=most).contains(&l) { value } else { Complex::ZERO }
    })
}

pub fn scaled(omega: &Coefficients, s: f64) -> Coefficients {
    Coefficients::from_fn(omega.size(), |l, m| omega.at(l, m) * s)
}

/// Returns the largest distance of coefficients.
pub fn distance(a: &Coefficients, b: &Coefficients) -> f64 {
    let all = (0..a.size()).flat_map(|l| (0..=l).map(move |m| (l, m)));
    all.map(|(l, m)| (a.at(l, m) - b.at(l, m)).norm()).fold(0.0, larger)
}

pub fn on_path(w: LargeSkewHermitian, path: u64) -> Pair<LargeSkewHermitian, PathAndTime<f64>> {
    Pair(w, Pair(PathNumber(path as f64), Time(0.0)))
}

pub fn paths(interval: f64) -> BrownianPaths {
    BrownianPaths::new(11, interval).unwrap()
}

pub fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

/// Returns the largest change of the Casimirs tr(−iW/|W|)ᵏ, k = 1 … N.
pub fn drift(fluid: &Zeitlin, start: &LargeSkewHermitian, end: &LargeSkewHermitian) -> f64 {
    let casimirs = |w: &LargeSkewHermitian| {
        let mut w = w.clone();
        w.scale_in_place(1.0 / start.norm());
        let count = w.size() as f64 / (4.0 * std::f64::consts::PI);
        fluid.casimirs(&w, w.size()).into_iter().map(move |c| c * count)
    };
    casimirs(start).zip(casimirs(end)).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}
