//! Input list and output list side by side, and which vertex of the one became which of the other.

use crate::{algo::polygon::SutherlandHodgmanEvent as Event, labs::rings::side_term};

use super::{
    drawing::{Picture, result_role, right_result},
    lists::{output_symbol, vertex_link},
    prelude::*,
    skin::LabVertex,
};

struct Pair<'a, V> {
    titles: [&'static str; 2],
    input: &'a [V],
    output: &'a [V],
    /// How far inside the clip edge vertices of the first lie, and whether that counts as inside.
    sides: &'a [(f64, bool)],
    /// Where between vertices of the first there are crossings.
    crossings: &'a [([usize; 2], Crossing<V>)],
    current: &'a [usize],
    now: Now<V>,
}

/// What this step does to the second list.
#[derive(Clone, Copy, PartialEq)]
enum Now<V> {
    /// Nothing has been asked yet.
    Begins,
    Looks,
    /// It finds a crossing that is to be put out.
    Finds(V),
    PutsOut,
    /// It makes it the next input list.
    Passes,
    /// It makes it the answer.
    Ends {
        is_wrong: bool,
    },
}

/// Both lists at a step; after a pass the old and the new one, at the end what was given and what is left.
pub fn lists<V: LabVertex>(now: &Picture<'_, V>) -> Lists {
    let rings = &now.rings;
    let current = rings.current();
    let looks = Pair {
        titles: ["sh-list-input", "sh-list-output"],
        input: rings.list,
        output: rings.output,
        sides: &rings.turn.sides,
        crossings: &rings.turn.crossings,
        current: &current,
        now: Now::Looks,
    };
    let pair = match now.event {
        Some(Event::Edge { .. }) if now.n_passed > 0 => Pair {
            titles: ["sh-list-handed-on", "sh-list-output"],
            ..looks
        },
        None => Pair {
            now: Now::Begins,
            ..looks
        },
        Some(Event::Edge { .. } | Event::First { .. } | Event::Test { .. }) => looks,
        Some(Event::Cross(Crossing { at, .. })) => Pair {
            now: Now::Finds(at),
            ..looks
        },
        Some(Event::Output { .. }) => Pair {
            now: Now::PutsOut,
            ..looks
        },
        Some(Event::Pass { .. }) => Pair {
            titles: ["sh-list-input", "sh-list-next"],
            input: rings.passed,
            output: rings.list,
            current: &[],
            now: Now::Passes,
            ..looks
        },
        Some(Event::Done { .. }) => {
            let is_wrong = right_result(now.input, rings.list).is_some();
            Pair {
                titles: ["sh-list-given", "sh-list-left"],
                input: &now.input.vertices,
                output: rings.list,
                sides: &[],
                crossings: &[],
                current: &[],
                now: Now::Ends { is_wrong },
            }
        }
    };
    pair.lists()
}

