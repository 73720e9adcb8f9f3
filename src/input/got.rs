//! Values whose shape is known to be right.

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

    pub fn list(&self) -> &[Self] {
        match self {
            Self::List(list) => list,
            _ => &[],
        }
    }
}
