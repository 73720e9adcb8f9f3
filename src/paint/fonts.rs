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

type File = (&'static str, &'static [u8]);

const FILES: [File; 7] = [
    font!("Inter-Regular.otf"),
    font!("Inter-SemiBold.otf"),
    font!("JetBrainsMono-Regular.ttf"),
    font!("DejaVuSans.ttf"),
    font!("DejaVuSans-Bold.ttf"),
    font!("DejaVuSansMono.ttf"),
    font!("ClipscopeSymbols.otf"),
];

/// What only Chinese needs. They are as large as all else that a page is made of but the program.
mod chinese {
    use super::File;

    #[cfg(not(target_arch = "wasm32"))]
    const FILES: [File; 2] = [
        font!("NotoSansSC-Regular.otf"),
        font!("NotoSansSC-Bold.otf"),
    ];

    #[cfg(not(target_arch = "wasm32"))]
    pub const fn files() -> &'static [File] {
        &FILES
    }

    #[cfg(target_arch = "wasm32")]
    pub use fetched::files;

    /// A page fetches them from beside itself.
    #[cfg(target_arch = "wasm32")]
    pub mod fetched {
        use std::sync::OnceLock;

        use super::File;

        pub const NAMES: [&str; 2] = ["NotoSansSC-Regular.otf", "NotoSansSC-Bold.otf"];

        static FILES: OnceLock<[File; 2]> = OnceLock::new();

        pub fn files() -> &'static [File] {
            FILES.get().map_or(&[], |files| files)
        }

        /// From now on they are there, for as long as the page is.
        pub fn add(files: [Vec<u8>; 2]) {
            let [regular, bold] = files.map(|bytes| &*bytes.leak());
            FILES.get_or_init(|| [(NAMES[0], regular), (NAMES[1], bold)]);
        }
    }
}

#[cfg(target_arch = "wasm32")]
pub use chinese::fetched as chinese_fonts;

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

/// The fonts of a family by name and bytes: a character is the first one's that has it.
pub fn of_family(family: &FontFamily) -> Vec<(&'static str, &'static [u8])> {
    let names: &[&str] = match family {
        FontFamily::Proportional => &PROPORTIONAL,
        FontFamily::Monospace => &MONOSPACE,
        FontFamily::Name(_) => &SEMIBOLD,
    };
    let here = || FILES.iter().chain(chinese::files());
    let file = |name: &&str| here().find(|(known, _)| known == name).copied();
    names.iter().filter_map(file).collect()
}

/// No font is scaled or shifted: their capitals are alike (0.727 to 0.733 of the size), on one baseline.
pub fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for &(name, bytes) in FILES.iter().chain(chinese::files()) {
        let data = FontData::from_static(bytes);
        fonts.font_data.insert(name.to_owned(), Arc::new(data));
    }
    let is_here = |name: &&&str| fonts.font_data.contains_key(**name);
    let names = |names: &[&str]| {
        let here = names.iter().filter(is_here);
        here.map(|&name| name.to_owned()).collect()
    };
    fonts.families = [
        (FontFamily::Proportional, names(&PROPORTIONAL)),
        (semibold(), names(&SEMIBOLD)),
        (FontFamily::Monospace, names(&MONOSPACE)),
    ]
    .into();
    fonts
}
