use std::f64::consts::{FRAC_1_SQRT_2, PI};

use proptest::prelude::*;

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
    ("four significant digits", PI, "3.142"),
    ("rounded below one", 0.382_683_432_365_089_8, "0.3827"),
    ("rounded below zero", -FRAC_1_SQRT_2, "−0.7071"),
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

fn number(lang: Lang, x: f64) -> String {
    Quantity::Number(x).written(lang, Notation::Own).to_string()
}

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
        let numbers = [1.5, -FRAC_1_SQRT_2, 1.234_567_89e12, 0.375];
        assert_eq!(numbers.map(|x| number(lang, x)), expected, "{lang}");
    }
}

#[test]
fn only_what_is_not_rounded_is_exact() {
    let third = 1.0 / 3.0;
    let shown = [0.0, 1.0, -0.375, third, 1.375, 123.45, 1e300, 1.2e-5];
    let odd = [f64::INFINITY, f64::NAN].map(|x| (x, true));
    let rounded = [0.1 + 0.2, 1.0 / 33.0, 9.999_96, 1.234_56e-7, PI].map(|x| (x, false));
    for (x, is_exact) in [&shown.map(|x| (x, true))[..], &odd, &rounded].concat() {
        let found = Quantity::Number(x).is_exact(Notation::Own);
        assert_eq!(found, is_exact, "{x}");
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
        let written = Quantity::Ratio(num, den).written(Lang::En, Notation::Own);
        assert_eq!(written.to_string(), expected, "{num} / {den}");
    }
}

#[test]
fn numbers_beside_each_other_are_of_one_kind() {
    for (what, numbers, expected) in [
        ("whole ones go with anything", vec![-1.0, 0.375], "−1 3/8"),
        (
            "decimals alone stay decimals",
            vec![1.5, 2.0, 0.1],
            "1.5 2 0.1",
        ),
        (
            "all have a short fraction",
            vec![1.5, 0.375, 2.0],
            "3/2 3/8 2",
        ),
        ("a tenth has one too", vec![0.3, 1.0 / 3.0], "3/10 1/3"),
        ("one has none", vec![0.375, 0.3827, 1.5], "0.375 0.3827 1.5"),
        (
            "a third has no decimal: it is rounded",
            vec![1.0 / 3.0, 0.3827],
            "0.3333 0.3827",
        ),
        ("too small for a fraction", vec![0.5, 1e-5], "0.5 1×10⁻⁵"),
    ] {
        let numbers: Vec<Quantity> = numbers.into_iter().map(Quantity::Number).collect();
        let mut alike = Alike::default();
        for &number in &numbers {
            alike.add(number);
        }
        let kind = alike.notation();
        let written = |x: &Quantity| x.written(Lang::En, kind).to_string();
        let written: Vec<String> = numbers.iter().map(written).collect();
        assert_eq!(written.join(" "), expected, "{what}");
    }
    assert!(Quantity::Ratio(1.0, 3.0).is_exact(Notation::Fractions));
    assert!(!Quantity::Ratio(1.0, 3.0).is_exact(Notation::Decimals));
}

proptest! {
    #[test]
    fn a_decimal_is_short_as_its_text_is(
        x in prop_oneof![
            SMALL..LARGE,
            (1..2_000_000_u32, 1..9).prop_map(|(n, places)| f64::from(n) / 10_f64.powi(places)),
        ],
        ulps in -1..=1_i64,
    ) {
        let x = f64::from_bits(x.to_bits().saturating_add_signed(ulps)).max(SMALL);
        prop_assume!(x.fract() != 0.0);
        let decimals = x.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let is_short = decimals <= 2 || significant_digits(x) <= DIGITS;
        prop_assert_eq!(is_short_decimal(x), is_short, "{}", x);
    }
}
