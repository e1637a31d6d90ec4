//! Isospectral equations with the time in them, inputs, controls, damping, and noise whose generators alternate.

use crate::examples::{Quadratic, distance, generic};
use crate::open_systems::support::{Large, Still, drift, on_path};
use isospectral_flows::collective_integrators::{
    BrownianPaths, Equivariant, Integrator, NoiseRule, RungeKutta, Start, StepError, fitted_order,
};
use isospectral_flows::lie_poisson::{
    Controlled, DissipationError, InputTable, Inputs, Interpolation, Pair, Sign, State,
};
use isospectral_flows::{
    DrivenIsospectralField, IsospectralDoubleBracket, IsospectralField, IsospectralNoise,
    IsotropicIsospectralNoise, NoisyIsospectral, Products,
};

const SIZE: usize = 3;

fn paths(interval: f64) -> BrownianPaths {
    BrownianPaths::new(5, interval).unwrap()
}

/// Returns W after steps of a driven motion.
fn driven<S, F>((scheme, field): (S, F), w: &Large, step: f64, steps: u64) -> Large
where
    S: Equivariant,
    F: DrivenIsospectralField,
{
    let motion = NoisyIsospectral::new(scheme, field, Vec::<Large>::new(), paths(step));
    let Pair(end, Pair(_, time)) =
        motion.after(&on_path(w.clone(), 0), step, steps).unwrap().momentum;
    assert!((time.0 - step * steps as f64).abs() < 1e-12);
    end
}

/// A generator that oscillates.
struct Oscillating(Quadratic);

impl DrivenIsospectralField for Oscillating {
    fn size(&self) -> usize {
        SIZE
    }

    fn generator_at_into(&self, w: &Large, time: f64, generator: &mut Large) {
        self.0.generator_into(w, generator);
        generator.scale_in_place((2.0 * time).cos());
    }
}

fn table(kind: Interpolation) -> InputTable {
    InputTable::new(vec![0.0, 0.33, 0.71, 1.5], vec![0.5, -1.0, 2.0, 0.3], kind).unwrap()
}

/// Inputs along two matrices that do not commute, beside the equation.
fn controlled(kind: Interpolation) -> impl DrivenIsospectralField {
    let inputs = [1.0, 2.0].map(|seed| (generic(SIZE, seed), table(kind)));
    Controlled { field: Quadratic(SIZE), control: Inputs::new(inputs.into()).unwrap() }
}

/// Returns the order of the midpoint rule to t = 1.
fn order<F: DrivenIsospectralField>(field: impl Fn() -> F) -> f64 {
    let (w, scheme) = (generic(SIZE, 0.3), RungeKutta::implicit_midpoint);
    let exact = driven((scheme(), field()), &w, 1.0 / 1024.0, 1024);
    let errors = [16_u32, 32, 64].map(|count| {
        let step = f64::from(count).recip();
        (step, distance(&driven((scheme(), field()), &w, step, count.into()), &exact))
    });
    assert!(distance(&w, &exact) > 0.05);
    fitted_order(&errors, 1e-14).unwrap()
}

/// Steps see the time in their middle, and none sees both sides of a jump.
#[test]
fn driven_steps_have_the_order_two_and_keep_the_spectrum() {
    /// The inputs without their breaks.
    struct Silent<F>(F);
    impl<F: DrivenIsospectralField> DrivenIsospectralField for Silent<F> {
        fn size(&self) -> usize {
            self.0.size()
        }
        fn generator_at_into(&self, w: &Large, time: f64, generator: &mut Large) {
            self.0.generator_at_into(w, time, generator);
        }
    }
    let found = [
        order(|| Oscillating(Quadratic(SIZE))),
        order(|| controlled(Interpolation::Constant)),
        order(|| controlled(Interpolation::Linear)),
    ];
    assert!(found.iter().all(|order| (order - 2.0).abs() < 0.15), "{found:?}");
    let silent = order(|| Silent(controlled(Interpolation::Constant)));
    assert!(silent < 1.7, "{silent}");
    let start = generic(SIZE, 0.3);
    for kind in [Interpolation::Constant, Interpolation::Linear] {
        let end = driven((RungeKutta::implicit_midpoint(), controlled(kind)), &start, 0.01, 150);
        assert!(drift(&start, &end) < 1e-14 && distance(&start, &end) > 0.1);
    }
}

