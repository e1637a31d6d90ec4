//! The differential and the second derivative of each Hamiltonian over small states, against exact derivatives by dual
//! numbers.

use lie_poisson_systems::lie_poisson::{
    Covector, DualNumber, Hamiltonian, LiePoisson, Pair, Point, PoissonSpace, Power, Se3, Vector,
    laws,
};
use lie_poisson_systems::nalgebra::{Matrix3, Vector3};
use lie_poisson_systems::{
    Gyrostat, HeisenbergChain, KidaVortex, Kirchhoff, MovableBaseAlgebra, MovableBaseTop, So21,
    SpinSpace,
};

const INERTIA: Vector3<f64> = Vector3::new(2.0, 2.2, 1.0);
const CENTER: Vector3<f64> = Vector3::new(0.1, 0.0, 0.8);

/// The suite compares to `bound` of the size, and leaves a law out that the Hamiltonian does not claim: the second
/// derivative has to be there.
fn check<P, H>(hamiltonian: &H, samples: &[Point<P>], bound: f64)
where
    P: PoissonSpace,
    H: Hamiltonian<P> + Hamiltonian<P, DualNumber>,
{
    for z in samples {
        assert!(Hamiltonian::<P>::hessian(hamiltonian, z, &Vector::basis(0)).is_some());
    }
    laws::hamiltonian::<P, _>(hamiltonian, samples).unwrap().check(bound).unwrap();
}

fn vectors(seed: f64) -> [Vector3<f64>; 3] {
    [1.0, 2.0, 3.0].map(|i| {
        let x = seed + i;
        Vector3::new((1.3 * x).cos(), (2.1 * x + 0.4).sin(), (0.7 * x).sin() - 0.3)
    })
}

/// A dozen products and sums of numbers of about one.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

#[test]
fn bodies() {
    let samples = [0.2, 5.0].map(|seed| {
        let [pi, p, _] = vectors(seed);
        Covector(Pair(pi, p))
    });
    let gyrostat = Gyrostat::new(INERTIA, 1.5, CENTER, Vector3::new(0.3, -0.2, 0.7)).unwrap();
    check::<LiePoisson<Se3>, _>(&gyrostat, &samples, ROUND_OFF);
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    let c = Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3);
    let body = Kirchhoff::new(a, b, c).unwrap();
    check::<LiePoisson<Se3>, _>(&body, &samples, ROUND_OFF);
    let samples = [0.2, 5.0].map(|seed| {
        let [pi, p, gamma] = vectors(seed);
        Covector(Pair(Pair(pi, p), gamma))
    });
    let top = MovableBaseTop::new(INERTIA, [1.0, 2.0], 1.0, CENTER).unwrap();
    check::<LiePoisson<MovableBaseAlgebra>, _>(&top, &samples, ROUND_OFF);
}

#[test]
fn spins_in_a_ring() {
    let chain = HeisenbergChain::<3>::new(0.8, Vector3::new(0.2, 0.1, -0.4)).unwrap();
    let samples = [0.2, 5.0].map(|seed| Covector(Power(vectors(seed))));
    check::<SpinSpace<3>, _>(&chain, &samples, ROUND_OFF);
}

/// The energy has a logarithm, whose derivatives lose digits to the difference of the semi-axes.
#[test]
fn the_vortex_of_kida() {
    let vortex = KidaVortex::new(1.3, 0.2, 0.07).unwrap();
    let samples = [(1.5, 0.5, 0.3), (0.7, 0.1, 1.4)]
        .map(|(major, minor, angle)| KidaVortex::momentum(major, minor, angle).unwrap());
    check::<LiePoisson<So21>, _>(&vortex, &samples, 4.0 * ROUND_OFF);
}
