//! Solids as the passes see them: their constants and poses, and the point of their surface that is nearest to a
//! particle.
pub(crate) mod motion;

use crate::arithmetic::real::{larger, less, root, vec3};
use crate::layout::{Model, POSE_STRIDE, Parameters, SOLID_STRIDE, f32x4};
use crate::scene::SolidModel;
use crate::terms::geometry::length2;
use crate::terms::motion::{rotated, rotated_back, velocity_at};
use crate::terms::pair::separation;
use crate::terms::shape::{
    FACET, POLYGON, direction_or, facet_crossing, from_side, is_over_facet, repulsion, shape_curvature, shape_distance,
    shape_normal, winding,
};

/// A solid at one time.
#[derive(Clone, Copy)]
pub(crate) struct Solid<'a> {
    m: &'a Model,
    p: &'a Parameters,
    rows: &'a [f32x4],
    pose: &'a [f32x4],
    /// The sides of its polygon: two rows each.
    sides: &'a [f32x4],
}

/// What a solid looks like from a point.
#[derive(Clone, Copy)]
pub(crate) struct Surface {
    /// Distance from the surface, m; negative inside of the solid.
    pub distance: f32,
    /// Normal at the nearest point of the surface, which leads away from the solid.
    pub normal: vec3<f32>,
}

/// Returns the solids of a scene, with these poses.
pub(crate) fn solids<'a>(
    m: &'a Model,
    p: &'a Parameters,
    poses: &'a [f32x4],
) -> impl Iterator<Item = Solid<'a>> + Clone {
    let rows = p.solids.chunks_exact(SOLID_STRIDE).take(p.solid_counts[0] as usize);
    rows.zip(poses.chunks_exact(POSE_STRIDE)).map(move |(rows, pose)| {
        let [first, count, ..] = rows[8];
        let sides = poses.get(first as usize..first as usize + 2 * count as usize).unwrap_or_default();
        Solid { m, p, rows, pose, sides }
    })
}

/// Returns whether a position lies in a solid.
pub(crate) fn is_in_solid(m: &Model, p: &Parameters, poses: &[f32x4], position: vec3<f32>) -> bool {
    solids(m, p, poses).any(|solid| less(solid.distance(solid.local_of(position)), 0.0))
}

