//! Bisection for the largest stable time step.

/// Precision of a bisection: the smallest unstable time step over the largest stable one, less 1.
pub(super) const PRECISION: f32 = 0.05;

/// The limit of stability, from both sides, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// Largest stable time step; `None` if none was stable.
    pub(super) stable: Option<f32>,
    /// Smallest unstable time step above it; `None` if all were stable.
    pub(super) unstable: Option<f32>,
}

/// Searches for the limit between `least` and `most`. It doubles or halves `start` until it has a stable and an
/// unstable time step, then bisects between them on a logarithmic scale. If stable and unstable time steps alternate,
/// it finds one of the limits.
///
/// # Errors
/// Returns the error of `is_stable`.
pub(super) fn edge<E>(
    start: f32,
    [least, most]: [f32; 2],
    mut is_stable: impl FnMut(f32) -> Result<bool, E>,
) -> Result<Edge, E> {
    let mut edge = Edge { stable: None, unstable: None };
    let mut step = start.min(most).max(least);
    while edge.stable.is_none() || edge.unstable.is_none() {
        if is_stable(step)? {
            edge.stable = Some(step);
            if step >= most {
                return Ok(edge);
            }
            step = (step * 2.0).min(most);
        } else {
            edge.unstable = Some(step);
            if step <= least {
                return Ok(edge);
            }
            step = (step * 0.5).max(least);
        }
    }
    while let Edge { stable: Some(stable), unstable: Some(unstable) } = edge {
        let middle = (stable * unstable).sqrt();
        let apart = stable < middle && middle < unstable;
        if unstable <= stable * (1.0 + PRECISION) || !apart {
            break;
        }
        if is_stable(middle)? { edge.stable = Some(middle) } else { edge.unstable = Some(middle) }
    }
    Ok(edge)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: [f32; 2] = [1e-6, 1e-1];

    /// Finds the edge for time steps that are stable up to `limit`, and the number of evaluations.
    fn look(start: f32, limit: f32) -> (Edge, u32) {
        let mut asked = 0;
        let found = edge(start, RANGE, |step| {
            asked += 1;
            Ok::<bool, ()>(step <= limit)
        });
        (found.expect("it never fails"), asked)
    }

    #[test]
    fn the_edge_is_found_from_either_side() {
        for limit in [3e-6, 1.1e-4, 9.9e-4, 1e-3, 1.01e-3, 0.04] {
            let (edge, asked) = look(1e-3, limit);
            let (stable, unstable) = (edge.stable.expect("one is stable"), edge.unstable.expect("one is unstable"));
            assert!(stable <= limit && limit < unstable, "{limit}: {edge:?}");
            assert!(unstable <= stable * (1.0 + PRECISION), "{limit}: {edge:?}");
            assert!(asked < 20, "{limit}: {asked}");
        }
    }

    #[test]
    fn where_there_is_no_edge_the_ends_are_told() {
        assert_eq!(look(1e-3, 1.0).0, Edge { stable: Some(RANGE[1]), unstable: None });
        assert_eq!(look(1e-3, 0.0).0, Edge { stable: None, unstable: Some(RANGE[0]) });
        assert_eq!(look(7.0, 1.0).0.stable, Some(RANGE[1]), "a start beyond the range");
    }

    #[test]
    fn what_cannot_be_said_ends_it() {
        assert_eq!(edge(1e-3, RANGE, |step| if step > 1e-4 { Ok(false) } else { Err(step) }).map(|_| ()), Err(6.25e-5));
    }
}
