//! Pixels beside each other, worked out at once.
//!
//! Written so that the compiler finds what the processor does four at a time: arrays of one length, and masks instead of
//! branches.

/// So many.
pub const LANES: usize = 8;

/// Of pixels beside each other, from left to right.
pub type Lanes<T> = [T; LANES];

/// The first where all bits are set, the second where none is.
#[inline]
pub(super) fn chosen(mask: Lanes<u32>, first: Lanes<u32>, second: Lanes<u32>) -> Lanes<u32> {
    std::array::from_fn(|lane| first[lane] & mask[lane] | second[lane] & !mask[lane])
}

/// Works on some numbers from a place on; beyond the end of the list they are `beyond`.
#[inline]
pub(super) fn with_lanes<T: Copy, O>(
    list: &mut [T],
    place: usize,
    beyond: T,
    work: impl Fn(&mut Lanes<T>) -> O,
) -> O {
    let list = &mut list[place..];
    if let Some(lanes) = list.first_chunk_mut() {
        return work(lanes);
    }
    let mut lanes = [beyond; LANES];
    lanes[..list.len()].copy_from_slice(list);
    let output = work(&mut lanes);
    list.copy_from_slice(&lanes[..list.len()]);
    output
}
