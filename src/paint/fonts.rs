//! The shipped fonts. Inter for words, `JetBrains` Mono for codes and numbers; what they lack comes from `DejaVu`, Noto
//! Sans SC and symbols of our own. `assets/fonts/make.sh` cuts them down to the characters in use.

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily};

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

pub fn semibold() -> FontFamily {
    FontFamily::Name("semibold".into())
}

/// No font is scaled or shifted: their capitals are alike (0.727 to 0.733 of the size), on one baseline.
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
