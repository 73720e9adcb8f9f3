//! Oracles in whole numbers.

/// n·p + d
pub fn sum([a, b, c, d]: [i64; 4], [x, y, z]: [i64; 3]) -> i128 {
    [a * x, b * y, c * z, d].map(i128::from).iter().sum()
}

pub fn minus(a: [i64; 3], b: [i64; 3]) -> [i128; 3] {
    std::array::from_fn(|i| i128::from(a[i] - b[i]))
}

/// The determinant of three rows.
pub fn det([a, b, c]: [[i128; 3]; 3]) -> i128 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Have the half-spaces a x + b y + c z + d ≥ 0 a point in common? By elimination, as Fourier and Motzkin have it: of
/// each two that bound a variable from both sides a sum is left in which it does not stand any more.
pub fn have_a_common_point(mut rows: Vec<[i128; 4]>) -> bool {
    for variable in 0..3 {
        let (low, rest): (Vec<_>, Vec<_>) = rows.into_iter().partition(|row| row[variable] > 0);
        let (high, free): (Vec<_>, Vec<_>) = rest.into_iter().partition(|row| row[variable] < 0);
        rows = free;
        for l in &low {
            for h in &high {
                let sum = std::array::from_fn(|i| l[i] * -h[variable] + h[i] * l[variable]);
                rows.push(shortened(sum));
            }
        }
        rows.sort_unstable();
        rows.dedup();
    }
    rows.iter().all(|row| row[3] >= 0)
}

/// a·b
pub fn sum_of_four(a: [i128; 4], b: [i128; 4]) -> i128 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a × b
pub fn cross(a: [i128; 3], b: [i128; 3]) -> [i128; 3] {
    let at = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [at(1, 2), at(2, 0), at(0, 1)]
}

/// Divided by what all of them have in common.
pub fn shortened<const N: usize>(row: [i128; N]) -> [i128; N] {
    let common = row.iter().fold(0, |a, &b| gcd(a, b.abs()));
    row.map(|x| if common == 0 { x } else { x / common })
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a } else { gcd(b, a % b) }
}
