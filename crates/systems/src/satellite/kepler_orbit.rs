//! The motion on an ellipse about a centre of attraction: [`KeplerOrbit`].

use crate::error::{SystemError, require_finite, require_positive, require_within};
use lie_poisson::{Mask, Real};
use std::f64::consts::PI;

/// The most steps of Newton's iteration. It falls to the root and shortens the distance to a simple root by a third at
/// worst, so that some twenty suffice for eccentricities that differ from 1 by a unit of round-off.
const MOST_STEPS: usize = 64;

/// The largest eccentricity, the number before 1.
const LARGEST: f64 = 1.0 - f64::EPSILON / 2.0;

/// An orbit on an ellipse in the field of a centre of attraction, by Kepler's laws.
///
/// With the mean motion n = √(GM/a³), the eccentricity e and the time t₀ of the pericentre, the eccentric anomaly E and
/// the ratio u = r/a of the distance to the semi-major axis obey
///
/// ```text
/// E − e sin E = n (t − t₀),    u = 1 − e cos E
/// dν/dt = n √(1 − e²)/u²,      GM/r³ = n²/u³
/// ```
///
/// where ν is the true anomaly, the angle from the pericentre seen from the centre. The turn of the satellite about the
/// centre, dν/dt, and the strength GM/r³ of the tide are all that acts on its attitude.
///
/// Source: J. M. A. Danby, *Fundamentals of Celestial Mechanics*, 2nd ed. (1988), ch. 6.
///
/// # Example
/// An eccentric orbit is fastest at its pericentre, where both numbers have closed forms:
/// ```
/// use lie_poisson_systems::KeplerOrbit;
/// let orbit = KeplerOrbit::new(2.0, 0.5, 10.0)?;
/// let (rate, tide) = (orbit.rate(10.0), orbit.tide(10.0));
/// assert!((rate - 2.0 * 0.75_f64.sqrt() / 0.25).abs() < 1e-14 && (tide - 4.0 / 0.125).abs() < 1e-13);
/// // after half a period, at the apocentre
/// let later = 10.0 + std::f64::consts::PI / 2.0;
/// assert!((orbit.tide(later) - 4.0 / 3.375).abs() < 1e-14);
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeplerOrbit {
    mean_motion: f64,
    eccentricity: f64,
    pericentre: f64,
}

impl KeplerOrbit {
    /// Creates an orbit from the mean motion n (rad/s), the eccentricity e, and a time t₀ at which the satellite is at
    /// the pericentre (s).
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the mean motion and its square are positive, 0 ≤ e < 1, and every number is
    /// finite.
    pub fn new(mean_motion: f64, eccentricity: f64, pericentre: f64) -> Result<Self, SystemError> {
        require_rate("mean motion", "square of the mean motion", mean_motion)?;
        require_within("eccentricity", eccentricity, [0.0, LARGEST])?;
        require_finite("time of the pericentre", pericentre)?;
        Ok(Self { mean_motion, eccentricity, pericentre })
    }

    /// Creates the orbit on which the satellite has the mean anomaly M = −n t₀ (rad) at the time 0.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), or that the anomaly is not finite.
    pub fn from_mean_anomaly(
        mean_motion: f64,
        eccentricity: f64,
        anomaly: f64,
    ) -> Result<Self, SystemError> {
        require_finite("mean anomaly", anomaly)?;
        Self::new(mean_motion, eccentricity, -anomaly / mean_motion)
    }

    /// Creates the orbit on which the satellite has the true anomaly ν (rad) at the time 0, for which
    /// tan(E/2) = √((1 − e)/(1 + e)) tan(ν/2) and M = E − e sin E.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), or that the anomaly is not finite.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_systems::KeplerOrbit;
    /// let orbit = KeplerOrbit::from_true_anomaly(1e-3, 0.3, 2.0)?;
    /// assert!((orbit.true_anomaly(0.0) - 2.0).abs() < 1e-14);
    /// # Ok::<(), lie_poisson_systems::SystemError>(())
    /// ```
    pub fn from_true_anomaly(
        mean_motion: f64,
        eccentricity: f64,
        anomaly: f64,
    ) -> Result<Self, SystemError> {
        require_finite("true anomaly", anomaly)?;
        let Self { eccentricity: e, .. } = Self::new(mean_motion, eccentricity, 0.0)?;
        let (sine, cosine) = (0.5 * anomaly).sin_cos();
        let eccentric = 2.0 * (sine * (1.0 - e).sqrt()).atan2(cosine * (1.0 + e).sqrt());
        Self::from_mean_anomaly(mean_motion, e, eccentric - e * eccentric.sin())
    }

    /// Returns the mean motion n, rad/s: 2π divided by the period.
    #[must_use]
    pub const fn mean_motion(&self) -> f64 {
        self.mean_motion
    }

    /// Returns the eccentricity e.
    #[must_use]
    pub const fn eccentricity(&self) -> f64 {
        self.eccentricity
    }

