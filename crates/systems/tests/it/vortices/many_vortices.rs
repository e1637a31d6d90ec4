//! Vortices whose number is known at run time, against those whose number the compiler knows.

use collective_integrators::{
    Composition, Direct, HamiltonianField, Integrator, RungeKutta, Scheme, SphericalMidpoint,
    StageSolver, StepError, Substeps, from_fn,
};
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, PowerAlgebra, Sites, SitesHamiltonian, So3, larger,
};
use lie_poisson_systems::{ManyVortices, PointVortices, SpinSpace, Spins, SystemError};
use nalgebra::{Vector1, Vector3};

const STRENGTHS: [f64; 4] = [1.0, -0.7, 1.5, 0.4];

type Many = Covector<Sites<Vector3<f64>>>;

fn positions() -> [Vector3<f64>; 4] {
    [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x| x.normalize())
}

fn field() -> HamiltonianField<SpinSpace<4>, PointVortices<4>> {
    let hamiltonian = PointVortices::new(STRENGTHS).unwrap();
    HamiltonianField { space: LiePoisson::minus(PowerAlgebra(So3)), hamiltonian }
}

/// Asserts that both integrators have the same bits and iterations, by steps and by steps in place.
fn same_bits(
    few: &impl Integrator<State = Spins<4>>,
    many: &impl Integrator<State = Many>,
    size: f64,
) {
    let vortices = ManyVortices::new(STRENGTHS.to_vec()).unwrap();
    let mut m = field().hamiltonian.momentum(&positions());
    let mut in_place = vortices.momentum(positions()).unwrap();
    let mut spaces = (few.workspace(), many.workspace(), many.workspace());
    for _ in 0..50 {
        let next = few.step(&m, size, &mut spaces.0).unwrap();
        let by_value = many.step(&in_place, size, &mut spaces.1).unwrap();
        let iterations = many.step_in_place(&mut in_place, size, &mut spaces.2).unwrap();
        m = next.point;
        assert_eq!(m.0.0[..], in_place.0[..]);
        assert_eq!(by_value.point, in_place);
        assert_eq!([next.iterations, by_value.iterations], [iterations; 2]);
    }
}

#[test]
fn a_number_at_run_time_changes_no_bit() {
    let many = ManyVortices::new(STRENGTHS.to_vec()).unwrap();
    let composed = |base| Composition::new(base, Substeps::yoshida4());
    for scheme in [RungeKutta::rk4(), RungeKutta::gauss(1).unwrap(), RungeKutta::gauss(4).unwrap()]
    {
        let few = Direct::new(scheme.clone(), field());
        same_bits(&few, &Direct::new(scheme.clone(), many.clone()), 0.1);
        let few = Direct::new(composed(scheme.clone()), field());
        same_bits(&few, &Direct::new(composed(scheme), many.clone()), 0.1);
    }
    same_bits(&SphericalMidpoint::new(field()), &SphericalMidpoint::new(many), 0.1);
}

/// For a large step sweeps diverge, and Newton's iteration solves the stages, by difference quotients for both.
#[test]
fn newtons_iteration_serves_a_number_at_run_time() {
    let midpoint = RungeKutta::implicit_midpoint();
    let many = ManyVortices::new(STRENGTHS.to_vec()).unwrap();
    let few = Direct::new(midpoint.clone(), field());
    let many = Direct::new(midpoint, many);
    let start = field().hamiltonian.momentum(&positions());
    let step = few.step(&start, 12.0, &mut few.workspace()).unwrap();
    assert!(step.iterations > 60, "sweeps alone took {}", step.iterations);
    let sites = Covector(start.0.0.into_iter().collect());
    let other = Integrator::<f64>::step(&many, &sites, 12.0, &mut many.workspace()).unwrap();
    assert!(other.iterations > 60);
    let other = other.point;
    for (a, b) in step.point.0.0.iter().zip(other.0.iter()) {
        // one has exact derivatives, the other difference quotients
        assert!((a - b).norm() < 1e-12, "{a} {b}");
    }
}

/// Returns n vortices near the equator.
fn ring(n: usize) -> (ManyVortices, Many) {
    let vortices = ManyVortices::new((0..n).map(|i| 1.0 + 0.1 * i as f64).collect()).unwrap();
    let position = |i: usize| {
        let (sin, cos) = (6.0 * i as f64 / n as f64).sin_cos();
        Vector3::new(cos, sin, 0.2 * sin * cos).normalize()
    };
    let start = vortices.momentum((0..n).map(position)).unwrap();
    (vortices, start)
}

/// One workspace serves states of different size, after each other and after a step that failed.
#[test]
fn a_workspace_serves_any_number_of_sites() {
    for scheme in [RungeKutta::rk4(), RungeKutta::gauss(1).unwrap(), RungeKutta::gauss(3).unwrap()]
    {
        let mut used = Scheme::workspace(&scheme);
        for n in [4, 7, 4, 2, 7] {
            let (vortices, start) = ring(n);
            let (mut z, mut w) = (start.clone(), start.clone());
            let mut fresh = Scheme::workspace(&scheme);
            for _ in 0..5 {
                scheme.step_in_place::<f64, _>(&vortices, &mut z, 0.05, &mut used).unwrap();
                scheme.step_in_place::<f64, _>(&vortices, &mut w, 0.05, &mut fresh).unwrap();
                assert_eq!(z, w, "{n}");
            }
            let mut kept = z.clone();
            let failed = scheme.step_in_place::<f64, _>(&vortices, &mut kept, f64::NAN, &mut used);
            assert!(failed.is_err() && kept == z);
        }
    }
}

