//! Values and derivatives: of conditions, against differences, and over other scalars.

mod conditions;
mod derivatives;
mod formulas_in_lanes;
