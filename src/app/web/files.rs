//! Files of a page: chosen or dropped ones are read into memory, what is written is a download.

use std::{
    cell::RefCell,
    collections::BTreeMap,
    path::Path,
    rc::Rc,
    sync::{Arc, Mutex, PoisonError},
};

use egui::{Context, DroppedFileHandle};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, BlobPropertyBag, File, HtmlAnchorElement, HtmlInputElement, Url, window};

use crate::{
    export,
    lesson::{FileError, MAX_SCENE_BYTES},
    paint::{Image, fonts::chinese_fonts},
    text::{Diagnostic, Lang, Message, Part, SystemError},
};

use super::super::{
    dialog::{Answer, Question},
    platform::{Platform, Reader, StageFigure, drawn},
};

use super::beside::Beside;
use super::host::{first_settings, is_so};

type Read = Result<Vec<u8>, FileError>;

pub struct PageFiles {
    /// With the fonts that were there when it drew first.
    studio: Option<export::Studio>,
    has_chinese: bool,
    beside: Beside,
    /// By their names: a page is told no more of where a file lies.
    held: Arc<Mutex<BTreeMap<String, Read>>>,
    answer: Rc<RefCell<Option<Answer>>>,
    arrived: Rc<RefCell<Vec<DroppedFileHandle>>>,
}

const UNSUPPORTED: SystemError = SystemError::of_kind(std::io::ErrorKind::Unsupported);

impl PageFiles {
    pub fn new(beside: Beside) -> Self {
        Self {
            studio: None,
            has_chinese: false,
            beside,
            held: Arc::default(),
            answer: Rc::default(),
            arrived: Rc::default(),
        }
    }
}

fn hold(held: &Mutex<BTreeMap<String, Read>>, name: String, read: Read) {
    let mut held = held.lock().unwrap_or_else(PoisonError::into_inner);
    held.insert(name, read);
}

impl Platform for PageFiles {
    fn has_fingers(&self) -> bool {
        is_so("(pointer: coarse)")
    }

    fn wants_stillness(&self) -> bool {
        is_so("(prefers-reduced-motion: reduce)")
    }

    fn fetch(&mut self, part: Part) -> bool {
        self.beside.fetch_part(part)
    }

    fn fetched(&mut self) -> Vec<(Part, bool)> {
        self.beside.take_fetched()
    }

    fn has_dialogs(&self) -> bool {
        true
    }

    fn has_paths(&self) -> bool {
        false
    }

    fn lang(&self) -> Lang {
        first_settings().lang
    }

    fn address(&self) -> Option<String> {
        let here = window()?.location();
        let course = here.search().ok().unwrap_or_default();
        let mut parts = course.trim_start_matches('?').split('&');
        let course = parts.find(|part| part.starts_with("course="));
        let course = course
            .map(|course| format!("?{course}"))
            .unwrap_or_default();
        Some(here.origin().ok()? + &here.pathname().ok()? + &course)
    }

    fn ask(&mut self, question: &Question, ctx: &Context) {
        let (held, answer, ctx) = (Arc::clone(&self.held), Rc::clone(&self.answer), ctx.clone());
        let said = move |said: Answer| {
            *answer.borrow_mut() = Some(said);
            ctx.request_repaint();
        };
        if choose(question.endings, held, said.clone()).is_err() {
            said(Answer::Cancelled);
        }
    }

    fn answer(&mut self) -> Option<Answer> {
        self.answer.borrow_mut().take()
    }

    fn arrived(
        &mut self,
        dropped: Vec<DroppedFileHandle>,
        ctx: &Context,
    ) -> Vec<DroppedFileHandle> {
        if !dropped.is_empty() {
            let (held, arrived, ctx) = (
                Arc::clone(&self.held),
                Rc::clone(&self.arrived),
                ctx.clone(),
            );
            spawn_local(async move {
                // A mesh is opened with the files that were dropped with it.
                for file in &dropped {
                    let read = file.bytes_async().await;
                    let read = read.map_err(|_| FileError::Unreadable(UNSUPPORTED));
                    hold(&held, file.path().display().to_string(), within(read));
                }
                arrived.borrow_mut().extend(dropped);
                ctx.request_repaint();
            });
        }
        self.arrived.take()
    }

