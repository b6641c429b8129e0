//! Walls made of particles: the values that a fluid particle sees of a wall particle.
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// No wall particles.
pub const NO_WALLS: u32 = 0;
/// Mirroring wall particles (Hinsch 2024, algorithm 1).
pub const MIRRORED: u32 = 1;
/// Dynamic boundary particles (Pirovano, section 3.5.3).
pub const DYNAMIC: u32 = 2;
/// Wall particles that take their pressure and velocity from the fluid around them (Adami, Hu and Adams 2012).
pub const EXTRAPOLATED: u32 = 3;
/// Wall particles that repel by the force of Lennard and Jones (Monaghan 1994; Pirovano, eq. 3.13).
pub const LENNARD_JONES: u32 = 4;
/// Wall particles that repel in proportion to the density kernel (Pirovano, section 3.5.2).
pub const KERNEL_FORCE: u32 = 5;

/// Returns whether wall particles repel, and have no part in density and pressure.
#[inline(always)]
pub fn repels_directly(m: &Model) -> bool {
    return m.has_repelling_walls == 1;
}

/// Returns `x`, or 0 for a wall particle that repels.
#[inline(always)]
pub fn unless_repelling<R: Real>(m: &Model, x: R, wall_b: R) -> R {
    if repels_directly(m) {
        return select(x, real(0.0), less(real(0.0), wall_b));
    }
    return x;
}

/// Returns the force of Lennard and Jones between a fluid particle and a wall particle, as the factor of `x_ab` in the
/// acceleration over the strength, 1/m2: `((h / r)^12 - (h / r)^6) / r^2` nearer than the particle spacing h. Nearer than
/// half of it, which a particle hardly comes, it grows no more than 1 / r^2.
#[inline(always)]
pub fn lennard_jones<R: Real>(p: &Parameters, r2: R) -> R {
    let one: R = real(1.0);
    let away2 = larger(r2, real(p.closest2));
    let s2 = smaller(div(real(p.spacing2), away2), real(4.0));
    let s6 = s2 * s2 * s2;
    let strength = larger(s6 * s6 - s6, real(0.0));
    return strength * div(one, away2);
}

/// Returns whether wall particles have no density of their own: what a fluid particle sees of them follows from the
/// fluid.
#[inline(always)]
pub fn follows_fluid(m: &Model) -> bool {
    return m.wall_particles == MIRRORED || m.wall_particles == EXTRAPOLATED || repels_directly(m);
}

/// Returns `x` for a neighbour in the fluid, and the particle's own value for a wall particle that follows the fluid.
#[inline(always)]
pub fn wall_following<R: Real>(m: &Model, own: R, x: R, wall_b: R) -> R {
    if follows_fluid(m) {
        return select(x, own, less(real(0.0), wall_b));
    }
    return x;
}

/// Returns `x` for a neighbour in the fluid, and the particle's own value for a mirroring wall particle (Hinsch 2024,
/// algorithm 1). With a mirrored pressure the wall always reacts, and never pulls harder than the fluid does.
#[inline(always)]
pub fn wall_mirrored<R: Real>(m: &Model, own: R, x: R, wall_b: R) -> R {
    if m.wall_particles == MIRRORED {
        return select(x, own, less(real(0.0), wall_b));
    }
    return x;
}

/// Returns the viscosity of a pair, Pa s: the mean of both particles, or for a wall particle the viscosity of the wall,
/// which ranges from no slip to no friction (Pirovano, section 3.5.3). A negative value stands for a wall without a
/// viscosity of its own, which has that of the particle.
#[inline(always)]
pub fn pair_viscosity<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.has_materials == 0 {
        return a.viscosity;
    }
    let nothing: R = real(0.0);
    let of_wall = select(b.viscosity, a.viscosity, less(b.viscosity, nothing));
    return select((a.viscosity + b.viscosity) * 0.5, of_wall, less(nothing, b.wall));
}

/// Returns `x`, or 0 for a wall particle without friction, whose viscosity is 0. Artificial viscosity acts between
/// particles that approach each other, and those that slide along a wall approach the wall particles ahead of them.
#[inline(always)]
pub fn unless_slipping<R: Real>(m: &Model, b: Local<R>, x: R) -> R {
    if m.wall_particles == NO_WALLS {
        return x;
    }
    // b.wall is 0 for a fluid particle
    let slips = less(abs(b.viscosity), b.wall * 0.000000000001);
    return select(x, real(0.0), slips);
}

/// Returns `x` for a fluid particle, and 0 for a wall particle or an inactive particle.
#[inline(always)]
pub fn if_free<R: Real>(m: &Model, x: vec3<R>, wall: R) -> vec3<R> {
    if m.wall_particles + m.has_inactive == NO_WALLS {
        return x;
    }
    let nothing: R = real(0.0);
    return only_if_free(m, vec3(nothing, nothing, nothing), x, wall);
}

/// Returns `free` for a particle that moves, and `held` for a wall particle or an inactive particle.
#[inline(always)]
pub fn only_if_free<R: Real>(m: &Model, held: vec3<R>, free: vec3<R>, wall: R) -> vec3<R> {
    if m.wall_particles + m.has_inactive == NO_WALLS {
        return free;
    }
    let is_held = less(real(0.0), wall);
    return vec3(select(free.x, held.x, is_held), select(free.y, held.y, is_held), select(free.z, held.z, is_held));
}

/// Returns the mass of a neighbour over that of a particle of the scene's first fluid at rest. A wall particle
/// that follows the fluid counts as one of the particle's own fluid.
#[inline(always)]
pub fn mass_seen<R: Real>(m: &Model, rest_a: R, mass_b: R, rest_b: R, wall_b: R) -> R {
    if m.is_multi_fluid == 0 {
        return mass_b;
    }
    return mass_b * wall_following(m, rest_a, rest_b, wall_b);
}

/// Returns the density of a neighbour over the rest density of the scene's first fluid. A wall particle that
/// follows the fluid counts as one of the particle's own fluid.
#[inline(always)]
pub fn density_seen<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    return density_ratio(m, b.deviation, wall_following(m, a.rest_ratio, b.rest_ratio, b.wall));
}

/// Returns `m_b / m_a`.
#[inline(always)]
pub fn mass_ratio<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.is_multi_fluid == 0 {
        return div(b.mass, a.mass);
    }
    return div(mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall), a.mass * a.rest_ratio);
}

/// Returns the volume of a neighbour, m3 (m2 in 2D). A mirroring wall particle has its own mass at the density of `a`.
#[inline(always)]
pub fn neighbour_volume<R: Real>(m: &Model, a: Local<R>, b: Local<R>) -> R {
    if m.has_variable_mass == 0 {
        return wall_mirrored(m, a.volume, b.volume, b.wall);
    }
    return wall_mirrored(m, a.volume * div(b.mass, a.mass), b.volume, b.wall);
}
