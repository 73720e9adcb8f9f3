//! Links: what is on the stage as one, and one that is opened, dropped in a picture, or pasted.

use egui::Event;

use crate::lesson::{self, LONG_LINK, LinkError, Stand, link_in, said};

use super::{App, bookmark::FreeScene, keys::Focus, notice::Notice, prelude::*};

/// Segments, or vertices, of a scene that is spelt at every step.
#[cfg(target_arch = "wasm32")]
const MOST_SPELT: usize = 2_000;

impl App {
    /// What is on the stage, as it stands there.
    pub fn link(&self) -> lesson::Link {
        let moment = self.moment();
        self.link_at(self.position(), &moment)
    }

    /// The scene on the stage, where its run stands at this moment.
    pub(super) fn link_at(&self, position: usize, moment: &Moment) -> lesson::Link {
        let stand = Stand {
            scene: self.history.now(),
            position,
            moment,
            step: self.bookmark.lesson().zip(self.bookmark.step()),
        };
        let lang = self.settings.lang;
        let is_own = self.settings.theme == self.lasting_theme();
        let link = stand.link(self.kit.formats);
        // Where the step itself asks, that is how it opens.
        let at = link.at.filter(|_| !self.practice.asks_for_a_step());
        lesson::Link {
            at,
            eye: self.stage.turned_eye(),
            lang: Some(lang).filter(|lang| *lang != self.platform.lang()),
            theme: (!is_own).then(|| self.settings.theme.id().to_owned()),
            ..link
        }
    }

    /// What the address of a page says of the stage: a scene that takes long to spell is not in it, its page is.
    #[cfg(target_arch = "wasm32")]
    pub(super) fn address_link(&self) -> Option<String> {
        let is_large = self.history.now().document().size() > MOST_SPELT;
        if !is_large || self.is_untouched() {
            return self.link().fitting();
        }
        let (lesson, step) = self.bookmark.lesson().zip(self.bookmark.step())?;
        Some(lesson::Link::to_step(&lesson.id, &step.id).to_string())
    }

    /// Puts the link on the system's clipboard: of a scene that is too large, that to its page.
    pub(super) fn copy_link(&mut self, ctx: &Context, now: f64) {
        let whole = self.link();
        let Some(link) = whole.fitting() else {
            self.complain(self.catalog().term("status-link-none"));
            return;
        };
        let address = self.platform.address().unwrap_or_default() + &link;
        let message = Message::new(match address.len() {
            _ if link != whole.to_string() => "status-link-of-page",
            LONG_LINK.. => "status-link-long",
            _ => "status-link-copied",
        });
        self.tell(&message.with("count", address.chars().count()), now);
        ctx.copy_text(address);
    }

    /// Opens what a link leads to; where it leads nowhere, that is said, and all stays as it was.
    pub fn open_link(&mut self, text: &str) {
        self.notices.retain(Notice::is_greeting);
        let link = text.parse().map_err(said);
        if let Err(problems) = link.and_then(|link| self.go_to(&link)) {
            self.report_unfit(&problems);
        }
    }

    fn go_to(&mut self, link: &lesson::Link) -> Result<(), Vec<Problem>> {
        let theme = link.theme.as_ref().map(|id| {
            let (key, value) = ("theme", id.clone());
            ThemeKind::from_id(id).ok_or_else(|| said(LinkError::Value { key, value }))
        });
        let theme = theme.transpose()?;
        let course = &self.bookmark.course;
        let opened = course.open_link(link, self.kit.formats)?;
        let lab = opened.scene.document().lab();
        self.settings.theme = theme.unwrap_or(self.settings.theme);
        match opened.page {
            Some(at) => self.turn_to(|bookmark| bookmark.open(at)),
            None => self.open_page(&FreeScene::of(lab).page()),
        }
        self.history.leave(self.position());
        self.history.replace(opened.scene);
        self.rerecord();
        self.fit();
        self.seek(opened.position);
        if link.at.is_none() {
            self.ask_of_step(false);
        } else if self.practice.asks_for_a_step() {
            // What comes there is shown.
            (self.practice.asked, self.practice.is_on) = (None, false);
        }
        self.stage.see_from(link.eye);
        if let Some(lang) = link.lang {
            self.speak(lang);
        }
        Ok(())
    }

    /// A link that was copied elsewhere opens here, unless text is being written.
    pub(super) fn take_pasted(&mut self, ctx: &Context) {
        if Focus::now(ctx, &self.stage.canvas_ids, &self.stage.handle_ids) == Focus::Text {
            return;
        }
        let pasted = ctx.input(|input| {
            let mut events = input.events.iter();
            events.find_map(|event| match event {
                Event::Paste(text) if lesson::Link::is_one(text) => Some(text.clone()),
                Event::Paste(text) => lesson::link_in(text.as_bytes()),
                _ => None,
            })
        });
        if let Some(link) = pasted {
            self.open_link(&link);
        }
    }

    /// Opens what a picture of ours was drawn of.
    pub(super) fn open_picture(&mut self, name: &str, bytes: &[u8]) {
        match link_in(bytes) {
            Some(link) => self.open_link(&link),
            None => {
                let reason = Message::new("problem-picture-without-link");
                self.report_unread(name, reason.into());
            }
        }
    }
}