    fn reader(&self) -> Reader {
        let held = Arc::clone(&self.held);
        Box::new(move |path: &Path, _| {
            let held = held.lock().unwrap_or_else(PoisonError::into_inner);
            let name = path.display().to_string();
            match held.get(&name) {
                Some(Ok(bytes)) => Ok(bytes.clone()),
                Some(Err(FileError::TooLarge { limit })) => {
                    Err(FileError::TooLarge { limit: *limit })
                }
                Some(Err(_)) => Err(FileError::Unreadable(UNSUPPORTED)),
                None => Err(std::io::Error::from(std::io::ErrorKind::NotFound).into()),
            }
        })
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic> {
        download(path, bytes).map_err(|_| UNSUPPORTED)?;
        Ok(path.to_owned())
    }

    fn draw(&mut self, picture: StageFigure<'_>, ctx: &Context) -> Result<Image, Diagnostic> {
        let has_chinese = !chinese_fonts::files().is_empty();
        if std::mem::replace(&mut self.has_chinese, has_chinese) != has_chinese {
            self.studio = None;
        }
        if picture.figures.lang == Lang::ZhCn && !has_chinese {
            self.beside.fetch_fonts(ctx);
            return Err(Message::new("status-fonts-coming").into());
        }
        let texts = Part::Texts(picture.figures.lang);
        if !texts.is_here() {
            self.beside.fetch_part(texts);
            let what = picture.figures.lang.native_name().to_owned();
            return Err(Message::new("status-coming").with("what", what).into());
        }
        Ok(drawn(&mut self.studio, picture))
    }
}

fn within(read: Read) -> Read {
    let limit = MAX_SCENE_BYTES;
    read.and_then(|bytes| {
        if bytes.len() as u64 > limit {
            return Err(FileError::TooLarge { limit });
        }
        Ok(bytes)
    })
}

/// Lets the browser ask for files. What it is asked with lies in the page until it has been answered: some forget one that does not.
fn choose(
    endings: &[&str],
    held: Arc<Mutex<BTreeMap<String, Read>>>,
    said: impl Fn(Answer) + Clone + 'static,
) -> Result<(), JsValue> {
    let document = window().and_then(|window| window.document());
    let document = document.ok_or(JsValue::NULL)?;
    let input: HtmlInputElement = document.create_element("input")?.dyn_into()?;
    let accepted: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    // A mesh may be chosen with its material and its picture.
    let more = if endings.contains(&"obj") {
        ",.mtl,.png,.jpg,.jpeg"
    } else {
        ""
    };
    input.set_type("file");
    input.set_accept(&(accepted.join(",") + more));
    input.set_multiple(!more.is_empty());
    input.set_hidden(true);
    document.body().ok_or(JsValue::NULL)?.append_child(&input)?;
    let (chosen, cancelled) = (input.clone(), said.clone());
    let changed = Closure::once_into_js(move || {
        let files = chosen.files();
        let n_files = files.as_ref().map_or(0, web_sys::FileList::length);
        let files: Vec<File> = (0..n_files)
            .filter_map(|i| files.as_ref()?.get(i))
            .collect();
        chosen.remove();
        spawn_local(async move { said(read_all(files, &held).await) });
    });
    let left = input.clone();
    let gone = Closure::once_into_js(move || {
        left.remove();
        cancelled(Answer::Cancelled);
    });
    input.add_event_listener_with_callback("change", changed.unchecked_ref())?;
    input.add_event_listener_with_callback("cancel", gone.unchecked_ref())?;
    input.click();
    Ok(())
}

/// Reads files; which of them was chosen: the mesh, where others came with it.
async fn read_all(files: Vec<File>, held: &Mutex<BTreeMap<String, Read>>) -> Answer {
    let names: Vec<String> = files.iter().map(File::name).collect();
    for file in files {
        let name = file.name();
        let read = if file.size() > MAX_SCENE_BYTES as f64 {
            let limit = MAX_SCENE_BYTES;
            Err(FileError::TooLarge { limit })
        } else {
            let bytes = JsFuture::from(file.array_buffer()).await;
            let bytes = bytes.map(|bytes| Uint8Array::new(&bytes).to_vec());
            bytes.map_err(|_| FileError::Unreadable(UNSUPPORTED))
        };
        hold(held, name, read);
    }
    let is_mesh = |name: &&String| name.to_lowercase().ends_with(".obj");
    let chosen = names.iter().find(is_mesh).or(names.first());
    chosen.map_or(Answer::Cancelled, |name| Answer::Chosen(name.clone()))
}

fn download(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = window().and_then(|window| window.document());
    let document = document.ok_or(JsValue::NULL)?;
    let about = BlobPropertyBag::new();
    about.set_type(match name.rsplit_once('.') {
        Some((_, "png")) => "image/png",
        Some((_, "json")) => "application/json",
        _ => "text/plain",
    });
    let parts = Array::of1(&Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence_and_options(&parts, &about)?;
    let url = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = document.create_element("a")?.dyn_into()?;
    link.set_href(&url);
    link.set_download(name);
    link.click();
    // The browser has taken it up by then.
    let forget = Closure::once_into_js(move || Url::revoke_object_url(&url));
    let window = window().ok_or(JsValue::NULL)?;
    window.set_timeout_with_callback_and_timeout_and_arguments_0(forget.unchecked_ref(), 60_000)?;
    Ok(())
}
