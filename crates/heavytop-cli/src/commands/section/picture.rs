//! The picture of a section, as SVG.

use super::orbits::orbit::Orbit;
use super::problems::section_problem::Drawing;
use super::settings::Settings;
use super::survey::Survey;
use crate::pictures::colour_scale::colour;
use crate::pictures::{Axis, Frame, Scale};
use std::f64::consts::TAU;
use std::fmt::Write;

/// The area that all points together cover, in square units.
const INK: f64 = 1.6e7;

/// The largest diameter of a point.
const LARGEST: f64 = 30.0;

/// The part of the colour scale that is used; its lightest colours do not show on white.
const DARK: f64 = 0.82;

/// The number of colours of the bar.
const SHADES: u32 = 64;

/// The picture of a section, with a colour for each start.
///
/// Starts are ordered by the mean of |y| over their points: those on one invariant curve, or in one
/// chaotic sea, have the same mean, and neighbours have similar ones.
///
/// Source: Z. Levnajić & I. Mezić, *Ergodic theory and visualization. I*, Chaos 20 (2010).
pub(super) struct Picture<'a> {
    means: &'a [f64],
    /// The range of the means.
    range: Axis,
    axis: Axis,
    /// The title of the abscissa, and its axis unless it is an angle.
    abscissa: (String, Option<Axis>),
    frame: Frame,
    svg: String,
}

impl<'a> Picture<'a> {
    /// Creates the picture without points.
    pub fn begin(settings: &Settings, survey: &'a Survey) -> Self {
        let drawing = settings.problem.drawing(&settings.limits);
        let Drawing { caption, abscissa: (title, is_angle), ordinate: (free, unit) } = drawing;
        let axis = Axis::around(survey.heights.into_iter(), 6);
        let means = &survey.means;
        let extremes = means
            .iter()
            .fold([f64::INFINITY, 0.0], |[low, high], &mean| [mean.min(low), mean.max(high)]);
        let [low, high] = if means.is_empty() { [0.0, 1.0] } else { extremes };
        let range = Axis::new(low, high, 6);
        let quantity = format!("{free}{unit}");
        let bar = Scale::linear(&range, &format!("mean of |{free}| over a start{unit}"), false);
        let frame = Frame::new(&caption, Scale::linear(&axis, &quantity, false), Some(bar));
        let across = (!is_angle)
            .then(|| Axis::around_along_line(survey.widths.into_iter(), 6, frame.length()));
        let diameter = (INK / survey.points.max(1) as f64).sqrt().min(LARGEST);
        let mut svg = Frame::begin();
        shades(&mut svg, &frame);
        let _ = write!(
            svg,
            "<g fill=\"none\" stroke-linecap=\"round\" stroke-width=\"{diameter:.1}\">"
        );
        Self { means, range, axis, abscissa: (title, across), frame, svg }
    }

    /// Adds the points of an orbit.
    pub fn add(&mut self, orbit: &Orbit) {
        let mean = self.means.get(orbit.number.saturating_sub(1)).copied().unwrap_or_default();
        let [red, green, blue] = colour(DARK * self.range.along(mean));
        let _ = write!(self.svg, "<path stroke=\"rgb({red},{green},{blue})\" d=\"");
        let Frame { left, right, top, bottom, .. } = self.frame;
        for point in &orbit.crossings {
            let [x, y] = point.plane;
            let x = match &self.abscissa.1 {
                Some(across) => left + (right - left) * across.along(x),
                None => left + (right - left) * x / TAU,
            };
            let y = bottom - (bottom - top) * self.axis.along(y);
            // Some viewers drop a line of no length.
            let _ = write!(self.svg, "M{x:.0} {y:.0}h.1");
        }
        self.svg += "\"/>";
    }

    /// Completes the picture, and returns it as SVG.
    pub fn complete(mut self) -> String {
        self.svg += "</g>";
        let (title, across) = self.abscissa;
        let abscissa = match across {
            Some(across) => Scale::linear(&across, &title, false),
            None => {
                let labels = ["0", "π/2", "π", "3π/2", "2π"].into_iter().map(String::from);
                let ticks = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().zip(labels).collect();
                Scale { ticks, title, line: None }
            }
        };
        self.frame.draw(&mut self.svg, &abscissa);
        self.svg + "</svg>"
    }
}

