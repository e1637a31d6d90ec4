//! Colours along a scale of six.

/// Returns the red, green and blue (0 to 255) of a value from 0 to 1, on a scale of six colours at equal distances.
///
/// A value outside the scale has the colour of the nearer end, and NaN that of the lower end.
pub(crate) fn colour(colours: &[[f64; 3]; 6], along: f64) -> [f64; 3] {
    let last = colours.len() - 1;
    let position = if along > 0.0 { along.min(1.0) * last as f64 } else { 0.0 };
    let index = (position as usize).min(last - 1);
    let part = position - index as f64;
    [0, 1, 2].map(|i| colours[index][i] * (1.0 - part) + colours[index + 1][i] * part)
}
