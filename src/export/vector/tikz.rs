//! TikZ: a picture that a LaTeX document takes in, with its labels set by TeX. Pixels go into files beside it.

mod tex;

use std::fmt::Write;

use egui::{Color32, FontFamily, Pos2, pos2};

use crate::{
    algo::polygon::Clipper,
    geom::{Polygon, Window},
    paint::{Image, fonts::semibold},
};

use super::{
    about::About,
    ink::{Ink, roles},
    number::number,
    page::{Drawn, Form, Item, Letter, Path, Picture, Run, Text, VectorPage, What},
};

use tex::{escaped, set};

/// Of a figure's points: one 960 points wide is as wide as a column of text.
const SCALE: f32 = 0.5;

/// The picture, and the images beside it: what their names have behind its own, and what is in them.
pub struct Tikz {
    pub text: String,
    pub images: Vec<(String, Vec<u8>)>,
}

/// `name` is the file's, without its ending: the images' begin so.
pub fn tikz(page: &VectorPage, name: &str, about: About<'_>) -> Tikz {
    let mut writer = Writer {
        page,
        name,
        out: String::new(),
        images: Vec::new(),
        groups: Vec::new(),
    };
    let mut rest = &page.items[..];
    while let Some((first, _)) = rest.split_first() {
        let joins = |item: &&Item| first.joins(item);
        let n = rest.iter().take_while(joins).count().max(1);
        writer.items(&rest[..n]);
        rest = &rest[n..];
    }
    let Writer { out, images, .. } = writer;
    let mut text = head(page, about, !images.is_empty());
    text.push_str(&out);
    text.push_str("\\end{tikzpicture}\n");
    Tikz { text, images }
}

fn head(page: &VectorPage, about: About<'_>, has_images: bool) -> String {
    let mut head = String::new();
    for line in about.alternative.trim_end().lines() {
        let _ = writeln!(head, "% {line}");
    }
    if let Some(link) = about.link {
        let _ = writeln!(head, "% clipscope {link}");
    }
    head.push_str("% \\usepackage{tikz}, then \\input this file");
    if has_images {
        head.push_str("; the PNG files beside it have what is drawn in pixels");
    }
    head.push_str(".\n");
    for (role, colour) in roles(page.theme) {
        let hex = Ink::of(page.theme, colour).hex().to_uppercase();
        let _ = writeln!(
            head,
            "\\definecolor{{cs-{role}}}{{HTML}}{{{}}}",
            hex.trim_start_matches('#')
        );
    }
    let [width, height] = [page.size.x, page.size.y].map(number);
    let _ = writeln!(
        head,
        "\\begin{{tikzpicture}}[x={SCALE}bp, y=-{SCALE}bp, line join=miter, inner sep=0pt, outer sep=0pt]"
    );
    let _ = writeln!(
        head,
        "\\path[use as bounding box] (0,0) rectangle ({width},{height});"
    );
    head
}

struct Writer<'a> {
    page: &'a VectorPage,
    name: &'a str,
    out: String,
    images: Vec<(String, Vec<u8>)>,
    groups: Vec<&'static str>,
}

