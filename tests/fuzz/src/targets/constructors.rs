//! Constructors: parameters are refused, or what is made of them obeys its laws.

use super::conservation::{
    LARGEST_TURN, SAFE, largest_turn, largest_turn_at, lengths_hold, steps_on_se3,
};
use crate::input::Input;
use collective_integrators::{
    AlternatingSubsteps, Direct, HamiltonianField, LiftFree, PartitionedRungeKutta, RungeKutta,
    SphericalMidpoint, Start, Substeps, Tableau,
};
use collective_integrators::{Direction, FirstHalf, Integrator};
use heavytop::{
    Coordinate, EnergyLevel, EulerSolution, HeavyTop, Invariant, JacobiElliptic, LagrangeNutation,
    RigidBody, Section, Surface,
};
use isospectral_flows::{
    ExponentialMidpoint, GaussMagnus, IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, Power, Se3, Se3Dual, State, StructureConstants,
    Vector, larger,
};
use lie_poisson_systems::{
    GeneralisedRigidBody, Gyrostat, HeisenbergLattice, KidaVortex, Kirchhoff, LatticeMidpoint,
    ManyVortices, MovableBaseAlgebra, MovableBaseTop, PointVortices, So21, Zeitlin,
};
use momentum_map::{PowerMultipliers, Quaternions};
use nalgebra::{Matrix3, Vector3};

pub(crate) fn run(case: &[u8]) {
    let input = &mut Input::new(case);
    match input.choice(16) {
        0 => euler_solution(input),
        1 => lagrange_nutation(input),
        2 => elliptic_functions(input),
        3 => section(input),
        4 => tableau(input),
        5 => substeps(input),
        6 => structure_constants(input),
        7 => gyrostat(input),
        8 => kirchhoff(input),
        9 => vortices(input),
        10 => kida_vortex(input),
        11 => movable_base(input),
        12 => lattice(input),
        13 => generalised_rigid_body(input),
        14 => zeitlin(input),
        _ => many_vortices(input),
    }
}

/// Asserts that steps of an integrator fail, or lead to a finite state.
fn steps<I>(integrator: &I, start: &I::Momentum, step: f64)
where
    I: Start<Momentum: Vector<Scalar = f64>>,
{
    if let Ok(sample) = integrator.after(start, step, 2) {
        assert!(
            sample.momentum.max_abs().is_finite(),
            "{start:?}, {step:e}: {:?}",
            sample.momentum
        );
    }
}

fn euler_solution(input: &mut Input<'_>) {
    let Ok(body) = RigidBody::new(input.moments()) else { return };
    let start = input.vector();
    let Ok(solution) = EulerSolution::new(&body, start) else { return };
    let time = input.number();
    let size = start.amax();
    if !time.is_finite() || size == 0.0 || !(1e-300..1e300).contains(&size) {
        return;
    }
    let pi = solution.at(time);
    if pi.x.is_nan() && time.abs() * size * body.inertia().min().recip() > 1e290 {
        return; // The phase overflows.
    }
    let lengths = [start, pi].map(|pi| (pi / size).norm());
    assert!((lengths[1] / lengths[0] - 1.0).abs() < 1e-12, "{body:?} {start:?} {time:e}: {pi:?}");
}

fn lagrange_nutation(input: &mut Input<'_>) {
    let [moment, axial, weight] = [input.number(), input.number(), input.number()].map(f64::abs);
    let Ok(top) = HeavyTop::lagrange(moment, axial, weight) else { return };
    let start = Se3Dual::new(input.vector(), input.vector());
    let Ok(nutation) = LagrangeNutation::new(&top, &start) else { return };
    let (lowest, highest) = nutation.turning_points();
    let time = input.number();
    assert!(lowest <= highest, "{top:?} {start:?}: {lowest:e} {highest:e}");
    assert!(nutation.period() > 0.0, "{top:?} {start:?}");
    if time.is_finite() {
        let height = nutation.height(time);
        if height.is_nan() && time.abs() / nutation.period() > 1e290 {
            return; // The phase overflows.
        }
        let slack = 1e-14 * lowest.abs().max(highest.abs());
        assert!(
            (lowest - slack..=highest + slack).contains(&height),
            "{top:?} {start:?}, at {time:e}: {height:e} of {lowest:e} to {highest:e}"
        );
    }
}

