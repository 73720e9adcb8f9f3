//! What of a scene in space can be set in the inspector.

use crate::{
    labs::space::{Opening, Scene, SpaceChange, controls::Section},
    panels::{form::Form, prelude::*},
};

use super::raster;

pub fn show(ui: &mut Ui, form: &Form<'_>, section: &Section, scene: &Scene) -> Option<PanelAsk> {
    let numbers = numbers(ui, form, section, scene);
    let choices = match section.id {
        "camera" => camera(ui, form, scene),
        "raster" => raster::choices(ui, form, scene),
        _ => None,
    };
    numbers.or(choices)
}

fn numbers(ui: &mut Ui, form: &Form<'_>, section: &Section, scene: &Scene) -> Option<PanelAsk> {
    let mut asked = None;
    for (nth, control) in section.numbers.iter().enumerate() {
        let (numbers, range) = ((control.numbers)(scene), (control.range)(scene));
        if numbers.is_empty() {
            continue;
        }
        let name = (control.name)();
        let entry = (control.id, &name, control.group);
        let set = form.row(ui, entry, numbers.len(), |ui, i| {
            let field = number_field(ui, form.look, control.unit, numbers[i], &range);
            let typed = field.to.filter(|_| field.is_typed);
            let refusal = typed.and_then(|to| control.refusal(scene, i, to));
            let refusal = field.unread.or(refusal);
            let to = field.to.filter(|_| refusal.is_none());
            form.refuse(ui, &field.response, refusal);
            (to.map(|to| (i, to)), field.response)
        });
        asked = asked.or(set.map(|(i, to)| {
            let change = Edit::own(SpaceChange::Set(control.id, i, to));
            PanelAsk::Tune(change, 3 * nth + i)
        }));
    }
    asked
}

fn camera(ui: &mut Ui, form: &Form<'_>, scene: &Scene) -> Option<PanelAsk> {
    let say = |key| form.look.say(key);
    let is_parallel = matches!(scene.camera.opening(), Opening::Height(_));
    let ways = [("camera-perspective", false), ("camera-parallel", true)];
    let ways = ways.map(|(key, is_parallel)| (is_parallel, say(key)));
    let name = Message::new("camera-sight");
    let sight = form.choice(ui, ("camera.sight", &name, "volume"), is_parallel, &ways);
    let name = Message::new("camera-frozen");
    let freeze = form.check(ui, ("camera.freeze", &name, ""), scene.frozen.is_some());
    let change = sight
        .map(SpaceChange::Parallel)
        .or(freeze.map(SpaceChange::Freeze));
    change.map(|change| PanelAsk::Edit(Edit::own(change)))
}
