//! Number of operations per pair, counted by running the scene's terms with a number type that counts operations.
use millpond_core::backend::arithmetic::real::{Real, real, root, vec3};
use millpond_core::backend::layout::{Model, Parameters, TABLE_WORDS};
use millpond_core::backend::terms::density::{
    continuity_neighbour, continuity_slope, density_neighbour, is_stepped, number_density_neighbour,
};
use millpond_core::backend::terms::geometry::dot3;
use millpond_core::backend::terms::near::{DOUBLE_DENSITY, near_density_neighbour};
use millpond_core::backend::terms::neighbour::force_neighbour;
use millpond_core::backend::terms::pair::{Local, pair_scale, separation, squared_ratio};
use millpond_core::backend::terms::wall::mass_seen;
use std::cell::Cell;
use std::ops::{Add, Mul, Neg, Sub};

thread_local! {
    /// Operations counted so far on this thread.
    static COUNTED: Cell<u64> = const { Cell::new(0) };
}

/// A number that counts operations. Each addition, subtraction, multiplication, division, square root, absolute value,
/// floor, negation, comparison, selection, minimum and maximum counts as one.
#[derive(Clone, Copy)]
struct Counted(f32);

/// Counts an operation and returns its result.
fn one_more(x: f32) -> Counted {
    COUNTED.set(COUNTED.get() + 1);
    Counted(x)
}

impl Add for Counted {
    type Output = Self;
    fn add(self, y: Self) -> Self {
        one_more(self.0 + y.0)
    }
}
impl Sub for Counted {
    type Output = Self;
    fn sub(self, y: Self) -> Self {
        one_more(self.0 - y.0)
    }
}
impl Mul for Counted {
    type Output = Self;
    fn mul(self, y: Self) -> Self {
        one_more(self.0 * y.0)
    }
}
impl Add<f32> for Counted {
    type Output = Self;
    fn add(self, y: f32) -> Self {
        one_more(self.0 + y)
    }
}
impl Sub<f32> for Counted {
    type Output = Self;
    fn sub(self, y: f32) -> Self {
        one_more(self.0 - y)
    }
}
impl Mul<f32> for Counted {
    type Output = Self;
    fn mul(self, y: f32) -> Self {
        one_more(self.0 * y)
    }
}
impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        one_more(-self.0)
    }
}

impl Real for Counted {
    type Mask = bool;
    const LANES: usize = 1;
    fn splat(x: f32) -> Self {
        Counted(x)
    }
    fn from_lanes(mut f: impl FnMut(usize) -> f32) -> Self {
        Counted(f(0))
    }
    fn lane(self, _: usize) -> f32 {
        self.0
    }
    fn any(mask: bool) -> bool {
        mask
    }
    fn div(self, y: Self) -> Self {
        one_more(self.0 / y.0)
    }
    fn root(self) -> Self {
        one_more(self.0.sqrt())
    }
    fn abs(self) -> Self {
        one_more(self.0.abs())
    }
    fn floor(self) -> Self {
        one_more(self.0.floor())
    }
    fn less(self, y: Self) -> bool {
        one_more(0.0);
        self.0 < y.0
    }
    fn select(no: Self, yes: Self, mask: bool) -> Self {
        one_more(if mask { yes.0 } else { no.0 })
    }
    fn larger(self, y: Self) -> Self {
        one_more(if self.0 < y.0 { y.0 } else { self.0 })
    }
    fn smaller(self, y: Self) -> Self {
        one_more(if y.0 < self.0 { y.0 } else { self.0 })
    }
}

/// Returns the number of operations of `work`.
fn counted<T>(work: impl FnOnce() -> T) -> u64 {
    let before = COUNTED.get();
    let _ = work();
    COUNTED.get() - before
}

/// Returns two particles at some distance. The cost of a pair depends on the model only, not on the values.
fn pair(p: &Parameters) -> [Local<Counted>; 2] {
    [0.0, 0.4].map(|x| {
        let one = || Counted(1.0);
        Local {
            position: vec3(Counted(x * p.support), Counted(0.0), Counted(0.0)),
            velocity: vec3(Counted(x), Counted(0.0), Counted(0.0)),
            support: one(),
            mass: one(),
            deviation: Counted(0.0),
            pressure: one(),
            near_pressure: one(),
            volume: one(),
            viscosity: one(),
            wall: Counted(0.0),
            rest_ratio: one(),
            fluid: Counted(0.0),
            speed_of_sound: one(),
            state_equation: Counted(0.0),
            tension: one(),
        }
    })
}

/// Operations to test whether two particles are within each other's support.
pub(super) fn of_test(m: &Model, p: &Parameters) -> u64 {
    let [a, b] = pair(p);
    counted(|| squared_distance(m, p, a, b).less(Counted(1.0)))
}

/// Returns the squared distance divided by the squared support radius of the pair.
fn squared_distance(m: &Model, p: &Parameters, a: Local<Counted>, b: Local<Counted>) -> Counted {
    squared_ratio(m, p, separation(m, p, a.position, b.position), pair_scale(m, a.support, b.support))
}

/// Operations to add a neighbour to the density of a particle. If density depends on the distance only, the squared
/// distance is known from the test and is not counted again.
pub(super) fn of_density(m: &Model, p: &Parameters) -> u64 {
    let (tables, [a, b]) = (&vec![0.0; TABLE_WORDS][..], pair(p));
    counted(|| {
        let one = real::<Counted>(1.0);
        let (q2, mass_b) = if m.sums_distances() {
            (real(0.16), one)
        } else {
            (squared_distance(m, p, a, b), mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall))
        };
        let sum = if is_stepped(m) {
            let v_ab = a.velocity - b.velocity;
            let x_ab = separation(m, p, a.position, b.position) - v_ab * real(1.0);
            let q = root(squared_ratio(m, p, x_ab, one));
            let slope = continuity_slope(m, tables, q, one);
            continuity_neighbour(m, dot3(x_ab, v_ab), mass_b, q, slope, one)
        } else {
            density_neighbour(m, number_density_neighbour(m, tables, q2, one), mass_b)
        };
        let near = (m.near_pressure == DOUBLE_DENSITY).then(|| near_density_neighbour(m, mass_b, q2, one));
        let number = (m.has_number_density_volume == 1).then(|| number_density_neighbour(m, tables, q2, one));
        // the addition to the sums counts too
        [Some(sum), near, number].map(|sum| sum.map(|sum| one + sum))
    })
}

/// Operations to add the force of a neighbour to that of a particle.
pub(super) fn of_force(m: &Model, p: &Parameters) -> u64 {
    let (tables, [a, b]) = (&vec![0.0; TABLE_WORDS][..], pair(p));
    counted(|| vec3(Counted(0.0), Counted(0.0), Counted(0.0)) + force_neighbour(m, p, tables, a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_counted_one_by_one() {
        let (x, y) = (Counted(3.0), Counted(2.0));
        assert_eq!(counted(|| x * y + 1.0), 2);
        assert_eq!(counted(|| Counted::select(x, x.div(y.root()), x.less(y))), 4);
        assert_eq!(counted(|| x.larger(y)), 1);
    }
}
