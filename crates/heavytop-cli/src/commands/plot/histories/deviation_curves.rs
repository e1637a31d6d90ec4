//! How far the conserved quantities of a run are from their start: [`DeviationCurves`].

use super::thinned::Thinned;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::Scale;
use crate::pictures::symbols::symbol;

/// The decimal logarithm of the least deviation that is drawn: less is round-off of what is not 0, or exactly 0.
const LEAST: f64 = -17.0;

/// The deviations of conserved quantities, relative to the start.
#[derive(Clone, Debug, Default)]
pub(super) struct DeviationCurves {
    /// The names, and the points (t, decimal logarithm).
    pub curves: Vec<(String, Vec<(f64, f64)>)>,
}

impl DeviationCurves {
    /// Reads the deviations of these quantities. That of a quantity that starts from 0 is absolute, and its name says so.
    ///
    /// # Errors
    /// If they cannot be read.
    pub fn read(run: &RunArrays, names: &[String]) -> Result<Self, Error> {
        let arrays: Vec<_> = names.iter().map(|name| (name.clone(), Vec::new())).collect();
        let mut curves = vec![Thinned::upper_bound(run.times.len()); names.len()];
        let mut starts = Vec::new();
        run.each(&arrays, |number, values| {
            if number == 0 {
                starts = values.to_vec();
            } else {
                for ((curve, value), start) in curves.iter_mut().zip(values).zip(&starts) {
                    let size = if *start == 0.0 { 1.0 } else { start.abs() };
                    let logarithm = ((value - start).abs() / size).log10().max(LEAST);
                    curve.push(run.time(number), logarithm);
                }
            }
            Ok(true)
        })?;
        let named = |((name, curve), start): ((&String, Thinned), &f64)| {
            let symbol = symbol(name);
            let name = if *start == 0.0 { format!("{symbol}, absolute") } else { symbol };
            (name, curve.complete())
        };
        Ok(Self { curves: names.iter().zip(curves).zip(&starts).map(named).collect() })
    }

    /// Returns the decimal logarithms at the ends of the ordinate.
    pub fn ends(&self) -> [f64; 2] {
        let values = self.curves.iter().flat_map(|(_, points)| points).map(|point| point.1);
        let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
            [least.min(x), most.max(x)]
        });
        let least = if least.is_finite() { least.floor() } else { LEAST };
        // A curve along an edge would be hidden by it.
        [least - 0.3, most.ceil().max(least + 1.0) + 0.3]
    }

    /// Returns the ordinate.
    pub fn scale(&self) -> Scale {
        Scale::logarithmic(self.ends(), "relative deviation")
    }
}
