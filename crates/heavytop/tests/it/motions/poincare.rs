//! Poincaré sections of tops: surfaces, starts, return maps and their invariants.

use collective_integrators::{Collective, Direction, EventError, LiftFree, RungeKutta, Start};
use heavytop::{
    Body, Coordinate, EnergyLevel, HeavyTop, HeavyTopSpace, Invariant, Section, SectionError,
    SpinorRealisation, Surface, SurfaceVariable,
};
use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, Se3, Se3Dual};
use momentum_map::DualQuaternions;
use nalgebra::{Matrix2, Vector2, Vector3};
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn generic() -> Outcome<HeavyTop> {
    let body = Body {
        inertia: Vector3::new(2.0, 1.5, 1.0),
        mass: 1.0,
        gravity: 1.0,
        length: 1.0,
        center_of_mass: Vector3::new(0.6, 0.0, 0.8),
    };
    Ok(HeavyTop::new(&body)?)
}

fn surface(variable: impl Into<SurfaceVariable>, level: f64, direction: Direction) -> Surface {
    Surface { variable: variable.into(), level, direction }
}

fn on(top: HeavyTop, vertical_momentum: f64, surface: Surface) -> Outcome<Section> {
    Ok(Section::new(EnergyLevel { top, energy: 1.7, vertical_momentum }, surface)?)
}

/// Returns Gauss's method of order 10, whose error at steps of 0.1 is round-off here.
fn gauss(top: HeavyTop) -> Outcome<LiftFree<RungeKutta, DualQuaternions, HeavyTop>> {
    Ok(LiftFree::new(RungeKutta::gauss(5)?, DualQuaternions, top))
}

fn returns(section: &Section, start: &Se3Dual, count: usize) -> Outcome<Vec<Se3Dual>> {
    let integrator = gauss(section.level().top)?;
    let crossings = section.crossings(&integrator, start, 0.1, 100_000)?.take(count);
    let found: Result<Vec<Se3Dual>, EventError> =
        crossings.map(|crossing| Ok(crossing?.momentum)).collect();
    Ok(found?)
}

#[test]
fn starts_are_on_level_and_surface_and_cross_it_in_its_direction() -> Outcome {
    let (top, space) = (generic()?, LiePoisson::minus(Se3::default()));
    for variable in SurfaceVariable::ALL {
        for (direction, sides) in [
            (Direction::Up, [true, false]),
            (Direction::Down, [false, true]),
            (Direction::Both, [true; 2]),
        ] {
            let section = on(top, 0.4, surface(variable, 0.2, direction))?;
            let starts = section.starts(50, 7)?;
            let mut seen = [false; 2];
            for mu in &starts {
                assert!(section.value(mu).abs() < 1e-15);
                assert!((Invariant::Energy.value(&top, mu) - 1.7).abs() < 1e-13);
                assert!((Invariant::VerticalMomentum.value(&top, mu) - 0.4).abs() < 1e-14);
                assert!((Invariant::VerticalSquared.value(&top, mu) - 1.0).abs() < 1e-14);
                let differential = Hamiltonian::<HeavyTopSpace>::differential(&top, mu);
                // The rate by a difference, which knows nothing of the jump of an angle.
                let rate = space.hamiltonian_vector(mu, &differential);
                let later = Se3Dual::new(mu.0.0 + rate.0.0 * 1e-7, mu.0.1 + rate.0.1 * 1e-7);
                let rate = variable.of(&later) - variable.of(mu);
                seen[usize::from(rate < 0.0)] = true;
                // From the plane (x, y) to the section and back.
                let near =
                    |other: Se3Dual| (other - *mu).0.0.norm() + (other - *mu).0.1.norm() < 1e-6;
                assert!(section.states(&section.plane(mu)).any(near));
            }
            assert_eq!(seen, sides, "{variable} {direction:?}");
            assert_eq!(section.starts(20, 7)?, starts[..20]);
            assert_ne!(section.starts(20, 8)?, starts[..20]);
        }
    }
    Ok(())
}

/// A start is no crossing, and what crosses within the first step is found, by every formulation: long steps have the
/// crossings of short ones.
#[test]
#[ignore = "long"]
fn the_first_step_has_its_crossings_and_not_the_start() -> Outcome {
    let top = generic()?;
    let scheme = RungeKutta::gauss(8)?;
    let lifted = Collective::new(scheme.clone(), SpinorRealisation, top);
    let free = LiftFree::new(scheme, DualQuaternions, top);
    let mut early = 0;
    for variable in SurfaceVariable::ALL {
        for level in [0.0, 0.3] {
            let section = on(top, 0.4, surface(variable, level, Direction::Both))?;
            for start in section.starts(10, 5)? {
                let short = times(&section, &free, &start, 0.05, 12)?;
                for times in [
                    times(&section, &free, &start, 0.6, 1)?,
                    times(&section, &lifted, &start, 0.6, 1)?,
                    times(&section, &lifted, &start, 0.05, 12)?,
                ] {
                    // Gauss's method of order 16 has an error of 1e-6 at a step of 0.6.
                    let near = times.iter().zip(&short).all(|(a, b)| (a - b).abs() < 1e-4);
                    assert!(times.len() == short.len() && near, "{variable}: {times:?} {short:?}");
                }
                assert!(short.iter().all(|t| *t > 1e-6), "{variable}: {short:?}");
                early += short.len();
            }
        }
    }
    assert!(early > 2, "{early}");
    Ok(())
}

