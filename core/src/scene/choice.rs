//! Every choice between formulas or structures that a scene can make. The numbers of those that a term compares are the
//! term's own.
use crate::terms::{kernel, pressure, state};

/// Dimension of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimension {
    /// The plane z = 0.
    Two,
    /// Space.
    Three,
}

impl Dimension {
    /// 2 or 3.
    #[must_use]
    pub fn count(self) -> usize {
        match self {
            Dimension::Two => 2,
            Dimension::Three => 3,
        }
    }
}

/// A smoothing kernel with a finite value everywhere. All vanish at the support radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum Kernel {
    /// Mueller et al. 2003, eq. 20; its gradient vanishes for close pairs, so it makes a poor pressure kernel.
    Poly6 = kernel::POLY6,
    /// Mueller et al. 2003, eq. 21.
    Spiky = kernel::SPIKY,
    /// Monaghan and Lattanzio 1985, with the support radius as its 2 h.
    CubicSpline = kernel::CUBIC_SPLINE,
}

impl Kernel {
    /// All of them.
    pub const ALL: [Kernel; 3] = [Kernel::Poly6, Kernel::Spiky, Kernel::CubicSpline];

    /// Names of its terms: value and slope.
    #[must_use]
    pub fn terms(self) -> [&'static str; 2] {
        match self {
            Kernel::Poly6 => ["poly6_w", "poly6_slope"],
            Kernel::Spiky => ["spiky_w", "spiky_slope"],
            Kernel::CubicSpline => ["cubic_spline_w", "cubic_spline_slope"],
        }
    }
}

/// How pressure follows from density.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum EquationOfState {
    /// Monaghan 1994, exponent 7 (S0 eq. 2.15).
    Tait = state::TAIT,
    /// Desbrun and Cani 1996, linear (S0 eq. 2.14).
    Desbrun = state::DESBRUN,
}

impl EquationOfState {
    /// Name of its term.
    #[must_use]
    pub fn term(self) -> &'static str {
        match self {
            EquationOfState::Tait => "pressure_tait",
            EquationOfState::Desbrun => "pressure_desbrun",
        }
    }
}

/// How pressure becomes force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum PressureForce {
    /// Mueller et al. 2003 (S0 eq. 2.19): cheap, and half of the gradient.
    Mueller = pressure::MUELLER,
    /// Monaghan 1992 (S0 eq. 2.18): the whole gradient, and with one kernel for density and gradient it conserves energy.
    Monaghan = pressure::MONAGHAN,
}

impl PressureForce {
    /// Name of its term.
    #[must_use]
    pub fn term(self) -> &'static str {
        match self {
            PressureForce::Mueller => "pressure_mueller",
            PressureForce::Monaghan => "pressure_monaghan",
        }
    }
}

/// How much of a bounce a wall gives back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Reflection {
    /// All that `bounce` says, however late the wall was found.
    Full = 0,
    /// Only the share of the path that lay behind the wall (S0 figure 3.8).
    #[default]
    EnergyConserving = 1,
}

/// A face of the container.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Face {
    /// Lowest x.
    Left,
    /// Highest x.
    Right,
    /// Lowest y.
    Floor,
    /// Highest y.
    Ceiling,
    /// Lowest z.
    Back,
    /// Highest z.
    Front,
}

impl Face {
    /// All of them, low and high along x, y, z.
    pub const ALL: [Face; 6] = [Face::Left, Face::Right, Face::Floor, Face::Ceiling, Face::Back, Face::Front];
}

/// How particles get into cells. Both give the same bits: inside a cell the order is always that of the ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum GridStructure {
    /// Count, prefix sum, place (S1 section 6.2): a cell holds any number.
    IndexSort,
    /// A fixed number of places a cell (the CUDA design, S0 section 4.4.2): one pass less, and a cell can be full.
    CellLists {
        /// Places of a cell.
        places: u32,
    },
}
