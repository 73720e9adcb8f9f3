//! The kinds of files that figures are written to.

/// What kind of file a figure is written to. The words are those of the command line's help.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Pixels
    Png,
    /// Shapes and text, for books, slides and web pages
    Svg,
    /// The same for printers and LaTeX: a page for each figure
    Pdf,
    /// The same for LaTeX alone, with labels that TeX sets
    Tikz,
    /// The whole run of each figure as a loop of pictures: an animated PNG
    Apng,
    /// The same as a GIF, for programs that play nothing else
    Gif,
    /// The whole run of each figure as numbered PNG files, for a film
    Frames,
}

impl Format {
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Tikz => "tikz",
            Self::Apng => "apng",
            Self::Gif => "gif",
            Self::Frames => "png",
        }
    }

    /// Pictures of all steps of a run, to be seen one after the other.
    pub const fn is_run(self) -> bool {
        self.is_loop() || matches!(self, Self::Frames)
    }

    /// The same in one file.
    pub const fn is_loop(self) -> bool {
        match self {
            Self::Apng | Self::Gif => true,
            Self::Png | Self::Svg | Self::Pdf | Self::Tikz | Self::Frames => false,
        }
    }
}
