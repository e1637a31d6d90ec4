//! The colours of a heat map: their range, and the bar that explains them.

use crate::configuration::{Column, Observable};
use crate::pictures::{Axis, Scale};

/// The colour of what has no value.
pub(super) const NONE: u8 = 190;

/// The fraction of the values, at either end, that may lie outside the range of colours.
const OUTLIERS: f64 = 0.005;

/// The value of MEGNO for regular motion.
const REGULAR: f64 = 2.0;

/// Returns the range of the colours: all values but outliers, and regular motion; `None` where there is no value.
pub(super) fn range(values: &[Option<f64>], column: &Column) -> Option<[f64; 2]> {
    let mut sorted: Vec<f64> = values.iter().copied().flatten().collect();
    sorted.sort_by(f64::total_cmp);
    let outliers = (sorted.len() as f64 * OUTLIERS) as usize;
    let least = *sorted.get(outliers)?;
    let most = *sorted.iter().rev().nth(outliers)?;
    let (least, most) = match is_megno(column) && column.is_logarithmic {
        true => (least.min(REGULAR.log10()), most.max(REGULAR.log10())),
        false => (least, most),
    };
    // The range is not narrowed to round-off, which thus looks constant.
    let size = if column.is_logarithmic { 1.0 } else { least.abs().max(most.abs()) };
    let room = 1e-9 * size;
    Some(match most - least > room {
        true => [least, most],
        false if size > 0.0 => [least - room, least + room],
        false => [-1.0, 1.0],
    })
}

fn is_megno(column: &Column) -> bool {
    Observable::Megno.columns().iter().any(|megno| megno.name == column.name)
}

/// Returns the scale of the bar of colours. MEGNO has a line at regular motion.
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
