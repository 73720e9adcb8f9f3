//! Polygons to start from.

/// A polygon with a name.
pub struct Preset {
    /// As menus name it: a catalogue key.
    pub name_key: &'static str,
    /// Its outline.
    pub outline: &'static [[f64; 2]],
    /// Its holes.
    pub holes: &'static [&'static [[f64; 2]]],
}

/// In the order of the menu; all of them lie about the window from (−1, −1) to (1, 1).
pub static PRESETS: [Preset; 0] = [];