/// Returns the times of the crossings in some steps.
fn times<I: Start<Momentum = Se3Dual>>(
    section: &Section,
    integrator: &I,
    start: &Se3Dual,
    step: f64,
    steps: usize,
) -> Outcome<Vec<f64>> {
    let crossings = section.crossings(integrator, start, step, steps)?;
    Ok(crossings.map(|crossing| Ok(crossing?.time)).collect::<Result<_, EventError>>()?)
}

/// Returns the tangent map of the first return in the plane, by central differences.
fn tangent(section: &Section, at: &Vector2<f64>) -> Outcome<Matrix2<f64>> {
    const STEP: f64 = 2e-5;
    let image = |plane: Vector2<f64>| -> Outcome<Vector2<f64>> {
        let start = section.states(&plane).next().ok_or("not accessible")?;
        let first = returns(section, &start, 1)?;
        Ok(section.plane(first.first().ok_or("no return")?))
    };
    let column = |offset: Vector2<f64>| -> Outcome<Vector2<f64>> {
        Ok((image(at + offset)? - image(at - offset)?) / (2.0 * STEP))
    };
    Ok(Matrix2::from_columns(&[column(Vector2::x() * STEP)?, column(Vector2::y() * STEP)?]))
}

/// Area is conserved to 1e-5: the differences are of second order with steps of 2e-5, and the third derivatives up to
/// some 1e4.
#[test]
#[ignore = "long"]
fn the_return_map_conserves_area_where_the_coordinates_are_canonical() -> Outcome {
    for (variable, canonical) in [
        (Coordinate::Gamma1.into(), true),
        (Coordinate::Gamma2.into(), true),
        (Coordinate::Gamma3.into(), true),
        (SurfaceVariable::Angle1, true),
        (SurfaceVariable::Angle2, true),
        (SurfaceVariable::Angle3, true),
        // Control: (angle, Γ₃) are not canonical on Π₃ = 0.
        (Coordinate::Pi3.into(), false),
    ] {
        let section = on(generic()?, 0.4, surface(variable, 0.1, Direction::Up))?;
        let mut worst: f64 = 0.0;
        for start in section.starts(6, 3)? {
            let area = tangent(&section, &section.plane(&start))?.determinant();
            worst = worst.max((area - 1.0).abs());
        }
        assert_eq!(worst < 1e-5, canonical, "{variable}: {worst:e}");
    }
    Ok(())
}

#[test]
#[ignore = "long"]
fn sections_of_integrable_tops_lie_on_curves() -> Outcome {
    for (top, vertical_momentum, coordinate, invariant, curves) in [
        (HeavyTop::kovalevskaya(1.0, 1.0)?, 0.5, Coordinate::Gamma3, Invariant::Kovalevskaya, true),
        (
            HeavyTop::lagrange(2.0, 1.0, 1.0)?,
            0.5,
            Coordinate::Gamma1,
            Invariant::AxialMomentum,
            true,
        ),
        (
            HeavyTop::goryachev_chaplygin(1.0, 1.0)?,
            0.0,
            Coordinate::Gamma3,
            Invariant::GoryachevChaplygin,
            true,
        ),
        // Controls: off the level of Goryachev and Chaplygin, and a function that is no invariant of this top.
        (
            HeavyTop::goryachev_chaplygin(1.0, 1.0)?,
            0.5,
            Coordinate::Gamma3,
            Invariant::GoryachevChaplygin,
            false,
        ),
        (generic()?, 0.5, Coordinate::Gamma3, Invariant::Kovalevskaya, false),
    ] {
        let section = on(top, vertical_momentum, surface(coordinate, 0.0, Direction::Up))?;
        let mut worst: f64 = 0.0;
        for start in section.starts(4, 0)? {
            let found = returns(&section, &start, 50)?;
            assert_eq!(found.len(), 50);
            for mu in found {
                assert!(section.value(&mu).abs() < 1e-15);
                let deviation = |f: Invariant| (f.value(&top, &mu) - f.value(&top, &start)).abs();
                for conserved in [Invariant::Energy, Invariant::VerticalMomentum] {
                    assert!(deviation(conserved) < 1e-11);
                }
                worst = worst.max(deviation(invariant));
            }
        }
        assert_eq!(worst < 1e-10, curves, "{invariant}: {worst:e}");
    }
    Ok(())
}

