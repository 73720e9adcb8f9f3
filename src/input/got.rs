//! Values whose shape is known to be right.

/// A value of the shape that was asked for. What is asked of it in another shape is empty or zero.
#[derive(Clone, PartialEq, Debug)]
pub enum Got {
    /// A number.
    Number(f64),
    /// A word or any other text.
    Text(String),
    /// Numbers of a list, or of lists in lists one after the other.
    Numbers(Vec<f64>),
    /// Whole numbers in the same way; a whole number alone.
    Wholes(Vec<i64>),
    /// The fields of a table that were given, in the order of its description.
    Table(Vec<(&'static str, Got)>),
    /// Values of any shape.
    List(Vec<Got>),
}

impl Got {
    /// The number.
    pub const fn number(&self) -> f64 {
        match self {
            Self::Number(x) => *x,
            _ => 0.0,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) => text,
            _ => "",
        }
    }

    /// All the numbers.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Numbers(numbers) => numbers,
            _ => &[],
        }
    }

    /// The first `N` of the numbers.
    pub fn array<const N: usize>(&self) -> [f64; N] {
        self.numbers().first_chunk().copied().unwrap_or([0.0; N])
    }

    /// The numbers, `N` in a row.
    pub fn rows<const N: usize>(&self) -> &[[f64; N]] {
        self.numbers().as_chunks().0
    }

    /// The first `R` rows of `N` numbers.
    pub fn matrix<const R: usize, const N: usize>(&self) -> [[f64; N]; R] {
        self.rows().first_chunk().copied().unwrap_or([[0.0; N]; R])
    }

    /// The whole numbers, `N` in a row.
    pub fn whole_rows<const N: usize>(&self) -> &[[i64; N]] {
        match self {
            Self::Wholes(wholes) => wholes.as_chunks().0,
            _ => &[],
        }
    }

    /// The first `N` of the whole numbers.
    pub fn wholes<const N: usize>(&self) -> [i64; N] {
        self.whole_rows().first().copied().unwrap_or([0; N])
    }

    /// The fields of the table that were given.
    pub fn fields(&self) -> &[(&'static str, Self)] {
        match self {
            Self::Table(fields) => fields,
            _ => &[],
        }
    }

    /// A field of the table, where it was given.
    pub fn get(&self, name: &str) -> Option<&Self> {
        let field = self.fields().iter().find(|(given, _)| *given == name);
        field.map(|(_, got)| got)
    }

    /// The number in this field of the table.
    pub fn number_in(&self, name: &str) -> f64 {
        self.get(name).map_or(0.0, Self::number)
    }

    /// The entries of the list.
    pub fn list(&self) -> &[Self] {
        match self {
            Self::List(list) => list,
            _ => &[],
        }
    }
}
