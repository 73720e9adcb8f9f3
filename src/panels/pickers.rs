//! Which methods are on stage: the same for every lab.

use egui::{
    ComboBox, Rect, Shape, Stroke, Ui,
    style::{StyleModifier, WidgetVisuals},
    vec2,
};

use crate::{
    labs::{Edit, MethodCard, Scene},
    widgets::{Look, menu_style, section},
};

/// A list of methods may be this high: all of a lab's are seen at once, where the window has room.
const LIST_PTS: f32 = 560.0;

/// The scene's method; the change that was asked for.
/// Where `asks` first, a faulty one is not called by its fault.
pub fn method_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene, asks: bool) -> Option<Edit> {
    let mut asked = None;
    let name = |card: &MethodCard| look.say(card.name_key);
    let now = *scene.document().methods().first()?;
    let shown = look.say(now.name_asked(asks));
    let combo = list("method", shown).truncate().show_ui(ui, |ui| {
        let methods = (scene.document().lab().methods)().into_iter();
        for card in methods.filter(|card| !card.is_faulty) {
            if ui.selectable_label(card.id == now.id, name(card)).clicked() {
                asked = Some(Edit::Method(card.id));
            }
        }
    });
    combo.response.on_hover_text(look.say("panel-algorithm"));
    asked
}

/// Where `asks` first, the faulty one that stands beside is not told.
pub fn compare_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene, asks: bool) -> Option<Edit> {
    let beside = scene.document().methods().into_iter().skip(1);
    let names: Vec<String> = beside.map(|card| look.say(card.name_asked(asks))).collect();
    let shown = if names.is_empty() {
        look.say("cost-compare")
    } else {
        names.join(" + ")
    };
    let combo = list("compare", shown).show_ui(ui, |ui| compare_choices(ui, look, scene, asks));
    combo.response.on_hover_text(look.say("cost-compare"));
    combo.inner.flatten()
}

pub fn compare_choices(ui: &mut Ui, look: Look<'_>, scene: &Scene, asks: bool) -> Option<Edit> {
    let mut asked = None;
    let methods = scene.document().methods();
    let (main, beside) = methods.split_first()?;
    let none = look.say("cost-compare-none");
    if ui.selectable_label(beside.is_empty(), none).clicked() {
        asked = Some(Edit::Compare(None));
    }
    // The ones that are wrong on purpose come last, under their question.
    let others = (scene.document().lab().methods)().into_iter();
    let others = others.filter(|card| card.id != main.id);
    let (faulty, right): (Vec<&MethodCard>, Vec<_>) = others.partition(|card| card.is_faulty);
    let first_faulty = faulty.first().map(|card| card.id);
    for card in right.into_iter().chain(faulty) {
        if first_faulty == Some(card.id) {
            ui.separator();
            section(ui, look, &look.say("faulty-title"));
        }
        let chosen = beside.iter().any(|beside| beside.id == card.id);
        let chosen = chosen && !(asks && card.is_faulty);
        let name = look.say(card.name_key);
        if ui.selectable_label(chosen, name).clicked() {
            asked = Some(Edit::Compare(Some(card.id)));
        }
    }
    asked
}

/// A button that opens a list of choices.
pub fn list(id: &str, shown: String) -> ComboBox<'_> {
    ComboBox::from_id_salt(id)
        .height(LIST_PTS)
        .icon(chevron)
        .popup_style(StyleModifier::new(menu_style))
        .selected_text(shown)
}

fn chevron(ui: &Ui, rect: Rect, _visuals: &WidgetVisuals, _is_open: bool) {
    let centre = rect.center().round();
    let line = [vec2(-3.5, -1.75), vec2(0.0, 1.75), vec2(3.5, -1.75)];
    let points = line.map(|offset| centre + offset).to_vec();
    let stroke = Stroke::new(1.5, ui.visuals().weak_text_color());
    ui.painter().add(Shape::line(points, stroke));
}
