//! Half a step of the collective midpoint rule for tops, from a guess of a = (h/4) Ω̄.

use super::components::{Components, State, add_cross, cross, dot, each};
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
    /// n = 1/(1+|a|²)
    scale: T,
    /// 2n a
    axis: Components<T>,
}

impl<T: Lanes> HalfTurn<T> {
    /// R_a − 1 = 2n (a aᵀ − |a|² − [a]×), where [a]× v = a×v.
    #[inline(always)]
    fn new(a: &Components<T>, square: T) -> Self {
        let scale = T::one() / (square + 1.0);
        let twice = scale + scale;
        let b = each!(i => twice * a[i]);
        let diagonal = twice * square;
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
        Self { rows, scale, axis: b }
    }

    /// x + (R_a − 1) v
    #[inline(always)]
    fn add(&self, x: &Components<T>, v: &Components<T>) -> Components<T> {
        each!(i => {
            let row = &self.rows[i];
            row[0].multiply_add(v[0], row[1].multiply_add(v[1], row[2].multiply_add(v[2], x[i])))
        })
    }

    /// R_a v
    #[inline(always)]
    fn apply(&self, v: &Components<T>) -> Components<T> {
        self.add(v, v)
    }
}

/// The first half of a step, with a guess a.
pub(super) struct Guess<T> {
    a: Components<T>,
    /// |a|²
    square: T,
    half_turn: HalfTurn<T>,
    /// G = R_a Γ₀
    vertical: Components<T>,
    /// R_a Π₀
    momentum: Components<T>,
    /// d, where a − d is nearer to the solution.
    correction: Components<T>,
}

impl<T: Lanes> Guess<T> {
    /// The residual r = a − (h/4) I⁻¹Π̄, with G = R_a Γ₀ and n = 1/(1+|a|²),
    ///
    /// ```text
    /// Π̄ = n ( R_a Π₀ + ½ h n ( G×(γ + γ×a) − (a·γ) G ) ),
    /// ```
    ///
    /// and the correction d = (1 − M)⁻¹r ≈ r + M r by the leading part 1 − M of its derivative,
    /// M r = (h/4) I⁻¹ (2 Π̄×r) = 2 I⁻¹((I a)×r).
    #[inline(always)]
    pub fn new(top: &Parameters<T>, start: &State<T>, a: Components<T>) -> Self {
        let square = dot(&a, &a);
        let half_turn = HalfTurn::new(&a, square);
        let half_kick = top.half_step * half_turn.scale;
        let force = add_cross(&top.force, &top.force, &a);
        let force = each!(i => half_kick * force[i]);
        let along = half_kick * dot(&a, &top.force);
        let vertical = half_turn.apply(&start.vertical);
        let momentum = half_turn.apply(&start.momentum);
        let middle = add_cross(&momentum, &vertical, &force);
        let middle = each!(i => along.negative_multiply_add(vertical[i], middle[i]));
        let residual =
            each!(i => (top.rate[i] * half_turn.scale).negative_multiply_add(middle[i], a[i]));
        let spin = each!(i => top.inertia[i] * a[i]);
        let [x, y, z] = residual;
        let [u, v, w] = top.twice_inverse;
        let correction = [
            (u * spin[1]).multiply_add(z, (u * spin[2]).negative_multiply_add(y, x)),
            (v * spin[2]).multiply_add(x, (v * spin[0]).negative_multiply_add(z, y)),
            (w * spin[0]).multiply_add(y, (w * spin[1]).negative_multiply_add(x, z)),
        ];
        Self { a, square, half_turn, vertical, momentum, correction }
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

    /// The end of the step with the rotation R_{a−d} = R_ε R_a, ε = −n (d + d×a),
    ///
    /// ```text
    /// Γ₁ = R_{a−d} R_{a−d} Γ₀,    Π₁ = R_{a−d} ( R_{a−d} Π₀ + h n (R_{a−d} Γ₀)×γ )
    /// ```
    ///
    /// to the first order in d: what does not depend on d need not wait for it. With η = ε + R_a ε,
    ///
    /// ```text
    /// Γ₁ = V + 2 V×η,                V = R_a G
    /// Π₁ = W + 2 W×η + 2 h n G×(ε×γ),    W = R_a ( R_a Π₀ + h n G×γ )
    /// ```
    #[inline(always)]
    pub fn end(&self, top: &Parameters<T>) -> State<T> {
        let turn = &self.half_turn;
        let half_kick = top.half_step * turn.scale;
        let force = each!(i => (half_kick + half_kick) * top.force[i]);
        let vertical = turn.apply(&self.vertical);
        let momentum = turn.apply(&add_cross(&self.momentum, &self.vertical, &force));
        // −2ε
        let d = &self.correction;
        let twice = turn.scale + turn.scale;
        let epsilon = add_cross(&each!(i => twice * d[i]), d, &turn.axis);
        // −2η
        let eta = turn.add(&each!(i => epsilon[i] + epsilon[i]), &epsilon);
        let kick = cross(&force, &epsilon);
        State {
            momentum: add_cross(&add_cross(&momentum, &eta, &momentum), &self.vertical, &kick),
            vertical: add_cross(&vertical, &eta, &vertical),
        }
    }
}
