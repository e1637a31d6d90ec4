//! The field of an open system on states of any dimension: [`OpenField`].

use super::elements::open_element::add;
use super::open_system::OpenSystem;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{AnyState, NoisePart, VectorField, Window};
use core::cell::RefCell;
use lie_poisson::{Pair, Real, State};
use nalgebra::Vector2;

/// A state: the point of a realisation or the momentum, the number of the path with the time in intervals, and the attitude, which
/// has four coordinates or none.
pub(super) type OpenState<T> = Pair<AnyState<T>, Pair<Vector2<T>, AnyState<T>>>;

/// The vectors of an evaluation.
#[derive(Debug)]
pub(super) struct Scratch<T> {
    /// The momentum, the time and the inputs.
    x: Vec<T>,
    pub(super) xi: Vec<T>,
    rate: Vec<T>,
    element: Vec<T>,
}

impl<T: Real> Scratch<T> {
    pub(super) fn new(dimension: usize) -> RefCell<Self> {
        let zeros = || vec![T::zero(); dimension];
        RefCell::new(Self { x: zeros(), xi: zeros(), rate: zeros(), element: zeros() })
    }
}

/// Which of the motions a part of a step makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Motions {
    /// All of them.
    All,
    /// The one along the coadjoint orbit.
    OnOrbit,
    /// That of the torque, for which the time stands still.
    OfTorque,
    /// That along the [element](OpenField::place) of another state, for which the time stands still.
    AlongElement,
}

/// The field of a part of a step.
pub(super) struct OpenField<'a, T> {
    pub(super) system: &'a OpenSystem,
    /// The momenta, and the sign of the generator that makes the bracket of the system; none if the state is the momentum.
    pub(super) momenta: Option<(&'a QuadraticMomenta, f64)>,
    pub(super) part: NoisePart<'a, T>,
    pub(super) motions: Motions,
    pub(super) window: Window<T>,
    pub(super) scratch: &'a RefCell<Scratch<T>>,
}

impl<T: Real> OpenField<'_, T> {
    /// Writes the momentum of a state with the time and the inputs, and the element of the algebra with which it moves.
    pub(super) fn place(&self, Pair(z, Pair(clock, _)): &OpenState<T>) {
        let scratch = &mut *self.scratch.borrow_mut();
        self.place_in(z, clock, scratch);
        self.element(scratch);
    }

    /// Writes the momentum of a state with the time and the inputs.
    fn place_in(&self, z: &AnyState<T>, clock: &Vector2<T>, scratch: &mut Scratch<T>) {
        let time = self.window.nearest(clock.y * self.system.interval());
        self.momentum(z, scratch);
        self.system.terms().inputs.append(time, &mut scratch.x);
    }

    /// Writes the momentum of a point.
    fn momentum(&self, z: &AnyState<T>, scratch: &mut Scratch<T>) {
        scratch.x.resize(self.system.base().algebra().dimension(), T::zero());
        match self.momenta {
            Some((momenta, _)) => momenta.values(z.as_slice(), &mut scratch.x),
            None => scratch.x.copy_from_slice(z.as_slice()),
        }
    }

    /// Writes the element of the algebra with which the momentum moves: that of the drift, and of the noise.
    fn element(&self, scratch: &mut Scratch<T>) {
        let Scratch { x, xi, rate, element } = scratch;
        self.system.write_element((self.part.drift, self.part.weights), x, [xi, rate, element]);
    }

    /// Adds the torque to a rate.
    fn add_torque(&self, x: &[T], rate: &mut [T]) {
        if let Some(torque) = &self.system.terms().torque {
            add(torque, x, T::from_f64(self.part.drift), rate);
        }
    }
}

impl<T: Real> VectorField<T> for OpenField<'_, T> {
    type Point = OpenState<T>;

    fn at(&self, z: &OpenState<T>) -> OpenState<T> {
        let mut value = z.zeros_like();
        self.at_into(z, &mut value);
        value
    }

    fn at_into(&self, Pair(z, Pair(clock, attitude)): &OpenState<T>, value: &mut OpenState<T>) {
        let Pair(rate, Pair(clock_rate, attitude_rate)) = value;
        let scratch = &mut *self.scratch.borrow_mut();
        if self.motions == Motions::AlongElement {
            self.momentum(z, scratch);
        } else {
            self.place_in(z, clock, scratch);
        }
        if self.motions == Motions::OfTorque {
            rate.as_mut_slice().fill(T::zero());
            self.add_torque(&scratch.x, rate.as_mut_slice());
            *clock_rate = Vector2::zeros();
            attitude_rate.as_mut_slice().fill(T::zero());
            return;
        }
        if self.motions != Motions::AlongElement {
            self.element(scratch);
        }
        let Scratch { x, xi, element, .. } = scratch;
        match self.momenta {
            Some((momenta, sign)) => {
                element.iter_mut().zip(xi.iter()).for_each(|(signed, xi)| *signed = *xi * sign);
                momenta.generator(element, z.as_slice(), rate.as_mut_slice());
            }
            None => {
                self.system.write_coadjoint(xi, x, rate.as_mut_slice());
                if self.motions == Motions::All {
                    self.add_torque(x, rate.as_mut_slice());
                }
            }
        }
        let clock_speed = self.part.drift / self.system.interval();
        *clock_rate = Vector2::new(T::zero(), T::from_f64(clock_speed));
        turn(attitude.as_slice(), xi, attitude_rate.as_mut_slice());
    }
}

/// Writes dq/dt = ½ q ω with the angular velocity ω in the body frame, if there is an attitude.
fn turn<T: Real>(attitude: &[T], omega: &[T], rate: &mut [T]) {
    let (&[w, x, y, z], &[a, b, c, ..]) = (attitude, omega) else { return };
    let turned = [
        -(x * a + y * b + z * c),
        w * a + y * c - z * b,
        w * b + z * a - x * c,
        w * c + x * b - y * a,
    ];
    rate.iter_mut().zip(turned).for_each(|(rate, turned)| *rate = turned * 0.5);
}
