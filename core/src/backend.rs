//! Items that the GPU backend, the program and the tests share with the solver: memory layout, tables and formulas.
//! This module is not part of the public API and may change in any version.

pub use crate::advance::{Pace, Paced, advance, step_until};
pub use crate::clock::SteadyTime;
pub use crate::passes::g_finish::commit::verdict;
pub use crate::passes::lists::ListReport;

/// See the module of the same name.
pub mod arithmetic {
    pub use crate::arithmetic::*;
}

/// See the module of the same name.
pub mod derive {
    pub use crate::derive::*;
}

/// See the module of the same name.
pub mod grid {
    pub use crate::grid::*;
}

/// See the module of the same name.
pub mod hash {
    pub use crate::hash::*;
}

/// See the module of the same name.
pub mod layout {
    pub use crate::layout::*;
}

/// See the module of the same name.
pub mod live {
    pub use crate::live::*;
}

/// See the module of the same name.
pub mod memory {
    pub use crate::memory::*;
}

/// See the module of the same name.
pub mod plan {
    pub use crate::plan::*;
}

/// See the module of the same name.
pub mod report {
    pub use crate::report::*;
}

/// See the module of the same name.
pub mod save {
    pub use crate::save::*;
}

/// Distances from solids.
pub mod solids {
    pub use crate::solid_state::distance_from;
}

/// See the module of the same name.
pub mod springs {
    pub use crate::springs::*;
}

/// See the module of the same name.
pub mod terms {
    pub use crate::terms::*;
}

/// See the module of the same name.
pub mod validate {
    pub use crate::validate::*;
}
