//! Promise: which job runs when and on which thread never changes a bit, nor which error is returned, whatever width an
//! executor reports.
//!
//! The executors here do what [`Executor`] allows but no sensible executor would do. Each steps the golden scenes,
//! which have pairs, springs, walls, air, cell lists and iterated pressure, and after every step the hash of all state
//! is compared with that of [`Serial`].
use millpond_core::scene::{GridStructure, Scene};
use millpond_core::{Executor, OwnedMemory, Serial, Solver, StepError};
use std::sync::atomic::{AtomicUsize, Ordering};

mod support;
use support::{Random, dam_break_2d, falling};

const STEPS: u32 = 10;

macro_rules! golden {
    ($($name:literal),*) => {
        [$(($name, include_str!(concat!("golden/", $name, ".ron")))),*]
    };
}

/// Returns the golden scenes, parsed.
fn scenes() -> Vec<(&'static str, Scene)> {
    let all = golden![
        "everything",
        "air-and-curvature",
        "plastic-and-warm",
        "tables-in-cell-lists",
        "corrected-pressure",
        "two-fluids-periodic",
        "adaptive-dynamic-walls",
        "pirovano-forms",
        "monaghan-in-a-box",
        "stepped-density-verlet",
        "beeman-exchange"
    ];
    all.into_iter().map(|(name, text)| (name, ron::from_str(text).expect("a scene in RON"))).collect()
}

/// Order in which an executor runs its jobs.
#[derive(Clone, Copy, Debug)]
enum Order {
    /// The first job first.
    Forwards,
    /// The last job first.
    Backwards,
    /// In a different order for each pass.
    Shuffled,
    /// Each job on a thread of its own, all at once.
    Threads,
}

/// Runs jobs in a given order, and reports a given width.
struct Odd {
    order: Order,
    width: usize,
    /// Number of passes so far.
    passes: AtomicUsize,
    /// Largest number of jobs in a pass.
    most: AtomicUsize,
}

impl Odd {
    fn new(order: Order, width: usize) -> Odd {
        Odd { order, width, passes: AtomicUsize::new(0), most: AtomicUsize::new(0) }
    }
}

impl Executor for Odd {
    fn width(&self) -> usize {
        self.width
    }

    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        let pass = self.passes.fetch_add(1, Ordering::Relaxed);
        self.most.fetch_max(jobs.len(), Ordering::Relaxed);
        match self.order {
            Order::Forwards => jobs.iter_mut().for_each(work),
            Order::Backwards => jobs.iter_mut().rev().for_each(work),
            Order::Shuffled => {
                let mut random = Random(pass as u64);
                let mut jobs: Vec<&mut J> = jobs.iter_mut().collect();
                jobs.sort_by_cached_key(|_| random.bits());
                jobs.into_iter().for_each(work);
            }
            Order::Threads => std::thread::scope(|scope| {
                for job in jobs {
                    scope.spawn(|| work(job));
                }
            }),
        }
    }
}

/// Returns executors, each with the smallest number of jobs that its widest pass must have. With fewer jobs it would
/// test nothing.
fn executors() -> Vec<(Odd, usize)> {
    vec![
        (Odd::new(Order::Forwards, 0), 1),
        (Odd::new(Order::Forwards, 64), 16),
        (Odd::new(Order::Forwards, usize::MAX), 16),
        (Odd::new(Order::Backwards, 1), 1),
        (Odd::new(Order::Backwards, 3), 8),
        (Odd::new(Order::Backwards, 64), 16),
        (Odd::new(Order::Shuffled, 64), 16),
        (Odd::new(Order::Threads, 0), 1),
        (Odd::new(Order::Threads, 2), 6),
        (Odd::new(Order::Threads, 64), 16),
    ]
}

/// Returns the hash of all state at the start and after each step, and the error that stopped the run.
fn hashes(scene: &Scene, executor: &impl Executor, steps: u32) -> (Vec<u64>, Option<StepError>) {
    let mut memory = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(scene, memory.lend()).expect("a scene");
    let mut hashes = vec![solver.full_hash()];
    for _ in 0..steps {
        if let Err(error) = solver.step(executor) {
            hashes.push(solver.full_hash());
            return (hashes, Some(error));
        }
        hashes.push(solver.full_hash());
    }
    (hashes, None)
}

#[test]
fn in_every_golden_scene() {
    for (name, scene) in scenes() {
        let want = hashes(&scene, &Serial, STEPS);
        assert!(want.1.is_none() && want.0[0] != want.0[STEPS as usize], "{name} moves");
        for (executor, least) in executors() {
            let got = hashes(&scene, &executor, STEPS);
            let differs = want.0.iter().zip(&got.0).position(|(want, got)| want != got);
            let what = format!("{name}, {:?}, width {}", executor.order, executor.width);
            assert_eq!((differs, got.1), (None, None), "first step that differs: {what}");
            let most = executor.most.into_inner();
            assert!(most >= least, "{most} jobs: {what}");
        }
    }
}

#[test]
fn when_a_step_is_refused() {
    // the first fluid is so stiff that hundreds of particles leave the grid's range at once, and in the second scene
    // cells fill up: whichever job runs first, the same error must be returned
    let mut stiff = dam_break_2d(0.5);
    stiff.fluids[0].speed_of_sound = 1e12;
    let mut crowded = falling::impact();
    crowded.grid.structure = GridStructure::CellLists { places: 13 };
    for scene in [stiff, crowded] {
        let (state, told) = hashes(&scene, &Serial, 1000);
        assert!(matches!(told, Some(StepError::OutOfRange { .. } | StepError::CellFull { .. })), "{told:?}");
        assert_eq!(state[state.len() - 2], state[state.len() - 1], "nothing has changed");
        for (executor, _) in executors() {
            let got = hashes(&scene, &executor, 1000);
            assert_eq!(got.1, told, "{:?}, width {}", executor.order, executor.width);
            assert!(got.0 == state, "{:?}, width {}", executor.order, executor.width);
            let many = executor.most.into_inner() > 1;
            assert_eq!(many, executor.width > 1, "{:?}, width {}", executor.order, executor.width);
        }
    }
}
