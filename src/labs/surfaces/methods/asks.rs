//! What a method asks, beside two others that make the same picture: what for, about what now, and how often so far.

use crate::figure::ViewId;

use super::prelude::*;

/// `now` is a template, of a run that is on its way, `so_far` a name; `all` are the questions of the whole run.
pub fn asks<M: Telling<Scenery = Scenery>>(
    at: &At<'_, M>,
    question: &'static str,
    [now, so_far]: [&str; 2],
    is_done: bool,
    all: impl FnOnce() -> usize,
) -> Option<View> {
    at.scenery.filter(|it| it.scene().beside.len() == 2)?;
    let counts = Message::new("asks-of").with("count", at.value(so_far)?);
    let (role, now) = if is_done {
        (Role::Soft, Some(Value::Term("asks-done")))
    } else {
        (Role::Ink, at.formula(now).map(Value::Formula))
    };
    let cells = [
        Some(Value::Term(question)),
        now,
        Some(counts.with("all", all()).into()),
    ];
    let row = TableRow {
        name: Value::Term(M::NAME_KEY),
        cells: cells.map(|value| Cell::new(role, value)).to_vec(),
        is_current: false,
        link: None,
    };
    let term = |key| Formula::default().term(key);
    let titles = ["asks-what", "asks-now", "asks-so-far"].map(term);
    let table = Table {
        header: [vec![Formula::default()], titles.to_vec()].concat(),
        rows: vec![row],
        notes: Vec::new(),
    };
    let (id, body) = (ViewId::ASKED, Body::Table(table));
    Some(View { id, body })
}
