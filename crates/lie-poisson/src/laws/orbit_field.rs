//! The law suites of [`OrbitField`] and of double brackets.

use super::{Faulty, NoSamples, Report, regimes};
use crate::algebras::algebra::Momentum;
use crate::brackets::casimirs::Casimirs;
use crate::brackets::hamiltonian::Hamiltonian;
use crate::brackets::poisson::{LiePoisson, PoissonSpace};
use crate::orbits::inner_product::InnerProduct;
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{
    Differential, DualNumber, Point, Real, State, Vector, derivative_part, larger, map_coordinates,
};

/// Evaluates the laws of an orbit field ξ on samples of momenta, from the time `begin` to `end`:
///
/// * `tangent to orbits`: ⟨dC, Λ ξ⟩ = 0 at both ends, for each Casimir C;
/// * `dual numbers`: over dual numbers ξ has the values that it has over `f64`;
/// * `breaks`: the next break is later than the time at which it is sought, or earlier if the time runs backward, and
///   the breaks are the same in both directions;
/// * `smoothness`: between breaks the change of ξ is the integral of ∂ξ/∂t. It is evaluated by Gauss's formula of order
///   6 with 32 panels, which sees a jump of ξ or of its first two derivatives; the field should change slowly from
///   panel to panel.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, InputTable, Inputs, Interpolation, LiePoisson, So3, laws};
/// use nalgebra::Vector3;
/// let table = InputTable::new(vec![0.0, 1.0, 3.0], vec![2.0, 5.0, 1.0], Interpolation::Linear)?;
/// let inputs = Inputs::new(vec![(Vector3::new(1.0, -2.0, 0.5), table)])?;
/// let samples = [Covector(Vector3::new(0.3, -0.7, 0.5)), Covector(Vector3::new(0.9, 0.2, -0.6))];
/// let space = LiePoisson::minus(So3);
/// laws::orbit_field(&space, &inputs, (0.0, 3.0), &samples)?.check(1e-13)?;
/// // Control: the suite refuses a field that tells no breaks.
/// let faulty = laws::Faulty::new(&inputs, "next_break", 0);
/// assert!(laws::orbit_field(&space, &faulty, (0.0, 3.0), &samples)?.check(1e-5).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn orbit_field<A, X>(
    space: &LiePoisson<A>,
    field: &X,
    (begin, end): (f64, f64),
    samples: &[Momentum<A>],
) -> Result<Report, NoSamples>
where
    A: Casimirs,
    X: OrbitField<LiePoisson<A>> + OrbitField<LiePoisson<A>, DualNumber>,
{
    let mut report = Report::default();
    let breaks = breaks::<LiePoisson<A>>(field, begin, end, &mut report);
    for mu in regimes("momenta", samples)? {
        for time in [begin, end] {
            let xi = OrbitField::<_, f64>::element(field, &mu, time);
            let rate = space.hamiltonian_vector::<f64>(&mu, &xi);
            for index in 0..A::COUNT {
                let dc = space.algebra().casimir_differential::<f64>(index, &mu);
                let size = dc.max_abs() * mu.max_abs() * xi.max_abs();
                report.note("tangent to orbits", rate.pairing(&dc).abs(), size);
            }
            let [value, _] = value_and_slope::<LiePoisson<A>, X>(field, &mu, time);
            report.note("dual numbers", (value - xi).max_abs(), xi.max_abs());
        }
        for piece in breaks.windows(2) {
            smoothness::<LiePoisson<A>, X>(field, &mu, (piece[0], piece[1]), &mut report);
        }
    }
    Ok(report)
}

/// Returns the breaks from `begin` to `end`, with both ends.
pub(super) fn breaks<P: PoissonSpace>(
    field: &impl OrbitField<P>,
    begin: f64,
    end: f64,
    report: &mut Report,
) -> Vec<f64> {
    let towards = |begin: f64, end: f64| {
        let (forward, mut all) = (end > begin, vec![begin]);
        let is_before = |a: f64, b: f64| if forward { a < b } else { a > b };
        let (mut last, mut ordered) = (begin, true);
        while let Some(next) = field.next_break(last, forward) {
            ordered &= is_before(last, next);
            if !ordered || !is_before(next, end) {
                break;
            }
            all.push(next);
            last = next;
        }
        all.push(end);
        (all, ordered)
    };
    let ((there, ordered), (mut back, ordered_back)) = (towards(begin, end), towards(end, begin));
    back.reverse();
    let holds = ordered && ordered_back && there == back;
    report.note("breaks", f64::from(u8::from(!holds)), 1.0);
    there
}

/// Returns ξ and ∂ξ/∂t by dual numbers.
fn value_and_slope<P, X>(field: &X, mu: &Point<P>, time: f64) -> [Differential<P>; 2]
where
    P: PoissonSpace,
    X: OrbitField<P, DualNumber>,
{
    let mu: Point<P, DualNumber> = map_coordinates(mu, DualNumber::constant);
    let xi = field.element(&mu, DualNumber::variable(time));
    [map_coordinates(&xi, |x: DualNumber| x.value_without_derivative()), derivative_part(&xi)]
}

