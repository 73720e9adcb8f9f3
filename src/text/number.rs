//! Numbers as people write them on the board: `3/8`, `−1.5`, `0.3827`, `1.2×10⁻⁵`.
//!
//! A number is shown exactly wherever that is short, and "exactly" is meant: `1/3` is shown for the
//! one double that is nearest to a third, and for no other. [`is_exact`] tells whether what is
//! shown is the number itself or a rounding of it.

use super::lang::Lang;

/// Significant digits of a number that is not shown exactly, and of an exact decimal.
const DIGITS: usize = 4;
/// Below one, fractions up to this denominator read better than decimals: 3/8, not 0.375.
const PLAIN_DENOMINATOR: u32 = 9;
/// The largest denominator, and numerator, of a fraction whose decimals are long or endless.
const MAX_DENOMINATOR: u32 = 32;
const MAX_NUMERATOR: f64 = 999.0;
/// The largest numerator and denominator of a quotient that is shown as a fraction.
const MAX_RATIO_TERM: u64 = 999;
/// From here on, and below [`SMALL`], numbers are shown with a power of ten.
const LARGE: f64 = 1e9;
const SMALL: f64 = 1e-4;
/// U+2212, as wide as a plus; the hyphen on the keyboard is not a minus.
const MINUS: char = '−';

/// A number as people write it, in one language.
pub(super) fn number(lang: Lang, x: f64) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    let magnitude = x.abs();
    let text = match form(magnitude) {
        Form::Infinite => "∞".to_owned(),
        Form::Integer => format!("{magnitude:.0}"),
        Form::Fraction(n, d) => format!("{n}/{d}"),
        Form::Decimal => localized(lang, &magnitude.to_string()),
        Form::Rounded => localized(lang, &rounded(magnitude)),
        Form::Scientific => scientific(lang, magnitude),
    };
    signed(x < 0.0, &text)
}

/// Whether [`number`] shows this very number, not one rounded to fewer digits.
pub(super) fn is_exact(x: f64) -> bool {
    let magnitude = x.abs();
    match form(magnitude) {
        Form::Infinite | Form::Integer | Form::Fraction(..) | Form::Decimal => true,
        Form::Rounded => false,
        Form::Scientific => significant_digits(magnitude) <= DIGITS,
    }
}

/// The quotient `num/den`: a reduced fraction where that is exact and short, else a number.
pub(super) fn ratio(lang: Lang, num: f64, den: f64) -> String {
    if den == 0.0 {
        return format!("{}/0", number(lang, num));
    }
    match reduced(num.abs(), den.abs()) {
        Some((n, d)) if d > 1 => signed((num < 0.0) != (den < 0.0), &format!("{n}/{d}")),
        _ => number(lang, num / den),
    }
}

/// The ways in which a magnitude can be written.
enum Form {
    Infinite,
    Integer,
    Fraction(f64, u32),
    Decimal,
    Rounded,
    Scientific,
}

fn form(magnitude: f64) -> Form {
    if magnitude.is_infinite() {
        Form::Infinite
    } else if magnitude != 0.0 && !(SMALL..LARGE).contains(&magnitude) {
        Form::Scientific
    } else if magnitude.fract() == 0.0 {
        Form::Integer
    } else if let Some((n, d)) = fraction(magnitude, PLAIN_DENOMINATOR)
        && magnitude < 1.0
    {
        Form::Fraction(n, d)
    } else if is_short_decimal(magnitude) {
        Form::Decimal
    } else if let Some((n, d)) = fraction(magnitude, MAX_DENOMINATOR) {
        Form::Fraction(n, d)
    } else {
        Form::Rounded
    }
}

/// The fraction with the smallest denominator, up to `max_denominator`, whose nearest double is `x`.
fn fraction(x: f64, max_denominator: u32) -> Option<(f64, u32)> {
    (2..=max_denominator)
        .map(|d| ((x * f64::from(d)).round(), d))
        .find(|&(n, d)| n / f64::from(d) == x)
        .filter(|&(n, _)| n <= MAX_NUMERATOR)
}

/// Four significant digits at most; or two decimals, so that 123.45 and 1000.5 stay themselves.
fn is_short_decimal(x: f64) -> bool {
    let decimals = x.to_string().split_once('.').map_or(0, |(_, d)| d.len());
    decimals <= 2 || significant_digits(x) <= DIGITS
}

/// How many digits the shortest decimal has whose nearest double is `x`.
fn significant_digits(x: f64) -> usize {
    let shortest = format!("{x:e}");
    let mantissa = shortest
        .split_once('e')
        .map_or("", |(mantissa, _)| mantissa);
    mantissa.bytes().filter(u8::is_ascii_digit).count()
}

/// Four significant digits, or more where the integer part has more.
fn rounded(magnitude: f64) -> String {
    let exponent = magnitude.log10().floor() as i32;
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

fn without_trailing_zeros(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

fn superscript(c: char) -> char {
    match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

fn localized(lang: Lang, decimal: &str) -> String {
    decimal.replace('.', &lang.decimal_separator().to_string())
}

fn signed(is_negative: bool, magnitude: &str) -> String {
    if is_negative {
        format!("{MINUS}{magnitude}")
    } else {
        magnitude.to_owned()
    }
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
