//! `laplace-drop`: the catalogue's case S1. Inside of a drop at rest the pressure is higher by `sigma / R` (Laplace; in the
//! plane). A disc is cut out of a lattice and calms down; the pressures of its inside and of what is around it are averaged
//! over time. What does not calm down are spurious currents: `Ca = mu v / sigma` says how fast they are
//! (the catalogue would like 1e-2 at most).
//!
//! The limits are for a drop in a like fluid. In nothing the colour ends at the surface, and half of its profile is missing:
//! how much of the tension is left is reported, and there the divergence of unit normals is the better curvature.
use super::drop::{Around, Droplet, SIGMA};
use super::{Context, Figure, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use millpond_core::scene::SurfaceTension;

const NAME: &str = "laplace-drop";

/// The models with a tension of their own.
const MODELS: [SurfaceTension; 2] = [SurfaceTension::Curvature, SurfaceTension::NormalCurvature];

/// Radius in spacings.
const COARSE: u16 = 10;
const FINE: u16 = 20;

/// Of the issue: the jump off `sigma / R`, at the finer one.
const LIMIT: f64 = 0.05;
const QUICK_LIMIT: f64 = 0.15;

/// What a drop came to.
#[derive(Clone, Copy, Debug)]
struct Jump {
    /// Radius of a disc of its volume, m.
    radius: f64,
    /// Pa.
    pressure: f64,
    /// Its miss of `sigma / R`, over that.
    off: f64,
    /// Capillary numbers of the root of the mean square speed, and of the largest one.
    currents: [f64; 2],
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (radius, limit) = if context.quick { (COARSE, QUICK_LIMIT) } else { (FINE, LIMIT) };
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for model in MODELS {
        let drop = Droplet::of_catalogue(model, Around::Like, radius);
        let jump = measure(context, &drop)?;
        figures.push(Figure::below(format!("jump off sigma / R, {}", drop.title()), jump.off.abs(), limit));
        lines.push(line(&drop, &Ok(jump)));
    }
    if !context.quick {
        for model in MODELS {
            for (around, radius) in [(Around::Like, COARSE), (Around::Nothing, COARSE), (Around::Nothing, FINE)] {
                let drop = Droplet::of_catalogue(model, around, radius);
                lines.push(line(&drop, &measure(context, &drop)));
            }
        }
    }
    let titles = ["tension", "around", "R/dx", "R, m", "jump, Pa", "off sigma / R", "Ca, rms", "Ca, largest"];
    let note = format!("sigma = {SIGMA} N/m; speeds are those of all particles, calmed or not.");
    Ok(Outcome::new(NAME, figures, vec![note, table(titles, lines)]))
}

fn line(drop: &Droplet, jump: &Result<Jump, Failure>) -> [String; 8] {
    let [radius, pascals, off, rms, fastest] = match jump {
        Ok(Jump { radius, pressure, off, currents: [rms, fastest] }) => [
            format!("{radius:.4}"),
            format!("{pressure:.3}"),
            format!("{:+.1} %", off * 100.0),
            format!("{rms:.1e}"),
            format!("{fastest:.1e}"),
        ],
        Err(failure) => [failure.to_string(), String::new(), String::new(), String::new(), String::new()],
    };
    let names = [drop.tension.name().into(), drop.around.name().into(), drop.radius.to_string()];
    let [tension, around, spacings] = names;
    [tension, around, spacings, radius, pascals, off, rms, fastest]
}

fn measure(context: &Context, drop: &Droplet) -> Result<Jump, Failure> {
    let sigma = f64::from(SIGMA);
    let calm = drop.calm(context, NAME)?;
    let off = calm.jump * calm.radius / sigma - 1.0;
    Ok(Jump { radius: calm.radius, pressure: calm.jump, off, currents: calm.currents.map(|current| current / sigma) })
}
