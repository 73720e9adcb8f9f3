//! Pictures of the screen over each other, at one scale: what each way of working puts there.

use crate::text::{Message, Value};

use super::{Mark, Role};

/// Screens from top to bottom. Each shows the square from −1 to 1, and as much beside it as all of them do.
#[derive(Clone, PartialEq, Debug)]
pub struct Screens {
    /// At least one.
    pub screens: Vec<Screen>,
}

/// One of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Screen {
    /// Over it: "Clip first".
    pub title: Value,
    /// After the title: what is seen there.
    pub note: Message,
    /// Of the note.
    pub role: Role,
    /// After the divide.
    pub marks: Vec<Mark>,
}

impl Screens {
    /// What is seen of the plane of the screen.
    pub const SEEN: [[f64; 2]; 2] = [[-2.5, -1.3], [2.5, 1.3]];
}
