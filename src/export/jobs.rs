//! The figures of lessons and scenes: what is drawn of each, and to which file.

use std::path::Path;

use crate::{
    figure::Moment,
    labs::Scene,
    lesson::{Lesson, LessonStep, Link, SceneFile, SceneFormats, Stand},
    paint::Theme,
    text::Lang,
};

use super::{
    animation::Reel,
    figure::{Before, Options, Picture, Steps, Studio},
    format::Format,
    shapes::{Made, Shapes, shapes},
    vector::Letters,
};

#[derive(Clone, Copy, Debug)]
pub enum Source<'a> {
    Step(&'a Lesson, &'a LessonStep),
    File(&'a SceneFile),
}

#[derive(Clone, Debug)]
pub struct Job<'a> {
    pub source: Source<'a>,
    pub position: usize,
    moment: Moment,
    /// Path below the output folder: `03-outcodes/nine-regions.png`.
    pub path: String,
    pub format: Format,
    /// Of a loop the first step and the last one, where that is not its whole run.
    span: Option<[usize; 2]>,
}

impl<'a> Source<'a> {
    pub fn scene(self) -> &'a Scene {
        match self {
            Self::Step(_, step) => &step.drawn().scene,
            Self::File(file) => &file.scene,
        }
    }
}

/// In the order of the course.
pub fn jobs<'a>(lessons: impl IntoIterator<Item = &'a Lesson>, steps: Steps) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    for lesson in lessons {
        for step in &lesson.steps {
            if let Some(figure) = &step.figure {
                let stem = format!("{}/{figure}", lesson.id);
                jobs.extend(jobs_of(Source::Step(lesson, step), &stem, steps));
            }
        }
    }
    jobs
}

/// The pictures of one scene, of which the paths begin so.
pub fn jobs_of<'a>(source: Source<'a>, stem: &str, steps: Steps) -> Vec<Job<'a>> {
    let job = |position, moment, path| Job {
        source,
        position,
        moment,
        path,
        format: Format::Png,
        span: None,
    };
    match steps {
        Steps::Figures => {
            let (position, moment) = match source {
                Source::Step(_, step) => (step.drawn().position(), &step.drawn().moment),
                Source::File(file) => (Some(file.position), &file.moment),
            };
            let path = format!("{stem}.png");
            let job = position.map(|position| job(position, moment.clone(), path));
            job.into_iter().collect()
        }
        Steps::All => {
            let runs = source.scene().document().record();
            let run = runs.first();
            let path = |step| format!("{stem}-{step:03}.png");
            let at_step = |step| Some(job(step, run?.moment(step), path(step)));
            let n_steps = run.map_or(0, |run| run.n_steps());
            (0..=n_steps).filter_map(at_step).collect()
        }
    }
}

/// Each picture in another format: `03-outcodes/nine-regions.svg`.
pub fn in_format(mut jobs: Vec<Job<'_>>, format: Format) -> Vec<Job<'_>> {
    for job in &mut jobs {
        let path = Path::new(&job.path).with_extension(format.extension());
        job.path = path.to_string_lossy().into_owned();
        job.format = format;
    }
    jobs
}

/// How files are written.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a> {
    pub options: Options,
    pub letters: Letters,
    /// The address of a page that links are opened on: then they are printed in the pictures' feet, too.
    pub page: Option<&'a str>,
}

/// What a run of a figure has no moment for.
#[derive(Debug)]
pub struct Missing {
    pub path: String,
    pub moment: Moment,
}

/// Of all steps of runs, those from one moment to another; of loops these alone.
pub fn between<'a>(jobs: Vec<Job<'a>>, [from, to]: &[Moment; 2]) -> Result<Vec<Job<'a>>, Missing> {
    let mut within = Vec::new();
    let mut known: Option<(*const Scene, [usize; 2])> = None;
    for mut job in jobs {
        let scene = job.source.scene();
        let span = match known {
            Some((last, span)) if std::ptr::eq(last, scene) => span,
            _ => {
                let runs = scene.document().record();
                let find = |moment: &Moment| {
                    let found = runs.first().and_then(|run| run.find(moment));
                    found.ok_or_else(|| Missing {
                        path: job.path.clone(),
                        moment: moment.clone(),
                    })
                };
                let [first, last] = [find(from)?, find(to)?];
                [first.min(last), first.max(last)]
            }
        };
        known = Some((scene, span));
        if job.format.is_loop() {
            job.span = Some(span);
            within.push(job);
        } else if (span[0]..=span[1]).contains(&job.position) {
            within.push(job);
        }
    }
    Ok(within)
}

