//! Events of a run: functions of the momentum and the time, and the integrator that carries the time for them.

pub(crate) mod event_functions;
pub(crate) mod timed_integrator;
