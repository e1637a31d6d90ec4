//! Allocations along a trajectory: there are none per step.
#![allow(unsafe_code)] // the allocator that counts

use collective_integrators::{
    Alternating, AnyState, BatchIntegrator, Collective, CollectiveSites, Composition, DenseOutput,
    Direct, Direction, Events, ExactFlows, Integrator, Laned, LiftFree, LiftFreeSites,
    LyapunovExponents, NoiseRule, RungeKutta, SphericalMidpoint, Splitting, StagesInLanes, Start,
    Substeps, TaoFlows, VariationalFlow, VectorField,
};
use heavytop::methods::{Formulation, SchemeName};
use heavytop::{CollectiveGauss, SpinorRealisation, TopMidpoint, WithAttitude};
use isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, Products,
};
use lie_poisson::{Covector, Pair, Se3, Se3Dual, Sites};
use lie_poisson_formula_systems::{
    NamedInputs, NoiseFields, NoiseTerms, OpenNames, OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::{FormulaHamiltonian, Parameters, Vocabulary};
use lie_poisson_systems::{GeneralisedRigidBody, HeisenbergLattice, LatticeMidpoint, ManyVortices};
use momentum_map::{DualQuaternions, HOPF, Quaternions};
use nalgebra::{Vector2, Vector3};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::error::Error;
use workspace_tests::tops;

type Points = Covector<Sites<Vector3<f64>>>;

/// The system's allocator with a counter for each thread.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is passed on to the system's allocator as it comes.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|n| n.set(n.get() + 1));
        // SAFETY: the caller's promises are those that `System` asks for.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Returns the number of allocations that `f` makes.
fn allocations(f: impl FnOnce() -> Result<(), Box<dyn Error>>) -> Result<usize, Box<dyn Error>> {
    let before = ALLOCATIONS.with(Cell::get);
    f()?;
    Ok(ALLOCATIONS.with(Cell::get) - before)
}

/// Returns the number of allocations of 20 steps in place, after the steps that fill the memory.
fn in_place<I: Integrator>(method: &I, mut state: I::State) -> Result<usize, Box<dyn Error>> {
    let mut workspace = method.workspace();
    for _ in 0..4 {
        method.step_in_place(&mut state, 0.01, &mut workspace)?;
    }
    allocations(|| {
        for _ in 0..20 {
            method.step_in_place(&mut state, 0.01, &mut workspace)?;
        }
        Ok(())
    })
}

/// The library takes one or two buffers for each of the three real products of a complex one, and gives them back: these
/// steps allocate nothing themselves.
#[test]
fn no_step_of_a_matrix_allocates() -> Result<(), Box<dyn Error>> {
    require_none_in_steps_of_matrices(12)
}

#[test]
#[ignore = "long"]
fn no_step_of_a_large_matrix_allocates() -> Result<(), Box<dyn Error>> {
    require_none_in_steps_of_matrices(40)
}

/// Counts the allocations of steps of matrices of a size.
fn require_none_in_steps_of_matrices(size: usize) -> Result<(), Box<dyn Error>> {
    let body = GeneralisedRigidBody::new((1..=size).map(|j| j as f64).collect())?;
    let start = body.momentum(|j, k| ((3 * j + k) as f64).sin());
    let (mut products, mut product) = (Products::default(), start.matrix().clone());
    products.multiply(start.matrix(), start.matrix(), &mut product);
    let multiply = allocations(|| {
        products.multiply(start.matrix(), start.matrix(), &mut product);
        Ok(())
    })?;
    assert!([3, 6].contains(&multiply), "a product of size {size}: {multiply}");
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2)?, &body);
    for of_steps in [
        in_place(&GaussMagnus::new(2, &body)?, start.clone())?,
        in_place(&GaussMagnus::new(3, &body)?, start.clone())?,
        in_place(&ExponentialMidpoint::new(&body), start.clone())?,
        in_place(&gauss, start.clone())?,
    ] {
        assert_eq!(of_steps % 3, 0, "{of_steps}");
    }
    // Four products in each of twenty steps.
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(&body));
    assert_eq!(in_place(&direct, start)?, 80 * multiply);
    Ok(())
}

/// Springs of several lengths, one behind the other: dq/dt = p, dp/dt = −q³.
struct Springs;

impl ExactFlows for Springs {
    type Point = Sites<Vector2<f64>>;
    const COUNT: usize = 2;

    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point {
        let mut end = z.clone();
        self.flow_in_place(index, time, &mut end, &mut Vec::new());
        end
    }

