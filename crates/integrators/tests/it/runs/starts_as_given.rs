//! The first sample of a run is the start, bit for bit, and events see it so.

use collective_integrators::{
    Collective, DenseOutput, Direction, Events, LiftFree, RungeKutta, Start,
};
use lie_poisson::{Covector, LiePoisson, So3, from_closure};
use momentum_map::{HOPF, Quaternions};
use nalgebra::Vector3;

type Momentum = Covector<Vector3<f64>>;

/// Starts whose lifts have other bits.
fn starts() -> impl Iterator<Item = Momentum> {
    (1..200).map(|n| {
        let n = f64::from(n);
        Covector(Vector3::new((0.7 * n).sin(), (1.3 * n).cos(), 0.1 * n))
    })
}

fn check<I: Start<Momentum = Momentum>>(integrator: &I, expects_rounding: bool) {
    let mut rounded = 0;
    for mu in starts() {
        let lifted = integrator.momentum(&integrator.start(&mu).unwrap());
        rounded += u32::from(lifted != mu);
        let first = integrator.trajectory(&mu, 0.1).unwrap().next().unwrap().unwrap();
        assert_eq!((first.step, first.momentum), (0, mu));
        assert_eq!(integrator.after(&mu, 0.1, 0).unwrap().momentum, mu);
        let mut dense = DenseOutput::new(integrator, integrator.trajectory(&mu, 0.1).unwrap());
        assert_eq!(dense.at(0.0).unwrap().momentum, mu);
        // The start lies on the surface Π₃ = c exactly, or up to rounding, and is no event unless it is asked for.
        let c = mu.0.z;
        for (level, shift) in [(c, 0.0), (c * (1.0 + 2.0 * f64::EPSILON), 0.0), (7.0 * c, 6.0 * c)]
        {
            let run = || integrator.trajectory(&mu, 0.1).unwrap().take(3);
            let g = |mu: &Momentum| (mu.0.z + shift) - level;
            let early = |direction| {
                let mut events = Events::new(integrator, run(), g, direction);
                events.next().is_some_and(|event| event.unwrap().time < 1e-6)
            };
            assert!(!early(Direction::Both), "{mu:?}");
            let counted: Vec<_> = [Direction::Up, Direction::Down]
                .into_iter()
                .filter_map(|direction| {
                    Events::new(integrator, run(), g, direction).counting_start().next()
                })
                .map(|event| event.unwrap())
                .filter(|event| event.time == 0.0)
                .collect();
            // It leaves the surface to one side.
            assert!(counted.len() == 1 && counted[0].momentum == mu, "{mu:?}: {counted:?}");
        }
    }
    assert_eq!(rounded > 20, expects_rounding, "{rounded}");
}

#[test]
#[ignore = "long"]
fn the_first_sample_and_events_have_the_bits_of_the_start() {
    let h = || {
        from_closure::<LiePoisson<So3>, _>(|Covector(pi)| {
            pi.x * pi.x * 0.5 + pi.y * pi.y * 0.3 + pi.x * pi.y + pi.z * pi.y * 0.1
        })
    };
    let gauss = RungeKutta::gauss(4).unwrap();
    check(&Collective::new(gauss.clone(), HOPF, h()), true);
    // control: a lift-free state is the start
    check(&LiftFree::new(gauss, Quaternions, h()), false);
}
