//! Rounds in turn, medians, and a table.

use std::{fs, time::Instant};

/// One of those that are measured.
pub struct Contender<'a> {
    name: &'static str,
    work: Box<dyn FnMut() + 'a>,
}

impl<'a> Contender<'a> {
    pub fn new(name: &'static str, work: impl FnMut() + 'a) -> Self {
        let work = Box::new(work);
        Self { name, work }
    }
}

/// Seconds of each contender in each round.
pub struct Results {
    names: Vec<&'static str>,
    rounds: Vec<Vec<f64>>,
}

/// Lets every contender run once a round, after one round that does not count.
pub fn race(n_rounds: usize, mut contenders: Vec<Contender>) -> Results {
    let mut rounds = Vec::with_capacity(n_rounds);
    for round in 0..=n_rounds {
        let secs = contenders.iter_mut().map(|contender| {
            let start = Instant::now();
            (contender.work)();
            start.elapsed().as_secs_f64()
        });
        let secs: Vec<f64> = secs.collect();
        if round > 0 {
            rounds.push(secs);
        }
    }
    let names = contenders.iter().map(|contender| contender.name).collect();
    Results { names, rounds }
}

impl Results {
    /// Median seconds of a contender.
    pub fn secs(&self, name: &str) -> f64 {
        let i = self.idx(name);
        median(self.rounds.iter().map(|round| round[i]))
    }

    /// Median, over the rounds, of one contender's time over another's in the same round: what slows a
    /// round slows both.
    pub fn ratio(&self, name: &str, base: &str) -> f64 {
        let (i, j) = (self.idx(name), self.idx(base));
        median(self.rounds.iter().map(|round| round[i] / round[j]))
    }

    fn idx(&self, name: &str) -> usize {
        let found = self.names.iter().position(|known| *known == name);
        found.unwrap_or_else(|| panic!("no contender is called {name}"))
    }
}

/// The middle one.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    quantile(values, 0.5)
}

/// The value below which a `part` of them lie.
pub fn quantile(values: impl IntoIterator<Item = f64>, part: f64) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values[(values.len() as f64 * part) as usize]
}

/// What a figure is to be.
#[derive(Clone, Copy)]
pub enum Target {
    None,
    AtMost(f64),
    #[cfg(feature = "gui")]
    AtLeast(f64),
}

impl Target {
    /// The two last cells of a row.
    pub fn cells(self, figure: f64) -> String {
        let (target, met) = match self {
            Self::None => return "|".to_owned(),
            Self::AtMost(most) => (format!("≤ {most}"), figure <= most),
            #[cfg(feature = "gui")]
            Self::AtLeast(least) => (format!("≥ {least}"), figure >= least),
        };
        format!("{target} | {}", if met { "met" } else { "missed" })
    }
}

/// The processor's name and how many of it there are.
pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let mut models = info
        .lines()
        .filter_map(|line| line.strip_prefix("model name"));
    let model = models
        .next()
        .map_or("unknown", |rest| rest.trim_start_matches([' ', '\t', ':']));
    let n = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {n} hardware threads")
}
