//! Lists of rings: they agree in any order, and each up to where it starts.

use serde_json::{Map, Value as Json};

use super::compare::{Difference, Tolerance};

/// Fields of `output` that hold rings: of several in one answer the first ring of each is the same one, and so are its vertices.
const FIELDS: [&str; 4] = ["polygons", "triangles", "vertices", "uv"];

/// Fields of `output` that came after programs had been written: those that leave them out are right.
pub(super) const LATER: [&str; 4] = ["outcome", "relation", "vertices", "brightness"];

/// More comparisons of vertices are not made: what has not been found by then counts as not said.
const MOST_COMPARED: usize = 20_000_000;

pub(super) fn is_of_rings(field: &str) -> bool {
    FIELDS.contains(&field)
}

/// The first ring that is true and not said, or where the lists are no lists of rings of the same number.
pub(super) fn first_difference(
    said: &Map<String, Json>,
    truth: &Map<String, Json>,
    tolerance: Tolerance,
) -> Option<Difference> {
    let is_asked = |name: &&str| {
        truth.contains_key(*name) && (said.contains_key(*name) || !LATER.contains(name))
    };
    let names: Vec<&str> = FIELDS.into_iter().filter(is_asked).collect();
    let first = names.first()?;
    let lists = |of: &Map<String, Json>| {
        let lists = names.iter().map(|name| of.get(*name)?.as_array().cloned());
        lists.collect::<Option<Vec<_>>>()
    };
    let as_they_stand = || {
        names.iter().find_map(|name| {
            let nothing = Json::Null;
            let said = said.get(*name).unwrap_or(&nothing);
            let difference = tolerance.first_difference(said, &truth[*name])?;
            let path = format!("{name}{}", difference.path);
            Some(Difference { path, ..difference })
        })
    };
    let lists = lists(said).zip(lists(truth));
    let Some((said, truth)) = lists.and_then(|(said, truth)| Some((rings(&said)?, rings(&truth)?)))
    else {
        return as_they_stand();
    };
    if said.len() != truth.len() {
        return as_they_stand();
    }
    let mut matching = Matching {
        is_taken: vec![false; said.len()],
        next: 0,
        n_left: MOST_COMPARED,
        tolerance,
    };
    let unmatched = truth.iter().position(|ring| !matching.take(ring, &said))?;
    let spare = matching.is_taken.iter().position(|is_taken| !is_taken);
    let of_first = |ring: &Ring| Json::Array(ring.iter().map(|vertex| vertex[0].clone()).collect());
    Some(Difference {
        path: format!("{first}[{unmatched}]"),
        said: spare.map(|i| of_first(&said[i])),
        truth: Some(of_first(&truth[unmatched])),
    })
}

/// Of each vertex what each field says of it.
type Ring = Vec<Vec<Json>>;

/// None where the fields do not fit together.
fn rings(lists: &[Vec<Json>]) -> Option<Vec<Ring>> {
    let n = lists.first()?.len();
    if lists.iter().any(|list| list.len() != n) {
        return None;
    }
    let ring = |i: usize| {
        let of_fields = lists.iter().map(|list| list[i].as_array());
        let of_fields = of_fields.collect::<Option<Vec<_>>>()?;
        let n = of_fields[0].len();
        let vertex = |k: usize| of_fields.iter().map(|field| field[k].clone()).collect();
        let fits = of_fields.iter().all(|field| field.len() == n);
        fits.then(|| (0..n).map(vertex).collect())
    };
    (0..n).map(ring).collect()
}

struct Matching {
    is_taken: Vec<bool>,
    /// Looked at first: mostly the order is the same.
    next: usize,
    n_left: usize,
    tolerance: Tolerance,
}

impl Matching {
    /// Takes the first ring that is free and agrees.
    fn take(&mut self, truth: &Ring, said: &[Ring]) -> bool {
        let n = said.len();
        for i in (self.next..n).chain(0..self.next) {
            if !self.is_taken[i] && self.is_same(&said[i], truth) {
                self.is_taken[i] = true;
                self.next = (i + 1) % n;
                return true;
            }
            if self.n_left == 0 {
                return false;
            }
        }
        false
    }

    fn is_same(&mut self, said: &Ring, truth: &Ring) -> bool {
        let n = truth.len();
        if said.len() != n {
            self.n_left = self.n_left.saturating_sub(1);
            return false;
        }
        n == 0 || (0..n).any(|start| self.is_same_from(said, start, truth))
    }

    fn is_same_from(&mut self, said: &Ring, start: usize, truth: &Ring) -> bool {
        let n = truth.len();
        (0..n).all(|k| {
            self.n_left = self.n_left.saturating_sub(1);
            let pairs = said[(start + k) % n].iter().zip(&truth[k]);
            let mut pairs = pairs.into_iter();
            self.n_left > 0 && pairs.all(|(said, truth)| self.tolerance.agree(said, truth))
        })
    }
}
