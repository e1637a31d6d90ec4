//! Torques that take a motion off its coadjoint orbit, and what they supply.

mod support;
mod compositions_of_flows;
mod ready_torques;
mod tabulated_torques;
mod laws_of_balance;
