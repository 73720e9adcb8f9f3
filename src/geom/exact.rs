//! The sign of an area with corners at any finite numbers, in integers of thousands of bits.
//!
//! ```text
//!   │a 1│
//!   │b 1│ = aₓ·b_y − a_y·bₓ + bₓ·c_y − b_y·cₓ + cₓ·a_y − c_y·aₓ
//!   │c 1│
//! ```
//!
//! Every product is a whole number of 2⁻²¹⁴⁸, below 2²⁰⁴⁸: it is added to a long number, digit by digit. For the
//! few that leave the range in which expansions are exact, and for rings that have next to no area.

use std::cmp::Ordering;

/// 32 bits each, of which 2⁻²¹⁴⁸ is the lowest: with room for the sum of 2⁶⁰ products.
const N_DIGITS: usize = (2148 + 2048) / 32 + 6;

/// Sign of the area that a ring of fewer than 2²⁹ corners runs around, `Greater` for counter-clockwise.
pub fn exact_winding(ring: impl ExactSizeIterator<Item = [f64; 2]> + Clone) -> Ordering {
    let mut sum = [0_i64; N_DIGITS];
    let after = ring.clone().cycle().skip(1);
    for ([px, py], [qx, qy]) in ring.zip(after) {
        add_product(&mut sum, px, qy);
        add_product(&mut sum, -py, qx);
    }
    sign(&sum)
}

fn add_product(sum: &mut [i64; N_DIGITS], x: f64, y: f64) {
    let [(mx, ex), (my, ey)] = [x, y].map(parts);
    let mantissa = u128::from(mx) * u128::from(my);
    let negative = (x < 0.0) != (y < 0.0);
    // Both exponents count from the lowest subnormal number.
    let shift = ex + ey;
    for (half, offset) in [(mantissa as u64, 0), ((mantissa >> 64) as u64, 64)] {
        let (first, within) = ((shift + offset) / 32, (shift + offset) % 32);
        let shifted = u128::from(half) << within;
        for k in 0..3 {
            let digit = (shifted >> (32 * k)) as u32;
            let digit = i64::from(digit);
            sum[first + k] += if negative { -digit } else { digit };
        }
    }
}

/// |x| as a whole number of 2⁻¹⁰⁷⁴, shifted to the left.
fn parts(x: f64) -> (u64, usize) {
    let bits = x.abs().to_bits();
    let (exponent, fraction) = ((bits >> 52) as usize, bits & ((1 << 52) - 1));
    match exponent {
        0 => (fraction, 0),
        _ => (fraction | 1 << 52, exponent - 1),
    }
}

fn sign(sum: &[i64; N_DIGITS]) -> Ordering {
    let (mut carry, mut any) = (0, false);
    for digit in sum {
        let digit = digit + carry;
        any |= digit & 0xffff_ffff != 0;
        carry = digit >> 32;
    }
    match carry {
        ..0 => Ordering::Less,
        0 if !any => Ordering::Equal,
        _ => Ordering::Greater,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_agrees_with_expansions_where_they_are_exact() {
        let mut state = 7_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            ((state >> 33) % 9) as f64
        };
        for scale in [1.0, 0.1, 1e-9, 1e20] {
            for _ in 0..20_000 {
                let points = [(); 3].map(|()| [next() * scale, next() * scale]);
                let [a, b, c] = points.map(|[x, y]| robust::Coord { x, y });
                let expected = robust::orient2d(a, b, c).partial_cmp(&0.0).unwrap();
                assert_eq!(exact_winding(points.into_iter()), expected, "{points:?}");
            }
        }
    }

    #[test]
    fn neither_the_largest_nor_the_smallest_numbers_are_lost() {
        let (max, min) = (f64::MAX, 5e-324);
        let cases = [
            ([[-max, -max], [max, max], [0.0, 0.0]], Ordering::Equal),
            ([[-max, -max], [max, max], [0.0, min]], Ordering::Greater),
            ([[-max, -max], [max, max], [min, 0.0]], Ordering::Less),
            ([[0.0, 0.0], [min, 0.0], [0.0, min]], Ordering::Greater),
            ([[0.0, 0.0], [min, min], [max, max]], Ordering::Equal),
            (
                [[0.0, 0.0], [min, min], [max, max.next_down()]],
                Ordering::Less,
            ),
        ];
        for (points, expected) in cases {
            assert_eq!(exact_winding(points.into_iter()), expected, "{points:?}");
            let [a, b, c] = points;
            assert_eq!(
                exact_winding([b, a, c].into_iter()),
                expected.reverse(),
                "{points:?}, turned"
            );
        }
    }
}
