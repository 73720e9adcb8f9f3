//! Numbers as people write them on the board: `3/8`, `−1.5`, `0.3827`, `1.2×10⁻⁵`. `1/3` is shown for the one double that
//! is nearest to a third, and for no other.

use std::fmt;

use super::lang::Lang;

const DIGITS: usize = 4;
/// Below one, fractions up to this denominator read better than decimals: 3/8, not 0.375.
const PLAIN_DENOMINATOR: u32 = 9;
const MAX_DENOMINATOR: u32 = 32;
const MAX_NUMERATOR: f64 = 999.0;
const MAX_RATIO_TERM: u64 = 999;
/// From here on, and below [`SMALL`], numbers are shown with a power of ten.
const LARGE: f64 = 1e9;
const SMALL: f64 = 1e-4;
/// From here on, the thousands of a count stand apart.
pub(super) const LARGE_COUNT: f64 = 1e4;
/// U+2212, as wide as a plus; the hyphen on the keyboard is not a minus.
const MINUS: &str = "−";

/// How numbers that stand beside each other are written, so that a reader can compare them.
/// Of two, the later one writes what both have to.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum Notation {
    /// Each in its own best way: they do not mix.
    #[default]
    Own,
    Fractions,
    Decimals,
}

impl Notation {
    pub const ALL: [Self; 3] = [Self::Own, Self::Fractions, Self::Decimals];
}

/// Numbers that will stand beside each other, one after the other: in which forms they would be written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Alike {
    has_fraction: bool,
    has_decimal: bool,
    /// Where fractions are wanted, too.
    has_decimal_only: bool,
}

impl Alike {
    pub(super) fn add(&mut self, x: Quantity) {
        let own = x.form(Notation::Own);
        self.has_fraction |= own.is_fraction();
        self.has_decimal |= own.is_decimal();
        self.has_decimal_only |= own.is_decimal() && x.form(Notation::Fractions).is_decimal();
    }

    pub const fn notation(self) -> Notation {
        match (self.has_fraction && self.has_decimal, self.has_decimal_only) {
            (false, _) => Notation::Own,
            (true, false) => Notation::Fractions,
            (true, true) => Notation::Decimals,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Quantity {
    Number(f64),
    /// `num / den`: a reduced fraction where that is exact and short, else a number.
    Ratio(f64, f64),
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Written {
    Line(String),
    Fraction {
        sign: &'static str,
        num: String,
        den: String,
    },
}

impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(text) => f.write_str(text),
            Self::Fraction { sign, num, den } => write!(f, "{sign}{num}/{den}"),
        }
    }
}

impl Quantity {
    pub(super) fn written(self, lang: Lang, notation: Notation) -> Written {
        let sign = if self.value() < 0.0 { MINUS } else { "" };
        let line = |text: &str| Written::Line(format!("{sign}{text}"));
        let magnitude = self.value().abs();
        match self.form(notation) {
            Form::NotANumber => Written::Line("NaN".to_owned()),
            Form::Infinite => line("∞"),
            Form::Integer => line(&format!("{magnitude:.0}")),
            Form::Fraction(num, den) => Written::Fraction {
                sign,
                num: num.to_string(),
                den: den.to_string(),
            },
            Form::ByZero(num) => {
                Written::Line(format!("{}/0", Self::Number(num).written(lang, notation)))
            }
            Form::Decimal => line(&localized(lang, &magnitude.to_string())),
            Form::Rounded => line(&localized(lang, &rounded(magnitude))),
            Form::Scientific => line(&scientific(lang, magnitude)),
        }
    }

    pub(super) fn is_exact(self, notation: Notation) -> bool {
        match self.form(notation) {
            Form::Rounded => false,
            Form::Scientific => significant_digits(self.value().abs()) <= DIGITS,
            _ => true,
        }
    }

    fn value(self) -> f64 {
        match self {
            Self::Number(x) => x,
            Self::Ratio(num, den) => num / den,
        }
    }

    fn form(self, notation: Notation) -> Form {
        match self {
            Self::Number(x) => form(x.abs(), notation),
            Self::Ratio(num, 0.0) => Form::ByZero(num),
            Self::Ratio(num, den) => match reduced(num.abs(), den.abs()) {
                Some((n, d)) if d > 1 && notation != Notation::Decimals => Form::Fraction(n, d),
                _ => form((num / den).abs(), notation),
            },
        }
    }
}

enum Form {
    NotANumber,
    Infinite,
    Integer,
    Fraction(u64, u64),
    ByZero(f64),
    Decimal,
    Rounded,
    Scientific,
}

impl Form {
    const fn is_fraction(&self) -> bool {
        matches!(self, Self::Fraction(..))
    }

