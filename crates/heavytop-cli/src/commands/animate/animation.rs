//! The HTML page of a motion: its frames inside the files of the folder `page`.

use crate::pictures::caption;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use heavytop::{HeavyTop, Invariant};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};
use nalgebra::Vector3;
use serde::Serialize;
use std::io::{self, Write};

const PAGE: &str = include_str!("page/page.html");
const STYLE: &str = concat!(include_str!("page/common/palette.css"), include_str!("page/page.css"));
/// The scripts of the page, in the order in which they need each other. Those of the folder `common` serve the page to
/// play with (`crates/page`), too.
const SCRIPTS: &[&str] = &[
    include_str!("page/common/theme.js"),
    include_str!("page/common/numbers.js"),
    include_str!("page/common/vectors.js"),
    include_str!("page/motion.js"),
    include_str!("page/common/camera.js"),
    include_str!("page/common/ellipsoid.js"),
    include_str!("page/common/scene.js"),
    include_str!("page/common/pointers.js"),
    include_str!("page/strip.js"),
    include_str!("page/pace.js"),
    include_str!("page/controls.js"),
];

/// The motion of a top as one HTML page for a browser, which needs neither other files nor a network.
///
/// The body is drawn as the homogeneous ellipsoid about the support that has its principal moments
/// I₁, I₂, I₃, up to a common scale:
///
/// ```text
/// semi-axes aᵢ ∝ √(Iⱼ + Iₖ − Iᵢ),    (i, j, k) cyclic
/// ```
///
/// The page shows the first precession, or a tumble of a body without weight, in some ten seconds, and says at which speed.
/// A body without weight has no post.
///
/// In space, where the page draws, the body is turned by the attitude R, the angular momentum is RΠ
/// and the vertical RΓ = e₃ |Γ|. The tip is the direction Rc of the centre of mass, c in the body frame.
///
/// A frame is the numbers t (s), Π₁, Π₂, Π₃ (kg m²/s, body frame), Γ₁, Γ₂, Γ₃ (body frame), the four
/// of the unit quaternion of R, the scalar first, and the values of the
/// [invariants](HeavyTop::invariants_from) of the motion from the first frame. The page has them as 64-bit numbers, to the last bit: little-endian, in Base64, in
/// the key `numbers` of the JSON of its element `motion`.
///
/// # Example
/// ```
/// use heavytop::collective_integrators::{Collective, RungeKutta, Start};
/// use heavytop::{HeavyTop, SpinorRealisation, WithAttitude};
/// use heavytop_cli::commands::animate::Animation;
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let gauss = WithAttitude(Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, top));
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
///
/// let mut animation = Animation::new(top, "gauss-4, step 0.02 s");
/// for sample in gauss.trajectory(&start, 0.02)?.take(501) {
///     let sample = sample?;
///     animation.push(sample.time, &sample.momentum, &sample.state.1);
/// }
/// assert!(animation.largest_turn() < 0.1); // |Ω| is below 5 rad/s
/// let mut page = Vec::new();
/// animation.write(&mut page)?;
/// assert!(page.starts_with(b"<!DOCTYPE html>") && page.ends_with(b"</html>\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    top: HeavyTop,
    description: String,
    invariants: Vec<Invariant>,
    numbers: Vec<f64>,
    last: Option<Quaternion>,
    largest_turn: f64,
}

/// The data that the scripts of the page read.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Motion<'a> {
    description: &'a str,
    /// The numbers of the top and of its start.
    top: String,
    inertia: [f64; 3],
    /// m g l, N m; a body without weight is free.
    weight: f64,
    center_of_mass: [f64; 3],
    /// The symbols and units of the invariants.
    invariants: Vec<[&'static str; 2]>,
    numbers: String,
}

impl Animation {
    /// Creates an animation without frames; the description below the title says how the motion was computed.
    #[must_use]
    pub fn new(top: HeavyTop, description: &str) -> Self {
        let (invariants, description) = (Vec::new(), description.into());
        Self { top, description, invariants, numbers: Vec::new(), last: None, largest_turn: 0.0 }
    }

