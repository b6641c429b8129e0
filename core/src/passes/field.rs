//! The acceleration field supplied by the caller: linear interpolation between the nodes of a lattice around a
//! position. Outside the lattice there are no nodes, and the field falls to zero within one spacing.
use super::context::Setup;
use crate::arithmetic::real::{Real, floor, larger, real, smaller, vec3};
use crate::terms::external::{field_place, field_share};

/// Returns the field at the positions of particles, m/s2.
#[inline(always)]
pub(crate) fn at<R: Real>(setup: &Setup<'_>, position: vec3<R>) -> vec3<R> {
    let (m, p) = (setup.model, setup.parameters);
    let place = field_place(p, position);
    // clamping does not change the result, since no position outside the lattice has nodes; it keeps the indices small
    let least = |x: R, points: u32| smaller(larger(floor(x), real(-2.0)), real(points as f32));
    let [nx, ny, nz, _] = p.field_counts;
    let first = vec3(least(place.x, nx), least(place.y, ny), least(place.z, if m.is_3d == 1 { nz } else { 0 }));
    let mut sum = vec3(real::<R>(0.0), real(0.0), real(0.0));
    for i in 0..4 << m.is_3d {
        let corner = [i & 1, i >> 1 & 1, i >> 2].map(|c: u32| c as f32);
        let node = vec3(first.x + corner[0], first.y + corner[1], first.z + corner[2]);
        let value = |axis: usize| {
            R::from_lanes(|lane| {
                let z = if m.is_3d == 1 { node.z.lane(lane) as i32 } else { 0 };
                let [x, y] = [node.x.lane(lane) as i32, node.y.lane(lane) as i32];
                let within = |c: i32, n: u32| (0..n as i32).contains(&c);
                if !(within(x, nx) && within(y, ny) && within(z, nz)) {
                    return 0.0;
                }
                let index = x as usize + nx as usize * (y as usize + ny as usize * z as usize);
                setup.field.get(index).map_or(0.0, |node| node[axis])
            })
        };
        sum = sum + vec3(value(0), value(1), value(2)) * field_share(m, place, node);
    }
    sum
}
