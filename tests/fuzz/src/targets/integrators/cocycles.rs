//! Cocycles of algebras with few dimensions, and motions on the Clebsch spaces of the representations that they extend.

use super::kinds::Kind;
use super::schemes::{scheme, steps_hold};
use crate::input::Input;
use crate::targets::conservation::{LARGEST_TURN, SAFE, TOLERANCE};
use collective_integrators::Collective;
use core::cell::Cell;
use lie_poisson::{
    Cocycle, CocycleExtension, Contragredient, Diagonal, Differential, Hamiltonian,
    InfinitesimalAdjoint, LieAlgebra, LiePoisson, Momentum, Real, Representation, So3, State,
    StructureConstants, Vector, larger,
};
use momentum_map::{PoissonMap, Side, clebsch_realisation};

pub(super) const KINDS: &[Kind] = &[
    ("Cocycle on so(3)", |input| moves(input, InfinitesimalAdjoint(So3), 1.0, length)),
    ("Cocycle on so(3)∗", |input| {
        moves(input, Contragredient(InfinitesimalAdjoint(So3)), 1.0, length)
    }),
    ("Cocycle on translations and dilations", |input| {
        dilations(input).is_some_and(|(algebra, unit)| {
            moves(input, InfinitesimalAdjoint(algebra), unit, direction)
        })
    }),
    ("Cocycle on the dual of translations and dilations", |input| {
        dilations(input).is_some_and(|(algebra, unit)| {
            moves(input, Contragredient(InfinitesimalAdjoint(algebra)), unit, direction)
        })
    }),
    ("Cocycle on affine maps", |input| {
        let unit = input.number();
        let algebra = StructureConstants::<2>::new(|i, j, k| match (i, j, k) {
            (0, 1, 0) => unit,
            (1, 0, 0) => -unit,
            _ => 0.0,
        });
        algebra.is_ok_and(|algebra| moves(input, InfinitesimalAdjoint(algebra), unit, nothing))
    }),
    ("Cocycle on a line", |input| {
        let line = StructureConstants::<1>::new(|_, _, _| 0.0);
        line.is_ok_and(|line| moves(input, InfinitesimalAdjoint(line), 0.0, value))
    }),
    ("Cocycle on a point", |input| {
        let point = StructureConstants::<0>::new(|_, _, _| 0.0);
        point.is_ok_and(|point| moves(input, InfinitesimalAdjoint(point), 0.0, nothing))
    }),
];

/// Returns the algebra [e₀, e₂] = u e₀, [e₁, e₂] = u e₁ with its unit u.
fn dilations(input: &mut Input<'_>) -> Option<(StructureConstants<3>, f64)> {
    let unit = input.number();
    let algebra = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
        (0, 2, 0) | (1, 2, 1) => unit,
        (2, 0, 0) | (2, 1, 1) => -unit,
        _ => 0.0,
    });
    Some((algebra.ok()?, unit))
}

/// A function of two momenta that is zero where they have the same Casimirs: a sum of products of their coordinates.
type Casimir<M> = fn(&M, &M) -> f64;

fn length<M: Vector<Scalar = f64>>(a: &M, b: &M) -> f64 {
    let square = |mu: &M| (0..3).map(|i| mu.coordinate(i).powi(2)).sum::<f64>();
    square(b) - square(a)
}

/// Returns μ₀ν₁ − μ₁ν₀, since μ₁/μ₀ is a Casimir.
fn direction<M: Vector<Scalar = f64>>(a: &M, b: &M) -> f64 {
    a.coordinate(0) * b.coordinate(1) - a.coordinate(1) * b.coordinate(0)
}

fn value<M: Vector<Scalar = f64>>(a: &M, b: &M) -> f64 {
    b.coordinate(0).powi(2) - a.coordinate(0).powi(2)
}

fn nothing<M>(_: &M, _: &M) -> f64 {
    0.0
}

/// The Hamiltonian Σ w_i μ_i²/2.
#[derive(Clone, Debug)]
struct Form([f64; 3]);

impl<A: LieAlgebra, T: Real> Hamiltonian<LiePoisson<A>, T> for Form {
    fn value(&self, mu: &Momentum<A, T>) -> T {
        let term = |i: usize| mu.coordinate(i) * mu.coordinate(i) * (0.5 * self.0[i]);
        (0..A::Element::<T>::DIM).fold(T::zero(), |sum, i| sum + term(i))
    }

