//! The marks in a drawing of the program, whose text and lines are all paths.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::tiny_skia::Pixmap;

/// The rectangle around a mark.
#[derive(Clone, Debug)]
pub struct Outline {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Outline {
    /// Returns the rectangle around the points of a path.
    pub fn of(path: &str) -> Self {
        let numbers = numbers_of(path);
        let points = numbers.as_chunks::<2>().0;
        let ends = |index: usize| {
            let values = points.iter().map(|point| point[index]);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        let ((left, right), (top, bottom)) = (ends(0), ends(1));
        Self { left, right, top, bottom }
    }

    pub fn width(&self) -> f64 {
        self.right - self.left
    }
}

/// Returns the data of the paths with these attributes.
pub fn paths(svg: &str, attributes: &str) -> Vec<String> {
    let has = |line: &&str| line.contains("<path ") && line.contains(attributes);
    let data = |line: &str| Some(line.split_once(" d=\"")?.1.split_once('"')?.0.to_owned());
    svg.lines().filter(has).filter_map(data).collect()
}

/// Returns the numbers of a path.
pub fn numbers_of(path: &str) -> Vec<f64> {
    path.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// Returns the data of the lines of a colour and of a width, in units of 0.01 mm.
pub fn lines(svg: &str, colour: &str, width: u32) -> Vec<String> {
    let of_width = format!(" stroke-width=\"{width}\"");
    let svg: String = svg.split_inclusive('\n').filter(|line| line.contains(&of_width)).collect();
    paths(&svg, &format!("fill=\"none\" stroke=\"{colour}\""))
}

/// Returns the closed black lines: the edges of fields, and of maps.
pub fn outlines(svg: &str) -> Vec<Outline> {
    let is_closed = |path: &&String| {
        let points = numbers_of(path);
        let points = points.as_chunks::<2>().0;
        path.ends_with('Z') || points.first() == points.last()
    };
    lines(svg, "#000000", 14).iter().filter(is_closed).map(|path| Outline::of(path)).collect()
}

/// Returns the colours of the pixels of the first image, in rows from the top.
pub fn colours(svg: &str) -> Vec<[u8; 3]> {
    let data = svg.split_once("data:image/png;base64,").unwrap().1.split_once('"').unwrap().0;
    let data: String = data.chars().filter(|c| !c.is_whitespace()).collect();
    let pixels = Pixmap::decode_png(&STANDARD.decode(data).unwrap()).unwrap();
    let colours = pixels.pixels().iter();
    colours.map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect()
}
