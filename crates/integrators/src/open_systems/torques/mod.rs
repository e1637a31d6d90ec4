//! Ready-made torques.

pub(crate) mod torque_error;
pub(crate) mod constant_torque;
pub(crate) mod viscous_torque;
pub(crate) mod viscous_matrix;
pub(crate) mod tabulated_torque;