fn elliptic_functions(input: &mut Input<'_>) {
    let (m, u) = (input.number(), input.number());
    let functions = if input.choice(2) == 0 {
        JacobiElliptic::new(m)
    } else {
        JacobiElliptic::with_complement(m)
    };
    let Ok(functions) = functions else { return };
    assert!(functions.quarter_period() > 1.5, "{m:e}");
    if u.is_finite() {
        let [sn, cn, dn, am] = functions.at(u);
        assert!((sn.hypot(cn) - 1.0).abs() < 1e-14, "{m:e} {u:e}: {sn:e} {cn:e} {am:e}");
        assert!((0.0..=1.0 + 1e-15).contains(&dn), "{m:e} {u:e}: {dn:e}");
    }
}

fn section(input: &mut Input<'_>) {
    let body = heavytop::Body {
        inertia: input.moments(),
        mass: input.number(),
        gravity: input.number(),
        length: input.ordinary(),
        center_of_mass: input.direction(),
    };
    let Ok(top) = HeavyTop::new(&body) else { return };
    let level = EnergyLevel { top, energy: input.number(), vertical_momentum: input.number() };
    let coordinates = [
        Coordinate::Gamma1,
        Coordinate::Gamma2,
        Coordinate::Gamma3,
        Coordinate::Pi1,
        Coordinate::Pi3,
    ];
    let coordinate = coordinates[input.choice(coordinates.len())];
    let direction = [Direction::Up, Direction::Down, Direction::Both][input.choice(3)];
    let surface = Surface { coordinate, level: input.number(), direction };
    let Ok(section) = Section::new(level, surface) else { return };
    let plane = nalgebra::Vector2::new(input.ordinary(), input.number());
    for mu in section.states(&plane) {
        let Covector(Pair(pi, gamma)) = mu;
        let energy = pi.dot(&pi.component_div(&top.inertia())) / 2.0 + top.weight_moment();
        let size = energy.abs().max(level.energy.abs());
        let error = (Invariant::Energy.value(&top, &mu) - level.energy).abs();
        let finite = pi.amax().is_finite() && gamma.amax().is_finite();
        assert!(finite, "{section:?} {mu:?}");
        let safe = [size, level.energy.abs(), top.inertia().min(), top.inertia().max()];
        assert!(
            error < 1e-9 * size || !safe.iter().all(|x| SAFE.contains(x)),
            "{section:?} {mu:?}: {error:e} of {size:e}"
        );
        assert!((gamma.norm() - 1.0).abs() < 1e-12, "{section:?} {mu:?}");
    }
}

fn tableau(input: &mut Input<'_>) {
    let stages = input.choice(4);
    let a: Vec<f64> = (0..stages * stages).map(|_| input.number()).collect();
    let b: Vec<f64> = (0..stages).map(|_| input.number()).collect();
    let Ok(tableau) = Tableau::new(&a, &b) else { return };
    let _ = PartitionedRungeKutta::<FirstHalf>::new(tableau.clone(), tableau.clone());
    let start = Se3Dual::new(input.vector(), input.vector());
    let Ok(top) = HeavyTop::kovalevskaya(1.0, 1.0) else { return };
    let direct = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    steps(&Direct::new(RungeKutta::new(tableau), direct), &start, input.number());
}

fn substeps(input: &mut Input<'_>) {
    let count = input.choice(6);
    let mut fractions: Vec<f64> = (0..count).map(|_| input.number()).collect();
    if input.choice(2) == 0 {
        fractions.push(1.0 - fractions.iter().sum::<f64>());
    }
    if let Ok(substeps) = Substeps::new(&fractions) {
        assert!(
            (substeps.fractions().iter().sum::<f64>() - 1.0).abs() <= 1.001e-8,
            "{fractions:?}"
        );
    }
    let _ = AlternatingSubsteps::new(&fractions, &fractions);
}

