//! Is the pressure good enough? Only where it is corrected.
use crate::layout::Parameters;

/// Do iterations end with this largest miss, given as bits? Not with one that is no number.
pub(crate) fn run(p: &Parameters, residual: u32) -> bool {
    f32::from_bits(residual) <= p.tolerance
}