/// The field without the time is that of the method without it, to the bit.
#[test]
fn inputs_are_what_they_are() {
    let one = |size| vec![(generic(size, 1.0), table(Interpolation::Linear))];
    let inputs = Inputs::new(one(SIZE)).unwrap();
    let (mut generator, mut expected) = (generic(SIZE, 9.0), generic(SIZE, 1.0));
    inputs.generator_at_into(&generic(SIZE, 0.3), 1.1, &mut generator);
    expected.scale_in_place(table(Interpolation::Linear).at(1.1));
    assert!(distance(&generator, &expected) < 1e-15);
    assert_eq!(
        [true, false].map(|forward| inputs.next_break(0.5, forward)),
        [Some(0.71), Some(0.33)]
    );
    let other = Inputs::new(one(SIZE + 1)).unwrap();
    other.generator_at_into(&generic(SIZE, 0.3), 1.1, &mut generator);
    assert!(generator.norm().is_nan());
    let motion = NoisyIsospectral::new(
        RungeKutta::implicit_midpoint(),
        Controlled { field: Quadratic(SIZE), control: other },
        Vec::<Large>::new(),
        paths(0.1),
    );
    let start = on_path(generic(SIZE, 0.3), 0);
    let mut state = start.clone();
    assert!(motion.step_in_place(&mut state, 0.1, &mut motion.workspace()).is_err());
    assert_eq!(state, start);
}

/// h = ½ ⟨W, dh⟩, with the generator dh of the plus bracket.
fn energy(w: &Large) -> f64 {
    let mut b = w.zeros_like();
    Quadratic(w.size()).generator_into(w, &mut b);
    0.5 * w.scalar_product(&b)
}

/// dh/dt = −θ |[dh, W]|².
#[test]
fn a_double_bracket_takes_the_energy_at_its_rate() {
    let (w, friction) = (generic(SIZE, 0.3), 0.3);
    let (mut b, mut rate, mut products) = (w.zeros_like(), w.zeros_like(), Products::default());
    Quadratic(SIZE).generator_into(&w, &mut b);
    products.commutator(&b, &w, &mut rate);
    let loss = -friction * rate.norm().powi(2);
    let change = |sign| {
        let field = IsospectralDoubleBracket::new(Quadratic(SIZE), friction, sign).unwrap();
        let (mut generator, mut rate) = (w.zeros_like(), w.zeros_like());
        field.generator_at_into(&w, 0.0, &mut generator);
        Products::default().commutator(&generator, &w, &mut rate);
        b.scalar_product(&rate)
    };
    assert!((change(Sign::Plus) - loss).abs() < 1e-14 * loss.abs());
    // Control: the other sign feeds it.
    assert!((change(Sign::Minus) + loss).abs() < 1e-14 * loss.abs() && loss.abs() > 0.1);
    let damped = || IsospectralDoubleBracket::new(Quadratic(SIZE), friction, Sign::Plus).unwrap();
    let end = driven((RungeKutta::implicit_midpoint(), damped()), &w, 0.05, 200);
    assert!(drift(&w, &end) < 1e-14 && energy(&end) < energy(&w) - 0.1);
    assert_eq!(damped().friction(), friction);
    for friction in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = IsospectralDoubleBracket::new(Quadratic(SIZE), friction, Sign::Plus);
        assert!(matches!(refused, Err(DissipationError::Friction { .. })));
        assert!(IsotropicIsospectralNoise::thermal(SIZE, (friction, 1.0)).is_err());
        assert!(IsotropicIsospectralNoise::thermal(SIZE, (1.0, friction)).is_err());
    }
}