fn structure_constants(input: &mut Input<'_>) {
    let table: [[f64; 3]; 3] = [(); 3].map(|()| input.numbers());
    let c = |i: usize, j: usize, k: usize| match (i, j) {
        (0, 1) => table[0][k],
        (1, 0) => -table[0][k],
        (0, 2) => table[1][k],
        (2, 0) => -table[1][k],
        (1, 2) => table[2][k],
        (2, 1) => -table[2][k],
        _ => 0.0,
    };
    let _ = StructureConstants::<3>::new(c);
}

fn gyrostat(input: &mut Input<'_>) {
    let Ok(gyrostat) =
        Gyrostat::new(input.moments(), input.number(), input.vector(), input.vector())
    else {
        return;
    };
    let start = Se3Dual::new(input.vector(), input.vector());
    steps_on_se3(&gyrostat, &start, input.number());
}

fn kirchhoff(input: &mut Input<'_>) {
    let mut symmetric = || {
        let half = Matrix3::from(
            input
                .numbers::<9>()
                .map(|x| x / 2.0)
                .as_chunks::<3>()
                .0
                .to_vec()
                .try_into()
                .unwrap_or([[0.0; 3]; 3]),
        );
        half + half.transpose()
    };
    let (a, b, c) = (symmetric(), symmetric(), symmetric());
    let definite = if input.choice(2) == 0 { Matrix3::identity() } else { Matrix3::zeros() };
    let Ok(body) = Kirchhoff::new(a * a + definite, b, c * c + definite) else { return };
    let start = Se3Dual::new(input.vector(), input.vector());
    steps_on_se3(&body, &start, input.number());
}

fn vortices(input: &mut Input<'_>) {
    let Ok(vortices) = PointVortices::<3>::new(input.numbers()) else { return };
    let start = vortices.momentum(&[(); 3].map(|()| input.direction()));
    let multipliers = PowerMultipliers::<_, 3>(Quaternions);
    let midpoint = LiftFree::new(RungeKutta::implicit_midpoint(), multipliers, vortices);
    let step = input.number();
    let rate = |m: &[Vector3<f64>]| {
        let [a, b, c] = m else { return f64::NAN };
        let dh: Power<Vector3<f64>, 3> = vortices.differential(&Covector(Power([*a, *b, *c])));
        dh.0.iter().map(|dh| dh.amax()).fold(0.0, larger)
    };
    let Ok(run) = midpoint.trajectory(&start, step) else { return };
    let mut before = start.0.0;
    for sample in run.take(3).skip(1) {
        let Ok(sample) = sample else { return };
        let after = sample.momentum.0.0;
        lengths_hold(&before, &after, largest_turn_at([&before, &after], step, rate));
        before = after;
    }
}

fn many_vortices(input: &mut Input<'_>) {
    let count = input.choice(5);
    let Ok(vortices) = ManyVortices::new((0..count).map(|_| input.number()).collect()) else {
        return;
    };
    let positions: Vec<Vector3<f64>> = (0..input.choice(5)).map(|_| input.direction()).collect();
    let Ok(start) = vortices.momentum(positions) else { return };
    let (spherical, step) = (SphericalMidpoint::new(vortices.clone()), input.number());
    let Ok(sample) = spherical.after(&start, step, 1) else { return };
    let ends = [&start.0[..], &sample.momentum.0];
    lengths_hold(ends[0], ends[1], largest_turn(&vortices, ends, step));
}

fn kida_vortex(input: &mut Input<'_>) {
    let Ok(vortex) = KidaVortex::new(input.number(), input.number(), input.number()) else {
        return;
    };
    let Ok(start) = KidaVortex::momentum(input.number(), input.number(), input.number()) else {
        return;
    };
    let field = HamiltonianField { space: LiePoisson::plus(So21), hamiltonian: vortex };
    steps(&Direct::new(RungeKutta::rk4(), field), &start, input.number());
}

fn movable_base(input: &mut Input<'_>) {
    let top = MovableBaseTop::new(input.moments(), input.numbers(), input.number(), input.vector());
    let Ok(top) = top else { return };
    let start = Covector(Pair(Pair(input.vector(), input.vector()), input.vector()));
    let space = LiePoisson::minus(MovableBaseAlgebra::default());
    let field = HamiltonianField { space, hamiltonian: top };
    steps(&Direct::new(RungeKutta::rk4(), field), &start, input.number());
}

