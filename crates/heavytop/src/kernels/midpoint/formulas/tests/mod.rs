//! The same bits in lanes and alone, and the error bound that the stopping rule assumes.
#![allow(clippy::unwrap_used)]

mod guesses;

use super::components::{TopState, each};
use super::guess::Guess;
use super::midpoint_parameters::{MidpointParameters, SQUARED_FLOOR};
use super::register_vector::RegisterVector;
use super::{GuessHistory, Member, together};
use crate::tops::top::{Body, HeavyTop};
use collective_integrators::{
    CHECKPOINT, IntegrationError, LaneKernel, LaneResults, Registers, StepError,
};
use core::ops::Range;
use lie_poisson::{InstructionSet, Lanes, Se3Dual, Width};
use nalgebra::Vector3;
use proptest::prelude::*;

#[derive(Clone, Copy)]
struct OneOfMany(HeavyTop, Se3Dual);

impl Member for OneOfMany {
    fn state(&self) -> &Se3Dual {
        &self.1
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        &mut self.1
    }
}

/// Returns the top with these moments and γ = `force`.
fn top(inertia: Vector3<f64>, force: Vector3<f64>) -> HeavyTop {
    let (gravity, center_of_mass) = (force.norm(), force.normalize());
    HeavyTop::new(&Body { inertia, mass: 1.0, gravity, length: 1.0, center_of_mass }).unwrap()
}

/// Returns tops of different shapes and starts, so many that the last group is incomplete at every width.
fn members() -> Vec<OneOfMany> {
    let member = |i: usize| {
        let x = i as f64;
        let moments = Vector3::new(2.0 + 0.01 * x, 2.0, 1.0 + 0.02 * x);
        let force = Vector3::new(0.8, 0.1 * x.sin(), 0.6);
        let start =
            Se3Dual::new(Vector3::new(2.0, 3.0 * x.cos(), 4.0), Vector3::new(0.6, 0.0, 0.8));
        OneOfMany(top(moments, force), start)
    };
    (0..19).map(member).collect()
}

/// The formulas without the general integrator: a top fails where they have no result.
struct Formulas(InstructionSet);

impl LaneKernel for Formulas {
    type Member = OneOfMany;

    #[cfg_attr(optimised, inline(always))]
    fn together<T: Lanes>(&self, group: &mut [OneOfMany], step: f64, count: u64) -> LaneResults {
        together::<T, _>(|member: &OneOfMany| member.0, group, step, count)
    }

    fn alone(
        &self,
        OneOfMany(top, mu): &mut OneOfMany,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let mut history = GuessHistory::new(top);
        for made in steps {
            if made % CHECKPOINT == 0 {
                history.forget();
            }
            match history.step(top, mu, step, self.0) {
                Some(next) => *mu = next.point,
                None => return Err(IntegrationError::after(made, step, StepError::NotFinite)),
            }
        }
        Ok(())
    }
}

/// Returns the ends after 1500 steps, and the members that failed with their numbers of steps.
fn run(
    mut members: Vec<OneOfMany>,
    set: InstructionSet,
    width: Width,
) -> (Vec<[u64; 6]>, Vec<(usize, u64)>) {
    let mut gone = Vec::new();
    let mut failed = |i, error: IntegrationError| gone.push((i, error.step - 1));
    let registers = Registers::new(set, width).unwrap();
    registers.advance(&Formulas(set), &mut members, 0.01, 0..1500, &mut failed);
    (bits(&members), gone)
}

/// Returns the ends of members that are advanced one after the other, each with the vectors of its step in
/// registers.
fn run_alone(
    mut members: Vec<OneOfMany>,
    set: InstructionSet,
) -> (Vec<[u64; 6]>, Vec<(usize, u64)>) {
    let mut gone = Vec::new();
    for (i, member) in members.iter_mut().enumerate() {
        if let Err(error) = Formulas(set).alone(member, 0.01, 0..1500) {
            gone.push((i, error.step - 1));
        }
    }
    (bits(&members), gone)
}

fn bits(members: &[OneOfMany]) -> Vec<[u64; 6]> {
    let bits = |x: f64| x.to_bits();
    let ends = members.iter().map(|OneOfMany(_, mu)| {
        let (pi, gamma) = (mu.0.0.map(bits), mu.0.1.map(bits));
        [pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]
    });
    ends.collect()
}

fn everywhere() -> impl Iterator<Item = (InstructionSet, Width)> {
    InstructionSet::available().flat_map(|set| Width::ALL.map(|width| (set, width)))
}

#[test]
fn a_lane_has_the_same_bits_at_every_width() {
    let alone = |set| run(members(), set, Width::Single).0;
    let unfused = alone(InstructionSet::Portable);
    for (set, width) in everywhere() {
        let expected =
            if set == InstructionSet::Portable { &unfused } else { &alone(InstructionSet::Avx2) };
        let (ends, gone) = run(members(), set, width);
        assert_eq!((&ends, gone), (expected, vec![]), "{set} {width:?}");
        // the control: other tops have other bits
        assert_ne!(ends[0], ends[1]);
        assert!(set == InstructionSet::Portable || ends != unfused);
    }
}

