//! Erratum 6 to §5.1: a symplectic scheme that treats q and p differently is not equivariant under χ ↦ χ + bψ. It
//! neither descends to se(3)* nor conserves f₁.
//!
//! The schemes are written here as plain maps of T*C²; [`Collective::new`](collective_integrators::Collective::new) takes them only if
//! someone promises that they are [`Equivariant`](collective_integrators::Equivariant).

use collective_integrators::{RungeKutta, Scheme, VectorField};
use heavytop::{HeavyTop, Invariant, SpinorPoint, SpinorRealisation};
use lie_poisson::{DualNumber, Real, Vector, derivative_part, seed};
use momentum_map::{CollectiveHamiltonian, Cotangent, FibreSymmetry, PoissonMap, SymplecticSpace};
use std::error::Error;
use workspace_tests::{assert_close, tops};

type Outcome = Result<(), Box<dyn Error>>;
type System = CollectiveHamiltonian<SpinorRealisation, HeavyTop>;

/// Solves z = f(z) from a first guess; f contracts by a factor of h|Ω|, 0.1 here.
fn fixed_point<T: Real>(
    guess: SpinorPoint<T>,
    f: impl Fn(&SpinorPoint<T>) -> SpinorPoint<T>,
) -> SpinorPoint<T> {
    (0..60).fold(guess, |z, _| f(&z))
}

/// Makes a step of symplectic Euler, implicit in p: p₁ = p₀ − h H_q(q₀, p₁), q₁ = q₀ + h H_p(q₀, p₁).
fn euler_p_first<T: Real>(system: &System, z: &SpinorPoint<T>, h: f64) -> SpinorPoint<T> {
    let h = T::from_f64(h);
    let middle =
        fixed_point(*z, |guess| Cotangent { q: z.q, p: z.p + system.at(guess).p.scaled(h) });
    let q = z.q + system.at(&middle).q.scaled(h);
    Cotangent { q, p: middle.p }
}

/// Makes a step of symplectic Euler, implicit in q, the adjoint of the other: q₁ = q₀ + h H_p(q₁, p₀), p₁ = p₀ − h
/// H_q(q₁, p₀).
fn euler_q_first<T: Real>(system: &System, z: &SpinorPoint<T>, h: f64) -> SpinorPoint<T> {
    let h = T::from_f64(h);
    let middle =
        fixed_point(*z, |guess| Cotangent { p: z.p, q: z.q + system.at(guess).q.scaled(h) });
    let p = z.p + system.at(&middle).p.scaled(h);
    Cotangent { q: middle.q, p }
}

/// Makes a step of Störmer–Verlet: half a step of each Euler method.
fn stoermer_verlet<T: Real>(system: &System, z: &SpinorPoint<T>, h: f64) -> SpinorPoint<T> {
    euler_q_first(system, &euler_p_first(system, z, 0.5 * h), 0.5 * h)
}

fn midpoint<T: Real>(system: &System, z: &SpinorPoint<T>, h: f64) -> SpinorPoint<T> {
    // The step is that of the scheme on T*C² itself: the collective integrator also moves along the fibre.
    let scheme = RungeKutta::implicit_midpoint();
    let step = scheme.step::<T, _>(system, z, h, &mut scheme.workspace());
    step.map_or_else(|_| z.scaled(T::from_f64(f64::NAN)), |step| step.point)
}

fn paper() -> Result<(System, SpinorPoint), Box<dyn Error>> {
    let system = CollectiveHamiltonian::new(SpinorRealisation, tops::paper()?);
    Ok((system, SpinorRealisation.lift_with(&tops::paper_start(), 1.0)?))
}