impl Writer<'_> {
    /// Several are paths that are one.
    fn items(&mut self, items: &[Item]) {
        match &items[0] {
            Item::Begin(name) => {
                self.groups.push(name);
                let _ = writeln!(self.out, "% {name}");
            }
            Item::End => {
                self.groups.pop();
            }
            Item::Drawn(drawn) => self.drawn(drawn, &items[1..]),
        }
    }

    fn drawn(&mut self, drawn: &Drawn, more: &[Item]) {
        if let Some(clip) = drawn.clip {
            let [left, top, right, bottom] =
                [clip.min.x, clip.min.y, clip.max.x, clip.max.y].map(number);
            let _ = writeln!(
                self.out,
                "\\begin{{scope}}\\clip ({left},{top}) rectangle ({right},{bottom});"
            );
        }
        match &drawn.what {
            What::Path(path) => self.path(path, more),
            What::Text(text) => self.text(text),
            What::Picture(picture) => self.picture(picture),
        }
        if drawn.clip.is_some() {
            self.out.push_str("\\end{scope}\n");
        }
    }

    fn path(&mut self, path: &Path, more: &[Item]) {
        let mut options = Vec::new();
        if let Some(colour) = path.fill {
            let (name, faded) = self.colour(colour);
            options.push(format!("fill={name}"));
            options.extend(faded.map(|strength| format!("fill opacity={strength:.3}")));
            let is_area = matches!(path.form, Form::Lines(_)) && !path.form.are_triangles();
            options.extend(is_area.then(|| "even odd rule".to_owned()));
        }
        if let Some((width, colour)) = path.stroke {
            let (name, faded) = self.colour(colour);
            options.push(format!("draw={name}"));
            options.push(format!("line width={}bp", number(SCALE * width)));
            options.extend(faded.map(|strength| format!("draw opacity={strength:.3}")));
        }
        let _ = write!(self.out, "\\path[{}]", options.join(", "));
        self.form(&path.form);
        for item in more {
            if let Some(path) = item.path() {
                self.form(&path.form);
            }
        }
        self.out.push_str(";\n");
    }

    fn form(&mut self, form: &Form) {
        match form {
            Form::Lines(runs) => runs.iter().for_each(|run| self.line(run)),
            Form::Circle(middle, radius) => {
                let [x, y, radius] = [middle.x, middle.y, *radius].map(number);
                let _ = write!(self.out, " ({x},{y}) circle[radius={radius}]");
            }
            Form::Rect(rect, radius) => {
                let [left, top, right, bottom] =
                    [rect.min.x, rect.min.y, rect.max.x, rect.max.y].map(number);
                if *radius > 0.0 {
                    let _ = write!(
                        self.out,
                        " {{[rounded corners={}bp]",
                        number(SCALE * radius)
                    );
                }
                let _ = write!(self.out, " ({left},{top}) rectangle ({right},{bottom})");
                if *radius > 0.0 {
                    self.out.push('}');
                }
            }
        }
    }

    fn line(&mut self, run: &Run) {
        let points = within(run);
        for (i, at) in points.iter().enumerate() {
            let to = if i == 0 { " " } else { " -- " };
            let _ = write!(self.out, "{to}({},{})", number(at.x), number(at.y));
        }
        if run.is_closed && !points.is_empty() {
            self.out.push_str(" -- cycle");
        }
    }

    /// Its name, and how strong it is where that is not at all.
    fn colour(&mut self, colour: Color32) -> (String, Option<f32>) {
        let ink = Ink::of(self.page.theme, colour);
        let name = match ink.role {
            Some(role) => format!("cs-{role}"),
            None => {
                let hex = ink.hex().trim_start_matches('#').to_uppercase();
                let name = format!("cs-{}", hex.to_lowercase());
                let _ = writeln!(self.out, "\\definecolor{{{name}}}{{HTML}}{{{hex}}}");
                name
            }
        };
        (name, (!ink.is_opaque()).then(|| ink.strength()))
    }

    /// A sentence is broken by TeX; numbers end where they end, labels stand about their middle, all else begins where it begins.
    fn text(&mut self, text: &Text) {
        let (Some(first), Some(last)) = (text.letters.first(), text.letters.last()) else {
            return;
        };
        let n_rows = 1 + text
            .letters
            .iter()
            .map(|letter| letter.row)
            .max()
            .unwrap_or_default();
        let right = text
            .letters
            .iter()
            .map(|letter| letter.at.x + letter.advance)
            .fold(last.at.x, f32::max);
        let at = text.turn.place(first.at);
        let is_number = text
            .plain
            .chars()
            .all(|c| c.is_ascii_digit() || "−./∞–".contains(c));
        let (anchor, x) = match self.groups.last() {
            _ if n_rows > 1 => ("base west", at.x),
            Some(&"labels") => ("base", 0.5 * (at.x + right)),
            _ if is_number => ("base east", right),
            _ => ("base west", at.x),
        };
        let (colour, _) = self.colour(largest(text).colour);
        let mut options = vec![format!("anchor={anchor}"), format!("text={colour}")];
        if n_rows > 1 {
            options.push(format!(
                "text width={}bp",
                number(SCALE * (right - at.x + 4.0))
            ));
            options.push("align=left".to_owned());
        }
        if text.turn.radians != 0.0 {
            options.push(format!(
                "rotate={}",
                number(-text.turn.radians.to_degrees())
            ));
        }
        options.push(format!("font={}", font(largest(text))));
        let [x, y] = [x, first_line(text)].map(number);
        let words = if is_code(first) {
            escaped(&text.plain).replace("--", "-")
        } else {
            set(&text.plain)
        };
        let _ = writeln!(
            self.out,
            "\\node[{}] at ({x},{y}) {{{words}}};",
            options.join(", ")
        );
    }

    fn picture(&mut self, picture: &Picture) {
        let nth = self.images.len() + 1;
        let suffix = format!("-{nth}.png");
        let rect = picture.rect;
        let [x, y] = [rect.min.x, rect.min.y].map(number);
        let width = number(SCALE * rect.width());
        let file = format!("{}{suffix}", self.name);
        let _ = writeln!(
            self.out,
            "\\node[anchor=north west] at ({x},{y}) {{\\includegraphics[width={width}bp]{{{file}}}}};"
        );
        self.images
            .push((suffix, Image::to_glass_png(&picture.image)));
    }
}