#[test]
fn a_top_alone_has_the_bits_of_a_lane() {
    // also where squares overflow and underflow
    let sizes = [1.0, 0.0, 5e-324, 1e-310, 1e-160, 30.0, 1e154, 1e300, f64::INFINITY, f64::NAN];
    let pairs = sizes.iter().flat_map(|&pi| sizes.map(|gamma| (pi, gamma)));
    let scaled = pairs.enumerate().map(|(i, (pi, gamma))| {
        let OneOfMany(top, mu) = members()[i % 19];
        OneOfMany(top, Se3Dual::new(mu.0.0 * pi, mu.0.1 * gamma))
    });
    let all: Vec<_> = members().into_iter().chain(scaled).collect();
    for set in InstructionSet::available() {
        let (ends, gone) = run_alone(all.clone(), set);
        let lanes = run(all.clone(), set, Width::Single);
        assert_eq!((&ends, &gone), (&lanes.0, &lanes.1), "{set}");
        // the controls: some converge and some do not, and rounding shows
        assert!((20..100).contains(&gone.len()), "{gone:?}");
        assert_ne!(ends[0], ends[1]);
        let other = if set == InstructionSet::Portable {
            InstructionSet::detected()
        } else {
            InstructionSet::Portable
        };
        assert!(other == set || run_alone(all.clone(), other).0 != ends);
    }
}

#[test]
fn a_lane_that_fails_harms_no_other() {
    for (set, width) in everywhere() {
        let whole = run(members(), set, width).0;
        for at in 0..19 {
            // NaN at every place, and each of the others once or more in each of up to eight lanes.
            for what in [f64::NAN, [1e6, f64::INFINITY][(at + at / 8) % 2]] {
                let mut spoiled = members();
                spoiled[at].1.0.0.y = what;
                let (ends, gone) = run(spoiled, set, width);
                assert_eq!(gone, [(at, 0)], "{set} {width:?} {what}");
                for i in (0..19).filter(|&i| i != at) {
                    assert_eq!(ends[i], whole[i], "{i} beside {at}");
                }
                assert_ne!(ends[at], whole[at]);
            }
        }
    }
}

proptest! {
    /// κ² = 2((6ρ|a|²)² + (⅛k)²), k = h²|γ||Γ|/I_min, bounds the error of a after a correction, and with ⅝k
    /// instead of ⅛k the error of the end.
    #[test]
    fn a_correction_leaves_less_than_the_bound(
        sides in [0.1..1.0, 0.1..1.0, 0.1..1.0f64],
        pi in [-1.0..1.0, -1.0..1.0, -1.0..1.0f64],
        force in [-2.0..2.0, -2.0..2.0, -2.0..2.0f64],
        error in [-1.0..1.0, -1.0..1.0, -1.0..1.0f64],
        step in 0.01..0.1f64,
    ) {
        let [x, y, z] = sides;
        let force = Vector3::from(force);
        prop_assume!(force.norm() > 1e-3);
        let top = top(Vector3::new(y + z, z + x, x + y), force);
        let parameters = MidpointParameters::<[f64; 3], f64>::gather(|_| top, |_| 1.0, step);
        let start = TopState { momentum: pi, vertical: [0.6, 0.0, 0.8] };
        let mut a = [0.0; 3];
        for _ in 0..100 {
            a = Guess::new(&parameters, &start, a).corrected();
        }
        let nearby = each!(i => a[i] + 1e-6 * error[i]);
        let guess = Guess::new(&parameters, &start, nearby);
        let left = each!(i => guess.corrected()[i] - a[i]);
        let square = a.dot(a);
        let bound = |part| {
            (parameters.turning_rate * square * square + parameters.kick_rate * part) * SQUARED_FLOOR
        };
        // round-off of a, and the second order of the error
        let least = (1e-16 + 1e-12 * error.dot(error)).powi(2);
        let size = 1e-12 * error.dot(error);
        prop_assert!(left.dot(left) <= 1.01 * bound(1.0 / 25.0) * size + least, "{left:?}");
        // the control: the error was there, and the correction removes it
        prop_assert!(guess.change() > 2.0 * size);
        let (end, expected) = (guess.end(&start), Guess::new(&parameters, &start, a).end(&start));
        // an error of Π as one of a = (h/4) I⁻¹Π; one of a turns Γ by four times as much
        let rate = &parameters.rate;
        let left = each!(i => rate[i] * (end.momentum[i] - expected.momentum[i]));
        prop_assert!(left.dot(left) <= 1.01 * bound(1.0) * size + 16.0 * least, "{left:?}");
        let left = each!(i => 0.25 * (end.vertical[i] - expected.vertical[i]));
        prop_assert!(left.dot(left) <= 1.01 * bound(1.0 / 25.0) * size + 16.0 * least, "{left:?}");
    }
}