/// A field with a value of another space than its argument makes every step fail, and nothing panics.
#[test]
fn a_field_of_another_space_fails() {
    let wrong = from_fn(|_: &Sites<Vector3<f64>>| Sites::new(vec![Vector3::x()]));
    let start = Sites::new(vec![Vector3::y(); 3]);
    for scheme in [RungeKutta::rk4(), RungeKutta::gauss(2).unwrap()] {
        assert!(scheme.step(&wrong, &start, 0.1, &mut scheme.workspace()).is_err());
    }
    // A state without sites stays as it is, even if only Newton's iteration is allowed.
    let solver = StageSolver { max_iterations: 0, ..Default::default() };
    let newton = RungeKutta::gauss(1).unwrap().with_solver(solver);
    let none = Sites::<Vector3<f64>>::new(Vec::new());
    let field = from_fn(|z: &Sites<Vector3<f64>>| z.clone());
    let step = newton.step(&field, &none, 0.1, &mut newton.workspace()).unwrap();
    assert_eq!(step.point, none);
}

/// Sweeps diverge for h = 3 and dz/dt = −z. Newton's iteration is made for 1024 unknowns, and not for 1025.
#[test]
fn newtons_iteration_is_for_systems_of_moderate_size() {
    let decay = from_fn(|z: &Sites<Vector1<f64>>| z.iter().map(|z| -z).collect());
    let midpoint = RungeKutta::implicit_midpoint();
    let step = |count| {
        let start = Sites::new(vec![Vector1::new(1.0); count]);
        midpoint.step(&decay, &start, 3.0, &mut midpoint.workspace())
    };
    let end = step(10).unwrap();
    assert!(end.iterations > 60 && end.point.iter().all(|z| (z.x + 0.2).abs() < 1e-14));
    assert!(matches!(step(1025), Err(StepError::NotConverged { .. })));
}

/// A hundred vortices on the spiral of equal areas.
#[test]
fn a_hundred_vortices_keep_their_invariants() {
    let count = 100;
    let strengths = (0..count).map(|i| if i % 3 == 0 { -0.5 } else { 1.0 }).collect();
    let vortices = ManyVortices::new(strengths).unwrap();
    let spiral = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.399963 * i as f64).sin_cos();
        Vector3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
    };
    let start = vortices.momentum((0..count).map(spiral)).unwrap();
    let moment = |m: &Many| m.0.iter().sum::<Vector3<f64>>();
    let drifts = |method: &dyn Fn(&mut Many)| {
        let mut m = start.clone();
        (0..100).for_each(|_| method(&mut m));
        let off = vortices.positions(&m).map(|x| (x.norm() - 1.0).abs()).fold(0.0, larger);
        let energy = (vortices.value(&m) / vortices.value(&start) - 1.0).abs();
        (off, (moment(&m) - moment(&start)).norm(), energy)
    };
    let midpoint = SphericalMidpoint::new(vortices.clone());
    let (off, moved, energy) = drifts(&|m| {
        midpoint
            .step_in_place(m, 0.01, &mut Integrator::<f64>::workspace(&midpoint))
            .map(drop)
            .unwrap();
    });
    assert!(off < 1e-13 && moved < 1e-11 && energy < 1e-4, "{off:e} {moved:e} {energy:e}");
    // control: an explicit method leaves the spheres
    let euler = Direct::new(RungeKutta::explicit_midpoint(), vortices.clone());
    let (off, ..) = drifts(&|m| {
        euler.step_in_place(m, 0.01, &mut Integrator::<f64>::workspace(&euler)).map(drop).unwrap();
    });
    assert!(off > 1e-9, "{off:e}");
}

#[test]
fn energies_agree_and_parameters_are_checked() {
    let many = ManyVortices::new(STRENGTHS.to_vec()).unwrap();
    let m = many.momentum(positions()).unwrap();
    let few = field().hamiltonian;
    assert_eq!(many.value(&m), few.value(&few.momentum(&positions())));
    assert_eq!(many.strengths(), STRENGTHS);
    let refused = SystemError::Count { name: "positions", expected: 4, found: 3 };
    assert_eq!(many.momentum(positions().into_iter().take(3)), Err(refused));
    assert_eq!(ManyVortices::new(vec![1.0, 0.0]), Err(SystemError::Zero { name: "strength" }));
    // Three or five positions are no point of four vortices.
    for count in [3, 5] {
        let other: Many = Covector(positions().into_iter().cycle().take(count).collect());
        assert!(many.value(&other).is_nan());
        let gauss = Direct::new(RungeKutta::gauss(2).unwrap(), many.clone());
        let rk4 = Direct::new(RungeKutta::rk4(), many.clone());
        let midpoint = SphericalMidpoint::new(many.clone());
        assert!(Integrator::<f64>::step(&gauss, &other, 0.1, &mut gauss.workspace()).is_err());
        assert!(Integrator::<f64>::step(&rk4, &other, 0.1, &mut rk4.workspace()).is_err());
        assert!(
            Integrator::<f64>::step(&midpoint, &other, 0.1, &mut midpoint.workspace()).is_err()
        );
    }
    assert_eq!(ManyVortices::new(vec![1e-310]), Err(SystemError::Zero { name: "strength" }));
    let infinite = ManyVortices::new(vec![f64::INFINITY]);
    assert!(matches!(infinite, Err(SystemError::NotFinite { .. })));
}
