//! The Casimirs of fluids that are driven, damped, or at a temperature.

use crate::fluids::zeitlin::{difference, largest};
use crate::open_fluids::support::{drift, eddies, on_path, paths};
use lie_poisson_systems::collective_integrators::{NoiseRule, RungeKutta, Start};
use lie_poisson_systems::isospectral_flows::{
    DrivenIsospectralField, IsospectralDoubleBracket, IsospectralField, IsospectralNoise,
    IsotropicIsospectralNoise, LargeSkewHermitian, NoisyIsospectral, Products,
};
use lie_poisson_systems::lie_poisson::{
    Controlled, InputTable, Inputs, Interpolation, Sign, State,
};
use lie_poisson_systems::{HarmonicNoise, Zeitlin};

const SIZE: usize = 16;

const STEP: f64 = 0.02;

fn fluid() -> Zeitlin {
    Zeitlin::new(SIZE).unwrap()
}

fn start() -> LargeSkewHermitian {
    fluid().vorticity(&eddies(SIZE, [1, 6]))
}

/// Returns the generator of a stream function of one degree.
fn stream(degree: usize) -> LargeSkewHermitian {
    let mut xi = fluid().vorticity(&eddies(SIZE, [degree, degree]));
    xi.scale_in_place(0.3 / fluid().planck_constant());
    xi
}

/// A Hamiltonian that depends on time: the flow is stirred by a stream function that oscillates.
struct Oscillating(Zeitlin, LargeSkewHermitian);

impl DrivenIsospectralField for Oscillating {
    fn size(&self) -> usize {
        SIZE
    }

    fn generator_at_into(
        &self,
        w: &LargeSkewHermitian,
        time: f64,
        generator: &mut LargeSkewHermitian,
    ) {
        self.0.generator_into(w, generator);
        generator.add_multiple((0.7 * time).cos(), &self.1);
    }
}

/// A control law that holds the flow back: −½ of its own stream function of each entry, which is that of no energy.
struct Feedback(Zeitlin);

impl IsospectralField for Feedback {
    fn size(&self) -> usize {
        SIZE
    }

    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        self.0.generator_into(w, generator);
        let n = SIZE;
        generator.change_upper(|re, im| {
            for i in 0..n * n {
                let factor = -0.5 / (1.0 + (i % n) as f64);
                (re[i], im[i]) = (re[i] * factor, im[i] * factor);
            }
        });
    }
}

fn table(kind: Interpolation) -> InputTable {
    let times = vec![0.0, 1.31, 2.5, 4.77, 1e9];
    InputTable::new(times, vec![0.0, 1.0, -1.0, 0.3, 0.3], kind).unwrap()
}

/// Returns the drift of the Casimirs of a path.
fn drift_of<F, N>((field, noise, rule): (F, N, NoiseRule), steps: u64) -> f64
where
    F: DrivenIsospectralField,
    N: IsospectralNoise,
{
    let midpoint = RungeKutta::implicit_midpoint();
    let motion = NoisyIsospectral::new(midpoint, field, noise, paths(STEP)).with_rule(rule);
    let end = motion.after(&on_path(start(), 3), STEP, steps).unwrap().momentum.0;
    assert!(difference(&start(), &end) > 0.01 * largest(&start()));
    drift(&fluid(), &start(), &end)
}

const NO_NOISE: Vec<LargeSkewHermitian> = Vec::new();

/// The fields, by their names.
const FIELDS: [&str; 7] = [
    "a Hamiltonian with the time",
    "inputs by tables",
    "a control law",
    "a double bracket",
    "transport noise, alternating",
    "a temperature",
    "a temperature, alternating",
];

/// Returns the drift of the Casimirs with one of the fields.
fn drift_with(field: &str, steps: u64) -> f64 {
    let together = NoiseRule::Together;
    let damped = |friction| IsospectralDoubleBracket::new(fluid(), friction, Sign::Minus).unwrap();
    let thermal = || IsotropicIsospectralNoise::thermal(SIZE, (0.01, 0.1)).unwrap();
    match field {
        "a Hamiltonian with the time" => {
            drift_of((Oscillating(fluid(), stream(3)), NO_NOISE, together), steps)
        }
        "inputs by tables" => {
            let inputs = Inputs::new(vec![
                (stream(2), table(Interpolation::Constant)),
                (stream(5), table(Interpolation::Linear)),
            ]);
            let field = Controlled { field: fluid(), control: inputs.unwrap() };
            drift_of((field, NO_NOISE, together), steps)
        }
        "a control law" => {
            let field = Controlled { field: fluid(), control: Feedback(fluid()) };
            drift_of((field, NO_NOISE, together), steps)
        }
        "a double bracket" => drift_of((damped(0.02), NO_NOISE, together), steps),
        "transport noise, alternating" => {
            let noise = HarmonicNoise::none(&fluid()).with_harmonic(4, 2, 0.05).unwrap();
            let noise = noise.with_harmonic(5, 1, 0.05).unwrap();
            drift_of((fluid(), noise, NoiseRule::Alternating), steps)
        }
        "a temperature" => drift_of((damped(0.01), thermal(), together), steps),
        _ => drift_of((damped(0.01), thermal(), NoiseRule::Alternating), steps),
    }
}

#[test]
fn driven_fluids_keep_their_casimirs() {
    for field in FIELDS {
        let drift = drift_with(field, 30);
        // Steps with some rounding errors each.
        assert!(drift < 1e-14, "{field}: {drift:e}");
    }
    // Control: an explicit step loses them.
    let (mut w, field) = (start(), Oscillating(fluid(), stream(3)));
    for n in 0..30 {
        let (mut b, mut rate) = (w.zeros_like(), w.zeros_like());
        field.generator_at_into(&w, STEP * f64::from(n), &mut b);
        Products::default().commutator(&b, &w, &mut rate);
        w.add_multiple(STEP, &rate);
    }
    assert!(drift(&fluid(), &start(), &w) > 1e-6);
}

/// The energy is −(2π/N) ⟨P, W⟩, so that the generator P/ħ is −dh of it up to a positive factor: with the minus bracket the double
/// bracket takes energy, and with the other one it feeds it.
#[test]
fn a_double_bracket_damps_a_fluid() {
    let end = |sign| {
        let damped = IsospectralDoubleBracket::new(fluid(), 0.05, sign).unwrap();
        let midpoint = RungeKutta::implicit_midpoint();
        let motion = NoisyIsospectral::new(midpoint, damped, NO_NOISE, paths(STEP));
        motion.after(&on_path(start(), 0), STEP, 20).unwrap().momentum.0
    };
    let energy = fluid().energy(&start());
    let [damped, fed] = [Sign::Minus, Sign::Plus].map(|sign| fluid().energy(&end(sign)));
    assert!(damped < energy - 1e-4 && fed > energy + 1e-4, "{damped} {fed} {energy}");
}

#[test]
#[ignore = "takes minutes"]
fn driven_fluids_keep_their_casimirs_many_times() {
    let steps = 1_000_000;
    for field in FIELDS {
        let drift = drift_with(field, steps);
        println!("{field}: the Casimirs after {steps} steps: {drift:e}");
        assert!(drift < 1e-12, "{field}: {drift:e}");
    }
}
