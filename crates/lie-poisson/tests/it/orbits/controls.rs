//! Controls: inputs along fixed elements of the algebra, and the times at which fields made of them are not smooth.

use lie_poisson::*;
use nalgebra::Vector3;
use proptest::prelude::*;

fn table(times: &[f64], values: &[f64]) -> InputTable {
    InputTable::new(times.to_vec(), values.to_vec(), Interpolation::Linear).unwrap()
}

proptest! {
    /// Breaks of a sum are those of its parts, in the order of time, and every wrapper tells those of its field.
    #[test]
    fn breaks_are_told_by_all_fields(time in -2.0..5.0_f64, forward: bool) {
        let one = table(&[0.0, 0.4, 1.0, 3.0], &[1.0, -0.5, 2.0, 0.7]);
        let other = table(&[-1.0, 2.0, 4.0], &[0.2, 0.9, -0.8]);
        let control = Inputs::new(vec![(Vector3::x(), one), (Vector3::y(), other.clone())]).unwrap();
        let still = Autonomous(from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y));
        let mut times = vec![-1.0, 0.0, 0.4, 1.0, 2.0, 3.0, 4.0];
        times.retain(|t| if forward { *t > time } else { *t < time });
        let expected = if forward { times.first() } else { times.last() }.copied();
        let space = LiePoisson::minus(So3);
        let field = Controlled { field: &still, control: &control };
        let bracket = DoubleBracket::new(space, &field, 0.1, InnerProduct::euclidean()).unwrap();
        let gilbert = GilbertDamping::new(space, &bracket, 0.1).unwrap();
        let nested = Controlled { field: &control, control: &gilbert };
        // Some of the times are given, in any order and twice, and the field tells the others.
        let given = vec![3.0, 0.4, 1.0, 0.0, 0.4];
        let other = Inputs::new(vec![(Vector3::y(), other)]).unwrap();
        let given = WithBreakpoints::new(&other, given).unwrap();
        let fields: [&dyn OrbitField<LiePoisson<So3>>; 6] =
            [&control, &field, &bracket, &gilbert, &nested, &given];
        for field in fields {
            prop_assert_eq!(field.next_break(time, forward), expected);
        }
        let still: &dyn OrbitField<LiePoisson<So3>> = &still;
        prop_assert_eq!(still.next_break(time, forward), None);
    }
}

#[test]
fn breakpoints_that_are_no_times_are_refused() {
    for time in [f64::NAN, f64::INFINITY] {
        let error = WithBreakpoints::new((), vec![0.5, time]).unwrap_err();
        assert!(error.place == 2 && !error.time.is_finite(), "{error}");
    }
}

#[test]
fn elements_of_inputs_that_are_no_numbers_are_refused() {
    let table = table(&[0.0, 1.0], &[2.0, 3.0]);
    let with = |xi| Inputs::new(vec![(Vector3::x(), table.clone()), (xi, table.clone())]);
    let error = with(Vector3::new(0.0, 0.0, f64::INFINITY)).unwrap_err();
    assert_eq!(error, InputsError::NotFinite { input: 2, coordinate: 3, number: f64::INFINITY });
    assert!(with(Vector3::new(f64::NAN, 0.0, 0.0)).is_err());
    let inputs = with(Vector3::y()).unwrap();
    assert_eq!(inputs.require_until(1.0, 0.0), Ok(()));
    assert_eq!(inputs.require_until(0.0, 1.5), table.require_until(0.0, 1.5));
    let at = |inputs: &Inputs<_>, t| {
        OrbitField::<LiePoisson<So3>>::element(inputs, &Covector(Vector3::zeros()), t)
    };
    assert_eq!(at(&inputs, 0.5), Vector3::new(2.5, 2.5, 0.0));
    assert!(at(&inputs, 1.5).x.is_nan());
    assert_eq!(at(&Inputs::new(vec![]).unwrap(), 7.0), Vector3::zeros());
}
