//! States of paths, and what they keep.

use crate::examples::casimirs;
use isospectral_flows::collective_integrators::PathAndTime;
use isospectral_flows::lie_poisson::{Pair, PathNumber, State, Time, larger};
use isospectral_flows::{IsospectralField, LargeSkewHermitian};

pub type Large = LargeSkewHermitian;

pub fn on_path(w: Large, path: u64) -> Pair<Large, PathAndTime<f64>> {
    Pair(w, Pair(PathNumber(path as f64), Time(0.0)))
}

/// Returns the largest change of the [`casimirs`].
pub fn drift(start: &Large, end: &Large) -> f64 {
    let of = |w| casimirs(w, start.norm());
    let changes = of(start).into_iter().zip(of(end)).map(|(a, b)| (a - b).abs());
    changes.fold(0.0, larger)
}

/// No drift, on matrices of a size.
pub struct Still(pub usize);

impl IsospectralField for Still {
    fn size(&self) -> usize {
        self.0
    }

    fn generator_into(&self, _: &Large, generator: &mut Large) {
        generator.set_zero();
    }
}