    const fn is_decimal(&self) -> bool {
        matches!(self, Self::Decimal | Self::Rounded | Self::Scientific)
    }
}

fn form(magnitude: f64, notation: Notation) -> Form {
    if magnitude.is_nan() {
        return Form::NotANumber;
    }
    if magnitude.is_infinite() {
        return Form::Infinite;
    }
    if magnitude != 0.0 && !(SMALL..LARGE).contains(&magnitude) {
        return Form::Scientific;
    }
    if magnitude.fract() == 0.0 {
        return Form::Integer;
    }
    let as_fraction = |max_denominator| {
        let (n, d) = fraction(magnitude, max_denominator)?;
        Some(Form::Fraction(n, d))
    };
    let simple = as_fraction(PLAIN_DENOMINATOR).filter(|_| magnitude < 1.0);
    let decimal = is_short_decimal(magnitude).then_some(Form::Decimal);
    let found = match notation {
        Notation::Own => simple.or(decimal).or_else(|| as_fraction(MAX_DENOMINATOR)),
        Notation::Fractions => as_fraction(MAX_DENOMINATOR).or(decimal),
        Notation::Decimals => decimal,
    };
    found.unwrap_or(Form::Rounded)
}

/// The fraction with the smallest denominator, up to `max_denominator`, whose nearest double is `x`.
fn fraction(x: f64, max_denominator: u32) -> Option<(u64, u64)> {
    (2..=max_denominator)
        .map(|d| ((x * f64::from(d)).round(), d))
        .find(|&(n, d)| n / f64::from(d) == x)
        .filter(|&(n, _)| n <= MAX_NUMERATOR)
        .map(|(n, d)| (n as u64, u64::from(d)))
}

/// Four significant digits at most; or two decimals, so that 123.45 and 1000.5 stay themselves.
fn is_short_decimal(x: f64) -> bool {
    let mut parts = 1.0;
    // So many decimals have four digits of the smallest number that is no power of ten.
    (1..=7).any(|decimals| {
        parts *= 10.0;
        let n = (x * parts).round();
        n / parts == x && (decimals <= 2 || n < 1e4)
    })
}

fn significant_digits(x: f64) -> usize {
    let shortest = format!("{x:e}");
    let mantissa = shortest.split('e').next().unwrap_or_default();
    mantissa.bytes().filter(u8::is_ascii_digit).count()
}

/// Four significant digits, or more where the integer part has more.
fn rounded(magnitude: f64) -> String {
    let exponent = libm::log10(magnitude).floor() as i32;
    let decimals = (DIGITS as i32 - 1 - exponent).max(0) as usize;
    without_trailing_zeros(&format!("{magnitude:.decimals$}")).to_owned()
}

fn scientific(lang: Lang, magnitude: f64) -> String {
    let text = format!("{magnitude:.*e}", DIGITS - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = localized(lang, without_trailing_zeros(mantissa));
    let exponent: String = exponent.chars().map(superscript).collect();
    format!("{mantissa}×10{exponent}")
}

pub(super) fn rounded_to(lang: Lang, x: f64, places: usize) -> String {
    let digits = format!("{:.places$}", x.abs());
    let is_negative = x < 0.0 && digits.contains(|c: char| ('1'..='9').contains(&c));
    let sign = if is_negative { MINUS } else { "" };
    format!("{sign}{}", localized(lang, &digits))
}

pub(super) fn count(lang: Lang, n: usize) -> String {
    if (n as f64) < LARGE_COUNT {
        n.to_string()
    } else {
        grouped(lang, n as f64)
    }
}

pub(super) fn grouped(lang: Lang, x: f64) -> String {
    let digits = rounded_to(lang, x, 0);
    let mut text = String::new();
    let n = digits.chars().count();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (n - i).is_multiple_of(3) && text.ends_with(|c: char| c.is_ascii_digit()) {
            text.push_str(lang.thousands_separator());
        }
        text.push(digit);
    }
    text
}

fn without_trailing_zeros(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

fn superscript(c: char) -> char {
    let digit = c.to_digit(10).map(|digit| digit as usize);
    digit
        .and_then(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit))
        .unwrap_or('⁻')
}

fn localized(lang: Lang, decimal: &str) -> String {
    decimal.replace('.', &lang.decimal_separator().to_string())
}

/// `num/den` in lowest terms, exactly, where both terms are short. Both arguments are magnitudes.
fn reduced(num: f64, den: f64) -> Option<(u64, u64)> {
    let (mut n, mut d) = (num, den);
    let limit = 2.0_f64.powi(f64::MANTISSA_DIGITS as i32);
    // Every finite double is a dyadic rational. Doubling both until neither has a fractional part
    // is exact and keeps the quotient; a term past 2^53 would not come out short.
    loop {
        if !(n <= limit && d <= limit) {
            return None;
        }
        if n.fract() == 0.0 && d.fract() == 0.0 {
            break;
        }
        (n, d) = (n * 2.0, d * 2.0);
    }
    let (n, d) = (n as u64, d as u64);
    let divisor = gcd(n, d);
    let (n, d) = (n / divisor, d / divisor);
    (n <= MAX_RATIO_TERM && d <= MAX_RATIO_TERM).then_some((n, d))
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests;
