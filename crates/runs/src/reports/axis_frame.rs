//! The axis of a body whose motion is told, and the direction from which it is counted: [`AxisFrame`].

use heavytop::{HeavyTop, attitude_of_vertical};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};
use nalgebra::Vector3;

/// An axis of the body, and the direction in space about which it precesses: the vertical, or the angular momentum of a body
/// without weight.
#[derive(Clone, Debug)]
pub(super) struct AxisFrame {
    top: HeavyTop,
    /// A right-handed frame of the body, whose third vector is the axis.
    frame: [Vector3<f64>; 3],
    /// Whether the direction is that of the angular momentum.
    is_free: bool,
    /// The rotation of space that makes the direction e₃.
    upright: Quaternion,
}

/// The angles of the axis, rad: Euler angles of the frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisAngles {
    pub precession: f64,
    pub inclination: f64,
    pub spin: f64,
}

impl AxisFrame {
    /// Creates the frame of a top that starts from a state with an attitude.
    pub(super) fn new(top: HeavyTop, start: &Se3Dual, attitude: &Quaternion) -> Self {
        let is_free = top.weight_moment() == 0.0;
        let axis = if is_free { free_axis(&top, start) } else { top.center_of_mass() };
        let frame = frame_about(axis);
        let upright = match is_free {
            true => attitude_of_vertical(&attitude.rotate(&start.0.0)),
            false => Quaternion::one(),
        };
        Self { top, frame, is_free, upright }
    }

    /// Returns the axis in the body.
    pub(super) fn axis(&self) -> Vector3<f64> {
        self.frame[2]
    }

    /// Returns the direction from which the inclination is counted, in the body.
    pub(super) fn direction(&self, Covector(Pair(pi, gamma)): &Se3Dual) -> Vector3<f64> {
        if self.is_free { pi / pi.amax().max(f64::MIN_POSITIVE) } else { *gamma }
    }

    /// Returns the rate of the cosine of the inclination, times a positive number.
    pub(super) fn rate(&self, mu: &Se3Dual) -> f64 {
        let omega = self.top.angular_velocity(&mu.0.0);
        self.axis().dot(&self.direction(mu).cross(&omega))
    }

    /// Returns the angles at a state with an attitude.
    pub(super) fn angles(&self, mu: &Se3Dual, attitude: &Quaternion) -> AxisAngles {
        let [first, second, axis] = &self.frame;
        let direction = self.direction(mu);
        let [x, y, z] = [first, second, axis].map(|v| v.dot(&direction));
        let in_space = (self.upright * *attitude).rotate(axis);
        AxisAngles {
            precession: in_space.x.atan2(-in_space.y),
            inclination: x.hypot(y).atan2(z),
            spin: x.atan2(y),
        }
    }
}

/// Returns a right-handed frame whose third vector is an axis: e₁, e₂ and e₃ about e₃.
pub(super) fn frame_about(axis: Vector3<f64>) -> [Vector3<f64>; 3] {
    // The basis vector that is furthest from the axis.
    let other = Vector3::ith(axis.iamin(), 1.0);
    let first = (other - axis * axis.dot(&other)).normalize();
    [first, axis.cross(&first), axis]
}

/// Returns the principal axis about which a body without weight goes round: that of the moment which differs from two equal
/// ones, or else that of the largest or of the smallest moment, on whose side of the separatrix the motion is.
fn free_axis(top: &HeavyTop, start: &Se3Dual) -> Vector3<f64> {
    let inertia = top.inertia();
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| inertia[a].total_cmp(&inertia[b]));
    let [low, middle, high] = order;
    let is_high = if inertia[low] == inertia[middle] {
        true
    } else if inertia[middle] == inertia[high] {
        false
    } else {
        // L² − 2E I of the middle moment, in units of the momentum.
        let pi = start.0.0 / start.0.0.amax().max(f64::MIN_POSITIVE);
        let part = |axis: usize| pi[axis].powi(2) * (1.0 - inertia[middle] / inertia[axis]);
        part(low) + part(high) > 0.0
    };
    let place = if is_high { high } else { low };
    Vector3::ith(place, if start.0.0[place] < 0.0 { -1.0 } else { 1.0 })
}
