//! Colours along a scale: from dark to light, and from blue over white to red.

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

/// The colours from blue over white to red at equal distances, for what lies on either side of a value with a meaning.
///
/// Source: C. A. Brewer, *ColorBrewer 2.0*, scheme RdBu, whose ends readers with all kinds of colour vision tell apart.
const BLUE_TO_RED: [[f64; 3]; 11] = [
    [5.0, 48.0, 97.0],
    [33.0, 102.0, 172.0],
    [67.0, 147.0, 195.0],
    [146.0, 197.0, 222.0],
    [209.0, 229.0, 240.0],
    [247.0, 247.0, 247.0],
    [253.0, 219.0, 199.0],
    [244.0, 165.0, 130.0],
    [214.0, 96.0, 77.0],
    [178.0, 24.0, 43.0],
    [103.0, 0.0, 31.0],
];

/// The red and the blue of marks for positive and for negative quantities.
pub(crate) const SIGNS: [[u8; 3]; 2] = [[178, 24, 43], [33, 102, 172]];

/// Returns the red, green and blue (0 to 255) of a value from 0 to 1.
///
/// A value outside the scale has the colour of the nearer end, and NaN that of the lower end.
pub(crate) fn colour(along: f64) -> [u8; 3] {
    between(&VIRIDIS, along)
}

/// Returns the red, green and blue (0 to 255) of a value from −1, blue, over 0, white, to 1, red.
///
/// A value outside the scale has the colour of the nearer end, and NaN that of the lower end.
pub(crate) fn signed_colour(value: f64) -> [u8; 3] {
    between(&BLUE_TO_RED, 0.5 + 0.5 * value)
}

fn between<const N: usize>(colours: &[[f64; 3]; N], along: f64) -> [u8; 3] {
    let last = N - 1;
    let position = if along > 0.0 { along.min(1.0) * last as f64 } else { 0.0 };
    let index = (position as usize).min(last - 1);
    let part = position - index as f64;
    [0, 1, 2]
        .map(|i| (colours[index][i] * (1.0 - part) + colours[index + 1][i] * part).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Luma of ITU-R BT.601, which is near the lightness.
    fn luma([r, g, b]: [u8; 3]) -> f64 {
        0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
    }

    #[test]
    fn lightness_grows_along_the_scale() {
        let lumas: Vec<f64> = (0..=50).map(|n| luma(colour(f64::from(n) / 50.0))).collect();
        assert!(lumas.windows(2).all(|pair| pair[0] < pair[1]), "{lumas:?}");
        assert_eq!(
            (colour(-1.0), colour(f64::NAN), colour(7.0)),
            (colour(0.0), colour(0.0), colour(1.0))
        );
    }

    #[test]
    fn a_scale_of_signs_is_lightest_in_its_middle_and_tells_the_signs() {
        let sides = [-1.0, 1.0].map(|sign| {
            let lumas = (0..=20).map(|n| luma(signed_colour(sign * f64::from(n) / 20.0)));
            lumas.collect::<Vec<_>>()
        });
        for lumas in sides {
            assert!(lumas.windows(2).all(|pair| pair[0] > pair[1]), "{lumas:?}");
        }
        let ([red, _, blue], [other_red, _, other_blue]) =
            (signed_colour(0.5), signed_colour(-0.5));
        assert!(red > blue && other_red < other_blue);
        assert_eq!(signed_colour(0.0), [247; 3]);
        assert_eq!(
            (signed_colour(9.0), signed_colour(-9.0)),
            (signed_colour(1.0), signed_colour(-1.0))
        );
    }
}
