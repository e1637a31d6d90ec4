//! The time of momentum maps that are derived from an action, against the same formulas by hand.
#![allow(missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use lie_poisson::{
    Covector, Diagonal, Pair, Power, SO3OnR3, SkewHermitian, UnitaryOnComplexSpace, Vector,
};
use momentum_map::{
    AffineAction, Cotangent, LinearAction, MomentumMap, Opposite, PoissonMap, ProductAction,
};
use nalgebra::{SMatrix, SVector, Vector3};
use num_complex::Complex;
use std::hint::black_box;

/// Returns a vector with generic coordinates in (−1, 1).
fn generic<V: Vector<Scalar = f64>>(seed: f64) -> V {
    V::from_coordinates(|i| (seed + 1.7 * i as f64).sin())
}

/// Times a formula of ξ and z.
fn time<X: Vector<Scalar = f64>, Z: Vector<Scalar = f64>, Y>(
    c: &mut Criterion,
    name: &str,
    f: impl Fn(&X, &Z) -> Y,
) {
    let (xi, z): (X, Z) = (generic(0.3), generic(2.1));
    c.bench_function(name, |b| b.iter(|| f(black_box(&xi), black_box(&z))));
}

type Two = Pair<Vector3<f64>, Vector3<f64>>;

/// so(4) = so(3) × so(3) on R³ × R³.
fn two_rotations(c: &mut Criterion) {
    let map = MomentumMap(ProductAction(LinearAction(SO3OnR3), LinearAction(SO3OnR3)));
    time(c, "so(4), apply, derived", |_: &Two, z| map.apply::<f64>(z));
    time(c, "so(4), apply, by hand", |_: &Two, z: &Cotangent<Two>| {
        let (q, Covector(p)) = (z.q, z.p);
        Covector(Pair(q.0.cross(&p.0), q.1.cross(&p.1)))
    });
    time(c, "so(4), generator, derived", |xi, z| map.generator::<f64>(xi, z));
    time(c, "so(4), generator, by hand", |xi: &Two, z: &Cotangent<Two>| {
        let turned = |v: &Two| Pair(xi.0.cross(&v.0), xi.1.cross(&v.1));
        Cotangent::new(turned(&z.q), Covector(turned(&z.p.0)))
    });
}

type Fields = Power<Vector3<f64>, 2>;
type Motion = Pair<Vector3<f64>, Fields>;

/// The right action of SO(3) ⋉ (R³)² of a body in two constant fields.
fn body_in_two_fields(c: &mut Criterion) {
    let map = MomentumMap(Opposite(AffineAction(Diagonal::<_, 2>(SO3OnR3))));
    time(c, "two fields, apply, derived", |_: &Motion, z| map.apply::<f64>(z));
    time(c, "two fields, apply, by hand", |_: &Motion, z: &Cotangent<Fields>| {
        let (Power(q), Covector(p)) = (z.q, z.p);
        Covector(Pair(p.0[0].cross(&q[0]) + p.0[1].cross(&q[1]), -p))
    });
    time(c, "two fields, generator, derived", |xi, z| map.generator::<f64>(xi, z));
    time(c, "two fields, generator, by hand", |xi: &Motion, z: &Cotangent<Fields>| {
        let back = |v: Fields| Power(v.0.map(|v| v.cross(&xi.0)));
        Cotangent::new(back(z.q) - xi.1, Covector(back(z.p.0)))
    });
}

type Skew = SkewHermitian<f64, 3>;
type Complex3 = SVector<Complex<f64>, 3>;

/// U(3), which contains SU(3), on C³.
fn unitary(c: &mut Criterion) {
    let map = MomentumMap(LinearAction(UnitaryOnComplexSpace::<3>));
    time(c, "u(3), apply, derived", |_: &Skew, z| map.apply::<f64>(z));
    time(c, "u(3), apply, by hand", |_: &Skew, z: &Cotangent<Complex3>| {
        let a = z.p.0 * z.q.adjoint();
        let twice: SMatrix<Complex<f64>, 3, 3> = a - a.adjoint();
        Covector(Skew::from_coordinates(|i| {
            let (j, k) = (i % 3, i / 3);
            let entry = twice[(j, k)];
            if j == k {
                0.5 * entry.im
            } else if j > k {
                entry.re
            } else {
                entry.im
            }
        }))
    });
    time(c, "u(3), generator, derived", |xi, z| map.generator::<f64>(xi, z));
    time(c, "u(3), generator, by hand", |xi: &Skew, z: &Cotangent<Complex3>| {
        Cotangent::new(xi.matrix() * z.q, Covector(xi.matrix() * z.p.0))
    });
}

criterion_group!(benches, two_rotations, body_in_two_fields, unitary);
criterion_main!(benches);
