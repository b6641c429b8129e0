//! Reads the fluids of a scene file, which are a list or a single fluid.
use super::fluid::{FLUIDS, Fluid};
use heapless::Vec;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};

/// Reads a list of fluids, or one fluid as a list of length 1.
pub(super) fn one_or_several<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Fluid, FLUIDS>, D::Error> {
    from.deserialize_any(Fluids)
}

struct Fluids;

impl<'de> Visitor<'de> for Fluids {
    type Value = Vec<Fluid, FLUIDS>;

    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "a fluid, or a list of at most {FLUIDS} fluids")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Self::Value, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, fluid: A) -> Result<Self::Value, A::Error> {
        Ok([Fluid::deserialize(MapAccessDeserializer::new(fluid))?].into_iter().collect())
    }
}
