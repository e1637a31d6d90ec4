//! Outlines of glyphs.
//!
//! Source: *OpenType specification*, `glyf` — Glyph Data Table.

use super::bytes::Bytes;

/// A part of an outline; points are in units of the font, with y upwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Segment {
    Move([f64; 2]),
    Line([f64; 2]),
    /// A quadratic Bézier curve: its control point, and its end.
    Curve([f64; 2], [f64; 2]),
    Close,
}

/// A point of a contour; beside the curve are the control points.
#[derive(Debug, Clone, Copy)]
struct Point {
    place: [f64; 2],
    is_on_curve: bool,
}

/// What the flags of a point mean.
mod point {
    pub const ON_CURVE: u8 = 1;
    /// The coordinate has one byte. Then the other flag is its sign, and else that it is that of the point before.
    pub const SHORT: [u8; 2] = [2, 4];
    pub const SAME_OR_POSITIVE: [u8; 2] = [16, 32];
    pub const REPEATED: u8 = 8;
}

/// What the flags of a part of a composite glyph mean.
mod part {
    pub const WORDS: u16 = 1;
    pub const OFFSETS: u16 = 2;
    pub const SCALED: u16 = 8 | 64 | 128;
    pub const MORE: u16 = 32;
}

/// How deep composite glyphs may be within composite glyphs.
const DEEPEST: usize = 8;

/// Returns the outline of a glyph, empty for a space; `None` if it cannot be read.
///
/// `data` gives the data of a glyph by its number. Parts of composite glyphs are moved, but not scaled; no glyph of
/// these fonts has scaled parts.
pub(crate) fn outline(glyph: u16, data: &dyn Fn(u16) -> Option<Bytes>) -> Option<Vec<Segment>> {
    let mut outline = Vec::new();
    add(glyph, [0.0; 2], data, DEEPEST, &mut outline)?;
    Some(outline)
}

fn add(
    glyph: u16,
    offset: [f64; 2],
    data: &dyn Fn(u16) -> Option<Bytes>,
    deepest: usize,
    outline: &mut Vec<Segment>,
) -> Option<()> {
    let bytes = data(glyph)?;
    if bytes.0.is_empty() {
        return Some(());
    }
    // The number of contours and a box come first.
    let (contours, bytes) = (bytes.i16(0)?, bytes.from(10)?);
    if let Ok(contours) = usize::try_from(contours) {
        return simple(contours, offset, bytes, outline);
    }
    let (mut at, deepest) = (0, deepest.checked_sub(1)?);
    loop {
        let (flags, glyph) = (bytes.u16(at)?, bytes.u16(at + 2)?);
        let moved = match flags & part::WORDS {
            0 => [bytes.u8(at + 4)? as i8, bytes.u8(at + 5)? as i8].map(f64::from),
            _ => [bytes.i16(at + 4)?, bytes.i16(at + 6)?].map(f64::from),
        };
        if flags & part::OFFSETS == 0 || flags & part::SCALED != 0 {
            return None;
        }
        add(glyph, [offset[0] + moved[0], offset[1] + moved[1]], data, deepest, outline)?;
        if flags & part::MORE == 0 {
            return Some(());
        }
        at += if flags & part::WORDS == 0 { 6 } else { 8 };
    }
}

/// Adds the outline of a glyph with contours of its own.
fn simple(
    contours: usize,
    offset: [f64; 2],
    bytes: Bytes,
    outline: &mut Vec<Segment>,
) -> Option<()> {
    let ends = (0..contours).map(|n| bytes.u16(2 * n).map(|end| usize::from(end) + 1));
    let ends = ends.collect::<Option<Vec<_>>>()?;
    let count = ends.last().copied().unwrap_or(0);
    let instructions = usize::from(bytes.u16(2 * contours)?);
    let mut at = 2 * contours + 2 + instructions;

    let mut flags = Vec::with_capacity(count);
    while flags.len() < count {
        let flag = bytes.u8(at)?;
        at += 1;
        let mut times = 1;
        if flag & point::REPEATED != 0 {
            times += usize::from(bytes.u8(at)?);
            at += 1;
        }
        flags.resize(flags.len() + times, flag);
    }
    let mut points: Vec<_> = flags[..count]
        .iter()
        .map(|flag| Point { place: offset, is_on_curve: flag & point::ON_CURVE != 0 })
        .collect();
    for axis in 0..2 {
        let mut coordinate = 0_i32;
        for (point, flag) in points.iter_mut().zip(&flags) {
            let is_same_or_positive = flag & point::SAME_OR_POSITIVE[axis] != 0;
            if flag & point::SHORT[axis] != 0 {
                let change = i32::from(bytes.u8(at)?);
                at += 1;
                coordinate += if is_same_or_positive { change } else { -change };
            } else if !is_same_or_positive {
                coordinate += i32::from(bytes.i16(at)?);
                at += 2;
            }
            point.place[axis] += f64::from(coordinate);
        }
    }
    let mut start = 0;
    for end in ends {
        contour(points.get(start..end)?, outline);
        start = end;
    }
    Some(())
}

/// Adds a closed contour. Halfway between two control points is a point on the curve.
fn contour(points: &[Point], outline: &mut Vec<Segment>) {
    let [first, middle @ .., last] = points else { return };
    let halfway = |a: [f64; 2], b: [f64; 2]| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    let (start, rest) = match (first.is_on_curve, last.is_on_curve) {
        (true, _) => (first.place, &points[1..]),
        (false, true) => (last.place, &points[..=middle.len()]),
        (false, false) => (halfway(first.place, last.place), points),
    };
    outline.push(Segment::Move(start));
    let mut control = None;
    for point in rest {
        match (point.is_on_curve, control.take()) {
            (true, None) => outline.push(Segment::Line(point.place)),
            (true, Some(control)) => outline.push(Segment::Curve(control, point.place)),
            (false, before) => {
                if let Some(before) = before {
                    outline.push(Segment::Curve(before, halfway(before, point.place)));
                }
                control = Some(point.place);
            }
        }
    }
    if let Some(control) = control {
        outline.push(Segment::Curve(control, start));
    }
    outline.push(Segment::Close);
}
