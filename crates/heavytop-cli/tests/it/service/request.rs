//! What the service is asked for, and when it is disturbed.

use super::attempt::Disturbance;
use std::time::Duration;

/// Runs of 3000 steps, with two or more moments for checkpoints.
const CONFIGURATIONS: [&[&str]; 8] = [
    &["integrator={scheme='gauss-4',end=60}"],
    &["integrator={scheme='implicit-midpoint',end=60}", "output.attitude=true"],
    &["integrator={formulation='reduced',scheme='gauss-6',end=60}"],
    &["integrator={formulation='reduced',scheme='suzuki-4',end=60}", "output.attitude=true"],
    &["integrator={formulation='direct',scheme='rk4',end=60}"],
    &["integrator={formulation='splitting',scheme='yoshida-4',end=60}"],
    &["integrator={scheme='kahan-li-6',end=60}", "body.inertia=[1.0,2.0,3.0]"],
    &[
        "system={algebra='so(3)',hamiltonian='Pi1^2+2*Pi2^2',initial={Pi=[1.0,0.5,0.3]}}",
        "integrator.end=60",
    ],
];

const ENDINGS: [&str; 3] = ["csv", "npz", "parquet"];

/// A run that somebody asks for: one of the kinds, under a name of its own.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    pub kind: usize,
    pub number: u64,
}

impl Request {
    /// The number of configurations in all formats.
    pub const KINDS: usize = CONFIGURATIONS.len() * ENDINGS.len();

    pub fn out(&self) -> String {
        format!("{:05}.{}", self.number, ENDINGS[self.kind % ENDINGS.len()])
    }

    pub fn checkpoint(&self) -> String {
        self.out() + ".checkpoint"
    }

    /// Returns the arguments of a run that makes a checkpoint whenever it can.
    pub fn arguments(&self) -> Vec<String> {
        let out = self.out();
        let first = ["simulate", "--quiet", "--checkpoint-interval", "0", "--out", &out];
        let settings = CONFIGURATIONS[self.kind / ENDINGS.len()].iter().chain(&["output.every=10"]);
        let settings = settings.flat_map(|&setting| ["--set", setting]);
        first.into_iter().chain(settings).map(String::from).collect()
    }
}

/// Random numbers: SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0xd1b5_4a32_d192_ed03))
    }

    /// Returns a number below a bound.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % bound
    }

    /// Disturbs every other run, by one of three signals, at a moment within the time that a run takes and somewhat more.
    pub fn disturbance(&mut self, typical: u64) -> Option<Disturbance> {
        let signal = *[libc::SIGINT, libc::SIGTERM, libc::SIGKILL].get(self.below(6) as usize)?;
        let after = Duration::from_micros(self.below(typical * 6 / 5 + 1));
        Some(Disturbance { signal, after })
    }
}
