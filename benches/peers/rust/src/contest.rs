//! What the contestants in Rust share: the problem file (see `problem.hpp`), the clock and the line of JSON.

use std::error::Error;
use std::time::Instant;

/// The state (Π, Γ).
pub type State = [f64; 6];

/// A top with run-time parameters, and its states at times 0, 10 and `end`.
pub struct Problem {
    pub top: Top,
    pub end: f64,
    pub start: State,
    at_10: State,
    at_end: State,
}

/// I and γ = mgl c.
#[derive(Clone, Copy)]
pub struct Top {
    inertia: [f64; 3],
    gravity: [f64; 3],
}

impl Top {
    /// Π' = Π×Ω + Γ×γ, Γ' = Γ×Ω with Ω = I⁻¹Π, as a user of a library would write it.
    #[inline(always)]
    pub fn rate(&self, y: &[f64], dy: &mut [f64]) {
        let g = self.gravity;
        let w: [f64; 3] = core::array::from_fn(|i| y[i] / self.inertia[i]);
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            dy[i] = y[j] * w[k] - y[k] * w[j] + y[3 + j] * g[k] - y[3 + k] * g[j];
            dy[3 + i] = y[3 + j] * w[k] - y[3 + k] * w[j];
        }
    }
}

impl Problem {
    pub fn read(path: &str) -> Result<Self, Box<dyn Error>> {
        let text = std::fs::read_to_string(path)?;
        let numbers = text.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let (first, rest) = numbers.split_at_checked(8).ok_or("no top in the file")?;
        let states = rest.as_chunks::<6>().0;
        let &[start, at_10, at_end] = states else { return Err("not one top in the file".into()) };
        let top = Top {
            inertia: [first[0], first[1], first[2]],
            gravity: [4, 5, 6].map(|i| first[3] * first[i]),
        };
        Ok(Self { top, end: first[7], start, at_10, at_end })
    }
}

fn distance(a: &State, b: &State) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Runs `integrate(end)`, which returns the state at `end` and the number of steps, and prints the result: the time of the
/// least disturbed run of at least five that together take half a second, after one to warm up.
pub fn contest(
    name: &str,
    setting: &str,
    problem: &Problem,
    mut integrate: impl FnMut(f64) -> Result<(State, usize), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let error_10 = distance(&integrate(10.0)?.0, &problem.at_10);
    let (at_end, steps) = integrate(problem.end)?;
    let (mut best, mut total, mut repeats) = (f64::INFINITY, 0.0, 0);
    while repeats < 5 || total < 0.5 {
        let begin = Instant::now();
        std::hint::black_box(integrate(problem.end)?);
        let seconds = begin.elapsed().as_secs_f64();
        (best, total, repeats) = (best.min(seconds), total + seconds, repeats + 1);
    }
    println!(
        "{{\"name\": \"{name}\", \"setting\": \"{setting}\", \"seconds\": {best:e}, \"steps\": {steps}, \
         \"error_10\": {error_10:.3e}, \"error_{}\": {:.3e}}}",
        problem.end,
        distance(&at_end, &problem.at_end)
    );
    Ok(())
}
