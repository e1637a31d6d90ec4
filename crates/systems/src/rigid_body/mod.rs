//! Rigid bodies in N dimensions, on so(N)∗.

pub(crate) mod generalised_rigid_body;
