//! Solids as walls in closed form: what of a kernel lies in them. A solid stands for the plane that touches it at the
//! point nearest to the particle, bent by its curvature. A box stands for its sides: the part of the kernel that lies in
//! it is the product of the parts between each pair of sides, which is exact for a Gaussian. A cylinder stands for its
//! ends and its round side in the same way.
use super::context::Setup;
use super::faces::{Face, Front, NOTHING, with_face};
use crate::arithmetic::real::{div, less, vec3};
use crate::solids::{Solid, Surface, solids};
use crate::terms::beyond::{Beyond, curved_share, part_between, part_in_front_of_curved, part_within};
use crate::terms::shape::{BOX, CYLINDER, beyond_cylinder, direction_or};

/// A solid that is near enough to matter.
struct Near<'a> {
    number: usize,
    solid: Solid<'a>,
    /// The particle in the frame of the solid, at its surface if it was inside.
    local: vec3<f32>,
    surface: Surface,
    /// Inverse of the particle's support radius, 1/m.
    inverse: f32,
}

/// Returns the solids in closed form that are nearer than the support radius.
fn near<'a>(setup: &Setup<'a>, front: Front<f32>) -> impl Iterator<Item = Near<'a>> {
    let inverse = div(1.0, front.support) * setup.parameters.inverse_support;
    let all = solids(setup.model, setup.parameters, setup.poses).enumerate();
    all.filter(|(_, solid)| solid.is_closed()).filter_map(move |(number, solid)| {
        let local = solid.local_of(front.position);
        let Surface { distance, normal } = solid.surface(local);
        if !less(distance * inverse, 1.0) {
            return None;
        }
        let is_inside = less(distance, 0.0);
        let local = if is_inside { local + normal * -distance } else { local };
        let surface = Surface { distance: if is_inside { 0.0 } else { distance }, normal };
        Some(Near { number, solid, local, surface, inverse })
    })
}

impl Near<'_> {
    /// Returns the parts of the kernel between the pairs of sides of a box.
    fn between(&self, setup: &Setup<'_>, gamma: u32) -> [f32; 3] {
        let (size, at) = (self.solid.size(), self.local);
        let part = |half: f32, at: f32| part_between(setup.tables, gamma, half * self.inverse, at * self.inverse);
        let along_z = if setup.model.is_3d == 1 { part(size.z, at.z) } else { 1.0 };
        [part(size.x, at.x), part(size.y, at.y), along_z]
    }

    /// Returns half of the curvature over the inverse of the support radius.
    fn bend(&self) -> f32 {
        div(self.solid.curvature(self.local) * 0.5, self.inverse)
    }

    /// Returns how far a particle lies within the round side of a cylinder, over its support radius, and half of the
    /// curvature of that side.
    fn round_side(&self) -> [f32; 2] {
        let size = self.solid.size();
        let beyond = beyond_cylinder(size, self.local);
        [-beyond.x * self.inverse, div(0.5, size.x * self.inverse)]
    }

    /// Returns the parts of the kernel between the ends of a cylinder, and within its side.
    fn in_cylinder(&self, setup: &Setup<'_>, [gamma, _, bending]: [u32; 3]) -> [f32; 2] {
        let [within, bend] = self.round_side();
        let ends = part_between(setup.tables, gamma, self.solid.size().y * self.inverse, self.local.y * self.inverse);
        [ends, part_within(setup.tables, gamma, bending, within, bend)]
    }

    /// Returns the part of the kernel in front of the solid.
    fn part_in_front(&self, setup: &Setup<'_>, tables: [u32; 3]) -> f32 {
        let [gamma, _, bending] = tables;
        if self.solid.kind() == BOX || self.solid.kind() == CYLINDER {
            let inside = if self.solid.kind() == BOX {
                let [x, y, z] = self.between(setup, gamma);
                x * y * z
            } else {
                let [ends, within] = self.in_cylinder(setup, tables);
                ends * within
            };
            return if self.solid.side() < 0.0 { inside } else { 1.0 - inside };
        }
        part_in_front_of_curved(setup.tables, gamma, bending, self.surface.distance * self.inverse, self.bend())
    }

    /// Adds what the solid contributes; `others` is the part of the kernel in front of all others.
    fn added(
        &self,
        setup: &Setup<'_>,
        front: Front<f32>,
        tables: [u32; 3],
        sum: Beyond<f32>,
        others: f32,
    ) -> Beyond<f32> {
        let velocity = self.solid.velocity_at(self.local);
        let face = |normal: vec3<f32>, height: f32| Face {
            normal: self.solid.turned(normal),
            height,
            ratio: height * self.inverse,
            velocity,
            viscosity: self.solid.viscosity(),
        };
        if self.solid.kind() == CYLINDER {
            return self.cylinder(setup, front, tables, sum, others, &face);
        }
        if self.solid.kind() != BOX {
            let face = face(self.surface.normal, self.surface.distance);
            return with_face(setup, front, tables, sum, face, others * curved_share(face.ratio, self.bend()));
        }
        let ([x, y, z], side, size) = (self.between(setup, tables[0]), self.solid.side(), self.solid.size());
        let axes = [
            (vec3(side, 0.0, 0.0), self.local.x, size.x, y * z),
            (vec3(0.0, side, 0.0), self.local.y, size.y, x * z),
            (vec3(0.0, 0.0, side), self.local.z, size.z, x * y),
        ];
        let mut sum = sum;
        for (normal, at, half, share) in axes.into_iter().take(2 + setup.model.is_3d as usize) {
            for (normal, height) in [(normal, (at - half) * side), (normal * -1.0, (-at - half) * side)] {
                sum = with_face(setup, front, tables, sum, face(normal, height), others * share);
            }
        }
        sum
    }
}

