//! Zeros of a function of one variable, bracketed, without derivatives: [`Bracket`].

/// The search for a zero in a bracket [0, end] with a change of sign.
///
/// It uses inverse quadratic interpolation where it is safe, and bisection elsewhere. The caller evaluates the
/// function, which may fail, at [`next`](Bracket::next) and passes the value to [`insert`](Bracket::insert).
///
/// Source: T. R. Chandrupatla, *A new hybrid quadratic/bisection algorithm for finding the zero of
/// a nonlinear function without using derivatives*, Adv. Eng. Softw. 28 (1997).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// The newest end with its value.
    a: (f64, f64),
    /// The other end, whose value has the other sign.
    b: (f64, f64),
    /// The end that was replaced last.
    c: (f64, f64),
    fraction: f64,
    end: f64,
}

impl Bracket {
    /// Creates a bracket from the values at 0 and at `end`, of different signs or zero.
    pub(crate) fn new(at_zero: f64, end: f64, at_end: f64) -> Self {
        let (a, b) = ((end, at_end), (0.0, at_zero));
        Self { a, b, c: a, fraction: 0.5, end }
    }

    /// Returns the end with the smaller value.
    pub(crate) fn best(&self) -> f64 {
        if self.a.1.abs() < self.b.1.abs() { self.a.0 } else { self.b.0 }
    }

    /// Returns the next point to evaluate, or `None` once the bracket is as narrow as rounding allows or an end is a
    /// zero.
    pub(crate) fn next(&self) -> Option<f64> {
        let width = (self.b.0 - self.a.0).abs();
        let least = f64::EPSILON * (self.best().abs() + 0.25 * self.end.abs());
        if self.a.1 == 0.0 || self.b.1 == 0.0 || width <= 2.0 * least {
            return None;
        }
        let margin = least / width;
        Some(self.a.0 + self.fraction.clamp(margin, 1.0 - margin) * (self.b.0 - self.a.0))
    }

    /// Inserts the value at the point of [`next`](Bracket::next).
    pub(crate) fn insert(&mut self, x: f64, value: f64) {
        if (value > 0.0) == (self.a.1 > 0.0) {
            self.c = self.a;
        } else {
            self.c = self.b;
            self.b = self.a;
        }
        self.a = (x, value);
        self.fraction = self.interpolated().unwrap_or(0.5);
    }

    /// Returns the point of inverse quadratic interpolation, if the parabola is monotone over the bracket.
    fn interpolated(&self) -> Option<f64> {
        let ((a, fa), (b, fb), (c, fc)) = (self.a, self.b, self.c);
        let xi = (a - b) / (c - b);
        let phi = (fa - fb) / (fc - fb);
        let safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        let first = fa / (fb - fa) * fc / (fb - fc);
        let second = (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        safe.then_some(first + second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the zero and the number of evaluations.
    fn zero(f: impl Fn(f64) -> f64, end: f64) -> (f64, u32) {
        let mut bracket = Bracket::new(f(0.0), end, f(end));
        let mut evaluations = 0;
        while let Some(x) = bracket.next() {
            bracket.insert(x, f(x));
            evaluations += 1;
        }
        (bracket.best(), evaluations)
    }

    #[test]
    fn zeros_to_round_off_in_a_few_evaluations() {
        for (f, end, root, most) in [
            ((|x| x - 0.3) as fn(f64) -> f64, 1.0, 0.3, 2),
            (|x: f64| x.cos() - 0.9, 1.0, 0.9_f64.acos(), 9),
            (|x: f64| x.sin() + 0.2, -1.0, -(0.2_f64.asin()), 7),
            (|x: f64| 1e-30 * ((x - 0.1).powi(3)), 1.0, 0.1, 53),
            (|x: f64| if x < 0.7 { -1.0 } else { 1e9 }, 1.0, 0.7, 52),
            (|x: f64| (x - 0.2) * (x + 2.0) * (x + 5.0), 1.0, 0.2, 6),
            (|x: f64| x * x - 3e-4, 1.0, 3e-4_f64.sqrt(), 13),
            (|x: f64| x, 1.0, 0.0, 0),
        ] {
            let (found, evaluations) = zero(f, end);
            assert!((found - root).abs() <= 4e-16, "{found} {root}");
            assert!(evaluations <= most, "{root}: {evaluations}");
        }
    }
}
