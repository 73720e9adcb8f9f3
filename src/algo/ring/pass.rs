//! A ring against one limit as a program would call it. Most edges stay on one side: only those that do not get the clipper's step, and
//! what lies between two of them is copied, or left out, as a whole.

use std::convert::Infallible;

use crate::trace::Told;

use super::{Clip, Happening, Limit, Lists, Right, Ring};

/// As many vertices are looked at together as a number has bits.
const TOGETHER: usize = u64::BITS as usize;

/// Puts what is left of `input` behind the limit into `output`, in place of what that held.
#[inline]
pub fn pass<P: Ring>(limit: &impl Limit<P::Vertex>, input: &[P::Vertex], output: &mut P) {
    output.clear();
    let Some((&first, &last)) = input.first().zip(input.last()) else {
        return;
    };
    let mut clip = Clip::begin::<Right, f64>(limit, first);
    let mut from = 0;
    for (start, chunk) in (0..).step_by(TOGETHER).zip(input.chunks(TOGETHER)) {
        let inside = limit.inside(chunk);
        let before = inside << 1 | u64::from(clip.is_inside());
        let mut turns = (inside ^ before) & (u64::MAX >> (TOGETHER - chunk.len()));
        while turns != 0 {
            let i = start + turns.trailing_zeros() as usize;
            turns &= turns - 1;
            if clip.is_inside() {
                output.append(&input[from..i]);
            }
            clip.go_to(limit, input[i - 1]);
            let vertex = ([0; 2], input[i]);
            let Told::Continue(()) =
                clip.vertex::<Right, f64, _>(limit, vertex, &mut put_in(output));
            from = i + 1;
        }
    }
    if clip.is_inside() {
        output.append(&input[from..]);
    }
    clip.go_to(limit, last);
    let Told::Continue(()) = clip.close::<Right, f64, _>(limit, [0; 2], &mut put_in(output));
}

impl<P: Ring> Lists<P> {
    /// Clips the list against one limit, and tells nobody.
    #[inline]
    pub(in crate::algo) fn pass(&mut self, limit: &impl Limit<P::Vertex>) {
        let [first, second] = &mut self.pair;
        if self.n_passed.is_multiple_of(2) {
            pass(limit, first.vertices(), second);
        } else {
            pass(limit, second.vertices(), first);
        }
        self.n_passed += 1;
    }
}

/// Appends what is put out to a list, and tells nobody.
#[inline]
fn put_in<P: Ring>(output: &mut P) -> impl FnMut(Happening<P::Vertex>) -> Told<Infallible> {
    |happening| {
        if let Happening::Output(vertex) = happening {
            output.push(vertex);
        }
        Told::Continue(())
    }
}
