//! Sums of products of a few numbers, exact for any finite ones: as whole numbers of thousands of bits.

use std::cmp::Ordering;

/// So many numbers are multiplied at most.
const MOST_FACTORS: usize = 4;

/// Digits of 32 bits of a product: 53 bits a factor, shifted by 31 at most.
const PRODUCT_DIGITS: usize = (MOST_FACTORS * 53 + 31).div_ceil(32);

/// Shifts of all factors, a product at the highest of them, and room for the carries of 2³⁰ products.
const N_DIGITS: usize = MOST_FACTORS * 2045 / 32 + PRODUCT_DIGITS + 2;

/// A sum of products that have as many factors each. The lowest bit stands for the product of the smallest numbers.
pub(super) struct LongSum([i64; N_DIGITS]);

impl LongSum {
    pub const fn zero() -> Self {
        Self([0; N_DIGITS])
    }

    /// Adds the product of at most four numbers.
    pub fn add<const N: usize>(&mut self, factors: [f64; N]) {
        const { assert!(N <= MOST_FACTORS) };
        let parts = factors.map(parts);
        let shift: usize = parts.iter().map(|(_, shift)| shift).sum();
        let mut product = [0_u64; PRODUCT_DIGITS];
        product[0] = 1 << (shift % 32);
        for (mantissa, _) in parts {
            let mut carry = 0;
            for digit in &mut product {
                let more = u128::from(*digit) * u128::from(mantissa) + carry;
                *digit = u64::from(more as u32);
                carry = more >> 32;
            }
        }
        let is_negative = factors.iter().fold(false, |turned, x| turned != (*x < 0.0));
        for (digit, more) in self.0[shift / 32..].iter_mut().zip(product) {
            *digit += if is_negative {
                -(more as i64)
            } else {
                more as i64
            };
        }
    }

    pub fn sign(&self) -> Ordering {
        let (mut carry, mut any) = (0, false);
        for digit in self.0 {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn sign<const N: usize>(products: &[[f64; N]]) -> Ordering {
        let mut sum = LongSum::zero();
        for &factors in products {
            sum.add(factors);
        }
        sum.sign()
    }

    #[test]
    fn nothing_is_lost() {
        let [large, small] = [2f64.powi(60), 2f64.powi(-60)];
        assert_eq!(sign::<2>(&[]), Ordering::Equal);
        let one = [[large, 1.0], [small, 1.0]];
        assert_eq!(sign(&[one[0], one[1], [-large, 1.0]]), Ordering::Greater);
        assert_eq!(
            sign(&[one[0], one[1], [large, -1.0], [small, -1.0]]),
            Ordering::Equal
        );
        // 0.1 as it is stored; three times of it is not 0.3.
        let thrice = [[0.1, 3.0, 1.0], [-0.3, 1.0, 1.0]];
        assert_eq!(sign(&thrice), Ordering::Greater);
    }

    #[test]
    fn the_largest_and_the_smallest_numbers_of_all_are_summed() {
        let (max, min) = (f64::MAX, 5e-324);
        let many = vec![[max; 4]; 1000];
        assert_eq!(sign(&many), Ordering::Greater);
        assert_eq!(
            sign(&[[max; 4], [-max, max, max, max], [-min, min, min, min]]),
            Ordering::Less
        );
        assert_eq!(
            sign(&[[max; 4], [-max, max, max, max.next_down()]]),
            Ordering::Greater
        );
        assert_eq!(sign(&[[min; 4], [-min, min, 0.0, max]]), Ordering::Greater);
    }
}