impl Solid<'_> {
    /// Returns whether the fluid feels it in closed form.
    pub(crate) fn is_closed(&self) -> bool {
        self.rows[0][2] == SolidModel::ClosedForm as u32 as f32
    }

    /// Returns the kind of its shape.
    pub(crate) fn kind(&self) -> u32 {
        self.rows[0][0] as u32
    }

    /// Returns 1 if the fluid is outside, and -1 if it is inside.
    pub(crate) fn side(&self) -> f32 {
        self.rows[0][1]
    }

    pub(crate) fn size(&self) -> vec3<f32> {
        vec3::splat(self.rows[1])
    }

    /// Returns the share of the normal velocity that it gives back, and the share of the tangential velocity.
    pub(crate) fn bounce_and_slip(&self) -> [f32; 2] {
        [self.rows[2][0], self.rows[2][1]]
    }

    /// Returns its dynamic viscosity, Pa s; negative for that of the particle.
    pub(crate) fn viscosity(&self) -> f32 {
        self.rows[2][2]
    }

    /// Returns a position in the frame of the solid.
    pub(crate) fn local_of(&self, position: vec3<f32>) -> vec3<f32> {
        self.turned_back(self.away(position))
    }

    /// Returns the vector from the origin of the solid.
    pub(crate) fn away(&self, position: vec3<f32>) -> vec3<f32> {
        separation(self.m, self.p, position, vec3::splat(self.pose[0]))
    }

    /// Returns in the frame of the solid, as it was, the image of `start` that is nearest to `end`, to which `away`
    /// leads from where the solid is now.
    pub(crate) fn local_near(&self, away: vec3<f32>, start: vec3<f32>, end: vec3<f32>, now: &Solid<'_>) -> vec3<f32> {
        let moved = separation(self.m, self.p, vec3::splat(now.pose[0]), vec3::splat(self.pose[0]));
        self.turned_back(away + separation(self.m, self.p, start, end) + moved)
    }

    fn turned_back(&self, vector: vec3<f32>) -> vec3<f32> {
        rotated_back(vec3::splat(self.pose[1]), self.pose[1][3], vector)
    }

    /// Returns a vector in the frame of the scene.
    pub(crate) fn turned(&self, vector: vec3<f32>) -> vec3<f32> {
        rotated(vec3::splat(self.pose[1]), self.pose[1][3], vector)
    }

    /// Returns a position in the frame of the scene.
    pub(crate) fn point(&self, local: vec3<f32>) -> vec3<f32> {
        vec3::splat(self.pose[0]) + self.turned(local)
    }

    /// Returns the velocity of the solid at a point of its frame, m/s.
    pub(crate) fn velocity_at(&self, local: vec3<f32>) -> vec3<f32> {
        velocity_at(vec3::splat(self.pose[2]), vec3::splat(self.pose[3]), self.turned(local))
    }

    /// Returns the distance of a point of its frame from the surface, m; negative inside of the solid. Nothing is inside
    /// of a facet.
    pub(crate) fn distance(&self, local: vec3<f32>) -> f32 {
        if self.kind() == FACET {
            return f32::MAX;
        }
        if self.kind() == POLYGON {
            return self.polygon(local).distance;
        }
        shape_distance(self.m, self.kind(), self.size(), local) * self.side()
    }

    /// Returns what it looks like from a point of its frame.
    pub(crate) fn surface(&self, local: vec3<f32>) -> Surface {
        if self.kind() == POLYGON {
            return self.polygon(local);
        }
        let normal = shape_normal(self.m, self.kind(), self.size(), local) * self.side();
        Surface { distance: self.distance(local), normal }
    }

    /// Returns the acceleration with which it repels a particle, m/s2.
    pub(crate) fn repulsion(&self, position: vec3<f32>) -> vec3<f32> {
        let local = self.local_of(position);
        let strength = self.rows[2][3];
        if self.kind() == FACET {
            let over = is_over_facet(self.m, self.size(), local);
            let above = if less(local.y, 0.0) { 0.0 } else { over };
            return self.turned(vec3(0.0, repulsion(self.p, strength, local.y) * above, 0.0));
        }
        let Surface { distance, normal } = self.surface(local);
        self.turned(normal * repulsion(self.p, strength, distance))
    }

    /// Returns whether it repels.
    pub(crate) fn repels(&self) -> bool {
        self.rows[0][2] == SolidModel::Repulsion as u32 as f32
    }

    /// Returns the sum of the principal curvatures of the surface, 1/m; negative where it surrounds the fluid.
    pub(crate) fn curvature(&self, local: vec3<f32>) -> f32 {
        shape_curvature(self.p, self.kind(), self.size(), local) * self.side()
    }

    /// Returns where the path from `start` along `way` comes through a facet from above: the share of the path, more than
    /// 1 if it does not.
    pub(crate) fn crossing(&self, touch: f32, start: vec3<f32>, way: vec3<f32>) -> f32 {
        facet_crossing(self.m, self.size(), touch, start, way)
    }

    /// Returns a distance from a facet that is exact beside its ends and, where it is a trapezoid, at most the true one.
    pub(crate) fn distance_from_facet(&self, local: vec3<f32>) -> f32 {
        let vec3 { x: near, y: far, z: length } = self.size();
        let share = (local.z / length).clamp(-1.0, 1.0) * 0.5 + 0.5;
        let (slope, half) =
            if self.m.is_3d == 1 { (0.5 * (far - near) / length, near + (far - near) * share) } else { (0.0, near) };
        let lean = root(1.0 + slope * slope);
        let beside = larger(local.x.abs() - half, 0.0) / lean;
        let beyond = if self.m.is_3d == 1 { larger(local.z.abs() - length, 0.0) } else { 0.0 };
        root(length2(vec3(beside, local.y, beyond)))
    }

    fn polygon(&self, local: vec3<f32>) -> Surface {
        let mut nearest = vec3(f32::MAX, 0.0, 0.0);
        let mut least = f32::MAX;
        let mut along = vec3(1.0, 0.0, 0.0);
        let mut turns = 0.0;
        for side in self.sides.chunks_exact(2) {
            let (from, side) = (vec3::splat(side[0]), vec3::splat(side[1]));
            let away = from_side(from, side, local);
            turns += winding(from, side, local);
            if length2(away) < least {
                (nearest, least, along) = (away, length2(away), side);
            }
        }
        // 1 outside of the polygon, -1 inside
        let outside = if turns == 0.0 { 1.0 } else { -1.0 };
        let distance = root(length2(nearest)) * outside;
        let normal = direction_or(nearest * outside, direction_or(vec3(along.y, -along.x, 0.0), nearest));
        Surface { distance: distance * self.side(), normal: normal * self.side() }
    }
}
