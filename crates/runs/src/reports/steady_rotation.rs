//! The steady rotations of a top about the vertical: [`SteadyRotation`].

use super::axis_frame::frame_about;
use heavytop::{EnergyLevel, HeavyTop};
use lie_poisson::euclidean_norm;
use nalgebra::{Complex, Matrix2, Matrix3, Matrix6, Vector2, Vector3, Vector6};

/// The number of directions from which steady rotations are searched.
const STARTS: usize = 256;

/// The largest number of Newton steps from one of them.
const MOST_STEPS: usize = 60;

/// The largest part of the size of its terms up to which a gradient is zero by rounding.
const ROUNDING: f64 = 1e-12;

/// The distance of two rotations that are one, rad.
const SAME: f64 = 1e-6;

/// The growth, as a part of the fastest rate, up to which an eigenvalue is imaginary. Double eigenvalues have errors of the
/// square root of rounding errors.
const IMAGINARY: f64 = 1e-5;

/// A steady rotation of a top: it turns about the vertical, which stands still in the body, at a constant rate.
///
/// The rotations with the vertical momentum Π·Γ = b are the critical points of the
/// [amended potential](EnergyLevel::amended_potential) U_b on the sphere |Γ| = 1, with Ω = ωΓ and ω = b/(Γ·IΓ). Sources:
/// O. Staude, J. reine angew. Math. 113 (1894) 318–334; S. Smale, Invent. Math. 10 (1970).
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyRotation {
    /// The vertical in the body, Γ.
    pub vertical: Vector3<f64>,
    /// The rate ω of the rotation about it, rad/s.
    pub rate: f64,
    /// The energy h, J.
    pub energy: f64,
    /// Whether the rotations are a circle about an axis of symmetry, of which `vertical` is one point.
    pub is_circle: bool,
    /// The rate at which small disturbances grow, 1/s; 0 if the rotation is stable in the linear approximation.
    pub growth: f64,
    /// The least angle between the vertical of the run and that of the rotation, rad.
    pub nearest: f64,
    /// The axis of symmetry, if there is one.
    symmetry: Option<Vector3<f64>>,
}

impl SteadyRotation {
    /// Returns the steady rotations of a top with this vertical momentum (kg m²/s), those of least energy first. There are none
    /// of a thin rod, nor of a body without weight and momentum, which rests in every direction, nor of a sphere without
    /// weight, which turns steadily about every axis.
    #[must_use]
    pub fn all(top: &HeavyTop, vertical_momentum: f64) -> Vec<Self> {
        let moments = top.inertia();
        let is_sphere = moments.x == moments.y && moments.y == moments.z;
        let is_any = top.weight_moment() == 0.0 && (vertical_momentum == 0.0 || is_sphere);
        if top.rod_axis().is_some() || is_any {
            return Vec::new();
        }
        let search = Search { top, momentum: vertical_momentum };
        let symmetry = axis_of_symmetry(top);
        let level = EnergyLevel { top: *top, energy: 0.0, vertical_momentum };
        let mut found: Vec<Self> = Vec::new();
        for start in (0..STARTS).map(direction) {
            let Some(mut vertical) = search.critical_point(start) else { continue };
            let across = symmetry.map(|axis| vertical - axis * axis.dot(&vertical));
            let is_circle = across.is_some_and(|across| euclidean_norm(&across) > SAME);
            if let (Some(axis), true) = (symmetry, is_circle) {
                // One point stands for the circle.
                let ([first, ..], along) = (frame_about(axis), axis * axis.dot(&vertical));
                vertical = along + first * euclidean_norm(&(vertical - along));
            }
            if found.iter().any(|other| (other.vertical - vertical).norm() < SAME) {
                continue;
            }
            let rate = vertical_momentum / moments.component_mul(&vertical).dot(&vertical);
            let growth = growth(top, &vertical, rate);
            let energy = level.amended_potential(&vertical);
            let nearest = f64::INFINITY;
            found.push(Self { vertical, rate, energy, is_circle, growth, nearest, symmetry });
        }
        found.sort_by(|one, other| one.energy.total_cmp(&other.energy));
        found
    }

    /// Learns how near a vertical of the run is.
    pub(super) fn observe(&mut self, vertical: &Vector3<f64>) {
        let angle = match self.symmetry.filter(|_| self.is_circle) {
            Some(axis) => (inclination(vertical, &axis) - inclination(&self.vertical, &axis)).abs(),
            None => inclination(vertical, &self.vertical),
        };
        self.nearest = self.nearest.min(angle);
    }
}

/// Returns the angle between two directions, rad.
fn inclination(one: &Vector3<f64>, other: &Vector3<f64>) -> f64 {
    one.cross(other).norm().atan2(one.dot(other))
}

/// Returns the axis about which two moments are equal, and on which the centre of mass is; none of a sphere without weight.
fn axis_of_symmetry(top: &HeavyTop) -> Option<Vector3<f64>> {
    let is_sphere = top.inertia().x == top.inertia().y && top.inertia().y == top.inertia().z;
    match top.axial_component() {
        _ if is_sphere => Some(top.center_of_mass()).filter(|_| top.weight_moment() > 0.0),
        Some(axis) => Some(Vector3::ith(axis, 1.0)),
        None => None,
    }
}

