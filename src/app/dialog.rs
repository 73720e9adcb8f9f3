//! What lies over the window: the list of keys, the question where to save, messages.

/// A dialog that is open.
#[derive(Clone, PartialEq, Debug)]
pub enum Dialog {
    /// The list of keys.
    Help,
    /// Where to save the scene.
    Save {
        /// As it is being written.
        path: String,
    },
    /// Where to export the figure.
    Export {
        /// As it is being written.
        path: String,
    },
}