    fn flow_in_place(
        &self,
        index: usize,
        time: f64,
        z: &mut Self::Point,
        _: &mut Vec<Self::Point>,
    ) {
        match index {
            0 => z.iter_mut().for_each(|z| z.x += time * z.y),
            1 => z.iter_mut().for_each(|z| z.y -= time * z.x.powi(3)),
            _ => {}
        }
    }
}

impl VectorField for Springs {
    type Point = Sites<Vector2<f64>>;

    fn at(&self, z: &Self::Point) -> Self::Point {
        z.iter().map(|z| Vector2::new(z.y, -z.x.powi(3))).collect()
    }

    fn at_into(&self, z: &Self::Point, rate: &mut Self::Point) {
        rate.iter_mut().zip(z.iter()).for_each(|(rate, z)| *rate = Vector2::new(z.y, -z.x.powi(3)));
    }
}

/// Returns vortices of equal strength on a spiral.
fn spiral(count: usize) -> Result<(ManyVortices, Points), Box<dyn Error>> {
    let vortices = ManyVortices::new(vec![1.0; count])?;
    let position = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.4 * i as f64).sin_cos();
        Vector3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
    };
    let start = vortices.momentum((0..count).map(position))?;
    Ok((vortices, start))
}

/// On several threads, seen from one of them.
#[test]
#[ignore = "long"]
fn no_step_in_place_on_threads_allocates() -> Result<(), Box<dyn Error>> {
    let (vortices, start) = spiral(500)?;
    let midpoint = SphericalMidpoint::new(vortices);
    let lattice = HeisenbergLattice::new([33, 20, 15])?.with_exchange([0, 1, 1], 1.0)?;
    let spins = lattice.state(|[x, y, _]| Vector3::new(x as f64, 1.0, y as f64).normalize());
    let (general, fast) = (SphericalMidpoint::new(lattice.clone()), LatticeMidpoint::new(lattice));
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let counts = pool.install(|| {
            let counts = [
                in_place(&midpoint, start.clone()),
                in_place(&general, spins.clone()),
                in_place(&fast, spins.clone()),
            ];
            // An error of any kind cannot leave the thread.
            counts.map(|count| count.map_err(|error| error.to_string()))
        });
        assert_eq!(counts, [const { Ok(0) }; 3], "{threads} threads");
    }
    Ok(())
}

#[test]
fn no_step_in_place_of_a_state_on_the_heap_allocates() -> Result<(), Box<dyn Error>> {
    let (vortices, start) = spiral(20)?;
    let direct = |scheme| Direct::new(scheme, vortices.clone());
    assert_eq!(in_place(&direct(RungeKutta::rk4()), start.clone())?, 0);
    assert_eq!(in_place(&direct(RungeKutta::gauss(3)?), start.clone())?, 0);
    assert_eq!(in_place(&SphericalMidpoint::new(vortices.clone()), start.clone())?, 0);
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
    assert_eq!(in_place(&Direct::new(composed, vortices.clone()), start.clone())?, 0);
    let midpoint = SphericalMidpoint::new(vortices.clone());
    let composed = Composition::new(midpoint, Substeps::suzuki4());
    assert_eq!(in_place(&composed, start.clone())?, 0);
    let compensated = direct(RungeKutta::gauss(3)?).compensated();
    assert_eq!(in_place(&compensated, Start::<f64>::start(&compensated, &start)?)?, 0);
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
    let compensated = Direct::new(composed, vortices.clone()).compensated();
    assert_eq!(in_place(&compensated, Start::<f64>::start(&compensated, &start)?)?, 0);
    let springs = Splitting::strang(Springs);
    let pairs: Sites<_> = (0..50).map(|i| Vector2::new(0.1 * f64::from(i), 1.0)).collect();
    assert_eq!(in_place(&springs, pairs.clone())?, 0);
    assert_eq!(in_place(&Composition::new(springs, Substeps::yoshida4()), pairs.clone())?, 0);
    let copies = TaoFlows::<_, Alternating>::new(Springs, 3.0);
    assert_eq!(in_place(&Splitting::strang(copies), Pair(pairs.clone(), pairs))?, 0);
    let collective = CollectiveSites::new(RungeKutta::gauss(2)?, HOPF, vortices.clone());
    assert_eq!(in_place(&collective, collective.start(&start)?)?, 0);
    let free = LiftFreeSites::new(RungeKutta::gauss(2)?, Quaternions, vortices.clone());
    assert_eq!(in_place(&free, start.clone())?, 0);
    let midpoint = SphericalMidpoint::new(vortices.clone());
    let mut flow = VariationalFlow::new(&midpoint, start.clone(), [start.clone()], 0.01);
    let mut advance = |steps: u32| (0..steps).try_for_each(|_| flow.advance());
    advance(4)?;
    assert_eq!(allocations(|| Ok(advance(100)?))?, 0);
    // control: each sample of a trajectory has a state of its own
    let midpoint = direct(RungeKutta::implicit_midpoint());
    let mut run = midpoint.trajectory(&start, 0.01)?.take(10);
    assert!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))? >= 10);
    Ok(())
}