// Writing to a string does not fail.

/// Fills the bar of colours.
fn shades(svg: &mut String, frame: &Frame) {
    let (left, right) = frame.bar();
    let height = (frame.bottom - frame.top) / f64::from(SHADES);
    for n in 0..SHADES {
        let [red, green, blue] = colour(DARK * (f64::from(n) + 0.5) / f64::from(SHADES));
        let y = frame.bottom - height * f64::from(n + 1);
        // A bit higher than it is, which closes the seams.
        let _ = write!(
            svg,
            "<rect x=\"{left:.0}\" y=\"{y:.1}\" width=\"{:.0}\" height=\"{:.1}\" \
             fill=\"rgb({red},{green},{blue})\"/>",
            right - left,
            height + if n > 0 { 10.0 } else { 0.0 }
        );
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::frame::{HEIGHT, WIDTH};
    use crate::pictures::lettering::checks::{collisions, texts};

    /// A picture of a top whose angular momenta are of this size, in kg m²/s.
    fn picture(size: f64, surface: &str) -> String {
        let text = format!(
            "body = {{ inertia = [{0:e}, {1:e}, {2:e}], mass = {size:e}, gravity = 1.0 }}\n\
             initial.angular_momentum = [{0:e}, 0.0, {0:e}]\nsection.surface = '{surface}'",
            2.0 * size,
            1.5 * size,
            size
        );
        let config: Config = toml::from_str(&text).unwrap();
        let settings = Settings::of(&config).unwrap();
        let mut survey = Survey::new(&settings);
        (survey.points, survey.heights) = (2, [-1.3 * size, 1.3 * size]);
        survey.means = vec![0.2 * size, 0.9 * size];
        Picture::begin(&settings, &survey).complete()
    }

    #[test]
    fn labels_of_a_system_are_apart() {
        let text = "system.algebra = 'se(3)'\nsystem.hamiltonian = '|Pi|^2 + |Gamma|^2'\n\
                    section.surface = 'Gamma3'\nsection.axes = ['Pi1 + (Pi2)', 'Pi3']\n\
                    system.initial = { Pi = [1, 2, 3], Gamma = [0, 0, 1] }";
        let settings = Settings::of(&toml::from_str(text).unwrap()).unwrap();
        let mut survey = Survey::new(&settings);
        (survey.points, survey.means) = (2, vec![0.2, 0.9]);
        for size in [1e-20, 1.0, 1e20] {
            (survey.widths, survey.heights) = ([-1.4 * size, 1.4 * size], [-1.3, 1.3]);
            let drawing = Picture::begin(&settings, &survey).complete();
            assert_eq!(collisions(&drawing, (WIDTH, HEIGHT)), [""; 0], "{size}");
            let texts = texts(&drawing);
            let has = |part: &str| texts.iter().any(|text| text.contains(part));
            assert!(has("Pi1 + Pi2") && has("Pi3") && has("Gamma3 = 0, increasing"), "{texts:?}");
        }
    }

    #[test]
    fn labels_are_apart_and_differ_at_every_scale() {
        for size in [1e-20, 2e-4, 1e-3, 1.0, 1e4, 1e20] {
            for surface in ["Gamma3", "Pi1"] {
                let drawing = picture(size, surface);
                assert_eq!(collisions(&drawing, (WIDTH, HEIGHT)), [""; 0], "{size}");
                let texts = texts(&drawing);
                let has = |part: &str| texts.iter().any(|text| text.contains(part));
                assert!(
                    has("reduced, gauss-8, step ") && has("60 starts, 500 returns"),
                    "{texts:?}"
                );
                assert!(has("mean of |") && has("angle of Γ about e"), "{texts:?}");
            }
        }
        let texts = texts(&picture(1e-20, "Gamma3"));
        assert!(texts.iter().any(|text| text == "Π₃ (10⁻²⁰ kg m²/s)"), "{texts:?}");
    }
}
