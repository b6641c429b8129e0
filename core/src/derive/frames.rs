//! The solids of a scene where they are at its start, for distances from them.
use super::material::FIRST_SOLID;
use super::solids::{MOST_POSE_ROWS, fill_poses, pose_rows, rows};
use crate::arithmetic::real::vec3;
use crate::layout::{Model, Parameters, f32x4};
use crate::scene::{Dimension, InitialParticle, Scene};
use crate::solids::{Solid, solids};
use bytemuck::Zeroable;
use glam::Vec3;
use heapless::Vec;

/// The poses of the solids of a scene at its start, and the sides of its polygons.
pub(crate) type Poses = Vec<f32x4, MOST_POSE_ROWS>;

/// Returns the poses of a scene at its start. A scene with too many sides of polygons, which is rejected, has only
/// some of them.
pub(crate) fn poses_at_start(scene: &Scene, p: &Parameters) -> Poses {
    let mut poses = Poses::new();
    let _ = poses.resize(pose_rows(scene).min(MOST_POSE_ROWS), [0.0; 4]);
    fill_poses(scene, &model(scene), p, &mut poses);
    poses
}

/// Returns the part of the model that distances depend on.
fn model(scene: &Scene) -> Model {
    Model { is_3d: u32::from(scene.dimension == Dimension::Three), ..Model::zeroed() }
}

/// Room for the solids of a scene whose constants have not been derived yet.
pub(crate) struct Own {
    p: Parameters,
    poses: Poses,
}

impl Own {
    pub(crate) fn of(scene: &Scene) -> Own {
        let solid_counts = [scene.solids.len() as u32, 0, 0, 0];
        let p = Parameters { solids: rows(scene), solid_counts, ..Parameters::zeroed() };
        Own { poses: poses_at_start(scene, &p), p }
    }

    pub(crate) fn frames(&self, scene: &Scene) -> Frames<'_> {
        Frames::of(scene, &self.p, &self.poses)
    }
}

/// The solids of a scene at its start.
#[derive(Clone, Copy)]
pub(crate) struct Frames<'a> {
    is_3d: u32,
    p: &'a Parameters,
    poses: &'a [f32x4],
}

impl<'a> Frames<'a> {
    pub(crate) fn of(scene: &Scene, p: &'a Parameters, poses: &'a [f32x4]) -> Frames<'a> {
        Frames { is_3d: model(scene).is_3d, p, poses }
    }

    /// The model is made here, since iterators hold this struct, and each of their copies would have one.
    fn model(&self) -> Model {
        Model { is_3d: self.is_3d, ..Model::zeroed() }
    }

    /// Returns the distance from a solid of a place in its frame, m.
    pub(crate) fn distance(&self, number: usize, local: Vec3) -> f32 {
        let m = self.model();
        let solid = solids(&m, self.p, self.poses).nth(number);
        solid.map_or(f32::MAX, |solid| solid.distance(vec3(local.x, local.y, local.z)))
    }

    /// Returns the distance from a solid of a place in the frame of the scene, m.
    pub(crate) fn distance_of(&self, number: usize, place: Vec3) -> f32 {
        let m = self.model();
        let solid = solids(&m, self.p, self.poses).nth(number);
        solid.map_or(f32::MAX, |solid| solid.distance(solid.local_of(vec3(place.x, place.y, place.z))))
    }

    /// Returns the distance from the nearest solid, m.
    pub(crate) fn nearest(&self, place: Vec3) -> f32 {
        let distance = |solid: Solid<'_>| solid.distance(solid.local_of(vec3(place.x, place.y, place.z)));
        solids(&self.model(), self.p, self.poses).map(distance).fold(f32::MAX, f32::min)
    }

    /// Returns a particle of a solid.
    pub(crate) fn particle(&self, number: usize, local: Vec3) -> Option<InitialParticle> {
        let m = self.model();
        let solid = solids(&m, self.p, self.poses).nth(number)?;
        let local = vec3(local.x, local.y, local.z);
        let (x, v) = (solid.point(local), solid.velocity_at(local));
        Some(InitialParticle::of_fluid(FIRST_SOLID + number as u32, [x.x, x.y, x.z], [v.x, v.y, v.z]))
    }
}
