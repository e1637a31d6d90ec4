//! Where the names of curves have room beside them: [`CurveLabels`].

/// A rectangle: left, top, right, bottom.
type Room = [f64; 4];

/// The distance of a name from its curve, as a multiple of the size of the text.
const APART: f64 = 0.6;

/// The number of points of a piece of a curve that are kept free of names.
const POINTS: usize = 24;

/// Finds room for names beside curves, so that no name covers another one or a curve.
///
/// Places are in units of the drawing, from the upper left corner of the field.
#[derive(Clone, Debug)]
pub(super) struct CurveLabels {
    field: (f64, f64),
    size: f64,
    /// The points of the curves.
    points: Vec<(f64, f64)>,
    taken: Vec<Room>,
}

impl CurveLabels {
    /// Creates the empty field of this width and height, for text of this size and these curves.
    pub fn new(field: (f64, f64), size: f64, curves: &[Vec<(f64, f64)>]) -> Self {
        let pieces = curves.iter().flat_map(|curve| curve.windows(2));
        let points = pieces.flat_map(|pair| {
            (0..=POINTS).filter_map(move |n| {
                let ([one, other], part) = (pair.first_chunk::<2>()?, n as f64 / POINTS as f64);
                let between = |a: f64, b: f64| a * (1.0 - part) + b * part;
                Some((between(one.0, other.0), between(one.1, other.1)))
            })
        });
        Self { field, size, points: points.collect(), taken: Vec::new() }
    }

    /// Returns the left end and the middle height of a name of this width beside a curve, as near to its middle as there is
    /// room; where there is none, in the upper right corner below the other names there.
    pub fn place(&mut self, curve: &[(f64, f64)], width: f64) -> (f64, f64) {
        let middle = curve.len() as f64 / 2.0;
        let mut order: Vec<usize> = (0..curve.len()).collect();
        order.sort_by(|a, b| {
            let distance = |index: usize| (index as f64 - middle).abs();
            distance(*a).total_cmp(&distance(*b))
        });
        let apart = APART * self.size;
        let beside = order.into_iter().filter_map(|index| curve.get(index)).flat_map(|&(x, y)| {
            let heights = [0.0, -0.8, 0.8, -1.6, 1.6].map(|up| y + up * self.size);
            heights.into_iter().flat_map(move |y| [(x + apart, y), (x - apart - width, y)])
        });
        let room = |&(left, y): &(f64, f64)| self.is_free(self.around((left, y), width));
        let corner = (0..)
            .map(|row| (self.field.0 - width - apart, (1.0 + 1.5 * f64::from(row)) * self.size));
        let is_apart = |&(left, y): &(f64, f64)| !self.is_taken(self.around((left, y), width));
        let place = beside.clone().find(room).or_else(|| corner.take(99).find(is_apart));
        let place = place.unwrap_or((0.0, 0.0));
        self.taken.push(self.around(place, width));
        place
    }

    fn around(&self, (left, y): (f64, f64), width: f64) -> Room {
        let half = 0.6 * self.size;
        [left, y - half, left + width, y + half]
    }

    fn is_free(&self, [left, top, right, bottom]: Room) -> bool {
        let inside = left >= 0.0 && top >= 0.0 && right <= self.field.0 && bottom <= self.field.1;
        let covers = |&(x, y): &(f64, f64)| x >= left && x <= right && y >= top && y <= bottom;
        inside && !self.is_taken([left, top, right, bottom]) && !self.points.iter().any(covers)
    }

    fn is_taken(&self, [left, top, right, bottom]: Room) -> bool {
        let meets = |other: &Room| {
            left < other[2] && other[0] < right && top < other[3] && other[1] < bottom
        };
        self.taken.iter().any(meets)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cover_neither_each_other_nor_a_curve() {
        // Curves so near to each other that names have room only at their sides and ends.
        let curve =
            |shift: f64| (0..9).map(|n| (3.0 + shift + f64::from(n), f64::from(2 * n))).collect();
        let curves: Vec<Vec<(f64, f64)>> = [0.0, 0.3, 0.6, 0.9].map(curve).into();
        let mut labels = CurveLabels::new((30.0, 20.0), 1.0, &curves);
        let places: Vec<_> = curves.iter().map(|curve| labels.place(curve, 4.0)).collect();
        let boxes: Vec<Room> = places.into_iter().map(|place| labels.around(place, 4.0)).collect();
        for (n, one) in boxes.iter().enumerate() {
            for other in &boxes[..n] {
                let is_apart = one[0] >= other[2]
                    || other[0] >= one[2]
                    || one[1] >= other[3]
                    || other[1] >= one[3];
                assert!(is_apart, "{one:?} {other:?}");
            }
            let inside =
                |&(x, y): &(f64, f64)| x > one[0] && x < one[2] && y > one[1] && y < one[3];
            assert!(!curves.iter().flatten().any(inside), "{one:?}");
        }
    }

    #[test]
    fn without_room_names_are_in_the_corner() {
        let curve = vec![(0.0, 0.0), (0.0, 20.0)];
        let wall: Vec<Vec<(f64, f64)>> =
            (0..60).map(|n| vec![(f64::from(n) / 2.0, 0.0), (f64::from(n) / 2.0, 20.0)]).collect();
        let mut labels = CurveLabels::new((30.0, 20.0), 1.0, &wall);
        let (first, second) = (labels.place(&curve, 4.0), labels.place(&curve, 4.0));
        assert_eq!((first, second), ((25.4, 1.0), (25.4, 2.5)));
    }
}
