//! Loads the particle data of passes over pairs. Receivers are loaded from consecutive slots, each into all of its
//! lanes. Neighbours are gathered from the slots in the lists, one per lane.
use super::columns::{Column, of_materials};
use super::context::Setup;
use super::lanes::is_wall;
use crate::arithmetic::lanes::{Lanes, Slots};
use crate::arithmetic::real::{real, vec3};
use crate::layout::{MaterialRows, f32x4};
use crate::terms::pair::{Local, Stiffness};

/// The arrays that passes over pairs read.
#[derive(Clone, Copy)]
pub(crate) struct Particles<'a> {
    pub position: &'a [f32x4],
    pub velocity: &'a [f32x4],
    /// Empty if the pass computes it, or does not need it.
    pub density_pressure: &'a [f32x4],
    /// Support radius over that of the scene. Empty if all particles have the same support radius.
    pub support: &'a [f32],
}

/// Returns the particles of a step. `but density` leaves out density and pressure, for a pass that writes them.
///
/// This is a macro because a function would borrow the whole state, while the pass writes to one of its arrays.
macro_rules! particles {
    ($step:ident) => {
        $crate::passes::local::Particles {
            density_pressure: &*$step.new.density_pressure,
            ..$crate::passes::local::particles!($step but density)
        }
    };
    ($step:ident but density) => {
        $crate::passes::local::Particles {
            position: &*$step.new.position,
            velocity: if matches!($step.command, $crate::plan::schedule::Command::RunAgain(_)) {
                &*$step.scratch.end_velocity
            } else {
                &*$step.new.velocity
            },
            density_pressure: &[],
            support: &*$step.scratch.support_ratio,
        }
    };
}
pub(crate) use particles;

impl Particles<'_> {
    /// Loads particles `first ..= last` as receivers, each in all of its lanes. The last particle fills the remaining
    /// lanes.
    #[inline(always)]
    pub(crate) fn receivers<R: Lanes>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Local<R> {
        let velocity = spread(self.velocity, first, last);
        let density_pressure = if self.is_known() { spread(self.density_pressure, first, last) } else { nothing() };
        let support = self.supports(setup, first, last);
        local(setup, spread(self.position, first, last), velocity, density_pressure, support)
    }

    /// Gathers the neighbours, one per lane.
    #[inline(always)]
    pub(crate) fn neighbours<R: Lanes>(&self, setup: &Setup<'_>, slots: &Slots) -> Local<R> {
        // positions first: distances and their square roots take longest
        let position = R::gather(self.position, slots);
        let velocity = R::gather(self.velocity, slots);
        let density_pressure = if self.is_known() { R::gather(self.density_pressure, slots) } else { nothing() };
        let support = self.supports_of(setup, slots);
        local(setup, position, velocity, density_pressure, support)
    }

    /// Returns whether densities and pressures are available.
    #[inline(always)]
    fn is_known(&self) -> bool {
        !self.density_pressure.is_empty()
    }

    /// Returns the support radii of receivers over that of the scene.
    #[inline(always)]
    pub(crate) fn supports<R: Lanes>(&self, setup: &Setup<'_>, first: usize, last: usize) -> R {
        if setup.model.has_variable_support == 0 {
            return real(1.0);
        }
        R::from_lanes(|lane| self.support[(first + lane / R::NEIGHBOURS).min(last)])
    }

    /// Returns the support radii of neighbours over that of the scene.
    #[inline(always)]
    pub(crate) fn supports_of<R: Lanes>(&self, setup: &Setup<'_>, slots: &Slots) -> R {
        if setup.model.has_variable_support == 0 {
            return real(1.0);
        }
        R::from_lanes(|lane| self.support[slots.lane(lane)])
    }

    /// Returns the constants that turn the density of receivers `first ..= last` into pressures.
    #[inline(always)]
    pub(crate) fn stiffness<R: Lanes>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Stiffness<R> {
        let (materials, columns) = (setup.materials, setup.columns);
        let [.., material] = spread::<R>(self.velocity, first, last);
        let of_states = |i: usize| -> R { of_material(setup, &materials.states, &columns.states, material, i) };
        let of_correction =
            |i: usize| -> R { of_material(setup, &materials.corrections, &columns.corrections, material, i) };
        Stiffness {
            state: of_states(0),
            near: of_states(1),
            pressure_response: of_correction(0),
            response_offset: of_correction(1),
            compressibility: of_correction(2),
        }
    }

    /// Returns whether all of the particles `first ..= last` are wall particles or inactive. These have no
    /// acceleration.
    #[inline(always)]
    pub(crate) fn are_walls(&self, setup: &Setup<'_>, first: usize, last: usize) -> bool {
        let held = setup.model.wall_particles != 0 || setup.model.has_inactive == 1;
        held && self.velocity[first..=last].iter().all(|v| is_wall(setup.materials, v[3]))
    }

    /// Returns whether some of the particles `first ..= last` are wall particles or inactive.
    #[inline(always)]
    pub(crate) fn have_walls(&self, setup: &Setup<'_>, first: usize, last: usize) -> bool {
        self.velocity[first..=last].iter().any(|v| is_wall(setup.materials, v[3]))
    }
}

/// Loads rows `first ..= last`, each in all lanes of a receiver. The last row fills the remaining lanes.
#[inline(always)]
pub(crate) fn spread<R: Lanes>(rows: &[f32x4], first: usize, last: usize) -> [R; 4] {
    R::spread(|receiver| &rows[(first + receiver).min(last)])
}

/// Loads the current entries `own` of the receivers.
#[inline(always)]
pub(crate) fn own_numbers<R: Lanes>(own: &[f32x4]) -> [R; 4] {
    spread(own, 0, own.len() - 1)
}

/// Returns four zeros.
#[inline(always)]
pub(crate) fn nothing<R: Lanes>() -> [R; 4] {
    [real(0.0); 4]
}

/// Builds the particles in the lanes from their rows and the constants of their materials.
#[inline(always)]
fn local<R: Lanes>(
    setup: &Setup<'_>,
    [x, y, z, mass]: [R; 4],
    [vx, vy, vz, material]: [R; 4],
    [deviation, pressure, near_pressure, volume]: [R; 4],
    support: R,
) -> Local<R> {
    let (materials, columns) = (setup.materials, setup.columns);
    let of_properties = |i: usize| -> R { of_material(setup, &materials.properties, &columns.properties, material, i) };
    let of_states = |i: usize| -> R { of_material(setup, &materials.states, &columns.states, material, i) };
    Local {
        position: vec3(x, y, z),
        velocity: vec3(vx, vy, vz),
        support,
        mass,
        deviation,
        pressure,
        near_pressure,
        volume,
        viscosity: of_properties(0),
        wall: of_properties(1),
        rest_ratio: of_properties(2),
        fluid: of_properties(3),
        speed_of_sound: of_states(2),
        state_equation: of_states(3),
        tension: of_material(setup, &materials.corrections, &columns.corrections, material, 3),
    }
}

/// Returns number `i` of the constants in `rows` for the materials in the lanes.
#[inline(always)]
pub(crate) fn of_material<R: Lanes>(
    setup: &Setup<'_>,
    rows: &MaterialRows,
    columns: &[Column; 4],
    material: R,
    i: usize,
) -> R {
    if setup.model.has_materials == 0 {
        return real(rows[0][i]);
    }
    if setup.columns.hold_all {
        R::pick(&columns[i], setup.columns.places(material))
    } else {
        of_materials(rows, material, i)
    }
}
