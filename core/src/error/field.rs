//! The path of a field of a scene, as errors write it.
use core::fmt::{self, Write};

/// Path of a field of a scene, such as `fluids[1].rest_density`: its names and, in a list, the index of the item.
///
/// ```
/// use millpond_core::Field;
///
/// let field = Field::of_item("fluids.rest_density", 1);
/// assert_eq!(field.to_string(), "fluids[1].rest_density");
/// assert_eq!(field, "fluids[1].rest_density");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    names: &'static str,
    item: Option<usize>,
}

impl Field {
    /// Returns the path of a field of one item of a list. The first of the `names` is that of the list, or that before
    /// `[]`, and items are counted from 0.
    #[must_use]
    pub const fn of_item(names: &'static str, item: usize) -> Field {
        Field { names, item: Some(item) }
    }
}

impl From<&'static str> for Field {
    fn from(names: &'static str) -> Field {
        Field { names, item: None }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Some(item), Some((list, rest))) = (self.item, self.names.split_once("[]")) {
            return write!(f, "{list}[{item}]{rest}");
        }
        match (self.item, self.names.split_once('.')) {
            (None, _) => f.write_str(self.names),
            (Some(item), None) => write!(f, "{}[{item}]", self.names),
            (Some(item), Some((list, rest))) => write!(f, "{list}[{item}].{rest}"),
        }
    }
}

impl PartialEq<&str> for Field {
    fn eq(&self, text: &&str) -> bool {
        let mut rest = Rest(text);
        write!(rest, "{self}").is_ok() && rest.0.is_empty()
    }
}

/// What is left of a text after everything written to it was found at its beginning.
struct Rest<'t>(&'t str);

impl Write for Rest<'_> {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        self.0 = self.0.strip_prefix(part).ok_or(fmt::Error)?;
        Ok(())
    }
}
