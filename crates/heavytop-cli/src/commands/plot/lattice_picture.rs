//! The picture of a plane of a lattice of spins.

use super::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::raster::{bar, image, pixels, range};
use crate::pictures::{Axis, Frame, Scale};
use std::fmt::Write;

/// The largest number of arrows along an axis.
const ARROWS: usize = 32;

/// Draws the spins of a sample at one index of the third axis, the middle one unless it is given: the third components as
/// colours, the others as arrows.
///
/// # Errors
/// If the sample cannot be read, or there is no such plane.
pub(super) fn lattice_picture(
    run: &mut RunArrays,
    sample: usize,
    plane: Option<usize>,
) -> Result<String, Error> {
    let (name, shape) = run.first();
    let [nx, ny, nz] = match shape[..] {
        [nx, ny, _] => [nx, ny, 1],
        [nx, ny, nz, _] => [nx, ny, nz],
        _ => return Err(Error::Figure(format!("{name} has no planes"))),
    };
    let plane = plane.unwrap_or(nz / 2);
    if plane >= nz {
        let range = "below the number of planes";
        return Err(Error::OutOfRange { name: "plane", range, value: plane as f64 });
    }
    let spins = run.sample(sample)?;
    let spins = spins.as_chunks::<3>().0;
    let spin =
        |x: usize, y: usize| spins.get((x * ny + y) * nz + plane).copied().unwrap_or_default();
    let lengths = spins.iter().map(|s| s.iter().map(|x| x * x).sum::<f64>().sqrt());
    let most = lengths.fold(f64::MIN_POSITIVE, f64::max);
    let from_top = (0..ny).rev().flat_map(|y| (0..nx).map(move |x| (x, y)));
    let cells: Vec<Option<f64>> = from_top.map(|(x, y)| Some(spin(x, y)[2])).collect();

    let range = range(cells.iter().flatten().copied());
    let axis = |count: usize| Axis::new(-0.5, count as f64 - 0.5, 5);
    let ordinate = Scale::linear(&axis(ny), "second index", false);
    let scale = Scale::linear(&Axis::new(range[0], range[1], 4), &format!("{name}₃"), false);
    let time = run.times.get(sample).copied().unwrap_or_default();
    let what = match nz {
        1 => format!("t = {time} s"),
        _ => format!("plane {plane} of {nz}, t = {time} s"),
    };
    let frame = Frame::new(&run.caption(what), ordinate, Some(scale));
    let abscissa = Scale::linear(&axis(nx), "first index", false);
    let mut svg = Frame::begin();
    let across = (frame.left, frame.right);
    let size = [nx as u32, ny as u32];
    image(&mut svg, &frame, across, &pixels(size, &cells, Some(range), 255)?);
    arrows(&mut svg, &frame, [nx, ny], |x, y| {
        let [first, second, _] = spin(x, y);
        [first / most, second / most]
    });
    bar(&mut svg, &frame, range)?;
    frame.draw(&mut svg, &abscissa);
    Ok(svg + "</svg>")
}

/// Draws an arrow for each spin of the plane, or for some of many.
fn arrows(
    svg: &mut String,
    frame: &Frame,
    [nx, ny]: [usize; 2],
    spin: impl Fn(usize, usize) -> [f64; 2],
) {
    let strides = [nx, ny].map(|count| count.div_ceil(ARROWS).max(1));
    let (width, height) = (frame.right - frame.left, frame.bottom - frame.top);
    let cell = [width / nx as f64, height / ny as f64];
    let length = 0.9 * (cell[0] * strides[0] as f64).min(cell[1] * strides[1] as f64);
    let mut path = String::new();
    for x in (strides[0] / 2..nx).step_by(strides[0]) {
        for y in (strides[1] / 2..ny).step_by(strides[1]) {
            let [first, second] = spin(x, y).map(|part| part * length);
            let centre = [
                frame.left + cell[0] * (x as f64 + 0.5),
                frame.bottom - cell[1] * (y as f64 + 0.5),
            ];
            let tip = [centre[0] + 0.5 * first, centre[1] - 0.5 * second];
            // The head is two lines at 25° from the shaft. Writing to a string does not fail.
            let head = |side: f64| {
                let (sin, cos) = (side * 25_f64.to_radians()).sin_cos();
                let back = [-0.3 * first, 0.3 * second];
                [back[0] * cos - back[1] * sin, back[0] * sin + back[1] * cos]
            };
            let ([a, b], [c, d]) = (head(1.0), head(-1.0));
            let _ = write!(
                path,
                "M{:.0} {:.0}L{:.0} {:.0}l{a:.0} {b:.0}M{:.0} {:.0}l{c:.0} {d:.0}",
                centre[0] - 0.5 * first,
                centre[1] + 0.5 * second,
                tip[0],
                tip[1],
                tip[0],
                tip[1]
            );
        }
    }
    for (colour, width) in [("white", 34), ("black", 14)] {
        let _ = write!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
        );
    }
}
