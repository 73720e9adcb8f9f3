//! The functions of a program in an order in which gzip finds more: it looks back 32 KB, so functions that are alike have to stand
//! near each other, as instances of one generic do.
//!
//! The order is that of balanced partitioning: all functions are halved so that each half has words that the other has not, then
//! each half is. Dhulipala et al., "Compressing Graphs and Indexes with Recursive Graph Bisection", 2016; lld sorts by it, too.

use std::{cmp::Ordering, convert::Infallible};

use anyhow::Context;
use wasm_encoder::{
    CodeSection, FunctionSection, Module,
    reencode::{Error, Reencode, utils},
};
use wasmparser::{
    CodeSectionReader, FunctionBody, FunctionSectionReader, Parser, Payload, TypeRef,
};

/// Bytes of a word. Shorter ones are everywhere, longer ones are found once.
const WORD: usize = 4;
/// What is called most has a short index, and keeps it.
const N_KEPT: usize = 128;
/// So few stand as they are.
const FEW: usize = 8;
/// Exchanges between two halves: after so many hardly any is left that gains.
const ROUNDS: usize = 60;

pub fn sorted(program: &[u8]) -> anyhow::Result<Vec<u8>> {
    let mut n_imported = 0;
    let mut bodies = Vec::new();
    for payload in Parser::new(0).parse_all(program) {
        match payload? {
            Payload::ImportSection(section) => {
                for import in section.into_imports() {
                    let is_function = matches!(import?.ty, TypeRef::Func(_));
                    n_imported += usize::from(is_function);
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(body.as_bytes()),
            _ => {}
        }
    }
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    let n_kept = N_KEPT.saturating_sub(n_imported).min(order.len());
    // What begins alike begins on one side.
    order[n_kept..].sort_by_key(|&function| bodies[function]);
    Halving::new(&bodies).order(&mut order[n_kept..]);
    let mut module = Module::new();
    let mut moved = Moved::new(order, n_imported);
    moved
        .parse_core_module(&mut module, Parser::new(0), program)
        .context("a function cannot be moved")?;
    Ok(module.finish())
}

/// Writes a program with its functions in another order.
struct Moved {
    order: Vec<usize>,
    /// By the index that a function had, imported ones first.
    to: Vec<u32>,
}

impl Moved {
    fn new(order: Vec<usize>, n_imported: usize) -> Self {
        let mut to: Vec<u32> = (0..).take(n_imported + order.len()).collect();
        for (now, &before) in (n_imported as u32..).zip(&order) {
            to[n_imported + before] = now;
        }
        Self { order, to }
    }
}

impl Reencode for Moved {
    type Error = Infallible;

    fn function_index(&mut self, idx: u32) -> Result<u32, Error<Infallible>> {
        Ok(self.to[idx as usize])
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        section: FunctionSectionReader<'_>,
    ) -> Result<(), Error<Infallible>> {
        let types = section.into_iter().collect::<Result<Vec<u32>, _>>()?;
        for &before in &self.order {
            functions.function(types[before]);
        }
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        section: CodeSectionReader<'_>,
    ) -> Result<(), Error<Infallible>> {
        let bodies = section
            .into_iter()
            .collect::<Result<Vec<FunctionBody<'_>>, _>>()?;
        for before in self.order.clone() {
            utils::parse_function_body(self, code, bodies[before].clone())?;
        }
        Ok(())
    }
}

struct Halving {
    /// Of each function, the words in it, each once.
    words: Vec<Vec<u32>>,
    /// By the word: its number among those of the functions that are halved.
    numbers: Vec<u32>,
    /// x log x, by x.
    costs: Vec<f32>,
}

impl Halving {
    fn new(bodies: &[&[u8]]) -> Self {
        let spelt = |body: &&[u8]| -> Vec<[u8; WORD]> {
            let mut words: Vec<_> = body.array_windows().copied().collect();
            words.sort_unstable();
            words.dedup();
            words
        };
        let spelt: Vec<_> = bodies.iter().map(spelt).collect();
        let mut all = spelt.concat();
        all.sort_unstable();
        all.dedup();
        let number = |word| all.binary_search(word).expect("it is one of them") as u32;
        let cost = |x: usize| (x as f32) * (x as f32 + 1.0).log2();
        Self {
            words: spelt
                .iter()
                .map(|words| words.iter().map(number).collect())
                .collect(),
            numbers: vec![0; all.len()],
            costs: (0..=bodies.len() + 1).map(cost).collect(),
        }
    }

    fn order(&mut self, functions: &mut [usize]) {
        if functions.len() <= FEW {
            return;
        }
        let words = self.shared(functions);
        let mut is_right: Vec<bool> = (0..functions.len())
            .map(|i| 2 * i >= functions.len())
            .collect();
        for round in 0..ROUNDS {
            let gains = self.gains(&words, &is_right);
            if !exchange(&gains, &mut is_right, round) {
                break;
            }
        }
        let half = |side: bool| {
            functions
                .iter()
                .zip(&is_right)
                .filter(move |(_, is)| **is == side)
        };
        let halved: Vec<usize> = half(false)
            .chain(half(true))
            .map(|(&function, _)| function)
            .collect();
        let n_left = is_right.iter().filter(|is_right| !**is_right).count();
        functions.copy_from_slice(&halved);
        let (left, right) = functions.split_at_mut(n_left);
        self.order(left);
        self.order(right);
    }

    /// Of each of these functions, the words that another one of them has, too, numbered from 0 on.
    fn shared(&mut self, functions: &[usize]) -> Vec<Vec<u32>> {
        let words = || functions.iter().map(|&function| &self.words[function]);
        for &word in words().flatten() {
            self.numbers[word as usize] = 0;
        }
        for &word in words().flatten() {
            self.numbers[word as usize] += 1;
        }
        let shared = words().map(|words| {
            let shared = words
                .iter()
                .copied()
                .filter(|&word| self.numbers[word as usize] > 1);
            shared.collect::<Vec<u32>>()
        });
        let mut shared: Vec<Vec<u32>> = shared.collect();
        let mut n_words = 0;
        // From here on a number is one of these words, plus 2 where it has been met.
        for word in shared.iter().flatten() {
            self.numbers[*word as usize] = u32::MAX;
        }
        for word in shared.iter_mut().flatten() {
            let number = &mut self.numbers[*word as usize];
            if *number == u32::MAX {
                *number = n_words;
                n_words += 1;
            }
            *word = *number;
        }
        shared
    }

    /// Of each function, what its words gain when it goes to the other half.
    fn gains(&self, functions: &[Vec<u32>], is_right: &[bool]) -> Vec<f32> {
        let n_words = functions
            .iter()
            .flatten()
            .max()
            .map_or(0, |&last| last as usize + 1);
        let mut counts = vec![[0_usize; 2]; n_words];
        for (words, &is_right) in functions.iter().zip(is_right) {
            for &word in words {
                counts[word as usize][usize::from(is_right)] += 1;
            }
        }
        let cost = |x: usize| self.costs[x];
        let gains: Vec<[f32; 2]> = counts
            .iter()
            .map(|&[left, right]| {
                let now = cost(left) + cost(right);
                let to_right = cost(left.saturating_sub(1)) + cost(right + 1) - now;
                let to_left = cost(left + 1) + cost(right.saturating_sub(1)) - now;
                [to_right, to_left]
            })
            .collect();
        let gain = |(words, &is_right): (&Vec<u32>, &bool)| {
            let gains = words
                .iter()
                .map(|&word| gains[word as usize][usize::from(is_right)]);
            gains.sum()
        };
        functions.iter().zip(is_right).map(gain).collect()
    }
}

/// Exchanges pairs of functions that both gain by that together; is there one?
fn exchange(gains: &[f32], is_right: &mut [bool], round: usize) -> bool {
    let side = |side: bool| {
        let mut those: Vec<usize> = (0..gains.len()).filter(|&i| is_right[i] == side).collect();
        those.sort_by(|&a, &b| gains[b].partial_cmp(&gains[a]).unwrap_or(Ordering::Equal));
        those
    };
    let pairs = side(false).into_iter().zip(side(true));
    let gaining = pairs.take_while(|&(left, right)| gains[left] + gains[right] > 0.0);
    let pairs: Vec<(usize, usize)> = gaining.collect();
    for (nth, &(left, right)) in pairs.iter().enumerate() {
        // Where all go at once two groups change places for ever: every fifth stays, another one each time.
        if (nth + round) % 5 != 4 {
            is_right.swap(left, right);
        }
    }
    !pairs.is_empty()
}