/// Returns one of [`STARTS`] directions that are spread over the sphere, on a spiral of the golden angle.
fn direction(number: usize) -> Vector3<f64> {
    let height = 1.0 - (2 * number + 1) as f64 / STARTS as f64;
    let (sine, cosine) = (2.399_963_229_728_653 * number as f64).sin_cos();
    let radius = (1.0 - height * height).sqrt();
    Vector3::new(radius * cosine, radius * sine, height)
}

/// The search for critical points of the amended potential.
struct Search<'a> {
    top: &'a HeavyTop,
    momentum: f64,
}

impl Search<'_> {
    /// Returns the gradient of U and the size of its terms, and the second derivatives, without the condition |Γ| = 1.
    fn derivatives(&self, gamma: &Vector3<f64>) -> (Vector3<f64>, f64, Matrix3<f64>) {
        let weight = self.top.center_of_mass() * self.top.weight_moment();
        let moments = self.top.inertia().component_mul(gamma);
        // b²/(2s) with s = Γ·IΓ; the factors are kept apart, since their products may overflow.
        let moment = moments.dot(gamma);
        let rate = self.momentum / moment;
        let kinetic = moments * rate * rate;
        let second = moments * moments.transpose() * (4.0 / moment * rate * rate)
            - Matrix3::from_diagonal(&self.top.inertia()) * (rate * rate);
        (weight - kinetic, weight.norm() + kinetic.norm(), second)
    }

    /// Returns the critical point to which Newton's iteration goes from a direction.
    fn critical_point(&self, mut gamma: Vector3<f64>) -> Option<Vector3<f64>> {
        for _ in 0..MOST_STEPS {
            let (gradient, size, second) = self.derivatives(&gamma);
            let frame = frame_about(gamma);
            let slope = Vector2::from_fn(|i, _| frame[i].dot(&gradient) / size);
            if slope.norm() <= ROUNDING {
                return Some(gamma);
            }
            let radial = gradient.dot(&gamma);
            let curvature = Matrix2::from_fn(|i, j| {
                let own = if i == j { radial } else { 0.0 };
                (frame[i].dot(&(second * frame[j])) - own) / size
            });
            // The iteration of nalgebra does not end with what is no number.
            if !(slope.norm() + curvature.norm()).is_finite() {
                return None;
            }
            let eigen = curvature.symmetric_eigen();
            // Along a circle of critical points there is no slope to follow.
            let along = eigen.eigenvectors.transpose() * slope;
            let part = |i: usize| match eigen.eigenvalues[i] {
                value if value.abs() < SAME => 0.0,
                value => -along[i] / value,
            };
            let step = eigen.eigenvectors * Vector2::new(part(0), part(1));
            let step = step * (0.5 / step.norm().max(0.5));
            gamma = (gamma + frame[0] * step.x + frame[1] * step.y).normalize();
        }
        None
    }
}

/// Returns the rate at which small disturbances of a steady rotation grow, 1/s.
///
/// They obey dδΠ/dt = δΠ × Ω + Π × I⁻¹δΠ + m g l δΓ × c and dδΓ/dt = δΓ × Ω + Γ × I⁻¹δΠ, with Ω = ωΓ and Π = IΩ. Two
/// eigenvalues of this Hamiltonian matrix A are 0, for the Casimirs, and the others are ±√x and ±√y, with x + y = tr A²/2 and
/// x² + y² = tr A⁴/2.
fn growth(top: &HeavyTop, vertical: &Vector3<f64>, rate: f64) -> f64 {
    let (moments, weight) = (top.inertia(), top.weight_moment());
    // In units of the largest moment and of the fastest rate all entries are of the order of 1.
    let unit = moments.max();
    let fastest = rate.abs().max((weight / unit).sqrt());
    let (moments, rate, weight) =
        (moments / unit, rate / fastest, weight / unit / fastest / fastest);
    let omega = vertical * rate;
    let pi = moments.component_mul(&omega);
    let disturbed = |delta: Vector6<f64>| {
        let (of_pi, of_gamma) =
            (delta.fixed_rows::<3>(0).into_owned(), delta.fixed_rows::<3>(3).into_owned());
        let of_omega = of_pi.component_div(&moments);
        let first = of_pi.cross(&omega)
            + pi.cross(&of_omega)
            + of_gamma.cross(&top.center_of_mass()) * weight;
        let second = of_gamma.cross(&omega) + vertical.cross(&of_omega);
        Vector6::new(first.x, first.y, first.z, second.x, second.y, second.z)
    };
    let columns: [Vector6<f64>; 6] = core::array::from_fn(|i| disturbed(Vector6::ith(i, 1.0)));
    let squared = Matrix6::from_columns(&columns).pow(2);
    let (sum, squares) = (squared.trace() / 2.0, squared.pow(2).trace() / 2.0);
    // x and y are sum/2 ± half the root of what follows.
    let difference = Complex::from(2.0 * squares - sum * sum).sqrt();
    let rates = [difference, -difference].map(|part| ((part + sum) / 2.0).sqrt());
    let largest = rates[0].norm().max(rates[1].norm());
    let growing = rates[0].re.max(rates[1].re);
    if growing > IMAGINARY * largest { growing * fastest } else { 0.0 }
}
