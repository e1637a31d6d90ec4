//! The spherical midpoint method of the Python package spinsys, by the authors of McLachlan, Modin & Verdier, against
//! `SphericalMidpoint` and the collective midpoint rule, number by number.
//!
//! The numbers come from <https://github.com/olivierverdier/spinsys>, commit
//! `e2c3fb57b33f60a7be1acd22ee7ca551fb44817a`, with numpy 2.4.6 and `numba.jit` replaced by the identity, by
//!
//! ```text
//! import numpy as np
//! from spinsys import midpoint, sphere, spinchain, vortex
//! m = np.array([[1, .2, -.3], [-.4, 1, .5], [.1, -.8, .7], [-.5, -.2, -1]])
//! m = (m.T / np.sqrt((m * m).sum(axis=1))).T
//! k = np.array([1, -.7, 1.5, .4])
//! chain = sphere.radially_constant(spinchain.get_gradient(1.))
//! vortices = sphere.radially_constant(vortex.get_gradient(k), k)
//! for field, h in (chain, .1), (vortices, .05):
//!     for w in list(midpoint.run(midpoint.get_increment(field), m.ravel(), h, 50))[25::25]:
//!         print(w.tolist())
//! print(vortex.get_energy(k)(m.ravel()))
//! ```

use collective_integrators::{
    AnyState, Collective, HamiltonianField, RungeKutta, SphericalMidpoint, Start, from_fn,
};
use core::f64::consts::PI;
use lie_poisson::{
    Automatic, Covector, Energy, Hamiltonian, LiePoisson, Power, PowerAlgebra, Real, So3, larger,
};
use lie_poisson_runs::{Arguments, ArrayKind, Model};
use lie_poisson_systems::{HeisenbergChain, PointVortices, SpinSpace, Spins};
use momentum_map::{PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;

/// The oracle ends Newton's iteration with finite differences of 1e-10 at a change of 1.5e-8. A step is then correct to
/// 1e-15, and 50 steps of a stable motion to a few 1e-14.
const TOLERANCE: f64 = 1e-12;

#[rustfmt::skip]
const CHAIN: [[f64; 12]; 2] = [
    [-0.0344658347351678, -0.14929970300824152, 0.9881911277266454, 0.07078781022505168, -0.6186431612841953, -0.7824766609425736, 0.9616099350445281, 0.21113631249813186, -0.17529344074536884, -0.7406386825820647, 0.661743816007063, -0.11640216423896058],
    [0.9501421935806741, 0.3024341146264853, -0.07591718045211365, -0.8896659331608417, 0.0967421045215192, -0.44624600007820364, -0.3315751835889577, 0.46164037202934416, 0.8227673210212947, 0.5283921511214725, -0.7558793269645907, -0.3865852786912346],
];

#[rustfmt::skip]
const VORTICES: [[f64; 12]; 2] = [
    [0.04210201154927028, -0.35834547881607665, 0.9326392327344919, -0.9528448640965127, 0.29106928334449034, 0.08582154308926812, 0.11777287446923773, -0.8777410151534398, -0.4644354210831271, 0.6379209215841651, 0.7075107060336333, -0.30411428551286346],
    [-0.09765857302178961, -0.49127052071557287, -0.865514921067914, 0.13569673713156388, 0.6004279521567131, -0.7880816390455644, 0.881213752030098, -0.47226699742793055, -0.020644766248216977, 0.029366894307723976, 0.06067341473310486, 0.9977255746262813],
];

const VORTEX_ENERGY: f64 = 0.353_553_801_206_113_3;

const STRENGTHS: [f64; 4] = [1.0, -0.7, 1.5, 0.4];

fn points() -> [Vector3<f64>; 4] {
    [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x| x.normalize())
}

/// Returns the largest difference from the numbers of the oracle after 25 and after 50 steps.
fn differences<I>(
    integrator: &I,
    start: &Spins<4>,
    step: f64,
    oracle: &[[f64; 12]; 2],
    points: impl Fn(&Spins<4>) -> [Vector3<f64>; 4],
) -> f64
where
    I: Start<Momentum = Spins<4>>,
{
    let mut worst = 0.0;
    for (steps, expected) in [25, 50].into_iter().zip(oracle) {
        let computed = points(&integrator.after(start, step, steps).unwrap().momentum);
        for (i, expected) in expected.iter().enumerate() {
            worst = larger(worst, (computed[i / 3][i % 3] - expected).abs());
        }
    }
    worst
}

/// A Hamiltonian on spheres, constant along rays: h(s₁/|s₁|, …).
#[derive(Clone, Copy)]
struct AlongRays(HeisenbergChain<4>);

impl Energy for AlongRays {
    type Space = SpinSpace<4>;

    fn energy<T: Real>(&self, s: &Spins<4, T>) -> T {
        let unit = s.0.0.map(|s| s / s.dot(&s).sqrt());
        self.0.value(&Covector(Power(unit)))
    }
}

#[test]
fn the_spin_chain_of_spinsys() {
    let chain = HeisenbergChain::<4>::new(1.0, Vector3::zeros()).unwrap();
    let start = Covector(Power(points()));
    let space = LiePoisson::plus(PowerAlgebra::<_, 4>(So3));
    let spherical = SphericalMidpoint::new(HamiltonianField { space, hamiltonian: chain });
    let difference = differences(&spherical, &start, 0.1, &CHAIN, |s| s.0.0);
    println!("spherical midpoint, chain: {difference:e}");
    assert!(difference < TOLERANCE, "{difference:e}");
    // The collective midpoint rule through the Hopf map is the same method for a Hamiltonian constant along rays.
    let map = PowerMap::<_, 4>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let midpoint = RungeKutta::implicit_midpoint;
    let collective = Collective::new(midpoint(), map, Automatic(AlongRays(chain)));
    let difference = differences(&collective, &start, 0.1, &CHAIN, |s| s.0.0);
    println!("collective midpoint, chain: {difference:e}");
    assert!(difference < TOLERANCE, "{difference:e}");
    // Negative control: without the projection to rays it is another method of order 2.
    let other = Collective::new(midpoint(), map, chain);
    assert!(differences(&other, &start, 0.1, &CHAIN, |s| s.0.0) > 1e-4);
}

/// Time runs 4π times faster for spinsys, whose energy has no factor 1/4π.
#[test]
fn the_point_vortices_of_spinsys() {
    let vortices = PointVortices::new(STRENGTHS).unwrap();
    let start = vortices.momentum(&points());
    // The oracle sums over pairs without a factor.
    assert!((4.0 * PI * vortices.value(&start) - VORTEX_ENERGY).abs() < 1e-15);
    let space = LiePoisson::minus(PowerAlgebra::<_, 4>(So3));
    let field = HamiltonianField { space, hamiltonian: vortices };
    let spherical = SphericalMidpoint::new(field);
    let difference =
        differences(&spherical, &start, 0.05 * 4.0 * PI, &VORTICES, |m| vortices.positions(m));
    println!("spherical midpoint, vortices: {difference:e}");
    assert!(difference < TOLERANCE, "{difference:e}");
    // Negative control: the time of the crate is not that of the oracle.
    let still = from_fn(|m: &Spins<4>| m.0.0.map(|m| m * 0.0).into_covector());
    let still = SphericalMidpoint::new(still);
    assert!(differences(&still, &start, 0.05, &VORTICES, |m| vortices.positions(m)) > 0.1);
}

/// The same numbers by the models of the program and of Python, under the name of the scheme.
#[test]
fn the_doors_make_the_steps_of_spinsys() {
    let start = points().map(|x| [x.x, x.y, x.z]).concat();
    let door =
        |kind: &str, parameters: Arguments, step: f64, oracle: &[[f64; 12]; 2], scale: &[f64]| {
            let model = ArrayKind::named(kind).unwrap().system(&parameters).unwrap();
            let method = model.method(
                Some("reduced".parse().unwrap()),
                "spherical-midpoint".parse().unwrap(),
                0.0,
            );
            let given: Vec<f64> = start.iter().enumerate().map(|(i, x)| x * scale[i / 3]).collect();
            let integrator = model.integrator(&method.unwrap(), &given).unwrap();
            let mut worst = 0.0;
            for (steps, expected) in [25, 50].into_iter().zip(oracle) {
                let end =
                    integrator.after(&AnyState::from_slice(&given), step, steps).unwrap().momentum;
                for (i, (x, expected)) in end.as_slice().iter().zip(expected).enumerate() {
                    worst = larger(worst, (x / scale[i / 3] - expected).abs());
                }
            }
            worst
        };
    let chain = Arguments::new().list("shape", vec![4.0]).number("exchange", 1.0);
    let difference = door("spin-lattice", chain.clone(), 0.1, &CHAIN, &[1.0; 4]);
    assert!(difference < TOLERANCE, "{difference:e}");
    // Control: open ends are another chain.
    assert!(door("spin-lattice", chain.number("periodic", 0.0), 0.1, &CHAIN, &[1.0; 4]) > 1e-3);
    let vortices = Arguments::new().list("strengths", STRENGTHS.to_vec());
    let difference = door("vortices", vortices, 0.05 * 4.0 * PI, &VORTICES, &STRENGTHS);
    assert!(difference < TOLERANCE, "{difference:e}");
}

trait IntoCovector {
    fn into_covector(self) -> Spins<4>;
}

impl IntoCovector for [Vector3<f64>; 4] {
    fn into_covector(self) -> Spins<4> {
        Covector(Power(self))
    }
}
