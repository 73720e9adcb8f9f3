//! A lesson that is being made: its files as they are written, and changes to them that leave all else byte for byte as hands wrote
//! it. A change that would not fit into the files is none.

mod changed;
mod passages;
mod statements;

use std::{collections::BTreeMap, io::ErrorKind, sync::Arc};

use toml::de::DeValue;

use crate::labs::Scene;

use super::{
    files::{FileError, Files, LESSON_FILE},
    lesson_file,
    names::is_kebab,
    prelude::*,
    scene_file::{SceneFormats, quoted},
};

use passages::passage;
use statements::{Block, blocks};

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Draft {
    toml: String,
    texts: BTreeMap<Lang, String>,
}

/// A step to be put into a lesson.
#[derive(Clone, Debug)]
pub struct NewStep {
    pub id: String,
    pub scene: String,
    pub at: String,
    /// Title and text in each language; one that is missing is given in English.
    pub texts: BTreeMap<Lang, [String; 2]>,
}

const STEP: &str = "step";
const SOURCE: &str = "source";
const SCENE: &str = "scene";
const GOAL: &str = "goal";
const REACHED: &str = "reached";

impl Draft {
    /// The files of a lesson; none of text that is no UTF-8.
    pub fn read(files: &dyn Files, lesson: &str) -> Result<Self, FileError> {
        let read = |name: &str| {
            let bytes = files.read(&format!("{lesson}/{name}"))?;
            String::from_utf8(bytes).map_err(|_| FileError::Unreadable(NOT_TEXT))
        };
        let mut texts = BTreeMap::new();
        for lang in Lang::ALL {
            match read(&text_file(lang)) {
                Ok(text) => {
                    texts.insert(lang, text);
                }
                Err(FileError::Unreadable(reason))
                    if reason.kind() == ErrorKind::NotFound && lang != Lang::En => {}
                Err(error) => return Err(error),
            }
        }
        Ok(Self {
            toml: read(LESSON_FILE)?,
            texts,
        })
    }

    /// Each file by its name.
    pub fn files(&self) -> impl Iterator<Item = (String, &str)> {
        let texts = self.texts.iter();
        let texts = texts.map(|(lang, text)| (text_file(*lang), &**text));
        [(LESSON_FILE.to_owned(), &*self.toml)]
            .into_iter()
            .chain(texts)
    }