/// Returns max |DΦᵀ Ω DΦ − Ω| over pairs of basis vectors.
fn symplectic_defect(
    step: impl Fn(&SpinorPoint<DualNumber>) -> SpinorPoint<DualNumber>,
    z: &SpinorPoint,
) -> f64 {
    let space = SpinorRealisation.source();
    let n = SpinorPoint::<f64>::DIM;
    let columns: Vec<SpinorPoint> =
        (0..n).map(|k| derivative_part(&step(&seed(z, &SpinorPoint::basis(k))))).collect();
    let mut largest = 0.0;
    for i in 0..n {
        for j in 0..n {
            let after = space.symplectic_form::<f64>(&columns[i], &columns[j]);
            let (u, v) = (SpinorPoint::basis(i), SpinorPoint::basis(j));
            let change = (after - space.symplectic_form::<f64>(&u, &v)).abs();
            largest = lie_poisson::larger(largest, change);
        }
    }
    largest
}

/// All of these schemes are symplectic on T*C², to the round-off of products of numbers up to 10. The explicit
/// midpoint rule, as negative control, is not.
#[test]
fn they_are_symplectic() -> Outcome {
    let (system, z) = paper()?;
    assert!(symplectic_defect(|z| euler_p_first(&system, z, 0.02), &z) < 1e-13);
    assert!(symplectic_defect(|z| euler_q_first(&system, z, 0.02), &z) < 1e-13);
    assert!(symplectic_defect(|z| stoermer_verlet(&system, z, 0.02), &z) < 1e-13);
    assert!(symplectic_defect(|z| midpoint(&system, z, 0.02), &z) < 1e-13);
    let explicit = |z: &SpinorPoint<DualNumber>| {
        let half = system.at(z).scaled(DualNumber::constant(0.01));
        *z + system.at(&(*z + half)).scaled(DualNumber::constant(0.02))
    };
    assert!(symplectic_defect(explicit, &z) > 1e-5);
    Ok(())
}

/// Returns f₁ at the end minus f₁ at the start, over 1000 steps of 1/50.
fn change_of_f1(
    step: impl Fn(&SpinorPoint) -> SpinorPoint,
    z: SpinorPoint,
) -> Result<f64, Box<dyn Error>> {
    let (top, mut z) = (tops::paper()?, z);
    for _ in 0..1000 {
        z = step(&z);
    }
    Ok(Invariant::VerticalSquared.value(&top, &SpinorRealisation.apply(&z)) - 1.0)
}

/// Symplectic Euler changes f₁ by −0.98 or +33.9, Störmer–Verlet by −0.033; the midpoint rule by
/// round-off.
#[test]
fn they_lose_f1() -> Outcome {
    let (system, z) = paper()?;
    let mut euler = [
        change_of_f1(|z| euler_p_first(&system, z, 0.02), z)?,
        change_of_f1(|z| euler_q_first(&system, z, 0.02), z)?,
    ];
    euler.sort_by(f64::total_cmp);
    // The numbers agree to the digits given.
    assert!((euler[0] + 0.98).abs() < 0.005 && (euler[1] - 33.9).abs() < 0.05);
    let verlet = change_of_f1(|z| stoermer_verlet(&system, z, 0.02), z)?;
    assert!((verlet + 0.033).abs() < 0.0005);
    assert!(change_of_f1(|z| midpoint(&system, z, 0.02), z)?.abs() < 1e-12);
    Ok(())
}

/// Two lifts of one momentum, apart by bψ with b = 1, have different images after a step: there is no map of se(3)*.
/// The midpoint rule sends both to one point.
#[test]
fn they_do_not_descend() -> Outcome {
    let (system, z) = paper()?;
    let other = SpinorRealisation.flow(0, 1.0, &z);
    let apart = |step: &dyn Fn(&SpinorPoint) -> SpinorPoint| {
        let image = |z: &SpinorPoint| SpinorRealisation.apply(&step(z));
        (image(&other) - image(&z)).max_abs()
    };
    let verlet = apart(&|z| stoermer_verlet(&system, z, 0.02));
    assert!(apart(&|z| euler_p_first(&system, z, 0.02)) > 5e-4);
    assert!(apart(&|z| euler_q_first(&system, z, 0.02)) > 5e-4);
    assert!(verlet > 5e-6);
    assert_close(apart(&|z| midpoint(&system, z, 0.02)), 0.0, 1e-14);
    Ok(())
}