    /// Returns the time t₀ of a pericentre, s.
    #[must_use]
    pub const fn pericentre(&self) -> f64 {
        self.pericentre
    }

    /// Returns the eccentric anomaly E at a time (s), in \[−π, π\].
    ///
    /// Newton's iteration for f(E) = (1 − e) E + e (E − sin E) − M with 0 ≤ M ≤ π starts where f is not negative. There
    /// f is convex and increases, so that the iterates fall to the root, for every eccentricity below 1.
    pub fn eccentric_anomaly<T: Real>(&self, time: T) -> T {
        let turned = (time - self.pericentre) * self.mean_motion;
        // The mean anomaly in [−π, π], with all digits of small ones.
        let mean = turned.sin().atan2(turned.cos());
        let size = mean.select_nonnegative(mean, -mean);
        let anomaly = self.solve(size);
        mean.select_nonnegative(anomaly, -anomaly)
    }

    /// Returns the root of f for a mean anomaly M in [0, π].
    fn solve<T: Real>(&self, mean: T) -> T {
        let e = self.eccentricity;
        let step = |anomaly: T| {
            let square = anomaly * anomaly;
            // E − sin E = E³ c₃(E²) and 1 − cos E = E² c₂(E²) have no cancellation.
            let sine = anomaly * square * square.stumpff(3);
            let slope = square * square.stumpff(2) * e + (1.0 - e);
            anomaly - (anomaly * (1.0 - e) + sine * e - mean) / slope
        };
        let least = |x: T, y: T| T::select(x.at_most(y), x, y);
        // All three are above the root: f(M + e) = e (1 − sin E), f(π) = π − M and f(M/(1 − e)) = e (E − sin E).
        let start = least(mean + e, mean / (1.0 - e));
        let mut anomaly = least(start, T::from_f64(PI));
        let mut solved = T::Mask::from_bool(false);
        for _ in 0..MOST_STEPS {
            let next = step(anomaly);
            solved = solved.or(anomaly.at_most(next));
            // Each lane ends at the step at which it would end alone.
            anomaly = T::select(solved, anomaly, next);
            if solved.all() {
                break;
            }
        }
        // The values have converged. A step makes the first derivatives exact, and two make the second ones exact.
        step(step(anomaly))
    }

    /// Returns the true anomaly ν at a time (s), in \[−π, π\].
    pub fn true_anomaly<T: Real>(&self, time: T) -> T {
        let half = self.eccentric_anomaly(time) * 0.5;
        let (e, sine, cosine) = (self.eccentricity, half.sin(), half.cos());
        (sine * (1.0 + e).sqrt()).atan2(cosine * (1.0 - e).sqrt()) * 2.0
    }

    /// Returns the angular velocity dν/dt of the satellite about the centre at a time (s), rad/s.
    pub fn rate<T: Real>(&self, time: T) -> T {
        self.rate_at(self.distance(self.eccentric_anomaly(time)))
    }

    /// Returns the strength GM/r³ of the tide at a time (s), 1/s².
    pub fn tide<T: Real>(&self, time: T) -> T {
        self.tide_at(self.distance(self.eccentric_anomaly(time)))
    }

    /// Returns the tide at the pericentre, n²/(1 − e)³.
    pub(crate) fn strongest_tide(&self) -> f64 {
        self.tide_at(1.0 - self.eccentricity)
    }

    /// Returns dν/dt (rad/s) and GM/r³ (1/s²) at a time (s), each with its derivative with respect to time.
    pub fn rate_and_tide<T: Real>(&self, time: T) -> [[T; 2]; 2] {
        let anomaly = self.eccentric_anomaly(time);
        let distance = self.distance(anomaly);
        // d ln u/dt, with dE/dt = n/u
        let growth = anomaly.sin() * self.eccentricity / distance
            * (T::from_f64(self.mean_motion) / distance);
        let (rate, tide) = (self.rate_at(distance), self.tide_at(distance));
        [[rate, rate * growth * -2.0], [tide, tide * growth * -3.0]]
    }

    /// Returns u = r/a at an eccentric anomaly, as (1 − e) + 2e sin²(E/2), which has no cancellation.
    fn distance<T: Real>(&self, anomaly: T) -> T {
        let sine = (anomaly * 0.5).sin();
        sine * sine * (2.0 * self.eccentricity) + (1.0 - self.eccentricity)
    }

    fn rate_at<T: Real>(&self, distance: T) -> T {
        let e = self.eccentricity;
        let ratio = ((1.0 - e) * (1.0 + e)).sqrt();
        T::from_f64(self.mean_motion * ratio) / (distance * distance)
    }

    fn tide_at<T: Real>(&self, distance: T) -> T {
        T::from_f64(self.mean_motion * self.mean_motion) / distance.powi(3)
    }
}

/// Checks that an angular velocity is positive, and that its square, which is a tide, is too.
pub(crate) fn require_rate(
    name: &'static str,
    square: &'static str,
    value: f64,
) -> Result<(), SystemError> {
    require_positive(name, value)?;
    require_positive(square, value * value)
}
