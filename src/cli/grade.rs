//! `clipscope grade`: a program's answers against the true ones.

use std::{
    fs::{self, File},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
    process::ExitCode,
};

use clap::ValueEnum;

use crate::{
    case::Solvers,
    export::{Drawn, draw_graded, write_whole},
    grade::{self, GradeError, Options, Picture, Report, Tolerance, Totals},
    text::{Catalog, Diagnostic, Lang, Message},
};

use super::{
    Outcome, lang_parser, say,
    say::{not_written, print, unreadable},
    source::Source,
    usage::Expected,
};

const EXAMPLES: &str = "\
Examples:
  python3 mine.py < cases.ndjson | clipscope grade cases.ndjson -
  clipscope grade cases.ndjson answers.ndjson --figure wrong.png
  clipscope grade cases.ndjson answers.ndjson --report prairielearn --out results
  clipscope grade cases.ndjson all.ndjson --submissions > reports.ndjson
  clipscope grade --merge reports-*.ndjson

Cases are those of `trace`, and answers have the shape of its answers: \"id\", \"output\" and, as far as the program tells
any, \"events\". Where answers say whose they are (\"submission\"), each submission gets a report of its own, as a line of JSON.

Exit status: 0 all right, 1 not all, 2 wrong usage or a file that cannot be opened; of --report kattis 42 all right,
43 not all, anything else a mistake of the judge.";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// A file of cases, one JSON object a line; `-` is standard input
    #[arg(value_name = "CASES", required_unless_present = "merge")]
    cases: Option<PathBuf>,
    /// A file of a program's answers, one JSON object a line; `-` is standard input
    #[arg(value_name = "ANSWERS", required_unless_present = "merge")]
    answers: Option<PathBuf>,
    /// For whom the report is [default: text on a terminal, json elsewhere]
    #[arg(long, value_enum)]
    report: Option<Form>,
    /// Write the report to a file in this folder; it is made where it is not there
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Draw the first case that is wrong
    #[arg(long, value_name = "FILE")]
    figure: Option<PathBuf>,
    /// How much a number may be off, of one that is larger than 1 as a part of it
    #[arg(long, value_name = "T", default_value = "1e-9", value_parser = tolerance)]
    tolerance: Tolerance,
    /// Every answer says whose it is: where there are no answers, there is no submission
    #[arg(long)]
    submissions: bool,
    /// Exit with 0 also where not all is right
    #[arg(long)]
    wrong_ok: bool,
    /// Sum up reports that were written as JSON; without files those of standard input
    #[arg(
        long,
        value_name = "REPORTS",
        num_args = 0..,
        conflicts_with_all = ["cases", "answers", "report", "out", "figure", "submissions"]
    )]
    merge: Option<Vec<PathBuf>>,
    /// Language of sentences
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// Sentences
    Text,
    /// One JSON object a line
    Json,
    /// XML for build servers
    Junit,
    /// `results.json` of PrairieLearn
    Prairielearn,
    /// `results.json` of Gradescope
    Gradescope,
    /// An output validator of Kattis and ICPC: `teammessage.txt` and the exit status
    Kattis,
}

impl Form {
    const fn file(self) -> &'static str {
        match self {
            Self::Text => "report.txt",
            Self::Json => "report.ndjson",
            Self::Junit => "junit.xml",
            Self::Prairielearn | Self::Gradescope => "results.json",
            Self::Kattis => "teammessage.txt",
        }
    }
}

fn tolerance(text: &str) -> Result<Tolerance, Expected> {
    let tolerance = text.parse().ok().and_then(Tolerance::new);
    tolerance.ok_or_else(|| Expected(Message::new("usage-expected-tolerance")))
}