impl Near<'_> {
    /// Adds the ends and the side of a cylinder.
    fn cylinder(
        &self,
        setup: &Setup<'_>,
        front: Front<f32>,
        tables: [u32; 3],
        sum: Beyond<f32>,
        others: f32,
        face: &dyn Fn(vec3<f32>, f32) -> Face,
    ) -> Beyond<f32> {
        let ([ends, within], side, size) = (self.in_cylinder(setup, tables), self.solid.side(), self.solid.size());
        let [inward, bend] = self.round_side();
        let up = vec3(0.0, side, 0.0);
        let mut sum = sum;
        for (normal, height) in [(up, (self.local.y - size.y) * side), (up * -1.0, (-self.local.y - size.y) * side)] {
            sum = with_face(setup, front, tables, sum, face(normal, height), others * within);
        }
        let normal = direction_or(vec3(self.local.x, 0.0, self.local.z), vec3(1.0, 0.0, 0.0)) * side;
        let height = beyond_cylinder(size, self.local).x * side;
        with_face(setup, front, tables, sum, face(normal, height), others * ends * curved_share(-inward, bend))
    }
}

/// Returns the part of a kernel in front of all walls; `in_front` is the part in front of the planes.
pub(super) fn part_in_front(setup: &Setup<'_>, front: Front<f32>, tables: [u32; 3], in_front: f32) -> f32 {
    near(setup, front).fold(in_front, |all, near| all * near.part_in_front(setup, tables))
}

/// Returns for each solid near a particle its index and the part of the kernel in it.
pub(super) fn parts<'a>(
    setup: &'a Setup<'_>,
    front: Front<f32>,
    tables: [u32; 3],
) -> impl Iterator<Item = (usize, f32)> + 'a {
    near(setup, front).map(move |near| (near.number, 1.0 - near.part_in_front(setup, tables)))
}

/// Returns what one solid contributes, the part of the kernel in it, and the vector from the particle to its surface;
/// `None` if it is far away.
pub(super) fn of_solid(
    setup: &Setup<'_>,
    front: Front<f32>,
    tables: [u32; 3],
    in_front: f32,
    number: usize,
) -> Option<(Beyond<f32>, f32, vec3<f32>)> {
    let near = near(setup, front).find(|near| near.number == number)?;
    let part = near.part_in_front(setup, tables);
    let foot = near.solid.turned(near.surface.normal) * -near.surface.distance;
    Some((near.added(setup, front, tables, NOTHING, div(in_front, part)), 1.0 - part, foot))
}

/// Adds what the solids contribute.
pub(super) fn with_solids(
    setup: &Setup<'_>,
    front: Front<f32>,
    tables: [u32; 3],
    sum: Beyond<f32>,
    in_front: f32,
) -> Beyond<f32> {
    near(setup, front).fold(sum, |sum, near| {
        let others = div(in_front, near.part_in_front(setup, tables));
        near.added(setup, front, tables, sum, others)
    })
}
