//! The methods of an algebra, by name, and the integrators that make their steps.

mod fastest_integrators;
mod methods_by_name;
mod schemes;
