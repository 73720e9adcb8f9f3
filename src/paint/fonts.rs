//! The fonts that are shipped with the program: the same text everywhere, and no boxes.
//!
//! Inter for words, `JetBrains` Mono for codes and numbers. What they lack comes from `DejaVu`
//! (a few signs of mathematics), Noto Sans SC (Chinese) and three transport symbols of our own.
//! The files under `assets/fonts` are cut down to the characters in use; `make.sh` there
//! remakes them, and `tests/glyphs.rs` says when that is due.

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily};

/// A font file by its name, which is also its name to egui.
macro_rules! font {
    ($file:literal) => {
        (
            $file,
            include_bytes!(concat!("../../assets/fonts/", $file)).as_slice(),
        )
    };
}

const FILES: [(&str, &[u8]); 9] = [
    font!("Inter-Regular.otf"),
    font!("Inter-SemiBold.otf"),
    font!("JetBrainsMono-Regular.ttf"),
    font!("DejaVuSans.ttf"),
    font!("DejaVuSans-Bold.ttf"),
    font!("DejaVuSansMono.ttf"),
    font!("NotoSansSC-Regular.otf"),
    font!("NotoSansSC-Bold.otf"),
    font!("ClipscopeSymbols.otf"),
];

const PROPORTIONAL: [&str; 4] = [
    "Inter-Regular.otf",
    "DejaVuSans.ttf",
    "NotoSansSC-Regular.otf",
    "ClipscopeSymbols.otf",
];

const SEMIBOLD: [&str; 4] = [
    "Inter-SemiBold.otf",
    "DejaVuSans-Bold.ttf",
    "NotoSansSC-Bold.otf",
    "ClipscopeSymbols.otf",
];

const MONOSPACE: [&str; 5] = [
    "JetBrainsMono-Regular.ttf",
    "DejaVuSansMono.ttf",
    "DejaVuSans.ttf",
    "NotoSansSC-Regular.otf",
    "ClipscopeSymbols.otf",
];

/// The family for the one thing that matters in a row: Inter's semibold cut.
pub fn semibold() -> FontFamily {
    FontFamily::Name("semibold".into())
}

/// Every font and family, for [`egui::Context::set_fonts`].
///
/// The families are `Proportional`, `Monospace` and [`semibold`]. No font is scaled or shifted:
/// egui sets them on one baseline, and their capitals are alike (0.727 to 0.733 of the size), as
/// are the centres of Noto's Chinese characters.
pub fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in FILES {
        let data = FontData::from_static(bytes);
        fonts.font_data.insert(name.to_owned(), Arc::new(data));
    }
    let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    fonts.families = [
        (FontFamily::Proportional, names(&PROPORTIONAL)),
        (semibold(), names(&SEMIBOLD)),
        (FontFamily::Monospace, names(&MONOSPACE)),
    ]
    .into();
    fonts
}
