//! Places for new particles: whether one is free, and where exposed particles of liquid request air.
use super::context::Setup;
use crate::arithmetic::real::vec3;
use crate::grid::{Cells, Stencil, cell_of};
use crate::layout::f32x4;
use crate::solids::is_in_solid;
use crate::terms::air::{is_taken, spawn_position};
use crate::terms::boundary::depth_behind;

/// The particles among which places are looked for, by slot.
#[derive(Clone, Copy)]
pub(super) struct Places<'a> {
    pub(super) sorted: Cells<'a>,
    pub(super) position: &'a [f32x4],
    /// Gradient of the colour of all fluids together; w: 1 for an exposed particle, else 0. Empty without air.
    pub(super) gradient: &'a [f32x4],
}

impl Places<'_> {
    /// Returns the place at which an exposed particle requests air.
    pub(super) fn beside(&self, setup: &Setup<'_>, a: usize) -> vec3<f32> {
        let (x, normal) = (vec3::splat(self.position[a]), vec3::splat(self.gradient[a]));
        spawn_position(setup.model, setup.parameters, x, normal)
    }

    /// Returns the cells around a position, or `None` if the position is outside the range of the grid.
    pub(super) fn around(&self, setup: &Setup<'_>, place: vec3<f32>) -> Option<Stencil> {
        let cell = cell_of(setup.parameters, [place.x, place.y, place.z, 0.0]).ok()?;
        Some(Stencil::around(setup.parameters, setup.model.is_3d as i32, self.sorted, cell as usize))
    }

    /// Returns whether no particle is near a position and the position is not behind a plane of the container or in a
    /// solid.
    pub(super) fn is_free(&self, setup: &Setup<'_>, place: vec3<f32>, around: &Stencil) -> bool {
        let (m, p) = (setup.model, setup.parameters);
        let planes = if m.has_container == 1 { p.plane_count as usize } else { 0 };
        let behind = |plane: &f32x4| depth_behind(place, vec3::splat(*plane), plane[3]) > 0.0;
        let taken = |b: usize| is_taken(m, p, place, vec3::<f32>::splat(self.position[b])) > 0.0;
        let is_behind = p.planes[..planes].iter().any(behind);
        let is_inside = m.has_solids == 1 && is_in_solid(m, p, setup.poses, place);
        !is_behind && !is_inside && !around.runs().flatten().any(taken)
    }
}