impl<V: LabVertex> Pair<'_, V> {
    fn lists(&self) -> Lists {
        let origins = self.origins();
        let lists = [self.input_list(&origins), self.output_list()];
        let said = [(ItemMarker::Dot, true), (ItemMarker::Ring, false)];
        let said = said.map(|(marker, is_inside)| (marker, Value::Term(side_term(is_inside))));
        Lists {
            links: self.links(&origins, &lists),
            lists: lists.into(),
            legend: said.to_vec(),
        }
    }

    fn found(&self) -> Option<&V> {
        match &self.now {
            Now::Finds(at) => Some(at),
            _ => None,
        }
    }

    /// Until a distance is known, a vertex stands with both its places.
    fn tells_both(&self) -> bool {
        V::IS_TEXTURED && matches!(self.now, Now::Begins)
    }

    fn is_inside(&self, i: usize) -> Option<bool> {
        self.sides.get(i).map(|&(_, is_inside)| is_inside)
    }

    /// Between which two vertices of the first list each entry of the second lies; twice the same one for a vertex that
    /// has been kept. A crossing that is about to be put out is one of them. None where that is long forgotten.
    fn origins(&self) -> Vec<Option<[usize; 2]>> {
        let (mut vertices, mut crossings) = (0, 0);
        let output = self.output.iter().chain(self.found());
        let origin = |vertex: &V| {
            // A crossing may be put out twice.
            let near = self.crossings.iter().enumerate().skip(crossings).take(2);
            if let Some((i, &(ends, _))) = near.into_iter().find(|(_, (_, it))| it.at == *vertex) {
                crossings = i;
                return Some(ends);
            }
            let ahead = self.input.iter().skip(vertices);
            let found = vertices + ahead.into_iter().position(|other| other == vertex)?;
            vertices = found + 1;
            Some([found; 2])
        };
        output.map(origin).collect()
    }

    fn input_list(&self, origins: &[Option<[usize; 2]>]) -> ListColumn {
        let is_last = matches!(self.now, Now::Ends { .. });
        let entry = |i: usize| {
            let is_left = || is_last.then(|| origins.contains(&Some([i; 2])));
            let is_inside = self.is_inside(i).or_else(is_left);
            let mut details = vec![Some(place(&self.input[i]))];
            if !is_last {
                let distance = self.sides.get(i).map(|&(d, _)| Value::Number(d));
                let point = || Value::Point(self.input[i].at().to_array());
                let asked = if self.tells_both() {
                    Some(point())
                } else {
                    distance
                };
                details.insert(usize::from(V::IS_TEXTURED), asked);
            }
            ListRow {
                role: match is_inside {
                    _ if self.current.contains(&i) => Role::Signal,
                    Some(true) => Role::Ink,
                    Some(false) => Role::Discarded,
                    None => Role::Soft,
                },
                marker: is_inside.map(ItemMarker::dot_or_ring),
                details,
                link: (!is_last).then(|| vertex_link(i)),
                ..ListRow::new(vertex_name(i))
            }
        };
        let mut columns = vec![column::<V>()];
        if !is_last {
            let asked = name(if self.tells_both() { "(x, y)" } else { "d" });
            columns.insert(usize::from(V::IS_TEXTURED), asked);
        }
        let (title, focus) = (Value::Term(self.titles[0]), self.current.last().copied());
        ListColumn {
            columns,
            is_ring: true,
            ..ListColumn::about(title, self.input.len(), focus, entry)
        }
    }

    fn output_list(&self) -> ListColumn {
        let found = self.found();
        let n = self.output.len() + usize::from(found.is_some());
        let is_closed = matches!(self.now, Now::Passes | Now::Ends { .. });
        let entry = |i: usize| {
            let (symbol, role) = match (self.output.get(i), self.now) {
                (None, _) => ("I".to_owned(), Role::Signal),
                (_, Now::Ends { is_wrong }) => (output_symbol(i), result_role(is_wrong)),
                (_, Now::Begins | Now::Passes | Now::Looks | Now::Finds(_) | Now::PutsOut) => {
                    (output_symbol(i), Role::Accent)
                }
            };
            ListRow {
                role,
                marker: Some(ItemMarker::Dot),
                details: vec![self.output.get(i).or(found).map(place)],
                link: is_closed.then(|| vertex_link(i)),
                ..ListRow::new(name(symbol))
            }
        };
        let title = match self.now {
            Now::Ends { is_wrong: true } => Message::new("result-wrong").with("n", n).into(),
            _ => Value::Term(self.titles[1]),
        };
        // Of a whole ring its beginning is seen, of one that grows its end.
        let focus = n.checked_sub(1).filter(|_| !is_closed);
        ListColumn {
            columns: vec![column::<V>()],
            is_ring: is_closed,
            ..ListColumn::about(title, n, focus, entry)
        }
    }

    /// What came from where, of the entries that are given: a crossing from both ends of its edge while that is at work,
    /// afterwards from the outer one, in whose place it stands; that of the closing edge from the last, so that links
    /// do not cross.
    fn links(&self, origins: &[Option<[usize; 2]>], lists: &[ListColumn; 2]) -> Vec<ListLink> {
        let is_now = matches!(self.now, Now::Finds(_) | Now::PutsOut);
        let mut links = Vec::new();
        for (i, origin) in origins.iter().enumerate() {
            let Some((to, [s, p])) = lists[1].entry_of(i).zip(*origin) else {
                continue;
            };
            let (from, role) = match (is_now && i + 1 == origins.len(), self.is_inside(s)) {
                (true, _) => (vec![s, p], Role::Signal),
                (false, Some(true)) if s < p => (vec![p], Role::Soft),
                (false, _) => (vec![s], Role::Soft),
            };
            let from = from.iter().skip(usize::from(from.first() == from.get(1)));
            let from = from.filter_map(|&from| lists[0].entry_of(from));
            links.extend(from.map(|from| ListLink::between(from, to, role)));
        }
        links
    }
}

