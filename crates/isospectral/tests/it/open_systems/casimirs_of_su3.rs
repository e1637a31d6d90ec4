//! The Casimirs on a generic orbit of su(3)∗, with each field that a system can have.

use crate::examples::{Quadratic, casimirs, distance, generic};
use crate::open_systems::support::{Large, drift, on_path};
use isospectral_flows::collective_integrators::{BrownianPaths, NoiseRule, RungeKutta, Start};
use isospectral_flows::lie_poisson::{Controlled, InputTable, Inputs, Interpolation, Sign, State};
use isospectral_flows::{
    DrivenIsospectralField, IsospectralDoubleBracket, IsospectralField, IsospectralNoise,
    IsotropicIsospectralNoise, NoisyIsospectral, Products,
};
use num_complex::Complex;

const SIZE: usize = 3;

/// A step turns a state by a tenth at most.
const STEP: f64 = 0.05;

/// Returns a matrix without a trace whose entries look random.
fn traceless(seed: f64) -> Large {
    let w = generic(SIZE, seed);
    let mean = Complex::new(0.0, w.trace() / SIZE as f64);
    Large::from_upper(SIZE, |j, k| if j == k { w.at(j, j) - mean } else { w.at(j, k) })
}

fn start() -> Large {
    traceless(0.3)
}

/// A Hamiltonian that oscillates.
struct Oscillating;

impl DrivenIsospectralField for Oscillating {
    fn size(&self) -> usize {
        SIZE
    }

    fn generator_at_into(&self, w: &Large, time: f64, generator: &mut Large) {
        Quadratic(SIZE).generator_into(w, generator);
        generator.scale_in_place(1.0 + 0.5 * (0.7 * time).cos());
    }
}

/// A control law that does not come from a Hamiltonian: the more of the state, the lower its row and column.
struct Feedback;

impl IsospectralField for Feedback {
    fn size(&self) -> usize {
        SIZE
    }

    fn generator_into(&self, w: &Large, generator: &mut Large) {
        let square = w.scalar_product(w);
        *generator = Large::from_upper(SIZE, |j, k| {
            w.at(j, k) * ((1 + j + k) as f64 * 0.2 * (1.0 + w.at(0, 1).norm_sqr() / square))
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
    let paths = BrownianPaths::new(11, STEP).unwrap();
    let motion = NoisyIsospectral::new(midpoint, field, noise, paths).with_rule(rule);
    let end = motion.after(&on_path(start(), 3), STEP, steps).unwrap().momentum.0;
    assert!(distance(&start(), &end) > 0.1);
    drift(&start(), &end)
}

const NO_NOISE: Vec<Large> = Vec::new();

const RULES: [(&str, NoiseRule); 2] =
    [("together", NoiseRule::Together), ("alternating", NoiseRule::Alternating)];

/// Returns the fields by their names, with the drifts of the Casimirs after so many steps.
fn drifts(steps: u64) -> Vec<(String, f64)> {
    let still = NoiseRule::Together;
    let damped =
        |friction| IsospectralDoubleBracket::new(Quadratic(SIZE), friction, Sign::Plus).unwrap();
    let inputs = Inputs::new(vec![
        (traceless(1.0), table(Interpolation::Constant)),
        (traceless(2.0), table(Interpolation::Linear)),
    ]);
    let driven = Controlled { field: Quadratic(SIZE), control: inputs.unwrap() };
    let controlled = Controlled { field: Quadratic(SIZE), control: Feedback };
    let mut found = vec![
        ("a Hamiltonian with the time".into(), drift_of((Oscillating, NO_NOISE, still), steps)),
        ("inputs by tables".into(), drift_of((driven, NO_NOISE, still), steps)),
        ("a control law".into(), drift_of((controlled, NO_NOISE, still), steps)),
        // Weak enough not to bring the motion to rest, where all steps make the same rounding errors: 3e-12 after 10⁶ steps.
        ("a double bracket".into(), drift_of((damped(1e-4), NO_NOISE, still), steps)),
    ];
    for (name, rule) in RULES {
        let noise: Vec<Large> = [1.0, 2.0]
            .map(|seed| {
                let mut xi = traceless(seed);
                xi.scale_in_place(0.1);
                xi
            })
            .into();
        let constant = drift_of((Quadratic(SIZE), noise, rule), steps);
        found.push((format!("constant noise, {name}"), constant));
        let noise = IsotropicIsospectralNoise::thermal(SIZE, (0.05, 0.2)).unwrap();
        found
            .push((format!("a temperature, {name}"), drift_of((damped(0.05), noise, rule), steps)));
    }
    found
}

/// For trace 0 the eigenvalues of iW/|W| are the roots of λ³ − λ c₂/2 − c₃/3, which differ if 4(c₂/2)³ > 27(c₃/3)².
#[test]
fn the_orbit_is_generic() {
    let c = casimirs(&start(), start().norm());
    assert!(c[0].abs() < 1e-15 && c[2].abs() > 0.01, "{c:?}");
    assert!(4.0 * (c[1] / 2.0).powi(3) - 27.0 * (c[2] / 3.0).powi(2) > 0.1, "{c:?}");
}

#[test]
fn each_field_keeps_the_casimirs_of_a_path() {
    for (name, drift) in drifts(125) {
        // Steps with some rounding errors each, which are unbiased.
        assert!(drift < 2e-14, "{name}: {drift:e}");
    }
    // Control: an explicit step loses them.
    let mut w = start();
    for n in 0..125 {
        let (mut b, mut rate) = (w.zeros_like(), w.zeros_like());
        Oscillating.generator_at_into(&w, STEP * f64::from(n), &mut b);
        Products::default().commutator(&b, &w, &mut rate);
        w.add_multiple(STEP, &rate);
    }
    assert!(drift(&start(), &w) > 1e-3);
}

#[test]
#[ignore = "takes minutes"]
fn each_field_keeps_the_casimirs_of_su3_many_times() {
    let steps = 1_000_000;
    let found = drifts(steps);
    found.iter().for_each(|(name, drift)| println!("{name}: {drift:e}"));
    for (name, drift) in found {
        assert!(drift < 1e-12, "{name}: {drift:e}");
    }
}
