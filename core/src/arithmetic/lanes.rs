//! Eight numbers side by side, one particle a lane, never a sum across lanes: so eight lanes give the bits of eight scalar
//! runs.

#[cfg(not(target_arch = "x86_64"))]
pub(crate) use super::portable::Lanes as Base;
/// Lanes in the instructions that every processor of the target has.
#[cfg(target_arch = "x86_64")]
pub(crate) use super::x86::Sse as Base;