/// Generators that alternate act by their exponentials: one of them by the increment of the path, whatever the step.
#[test]
fn generators_that_alternate_act_exactly() {
    let start = on_path(generic(SIZE, 0.3), 3);
    let end = |rule, step: f64, steps| {
        let noise = vec![generic(SIZE, 1.0)];
        let midpoint = RungeKutta::implicit_midpoint();
        let noisy =
            NoisyIsospectral::new(midpoint, Still(SIZE), noise, paths(step)).with_rule(rule);
        let end = noisy.after(&start, step, steps).unwrap().momentum.0;
        assert!(drift(&start.0, &end) < 1e-14);
        // The second component is the coin.
        let mut motion = [0.0; 2];
        noisy.paths().write_increments(3, 0.0, steps as f64, &mut motion);
        let (mut omega, mut exact) = (generic(SIZE, 1.0), generic(SIZE, 0.3));
        omega.scale_in_place(motion[0]);
        let mut turn = isospectral_flows::LargeMatrix::zeros(SIZE);
        Products::default().exponential_minus_one(&omega, &mut turn);
        Products::default().conjugate(&turn, &start.0, &mut exact);
        distance(&end, &exact)
    };
    for (step, steps) in [(0.1, 40), (2.0, 10)] {
        // Some roundings of each turn.
        assert!(end(NoiseRule::Alternating, step, steps) < 1e-13);
    }
    assert!(end(NoiseRule::Together, 0.1, 40) > 1e-3);
}

/// The order of two generators is that of the coin, and both orders occur.
#[test]
fn generators_alternate_in_both_orders() {
    let (w, step) = (generic(SIZE, 0.3), 0.1);
    let generators = || vec![generic(SIZE, 1.0), generic(SIZE, 2.0)];
    let midpoint = RungeKutta::implicit_midpoint();
    let noisy = NoisyIsospectral::new(midpoint, Still(SIZE), generators(), paths(step));
    let noisy = noisy.with_rule(NoiseRule::Alternating);
    let mut products = Products::default();
    let mut seen = [false; 2];
    for path in 0..10 {
        let end = noisy.after(&on_path(w.clone(), path), step, 1).unwrap().momentum.0;
        let mut noise = [0.0; 3];
        noisy.paths().write_increments(path, 0.0, 1.0, &mut noise);
        let is_forward = noise[2] >= 0.0;
        seen[usize::from(is_forward)] = true;
        let mut by_order = |order: [usize; 2]| {
            order.iter().fold(w.clone(), |w, &k| {
                let (mut omega, mut next) = (generators()[k].clone(), w.zeros_like());
                omega.scale_in_place(noise[k]);
                let mut turn = isospectral_flows::LargeMatrix::zeros(SIZE);
                products.exponential_minus_one(&omega, &mut turn);
                products.conjugate(&turn, &w, &mut next);
                next
            })
        };
        let (forward, backward) = (by_order([0, 1]), by_order([1, 0]));
        let (expected, other) =
            if is_forward { (&forward, &backward) } else { (&backward, &forward) };
        assert!(distance(&end, expected) < 1e-14);
        assert!(distance(&end, other) > 1e-6);
    }
    assert_eq!(seen, [true; 2]);
}

#[test]
fn other_sizes_are_refused() {
    let noise = IsotropicIsospectralNoise { size: SIZE + 1, strength: 1.0 };
    let mut generator = generic(SIZE, 0.0);
    noise.add_to(&[0.0; 16], &mut generator);
    assert!(generator.norm().is_nan());
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let noisy =
            NoisyIsospectral::new(RungeKutta::implicit_midpoint(), Still(SIZE), noise, paths(0.1));
        let noisy = noisy.with_rule(rule);
        let start = on_path(generic(SIZE, 0.3), 0);
        let mut state = start.clone();
        let refused = noisy.step_in_place(&mut state, 0.1, &mut noisy.workspace());
        assert!(refused.is_err() && state == start);
        let other = on_path(generic(SIZE + 1, 0.3), 0);
        let refused = noisy.step(&other, 0.1, &mut noisy.workspace());
        assert!(matches!(refused, Err(StepError::Dimension { .. })));
    }
}
