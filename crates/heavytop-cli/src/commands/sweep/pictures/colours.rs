//! The scales of the pictures of a sweep: which logarithms they show, the ends of curves, and the ticks.

use crate::configuration::{Column, Observable};
use crate::pictures::{Axis, Scale};

/// The colour of what has no value.
pub(super) const NONE: u8 = 190;

/// The value of MEGNO for regular motion.
pub(super) const REGULAR: f64 = 2.0;

/// The smallest number whose logarithm is distinguished, relative to the largest number of the picture.
const SMALLEST: f64 = 1e-16;

/// Half of the least range that a curve shows, relative to a value, or in decades: less is round-off.
const LEAST_HALF: f64 = 1e-9;

/// Returns the values, or their decimal logarithms, that a picture shows, and the column with the scale that it then has:
/// where all is zero there are no logarithms. What is no finite number has no value.
pub(super) fn scaled(column: &Column, values: &[Option<f64>]) -> (Column, Vec<Option<f64>>) {
    let numbers = values.iter().flatten().copied().filter(|value| value.is_finite());
    let smallest = SMALLEST * numbers.fold(0.0, f64::max);
    let is_logarithmic = column.is_logarithmic && smallest > 0.0;
    let scaled = |value: f64| if is_logarithmic { value.max(smallest).log10() } else { value };
    let finite = |value: &Option<f64>| value.map(scaled).filter(|value| value.is_finite());
    let scaled = values.iter().map(finite).collect();
    (Column { is_logarithmic, ..column.clone() }, scaled)
}

/// Returns whether a column is MEGNO.
pub(super) fn is_megno(column: &Column) -> bool {
    Observable::Megno.columns().iter().any(|megno| megno.name == column.name)
}

/// Returns the ends of the ordinate of a curve: around all values, and regular motion; `None` where there is no value.
pub(super) fn ends(values: &[Option<f64>], column: &Column) -> Option<[f64; 2]> {
    let regular = (is_megno(column) && column.is_logarithmic).then(|| REGULAR.log10());
    values.iter().flatten().next()?;
    let all = values.iter().copied().flatten().chain(regular);
    let [least, most] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
        [least.min(value), most.max(value)]
    });
    let (half, size) = (most / 2.0 - least / 2.0, least.abs().max(most.abs()));
    // A constant has a scale whose numbers show what it is.
    let room = match column.is_logarithmic {
        true if half < LEAST_HALF => 0.5,
        false if half <= LEAST_HALF * size => {
            if size > 0.0 {
                1e-2 * size
            } else {
                1.0
            }
        }
        _ => 0.1 * half,
    };
    Some([(least - room).max(-f64::MAX), (most + room).min(f64::MAX)])
}

/// Returns the scale of a bar of colours or of an ordinate. MEGNO has a line at regular motion.
pub(super) fn bar_scale(column: &Column, [least, most]: [f64; 2]) -> Scale {
    if !column.is_logarithmic {
        return Scale::linear(&Axis::new(least, most, 6), &column.label, false);
    }
    let scale = Scale::logarithmic([least, most], &column.label);
    if is_megno(column) {
        // Labels are some 4 % of the bar high.
        scale.with_line((REGULAR.log10() - least) / (most - least), "2 (regular)", 0.05)
    } else {
        scale
    }
}
