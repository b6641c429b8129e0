//! Walls of particles: what one of their particles is to a particle of the fluid.
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::Model;

/// None.
pub const NO_WALLS: u32 = 0;
/// Hinsch 2024 algorithm 1.
pub const MIRRORED: u32 = 1;
/// Pirovano, section 3.5.3.
pub const DYNAMIC: u32 = 2;

/// `x` of a neighbour in the fluid; of a mirroring wall, what the particle itself has (Hinsch 2024 algorithm 1): a pressure that
/// always answers, and never pulls harder than the fluid does.
#[inline(always)]
pub fn wall_mirrored<R: Real>(m: &Model, own: R, x: R, wall_b: R) -> R {
    if m.wall_particles == MIRRORED {
        return select(x, own, less(real(0.0), wall_b));
    }
    return x;
}

/// Viscosity of a pair, Pa s: the mean, or that of the wall, from no slip to none (Pirovano, section 3.5.3); a wall that has none of
/// its own, which is written as a negative one, has the particle's.
#[inline(always)]
pub fn pair_viscosity<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.has_materials == 0 {
        return a.viscosity;
    }
    let nothing: R = real(0.0);
    let of_wall = select(b.viscosity, a.viscosity, less(b.viscosity, nothing));
    return select((a.viscosity + b.viscosity) * 0.5, of_wall, less(nothing, b.wall));
}

/// 0 for what a particle of a wall, or of air that is not there, would do, were it free.
#[inline(always)]
pub fn if_free<R: Real>(m: &Model, x: vec3<R>, wall: R) -> vec3<R> {
    if m.wall_particles + m.has_air == NO_WALLS {
        return x;
    }
    let nothing: R = real(0.0);
    return only_if_free(m, vec3(nothing, nothing, nothing), x, wall);
}

/// `free` for a particle that moves, `held` for one of a wall or of air that is not there.
#[inline(always)]
pub fn only_if_free<R: Real>(m: &Model, held: vec3<R>, free: vec3<R>, wall: R) -> vec3<R> {
    if m.wall_particles + m.has_air == NO_WALLS {
        return free;
    }
    let is_held = less(real(0.0), wall);
    return vec3(select(free.x, held.x, is_held), select(free.y, held.y, is_held), select(free.z, held.z, is_held));
}

/// Mass of a neighbour over that of a particle of the scene's first fluid at rest; a mirroring wall's is as if it were of
/// the particle's own fluid.
#[inline(always)]
pub fn mass_seen<R: Real>(m: &Model, rest_a: R, mass_b: R, rest_b: R, wall_b: R) -> R {
    if m.is_multi_fluid == 0 {
        return mass_b;
    }
    return mass_b * wall_mirrored(m, rest_a, rest_b, wall_b);
}

/// Density of a neighbour over that of the scene's first fluid at rest; a mirroring wall's is as if it were of the particle's
/// own fluid.
#[inline(always)]
pub fn density_seen<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    return density_ratio(m, b.deviation, wall_mirrored(m, a.rest_ratio, b.rest_ratio, b.wall));
}

/// `m_b / m_a`.
#[inline(always)]
pub fn mass_ratio<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.is_multi_fluid == 0 {
        return div(b.mass, a.mass);
    }
    return div(mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall), a.mass * a.rest_ratio);
}

/// Volume that a neighbour stands for, m3: for a mirroring wall its own mass at the particle's density.
#[inline(always)]
pub fn neighbour_volume<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.has_variable_mass == 0 {
        return wall_mirrored(m, a.volume, b.volume, b.wall);
    }
    return wall_mirrored(m, a.volume * div(b.mass, a.mass), b.volume, b.wall);
}
