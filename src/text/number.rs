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
    let magnitude = x.abs();
    let text = match form(magnitude) {
        Form::NotANumber => "NaN".to_owned(),
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
        Form::Rounded => false,
        Form::Scientific => significant_digits(magnitude) <= DIGITS,
        _ => true,
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

/// Whether [`ratio`] shows this very quotient.
pub(super) fn is_exact_ratio(num: f64, den: f64) -> bool {
    den == 0.0 || reduced(num.abs(), den.abs()).is_some() || is_exact(num / den)
}

/// The ways in which a magnitude can be written.
enum Form {
    NotANumber,
    Infinite,
    Integer,
    Fraction(f64, u32),
    Decimal,
    Rounded,
    Scientific,
}

fn form(magnitude: f64) -> Form {
    if magnitude.is_nan() {
        Form::NotANumber
    } else if magnitude.is_infinite() {
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

#[cfg(test)]
mod tests {
    use super::*;

    const ON_THE_BOARD: &[(&str, f64, &str)] = &[
        ("zero", 0.0, "0"),
        ("negative zero has no sign", -0.0, "0"),
        ("an integer", 7.0, "7"),
        ("a negative integer, with a true minus", -2.0, "−2"),
        ("six digits, not grouped", 123_456.0, "123456"),
        ("nine digits", 999_999_999.0, "999999999"),
        ("a half", 0.5, "1/2"),
        ("a third", 1.0 / 3.0, "1/3"),
        ("two fifths", 0.4, "2/5"),
        ("four fifths", 0.8, "4/5"),
        ("three eighths below zero", -0.375, "−3/8"),
        ("seven eighths", 0.875, "7/8"),
        ("a sixth below zero", -1.0 / 6.0, "−1/6"),
        ("a ninth", 1.0 / 9.0, "1/9"),
        ("a tenth", 0.1, "0.1"),
        ("three tenths", 0.3, "0.3"),
        ("seven twentieths", 0.35, "0.35"),
        ("a sixteenth", 0.0625, "0.0625"),
        (
            "five thirty-seconds: exact and shorter than 0.15625",
            0.156_25,
            "5/32",
        ),
        ("a twelfth", 1.0 / 12.0, "1/12"),
        ("a thirty-first", 1.0 / 31.0, "1/31"),
        (
            "a thirty-third: too fine for a fraction",
            1.0 / 33.0,
            "0.0303",
        ),
        ("one and a half", 1.5, "1.5"),
        ("one and a half below zero", -1.5, "−1.5"),
        ("four digits", 1.375, "1.375"),
        ("five digits, a sixteenth", 1.8125, "29/16"),
        ("five thirds", 5.0 / 3.0, "5/3"),
        ("seven thirds below zero", -7.0 / 3.0, "−7/3"),
        ("a large numerator is no fraction", 1000.0 / 3.0, "333.3"),
        ("two decimals", 123.45, "123.45"),
        ("the middle of a pixel far away", 1000.5, "1000.5"),
        ("four significant digits", std::f64::consts::PI, "3.142"),
        ("rounded below one", 0.382_683_432_365_089_8, "0.3827"),
        (
            "rounded below zero",
            -std::f64::consts::FRAC_1_SQRT_2,
            "−0.7071",
        ),
        (
            "leading zeros are not significant",
            0.001_234_56,
            "0.001235",
        ),
        ("rounding carries into a digit more", 9.999_96, "10"),
        (
            "the integer part is never rounded away",
            123_456.789,
            "123457",
        ),
        ("a sum of tenths that misses three tenths", 0.1 + 0.2, "0.3"),
        ("the smallest plain decimal", 1e-4, "0.0001"),
        ("small", 1.2e-5, "1.2×10⁻⁵"),
        ("small and long", -1.234_56e-7, "−1.235×10⁻⁷"),
        ("a thousand million", 1e9, "1×10⁹"),
        ("large and long", 1.234_567_89e12, "1.235×10¹²"),
        ("huge", 1e300, "1×10³⁰⁰"),
        ("the smallest double", 5e-324, "4.941×10⁻³²⁴"),
        ("infinite", f64::INFINITY, "∞"),
        ("infinite below zero", f64::NEG_INFINITY, "−∞"),
        ("no number", f64::NAN, "NaN"),
    ];

    #[test]
    fn numbers_are_written_as_on_the_board() {
        for &(what, x, expected) in ON_THE_BOARD {
            assert_eq!(number(Lang::En, x), expected, "{what}");
        }
    }

    #[test]
    fn the_decimal_separator_is_the_reader_s() {
        for (lang, expected) in [
            (Lang::En, ["1.5", "−0.7071", "1.235×10¹²", "3/8"]),
            (Lang::ZhCn, ["1.5", "−0.7071", "1.235×10¹²", "3/8"]),
            (Lang::Es, ["1,5", "−0,7071", "1,235×10¹²", "3/8"]),
            (Lang::PtBr, ["1,5", "−0,7071", "1,235×10¹²", "3/8"]),
        ] {
            let written = [
                1.5,
                -std::f64::consts::FRAC_1_SQRT_2,
                1.234_567_89e12,
                0.375,
            ]
            .map(|x| number(lang, x));
            assert_eq!(written, expected, "{lang}");
        }
    }

    #[test]
    fn only_what_is_not_rounded_is_exact() {
        for x in [
            0.0,
            1.0,
            -0.375,
            1.0 / 3.0,
            1.375,
            123.45,
            1e300,
            1.2e-5,
            f64::INFINITY,
            f64::NAN,
        ] {
            assert!(is_exact(x), "{x} is shown exactly");
        }
        for x in [
            0.1 + 0.2,
            1.0 / 33.0,
            9.999_96,
            1.234_56e-7,
            std::f64::consts::PI,
        ] {
            assert!(!is_exact(x), "{x} is shown rounded");
        }
    }

    #[test]
    fn quotients_are_reduced() {
        for (num, den, expected) in [
            (1.0, 4.0, "1/4"),
            (2.0, 8.0, "1/4"),
            (-2.0, 8.0, "−1/4"),
            (-3.0, -4.0, "3/4"),
            (3.0, 10.0, "3/10"),
            (5.0, 2.0, "5/2"),
            (1.5, 2.5, "3/5"),
            (0.375, 1.0, "3/8"),
            (8.0, 4.0, "2"),
            (-8.0, 4.0, "−2"),
            (5e9, 1.0, "5×10⁹"),
            (-0.0, 4.0, "0"),
            (0.0, -4.0, "0"),
            (1001.0, 1000.0, "1.001"),
            (0.1, 0.4, "1/4"),
            (1.0, 1e-300, "1×10³⁰⁰"),
            (5e-324, f64::MAX, "0"),
            (f64::MAX, f64::MAX, "1"),
            (f64::INFINITY, 2.0, "∞"),
            (1.0, f64::INFINITY, "0"),
            (3.0, 0.0, "3/0"),
            (0.0, -0.0, "0/0"),
            (f64::NAN, 1.0, "NaN"),
        ] {
            assert_eq!(ratio(Lang::En, num, den), expected, "{num} / {den}");
        }
    }
}