/// Over the column that every list has: what the drawing does not tell.
fn column<V: LabVertex>() -> Value {
    name(if V::IS_TEXTURED { "(u, v)" } else { "(x, y)" })
}

/// Where in the texture a vertex is, if it has a place there, else where on the stage.
fn place<V: LabVertex>(vertex: &V) -> Value {
    Value::Point(vertex.uv().unwrap_or_else(|| vertex.at().to_array()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        algo::polygon::{SutherlandHodgman, SutherlandHodgmanInput},
        geom::{Polygon, Window},
        labs::polygons::methods::shown_lists::{assert_are_short, at, taken},
    };

    fn run(outline: &[[f64; 2]]) -> Box<dyn Run> {
        let region = Window::new(-4.0, -3.0, 4.0, 3.0).unwrap().into();
        let input = SutherlandHodgmanInput::new(region, &Polygon::new(outline).unwrap());
        Box::new(Recorded::<SutherlandHodgman>::new(input, None))
    }

    const CUT_LEFT: [[f64; 2]; 5] = [
        [3.0, -1.0],
        [2.0, 2.0],
        [-6.0, 1.0],
        [-6.0, -1.0],
        [-2.0, -2.0],
    ];

    #[test]
    fn a_crossing_comes_from_both_ends_of_its_edge_and_a_vertex_from_itself() {
        let run = run(&CUT_LEFT);
        let found = at(&*run, "cross");
        let [input, output] = &found.lists[..] else {
            panic!("two lists")
        };
        let roles: Vec<Role> = input.entries.iter().map(|entry| entry.role).collect();
        let [now, to_come] = [Role::Signal, Role::Soft];
        assert_eq!(roles, [Role::Ink, now, now, to_come, to_come], "S and P");
        let p = &input.entries[2];
        assert_eq!(p.marker, Some(ItemMarker::Ring), "P is outside");
        assert_eq!(p.details[0], Some(Value::Number(-2.0)), "by 2");
        let last = output.entries.last().expect("I");
        assert_eq!((&last.name, last.role), (&name("I"), Role::Signal));
        let from_both = [[[0, 1], [1, 2]], [[0, 2], [1, 2]]];
        assert_eq!(taken(&found), from_both, "from S and from P");
        let put_out = at(&*run, "output #5");
        assert_eq!(taken(&put_out), [[[0, 4], [1, 4]]], "V₅ is V₅′");
    }

    #[test]
    fn a_pass_keeps_what_is_linked() {
        let passed = at(&*run(&CUT_LEFT), "pass");
        let links: Vec<[usize; 2]> = passed.links.iter().map(|l| [l.from[1], l.to[1]]).collect();
        assert_eq!(links, [0, 1, 2, 3, 4].map(|i| [i; 2]));
        let entries = passed.lists[0].entries.iter();
        let outside = entries.filter(|entry| entry.marker == Some(ItemMarker::Ring));
        assert_eq!(outside.count(), 2);
    }

    #[test]
    fn a_long_list_is_given_about_the_step() {
        let n = 1000;
        let tooth = |i: usize| [i as f64 / 100.0 - 5.0, (i % 2) as f64];
        let outline: Vec<[f64; 2]> = (0..n).map(tooth).collect();
        let lists = at(&*run(&outline), "test #700");
        assert_are_short(&lists);
        assert!(lists.lists.iter().all(|list| list.focus.is_some()));
        let input = &lists.lists[0];
        assert_eq!(input.n_before + input.entries.len() + input.n_after, n);
    }
}
