//! Values whose shape is known to be right.

use std::ops::Range;

/// A value of the shape that was asked for. What is asked of it in another shape is empty or zero.
#[derive(Clone, PartialEq, Debug)]
pub enum Got {
    Number(f64),
    Text(String),
    /// Numbers of a list, or of lists in lists one after the other.
    Numbers(Vec<f64>),
    /// Whole numbers in the same way; a whole number alone.
    Wholes(Vec<i64>),
    /// The fields of a table that were given, in the order of its description.
    Table(Vec<(&'static str, Got)>),
    List(Vec<Got>),
}

impl Got {
    pub const fn number(&self) -> f64 {
        match self {
            Self::Number(x) => *x,
            _ => 0.0,
        }
    }

    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) => text,
            _ => "",
        }
    }

    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Numbers(numbers) => numbers,
            _ => &[],
        }
    }

    pub fn array<const N: usize>(&self) -> [f64; N] {
        self.numbers().first_chunk().copied().unwrap_or([0.0; N])
    }

    pub fn rows<const N: usize>(&self) -> &[[f64; N]] {
        self.numbers().as_chunks().0
    }

    pub fn matrix<const R: usize, const N: usize>(&self) -> [[f64; N]; R] {
        self.rows().first_chunk().copied().unwrap_or([[0.0; N]; R])
    }

    pub fn whole_rows<const N: usize>(&self) -> &[[i64; N]] {
        match self {
            Self::Wholes(wholes) => wholes.as_chunks().0,
            _ => &[],
        }
    }

    pub fn wholes<const N: usize>(&self) -> [i64; N] {
        self.whole_rows().first().copied().unwrap_or([0; N])
    }

    pub fn fields(&self) -> &[(&'static str, Self)] {
        match self {
            Self::Table(fields) => fields,
            _ => &[],
        }
    }

    pub fn get(&self, name: &str) -> Option<&Self> {
        let field = self.fields().iter().find(|(given, _)| *given == name);
        field.map(|(_, got)| got)
    }

    pub fn number_in(&self, name: &str) -> f64 {
        self.get(name).map_or(0.0, Self::number)
    }

    /// Are all its coordinates 0, or so near to 1 that no product of a few, and no quotient of such, leaves the range of f64?
    pub fn is_moderate(&self) -> bool {
        /// 2⁻¹⁰⁰ to 2¹⁰⁰
        const MODERATE: Range<f64> = 7.888_609_052_210_118e-31..1.267_650_600_228_229_4e30;
        let is_moderate = |x: &f64| *x == 0.0 || MODERATE.contains(&x.abs());
        match self {
            Self::Number(x) => is_moderate(x),
            Self::Numbers(numbers) => numbers.iter().all(is_moderate),
            Self::Table(fields) => fields.iter().all(|(_, got)| got.is_moderate()),
            Self::List(list) => list.iter().all(Self::is_moderate),
            Self::Text(_) | Self::Wholes(_) => true,
        }
    }

    pub fn list(&self) -> &[Self] {
        match self {
            Self::List(list) => list,
            _ => &[],
        }
    }
}
