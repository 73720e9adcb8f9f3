//! A tree on layers: what is below a node stands below it, to its left and to its right.
//!
//! ```text
//!   layer 0             A
//!                    ╱     ╲
//!   layer 1      B            C
//!              ╱               ╲
//!   layer 2  D                  +12
//!   column   0   1      2     3   4
//! ```
//!
//! Every node has a column of its own, between all that is below it to its left and all that is below it to its right. What has no
//! room is folded: a whole subtree to one spot that counts it, and so all that is not below the first one shown.

/// What stands in a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stands {
    /// This node.
    Node(usize),
    /// So many, folded.
    Folded(usize),
}

/// A place of a tree, and what stands there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Spot {
    /// What.
    pub stands: Stands,
    /// From the left.
    pub column: usize,
    /// From the top.
    pub layer: usize,
    /// The spot above, among all.
    pub above: Option<usize>,
}

/// The spots of a tree from node 0, no more than there are columns and layers for; about `focus`, which is always shown. `below` has
/// what is below each node to its left and to its right.
pub fn layers(
    below: &[[Option<usize>; 2]],
    focus: Option<usize>,
    [columns, rows]: [usize; 2],
) -> Vec<Spot> {
    if below.is_empty() {
        return Vec::new();
    }
    let tree = Tree::new(below);
    let path = tree.path(focus.filter(|&node| node < below.len()).unwrap_or(0));
    let path = tree.seen_of(&path, [columns, rows.max(3)]);
    let top = path[0];
    let first_layer = usize::from(top != 0);
    let shown = tree.shown(path, columns, rows.max(3) - first_layer);
    tree.spots(top, &shown)
}

struct Tree<'a> {
    below: &'a [[Option<usize>; 2]],
    above: Vec<Option<usize>>,
    /// How many there are in the subtree of each, with itself.
    sizes: Vec<usize>,
}

impl<'a> Tree<'a> {
    fn new(below: &'a [[Option<usize>; 2]]) -> Self {
        let mut above = vec![None; below.len()];
        let mut order = vec![0];
        let mut nth = 0;
        while let Some(&node) = order.get(nth) {
            for &child in below[node].iter().flatten() {
                above[child] = Some(node);
                order.push(child);
            }
            nth += 1;
        }
        let mut sizes = vec![1; below.len()];
        for &node in order.iter().rev() {
            if let Some(parent) = above[node] {
                sizes[parent] += sizes[node];
            }
        }
        Self {
            below,
            above,
            sizes,
        }
    }

    /// From the root to a node.
    fn path(&self, node: usize) -> Vec<usize> {
        let up = std::iter::successors(Some(node), |&node| self.above[node]);
        let mut path: Vec<usize> = up.collect();
        path.reverse();
        path
    }

    fn n_below(&self, node: usize) -> usize {
        self.below[node].iter().flatten().count()
    }

    /// Columns that these nodes take, each below another of them but the first: their own, and those of what is folded below them.
    fn columns_of(&self, nodes: &[usize]) -> usize {
        let all: usize = nodes.iter().map(|&node| 1 + self.n_below(node)).sum();
        all - (nodes.len() - 1)
    }

