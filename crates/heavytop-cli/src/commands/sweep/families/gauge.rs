//! The measurements along a motion: [`Gauge`].

use crate::configuration::Observable;
use collective_integrators::diagnostics::InvariantSize;
use heavytop::{HeavyTop, Invariant, Nutation};
use lie_poisson::{DualNumber, Se3Dual, Vector, larger, seed};
use lie_poisson_formula_systems::{Casimir, ScalarFunction};
use lie_poisson_formulas::Formula;
use lie_poisson_runs::{Model, TopInAxes};

/// A conserved quantity, whose deviations are measured.
pub(super) trait Quantity {
    /// Returns the value at a momentum.
    fn value(&self, mu: &[f64]) -> f64;

    /// Writes the coordinates of the differential at a momentum.
    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]);
}

impl Quantity for Formula {
    fn value(&self, mu: &[f64]) -> f64 {
        self.value_at(mu)
    }

    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        self.write_differential(mu, slopes);
    }
}

impl Quantity for Casimir {
    fn value(&self, mu: &[f64]) -> f64 {
        self.value_at(mu)
    }

    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        ScalarFunction::write_differential(self, mu, slopes);
    }
}

/// An invariant of a top.
impl Quantity for (HeavyTop, Invariant) {
    fn value(&self, mu: &[f64]) -> f64 {
        self.1.value(&self.0, &TopInAxes::state(mu))
    }

    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        let mu = TopInAxes::state(mu);
        for (i, slope) in slopes.iter_mut().enumerate() {
            let moved: Se3Dual<DualNumber> = seed(&mu, &Vector::basis(i));
            *slope = self.1.value(&self.0, &moved).derivative();
        }
    }
}

/// The measurements along a motion besides those of its tangent vectors: the deviations of conserved quantities, and the
/// nutation of a top.
pub(super) struct Gauge<'a> {
    model: &'a dyn Model,
    /// The quantity of each column, if the member has one for it.
    quantities: Vec<Option<&'a dyn Quantity>>,
    initial: Vec<f64>,
    drift: Vec<f64>,
    /// The sizes of the quantities along the motion; none if no observable is relative to them.
    sizes: Vec<InvariantSize>,
    /// Space for a differential.
    slopes: Vec<f64>,
    nutation: Option<Nutation>,
    undefined: Option<Vec<f64>>,
}

impl<'a> Gauge<'a> {
    /// Creates the gauge of a motion of a model from a start, with the sizes of the quantities if they are wanted.
    pub fn new(
        model: &'a dyn Model,
        quantities: Vec<Option<&'a dyn Quantity>>,
        (start, wants_sizes): (&[f64], bool),
    ) -> Self {
        let value = |quantity: &Option<&dyn Quantity>| quantity.map_or(0.0, |f| f.value(start));
        let initial = quantities.iter().map(value).collect();
        let drift = vec![0.0; quantities.len()];
        let sized = if wants_sizes { quantities.len() } else { 0 };
        let sizes = (0..sized).map(|_| InvariantSize::new(model.blocks())).collect();
        let mut gauge = Self {
            model,
            quantities,
            initial,
            drift,
            sizes,
            slopes: vec![0.0; start.len()],
            nutation: None,
            undefined: None,
        };
        gauge.include_sizes(start);
        gauge
    }

    /// Measures the nutation of a top, too.
    pub fn with_nutation(mut self, top: &HeavyTop, start: &[f64]) -> Self {
        let mut nutation = Nutation::new(top);
        nutation.observe(0.0, &TopInAxes::state(start));
        self.nutation = Some(nutation);
        self
    }

    /// Returns the first momentum at which a quantity had no finite value.
    pub fn undefined(&self) -> Option<&[f64]> {
        self.undefined.as_deref()
    }

    /// Takes notice of the momentum after a step, at a time (s).
    pub fn observe(&mut self, time: f64, mu: &[f64]) {
        if let Some(nutation) = &mut self.nutation {
            nutation.observe(time, &TopInAxes::state(mu));
        }
        let before = self.drift.iter_mut().zip(&self.initial);
        for ((drift, initial), quantity) in before.zip(&self.quantities) {
            if let Some(quantity) = quantity {
                let value = quantity.value(mu);
                if !value.is_finite() {
                    self.undefined.get_or_insert_with(|| mu.to_vec());
                }
                *drift = larger(*drift, (value - initial).abs());
            }
        }
        self.include_sizes(mu);
    }

    /// Raises the sizes of the quantities to those at a momentum.
    fn include_sizes(&mut self, mu: &[f64]) {
        for (size, quantity) in self.sizes.iter_mut().zip(&self.quantities) {
            if let Some(quantity) = quantity {
                quantity.write_differential(mu, &mut self.slopes);
                size.include(mu, &self.slopes);
            }
        }
    }

    /// Returns the values of the columns of an observable that needs no tangent vectors, at the end of the motion.
    pub fn values(&self, observable: Observable, end: &[f64]) -> Vec<Option<f64>> {
        match observable {
            Observable::FinalState => {
                let mut end = end.to_vec();
                self.model.present(&mut end);
                end.into_iter().map(Some).collect()
            }
            Observable::InvariantDrift => {
                let drifts = self.quantities.iter().zip(&self.drift);
                drifts.map(|(quantity, drift)| quantity.map(|_| *drift)).collect()
            }
            Observable::RelativeDrift => {
                let drifts = self.quantities.iter().zip(self.sizes.iter().zip(&self.drift));
                drifts.map(|(f, (size, drift))| f.map(|_| size.relative(*drift))).collect()
            }
            Observable::RotationNumber => {
                vec![self.nutation.as_ref().and_then(Nutation::rotation_number)]
            }
            Observable::NutationAmplitude => {
                vec![self.nutation.as_ref().and_then(Nutation::amplitude)]
            }
            Observable::Lyapunov | Observable::Megno | Observable::Sali => Vec::new(),
        }
    }
}

/// Returns for each column the place of a Casimir of the column's degree: the n-th Casimir of a degree stands in the n-th
/// column of this degree. If there are as many Casimirs as columns, they stand in their order.
pub(super) fn in_columns(degrees: &[u8], columns: &[u8]) -> Vec<Option<usize>> {
    if degrees.len() == columns.len() {
        return (0..columns.len()).map(Some).collect();
    }
    let of_degree = |degree: u8, n: usize| {
        degrees.iter().enumerate().filter(|(_, own)| **own == degree).map(|(place, _)| place).nth(n)
    };
    let place = |(column, &degree): (usize, &u8)| {
        let before = columns.iter().take(column).filter(|other| **other == degree).count();
        of_degree(degree, before)
    };
    columns.iter().enumerate().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::in_columns;

    #[test]
    fn casimirs_stand_in_columns_of_their_degrees() {
        assert_eq!(in_columns(&[1, 2], &[1, 2]), [Some(0), Some(1)]);
        assert_eq!(in_columns(&[1], &[2]), [Some(0)]);
        assert_eq!(in_columns(&[2], &[1, 2]), [None, Some(0)]);
        assert_eq!(in_columns(&[2, 2, 3], &[2, 3]), [Some(0), Some(2)]);
        assert_eq!(in_columns(&[2, 2], &[2, 2, 2]), [Some(0), Some(1), None]);
        assert_eq!(in_columns(&[], &[2]), [None]);
    }
}
