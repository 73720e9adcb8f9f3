//! The camera's picture beside the observer's, as large: with a double click on it, or a key.

use crate::{
    figure::{ColumnLayout, Layout, Need, Stand},
    widgets::rect_of,
};

use super::{App, prelude::*};

impl App {
    /// Is the camera's picture as large as the observer's? Another lesson begins with a small one.
    pub(super) fn has_large_picture(&self) -> bool {
        self.shown.large_picture == Some(self.whereabouts())
    }

    pub(super) fn turn_picture(&mut self, now: f64) {
        if !self.has_small_picture() {
            return self.tell(&Message::new("no-picture"), now);
        }
        let is_large = self.has_large_picture();
        self.shown.large_picture = (!is_large).then(|| self.whereabouts());
    }

    /// Does a method on the stage show what the camera sees?
    pub(super) fn has_small_picture(&self) -> bool {
        let mut needs = self.playback.needs.iter().flatten();
        needs.any(|need| need.stand == Stand::Inset)
    }
}

/// The camera's picture as large as the observer's space, in each column.
pub fn enlarge_pictures(needs: &mut [Vec<Need>]) {
    for need in needs.iter_mut().flatten() {
        let is_equal = need.stand == Stand::Inset;
        *need = Need {
            is_equal,
            ..need.enlarged()
        };
    }
}

/// Is the camera's picture, enlarged, still no match for the observer's?
pub fn is_cramped(layout: &Layout, needs: &[Vec<Need>]) -> bool {
    let mut columns = layout.columns.iter().zip(needs);
    columns.any(|(places, needs)| is_cramped_in(places, needs))
}

fn is_cramped_in(places: &ColumnLayout, needs: &[Need]) -> bool {
    let area = |id| places.slot(id).map(|slot| rect_of(slot).area());
    let observer = places.views.first().and_then(|&(id, _)| area(id));
    let pictures = needs.iter().filter(|need| need.is_equal);
    let mut sizes = pictures.filter_map(|need| area(need.id).zip(observer));
    places.overlaps() || sizes.any(|(picture, observer)| picture < 0.5 * observer)
}
