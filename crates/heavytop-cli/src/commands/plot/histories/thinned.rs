//! The points of a curve against time, of which a long run has more than a picture can show: [`Thinned`].

/// The number of parts of the time of which each has a column of pixels of its own, or nearly so.
const COLUMNS: usize = 1000;

/// The number of parts of an upper bound, which shows no oscillations.
const BOUNDS: usize = 200;

/// The points of a curve; of a long one the lowest and the highest of each part of the time, so that no peak is lost.
#[derive(Clone, Debug)]
pub(super) struct Thinned {
    /// The number of samples in a part.
    stride: usize,
    with_lowest: bool,
    /// The lowest and the highest point of the part that is not complete, each with its number.
    extremes: Option<[(usize, (f64, f64)); 2]>,
    count: usize,
    points: Vec<(f64, f64)>,
}

impl Thinned {
    /// Creates a curve for so many samples.
    pub fn new(samples: usize) -> Self {
        let stride = samples.div_ceil(COLUMNS).max(1);
        let (extremes, count, points) = (None, 0, Vec::new());
        Self { stride, with_lowest: true, extremes, count, points }
    }

    /// Creates a curve for so many samples that is the upper bound of all of them.
    pub fn upper_bound(samples: usize) -> Self {
        let stride = samples.div_ceil(BOUNDS).max(1);
        Self { with_lowest: false, stride, ..Self::new(samples) }
    }

    /// Adds the point of the next sample.
    pub fn push(&mut self, time: f64, value: f64) {
        let point = (self.count, (time, value));
        let [lowest, highest] = self.extremes.get_or_insert([point; 2]);
        if value < lowest.1.1 {
            *lowest = point;
        }
        if value > highest.1.1 {
            *highest = point;
        }
        self.count += 1;
        if self.count.is_multiple_of(self.stride) {
            self.end_part();
        }
    }

    /// Returns the points, in the order of time.
    pub fn complete(mut self) -> Vec<(f64, f64)> {
        self.end_part();
        self.points
    }

    fn end_part(&mut self) {
        let Some([(at_lowest, lowest), (at_highest, highest)]) = self.extremes.take() else {
            return;
        };
        if !self.with_lowest || at_lowest == at_highest {
            return self.points.push(highest);
        }
        let is_rise = at_lowest < at_highest;
        self.points.extend(if is_rise { [lowest, highest] } else { [highest, lowest] });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thinned(mut curve: Thinned, values: impl Iterator<Item = f64>, step: f64) -> Vec<f64> {
        for (number, value) in values.enumerate() {
            curve.push(step * number as f64, value);
        }
        let points = curve.complete();
        assert!(points.is_sorted_by(|a, b| if step > 0.0 { a.0 < b.0 } else { a.0 > b.0 }));
        points.into_iter().map(|point| point.1).collect()
    }

    #[test]
    fn a_short_curve_keeps_all_points_and_a_long_one_its_peaks() {
        let wave = |n: i32| f64::from(n % 77 * (n % 77) % 77) - 30.0;
        for step in [0.1, -0.1] {
            let short: Vec<f64> = (0..900).map(wave).collect();
            assert_eq!(thinned(Thinned::new(900), (0..900).map(wave), step), short);
            let with_peaks = |n: i32| if n == 4321 { 1e3 } else { wave(n) };
            let peaks = || (0..123_456).map(with_peaks);
            let long = thinned(Thinned::new(123_456), peaks(), step);
            assert!(long.len() <= 2 * COLUMNS && long.len() > COLUMNS, "{}", long.len());
            assert!(long.contains(&1e3) && long.contains(&-30.0));
            let above = thinned(Thinned::upper_bound(123_456), peaks(), step);
            assert!(above.len() <= BOUNDS && above.iter().all(|value| *value > 40.0));
        }
    }
}
