//! What is known of a method without running it.

use crate::text::Value;

#[derive(Clone, Copy, Debug)]
pub struct MethodCard {
    /// As the command line, JSON and lesson files spell it; unique among all labs.
    pub id: &'static str,
    pub name_key: &'static str,
    /// Author and year.
    pub source: &'static str,
    pub code: &'static [CodeLine],
    /// Is it wrong on purpose, to be compared with the right one?
    pub is_faulty: bool,
    /// Does it show where a formula comes from, and answers nothing?
    pub is_proof: bool,
    /// The key of the heading under which lists of methods have it; those without one come first.
    pub group_key: Option<&'static str>,
}

impl MethodCard {
    pub const fn name(&self) -> Value {
        Value::Term(self.name_key)
    }

    /// The key of its name; while it is asked what is wrong, one that does not tell.
    pub const fn name_asked(&self, is_asked: bool) -> &'static str {
        if is_asked && self.is_faulty {
            "faulty-unnamed"
        } else {
            self.name_key
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct CodeLine {
    /// Levels of indentation.
    pub depth: usize,
    /// Catalogue key of the line as code: `code-…`.
    pub code: &'static str,
    /// Catalogue key of the line in words: `words-…`.
    pub words: &'static str,
}

pub const fn code_line(depth: usize, code: &'static str, words: &'static str) -> CodeLine {
    CodeLine { depth, code, words }
}

/// Pseudocode, line after line: what a line is called in its file, how deep it is, and its two keys.
macro_rules! pseudocode {
    ($($line:ident: $depth:literal, $code:literal, $words:literal;)+) => {
        #[allow(non_camel_case_types, clippy::upper_case_acronyms, reason = "the names of lines")]
        enum Place { $($line),+ }

        $(
            #[allow(dead_code, reason = "on some lines no step stands")]
            pub const $line: usize = Place::$line as usize;
        )+

        pub const LINES: [CodeLine; [$($depth),+].len()] = [$(code_line($depth, $code, $words)),+];
    };
}

pub(super) use pseudocode;

/// A table of mistakes. Of each: its id, its name, what is said at the first step that the right method does not do, and the lines
/// of pseudocode that are other ones.
macro_rules! mistakes {
    ($variant:path: $($rules:ident {
        $id:literal, $name_key:literal, $differs_key:literal;
        $($code:ident = $right:ident but $($line:path: $as_code:literal $in_words:literal),+;)+
    })+) => { $(
        impl $variant for $rules {
            const ID: &'static str = $id;
            const NAME_KEY: &'static str = $name_key;
            const DIFFERS_KEY: Option<&'static str> = Some($differs_key);
            $(const $code: &'static [CodeLine] = &but_for($right, [$(($line, $as_code, $in_words)),+]);)+
        }
    )+ };
}

pub(super) use mistakes;

/// Pseudocode with other lines in some places, each given by its two keys: as deep as what stood there.
pub(super) const fn but_for<const M: usize, const N: usize>(
    mut lines: [CodeLine; M],
    others: [(usize, &'static str, &'static str); N],
) -> [CodeLine; M] {
    let mut i = 0;
    while i < N {
        let (place, code, words) = others[i];
        lines[place] = code_line(lines[place].depth, code, words);
        i += 1;
    }
    lines
}
