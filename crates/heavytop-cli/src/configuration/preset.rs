//! The presets: tops by name.

use super::config::Config;
use super::integrator_config::Integration;
use super::top::{BodyConfig, InitialConfig};
use clap::ValueEnum;
use heavytop::methods::{Formulation, SchemeName};

/// A top by name, with its start and its integrator: the defaults of a configuration.
///
/// All but the benchmark fix the moments and the weight moment m g l alone, which is all that the motion depends on: their
/// `[body]` has the key `weight_moment`, and says nothing about a mass and a length.
///
/// # Example
/// ```
/// use heavytop_cli::configuration::Preset;
/// // Brüls's top: the height of its centre of mass at t = 2 s
/// let (experiment, mut end) = (Preset::MultibodyBenchmark.config().experiment()?, None);
/// experiment.run(|_, t, mu, _| Ok::<_, heavytop_cli::Error>(end = Some((t, mu.0.1.y))))?;
/// let (t, height) = end.unwrap();
/// assert_eq!(t, 2.0);
/// assert!((height + 0.67302226956).abs() < 1e-8);
/// # Ok::<(), heavytop_cli::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Preset {
    /// The paper's top: I₁ = I₂ = 2I₃, centre of mass on e₁.
    Kovalevskaya,
    /// A symmetric top let go while it spins, so that its nutation has cusps.
    Lagrange,
    /// A free rigid body that tumbles: it turns nearly about the middle axis.
    Euler,
    /// I₁ = I₂ = 4I₃, centre of mass on e₁, Π·Γ = 0.
    GoryachevChaplygin,
    /// The fast heavy top on which multibody codes are compared.
    ///
    /// m = 15 kg with the moments (0.234375, 0.46875, 0.234375) kg m² about the centre of mass,
    /// which starts at (0, 1, 0) m from the support; g = 9.81 m/s² along −e₃;
    /// Ω(0) = (0, 150, −4.61538) rad/s, R(0) = 1. About the support the moments are
    /// J + m(|X|² − XXᵀ).
    ///
    /// Source: Brüls & Cardona, *On the use of Lie group time integrators in multibody dynamics*,
    /// J. Comput. Nonlinear Dynam. 5 (2010) 031002, §5.
    MultibodyBenchmark,
}

impl Preset {
    /// Returns the words for the top in messages: `the preset lagrange`.
    pub(crate) fn words(self) -> String {
        let name = self.to_possible_value().map(|value| value.get_name().to_owned());
        format!("the preset {}", name.unwrap_or_default())
    }

    /// Returns the configuration of the preset.
    #[must_use]
    pub fn config(self) -> Config {
        let mut config = Config::default();
        match self {
            Self::Kovalevskaya => {}
            Self::Lagrange => {
                config.body.center_of_mass = [0.0, 0.0, 1.0];
                config.initial.angular_momentum = [0.0, 0.0, 4.0];
            }
            Self::Euler => {
                config.body.inertia = [1.0, 2.0, 3.0].into();
                (config.body.gravity, config.body.weight_moment) = (0.0, Some(0.0));
                config.initial.angular_momentum = [0.1, 2.0, 0.1];
            }
            Self::GoryachevChaplygin => {
                config.body.inertia = [4.0, 4.0, 1.0].into();
                config.initial.angular_momentum = [2.0, 3.0, 0.0];
                config.initial.vertical = [0.0, 0.0, 1.0];
            }
            Self::MultibodyBenchmark => multibody_benchmark(&mut config),
        }
        config
    }
}

fn multibody_benchmark(config: &mut Config) {
    let (mass, central, spin) = (15.0, [0.234_375, 0.468_75, 0.234_375], [0.0, 150.0, -4.615_38]);
    let inertia: [f64; 3] = [central[0] + mass, central[1], central[2] + mass];
    let angular_momentum = std::array::from_fn(|i| inertia[i] * spin[i]);
    let (inertia, weight_moment) = (inertia.into(), None);
    let center_of_mass = [0.0, 1.0, 0.0];
    let own = BodyConfig::default();
    config.body = BodyConfig {
        inertia,
        mass,
        gravity: 9.81,
        length: 1.0,
        weight_moment,
        center_of_mass,
        ..own
    };
    let vertical = [0.0, 0.0, 1.0];
    config.initial = InitialConfig { angular_momentum, vertical, ..InitialConfig::default() };
    // A step of half a radian, which the method of order 16 integrates to round-off.
    config.integrator = Integration {
        formulation: Formulation::Reduced,
        scheme: SchemeName::Gauss(8),
        step: 0.003_125,
        end: 2.0,
        ..Integration::default()
    }
    .into();
}
