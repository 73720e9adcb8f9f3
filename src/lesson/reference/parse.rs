//! Reads what stands between the braces.

use std::{iter::Peekable, str::Chars};

use crate::{figure::Moment, lesson::prelude::*};

use super::{Expression, Form, Operator, Part, Reference, Root, expression::Function};

/// More digits than a double has.
const MAX_PLACES: usize = 15;
/// An expression in so many parentheses is no sentence's number.
const MAX_DEPTH: usize = 16;

pub fn parse(text: &str) -> Result<Reference, Diagnostic> {
    let clauses = Clauses {
        rest: text,
        next: Some(Clause::Value),
    };
    let mut reference = Reference {
        value: Expression::Number(0.0),
        at: None,
        scene: None,
        method: None,
        form: Form::default(),
    };
    for (clause, text) in clauses {
        match clause {
            Clause::Value => reference.value = expression(text).ok_or_else(unreadable)?,
            Clause::At => reference.at = Some(text.parse::<Moment>()?),
            Clause::Of => reference.scene = Some(text.to_owned()),
            Clause::By => reference.method = Some(text.to_owned()),
            Clause::Form => reference.form = form(text)?,
        }
    }
    Ok(reference)
}

pub fn unreadable() -> Diagnostic {
    Diagnostic::new(Message::new("problem-bad-reference")).noting(Message::new("expect-reference"))
}

fn form(text: &str) -> Result<Form, Diagnostic> {
    let places = text.parse().ok().filter(|&n: &usize| n <= MAX_PLACES);
    let named = Form::WORDS.into_iter().find(|(word, _)| *word == text);
    let form = named.map(|(_, form)| form).or(places.map(Form::Places));
    form.ok_or_else(|| {
        let message = Message::new("problem-unknown-form").with("name", clipped(text));
        let words = Form::WORDS.map(|(word, _)| word);
        let notes = suggestion(nearest(text, words), &words);
        notes
            .into_iter()
            .fold(Diagnostic::new(message), Diagnostic::noting)
    })
}

#[derive(Clone, Copy, PartialEq)]
enum Clause {
    Value,
    At,
    Of,
    By,
    Form,
}

impl Clause {
    const MARKS: [(&'static str, Self); 4] = [
        ("@", Self::At),
        (" of ", Self::Of),
        (" by ", Self::By),
        (":", Self::Form),
    ];
}

/// The clauses of a reference, each without its mark.
struct Clauses<'t> {
    rest: &'t str,
    next: Option<Clause>,
}

impl<'t> Iterator for Clauses<'t> {
    type Item = (Clause, &'t str);

    fn next(&mut self) -> Option<Self::Item> {
        let clause = self.next.take()?;
        let is_quoted = |at: usize| self.rest[..at].matches('"').count() % 2 == 1;
        let first = |(mark, clause): (&str, Clause)| {
            let mut found = self.rest.match_indices(mark).map(|(at, _)| at);
            found
                .find(|&at| !is_quoted(at))
                .map(|at| (at, mark.len(), clause))
        };
        let end = Clause::MARKS
            .into_iter()
            .filter_map(first)
            .min_by_key(|&(at, ..)| at);
        let Some((at, length, following)) = end else {
            return Some((clause, self.rest.trim()));
        };
        let text = &self.rest[..at];
        self.rest = &self.rest[at + length..];
        self.next = Some(following);
        Some((clause, text.trim()))
    }
}

/// `None` where it is none, or goes on after its end.
fn expression(text: &str) -> Option<Expression> {
    let mut reader = Reader {
        chars: text.chars().peekable(),
        depth: 0,
    };
    let read = reader.sum()?;
    reader.peek().is_none().then_some(read)
}

struct Reader<'t> {
    chars: Peekable<Chars<'t>>,
    depth: usize,
}

