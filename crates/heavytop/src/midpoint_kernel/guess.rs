//! Half a step of the collective midpoint rule for tops, from a guess of a = (h/4) Ω̄.

use super::components::{Components, State, add_cross, dot, each};
use super::parameters::Parameters;
use lie_poisson::{Lanes, Mask};

/// A guess is accepted when its error, after the correction, is below this multiple of |a|.
const FLOOR: f64 = 2.0 * f64::EPSILON;

/// A correction that has not become smaller is round-off below this multiple of |a|.
const ROUND_OFF: f64 = 128.0 * f64::EPSILON;

/// The rotation R_a as the matrix R_a − 1, whose entries are of the size of |a|, so that their
/// rounding is small against that of the vectors which it turns.
struct HalfTurn<T> {
    rows: [Components<T>; 3],
    /// 2n, n = 1/(1+|a|²)
    scale: T,
}

impl<T: Lanes> HalfTurn<T> {
    /// R_a − 1 = 2n (a aᵀ − |a|² − [a]×), where [a]× v = a×v.
    #[inline(always)]
    fn new(a: &Components<T>, square: T) -> Self {
        let half = T::from_f64(0.5);
        let scale = T::one() / half.multiply_add(square, half);
        let b = each!(i => scale * a[i]);
        let diagonal = scale * square;
        let rows = [
            [
                b[0].multiply_subtract(a[0], diagonal),
                b[0].multiply_add(a[1], b[2]),
                b[0].multiply_subtract(a[2], b[1]),
            ],
            [
                b[1].multiply_subtract(a[0], b[2]),
                b[1].multiply_subtract(a[1], diagonal),
                b[1].multiply_add(a[2], b[0]),
            ],
            [
                b[2].multiply_add(a[0], b[1]),
                b[2].multiply_subtract(a[1], b[0]),
                b[2].multiply_subtract(a[2], diagonal),
            ],
        ];
        Self { rows, scale }
    }

    /// R_a v
    #[inline(always)]
    fn apply(&self, v: &Components<T>) -> Components<T> {
        each!(i => {
            let row = &self.rows[i];
            row[0].multiply_add(v[0], row[1].multiply_add(v[1], row[2].multiply_add(v[2], v[i])))
        })
    }
}

/// The first half of a step, with a guess a.
pub(super) struct Guess<T> {
    a: Components<T>,
    /// |a|²
    square: T,
    half_turn: HalfTurn<T>,
    /// F
    force: Components<T>,
    /// α
    along: T,
    /// X
    middle: Components<T>,
    /// d, where a − d is nearer to the solution.
    correction: Components<T>,
}

impl<T: Lanes> Guess<T> {
    /// The residual r = a − (h/4) I⁻¹Π̄. In terms of Π₀ and Γ₀, with n = 1/(1+|a|²),
    ///
    /// ```text
    /// F = ½ h n (γ − γ×a),  α = ½ h n a·γ
    /// X = R_a ( Π₀ + Γ₀×F − α Γ₀ ),  Π̄ = n X,
    /// ```
    ///
    /// and the correction is d = (1 − M)⁻¹r ≈ r + M r by the leading part 1 − M of the derivative,
    /// M r = (h/4) I⁻¹ (2 Π̄×r) = 2 I⁻¹((I a)×r).
    #[inline(always)]
    pub fn new(top: &Parameters<T>, start: &State<T>, a: Components<T>) -> Self {
        let square = dot(&a, &a);
        let half_turn = HalfTurn::new(&a, square);
        let scale = half_turn.scale;
        let force = add_cross(&top.force, &a, &top.force);
        let force = each!(i => scale * force[i]);
        let along = scale * dot(&a, &top.force);
        let gamma = &start.vertical;
        let kicked = add_cross(&start.momentum, gamma, &force);
        let kicked = each!(i => along.negative_multiply_add(gamma[i], kicked[i]));
        let middle = half_turn.apply(&kicked);
        let residual = each!(i => (top.rate[i] * scale).negative_multiply_add(middle[i], a[i]));
        let [x, y, z] = residual;
        let (next, previous) = (&top.next_ratio, &top.previous_ratio);
        let correction = [
            (next[0] * a[1]).multiply_add(z, (previous[0] * a[2]).negative_multiply_add(y, x)),
            (next[1] * a[2]).multiply_add(x, (previous[1] * a[0]).negative_multiply_add(z, y)),
            (next[2] * a[0]).multiply_add(y, (previous[2] * a[1]).negative_multiply_add(x, z)),
        ];
        Self { a, square, half_turn, force, along, middle, correction }
    }

    /// |d|²
    #[inline(always)]
    pub fn change(&self) -> T {
        dot(&self.correction, &self.correction)
    }

    /// Where the error of a − d, at most κ|d|, is at the floor. False where something is NaN.
    #[inline(always)]
    pub fn settled(&self, top: &Parameters<T>) -> T::Mask {
        let rate = (self.square * self.square).multiply_add(top.turning_rate, top.kick_rate);
        let size = self.square + top.least_square;
        (self.change() * rate).at_most(size * (FLOOR * FLOOR))
    }

    /// Where the correction is round-off, for an iteration that no longer gets better.
    #[inline(always)]
    pub fn stalled(&self, top: &Parameters<T>, previous: T) -> T::Mask {
        let change = self.change();
        let size = self.square + top.least_square;
        previous.at_most(change).and(change.at_most(size * (ROUND_OFF * ROUND_OFF)))
    }

    /// a − d
    #[inline(always)]
    pub fn corrected(&self) -> Components<T> {
        each!(i => self.a[i] - self.correction[i])
    }

    /// The end of the step with a − d in the place of a. With G = R_a Γ₀ and Y = R_a Π₀ + h n G×γ,
    ///
    /// ```text
    /// Y = X + G×F + α G,  Γ₁ = R_a G,  Π₁ = R_a Y
    /// ```
    ///
    /// where a solves the equation, and R_{a−d} R_{a−d} = R_a (1 + [δ]×) R_a, δ = 4n d, to the
    /// first order in d. So what does not depend on d need not wait for it:
    ///
    /// ```text
    /// Γ₁ = R_a (G + δ×G),    Π₁ = R_a (Y + δ×Y)
    /// ```
    ///
    /// This leaves a term ½ h n G×(γ×δ) out of Π₁, which `kick_rate` keeps below the floor.
    #[inline(always)]
    pub fn end(&self, start: &State<T>) -> State<T> {
        let turn = &self.half_turn;
        let vertical = turn.apply(&start.vertical);
        let momentum = add_cross(&self.middle, &vertical, &self.force);
        let momentum = each!(i => self.along.multiply_add(vertical[i], momentum[i]));
        let twice = turn.scale + turn.scale;
        let delta = each!(i => twice * self.correction[i]);
        State {
            momentum: turn.apply(&add_cross(&momentum, &delta, &momentum)),
            vertical: turn.apply(&add_cross(&vertical, &delta, &vertical)),
        }
    }
}
