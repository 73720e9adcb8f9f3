//! Changes to a lesson that is made: each gives another lesson, or none where it would not fit into the files.

use std::collections::BTreeMap;

use super::super::asking::in_words;
use super::passages::{
    moved, put, with_body, with_name, with_parts, with_passage, with_title, without,
};
use super::statements::{blocks, fields, in_tables, line_break};
use super::{Draft, GOAL, NewStep, REACHED, SCENE, SOURCE, STEP, is_kebab, quoted};
use crate::text::Lang;

impl Draft {
    /// A lesson of one step, with a title in each language that it begins with; `scene` is the step's as a file spells it.
    pub fn begun(
        [lab, source, scene]: [&str; 3],
        titles: BTreeMap<Lang, String>,
        step: &NewStep,
    ) -> Self {
        let (lab, source, name) = (quoted(lab), quoted(source), &step.scene);
        let titled = |(lang, title): (Lang, String)| (lang, format!("# {}\n", title.trim()));
        let mut draft = Self {
            toml: format!("lab = {lab}\nsource = {source}\n\n[scenes.{name}]\n{scene}\n"),
            texts: titles.into_iter().map(titled).collect(),
        };
        draft.put_step(None, step);
        draft
    }

    /// The lesson with a step after another one, or first.
    pub fn with_step(&self, after: Option<&str>, step: &NewStep) -> Option<Self> {
        let is_new = self.step(&step.id).is_none() && is_kebab(&step.id);
        let mut draft = self.clone();
        draft.put_step(after, step).filter(|()| is_new)?;
        Some(draft)
    }

    fn put_step(&mut self, after: Option<&str>, step: &NewStep) -> Option<()> {
        let nl = line_break(&self.toml);
        let at = match after {
            Some(id) => self.step(id)?.lines.end,
            None => self
                .steps()
                .first()
                .map_or(self.toml.len(), |first| first.lines.start),
        };
        let moment = match &*step.at {
            "start" => String::new(),
            at => format!("at = {}{nl}", quoted(at)),
        };
        let lines = format!("[[step]]{nl}id = {}{nl}{moment}", quoted(&step.id));
        let mut shown = self.scenes();
        shown.push((step.id.clone(), step.scene.clone()));
        self.toml = put(&self.toml, at, &lines);
        self.show(&shown);
        let english = step.texts.get(&Lang::En)?;
        for (lang, text) in &mut self.texts {
            let [title, body] = step.texts.get(lang).unwrap_or(english);
            *text = with_passage(text, after.unwrap_or(""), [&step.id, title, body])?;
        }
        Some(())
    }

    /// Sees to it that each of these steps shows its scene, whatever stands before it now.
    fn show(&mut self, wanted: &[(String, String)]) {
        // From the first on: what one says of itself is said of those after it, too.
        for id in self.ids() {
            let wanted = wanted.iter().find(|(step, _)| *step == id);
            if let Some((_, scene)) = wanted
                && self.scene_of(&id).as_ref() != Some(scene)
            {
                self.set(&id, SCENE, Some(&quoted(scene)));
            }
        }
    }

    fn set(&mut self, id: &str, key: &str, value: Option<&str>) -> Option<()> {
        self.toml = self.step(id)?.with(&self.toml, key, value);
        Some(())
    }

    /// The lesson without a step. It keeps one.
    pub fn without_step(&self, id: &str) -> Option<Self> {
        let (mut draft, shown) = (self.clone(), self.scenes());
        draft.toml.replace_range(self.step(id)?.lines, "");
        draft.show(&shown);
        for text in draft.texts.values_mut() {
            *text = without(text, id)?;
        }
        (shown.len() > 1).then_some(draft)
    }

    /// The lesson with a step at this place among its steps, from 0.
    pub fn with_moved(&self, id: &str, to: usize) -> Option<Self> {
        let (mut draft, shown) = (self.clone(), self.scenes());
        let lines = self.step(id)?.lines;
        draft.toml.replace_range(lines.clone(), "");
        let others = draft.steps();
        let after = match to {
            0 => None,
            _ => Some(others.get(to - 1)?),
        };
        let at = match after {
            Some(block) => block.lines.end,
            None => others.first()?.lines.start,
        };
        let after = after.map_or(String::new(), |block| draft.id_of(block));
        draft.toml = put(&draft.toml, at, &self.toml[lines]);
        draft.show(&shown);
        for text in draft.texts.values_mut() {
            *text = moved(text, id, &after)?;
        }
        Some(draft)
    }

    pub fn with_id(&self, id: &str, new: &str) -> Option<Self> {
        let mut draft = self.clone();
        draft.set(id, "id", Some(&quoted(new)))?;
        for text in draft.texts.values_mut() {
            *text = with_name(text, id, new)?;
        }
        (is_kebab(new) && self.step(new).is_none()).then_some(draft)
    }

    /// The lesson with a field of a step, spelt as TOML, or without it.
    pub fn with_field(&self, id: &str, key: &str, value: Option<&str>) -> Option<Self> {
        let mut draft = self.clone();
        draft.set(id, key, value)?;
        Some(draft)
    }

