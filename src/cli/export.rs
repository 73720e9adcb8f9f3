//! `clipscope export`: figures to files.

use std::{path::PathBuf, process::ExitCode, str::FromStr};

use clap::ValueEnum;

use crate::text::Lang;

use super::{Outcome, lang_parser, say::say_text};

const EXAMPLES: &str = "\
Examples:
  clipscope export --out figures
  clipscope export 02-cohen-sutherland --out slides --theme projector --scale 2
  clipscope export --out figuras --lang pt-BR --steps all

The same input gives the same bytes on every machine. A file is written whole or not at all.";

/// What it accepts.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lessons of the embedded course by name, or lesson folders; all of the course where none is given
    #[arg(value_name = "LESSON")]
    pub lessons: Vec<PathBuf>,
    /// The folder to write to; it is made where it is not there
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// File formats
    #[arg(long, value_enum, value_delimiter = ',', default_value = "png")]
    pub format: Vec<Format>,
    /// Width and height in points
    #[arg(long, value_name = "WxH", default_value = "1920x1080")]
    pub size: Size,
    /// Pixels a point
    #[arg(long, value_name = "N", default_value_t = 1.0, value_parser = scale)]
    pub scale: f32,
    /// Colours
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    pub theme: Theme,
    /// Language of labels and captions
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    pub lang: Lang,
    /// The figures that lessons name, or every step of every run
    #[arg(long, value_enum, default_value_t = Steps::Figures)]
    pub steps: Steps,
    /// The whole window of the app instead of the stage alone
    #[arg(long)]
    pub window: bool,
}

/// A file format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Format {
    /// Pixels
    Png,
}

/// A theme by name.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Theme {
    /// Ink on paper
    Light,
    /// For a dark room
    Dark,
    /// Large and high in contrast
    Projector,
}

/// Which steps become files.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Steps {
    /// Those that lessons name
    Figures,
    /// Every one
    All,
}

/// Width and height in points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Size {
    /// Points across.
    pub width: u32,
    /// Points down.
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || {
            format!("expected WIDTHxHEIGHT from 64x64 to {MAX_SIDE}x{MAX_SIDE}, such as 1920x1080")
        };
        let (width, height) = text.split_once(['x', '×']).ok_or_else(expected)?;
        let side = |text: &str| match text.parse() {
            Ok(side @ 64..=MAX_SIDE) => Ok(side),
            _ => Err(expected()),
        };
        Ok(Self {
            width: side(width)?,
            height: side(height)?,
        })
    }
}

/// A picture of this side at scale 1 takes 1 GiB in memory: nothing prints larger.
const MAX_SIDE: u32 = 16_384;

fn scale(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(scale) if (0.25..=8.0).contains(&scale) => Ok(scale),
        _ => Err("expected a number from 0.25 to 8".to_owned()),
    }
}

/// Draws the figures.
pub(super) fn export(_args: &Args) -> ExitCode {
    say_text("not built yet");
    Outcome::Unusable.into()
}
