//! The words of every file that tells a method: what is drawn, what is said, and the table of its steps.

pub use crate::{
    figure::{
        Body, Cell, Link, ListColumn, ListRow, Lists, Mark, Mark3, Pixel, Raster, RasterMark,
        RasterShape, Role, Run, Shape, Shape3, Table, TableNote, TableRow,
        Tick::{Accept, Cut, Phase, Reject, Test},
        Tiles, View, Watch, WatchRow, WatchSection,
    },
    text::{Formula, Message, Value},
    trace::{Recording, Step, silent},
};

pub use super::{
    Answer, AtStep, CodeLine, Verdict,
    card::{MethodCard, code_line},
    recorded::Recorded,
    telling::{AnswerAsItIs, At, Each, Named, Row, Telling, Watched, table},
    words::{
        end_link, end_name, end_name_now, equal_to, name, numbered, subscript, sum_of, sym, times,
    },
};

pub(in crate::labs) use super::card::{but_for, mistakes, pseudocode};