/// Γ of a fast symmetric top turns about e₃ once in 2π I₁/(I₁ − I₃) turns of the body. The surface is passed at its level,
/// also where that is π or more, and never at the jump.
#[test]
fn an_angle_is_passed_once_per_turn() -> Outcome {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0)?;
    let start = Se3Dual::new(Vector3::new(0.1, 0.0, 9.0), Vector3::new(0.6, 0.0, 0.8));
    let energy = Invariant::Energy.value(&top, &start);
    let vertical_momentum = Invariant::VerticalMomentum.value(&top, &start);
    let (integrator, level) = (gauss(top)?, EnergyLevel { top, energy, vertical_momentum });
    let run = |angle: f64, direction| -> Outcome<Vec<Se3Dual>> {
        let section = Section::new(level, surface(SurfaceVariable::Angle3, angle, direction))?;
        let crossings = section.crossings(&integrator, &start, 0.05, 200)?;
        Ok(crossings.map(|crossing| Ok(crossing?.momentum)).collect::<Result<_, EventError>>()?)
    };
    // The turns of Γ, counted by its changes from sample to sample.
    let mut turns = 0.0;
    let mut before = start.0.1;
    for sample in integrator.trajectory(&start, 0.05)?.take(201) {
        let gamma = sample?.momentum.0.1;
        turns += (before.x * gamma.y - before.y * gamma.x)
            .atan2(before.x * gamma.x + before.y * gamma.y)
            / std::f64::consts::TAU;
        before = gamma;
    }
    assert!(turns < -10.0, "{turns}");
    for angle in [0.5, 3.0, std::f64::consts::PI, -3.1, 7.0] {
        let passed = run(angle, Direction::Down)?;
        let whole = passed.len() as f64;
        assert!((whole - turns.abs()).abs() < 1.0, "{angle}: {whole} {turns}");
        for mu in passed {
            let difference = mu.0.1.y.atan2(mu.0.1.x) - angle;
            assert!((0.5 * difference).sin().abs() < 1e-14, "{angle}: {difference}");
        }
        // Control: the jump of atan2, where the value grows, is no crossing upwards.
        assert_eq!(run(angle, Direction::Up)?, [], "{angle}");
    }
    Ok(())
}

#[test]
fn the_least_energy_is_that_of_closed_forms() -> Outcome {
    let kovalevskaya = HeavyTop::kovalevskaya(1.0, 1.0)?;
    for (top, vertical_momentum, variable, level, least) in [
        // The top hangs at rest.
        (kovalevskaya, 0.0, Coordinate::Gamma3.into(), 0.0, -1.0),
        // The top rests as low as it can be on Γ₃ = ½.
        (kovalevskaya, 0.0, Coordinate::Gamma3.into(), 0.5, -0.75_f64.sqrt()),
        // The top hangs and turns about e₁ with I₁ = 2.
        (kovalevskaya, 0.5, Coordinate::Gamma3.into(), 0.0, -1.0 + 0.25 / 4.0),
        // The top hangs and turns about e₃ with I₃ = 1.
        (kovalevskaya, 0.0, Coordinate::Pi3.into(), 2.0, -1.0 + 2.0),
        // A free body turns about its largest axis.
        (
            HeavyTop::free_rigid_body(Vector3::new(1.0, 2.0, 3.0))?,
            3.0,
            Coordinate::Gamma1.into(),
            0.0,
            1.5,
        ),
        // The top hangs as low as it can be on a half circle through e₃, at 60° from the lowest one and on it.
        (kovalevskaya, 0.0, SurfaceVariable::Angle3, std::f64::consts::PI * 2.0 / 3.0, -0.5),
        (kovalevskaya, 0.0, SurfaceVariable::Angle3, std::f64::consts::PI, -1.0),
    ] {
        let surface = surface(variable, level, Direction::Up);
        let at = |energy| Section::new(EnergyLevel { top, energy, vertical_momentum }, surface);
        let Err(SectionError::Empty { least: found, .. }) = at(least - 1e-9) else {
            return Err(format!("{variable}: not refused").into());
        };
        assert!((found - least).abs() < 1e-12, "{variable}: {found} {least}");
        assert!(at(least + 1e-9).is_ok());
    }
    Ok(())
}

#[test]
#[ignore = "long"]
fn sections_that_are_not_there_are_refused() -> Outcome {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let make = |energy, vertical_momentum, level| {
        let surface = surface(Coordinate::Gamma3, level, Direction::Up);
        Section::new(EnergyLevel { top, energy, vertical_momentum }, surface)
    };
    assert!(matches!(
        make(f64::NAN, 0.0, 0.0),
        Err(SectionError::NotFinite { name: "energy", .. })
    ));
    assert!(matches!(make(1.0, f64::INFINITY, 0.0), Err(SectionError::NotFinite { .. })));
    assert!(matches!(make(1.0, 0.0, -1.0), Err(SectionError::NoSuchVertical { .. })));
    let tiny = make(-1.0 + 1e-13, 0.0, 0.0)?;
    assert!(matches!(tiny.starts(1000, 0), Err(SectionError::TooSmall { count: 1000, .. })));
    assert_eq!(tiny.starts(0, 0)?, []);
    Ok(())
}
