//! Logarithmic axes of a panel, in powers of ten.

use crate::pictures::Scale;
use crate::pictures::numerals::power_of_ten;

/// The smallest error that the chart distinguishes; smaller errors are accidents of round-off, and are drawn here.
pub(super) const SMALLEST: f64 = 1e-15;

/// The decades of both axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    /// The decades of the abscissa.
    pub seconds: (i32, i32),
    /// The decades of the ordinate.
    pub error: (i32, i32),
}

impl Axes {
    /// Returns the places of a time and an error along the axes, from 0 to 1.
    pub fn place(&self, seconds: f64, error: f64) -> (f64, f64) {
        (along(self.seconds, seconds), along(self.error, error.max(SMALLEST)))
    }
}

/// Returns the scale of an axis with a tick at every n-th decade; labels show if they have room.
pub(super) fn scale(decades: (i32, i32), every: i32, is_labelled: impl Fn(i32) -> bool) -> Scale {
    let ticks = (decades.0..=decades.1).filter(|decade| decade % every == 0).map(|decade| {
        let label = if is_labelled(decade) { power_of_ten(decade) } else { String::new() };
        (along(decades, 10_f64.powi(decade)), label)
    });
    Scale { ticks: ticks.collect(), ..Scale::default() }
}

fn along((low, high): (i32, i32), value: f64) -> f64 {
    (value.log10() - f64::from(low)) / f64::from(high - low)
}

/// Returns the decades around all values.
pub(super) fn decades(values: impl Iterator<Item = f64>) -> (i32, i32) {
    let logarithms = values.filter(|x| *x > 0.0 && x.is_finite()).map(f64::log10);
    let (low, high) = logarithms
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return (-1, 0);
    }
    let low = low.floor() as i32;
    (low, (high.ceil() as i32).max(low + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_around_the_values() {
        assert_eq!(decades([2e-3, 5.0, f64::NAN, 0.0].into_iter()), (-3, 1));
        assert_eq!(decades([1.0].into_iter()), (0, 1));
        assert_eq!(decades([f64::NAN].into_iter()), (-1, 0));
    }
}
