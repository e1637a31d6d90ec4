//! The double bracket: a spin that comes to rest in a field, and bodies that lose energy on their orbits.

use collective_integrators::{Driven, RungeKutta, Start};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, Hamiltonian, InnerProduct, LiePoisson, Pair, Se3, So3,
    Time, from_closure,
};
use momentum_map::{HOPF, PARTICLE};
use nalgebra::Vector3;
use proptest::prelude::*;

proptest! {
    /// With h = −B Π₃ the angle α from the field obeys tan(α/2) = tan(α₀/2) exp(−θ B |Π| t), and Π turns about it by −Bt.
    #[test]
    fn a_spin_comes_to_rest_as_landau_and_lifshitz_say(
        angle in 0.05..3.1_f64,
        friction in 0.0..0.8_f64,
        field in 0.3..1.5_f64,
        power in -30..30_i32,
    ) {
        let unit = 10.0_f64.powi(power);
        let space = LiePoisson::minus(So3);
        let h = from_closure::<LiePoisson<So3>, _>(move |Covector(pi)| pi.z * -field);
        let inner_product = InnerProduct::euclidean();
        let damped =
            DoubleBracket::new(space, Autonomous(h), friction / unit, inner_product).unwrap();
        let pi = Vector3::new(angle.sin(), 0.0, angle.cos()) * unit;
        let gauss = Driven::new(RungeKutta::gauss(5).unwrap(), HOPF, damped);
        let start = Pair(Covector(pi), Time(0.0));
        let end = gauss.after(&start, 0.05, 80).unwrap().momentum.0.0 / unit;
        let angle = 2.0 * ((angle / 2.0).tan() * (-friction * field * 4.0).exp()).atan();
        let turned = field * 4.0;
        let exact = Vector3::new(
            angle.sin() * turned.cos(),
            angle.sin() * turned.sin(),
            angle.cos(),
        );
        // Order ten with a step of 0.05 has an error of 1e-13.
        prop_assert!((end - exact).norm() < 1e-11, "{end} {exact}");
        prop_assert!((end.norm() - 1.0).abs() < 1e-13);
        // Control: an undamped spin stays at its angle.
        prop_assert!(friction < 0.01 || (end.z - pi.z / unit).abs() > 1e-6);
    }

    /// A heavy top loses energy by a double bracket at the rate −θ |Λ dh|², for any inner product, and keeps |Γ|² and Π·Γ.
    #[test]
    fn a_top_loses_energy_on_its_orbit(
        pi in prop::array::uniform3(-2.0..2.0_f64),
        numbers in prop::array::uniform12(-0.4..0.4_f64),
        friction in 0.05..0.5_f64,
    ) {
        let h = |Covector(Pair(pi, gamma)): &Covector<Pair<Vector3<f64>, Vector3<f64>>>| {
            (pi.x * pi.x / 2.0 + pi.y * pi.y / 1.5 + pi.z * pi.z) * 0.5
                + gamma.x * 0.6 + gamma.z * 0.8
        };
        let space = LiePoisson::minus(Se3::default());
        // A matrix AAᵀ + 1 with a lower triangle of random entries.
        let mut root = nalgebra::DMatrix::<f64>::identity(6, 6);
        for (place, number) in numbers.iter().enumerate() {
            root[(5 - place % 3, place / 3)] += number;
        }
        let matrix = &root * root.transpose();
        let inner_product = InnerProduct::new(matrix.as_slice()).unwrap();
        let gradient = lie_poisson::from_closures::<LiePoisson<Se3>, _, _>(
            h,
            |Covector(Pair(pi, _))| Pair(
                Vector3::new(pi.x / 2.0, pi.y / 1.5, pi.z),
                Vector3::new(0.6, 0.0, 0.8),
            ),
        );
        let (energy, rate) = (h, |mu: &_| {
            let dh = gradient.differential(mu);
            lie_poisson::PoissonSpace::hamiltonian_vector::<f64>(&space, mu, &dh)
        });
        let field = Autonomous(&gradient);
        let damped = DoubleBracket::new(space, field, friction, inner_product.clone()).unwrap();
        let gauss = Driven::new(RungeKutta::gauss(4).unwrap(), PARTICLE, damped);
        let gamma = Vector3::new(0.6, 0.48, 0.64);
        // The realisation is that of Π·Γ = 0.
        let pi = Vector3::from(pi).cross(&gamma);
        let start = Pair(Covector(Pair(pi, gamma)), Time(0.0));
        let samples: Vec<_> = gauss.trajectory(&start, 0.01).unwrap().take(301)
            .map(|sample| sample.unwrap().momentum.0).collect();
        for three in samples.windows(3).step_by(40) {
            let Covector(Pair(pi, gamma)) = three[1];
            prop_assert!((gamma.norm_squared() - 1.0).abs() < 1e-12);
            prop_assert!(pi.dot(&gamma).abs() < 1e-12);
            let change = rate(&three[1]);
            let sharp = inner_product.sharp::<LiePoisson<Se3>, f64>(&change);
            let loss = friction * lie_poisson::Vector::pairing(&sharp, &change);
            let slope = (energy(&three[2]) - energy(&three[0])) / 0.02;
            // The difference quotient has an error of h²/6 times the third derivative.
            prop_assert!((slope + loss).abs() < 5e-3 * (1.0 + loss), "{slope} {loss}");
        }
        prop_assert!(energy(&samples[300]) < energy(&samples[0]));
    }
}