fn lattice(input: &mut Input<'_>) {
    let sizes = [0, 1, 2, 3, 5, usize::MAX, 1 << 40, 1 << 21];
    let cells = [(); 3].map(|()| sizes[input.choice(sizes.len())]);
    let offset = [(); 3].map(|()| [0, 1, -1, 2, i64::MAX, i64::MIN][input.choice(6)]);
    let Ok(lattice) = HeisenbergLattice::new(cells) else { return };
    let lattice = lattice
        .with_exchange(offset, input.number())
        .and_then(|lattice| lattice.with_anisotropy(input.direction(), input.number()))
        .and_then(|lattice| lattice.with_field(input.vector()));
    let Ok(lattice) = lattice else { return };
    if lattice.count() > 200 {
        return;
    }
    let (one, other, step) = (input.vector(), input.vector(), input.number());
    let start = lattice.state(|[i, j, k]| if (i + j + k) % 2 == 0 { one } else { other });
    let Ok(sample) = LatticeMidpoint::new(lattice.clone()).after(&start, step, 1) else { return };
    let ends = [&start.0[..], &sample.momentum.0];
    lengths_hold(ends[0], ends[1], largest_turn(&lattice, ends, step));
}

/// Asserts that a step fails, or is finite and conserves the norm up to the rounding errors of the step times the generator.
fn isospectral<I: Integrator<f64, State = LargeSkewHermitian>>(
    integrator: &I,
    field: &impl IsospectralField,
    mut w: LargeSkewHermitian,
    step: f64,
) {
    let rate = |w: &LargeSkewHermitian| {
        let mut generator = w.clone();
        field.generator_into(w, &mut generator);
        step.abs() * generator.norm()
    };
    let (norm, before) = (w.norm(), rate(&w));
    let size = w.size();
    let stiff = (0..size).any(|i| {
        let unit = LargeSkewHermitian::from_upper(size, |j, k| {
            nalgebra::Complex::new(if j == i && k > j { norm } else { 0.0 }, 0.0)
        });
        rate(&unit) > LARGEST_TURN
    });
    let mut workspace = integrator.workspace();
    if integrator.step_in_place(&mut w, step, &mut workspace).is_ok() {
        assert!((0..w.dimension()).all(|i| w.entry(i).is_finite()), "{step:e}: {w:?}");
        let after = w.norm();
        let round_off = 1e-11 + 1e-12 * before.max(rate(&w));
        // Where another matrix of this norm turns by many radians, Q need only be unitary to 1e-3.
        let allowed = if stiff { 1e-2 } else { round_off.min(1e-2) };
        assert!(
            (after / norm - 1.0).abs() <= allowed || !SAFE.contains(&norm),
            "{step:e}: {norm:e} {after:e}, {before:e} {:e}",
            rate(&w)
        );
    }
}

fn generalised_rigid_body(input: &mut Input<'_>) {
    let size = input.choice(6);
    let Ok(body) = GeneralisedRigidBody::new((0..size).map(|_| input.number()).collect()) else {
        return;
    };
    let entries: [f64; 15] = input.numbers();
    let start = body.momentum(|j, k| entries[(j * 5 + k) % 15]);
    let step = input.number();
    let midpoint = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), &body);
    isospectral(&midpoint, &body, start.clone(), step);
    if let Ok(magnus) = GaussMagnus::new(2, &body) {
        isospectral(&magnus, &body, start, step);
    }
}

fn zeitlin(input: &mut Input<'_>) {
    let Ok(fluid) = Zeitlin::new(input.choice(6)) else { return };
    let Ok(fluid) = fluid.with_rotation(input.number()) else { return };
    let entries: [f64; 8] = input.numbers();
    let size = fluid.laplacian().size();
    let start = LargeSkewHermitian::from_upper(size, |j, k| {
        let at = |i: usize| entries[i % 8];
        nalgebra::Complex::new(if j == k { 0.0 } else { at(j + 2 * k) }, at(3 * j + k))
    });
    isospectral(&ExponentialMidpoint::new(&fluid), &fluid, start, input.number());
}
