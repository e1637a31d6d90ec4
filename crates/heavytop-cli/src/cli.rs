//! The command line.

use crate::Error;
use crate::reproduce::reproduce;
use crate::simulate::simulate;
use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Simulates heavy tops with collective Lie–Poisson integrators.
///
/// The method is of T. Ohsawa, "Collective Heavy Top Dynamics", SIGMA 15 (2019) 083: a symplectic
/// scheme on T∗C², mapped to the phase space of the top, conserves the Casimirs f1 = |Γ|² and
/// f2 = Π·Γ exactly.
#[derive(Debug, Parser)]
#[command(name = "heavytop", version, after_long_help = EXIT_CODES)]
struct Arguments {
    /// Show no progress bar. (It shows on a terminal only, in long runs.)
    #[arg(long, global = true, display_order = 100)]
    quiet: bool,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Reproduce the paper's figures: Kovalevskaya's top with four integrators.
    #[command(long_about = REPRODUCE, after_long_help = REPRODUCE_EXAMPLES)]
    Reproduce {
        /// The folder for the figures and tables; made if it is not there.
        #[arg(long, value_name = "DIR", default_value = "figures")]
        out: PathBuf,
        /// The time to stop at, in seconds: a whole number of steps.
        #[arg(
            long,
            value_name = "SECONDS",
            default_value_t = 100.0,
            allow_negative_numbers = true
        )]
        end: f64,
        /// The time step, in seconds.
        #[arg(long, value_name = "SECONDS", default_value_t = 0.02, allow_negative_numbers = true)]
        step: f64,
    },
    /// Simulate a top and write its states and invariants.
    #[command(long_about = SIMULATE, after_long_help = SIMULATE_EXAMPLES)]
    Simulate {
        /// The configuration, in TOML. Without it the paper's Kovalevskaya top is run.
        config: Option<PathBuf>,
        /// The file to write; its name ends in .csv.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
}

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    let Arguments { quiet, command } = Arguments::parse();
    let done = match command {
        Command::Reproduce { out, end, step } => reproduce(&out, step, end, quiet),
        Command::Simulate { config, out } => simulate(config.as_deref(), &out, quiet),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => report(&error),
    }
}

fn report(error: &Error) -> ExitCode {
    use std::io::Write;
    // Where stderr is closed the exit code has to do.
    let _ = writeln!(std::io::stderr(), "heavytop: {error}");
    error.exit_code().into()
}

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the run failed: a stage equation did not converge, a state is not finite, or the disk is full;
     what was computed until then is kept as FILE.partial
  2  the request is wrong; nothing was written

Files appear under their name only when they are complete.";

const REPRODUCE: &str = "\
Reproduce the paper's figures: Kovalevskaya's top with four integrators.

The top has m = g = l = I3 = 1, I1 = I2 = 2 and its centre of mass along e1 (SI units throughout);
Π(0) = (2, 3, 4) and Γ(0) = (1/2, 0, √3/2). It is followed by the implicit and by the explicit
midpoint rule, each applied collectively, on T*C², and directly, to the six equations of the top.

Written into the folder, the figures each as .svg and .png:
  fig1a fig1b fig1c fig1d  h, f1, f2 and K: explicit midpoint collectively (blue) and directly
                           (green), implicit midpoint collectively (red)
  fig2a fig2b              h and K: implicit midpoint directly (gray) and collectively (red)
  trajectories.csv         all states: formulation,scheme,t,Pi1,...,Gamma3,h,f1,f2,K
  summary.csv              the largest deviation of h, f1, f2 and K from the initial value over all
                           steps; also printed";

const REPRODUCE_EXAMPLES: &str = "\
Examples:
  heavytop reproduce                              # the paper's Figures 1 and 2, in ./figures
  heavytop reproduce --out half --step 0.01       # half the step
  heavytop reproduce --out long --end 1000        # ten times as long";

const SIMULATE: &str = "\
Simulate a top and write its states and invariants.

Columns: t (s), Pi1,Pi2,Pi3 (kg m²/s, body frame), Gamma1,Gamma2,Gamma3 (the upward vertical, body
frame), h (J), f1 = |Γ|², f2 = Π·Γ (kg m²/s), then K ((kg m²/s)⁴) for a Kovalevskaya top, G
((kg m²/s)³) for a Goryachev–Chaplygin top. Row 0 is the initial state. Each number reads back as
the same 64-bit number.";

const SIMULATE_EXAMPLES: &str = "\
Configuration: every key may be left out, and has then the value below.
  [body]
  inertia = [2.0, 2.0, 1.0]          # principal moments, kg m²
  mass = 1.0                         # kg
  gravity = 1.0                      # m/s²; 0 gives the free rigid body
  length = 1.0                       # m, support to centre of mass
  center_of_mass = [1.0, 0.0, 0.0]   # direction in the body frame; a unit vector

  [initial]
  angular_momentum = [2.0, 3.0, 4.0]            # Π(0), kg m²/s, body frame
  vertical = [0.5, 0.0, 0.8660254037844386]     # Γ(0), body frame; a unit vector

  [integrator]
  formulation = \"collective\"         # or reduced, direct, splitting; see below
  scheme = \"implicit-midpoint\"       # see below
  step = 0.02                        # s
  end = 100.0                        # s; a whole number of steps
  tolerance = 0.0                    # of the stage equations; 0 iterates to the round-off floor

  [output]
  every = 1                          # keep every n-th step; the last step is always kept

Formulations:
  collective   on T*C², read through M: T*C² → se(3)*
  reduced      the same maps without a lift, on se(3)* itself
  direct       on the six equations of the top: not Poisson, whatever the scheme
  splitting    exact flows of the free top and of its weight, explicit and Poisson; of the free top
               as three rotors unless I1 = I2

Schemes; the number is the order:
  implicit-midpoint, gauss-4, gauss-6, gauss-8, gauss-10, gauss-12, gauss-16
                                        collective, reduced, direct
  explicit-midpoint, rk4                collective, direct
  symplectic-euler, stormer-verlet, lobatto-iiia-iiib-4
                                        collective, with a warning: they do not descend to se(3)*
  strang, yoshida-4, suzuki-4, yoshida-6, kahan-li-6, kahan-li-8
                                        all: compositions of Strang's splitting under splitting, of
                                        the implicit midpoint rule elsewhere, where strang is that
                                        rule itself

Examples:
  heavytop simulate --out kovalevskaya.csv        # the paper's top
  heavytop simulate top.toml --out top.csv
  heavytop simulate top.toml --out /dev/stdout | gzip > top.csv.gz";