impl Way<'_> {
    /// With text as text, for whoever has the program.
    pub const fn of(options: Options) -> Self {
        Self {
            options,
            letters: Letters::Fonts,
            page: None,
        }
    }
}

impl Job<'_> {
    /// What the step's figure shows; of a picture that asks, and of each of all moments, the step's title.
    pub fn title(&self, options: Options) -> Option<&str> {
        let lang = options.lang;
        match self.source {
            Source::Step(lesson, step) => {
                let is_shown = !options.asks && options.steps == Steps::Figures;
                lesson.step_heading(lesson.step_index(&step.id)?, lang, is_shown)
            }
            Source::File(_) => None,
        }
    }

    pub fn picture(&self, options: Options) -> Picture<'_> {
        Picture {
            title: self.title(options),
            scene: self.source.scene(),
            lesson: match self.source {
                Source::Step(lesson, _) => Some(lesson),
                Source::File(_) => None,
            },
            step: self.position,
            before: match self.source {
                Source::Step(lesson, step) => step.before.as_ref().map(|stop| Before {
                    stop,
                    sides: lesson.step_sides(step, options.lang),
                }),
                Source::File(_) => None,
            },
            foot: None,
            options,
        }
    }

    /// To what the picture shows.
    pub fn link(&self, options: Options) -> Option<String> {
        let stand = Stand {
            scene: self.source.scene(),
            position: self.position,
            moment: &self.moment,
            step: match self.source {
                Source::Step(lesson, step) => Some((lesson, step)),
                Source::File(_) => None,
            },
        };
        let lang = Some(options.lang).filter(|lang| *lang != Lang::default());
        let link = stand.link(SceneFormats::standard());
        Link { lang, ..link }.fitting()
    }

    fn link_on(&self, way: Way<'_>) -> Option<String> {
        let link = self.link(way.options)?;
        Some(way.page.unwrap_or_default().to_owned() + &link)
    }

    pub const fn is_loop(&self) -> bool {
        self.format.is_loop()
    }

    /// Are both pictures of one lesson?
    pub fn is_beside(&self, other: &Self) -> bool {
        match (self.source, other.source) {
            (Source::Step(a, _), Source::Step(b, _)) => a.id == b.id,
            _ => false,
        }
    }

    /// The file's bytes, with the link to what it shows.
    pub fn bytes(&self, studio: &mut Studio, way: Way<'_>) -> Vec<u8> {
        self.made(studio, way).bytes
    }

    /// The same, with the files that belong to it.
    pub fn made(&self, studio: &mut Studio, way: Way<'_>) -> Made {
        let link = self.link_on(way);
        let link = link.as_deref();
        let mut options = way.options;
        if self.format.is_run() {
            // One eye sees all of it.
            options.steps = Steps::All;
        }
        let picture = Picture {
            foot: link.filter(|_| way.page.is_some()),
            ..self.picture(options)
        };
        match self.format {
            Format::Png | Format::Frames => studio.draw(&picture).to_linked_png(link).into(),
            Format::Apng | Format::Gif => self.animation(studio, &picture, link).into(),
            Format::Svg => shapes(studio, &picture, Shapes::Svg(way.letters), link),
            Format::Pdf => shapes(studio, &picture, Shapes::Pdf, link),
            Format::Tikz => {
                let name = Path::new(&self.path).file_stem().unwrap_or_default();
                let name = name.to_string_lossy();
                shapes(studio, &picture, Shapes::Tikz(&name), link)
            }
        }
    }

    /// Its run as a loop.
    fn animation(&self, studio: &mut Studio, picture: &Picture<'_>, link: Option<&str>) -> Vec<u8> {
        let options = picture.options;
        let runs = self.source.scene().document().record();
        let n_steps = runs.first().map_or(0, |run| run.n_steps());
        let [first, last] = self.span.unwrap_or([0, n_steps]);
        let pictures = (first..=last).map(|step| {
            studio.draw(&Picture {
                step,
                foot: picture.foot,
                ..self.picture(options)
            })
        });
        let reel = Reel {
            n_pictures: last - first + 1,
            pictures,
            theme: Theme::of(options.theme),
            link,
        };
        if self.format == Format::Gif {
            reel.gif()
        } else {
            reel.apng()
        }
    }
}
