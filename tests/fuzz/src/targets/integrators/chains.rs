//! Chains of spins, at rest and on atoms in motion: the lengths of spins, and the total momentum of atoms.

use super::kinds::Kind;
use super::schemes::{scheme, spin, steps_hold};
use crate::input::Input;
use crate::targets::conservation::{TOLERANCE, largest_turn_at, lengths_hold};
use collective_integrators::{Collective, LiftFree};
use lie_poisson::{
    Automatic, Covector, Hamiltonian, Pair, Point, Power, RealSpace, Vector, larger,
};
use lie_poisson_systems::{HeisenbergChain, SpinLattice, SpinLatticeSpace, Spins};
use momentum_map::{
    Cotangent, CotangentBundle, Identity, PowerMap, PowerMultipliers, ProductMap,
    QuadraticMomentumMap, Quaternions, Side, So3OnC2,
};
use nalgebra::SVector;

pub(super) const KINDS: &[Kind] = &[
    ("HeisenbergChain<0>", chain::<0>),
    ("HeisenbergChain<1>", chain::<1>),
    ("HeisenbergChain<2>", chain::<2>),
    ("HeisenbergChain<3>", chain::<3>),
    ("HeisenbergChain<5>", chain::<5>),
    ("SpinLattice<0>", lattice::<0>),
    ("SpinLattice<1>", lattice::<1>),
    ("SpinLattice<2>", lattice::<2>),
    ("SpinLattice<3>", lattice::<3>),
];

type SpinMap<const N: usize> = PowerMap<QuadraticMomentumMap<So3OnC2>, N>;

const fn map<const N: usize>() -> SpinMap<N> {
    PowerMap(QuadraticMomentumMap::new(So3OnC2, Side::Left))
}

fn spins<const N: usize>(input: &mut Input<'_>) -> Spins<N> {
    Covector(Power([(); N].map(|()| spin(input))))
}

fn chain<const N: usize>(input: &mut Input<'_>) -> bool {
    let Ok(chain) = HeisenbergChain::<N>::new(input.number(), input.vector()) else {
        return false;
    };
    let (start, step, (scheme, conserves)) = (spins::<N>(input), input.number(), scheme(input));
    let rate = |spins: &[_]| {
        let spins = Covector(Power::from_factors(|i| spins[i]));
        Hamiltonian::<_, f64>::differential(&chain, &spins).max_abs()
    };
    // A method without quadratic invariants promises finite numbers alone.
    let holds = |before: &Spins<N>, after: &Spins<N>| {
        let ends = [&before.0.0[..], &after.0.0];
        let turn = if conserves { largest_turn_at(ends, step, rate) } else { f64::INFINITY };
        lengths_hold(ends[0], ends[1], turn)
    };
    if input.choice(2) == 0 {
        let multipliers = PowerMultipliers::<_, N>(Quaternions);
        let lift_free = LiftFree::new(scheme, multipliers, chain);
        steps_hold(&lift_free, &start, step, |before, after| holds(before, &after.momentum))
    } else {
        let collective = Collective::new(scheme, map::<N>(), chain);
        steps_hold(&collective, &start, step, |before, after| holds(before, &after.momentum))
    }
}

type Atoms<const N: usize> = Point<SpinLatticeSpace<N>, f64>;

fn lattice<const N: usize>(input: &mut Input<'_>) -> bool {
    let [mass, stiffness, exchange, coupling] = input.numbers();
    let Ok(lattice) = SpinLattice::<N>::new(mass, stiffness, exchange, coupling) else {
        return false;
    };
    let lattice = Automatic(lattice);
    let numbers = |input: &mut Input<'_>| SVector::<f64, N>::from(input.numbers());
    let atoms = Cotangent::new(numbers(input), Covector(numbers(input)));
    let start: Atoms<N> = Pair(spins::<N>(input), atoms);
    let (step, (scheme, conserves)) = (input.number(), scheme(input));
    let map = ProductMap(map::<N>(), Identity(CotangentBundle(RealSpace::<N>)));
    let collective = Collective::new(scheme, map, lattice);
    steps_hold(&collective, &start, step, |before, after| {
        let after = &after.momentum;
        let both = |size: fn(&Atoms<N>) -> f64| larger(size(before), size(after));
        let [spin, q, p] =
            [both(|z| z.0.max_abs()), both(|z| z.1.q.max_abs()), both(|z| z.1.p.max_abs())];
        // Atoms may swing out between the ends. Differences have the rounding errors of their terms.
        let reach = q + step.abs() * p / mass;
        let turn = step.abs() * 4.0 * spin * (exchange.abs() + 2.0 * coupling.abs() * reach);
        let turn = if conserves { turn } else { f64::INFINITY };
        if !lengths_hold(&before.0.0.0, &after.0.0.0, turn) {
            return false;
        }
        let force = 4.0 * (stiffness * reach + coupling.abs() * spin * spin);
        // The forces between atoms cancel, but not their rounding errors.
        let size = p + step.abs() * force;
        let change = (after.1.p.0.sum() - before.1.p.0.sum()).abs();
        let holds = change <= TOLERANCE * size + f64::MIN_POSITIVE || !size.is_finite();
        assert!(holds, "{lattice:?} {step:e}: {change:e} of {size:e}, {before:?} {after:?}");
        true
    })
}
