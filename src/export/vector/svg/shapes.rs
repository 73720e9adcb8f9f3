//! Paths: neighbours that are drawn alike are one element.

use std::fmt::Write;

use crate::{
    export::vector::{
        ink::Ink,
        number::number,
        page::{Form, Path, Run},
    },
    paint::Theme,
};

use super::attributes::ink_class;

pub fn write(out: &mut String, theme: &Theme, paths: &[&Path]) {
    let Some(first) = paths.first() else { return };
    let style = style(theme, first);
    match (&first.form, paths) {
        (Form::Circle(middle, radius), _) => {
            let [x, y, radius] = [middle.x, middle.y, *radius].map(number);
            let _ = writeln!(out, "<circle{style} cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>");
        }
        (Form::Rect(rect, radius), [_]) => {
            let [x, y, width, height] =
                [rect.min.x, rect.min.y, rect.width(), rect.height()].map(number);
            let round = if *radius > 0.0 {
                format!(" rx=\"{}\"", number(*radius))
            } else {
                String::new()
            };
            let _ = writeln!(
                out,
                "<rect{style} x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"{round}/>"
            );
        }
        (Form::Lines(_) | Form::Rect(..), _) => {
            let mut data = String::new();
            for path in paths {
                match &path.form {
                    Form::Lines(runs) => runs.iter().for_each(|run| line(&mut data, run)),
                    Form::Rect(rect, _) => {
                        let [x, y, width, height] =
                            [rect.min.x, rect.min.y, rect.width(), rect.height()].map(number);
                        let _ = write!(data, "M{x} {y}h{width}v{height}H{x}z");
                    }
                    Form::Circle(..) => {}
                }
            }
            let is_area = first.fill.is_some() && matches!(first.form, Form::Lines(_));
            let rule = if is_area && !first.form.are_triangles() {
                " fill-rule=\"evenodd\""
            } else {
                ""
            };
            let _ = writeln!(out, "<path{style}{rule} d=\"{data}\"/>");
        }
    }
}

fn line(data: &mut String, run: &Run) {
    for (i, at) in run.points.iter().enumerate() {
        let letter = match i {
            0 => "M",
            1 => "L",
            _ => " ",
        };
        let _ = write!(data, "{letter}{} {}", number(at.x), number(at.y));
    }
    if run.is_closed {
        data.push('z');
    }
}

fn style(theme: &Theme, path: &Path) -> String {
    let mut classes = Vec::new();
    let mut attributes = String::new();
    if let Some(colour) = path.fill {
        let (class, own) = ink_class(Ink::of(theme, colour), "", "fill");
        classes.extend(class);
        attributes.push_str(&own);
    } else {
        attributes.push_str(" fill=\"none\"");
    }
    if let Some((width, colour)) = path.stroke {
        let (class, own) = ink_class(Ink::of(theme, colour), "s-", "stroke");
        classes.extend(class);
        let _ = write!(attributes, "{own} stroke-width=\"{}\"", number(width));
    }
    if !classes.is_empty() {
        attributes = format!(" class=\"{}\"{attributes}", classes.join(" "));
    }
    attributes
}