    /// The lesson with these files in the place of those that it has, and of no other lesson any.
    pub fn over<'a>(&'a self, lesson: &'a str, files: &'a dyn Files) -> impl Files + 'a {
        Over {
            draft: self,
            lesson,
            files,
        }
    }

    fn steps(&self) -> Vec<Block> {
        blocks(&self.toml, STEP)
    }

    fn id_of(&self, block: &Block) -> String {
        self.word(block, "id").unwrap_or_default()
    }

    fn step(&self, id: &str) -> Option<Block> {
        self.steps()
            .into_iter()
            .find(|block| self.id_of(block) == id)
    }

    fn word(&self, block: &Block, key: &str) -> Option<String> {
        block.value(&self.toml, key).map(unquoted)
    }

    /// The steps' ids, in order.
    pub fn ids(&self) -> Vec<String> {
        self.steps().iter().map(|block| self.id_of(block)).collect()
    }

    /// Each step with the scene that it shows.
    pub fn scenes(&self) -> Vec<(String, String)> {
        let mut scene = String::new();
        let steps = self.steps();
        let shown = steps.iter().map(|block| {
            scene = self
                .word(block, SCENE)
                .unwrap_or_else(|| std::mem::take(&mut scene));
            (self.id_of(block), scene.clone())
        });
        shown.collect()
    }

    /// Does another step show the scene of this one?
    pub fn shares_scene(&self, id: &str) -> bool {
        let shown = self.scenes();
        let own = shown.iter().find(|(step, _)| step == id);
        let shows = |scene: &String| shown.iter().filter(|(_, it)| it == scene).count();
        own.is_some_and(|(_, scene)| shows(scene) > 1)
    }

    pub fn scene_of(&self, id: &str) -> Option<String> {
        let mut scenes = self.scenes().into_iter();
        scenes.find(|(step, _)| step == id).map(|(_, scene)| scene)
    }

    /// The value of a step's field, as it is written.
    pub fn field(&self, id: &str, key: &str) -> Option<&str> {
        self.step(id)?.value(&self.toml, key)
    }

    /// What it says.
    pub fn word_of(&self, id: &str, key: &str) -> Option<String> {
        self.field(id, key).map(unquoted)
    }

    pub fn speaks(&self, lang: Lang) -> bool {
        self.texts.contains_key(&lang)
    }

    /// The text in this language, else in English.
    fn text(&self, lang: Lang) -> &str {
        let own = self.texts.get(&lang).or_else(|| self.texts.get(&Lang::En));
        own.map_or("", |text| text)
    }

    /// Title and text of a step; the lesson's title where the id is none.
    pub fn passage(&self, id: &str, lang: Lang) -> [String; 2] {
        let text = self.text(lang);
        let written = |at: Range<usize>| text[at].replace("\r\n", "\n");
        passage(text, id).map_or_else(Default::default, |it| [it.title, it.body].map(written))
    }

    /// A name that is made of this one and that nothing in the lesson has.
    pub fn fresh(&self, stem: &str) -> String {
        let stem = if is_kebab(stem) { stem } else { STEP };
        let is_taken = |name: &str| {
            let scene = !blocks(&self.toml, &format!("scenes.{name}")).is_empty();
            let mut steps = self.steps().into_iter();
            let known = |block: Block| {
                ["id", "was", "figure"]
                    .iter()
                    .any(|key| self.word(&block, key).as_deref() == Some(name))
            };
            scene || steps.any(known)
        };
        let names = (1..).map(|n| {
            if n == 1 {
                stem.to_owned()
            } else {
                format!("{stem}-{n}")
            }
        });
        let mut names = names.filter(|name| !is_taken(name));
        names.next().unwrap_or_default()
    }

    /// Who said it first, and when.
    pub fn source(&self) -> String {
        let head = blocks(&self.toml, "");
        let source = head.first().and_then(|head| self.word(head, SOURCE));
        source.unwrap_or_default()
    }

    /// The entries of a step's field that is a list of texts.
    pub fn list(&self, id: &str, key: &str) -> Vec<String> {
        let value = self
            .field(id, key)
            .and_then(|value| DeValue::parse(value).ok());
        let entries = value.as_ref().and_then(|value| value.get_ref().as_array());
        let text = |entry: &toml::Spanned<DeValue<'_>>| entry.get_ref().as_str().map(str::to_owned);
        entries.into_iter().flatten().filter_map(text).collect()
    }

    /// What another version of the lesson has in its files: of each that differs the name, and the first such line with its number.
    pub fn others<'a>(&self, other: &'a Self) -> Vec<(String, usize, &'a str)> {
        let differs = |(name, theirs): (String, &'a str)| {
            let own = self.files().find(|(known, _)| *known == name);
            let mut own = own.map_or("", |(_, text)| text).lines();
            let mut lines = theirs.lines().map(Some).chain([None]).enumerate();
            let first = lines.find(|(_, line)| own.next() != *line);
            first.map(|(i, line)| (name, i + 1, line.unwrap_or_default()))
        };
        other.files().filter_map(differs).collect()
    }

    /// A scene by its name, whatever else is wrong; `files` are those of the lesson.
    pub fn scene(
        &self,
        name: &str,
        (lesson, files): (&str, &dyn Files),
        formats: SceneFormats,
    ) -> Option<Arc<Scene>> {
        let source = Source {
            folder: Some((files, lesson)),
            ..Source::new(String::new(), self.toml.as_bytes())
        };
        lesson_file::scene(formats, name, &Sink::new(&source))
    }
}

/// What a spelt value says; of what is no text, the spelling.
fn unquoted(value: &str) -> String {
    let read = DeValue::parse(value).ok();
    let text = read.as_ref().and_then(|value| value.get_ref().as_str());
    text.unwrap_or(value).to_owned()
}

fn text_file(lang: Lang) -> String {
    format!("{lang}.md")
}

const NOT_TEXT: crate::text::SystemError =
    crate::text::SystemError::of_kind(ErrorKind::InvalidData);

/// A draft before the files that it is of.
struct Over<'a> {
    draft: &'a Draft,
    lesson: &'a str,
    files: &'a dyn Files,
}

impl Over<'_> {
    fn own(&self, path: &str) -> Option<&str> {
        let name = path.strip_prefix(self.lesson)?.strip_prefix('/')?;
        let mut files = self.draft.files();
        files.find(|(known, _)| known == name).map(|(_, text)| text)
    }
}

impl Files for Over<'_> {
    fn list(&self) -> Result<Vec<String>, FileError> {
        let mut paths = self.files.list()?;
        // A text that is gone from the draft is gone, whatever lies on the disk.
        paths.retain(|path| match path.split_once('/') {
            Some((lesson, name)) => {
                lesson == self.lesson && Lang::ALL.iter().all(|&lang| text_file(lang) != name)
            }
            None => false,
        });
        let own = self.draft.files();
        paths.extend(own.map(|(name, _)| format!("{}/{name}", self.lesson)));
        Ok(paths)
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        self.own(path).map_or_else(
            || self.files.read(path),
            |text| Ok(text.as_bytes().to_vec()),
        )
    }

    fn shown(&self, path: &str) -> String {
        self.files.shown(path)
    }
}
