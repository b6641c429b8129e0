//! Solids for the host program: where they are, and how it moves those that it drives. Nothing here is part of a step.
use crate::arithmetic::real::{flush, vec3};
use crate::error::SolidError;
use crate::layout::{DRIVEN, Model, POSE_STRIDE, Parameters, SOLID_STRIDE, f32x4};
use crate::solids::solids;
use crate::solver::Solver;
use crate::terms::geometry::flush3;
use crate::terms::integrate::wrap;
use crate::terms::shape::FACET;
use glam::{Quat, Vec3};

/// Where a solid is, and how fast it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidState {
    /// Position of its origin, m.
    pub position: Vec3,
    /// Rotation, a unit quaternion.
    pub rotation: Quat,
    /// Velocity of its origin, m/s.
    pub velocity: Vec3,
    /// Angular velocity, 1/s.
    pub angular_velocity: Vec3,
}

impl SolidState {
    /// Returns the state in these rows.
    #[must_use]
    pub fn of_rows([position, rotation, velocity, spin]: [f32x4; POSE_STRIDE]) -> SolidState {
        let vector = |[x, y, z, _]: f32x4| Vec3::new(x, y, z);
        SolidState {
            position: vector(position),
            rotation: Quat::from_array(rotation),
            velocity: vector(velocity),
            angular_velocity: vector(spin),
        }
    }

    /// Returns the rows of this state, which is the new one of the solid with this index.
    ///
    /// # Errors
    /// A [`SolidError`] if the host does not drive the solid, or if a value is not valid.
    pub fn to_rows(self, m: &Model, p: &Parameters, solid: usize) -> Result<[f32x4; POSE_STRIDE], SolidError> {
        let rows = p.solids.chunks_exact(SOLID_STRIDE).take(p.solid_counts[0] as usize).nth(solid);
        let rows = rows.ok_or(SolidError::NoSuchSolid { solid, solids: p.solid_counts[0] as usize })?;
        if rows[0][3] != DRIVEN {
            return Err(SolidError::NotDriven { solid });
        }
        let vectors = [self.position, self.velocity, self.angular_velocity];
        let numbers = vectors.into_iter().flat_map(|v| v.to_array()).chain(self.rotation.to_array());
        if !numbers.into_iter().all(f32::is_finite) {
            return Err(SolidError::NotFinite);
        }
        if (self.rotation.length() - 1.0).abs() > 1e-3 {
            return Err(SolidError::NotARotation { length: self.rotation.length() });
        }
        let q = self.rotation.normalize();
        let off_plane = [self.position.z, self.velocity.z, self.angular_velocity.x, self.angular_velocity.y, q.x, q.y];
        if m.is_3d == 0 && off_plane.into_iter().any(|x| x != 0.0) {
            return Err(SolidError::OutOfPlane);
        }
        let flushed = |v: Vec3| flush3::<f32>(vec3(v.x, v.y, v.z));
        let row = |v: vec3<f32>| [v.x, v.y, v.z, 0.0];
        let place = wrap(m, p, flushed(self.position));
        let turn = flushed(q.xyz());
        let turn = [turn.x, turn.y, turn.z, flush(q.w)];
        Ok([row(place), turn, row(flushed(self.velocity)), row(flushed(self.angular_velocity))])
    }
}

impl Solver<'_> {
    /// Where the solid with this index is; `None` if there is none.
    #[must_use]
    pub fn solid(&self, solid: usize) -> Option<SolidState> {
        if solid >= self.parameters().solid_counts[0] as usize {
            return None;
        }
        let rows = self.state().pose.chunks_exact(POSE_STRIDE).nth(solid)?;
        rows.try_into().ok().map(SolidState::of_rows)
    }

    /// Distance of a position from the surface of a solid, m; negative inside of the solid, and `None` if there is no
    /// solid with this index.
    #[must_use]
    pub fn distance_from_solid(&self, solid: usize, position: impl Into<Vec3>) -> Option<f32> {
        distance_from(&self.plan().model, self.parameters(), self.state().pose, solid, position.into())
    }

    /// Sets where a solid is and how fast it moves, from the next step on. It then goes on with these velocities. The
    /// motion of the solid must be [`Motion::Driven`](crate::scene::Motion::Driven). A particle that a solid is set
    /// upon is put to the surface that is nearest, so move it by velocities rather than by jumps.
    ///
    /// # Errors
    /// A [`SolidError`] if the host does not drive the solid, or if a value is not valid. The fluid stays as it was.
    pub fn move_solid(&mut self, solid: usize, to: SolidState) -> Result<(), SolidError> {
        let rows = to.to_rows(&self.plan().model, self.parameters(), solid)?;
        if let Some(pose) = self.state_mut().pose.chunks_exact_mut(POSE_STRIDE).nth(solid) {
            pose.copy_from_slice(&rows);
        }
        Ok(())
    }
}

/// Returns the distance of a position from the surface of a solid with these poses, m; `None` if there is no such
/// solid.
#[must_use]
pub fn distance_from(m: &Model, p: &Parameters, poses: &[f32x4], solid: usize, position: Vec3) -> Option<f32> {
    let solid = solids(m, p, poses).nth(solid)?;
    let local = solid.local_of(vec3(position.x, position.y, position.z));
    Some(if solid.kind() == FACET { solid.distance_from_facet(local) } else { solid.distance(local) })
}
