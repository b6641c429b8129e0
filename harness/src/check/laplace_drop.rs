//! `laplace-drop`: the catalogue's case Hinsch 2024. Inside of a drop at rest the pressure is higher by `sigma / R` (Laplace; in the
//! plane). A disc is cut out of a lattice and calms down; the pressures of its inside and of what is around it are averaged
//! over time. What does not calm down are spurious currents: `Ca = mu v / sigma` says how fast they are
//! (the catalogue would like 1e-2 at most).
//!
//! The limits are for a drop in a like fluid. In nothing the colour ends at the surface, and half of its profile is missing:
//! how much of the tension is left is reported, and there the divergence of unit normals is the better curvature.
use super::drop::{Around, Droplet, SIGMA};
use super::flow::mean;
use super::{Context, Metric, Outcome};
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

/// What a quick study asks of each model, and of the mean over which places of the disc on the lattice.
///
/// The curvature of normals is as close with a coarse drop: from -0.8 to -1.2 % wherever the disc is cut out, R/dx being 10 or 12.
/// The curvature of the colour is pulled about by single particles of the rim. Its drop rings as long as it is looked at, and
/// the jump is off by +22.1, +0.1, -4.5 and +11.7 % at these four places with R/dx = 10, by +12.7, +1.3, +5.3 and +11.4 % with 12, by
/// +12.0, +11.4, +12.6 and +7.9 % with 14, by +2.7, +17.7, +9.5 and +13.5 % with 20. It is too large by some 10 %, which no finer drop
/// mends, and scatters by up to 11 %, half of which is left in a mean of four: the limit is these two together.
const QUICK: [(SurfaceTension, &[[f64; 2]], f64); 2] = [
    (SurfaceTension::Curvature, &[[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.25, 0.25]], 0.15),
    (SurfaceTension::NormalCurvature, &[[0.0, 0.0]], LIMIT),
];

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
    let judged = MODELS.map(|model| (model, &[[0.0; 2]] as &[_], LIMIT));
    let (radius, judged) = if context.quick { (COARSE, QUICK) } else { (FINE, judged) };
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (model, offsets, limit) in judged {
        let centred = Droplet::of_catalogue(model, Around::Like, radius);
        let mut off = Vec::new();
        for &offset in offsets {
            let drop = Droplet { offset, ..centred };
            let jump = measure(context, &drop)?;
            off.push(jump.off);
            lines.push(line(&drop, &Ok(jump)));
        }
        let name = match off.len() {
            1 => format!("jump off sigma / R, {}", centred.title()),
            places => format!("jump off sigma / R, {}, mean of {places} places", centred.title()),
        };
        figures.push(Metric::below(name, mean(&off, |off| *off).abs(), limit));
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
