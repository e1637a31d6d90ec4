//! The picture of a section, as SVG.

use super::orbit::Orbit;
use super::survey::Survey;
use crate::pictures::Axis;
use crate::pictures::colour_scale::colour;
use crate::pictures::render::FONT;
use collective_integrators::Direction;
use heavytop::{EnergyLevel, Section, Surface};
use std::f64::consts::TAU;
use std::fmt::Write;

/// The width of the picture, in units of 0.01 mm.
const WIDTH: f64 = 12_000.0;
const HEIGHT: f64 = 10_000.0;
const LEFT: f64 = 1400.0;
const TOP: f64 = 700.0;
const RIGHT: f64 = WIDTH - 450.0;
const BOTTOM: f64 = HEIGHT - 1100.0;

/// The size of the text, 8 pt.
const TEXT: f64 = 282.0;
const RULE: f64 = 14.0;

/// The area that all points together cover, in square units.
const INK: f64 = 1.6e7;

/// The largest diameter of a point.
const LARGEST: f64 = 30.0;

const COLOURS: [[f64; 3]; 6] = [
    [36.0, 44.0, 122.0],
    [26.0, 120.0, 178.0],
    [40.0, 160.0, 130.0],
    [232.0, 170.0, 40.0],
    [214.0, 84.0, 40.0],
    [140.0, 24.0, 84.0],
];

/// The picture of a section, with a colour for each start.
///
/// Starts are ordered by the mean of |y| over their points: those on one invariant curve, or in one
/// chaotic sea, have the same mean, and neighbours have similar ones.
///
/// Source: Z. Levnajić & I. Mezić, *Ergodic theory and visualization. I*, Chaos 20 (2010).
pub(super) struct Picture<'a> {
    section: &'a Section,
    means: &'a [f64],
    /// The least and the largest of the means.
    range: [f64; 2],
    axis: Axis,
    svg: String,
}

impl<'a> Picture<'a> {
    /// Creates the picture without points.
    pub fn begin(section: &'a Section, survey: &'a Survey) -> Self {
        let axis = Axis::around(survey.heights.into_iter(), 6);
        let diameter = (INK / survey.points.max(1) as f64).sqrt().min(LARGEST);
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"{FONT}\" font-size=\"{TEXT}\">\
             <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\
             <g fill=\"none\" stroke-linecap=\"round\" stroke-width=\"{diameter:.1}\">",
            WIDTH / 100.0,
            HEIGHT / 100.0
        );
        let means = &survey.means;
        let range = means
            .iter()
            .fold([f64::INFINITY, 0.0], |[low, high], &mean| [mean.min(low), mean.max(high)]);
        Self { section, means, range, axis, svg }
    }

    /// Adds the points of an orbit.
    pub fn add(&mut self, orbit: &Orbit) {
        let mean = self.means.get(orbit.number.saturating_sub(1)).copied().unwrap_or_default();
        let [low, high] = self.range;
        // If there is one orbit alone, the range is empty, and its colour is the first one.
        let [red, green, blue] = colour(&COLOURS, (mean - low) / (high - low));
        let stroke = format!("rgb({red:.0},{green:.0},{blue:.0})");
        let _ = write!(self.svg, "<path stroke=\"{stroke}\" d=\"");
        for point in &orbit.crossings {
            let x = LEFT + (RIGHT - LEFT) * point.plane.x / TAU;
            let y = BOTTOM - (BOTTOM - TOP) * self.axis.along(point.plane.y);
            // Some viewers drop a line of no length.
            let _ = write!(self.svg, "M{x:.0} {y:.0}h.1");
        }
        self.svg += "\"/>";
    }

    /// Completes the picture, and returns it as SVG.
    pub fn complete(mut self) -> String {
        self.svg += "</g>";
        frame(&mut self.svg, self.section, &self.axis);
        self.svg + "</svg>"
    }
}

// Writing to a string does not fail.

fn frame(svg: &mut String, section: &Section, axis: &Axis) {
    let (width, height) = (RIGHT - LEFT, BOTTOM - TOP);
    let _ = write!(
        svg,
        "<rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{width}\" height=\"{height}\" fill=\"none\" \
         stroke=\"black\" stroke-width=\"{RULE}\"/><g text-anchor=\"middle\">"
    );
    let mut ticks = String::new();
    for (quarter, label) in ["0", "π/2", "π", "3π/2", "2π"].iter().enumerate() {
        let x = LEFT + width * quarter as f64 / 4.0;
        let _ = write!(ticks, "M{x:.0} {BOTTOM}v-90M{x:.0} {TOP}v90");
        let _ = write!(svg, "<text x=\"{x:.0}\" y=\"{}\">{label}</text>", BOTTOM + 380.0);
    }
    svg.push_str("</g><g text-anchor=\"end\">");
    for (value, label) in axis.labels() {
        let y = BOTTOM - height * axis.along(value);
        let _ = write!(ticks, "M{LEFT} {y:.0}h90M{RIGHT} {y:.0}h-90");
        let _ = write!(svg, "<text x=\"{}\" y=\"{:.0}\">{label}</text>", LEFT - 110.0, y + 100.0);
    }
    let _ = write!(svg, "</g><path d=\"{ticks}\" stroke=\"black\" stroke-width=\"{RULE}\"/>");
    lettering(svg, section);
}

/// Rounds a number to six digits.
fn six_digits(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

fn lettering(svg: &mut String, section: &Section) {
    let (middle, centre) = ((LEFT + RIGHT) / 2.0, (TOP + BOTTOM) / 2.0);
    let Surface { coordinate, level, direction } = section.surface();
    let EnergyLevel { energy, vertical_momentum, .. } = section.level();
    let [energy, vertical_momentum, level] = [*energy, *vertical_momentum, *level].map(six_digits);
    let axis = ["₁", "₂", "₃"][coordinate.axis()];
    let (fixed, free, unit) = if coordinate.is_momentum() {
        (format!("Π{axis} = {level} kg m²/s"), format!("Γ{axis}"), "")
    } else {
        (format!("Γ{axis} = {level}"), format!("Π{axis}"), " (kg m²/s)")
    };
    let crossed = match direction {
        Direction::Up => ", increasing",
        Direction::Down => ", decreasing",
        Direction::Both => "",
    };
    let numbers = format!(
        "<tspan font-style='italic'>h</tspan> = {energy} J, Π·Γ = {vertical_momentum} kg m²/s; {fixed}{crossed}"
    );
    let numbers = numbers.replace("= -", "= −");
    let _ = write!(
        svg,
        "<g text-anchor=\"middle\"><text x=\"{middle}\" y=\"{}\">{numbers}</text>\
         <text x=\"{middle}\" y=\"{}\">angle of Γ about e{axis} (rad)</text>\
         <text transform=\"translate(400 {centre}) rotate(-90)\">{free}{unit}</text></g>",
        TOP - 250.0,
        HEIGHT - 260.0,
    );
}