pub(super) fn grade(args: &Args) -> ExitCode {
    if let Some(files) = &args.merge {
        return merge(files, args.lang).into();
    }
    let (Some(cases), Some(answers)) = (&args.cases, &args.answers) else {
        return Outcome::Unusable.into();
    };
    match graded(cases, answers, args) {
        Ok(verdict) => verdict.status(args),
        Err(outcome) => outcome.into(),
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Verdict {
    AllRight,
    NotAll,
}

impl Verdict {
    fn status(self, args: &Args) -> ExitCode {
        let is_judge = args.report == Some(Form::Kattis);
        ExitCode::from(match self {
            Self::AllRight if is_judge => 42,
            Self::NotAll if is_judge => 43,
            Self::NotAll if !args.wrong_ok => 1,
            Self::AllRight | Self::NotAll => 0,
        })
    }
}

fn graded(cases: &Path, answers: &Path, args: &Args) -> Result<Verdict, Outcome> {
    let lang = args.lang;
    let stdin = Path::new("-");
    if cases == stdin && answers == stdin {
        say(lang, &Message::new("grade-both-stdin"));
        return Err(Outcome::Unusable);
    }
    let open =
        |path: &Path| Source::open(path, lang).map_err(|error| unreadable(path, error, lang));
    let (own_cases, own_answers) = (open(cases)?, open(answers)?);
    let mut press = Press::open(args)?;
    let mut verdict = Verdict::AllRight;
    let options = Options {
        tolerance: args.tolerance,
        of_many: args.submissions,
    };
    let solvers = Solvers::standard();
    let done = grade::grade(solvers, own_cases, own_answers, options, |report| {
        if !report.is_all_right() {
            verdict = Verdict::NotAll;
        }
        press.print(report)
    });
    let done = done.and_then(|()| press.finish().map_err(GradeError::Report));
    match done {
        Ok(()) => Ok(verdict),
        Err(GradeError::Cases(error)) => Err(unreadable(cases, error, lang)),
        Err(GradeError::Answers(error)) => Err(unreadable(answers, error, lang)),
        Err(GradeError::Report(error)) if error.kind() == io::ErrorKind::Unsupported => {
            say(lang, &Message::new("grade-one-at-a-time"));
            Err(Outcome::Unusable)
        }
        // It has been said of which figure.
        Err(GradeError::Report(error)) if error.kind() == io::ErrorKind::Other => {
            Err(Outcome::Unusable)
        }
        Err(GradeError::Report(error)) => match &args.out {
            Some(out) => Err(unwritten(&out.join(press.form.file()), error, lang)),
            None => match not_written(error, lang) {
                // Whoever read the reports has gone.
                Outcome::Done => Ok(verdict),
                outcome => Err(outcome),
            },
        },
    }
}

fn unwritten(path: &Path, error: io::Error, lang: Lang) -> Outcome {
    let message = Message::new("grade-not-written")
        .with("path", path.display().to_string())
        .with("reason", Diagnostic::from(error));
    say(lang, &message);
    Outcome::Unusable
}

/// Where reports go.
struct Press<'a> {
    args: &'a Args,
    form: Form,
    catalog: &'static Catalog,
    /// No figure has been drawn yet.
    is_first: bool,
    /// A file grows under another name until it is whole.
    out: BufWriter<Box<dyn Write>>,
}

impl<'a> Press<'a> {
    fn open(args: &'a Args) -> Result<Self, Outcome> {
        use std::io::IsTerminal;
        let by_default = if args.out.is_none() && io::stdout().is_terminal() {
            Form::Text
        } else {
            Form::Json
        };
        let form = args.report.unwrap_or(by_default);
        let out: Box<dyn Write> = match &args.out {
            None => Box::new(io::stdout()),
            Some(out) => {
                let growing = growing(out, form);
                let made = fs::create_dir_all(out).and_then(|()| File::create(&growing));
                Box::new(made.map_err(|error| unwritten(&growing, error, args.lang))?)
            }
        };
        Ok(Self {
            args,
            form,
            catalog: Catalog::of(args.lang),
            is_first: true,
            out: BufWriter::new(out),
        })
    }

    fn print(&mut self, report: &Report) -> io::Result<()> {
        let drawn = self.draw(report)?;
        let (catalog, out) = (self.catalog, &mut self.out);
        let is_of_many = report.submission.is_some();
        match self.form {
            Form::Text => grade::write_text(report, catalog, out),
            Form::Json => grade::write_json(report, catalog, out),
            Form::Junit | Form::Prairielearn | Form::Gradescope | Form::Kattis if is_of_many => {
                Err(io::ErrorKind::Unsupported.into())
            }
            Form::Junit => grade::write_junit(report, catalog, out),
            Form::Prairielearn => {
                let picture = drawn
                    .as_ref()
                    .map(|(png, alternative)| Picture { png, alternative });
                let results = grade::prairielearn(report, picture.as_ref(), catalog);
                writeln!(out, "{results:#}")
            }
            Form::Gradescope => {
                let results = grade::gradescope(report, catalog);
                writeln!(out, "{results:#}")
            }
            Form::Kattis => grade::write_text(report, catalog, out),
        }
    }

    /// The first wrong case of all, where somebody asks to see it.
    fn draw(&mut self, report: &Report) -> io::Result<Option<(Vec<u8>, String)>> {
        let team_image = self.args.out.as_ref().filter(|_| self.form == Form::Kattis);
        let team_image = team_image.map(|out| out.join("teamimage.png"));
        let files: Vec<&PathBuf> = self.args.figure.iter().chain(&team_image).collect();
        if !self.is_first || (files.is_empty() && self.form != Form::Prairielearn) {
            return Ok(None);
        }
        let Some(Drawn { image, alternative }) =
            draw_graded(report, Solvers::standard(), self.args.lang)
        else {
            return Ok(None);
        };
        self.is_first = false;
        let png = image.to_png();
        for file in files {
            write_whole(file, &png).map_err(|error| {
                unwritten(file, error, self.args.lang);
                io::Error::from(io::ErrorKind::Other)
            })?;
        }
        Ok(Some((png, alternative)))
    }

    fn finish(&mut self) -> io::Result<()> {
        self.out.flush()?;
        match &self.args.out {
            Some(out) => fs::rename(growing(out, self.form), out.join(self.form.file())),
            None => Ok(()),
        }
    }
}

impl Drop for Press<'_> {
    /// What has not become whole is not left behind.
    fn drop(&mut self) {
        if let Some(out) = &self.args.out {
            drop(fs::remove_file(growing(out, self.form)));
        }
    }
}

fn growing(out: &Path, form: Form) -> PathBuf {
    out.join(format!(".{}.part", form.file()))
}

fn merge(files: &[PathBuf], lang: Lang) -> Outcome {
    let stdin = [PathBuf::from("-")];
    let files = if files.is_empty() { &stdin[..] } else { files };
    let mut totals = Totals::new();
    let mut n_refused = 0;
    for file in files {
        let refuse = |line| {
            n_refused += 1;
            let message = Message::new("grade-no-report")
                .with("path", file.display().to_string())
                .with("line", line);
            say(lang, &message);
        };
        let source = Source::open(file, lang);
        if let Err(error) = source.and_then(|source| grade::merge(&mut totals, source, refuse)) {
            return unreadable(file, error, lang);
        }
    }
    let printed = serde_json::to_string(&totals).map_or(Outcome::Unusable, |totals| {
        print(&format!("{totals}\n"), lang)
    });
    if printed == Outcome::Done && n_refused > 0 {
        Outcome::Refused
    } else {
        printed
    }
}
