//! Powers of two: what is too large or too small to be multiplied is brought near 1 by one of them, and back, without losing a bit.

/// Of the largest magnitude among some finite numbers: 0 for 1 to 2, and where all are 0.
#[must_use]
pub fn exponent(numbers: &[f64]) -> i32 {
    let largest = numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest == 0.0 {
        0
    } else {
        libm::ilogb(largest)
    }
}

/// Each times 2 to the power of an exponent; what is too large becomes infinite.
#[inline]
#[must_use]
pub fn times_power<const N: usize>(numbers: [f64; N], exponent: i32) -> [f64; N] {
    numbers.map(|x| libm::scalbn(x, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        for x in [5e-324, 1.5e-310, 0.1, -1.0, 3.0, f64::MAX] {
            let exponent = exponent(&[0.0, x]);
            let [near_one] = times_power([x], -exponent);
            assert!((1.0..2.0).contains(&near_one.abs()), "{x:e}");
            assert_eq!(times_power([near_one], exponent), [x]);
        }
        assert_eq!((exponent(&[]), exponent(&[0.0, -0.0])), (0, 0));
        assert_eq!(times_power([1.0], 1024), [f64::INFINITY]);
    }
}
