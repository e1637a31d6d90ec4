//! The picture of a section, as SVG.

use super::orbits::orbit::Orbit;
use super::plane_range::Abscissa;
use super::problems::section_problem::Drawing;
use super::settings::Settings;
use super::survey::Survey;
use crate::errors::Error;
use crate::pictures::charts::frame::HEIGHT;
use crate::pictures::charts::scaled_chart::Chart;
use crate::pictures::colour_scale::colour;
use crate::pictures::{Axis, Frame, Scale};
use plotters::style::RGBColor;
use svg_pictures::SvgElement;

/// The area that all points together cover, in square units.
const INK: f64 = 1.6e7;

/// The largest diameter of a point.
const LARGEST: f64 = 30.0;

/// The part of the colour scale that is used; its lightest colours do not show on white.
const DARK: f64 = 0.82;

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
    across: Abscissa,
    diameter: f64,
    frame: Frame,
    chart: Chart<'static>,
}

impl<'a> Picture<'a> {
    /// Creates the picture without points.
    ///
    /// # Errors
    /// If the caption cannot be drawn.
    pub fn begin(settings: &Settings, survey: &'a Survey) -> Result<Self, Error> {
        let drawing = settings.problem.drawing(&settings.limits);
        let Drawing { mut caption, abscissa: (title, _), ordinate: (free, unit) } = drawing;
        let (axis, outside) = (survey.plane.ordinate(), survey.plane.outside);
        caption.extend(
            (outside > 0).then(|| {
                format!("{outside} of {} points are outside of the limits", survey.points)
            }),
        );
        let means = &survey.means;
        let extremes = means
            .iter()
            .fold([f64::INFINITY, 0.0], |[low, high], &mean| [mean.min(low), mean.max(high)]);
        let [low, high] = if means.is_empty() { [0.0, 1.0] } else { extremes };
        let range = Axis::new(low, high, 6);
        let quantity = format!("{free}{unit}");
        let bar = Scale::linear(&range, &format!("mean of |{free}| over a start{unit}"), false);
        let frame =
            Frame::new(HEIGHT, &caption, Scale::linear(&axis, &quantity, false), Some(bar))?;
        let (across, abscissa) = survey.plane.abscissa(&title, frame.length());
        let diameter =
            (INK / survey.points.saturating_sub(outside).max(1) as f64).sqrt().min(LARGEST);
        let chart = frame.chart(abscissa)?;
        Ok(Self { means, range, axis, across, diameter, frame, chart })
    }

    /// Adds the points of an orbit.
    ///
    /// # Errors
    /// If plotters cannot draw them.
    pub fn add(&mut self, orbit: &Orbit) -> Result<(), Error> {
        let mean = self.means.get(orbit.number.saturating_sub(1)).copied().unwrap_or_default();
        let [red, green, blue] = colour(DARK * self.range.along(mean));
        let place = |[x, y]: [f64; 2]| (self.across.along(x), self.axis.along(y));
        let is_inside = |(x, y): &(f64, f64)| [x, y].iter().all(|at| (0.0..=1.0).contains(*at));
        let points = orbit.crossings.iter().map(|point| place(point.plane));
        let points: Vec<_> = points.filter(is_inside).collect();
        let dots = SvgElement::dots(points, RGBColor(red, green, blue), self.diameter);
        self.chart.draw_series([dots])?;
        Ok(())
    }

    /// Completes the picture, and returns it as SVG.
    ///
    /// # Errors
    /// If a label cannot be drawn.
    pub fn complete(self) -> Result<String, Error> {
        self.frame.complete(self.chart, |along| colour(DARK * along))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::charts::frame::WIDTH;
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
        survey.points = 2;
        [-1.3, 1.3].into_iter().for_each(|y| survey.plane.include([2.0 + y, y * size]));
        survey.means = vec![0.2 * size, 0.9 * size];
        Picture::begin(&settings, &survey).unwrap().complete().unwrap()
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
            let mut survey = survey.clone();
            [-1.3, 1.3].into_iter().for_each(|y| survey.plane.include([1.1 * y * size, y]));
            let drawing = Picture::begin(&settings, &survey).unwrap().complete().unwrap();
            assert_eq!(collisions(&drawing, (WIDTH.into(), HEIGHT.into())), [""; 0], "{size}");
            let texts = texts(&drawing);
            let has = |part: &str| texts.iter().any(|text| text.contains(part));
            assert!(has("Π₁ + Π₂") && has("Π₃") && has("Γ₃ = 0, increasing"), "{texts:?}");
        }
    }

    /// A formula that is longer than its axis ends in an ellipsis there, and is whole in the caption and in the description.
    #[test]
    fn long_formulas_are_whole_in_the_caption_and_in_the_description() {
        let axis = ["Pi1^2*Gamma3"; 12].join(" + ");
        let text = format!(
            "system.algebra = 'se(3)'\nsystem.hamiltonian = '|Pi|^2 + Gamma3 + {}'\n\
             section.surface = 'Gamma3'\nsection.axes = ['{axis}', 'Pi3']\n\
             system.initial = {{ Pi = [1, 2, 3], Gamma = [0, 0, 1] }}",
            ["Gamma1^2"; 100].join(" + ")
        );
        let settings = Settings::of(&toml::from_str(&text).unwrap()).unwrap();
        let mut survey = Survey::new(&settings);
        [-1.3, 1.3].into_iter().for_each(|y| survey.plane.include([y, y]));
        let drawing = Picture::begin(&settings, &survey).unwrap().complete().unwrap();
        assert_eq!(collisions(&drawing, (WIDTH.into(), HEIGHT.into())), [""; 0]);
        let texts = texts(&drawing);
        assert!(texts.iter().any(|text| text.starts_with("Π₁²*Γ₃") && text.ends_with('…')));
        let count = |text: &str, part: &str| text.matches(part).count();
        let (_, description) = drawing.split_once("<desc>").unwrap();
        let (description, _) = description.split_once("</desc>").unwrap();
        assert_eq!((count(description, "Γ₁²"), count(description, "Π₁²*Γ₃")), (100, 12));
        let caption: Vec<&str> =
            texts.iter().map(String::as_str).filter(|text| !text.ends_with(")")).collect();
        assert!(count(&caption.join(" "), "Γ₁²") < 100);
    }

    #[test]
    fn labels_are_apart_and_differ_at_every_scale() {
        for size in [1e-20, 2e-4, 1e-3, 1.0, 1e4, 1e20] {
            for surface in ["Gamma3", "Pi1"] {
                let drawing = picture(size, surface);
                assert_eq!(collisions(&drawing, (WIDTH.into(), HEIGHT.into())), [""; 0], "{size}");
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
