//! Logarithmic axes of a panel, in powers of ten.

/// Width and height of a panel, in units of 0.01 mm.
pub(super) const PANEL: (f64, f64) = (5700.0, 5900.0);

/// The smallest error that the chart distinguishes; smaller errors are accidents of round-off, and are drawn here.
pub(super) const SMALLEST: f64 = 1e-15;

/// The decades of both axes, and the corner of a panel.
pub(super) struct Axes {
    /// The decades of the abscissa.
    pub seconds: (i32, i32),
    /// The decades of the ordinate.
    pub error: (i32, i32),
    /// The upper left corner of the panel.
    pub corner: (f64, f64),
}

impl Axes {
    pub fn x(&self, seconds: f64) -> f64 {
        self.corner.0 + PANEL.0 * along(self.seconds, seconds)
    }

    pub fn y(&self, error: f64) -> f64 {
        self.corner.1 + PANEL.1 * (1.0 - along(self.error, error.max(SMALLEST)))
    }
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
