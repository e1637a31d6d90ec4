//! Minima of a function of one variable, bracketed, without derivatives: [`Minimum`].

/// The search for a minimum between two ends at which the function is larger than at a point between them.
///
/// It uses parabolas where they are safe, and the golden section elsewhere. The caller evaluates the function, which
/// may fail, at [`next`](Minimum::next) and passes the value to [`insert`](Minimum::insert).
///
/// Source: R. P. Brent, *Algorithms for Minimization without Derivatives* (1973), ch. 5.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Minimum {
    low: f64,
    high: f64,
    /// The three best points with their values, the best first.
    best: [(f64, f64); 3],
    /// The last step and the one before it.
    moves: [f64; 2],
}

/// The part of an interval that a golden section cuts off: (3 − √5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

impl Minimum {
    /// Creates a search in [low, high], from the value at a point between them.
    pub(crate) fn new(low: f64, (x, value): (f64, f64), high: f64) -> Self {
        Self { low, high, best: [(x, value); 3], moves: [0.0; 2] }
    }

    /// Returns the distance below which values differ by rounding only: √ε of the extent of the interval.
    fn resolution(&self) -> f64 {
        f64::EPSILON.sqrt() * self.best[0].0.abs().max(self.high - self.low).max(1e-3)
    }

    /// Returns the next point to evaluate, or `None` once the minimum is known to √ε.
    pub(crate) fn next(&mut self) -> Option<f64> {
        let (x, least) = (self.best[0].0, self.resolution());
        let middle = 0.5 * (self.low + self.high);
        if (x - middle).abs() + 0.5 * (self.high - self.low) <= 2.0 * least {
            return None;
        }
        let vertex = self.parabolic().map(|step| {
            // The values at the ends are known. A vertex next to an end adds no information: the other end is moved
            // instead.
            let known = (x + step - self.low).min(self.high - x - step) < 2.0 * least;
            if known { least.copysign(middle - x) } else { step }
        });
        let step = vertex.unwrap_or_else(|| {
            let far = if x < middle { self.high - x } else { self.low - x };
            // A parabola may follow this move.
            self.moves[0] = far;
            GOLDEN * far
        });
        self.moves = [step, self.moves[0]];
        Some(x + if step.abs() < least { least.copysign(step) } else { step })
    }

    /// Returns the step to the vertex of the parabola through the three best points.
    ///
    /// There is one if the vertex lies inside and the step is less than half of the step before the last.
    fn parabolic(&self) -> Option<f64> {
        let [(x, fx), (w, fw), (v, fv)] = self.best;
        let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
        let step = ((x - w) * r - (x - v) * q) / (2.0 * (q - r));
        let inside = self.low < x + step && x + step < self.high;
        (inside && step.abs() < 0.5 * self.moves[1].abs()).then_some(step)
    }

    /// Inserts the value at the point of [`next`](Minimum::next).
    pub(crate) fn insert(&mut self, u: f64, value: f64) {
        let [first, second, third] = self.best;
        // Of equal values, which differ by less than rounding, the first one stays.
        let (worse, better) = if value < first.1 { (first.0, u) } else { (u, first.0) };
        // The minimum lies on the side of the better point.
        if worse < better {
            self.low = worse
        } else {
            self.high = worse
        }
        if value < first.1 {
            self.best = [(u, value), first, second];
        } else if value <= second.1 || second.0 == first.0 {
            self.best = [first, (u, value), second];
        } else if value <= third.1 || third.0 == first.0 || third.0 == second.0 {
            self.best[2] = (u, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the minimum of f in [−1, 1], from 0, and the number of evaluations.
    fn minimum(f: impl Fn(f64) -> f64) -> (f64, u32) {
        let mut minimum = Minimum::new(-1.0, (0.0, f(0.0)), 1.0);
        let mut evaluations = 0;
        while let Some(x) = minimum.next() {
            minimum.insert(x, f(x));
            evaluations += 1;
            assert!(evaluations < 200);
        }
        (minimum.best[0].0, evaluations)
    }

    #[test]
    fn minima_to_half_of_the_digits_in_a_few_evaluations() {
        for (f, place, most) in [
            ((|x| (x - 0.3) * (x - 0.3)) as fn(f64) -> f64, 0.3, 5),
            (|x: f64| (x - 0.3) * (x - 0.3) * (1.0 + 0.5 * x), 0.3, 10),
            (|x: f64| x * x * x * x - x, 0.25_f64.cbrt(), 12),
            (|x: f64| -(x + 0.4).cos(), -0.4, 9),
            (|x: f64| (x - 0.25).powi(4), 0.25, 18),
            (|x: f64| (x + 0.7).abs(), -0.7, 21),
            (|x: f64| (x + 0.6).abs() * (1.0 + x * x), -0.6, 24),
            (|x: f64| if x < 0.5 { 1.0 - x } else { x + 5.0 }, 0.5, 39),
            (|x: f64| x * x, 0.0, 7),
        ] {
            let (found, evaluations) = minimum(f);
            // a parabola of fourth order is flat to ε over ε^¼
            let tolerance = if place == 0.25 { 1e-3 } else { 1e-7 };
            assert!((found - place).abs() < tolerance, "{found} {place}");
            assert!(evaluations <= most, "{place}: {evaluations}");
        }
    }
}
