//! The words of every lab's part of the window.

pub(super) use egui::{Button, RichText, Ui};

pub(super) use crate::{
    labs::{self, Edit, Lab},
    paint::theme,
    text::{Message, Value},
    widgets::{Look, form_button, menu_button, quiet_button},
};

pub(super) use super::bench::{self, Bench, Measuring};
pub(super) use super::fields::{Seeded, count_slider, number_field};
pub(super) use super::lab_panel::{LabPanel, PanelAsk};
pub(super) use super::plots::{PowerLine, power_plot, row_bars};