    /// The end of a path that there is room for: with a layer for what is folded above it, and one for what is below it.
    fn seen_of<'p>(&self, path: &'p [usize], [columns, rows]: [usize; 2]) -> &'p [usize] {
        let has_room = |seen: &[usize]| {
            let above = usize::from(seen.len() < path.len());
            let under = usize::from(seen.last().is_some_and(|&node| self.n_below(node) > 0));
            seen.len() + above + under <= rows && self.columns_of(seen) <= columns
        };
        let starts = 0..path.len() - 1;
        let found = starts.map(|from| &path[from..]).find(|seen| has_room(seen));
        found.unwrap_or(&path[path.len() - 1..])
    }

    /// The path, and of all below its first node layer after layer what there is room for.
    fn shown(&self, path: &[usize], columns: usize, rows: usize) -> Vec<bool> {
        let mut shown = vec![false; self.below.len()];
        for &node in path {
            shown[node] = true;
        }
        let mut taken = self.columns_of(path);
        let mut open = vec![(path[0], 0)];
        let mut nth = 0;
        while let Some(&(node, layer)) = open.get(nth) {
            nth += 1;
            for &child in self.below[node].iter().flatten() {
                if !shown[child] {
                    let more = self.n_below(child);
                    let lowest = layer + 1 + usize::from(more > 0);
                    if taken + more > columns || lowest >= rows {
                        continue;
                    }
                    // It stands where it was counted.
                    taken += more;
                    shown[child] = true;
                }
                open.push((child, layer + 1));
            }
        }
        shown
    }

    /// From the left to the right, without recursion: a tree may be as deep as it has nodes.
    fn spots(&self, top: usize, shown: &[bool]) -> Vec<Spot> {
        enum Next {
            Enter(usize, Option<usize>, usize),
            Place(usize),
        }
        let mut spots: Vec<Spot> = Vec::new();
        let n_outside = self.below.len() - self.sizes[top];
        let spot = |stands, layer, above| Spot {
            stands,
            column: 0,
            layer,
            above,
        };
        spots.extend((n_outside > 0).then(|| spot(Stands::Folded(n_outside), 0, None)));
        let first = spots.len();
        let mut open = vec![Next::Enter(top, first.checked_sub(1), first)];
        let mut column = 0;
        while let Some(next) = open.pop() {
            match next {
                Next::Enter(node, above, layer) => {
                    let idx = spots.len();
                    if shown[node] {
                        spots.push(spot(Stands::Node(node), layer, above));
                        let [left, right] = self.below[node];
                        let enter = |child| Next::Enter(child, Some(idx), layer + 1);
                        open.extend(right.map(enter));
                        open.push(Next::Place(idx));
                        open.extend(left.map(enter));
                    } else {
                        spots.push(spot(Stands::Folded(self.sizes[node]), layer, above));
                        open.push(Next::Place(idx));
                    }
                }
                Next::Place(idx) => {
                    spots[idx].column = column;
                    column += 1;
                }
            }
        }
        if first > 0 {
            spots[0].column = spots[first].column;
        }
        spots
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tree as a list: each node below the one before, to one side or the other.
    fn chain(n: usize) -> Vec<[Option<usize>; 2]> {
        let next = |i: usize| (i + 1 < n).then_some(i + 1);
        (0..n)
            .map(|i| {
                if i % 3 == 0 {
                    [None, next(i)]
                } else {
                    [next(i), None]
                }
            })
            .collect()
    }

    /// Every layer full.
    fn full(n: usize) -> Vec<[Option<usize>; 2]> {
        let child = |i: usize| (i < n).then_some(i);
        (0..n)
            .map(|i| [child(2 * i + 1), child(2 * i + 2)])
            .collect()
    }

    fn count(spots: &[Spot]) -> usize {
        let counts = spots.iter().map(|spot| match spot.stands {
            Stands::Node(_) => 1,
            Stands::Folded(n) => n,
        });
        counts.sum()
    }

    #[test]
    fn what_is_below_stands_on_its_side() {
        let spots = layers(&full(5), None, [20, 20]);
        let at = |node| {
            let spot = spots.iter().find(|spot| spot.stands == Stands::Node(node));
            spot.map(|spot| [spot.column, spot.layer])
        };
        assert_eq!(at(0), Some([3, 0]));
        assert_eq!(at(1), Some([1, 1]));
        assert_eq!(at(2), Some([4, 1]));
        assert_eq!(at(3), Some([0, 2]));
        assert_eq!(at(4), Some([2, 2]));
    }

    #[test]
    fn all_are_shown_or_counted_once_in_the_room_and_the_focus_is_seen() {
        for tree in [chain(60), full(63), chain(1), full(200)] {
            for room in [[5, 3], [8, 4], [14, 6], [40, 12]] {
                for focus in 0..tree.len() {
                    let spots = layers(&tree, Some(focus), room);
                    let what = format!("{} {focus} {room:?}: {spots:?}", tree.len());
                    assert_eq!(count(&spots), tree.len(), "{what}");
                    let is_focus = |spot: &Spot| spot.stands == Stands::Node(focus);
                    assert!(spots.iter().any(is_focus), "{what}");
                    assert!(spots.iter().all(|spot| spot.layer < room[1]), "{what}");
                    assert!(spots.iter().all(|spot| spot.column < room[0]), "{what}");
                    let is_above =
                        |spot: &Spot| spot.above.is_none_or(|i| spots[i].layer < spot.layer);
                    assert!(spots.iter().all(is_above), "{what}");
                }
            }
        }
    }
}
