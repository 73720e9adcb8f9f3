//! What is drawn, and how.

use crate::{
    labs::Scene,
    lesson::{Lesson, Stop},
    paint::ThemeKind,
    text::Lang,
};

/// Which steps of the runs become pictures. The words are those of the command line's help.
#[cfg_attr(not(target_arch = "wasm32"), derive(clap::ValueEnum))]
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Steps {
    /// Those that lessons name
    #[default]
    Figures,
    /// Every one
    All,
}

/// How pictures are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub size_px: [u32; 2],
    pub theme: ThemeKind,
    pub lang: Lang,
    /// Which steps are drawn, so that a picture leaves room for what the others say.
    pub steps: Steps,
    /// What is asked is drawn, and what might come, in place of what comes.
    pub asks: bool,
}

/// How it was, and what that and how it is are called.
#[derive(Clone, Copy, Debug)]
pub struct Before<'a> {
    pub stop: &'a Stop,
    pub sides: Option<&'a [String; 2]>,
}

#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The idea in words, over everything.
    pub title: Option<&'a str>,
    pub scene: &'a Scene,
    /// The lesson that the scene is of: its figures are drawn alike.
    pub lesson: Option<&'a Lesson>,
    /// Events folded so far.
    pub step: usize,
    /// How it was: what is shown beside the scene.
    pub before: Option<Before<'a>>,
    /// What stands in its foot: a link, say, where it is printed.
    pub foot: Option<&'a str>,
    pub options: Options,
}

impl Picture<'_> {
    /// How it was, if that is shown, and how it is.
    pub fn stops(&self) -> Vec<(&Scene, usize)> {
        let was = self.before;
        let was = was.and_then(|was| Some((&*was.stop.scene, was.stop.position()?)));
        was.into_iter().chain([(self.scene, self.step)]).collect()
    }

    /// The language in which it is asked what comes, if it is.
    pub fn asked_in(&self) -> Option<Lang> {
        self.options.asks.then_some(self.options.lang)
    }
}