    fn differential(&self, mu: &Momentum<A, T>) -> Differential<LiePoisson<A>, T> {
        Vector::from_coordinates(|i| mu.coordinate(i) * self.0[i])
    }
}

/// Returns a cocycle with its largest entry: of a given matrix, or the nearest one to it, or a multiple of it.
fn cocycle<R: Representation + core::fmt::Debug>(
    input: &mut Input<'_>,
    representation: &R,
) -> Option<(Cocycle<R>, f64)> {
    let matrix: [f64; 9] = input.numbers();
    let of_target = Cell::new(0.0);
    let entries = |i: usize, j: usize| {
        let entry = matrix[(3 * i + j) % 9];
        of_target.set(larger(of_target.get(), entry.abs()));
        entry
    };
    let largest = |c: &Cocycle<R>| {
        let entries = (0..9).map(|place| c.entry(place / 3, place % 3).abs());
        entries.fold(0.0, larger)
    };
    let mut c = if input.choice(4) == 0 {
        Cocycle::new(representation.clone(), entries).ok()?
    } else {
        let nearest = Cocycle::nearest_to(representation.clone(), entries).ok()?;
        let (size, of_target) = (largest(&nearest), of_target.get());
        let said = || format!("{nearest:?}, nearest to {matrix:?}");
        // A projection makes no vector longer, and one of nine entries is at most three times its largest one.
        assert!(size <= 3.0 * of_target * (1.0 + TOLERANCE), "{}", said());
        // The equation has the rounding errors of the target, and is tested to 1e-10 of the cocycle.
        let again = Cocycle::new(representation.clone(), |i, j| nearest.entry(i, j));
        assert!(again.is_ok() || size < 1e-4 * of_target, "{} {again:?}", said());
        nearest
    };
    if input.choice(2) == 0 {
        c = c.scaled(input.number()).ok()?;
    }
    let size = largest(&c);
    assert!(size.is_finite(), "{c:?}");
    Some((c, size))
}

/// Asserts that motions on two copies of an extended representation, whose largest matrix element is `unit`, conserve the
/// Casimir if they are maps of 𝔤∗.
fn moves<R: Representation + core::fmt::Debug>(
    input: &mut Input<'_>,
    representation: R,
    unit: f64,
    casimir: Casimir<Momentum<R::Algebra>>,
) -> bool {
    let Some((c, size)) = cocycle(input, &representation) else { return false };
    let side = if input.choice(2) == 0 { Side::Left } else { Side::Right };
    let extension = Diagonal::<_, 2>(CocycleExtension(c));
    let Ok(map) = clebsch_realisation(extension, side) else { return false };
    let (scheme, conserves) = scheme(input);
    let conserves = conserves && map.equivariant_maps_descend();
    let (form, step) = (Form(input.numbers()), input.number());
    let numbers: [f64; 3] = input.numbers();
    let start = Momentum::<R::Algebra>::from_coordinates(|i| numbers[i]);
    let elements = unit.abs() + size;
    let collective = Collective::new(scheme, map, form.clone());
    let mut terms = 0.0;
    steps_hold(&collective, &start, step, |before, after| {
        let (mu, z) = (&after.momentum, &after.state);
        let [q, p] = [z.q.max_abs(), z.p.max_abs()];
        // M(z) is a sum of products of a matrix element with a coordinate of q and one of p, whose rounding errors it has.
        let size = larger(before.max_abs(), mu.max_abs());
        terms = larger(terms, larger(elements * q * p, size));
        let rate = form.0.iter().fold(0.0, |m, w| larger(m, w.abs())) * size;
        let turn = step.abs() * rate * elements;
        if !conserves {
            return false;
        }
        let is_safe = [q, p, elements, terms].iter().all(|size| SAFE.contains(size));
        if turn >= LARGEST_TURN || turn.is_nan() || !is_safe {
            return false;
        }
        let [a, b] = [before, mu].map(|mu| mu.scaled(terms.recip()));
        let change = casimir(&a, &b).abs();
        let said = || format!("{change:e}, {turn:e}: {collective:?} {step:e} {before:?} {after:?}");
        assert!(change < TOLERANCE, "{}", said());
        true
    })
}
