//! Puts particles that came into a solid back to its surface, and reflects their velocities. Runs only with solids.
//!
//! A particle is followed from where it was at the start of the step, in the frame of the solid, to where it is now:
//! the first point of this path inside of the solid counts, so nothing passes through a thin wall however fast it is.
//! From each point the search goes on by the distance to the surface, since nothing is nearer (sphere tracing, Hart
//! 1996), and most particles need no search. In a corner a particle is put back up to three times.
use crate::arithmetic::real::{larger, less, root, vec3};
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::{LEAST_STEP, MOST_TRACED, ROUNDS, f32x4};
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::is_wall;
use crate::solids::{Solid, Surface, solids};
use crate::terms::boundary::{depth_behind, put_back, reflected, share_behind, share_of_way};
use crate::terms::geometry::{dot3, flush3, length2};
use crate::terms::integrate::{has_history, history_reversed, wrap};
use crate::terms::shape::{FACET, direction_or};

/// Where a path comes to a solid, in the frame of the solid.
struct Hit {
    foot: vec3<f32>,
    normal: vec3<f32>,
}

/// Returns where the path from `from` to `to` comes to the solid; `None` if it does not.
fn first_hit(solid: &Solid<'_>, touch: f32, from: vec3<f32>, to: vec3<f32>) -> Option<Hit> {
    let way = to - from;
    if solid.kind() == FACET {
        let share = solid.crossing(touch, from, way);
        let above = vec3(0.0, 1.0, 0.0);
        return less(share, 1.5).then(|| Hit { foot: from + way * share, normal: above });
    }
    let length = root(length2(way));
    let (before, after) = (solid.distance(from), solid.distance(to));
    if less(length, before + after) {
        return None;
    }
    if less(before, -touch) {
        // it was inside already
        return nearest(solid, to);
    }
    let mut traced = 0.0;
    let mut at = from;
    for _ in 0..MOST_TRACED {
        at = from + way * share_of_way(traced, length);
        let Surface { distance, normal } = solid.surface(at);
        if less(distance, touch) && less(dot3(normal, way), 0.0) {
            return Some(Hit { foot: at, normal });
        }
        traced += larger(distance, larger(touch, length * LEAST_STEP));
        if less(length, traced) {
            return nearest(solid, to);
        }
    }
    // it stops where the search has come to
    Some(Hit { foot: at, normal: direction_or(way, way) * -1.0 })
}

/// Returns the point of the surface that is nearest to a point inside of the solid; `None` for a point outside.
fn nearest(solid: &Solid<'_>, to: vec3<f32>) -> Option<Hit> {
    let Surface { distance, normal } = solid.surface(to);
    less(distance, 0.0).then_some(Hit { foot: to + normal * -distance, normal })
}

/// A particle that is followed.
#[derive(Clone, Copy)]
struct Path {
    start: vec3<f32>,
    position: vec3<f32>,
    velocity: vec3<f32>,
    is_moved: bool,
}

/// Puts a particle back to the surface of a solid, if it came into it.
fn touched(setup: &Setup<'_>, path: Path, [before, now]: [Solid<'_>; 2]) -> Path {
    let touch = setup.parameters.touch;
    let to = now.local_of(path.position);
    let from = if setup.model.is_periodic == 0 {
        before.local_of(path.start)
    } else {
        // the image of the start that is nearest to the end
        before.local_near(now.away(path.position), path.start, path.position, &now)
    };
    let Some(Hit { foot, normal }) = first_hit(&now, touch, from, to) else { return path };
    let depth = dot3(foot - to, normal);
    if !less(0.0, depth) {
        return path;
    }
    let position = flush3(now.point(to + normal * depth));
    let (normal, wall) = (now.turned(normal), now.velocity_at(foot));
    let [bounce, slip] = now.bounce_and_slip();
    let relative = path.velocity - wall;
    let share = share_behind::<f32>(setup.uniform, relative, depth) * bounce;
    let velocity = flush3(wall + reflected(relative, normal, share, slip));
    Path { position: wrap(setup.model, setup.parameters, position), velocity, is_moved: true, ..path }
}

/// Returns a particle in front of all solids and of the planes of the container.
fn in_front(setup: &Setup<'_>, old: &[f32x4], path: Path) -> Path {
    let (m, p) = (setup.model, setup.parameters);
    let pairs = || solids(m, p, old).zip(solids(m, p, setup.poses));
    let mut path = path;
    let mut hit = false;
    for _ in 0..ROUNDS {
        path.is_moved = false;
        for (before, now) in pairs() {
            path = touched(setup, path, [before, now]);
        }
        if !path.is_moved {
            break;
        }
        hit = true;
        if m.has_container == 1 {
            for plane in &p.planes[..p.plane_count as usize] {
                let normal = vec3::splat(*plane);
                path.position = put_back(path.position, normal, depth_behind(path.position, normal, plane[3]));
            }
        }
    }
    if hit {
        for (before, now) in pairs() {
            let local = now.local_of(path.position);
            if less(now.distance(local), -p.touch) {
                // it is wedged in, and is carried along from where it was
                let at = before.local_of(path.start);
                path.position = wrap(m, p, flush3(now.point(at)));
                path.velocity = flush3(now.velocity_at(at));
            }
        }
    }
    path.is_moved = hit;
    path
}

/// Corrects positions, velocities and the history of the integrator, and counts the particles that came into a solid.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, old, new) = (step.setup, &*step.old.pose, &mut *step.new);
    let start = &*step.scratch.start_position;
    let (mut positions, mut velocities, mut histories) = (&mut *new.position, &mut *new.velocity, &mut *new.history);
    let has_histories = !histories.is_empty();
    let mut jobs = Jobs::new();
    for slots in shares(new.id.len(), parts(step.executor)) {
        let histories = take(&mut histories, if has_histories { slots.len() } else { 0 });
        let own = (take(&mut positions, slots.len()), take(&mut velocities, slots.len()), histories);
        let _ = jobs.push((slots.start, own, 0u32));
    }
    let acceleration = &*new.acceleration;
    step.executor.run(&mut jobs, |(first, (positions, velocities, histories), hits)| {
        for (i, (position, velocity)) in positions.iter_mut().zip(velocities.iter_mut()).enumerate() {
            let slot = *first + i;
            if is_wall(setup.materials, velocity[3]) && setup.model.has_materials == 1 {
                continue;
            }
            let [x, v] = [vec3::splat(*position), vec3::splat(*velocity)];
            let path = Path { start: vec3::splat(start[slot]), position: x, velocity: v, is_moved: false };
            let path = in_front(&setup, old, path);
            if !path.is_moved {
                continue;
            }
            *hits += 1;
            let [x, v] = [path.position, path.velocity];
            position[..3].copy_from_slice(&[x.x, x.y, x.z]);
            velocity[..3].copy_from_slice(&[v.x, v.y, v.z]);
            if has_history(setup.model)
                && let Some(history) = histories.get_mut(i)
            {
                let (m, u, a) = (setup.model, setup.uniform, vec3::splat(acceleration[slot]));
                let vec3 { x, y, z } = history_reversed(m, u, v, a, vec3::splat(*history));
                *history = [x, y, z, 0.0];
            }
        }
    });
    step.found.flux.hits = jobs.iter().map(|(.., hits)| u64::from(*hits)).sum();
}