/// The number of panels of the integral over the time between two breaks.
const PANELS: u32 = 32;

/// Notes the difference of the change of ξ and the integral of its derivative between two breaks.
pub(super) fn smoothness<P, X>(
    field: &X,
    mu: &Point<P>,
    (begin, end): (f64, f64),
    report: &mut Report,
) where
    P: PoissonSpace,
    X: OrbitField<P> + OrbitField<P, DualNumber>,
{
    let panel = (end - begin) / f64::from(PANELS);
    let node = 0.6_f64.sqrt() / 2.0;
    let (mut integral, mut size): (Differential<P>, f64) = (Vector::zero(), 0.0);
    for middle in (0..PANELS).map(|i| begin + panel * (f64::from(i) + 0.5)) {
        for (place, weight) in [(-node, 5.0), (0.0, 8.0), (node, 5.0)] {
            let [xi, slope] = value_and_slope::<P, X>(field, mu, middle + panel * place);
            integral.add_multiple(panel * (weight / 18.0), &slope);
            size = larger(size, larger(xi.max_abs(), slope.max_abs() * (end - begin).abs()));
        }
    }
    // The values at the ends belong to this interval, and not to its neighbours.
    let (after, before) = match begin < end {
        true => (begin.next_up(), end.next_down()),
        false => (begin.next_down(), end.next_up()),
    };
    let at = |time| OrbitField::<P, f64>::element(field, mu, time);
    report.note("smoothness", (at(before) - at(after) - integral).max_abs(), size);
}

/// Evaluates the laws of a double bracket, given as a field for each friction, at the time 0:
///
/// * `loss of energy`: dh/dt = ⟨dh, Λ ξ⟩ is −θ |Λ dh|², with the given inner product;
/// * `linear in the friction`: ξ is dh without friction, and changes in proportion to θ.
///
/// The suite takes 0, θ and 3θ for the given `friction` θ, whose unit is that of 1/μ if the inner product has none.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use lie_poisson::{Autonomous, Covector, DoubleBracket, InnerProduct, LiePoisson, So3, from_closure, laws};
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.z);
/// let (space, inner_product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
/// let damped = |space| {
///     let inner_product = inner_product.clone();
///     let field = Autonomous(&h);
///     move |friction| DoubleBracket::new(space, field, friction, inner_product.clone()).unwrap()
/// };
/// let samples = [Covector(Vector3::new(0.3, -0.7, 0.5)), Covector(Vector3::new(0.9, 0.2, -0.6))];
/// let check = |field_of| laws::double_bracket(&space, &h, &inner_product, field_of, 0.7, &samples);
/// check(damped(space))?.check(1e-13)?;
/// assert!(check(damped(LiePoisson::plus(So3)))?.check(1e-3).is_err()); // energy is fed
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn double_bracket<P, H, X>(
    space: &P,
    hamiltonian: &H,
    inner_product: &InnerProduct,
    field: impl Fn(f64) -> X,
    friction: f64,
    samples: &[Point<P>],
) -> Result<Report, NoSamples>
where
    P: PoissonSpace,
    H: Hamiltonian<P>,
    X: OrbitField<P>,
{
    let mut report = Report::default();
    for mu in regimes("points", samples)? {
        let dh = hamiltonian.differential(&mu);
        let rate = space.hamiltonian_vector::<f64>(&mu, &dh);
        let sharp = inner_product.sharp::<P, f64>(&rate);
        let tensor = space.poisson_tensor::<f64>(&mu).iter().fold(0.0, |m, x| larger(m, x.abs()));
        for friction in [0.0, friction, 3.0 * friction] {
            let xi = field(friction).element(&mu, 0.0);
            let change = space.hamiltonian_vector::<f64>(&mu, &xi).pairing(&dh);
            let loss = friction * rate.pairing(&sharp);
            let size = dh.max_abs() * tensor * xi.max_abs();
            report.note("loss of energy", (change + loss).abs(), size);
            let linear = xi - dh - sharp.scaled(friction);
            let size = dh.max_abs() + friction.abs() * sharp.max_abs();
            report.note("linear in the friction", linear.max_abs(), size);
        }
    }
    Ok(report)
}

/// The fault can be in the method [`element`](OrbitField::element). A fault of [`next_break`](OrbitField::next_break)
/// is that there is never one.
impl<P: PoissonSpace, T: Real, X: OrbitField<P, T>> OrbitField<P, T> for Faulty<'_, X> {
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        self.halved("element", self.object().element(mu, time))
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let is_silent = self.has_fault_in("next_break");
        self.object().next_break(time, forward).filter(|_| !is_silent)
    }
}