    /// Adds a frame: the time (s), (Π, Γ) in the body frame, and the attitude.
    ///
    /// Each time is later than the one before, or each earlier if the motion goes backward in time from 0. The attitude is the unit quaternion of the rotation R from the body
    /// frame to the spatial one, Γ ∥ Rᵀe₃.
    pub fn push(&mut self, time: f64, mu: &Se3Dual, attitude: &Quaternion) {
        if self.is_empty() {
            self.invariants = self.top.invariants_from(mu);
        }
        let Covector(Pair(pi, gamma)) = mu;
        let Quaternion { scalar, vector } = attitude;
        self.numbers.push(time);
        self.numbers.extend(pi.iter().chain(gamma));
        self.numbers.push(*scalar);
        self.numbers.extend(vector.iter());
        self.numbers.extend(self.invariants.iter().map(|i| i.value(&self.top, mu)));
        if let Some(last) = self.last.replace(*attitude) {
            let turn = last.conjugate() * *attitude;
            // q and −q are the same attitude.
            let angle = 2.0 * turn.vector.norm().atan2(turn.scalar.abs());
            self.largest_turn = lie_poisson::larger(self.largest_turn, angle);
        }
    }

    /// Returns the number of frames.
    #[must_use]
    pub fn len(&self) -> usize {
        self.numbers.len() / (1 + 3 + 3 + 4 + self.invariants.len())
    }

    /// Returns whether there is no frame yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Returns the largest angle between the attitudes of consecutive frames, in [0, π] rad.
    #[must_use]
    pub fn largest_turn(&self) -> f64 {
        self.largest_turn
    }

    /// Writes the page; a page without frames says so and shows nothing.
    ///
    /// # Errors
    /// Returns the error of the writer.
    pub fn write(&self, to: &mut impl Write) -> io::Result<()> {
        let bytes: Vec<u8> = self.numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let motion = Motion {
            description: &self.description,
            top: self.words(),
            inertia: self.top.inertia().into(),
            weight: self.top.weight_moment(),
            center_of_mass: self.top.center_of_mass().into(),
            invariants: self.invariants.iter().map(|i| [i.symbol(), i.unit()]).collect(),
            numbers: BASE64_STANDARD.encode(bytes),
        };
        // In a script element HTML knows no escapes, but JSON does: nothing can end the element.
        let motion = serde_json::to_string(&motion)?.replace('<', "\\u003c");
        let script = SCRIPTS.concat();
        write_filled(to, PAGE, &[("style", STYLE), ("script", &script), ("motion", &motion)])
    }
}

impl Animation {
    /// Returns the numbers of the top and of its start.
    fn words(&self) -> String {
        let top = caption::top(&self.top);
        match self.numbers.as_slice() {
            [_, pi1, pi2, pi3, gamma1, gamma2, gamma3, ..] => {
                let pi = Vector3::new(*pi1, *pi2, *pi3);
                let gamma = Vector3::new(*gamma1, *gamma2, *gamma3);
                format!("{top}; {}", caption::start(&Se3Dual::new(pi, gamma)))
            }
            _ => top,
        }
    }
}

/// Writes the template with each `{{name}}` in it replaced by the text of that name.
fn write_filled(to: &mut impl Write, template: &str, texts: &[(&str, &str)]) -> io::Result<()> {
    let mut rest = template;
    while let Some((before, name, after)) = placeholder(rest) {
        let text = texts.iter().find(|(known, _)| *known == name).map_or("", |(_, text)| text);
        write!(to, "{before}{text}")?;
        rest = after;
    }
    to.write_all(rest.as_bytes())
}

/// Finds the first `{{name}}`, and returns it with the text before and after it.
fn placeholder(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once("{{")?;
    let (name, after) = rest.split_once("}}")?;
    Some((before, name, after))
}
