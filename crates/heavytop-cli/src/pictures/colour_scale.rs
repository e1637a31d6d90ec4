//! Colours along a scale, from dark to light.

/// The colours of viridis at equal distances.
///
/// Its lightness grows steadily, so that readers who do not see all hues, and prints in black and white, keep the order.
/// Source: S. van der Walt & N. Smith, *mpl-colormaps* (2015), CC0.
const VIRIDIS: [[f64; 3]; 6] = [
    [68.0, 1.0, 84.0],
    [65.0, 68.0, 135.0],
    [42.0, 120.0, 142.0],
    [34.0, 168.0, 132.0],
    [122.0, 209.0, 81.0],
    [253.0, 231.0, 37.0],
];

/// The red and the blue of marks for positive and for negative quantities.
pub(crate) const SIGNS: [[u8; 3]; 2] = [[178, 24, 43], [33, 102, 172]];

/// Returns the red, green and blue (0 to 255) of a value from 0 to 1.
///
/// A value outside the scale has the colour of the nearer end, and NaN that of the lower end.
pub(crate) fn colour(along: f64) -> [u8; 3] {
    let last = VIRIDIS.len() - 1;
    let position = if along > 0.0 { along.min(1.0) * last as f64 } else { 0.0 };
    let index = (position as usize).min(last - 1);
    let part = position - index as f64;
    [0, 1, 2]
        .map(|i| (VIRIDIS[index][i] * (1.0 - part) + VIRIDIS[index + 1][i] * part).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_grows_along_the_scale() {
        // Luma of ITU-R BT.601, which is near the lightness.
        let luma =
            |[r, g, b]: [u8; 3]| 0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b);
        let lumas: Vec<f64> = (0..=50).map(|n| luma(colour(f64::from(n) / 50.0))).collect();
        assert!(lumas.windows(2).all(|pair| pair[0] < pair[1]), "{lumas:?}");
        assert_eq!(
            (colour(-1.0), colour(f64::NAN), colour(7.0)),
            (colour(0.0), colour(0.0), colour(1.0))
        );
    }
}