/// The midpoint rule without a lift along a path by formulas in the time.
#[test]
fn no_step_of_a_path_by_formula_allocates() -> Result<(), Box<dyn Error>> {
    let inputs = NamedInputs::default();
    let names = OpenNames::new(SystemAlgebra::named("so(3)")?, &inputs, Parameters::new())?;
    let (base, hamiltonian) = names.system("(Pi1^2 + 2*Pi2^2)/2 + cos(t)*Pi3")?;
    let field = ["0.2*cos(t)", "0", "0.1*Pi3"].map(|text| names.formula("noise", text));
    let noise = NoiseTerms {
        fields: NoiseFields::Formulas(vec![field.into_iter().collect::<Result<_, _>>()?]),
        seed: 1,
        path: 0,
        rule: NoiseRule::Together,
        interval: None,
        bound: None,
    };
    let terms = OpenTerms { inputs, hamiltonian, noise: Some(noise), ..OpenTerms::default() };
    let open = OpenSystem::new(base, terms, 0.01)?;
    let method = open.method(Formulation::Reduced, SchemeName::ImplicitMidpoint, 0.0)?;
    let start = [0.6, -0.5, 1.2];
    let integrator = open.tangent_integrator(&method, &start)?.without_tangents();
    assert_eq!(in_place(&integrator, integrator.start(&AnyState::from_slice(&start))?)?, 0);
    Ok(())
}

#[test]
fn no_step_allocates() -> Result<(), Box<dyn Error>> {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let free = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top);
    let lifted = Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, top);

    // The midpoint rule for tops by its formulas and, at 0.5, by the iteration for any system.
    let midpoint = TopMidpoint::new(top);
    for step in [0.01, 0.5] {
        let mut run = midpoint.trajectory(&start, step)?.skip(1).take(200);
        run.next();
        assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);
    }

    let mut run = lifted.trajectory(&start, 0.05)?.take(200);
    assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);

    // The first step chooses the registers.
    let side_by_side = StagesInLanes::widest(lifted.clone());
    let mut run = side_by_side.trajectory(&start, 0.05)?.skip(1).take(200);
    run.next();
    assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);

    let names = Vocabulary::of(&Se3::default(), &Parameters::new())?;
    let text = FormulaHamiltonian::<Se3>::new("|Pi|^2/2 + sin(Gamma1*Pi2)/|Gamma|", &names)?;
    let of_text = Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, text);
    let mut run = of_text.trajectory(&start, 0.05)?.take(200);
    assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);

    let kernel = CollectiveGauss::new(8, top)?;
    let mut run = kernel.trajectory(&start, 0.05)?.take(200);
    assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);

    let compensated = WithAttitude(lifted.clone().compensated());
    let mut run = compensated.trajectory(&start, 0.05)?.take(200);
    assert_eq!(allocations(|| Ok(run.try_for_each(|sample| sample.map(drop))?))?, 0);

    let run = lifted.trajectory(&start, 0.05)?.take(200);
    let mut events = Events::new(&lifted, run, |mu: &Se3Dual| mu.0.1.x, Direction::Both);
    assert_eq!(allocations(|| Ok(events.try_for_each(|event| event.map(drop))?))?, 0);

    let mut dense = DenseOutput::new(&free, free.trajectory(&start, 0.05)?);
    let at = |n: u32| 0.07 * f64::from(n);
    let count = allocations(|| Ok((0..100).try_for_each(|n| dense.at(at(n)).map(drop))?))?;
    assert_eq!(count, 0);

    let mut spectrum = LyapunovExponents::<_, 6>::new(&free, start, 0.05).take(100);
    assert_eq!(allocations(|| Ok(spectrum.try_for_each(|item| item.map(drop))?))?, 0);

    let laned = Laned::new(free);
    let (mut members, mut space) = ([start; 7], laned.workspace());
    let mut run = |steps| {
        let mut failures = 0;
        laned.advance(&mut members, 0.05, steps, &mut space, &mut |_, _| failures += 1);
        assert_eq!(failures, 0);
        Ok(())
    };
    assert_eq!(allocations(|| run(0..100))?, 0);

    // Negative control: the counter counts.
    let boxed = || {
        drop(std::hint::black_box(Box::new(1)));
        Ok(())
    };
    assert_eq!(allocations(boxed)?, 1);
    Ok(())
}
