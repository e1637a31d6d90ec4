//! Inertia matrices, their principal axes, and moments about the centre of mass.

use collective_integrators::{Integrator, Start};
use heavytop::{
    Body, HeavyTop, PrincipalAxes, TopError, WithAttitude, attitude_of_vertical, point_inertia,
    require_possible_body,
};
use lie_poisson::{Pair, Quaternion, Se3Dual, Vector};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Rotations spread over SO(3), the same ones each time.
fn rotations() -> impl Iterator<Item = Matrix3<f64>> {
    let roots = [0.754_877_666, 0.569_840_291, 0.430_159_709];
    let turn = move |n: u32| roots.map(|root| (f64::from(n) * root).fract() * 6.2 - 3.1);
    (1..60).map(turn).map(|[a, b, c]| Rotation3::from_euler_angles(a, b, c).into_inner())
}

/// Moments of a generic body, of a symmetric one, of nearly equal ones, of a sphere, a flat body and a thin rod.
const MOMENTS: [[f64; 3]; 6] = [
    [1.0, 1.7, 2.2],
    [2.0, 2.0, 1.0],
    [1.0, 1.0 + 1e-13, 1.0 - 1e-13],
    [1.4, 1.4, 1.4],
    [1.0, 2.0, 3.0],
    [0.0, 1.0, 1.0],
];

/// A diag(I) Aᵀ is the matrix, A is a rotation, and the moments are those that were put in, whatever the unit.
#[test]
fn a_matrix_is_that_of_its_moments_along_its_axes() {
    for scale in [1.0, 1e-30, 1e30, 1e-290, 1e290] {
        for (moments, rotation) in MOMENTS.iter().flat_map(|m| rotations().map(move |r| (m, r))) {
            let moments = Vector3::from(*moments);
            let matrix = rotation * Matrix3::from_diagonal(&moments) * rotation.transpose();
            let found = PrincipalAxes::of(&(matrix * scale)).unwrap();
            let axes = found.rotation();
            // Some ten roundings of entries of size 1.
            let near = |a: &Matrix3<f64>, b: &Matrix3<f64>| (a - b).amax() < 5e-15;
            assert!(near(&(axes * axes.transpose()), &Matrix3::identity()), "{axes}");
            assert!((axes.determinant() - 1.0).abs() < 1e-14);
            let again =
                axes * Matrix3::from_diagonal(&(found.moments() / scale)) * axes.transpose();
            assert!(near(&again, &matrix), "{moments} {scale:e}: {again} {matrix}");
            let sorted = |v: Vector3<f64>| {
                let mut v: [f64; 3] = v.into();
                v.sort_by(f64::total_cmp);
                Vector3::from(v)
            };
            let error = sorted(found.moments() / scale) - sorted(moments);
            assert!(error.amax() < 5e-15, "{moments} {scale:e}: {error}");
        }
    }
}

/// A diagonal matrix is described in its principal axes, whose moments stay where they are, to the last bit.
#[test]
fn a_diagonal_matrix_is_aligned() {
    for moments in MOMENTS.map(Vector3::from) {
        let found = PrincipalAxes::of(&Matrix3::from_diagonal(&moments)).unwrap();
        assert_eq!(found, PrincipalAxes::aligned(moments));
        let minus_zero = found.from_principal(&Vector3::new(-0.0, 1.0, 0.0)).x;
        assert!(minus_zero.is_sign_negative());
    }
    // The control: a small product of inertia turns the axes.
    let turned = Matrix3::new(2.0, 1e-9, 0.0, 1e-9, 1.5, 0.0, 0.0, 0.0, 1.0);
    assert!(!PrincipalAxes::of(&turned).unwrap().is_aligned());
}

#[test]
fn matrices_that_are_none_of_a_body_are_refused() {
    let skew = Matrix3::new(2.0, 0.1, 0.0, 0.2, 1.5, 0.0, 0.0, 0.0, 1.0);
    let refused = TopError::NotSymmetric { row: 0, column: 1, value: 0.1, mirrored: 0.2 };
    assert_eq!(PrincipalAxes::of(&skew), Err(refused));
    for bad in [f64::NAN, f64::INFINITY] {
        let matrix = Matrix3::from_diagonal(&Vector3::new(1.0, bad, 1.0));
        assert!(matches!(PrincipalAxes::of(&matrix), Err(TopError::NotFinite { .. })));
    }
    // Entries that differ by the rounding of twelve digits are taken.
    let rounded = Matrix3::new(2.0, 0.1, 0.0, 0.1 + 1e-12, 1.5, 0.0, 0.0, 0.0, 1.0);
    assert!(PrincipalAxes::of(&rounded).is_ok());
}

/// The state and the attitude after a time by Kutta's method on the equations with the full matrix, and on dR/dt = RΩ^.
fn by_equations(
    inertia: &Matrix3<f64>,
    force: &Vector3<f64>,
    start: &Se3Dual,
    (attitude, end, steps): (Matrix3<f64>, f64, u32),
) -> (Se3Dual, Matrix3<f64>) {
    let inverse = inertia.try_inverse().unwrap();
    type State = (Vector3<f64>, Vector3<f64>, Matrix3<f64>);
    let rate = |(pi, gamma, r): &State| -> State {
        let omega = inverse * pi;
        (pi.cross(&omega) + gamma.cross(force), gamma.cross(&omega), r * omega.cross_matrix())
    };
    let add = |a: &State, b: &State, h: f64| (a.0 + b.0 * h, a.1 + b.1 * h, a.2 + b.2 * h);
    let h = end / f64::from(steps);
    let mut state = (start.0.0, start.0.1, attitude);
    for _ in 0..steps {
        let k1 = rate(&state);
        let k2 = rate(&add(&state, &k1, 0.5 * h));
        let k3 = rate(&add(&state, &k2, 0.5 * h));
        let k4 = rate(&add(&state, &k3, h));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            state = add(&state, &k, weight * h / 6.0);
        }
    }
    (Se3Dual::new(state.0, state.1), state.2)
}

