//! Both grid structures of a scene, timed alternately.
use super::{Options, StructureTime};
use crate::failure::Failure;
use crate::fluid::start;
use crate::plan_view::USUAL_PLACES;
use crate::pool::Pool;
use crate::scenes::LoadedScene;
use crate::timing::{Milliseconds, timed};
use millpond_core::scene::GridStructure;
use millpond_core::{Checked, OwnedMemory, Requirements, Simd};

/// Times the scene with both grid structures, alternately.
pub(super) fn structures(
    named: &LoadedScene,
    simd: Simd,
    pool: &Pool,
    options: &Options,
) -> Result<Vec<StructureTime>, Failure> {
    let lists = match named.file.scene.grid.structure {
        GridStructure::IndexSort => GridStructure::CellLists { places: USUAL_PLACES },
        lists @ GridStructure::CellLists { .. } => lists,
    };
    let scenes = [GridStructure::IndexSort, lists].map(|structure| {
        let mut scene = named.file.scene.clone();
        scene.grid.structure = structure;
        scene
    });
    let refused = |error| Failure::Scene { origin: named.name.clone(), error };
    let checked = scenes.iter().map(|scene| scene.check().map_err(refused)).collect::<Result<Vec<_>, _>>()?;
    let mut heaps = [OwnedMemory::of(&checked[0]), OwnedMemory::of(&checked[1])];
    let mut solvers = Vec::new();
    for (scene, heap) in checked.iter().zip(&mut heaps) {
        solvers.push(start(&named.name, scene, heap)?.at_level(simd));
    }
    for solver in &mut solvers {
        for _ in 0..options.warm_up {
            solver.step(pool)?;
        }
    }
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..options.steps {
        for (solver, times) in solvers.iter_mut().zip(&mut times) {
            let (result, ms) = timed(|| solver.step(pool));
            result?;
            times.push(ms);
        }
    }
    let of = |(scene, times): (&Checked<'_>, &Vec<f64>)| {
        let requirements = Requirements::of(scene);
        StructureTime {
            structure: format!("{:?}", scene.grid.structure),
            ms_per_step: Milliseconds::of(times),
            bytes_per_particle: requirements.bytes() as f64 / requirements.counts.particles.max(1) as f64,
        }
    };
    Ok(checked.iter().zip(&times).map(of).collect())
}
