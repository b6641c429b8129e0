//! Diffusion of density between particles of one fluid (Molteni and Colagrossi 2009; Antuono et al. 2010; Fourtakas et
//! al. 2019).
use super::density::*;
use super::external::*;
use super::geometry::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// No diffusion.
pub const NO_DIFFUSION: u32 = 0;
/// Diffusion of the density (Molteni and Colagrossi 2009).
pub const PLAIN: u32 = 1;
/// Diffusion of the density that is not due to the weight of the fluid (Fourtakas et al. 2019).
pub const HYDROSTATIC: u32 = 2;
/// Diffusion of the density that differs from a linear field (Antuono et al. 2010).
pub const RENORMALISED: u32 = 3;

/// Returns the difference of the density deviations of two particles, `e_b - e_a`, that the weight of the fluid between
/// them causes: `g . (x_b - x_a) / c^2` (Fourtakas et al. 2019, eq. 15, to first order in the compression). `rest` is
/// the rest density of the fluid over that of the first fluid.
#[inline(always)]
pub fn hydrostatic_difference<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    x_ab: vec3<R>,
    sound: R,
    rest: R,
) -> R {
    return -div(dot3(weight(m, p, u, rest), x_ab), sound * sound);
}

/// Returns the difference of the density deviations of two particles, `e_b - e_a`, in a linear field with the mean of
/// their two renormalised gradients (Antuono et al. 2010, eq. 4).
#[inline(always)]
pub fn linear_difference<R: Real>(x_ab: vec3<R>, gradient_a: vec3<R>, gradient_b: vec3<R>) -> R {
    return dot3(gradient_a + gradient_b, x_ab) * -0.5;
}

/// Returns the contribution of a neighbour to the diffusion of density, `2 delta h c sum m_b / rho0 (e_b - e_a) |grad
/// W| / r`, as a sum of the same unit as [`continuity_neighbour`]. `difference` is `e_b - e_a`, without the part that
/// the weight causes if that is not to diffuse.
#[inline(always)]
pub fn diffusion_neighbour<R: Real>(
    m: &Model,
    p: &Parameters,
    difference: R,
    sound: R,
    mass_b: R,
    q: R,
    slope: R,
    scale: R,
) -> R {
    return density_neighbour(m, over_distance(difference * sound * p.diffusion * slope * scale, q), mass_b);
}

/// Returns `x` for a neighbour of the same fluid, and 0 for one of another fluid or of a wall.
#[inline(always)]
pub fn if_diffusing<R: Real>(m: &Model, x: R, fluid_a: R, fluid_b: R, wall_b: R) -> R {
    let nothing: R = real(0.0);
    if m.has_materials == 0 {
        return x;
    }
    let other = abs(fluid_a - fluid_b) + wall_b;
    return select(x, nothing, less(nothing, other));
}