fn matrix_of(q: &Quaternion) -> Matrix3<f64> {
    let v = nalgebra::Quaternion::new(q.scalar, q.vector.x, q.vector.y, q.vector.z);
    nalgebra::UnitQuaternion::from_quaternion(v).to_rotation_matrix().into_inner()
}

/// The motion in the axes of the matrix, attitude included, is that of the equations with the full matrix.
#[test]
fn the_motion_is_that_of_the_equations_with_the_full_matrix() {
    let rotation = Rotation3::from_euler_angles(0.4, -1.1, 2.3).into_inner();
    for moments in [[1.0, 1.7, 2.2], [2.0, 2.0, 1.0], [1.4, 1.4, 1.4]] {
        let inertia =
            rotation * Matrix3::from_diagonal(&Vector3::from(moments)) * rotation.transpose();
        let (c, weight) = (Vector3::new(0.48, 0.6, 0.64), 1.3);
        let axes = PrincipalAxes::of(&inertia).unwrap();
        let top = HeavyTop::new(&Body {
            inertia: axes.moments(),
            mass: 1.0,
            gravity: weight,
            length: 1.0,
            center_of_mass: axes.to_principal(&c),
        })
        .unwrap();
        let start = Se3Dual::new(Vector3::new(0.5, 1.2, -0.8), Vector3::new(0.6, 0.0, 0.8));
        let upright = attitude_of_vertical(&start.0.1);
        let gauss = WithAttitude(top.gauss(4).unwrap());
        let Pair(state, _) = gauss.start(&axes.state_to_principal(&start)).unwrap();
        let attitude = axes.attitude_to_principal(&upright);
        let run = gauss.trajectory_from(Pair(state, attitude), 0.05);
        let end = run.take(81).last().unwrap().unwrap();
        let found = axes.state_from_principal(&end.momentum);
        let turned = matrix_of(&axes.attitude_from_principal(&end.state.1));
        let from = (matrix_of(&upright), 4.0, 4000);
        let (expected, attitude) = by_equations(&inertia, &(c * weight), &start, from);
        // Order 4 at a step of 0.001, and order 8 at 0.05.
        assert!((found - expected).max_abs() < 1e-9, "{moments:?}: {found:?} {expected:?}");
        assert!((turned - attitude).amax() < 1e-9, "{moments:?}: {turned} {attitude}");
    }
}

/// A laboratory gyroscope: m l² = 8e-4 kg m² is more than its moments. Rigid bodies pass, and the tolerance has no unit.
#[test]
fn moments_about_the_support_leave_room_for_the_mass() {
    let gyroscope = |scale: f64| Body {
        inertia: Vector3::new(2e-4, 2e-4, 3e-4) * scale,
        mass: 0.5 * scale,
        gravity: 9.81,
        length: 0.04,
        center_of_mass: Vector3::z(),
    };
    for scale in [1.0, 1e-30, 1e30] {
        let refused = gyroscope(scale).require_possible().unwrap_err();
        let TopError::ImpossibleBody { point, least, .. } = refused else { panic!("{refused}") };
        assert!((point / scale - 8e-4).abs() < 1e-18, "{point}");
        assert!((least / scale + 6e-4).abs() < 1e-18, "{least}");
        // The same numbers about the centre of mass are those of a body.
        let central = Matrix3::from_diagonal(&gyroscope(scale).inertia);
        let position = Vector3::new(0.024, 0.0, 0.032);
        let inertia = central + point_inertia(0.5 * scale, &position);
        require_possible_body(&inertia, 0.5 * scale, &position).unwrap();
    }
    // The bounds: a point mass, a rod held at its end, a disc that is not thick enough by a part in 1e6.
    let across = |a: f64, b: f64| Body { inertia: Vector3::new(a, a, b), ..gyroscope(1.0) };
    across(8e-4, 0.0).require_possible().unwrap();
    across(4.0 * 8e-4 / 3.0, 0.0).require_possible().unwrap();
    across(8e-4 + 2e-4, 4e-4).require_possible().unwrap();
    across(8e-4 + 2e-4, 4e-4 * (1.0 + 1e-6)).require_possible().unwrap_err();
}

/// The moments of a point mass about its centre of mass are rounding errors, in any axes and any unit.
#[test]
fn a_point_mass_off_the_axes_is_a_body() {
    for turn in rotations() {
        for (mass, length) in [(0.3, 0.7), (2e-30, 0.1), (7e30, 1e-3)] {
            let point: f64 = mass * length * length;
            let principal = Matrix3::from_diagonal(&Vector3::new(point, point, 0.0));
            let (inertia, position) =
                (turn * principal * turn.transpose(), turn.column(2) * length);
            require_possible_body(&inertia, mass, &position).unwrap();
            // Controls: a larger mass is more than the moments, and an asymmetry of 1e-8 is no rounding.
            require_possible_body(&inertia, mass * (1.0 + 1e-8), &position).unwrap_err();
            let mut other = inertia;
            other[(0, 1)] += 1e-8 * point;
            let refused = require_possible_body(&other, mass, &position).unwrap_err();
            assert!(
                matches!(refused, TopError::NotSymmetric { row: 0, column: 1, .. }),
                "{refused}"
            );
        }
    }
}