/// TeX knows no length above some 16,000 points: what reaches farther is cut off out of sight.
fn within(run: &Run) -> Vec<Pos2> {
    const FAR: f32 = 4_000.0;
    let is_near = |at: &Pos2| at.x.abs() <= FAR && at.y.abs() <= FAR;
    if run.points.iter().all(is_near) {
        return run.points.clone();
    }
    let far = f64::from(FAR);
    let points = run.points.iter().map(|at| [at.x, at.y].map(f64::from));
    let polygon = Polygon::new(&points.collect::<Vec<_>>());
    let window = Window::new(-far, -far, far, far);
    let (true, Ok(polygon), Ok(window)) = (run.is_closed, polygon, window) else {
        let clamped = run
            .points
            .iter()
            .map(|at| at.clamp(pos2(-FAR, -FAR), pos2(FAR, FAR)));
        return clamped.collect();
    };
    let mut clipper = Clipper::new(&window.into());
    let clipped = clipper.clip(polygon.vertices());
    let vertices = clipped.vertices().iter();
    vertices.map(|p| pos2(p.x() as f32, p.y() as f32)).collect()
}

/// The line that letters of full size stand on.
fn first_line(text: &Text) -> f32 {
    let largest = largest(text);
    let of_first_row = text
        .letters
        .iter()
        .filter(|letter| letter.row == text.letters[0].row);
    let is_full = |letter: &&Letter| letter.font.size >= largest.font.size;
    let mut full = of_first_row.filter(is_full).map(|letter| letter.at.y);
    full.next().unwrap_or(text.letters[0].at.y)
}

fn is_code(letter: &Letter) -> bool {
    letter.font.family == FontFamily::Monospace
}

/// It stands for all.
fn largest(text: &Text) -> &Letter {
    let by_size = |a: &&Letter, b: &&Letter| a.font.size.total_cmp(&b.font.size);
    let first = &text.letters[0];
    text.letters.iter().rev().max_by(by_size).unwrap_or(first)
}

fn font(letter: &Letter) -> String {
    let size = SCALE * letter.font.size;
    let [size, line] = [size, 1.25 * size].map(number);
    let family = match &letter.font.family {
        FontFamily::Monospace => "\\ttfamily",
        family if *family == semibold() => "\\sffamily\\bfseries",
        FontFamily::Proportional | FontFamily::Name(_) => "\\sffamily",
    };
    format!("\\fontsize{{{size}}}{{{line}}}\\selectfont{family}")
}
