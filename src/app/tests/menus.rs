//! Menus: what is clicked in them.

use super::*;

impl Bench {
    /// Everything with a name in the last frames: what a screen reader would hear, and where it lies.
    pub(super) fn named(&mut self) -> Vec<(String, Rect)> {
        self.ctx.enable_accesskit();
        self.frame(0.1, Vec::new());
        self.names.clone()
    }

    fn where_is(&mut self, name: &str) -> Option<Rect> {
        let mut named = self.named().into_iter();
        named.find(|(known, _)| known == name).map(|(_, rect)| rect)
    }

    pub(super) fn found(&mut self, name: &str) -> Rect {
        let rect = self.where_is(name);
        rect.unwrap_or_else(|| panic!("no {name} in {:?}", self.names))
    }

    pub(super) fn click_on(&mut self, name: &str) {
        let at = self.found(name).center();
        self.press_at(at);
    }
}

fn n_segments(bench: &Bench) -> usize {
    bench.scene::<lines::Scene>().segments().len()
}

#[test]
fn random_numbers_are_typed_and_another_set_follows() {
    let mut bench = Bench::new(SIZE);
    bench.open_menus(&["Scene", "Random segments"]);
    bench.type_into("How many", "30");
    assert!(bench.where_is("How many").is_some(), "the menu stays open");
    bench.click_on("Replace all segments");
    assert_eq!(n_segments(&bench), 30);
    assert!(bench.where_is("How many").is_none());
    bench.open_menus(&["Scene", "Random segments"]);
    let mut seen = vec![bench.app.scene().clone()];
    for _ in 0..3 {
        bench.click_on("Another set, from the next seed");
        assert!(!seen.contains(bench.app.scene()));
        seen.push(bench.app.scene().clone());
    }
}

/// Each row of a list of methods, all of it in sight, and the groups that they stand in.
#[test]
fn lists_of_methods_show_all_rows_whole_and_what_is_wrong_apart() {
    for (lang, theme, size) in [
        (Lang::En, ThemeKind::Light, SIZE),
        (Lang::Es, ThemeKind::Light, vec2(1024.0, 768.0)),
        (Lang::Es, ThemeKind::Projector, vec2(1024.0, 768.0)),
    ] {
        let mut bench = Bench::seen(lang, theme, size);
        bench.command(Command::Lab("frustum"));
        let catalog = Catalog::of(lang);
        let on_stage = catalog.term(bench.document().methods()[0].name_key);
        let texts = bench.texts();
        let button = texts.iter().find(|(text, _)| *text == on_stage);
        bench.press_at(button.expect("the method's name").1.center());
        let texts = bench.texts();
        let top = |key: &str| {
            let said = catalog.term(key);
            let rows = texts.iter().filter(|(text, _)| *text == said);
            rows.map(|(_, rect)| rect.top()).reduce(f32::max)
        };
        let methods = (bench.document().lab().methods)();
        for card in methods.iter().filter(|card| !card.is_faulty) {
            assert!(top(card.name_key).is_some(), "{lang}: {}", card.id);
            let heading = card.group_key.and_then(top);
            assert!(heading.is_some(), "{lang}: over {}", card.id);
        }
        assert!(top("faulty-title") < top("alg-undivided-texture"));
    }
}

#[test]
fn wherever_the_pointer_is_in_a_menu_it_is_on_a_row() {
    let mut bench = Bench::new(SIZE);
    bench.click_on("Scene");
    let [undo, redo] = ["Undo", "Redo"].map(|name| {
        let mut named = bench.named().into_iter();
        let found = named.find(|(known, _)| known.starts_with(name));
        found.expect("a row").1
    });
    assert_eq!(undo.bottom(), redo.top());
    assert_eq!(undo.x_range(), redo.x_range());
}

#[test]
fn whoever_leaves_a_menu_by_its_key_goes_on_from_its_button() {
    let mut bench = Bench::new(SIZE);
    bench.click_on("Scene");
    bench.key(Key::Tab);
    let row = bench.ctx.memory(egui::Memory::focused);
    bench.key(Key::Escape);
    let button = bench.ctx.memory(egui::Memory::focused);
    assert!(button.is_some() && button != row, "{button:?} {row:?}");
    bench.key(Key::Enter);
    assert!(
        bench
            .named()
            .iter()
            .any(|(name, _)| name.starts_with("Undo"))
    );
}

#[test]
fn what_has_no_room_in_the_bar_is_in_a_menu() {
    for (size, menu) in [(vec2(360.0, 640.0), "More"), (SIZE, "Scene")] {
        let mut bench = Bench::new(size);
        let in_the_bar = bench.where_is("Compare with…").is_some();
        bench.click_on(menu);
        if menu == "More" {
            assert!(bench.where_is("1×").is_some(), "the speed");
            bench.click_on("Scene");
        }
        let all = bench.named();
        let n = all.iter().filter(|(name, _)| name == "Compare with…");
        assert_eq!(n.count(), 1, "{size}: once, in the bar: {in_the_bar}");
    }
}

#[test]
fn the_number_of_the_step_is_there_however_narrow_the_window() {
    for width in [320.0, 420.0, 640.0, 1280.0] {
        for is_presenting in [false, true] {
            let mut bench = Bench::new(vec2(width, 480.0));
            if is_presenting {
                bench.command(Command::Present);
            }
            bench.command(Command::Seek(2));
            let n_steps = bench.n_steps();
            let said = [format!("step 2 of {n_steps}"), format!("2 / {n_steps}")];
            let texts = bench.texts();
            let is_said = texts.iter().any(|(text, _)| said.contains(text));
            assert!(is_said, "{width}, {is_presenting}: {texts:?}");
        }
    }
}
