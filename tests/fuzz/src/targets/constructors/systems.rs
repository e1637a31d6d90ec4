//! Bodies, vortices and spins: steps fail, or are finite and conserve what they should.

use super::steps;
use crate::input::Input;
use crate::targets::conservation::{largest_turn, largest_turn_at, lengths_hold, steps_on_se3};
use collective_integrators::{
    Direct, HamiltonianField, LiftFree, RungeKutta, SphericalMidpoint, Start,
};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, Power, Se3Dual, larger};
use lie_poisson_systems::{
    Gyrostat, HeisenbergLattice, KidaVortex, Kirchhoff, LatticeMidpoint, ManyVortices,
    MovableBaseAlgebra, MovableBaseTop, PointVortices, So21,
};
use momentum_map::{PowerMultipliers, Quaternions};
use nalgebra::{Matrix3, Vector3};

pub(super) fn gyrostat(input: &mut Input<'_>) {
    let Ok(gyrostat) =
        Gyrostat::new(input.moments(), input.number(), input.vector(), input.vector())
    else {
        return;
    };
    let start = Se3Dual::new(input.vector(), input.vector());
    steps_on_se3(&gyrostat, &start, input.number());
}

pub(super) fn kirchhoff(input: &mut Input<'_>) {
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

pub(super) fn vortices(input: &mut Input<'_>) {
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

pub(super) fn many_vortices(input: &mut Input<'_>) {
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

pub(super) fn kida_vortex(input: &mut Input<'_>) {
    let Ok(vortex) = KidaVortex::new(input.number(), input.number(), input.number()) else {
        return;
    };
    let Ok(start) = KidaVortex::momentum(input.number(), input.number(), input.number()) else {
        return;
    };
    let field = HamiltonianField { space: LiePoisson::plus(So21), hamiltonian: vortex };
    steps(&Direct::new(RungeKutta::rk4(), field), &start, input.number());
}

pub(super) fn movable_base(input: &mut Input<'_>) {
    let top = MovableBaseTop::new(input.moments(), input.numbers(), input.number(), input.vector());
    let Ok(top) = top else { return };
    let start = Covector(Pair(Pair(input.vector(), input.vector()), input.vector()));
    let space = LiePoisson::minus(MovableBaseAlgebra::default());
    let field = HamiltonianField { space, hamiltonian: top };
    steps(&Direct::new(RungeKutta::rk4(), field), &start, input.number());
}

pub(super) fn lattice(input: &mut Input<'_>) {
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
