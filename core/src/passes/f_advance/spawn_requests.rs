//! Finds the liquid particles beside which an air particle is to be made. Runs only with air.
//!
//! An exposed particle requests an air particle one spacing away, if no particle is near that position. If several
//! particles request air at nearly the same position, the one with the smallest id gets it. Particles that could be in
//! the way are searched around the requested position, not around the exposed particle: across a gap they may be
//! further away than a support radius. Few particles are exposed, so the pass does not use SIMD.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares, take};
use crate::grid::{Cells, Stencil, cell_of};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::pairs::cells;
use crate::terms::air::{is_taken, spawn_position};
use crate::terms::boundary::depth_behind;

/// The particles, by slot.
#[derive(Clone, Copy)]
struct Liquid<'a> {
    sorted: Cells<'a>,
    position: &'a [f32x4],
    /// Gradient of the colour of all fluids together; w: 1 for an exposed particle, else 0.
    gradient: &'a [f32x4],
    id: &'a [u32],
}

impl Liquid<'_> {
    fn place(&self, setup: &Setup<'_>, a: usize) -> vec3<f32> {
        let (x, normal) = (vec3::splat(self.position[a]), vec3::splat(self.gradient[a]));
        spawn_position(setup.model, setup.parameters, x, normal)
    }

    /// Returns the cells around a position, or `None` if the position is outside the range of the grid.
    fn around(&self, setup: &Setup<'_>, place: vec3<f32>) -> Option<Stencil> {
        let cell = cell_of(setup.parameters, [place.x, place.y, place.z, 0.0]).ok()?;
        Some(Stencil::around(setup.parameters, setup.model.is_3d as i32, self.sorted, cell as usize))
    }

    /// Returns whether no particle is near a position and the position is not behind a penalty plane.
    fn is_free(&self, setup: &Setup<'_>, place: vec3<f32>, around: &Stencil) -> bool {
        let (m, p) = (setup.model, setup.parameters);
        let planes = if m.has_container == 1 { p.plane_count as usize } else { 0 };
        let behind = |plane: &f32x4| depth_behind(place, vec3::splat(*plane), plane[3]) > 0.0;
        let taken = |b: usize| is_taken(m, p, place, vec3::<f32>::splat(self.position[b])) > 0.0;
        !p.planes[..planes].iter().any(behind) && !around.runs().flatten().any(taken)
    }

    /// Returns whether an air particle is to be made beside the particle in this slot.
    fn wants_spawn(&self, setup: &Setup<'_>, a: usize) -> bool {
        if self.gradient[a][3] == 0.0 {
            return false;
        }
        let place = self.place(setup, a);
        let Some(around) = self.around(setup, place) else { return false };
        let goes_first = |b: usize| {
            if self.gradient[b][3] == 0.0 || self.id[b] >= self.id[a] {
                return false;
            }
            let other = self.place(setup, b);
            is_taken(setup.model, setup.parameters, place, other) > 0.0
                && self.around(setup, other).is_some_and(|around| self.is_free(setup, other, &around))
        };
        self.is_free(setup, place, &around) && !around.runs().flatten().any(goes_first)
    }
}

/// Fills `spawn_requested`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, position, id) = (step.setup, &*step.new.position, &*step.new.id);
    let liquid = Liquid { sorted: cells!(step), position, gradient: step.scratch.total_colour_gradient, id };
    let mut rest = &mut *step.scratch.spawn_requested;
    let mut jobs = Jobs::new();
    for slots in shares(id.len(), parts(step.executor)) {
        let own = take(&mut rest, slots.len());
        let _ = jobs.push((slots.start, own));
    }
    step.executor.run(&mut jobs, |(first, own)| {
        for (i, own) in own.iter_mut().enumerate() {
            *own = u32::from(liquid.wants_spawn(&setup, *first + i));
        }
    });
}
