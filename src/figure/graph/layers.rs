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
//! Every node has a column of its own. What has no room is folded: a whole subtree, or all above, to one spot that counts it.

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stands {
    Node(usize),
    Folded(usize),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Spot {
    pub stands: Stands,
    pub column: usize,
    pub layer: usize,
    pub above: Option<usize>,
}

/// The spots of a tree from node 0 about `focus`; `below` has what is below each node, left and right.
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

/// So many columns and layers the spots take.
pub fn size_of(spots: &[Spot]) -> [f32; 2] {
    let n_columns = spots.iter().map(|spot| spot.column + 1).max();
    let n_layers = spots.iter().map(|spot| spot.layer + 1).max();
    [n_columns, n_layers].map(|n| n.unwrap_or(1) as f32)
}

struct Tree<'a> {
    below: &'a [[Option<usize>; 2]],
    above: Vec<Option<usize>>,
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

    fn path(&self, node: usize) -> Vec<usize> {
        let up = std::iter::successors(Some(node), |&node| self.above[node]);
        let mut path: Vec<usize> = up.collect();
        path.reverse();
        path
    }

    fn n_below(&self, node: usize) -> usize {
        self.below[node].iter().flatten().count()
    }

    fn columns_of(&self, nodes: &[usize]) -> usize {
        let all: usize = nodes.iter().map(|&node| 1 + self.n_below(node)).sum();
        all - (nodes.len() - 1)
    }

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

    fn chain(n: usize) -> Vec<[Option<usize>; 2]> {
        let next = |i: usize| (i + 1 < n).then_some(i + 1);
        let below = |i: usize| match i % 3 {
            0 => [None, next(i)],
            _ => [next(i), None],
        };
        (0..n).map(below).collect()
    }

    fn full(n: usize) -> Vec<[Option<usize>; 2]> {
        let child = |i: usize| (i < n).then_some(i);
        let below = |i| [child(2 * i + 1), child(2 * i + 2)];
        (0..n).map(below).collect()
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
        let places = [[3, 0], [1, 1], [4, 1], [0, 2], [2, 2]];
        assert_eq!([0, 1, 2, 3, 4].map(at), places.map(Some));
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
                    for spot in &spots {
                        assert!(spot.column < room[0] && spot.layer < room[1], "{what}");
                        let above = spot.above.map(|i| spots[i].layer);
                        assert!(above.is_none_or(|above| above < spot.layer), "{what}");
                    }
                }
            }
        }
    }
}