impl Reader<'_> {
    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        while self.chars.next_if(|c| c.is_whitespace()).is_some() {}
        self.chars.peek().copied()
    }

    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.peek().filter(|c| wanted.contains(c))?;
        self.chars.next()
    }

    fn sum(&mut self) -> Option<Expression> {
        self.joined(&['+', '-', '−'], Self::product)
    }

    fn product(&mut self) -> Option<Expression> {
        self.joined(&['*', '/'], Self::factor)
    }

    fn joined(
        &mut self,
        signs: &[char],
        part: fn(&mut Self) -> Option<Expression>,
    ) -> Option<Expression> {
        let mut left = part(self)?;
        while let Some(sign) = self.take(signs) {
            let operator = match sign {
                '+' => Operator::Plus,
                '*' => Operator::Times,
                '/' => Operator::Over,
                _ => Operator::Minus,
            };
            left = Expression::Joined(operator, Box::new([left, part(self)?]));
        }
        Some(left)
    }

    fn factor(&mut self) -> Option<Expression> {
        self.depth += 1;
        let read = (self.depth <= MAX_DEPTH).then(|| self.one())?;
        self.depth -= 1;
        read
    }

    fn one(&mut self) -> Option<Expression> {
        if self.take(&['-', '−']).is_some() {
            return Some(Expression::Negated(Box::new(self.factor()?)));
        }
        if self.take(&['(']).is_some() {
            return self.closed(Self::sum);
        }
        if self.peek()?.is_ascii_digit() {
            let digits = self.while_next(|c| c.is_ascii_digit() || c == '.');
            return digits.parse().ok().map(Expression::Number);
        }
        if self.take(&['"']).is_some() {
            let name = self.while_next(|c| c != '"');
            self.take(&['"'])?;
            return self.path(Root::Name(name));
        }
        let name = self.while_next(is_of_name);
        if name == "events" && self.take(&['(']).is_some() {
            let words = self.while_next(|c| c != ')');
            self.take(&[')'])?;
            return Some(Expression::Events(words.split_whitespace().collect()));
        }
        if self.take(&['(']).is_some() {
            let (_, function) = Function::ALL.into_iter().find(|(word, _)| *word == name)?;
            let arguments = self.closed(Self::arguments)?;
            return Some(Expression::Call(function, arguments));
        }
        self.path(match &name[..] {
            "" => return None,
            "event" => Root::Event,
            "output" => Root::Output,
            "cost" => Root::Cost,
            "scene" => Root::Scene,
            "steps" => Root::Steps,
            "differs" => Root::Differs,
            _ => Root::Name(name),
        })
    }

    fn closed<T>(&mut self, inner: fn(&mut Self) -> Option<T>) -> Option<T> {
        let read = inner(self)?;
        self.take(&[')'])?;
        Some(read)
    }

    fn arguments(&mut self) -> Option<Vec<Expression>> {
        let mut arguments = vec![self.sum()?];
        while self.take(&[',']).is_some() {
            arguments.push(self.sum()?);
        }
        Some(arguments)
    }

    fn path(&mut self, root: Root) -> Option<Expression> {
        let mut parts = Vec::new();
        loop {
            if self.take(&['.']).is_some() {
                let name = self.while_next(is_of_name);
                parts.push(Part::Field((!name.is_empty()).then_some(name)?));
            } else if self.take(&['[']).is_some() {
                let digits = self.while_next(|c| c.is_ascii_digit());
                self.take(&[']'])?;
                parts.push(Part::Entry(digits.parse().ok()?));
            } else {
                return Some(Expression::Path { root, parts });
            }
        }
    }

    fn while_next(&mut self, is_part: fn(char) -> bool) -> String {
        let mut text = String::new();
        while let Some(c) = self.chars.next_if(|&c| is_part(c)) {
            text.push(c);
        }
        text
    }
}

/// May a name have this without quotation marks?
fn is_of_name(c: char) -> bool {
    !c.is_whitespace() && !"+-−*/()[],.\"".contains(c)
}