    /// The lesson with another title of a step, or its own where the id is none. A language that has no text begins with the English one.
    pub fn with_title(&self, id: &str, lang: Lang, title: &str) -> Option<Self> {
        Some(self.with_text(lang, with_title(self.text(lang), id, title)?))
    }

    pub fn with_body(&self, id: &str, lang: Lang, body: &str) -> Option<Self> {
        Some(self.with_text(lang, with_body(self.text(lang), id, body)?))
    }

    fn with_text(&self, lang: Lang, text: String) -> Self {
        let mut draft = self.clone();
        draft.texts.insert(lang, text);
        draft
    }

    pub fn with_source(&self, source: &str) -> Option<Self> {
        let mut draft = self.clone();
        let head = blocks(&self.toml, "").into_iter().next()?;
        draft.toml = head.with(&self.toml, SOURCE, Some(&quoted(source)));
        Some(draft)
    }

    /// The lesson with these entries of a list, or without it where there are none.
    pub fn with_list(&self, id: &str, key: &str, entries: &[String]) -> Option<Self> {
        let spelt: Vec<String> = entries.iter().map(|entry| quoted(entry)).collect();
        let spelt = (!spelt.is_empty()).then(|| format!("[{}]", spelt.join(", ")));
        self.with_field(id, key, spelt.as_deref())
    }

    /// The lesson with these parts of a step's goal, or without it where there are none, and a line for each in every text.
    pub fn with_goal(&self, id: &str, parts: &[String]) -> Option<Self> {
        let old = self.list(id, GOAL);
        let mut draft = self.with_list(id, GOAL, parts)?;
        if parts.is_empty() {
            draft = draft.without_reached(id)?;
        }
        for (lang, text) in &mut draft.texts {
            *text = with_parts(text, id, [&old, parts], |part| in_words(part, *lang))?;
        }
        Some(draft)
    }

    /// Without the scene that reaches a goal, where no other step shows it and no text names it.
    fn without_reached(&self, id: &str) -> Option<Self> {
        let Some(name) = self.word_of(id, REACHED) else {
            return Some(self.clone());
        };
        let mut draft = self.with_field(id, REACHED, None)?;
        let is_used = draft.toml.contains(&quoted(&name))
            || draft.texts.values().any(|text| text.contains(&name));
        let block = blocks(&draft.toml, &format!("scenes.{name}"));
        if let Some(block) = block.first().filter(|_| !is_used) {
            draft.toml.replace_range(block.lines.clone(), "");
        }
        Some(draft)
    }

    /// The same lesson with a header for each step, where they stand in one list: `step = [{…}, …]`.
    pub fn in_tables(&self) -> Option<Self> {
        let mut draft = self.clone();
        draft.toml = in_tables(&self.toml, STEP)?;
        Some(draft)
    }

    /// The same of a first part; the scene that reaches it is one more, as a file spells it.
    pub fn with_reached(&self, id: &str, parts: &[String], scene: &str) -> Option<Self> {
        let name = self.fresh(&format!("{id}-reached"));
        let draft = self.with_new_scene(&name, scene)?.with_goal(id, parts)?;
        draft.with_field(id, REACHED, Some(&quoted(&name)))
    }

    /// The lesson with a step that shows a scene of its own; the steps after it show what they did.
    pub fn with_own_scene(&self, id: &str, name: &str, scene: &str) -> Option<Self> {
        let mut draft = self.with_new_scene(name, scene)?;
        let mut shown = self.scenes();
        let own = shown.iter_mut().find(|(step, _)| step == id)?;
        name.clone_into(&mut own.1);
        draft.show(&shown);
        Some(draft)
    }

    /// The lesson with one scene more, as a file spells it.
    pub fn with_new_scene(&self, name: &str, scene: &str) -> Option<Self> {
        let nl = line_break(&self.toml);
        let mut draft = self.clone();
        let scene = scene.replace('\n', nl);
        let at = self.steps().first()?.lines.start;
        draft.toml = put(&self.toml, at, &format!("[scenes.{name}]{nl}{scene}{nl}"));
        Some(draft)
    }

    /// The lesson with another scene of this name. Of what `old` and `new` spell alike nothing is touched, where that `is_right`; else
    /// the whole scene is spelt anew.
    pub fn with_scene(
        &self,
        name: &str,
        [old, new]: [&str; 2],
        is_right: impl Fn(&Self) -> bool,
    ) -> Option<Self> {
        let find = |draft: &Self| {
            blocks(&draft.toml, &format!("scenes.{name}"))
                .into_iter()
                .next()
        };
        let nl = line_break(&self.toml);
        let (old, now) = (fields(old), fields(new));
        let gone = old
            .iter()
            .filter(|(key, _)| now.iter().all(|(known, _)| known != key));
        let gone = gone.map(|(key, _)| (*key, None));
        let other = now.iter().filter(|field| !old.contains(field));
        let other = other.map(|(key, value)| (*key, Some(value.replace('\n', nl))));
        let mut draft = self.clone();
        for (key, value) in gone.chain(other) {
            draft.toml = find(&draft)?.with(&draft.toml, key, value.as_deref());
        }
        if is_right(&draft) {
            return Some(draft);
        }
        let mut draft = self.clone();
        draft.toml = find(self)?.filled(&self.toml, &new.replace('\n', nl));
        Some(draft)
    }
}
