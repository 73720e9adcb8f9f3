//! The places that a case, an answer or an event names.

use serde_json::Value as Json;

/// Places of `N` numbers.
pub(super) struct Told<const N: usize> {
    /// Two are the ends of a segment, more the corners of an outline.
    pub outlines: Vec<Vec<[f64; N]>>,
    /// Where a step is at work.
    pub at: Option<[f64; N]>,
}

impl<const N: usize> Told<N> {
    pub(super) fn of(said: &Json) -> Self {
        let alone = ["segment", "ends", "triangle"].into_iter();
        let alone = alone.filter_map(|name| said.get(name));
        let lists = ["polygons", "triangles"].into_iter();
        let lists = lists.filter_map(|name| said.get(name)?.as_array());
        let outlines = alone.chain(lists.flatten()).filter_map(outline);
        Self {
            outlines: outlines.collect(),
            at: ["to", "at"]
                .into_iter()
                .find_map(|name| place(said.get(name)?)),
        }
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = [f64; N]> {
        self.outlines.iter().flatten().copied()
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.outlines.is_empty() && self.at.is_none()
    }

    /// The same, seen in another space.
    pub(super) fn map<const M: usize>(&self, seen: impl Fn([f64; N]) -> [f64; M]) -> Told<M> {
        let outlines = self.outlines.iter();
        let outlines = outlines.map(|corners| corners.iter().map(|&at| seen(at)).collect());
        Told {
            outlines: outlines.collect(),
            at: self.at.map(&seen),
        }
    }
}

/// Numbers, alone or under `at`.
pub(super) fn place<const N: usize>(value: &Json) -> Option<[f64; N]> {
    numbers(value.get("at").unwrap_or(value))
}

/// So many numbers that can be drawn.
pub(super) fn numbers<const N: usize>(value: &Json) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(drawable).collect();
    numbers?.try_into().ok()
}

/// At least two places: a list of them, or both ends of a segment in one list of numbers.
pub(super) fn outline<const N: usize>(value: &Json) -> Option<Vec<[f64; N]>> {
    let list = value.as_array()?;
    let (first, last) = list.split_at(N.min(list.len()));
    let ends = [first, last].map(|end| place(&Json::from(end)));
    let corners = match ends {
        [Some(a), Some(b)] => vec![a, b],
        _ => list.iter().map(place).collect::<Option<_>>()?,
    };
    (corners.len() > 1).then_some(corners)
}

fn drawable(value: &Json) -> Option<f64> {
    value.as_f64().filter(|x| x.abs() < 1e9)
}
