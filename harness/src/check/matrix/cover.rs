//! Pairwise coverage: few combinations that together contain every pair of options that goes together (a covering array
//! of strength 2; Cohen, Dalal, Fredman and Patton 1997 describe the greedy search).

/// A combination: for each choice, the option that is taken, or `None` to leave the scene as it is.
pub(super) type Combination = Vec<Option<usize>>;

/// An option of a choice, both by index.
pub(super) type Taken = (usize, usize);

/// Combinations and what they cover.
#[derive(Debug)]
pub(super) struct Cover {
    /// The combinations.
    pub(super) combinations: Vec<Combination>,
    /// Number of pairs of options that are in a combination.
    pub(super) covered: usize,
    /// Pairs of options that do not go together, with any third option either.
    pub(super) refused: Vec<[Taken; 2]>,
}

/// Returns combinations that contain every pair of options that `goes` accepts, alone or with one option more.
/// `sizes` has the number of options of each choice.
///
/// Each combination starts from a pair that is not covered yet. The other choices follow in an order that changes from
/// one combination to the next, and each takes the option that covers the most new pairs.
pub(super) fn cover(sizes: &[usize], goes: impl Fn(&[Option<usize>]) -> bool) -> Cover {
    let mut seen = Seen::new(sizes);
    let mut found = Cover { combinations: Vec::new(), covered: 0, refused: Vec::new() };
    for first in options(sizes) {
        for second in options(sizes).filter(|second| second.0 > first.0) {
            if seen.has(first, second) {
                continue;
            }
            let Some(mut row) = with_both(sizes, first, second, &goes) else {
                found.refused.push([first, second]);
                continue;
            };
            fill(&mut row, sizes, &seen, found.combinations.len(), &goes);
            found.covered += seen.add(&row);
            found.combinations.push(row);
        }
    }
    found
}

/// Returns all options of all choices.
fn options(sizes: &[usize]) -> impl Iterator<Item = Taken> {
    sizes.iter().enumerate().flat_map(|(choice, &size)| (0..size).map(move |option| (choice, option)))
}

/// Returns the smallest combination that contains both options and goes together.
fn with_both(
    sizes: &[usize],
    first: Taken,
    second: Taken,
    goes: &impl Fn(&[Option<usize>]) -> bool,
) -> Option<Combination> {
    let mut row = vec![None; sizes.len()];
    for (choice, option) in [first, second] {
        row[choice] = Some(option);
    }
    if goes(&row) {
        return Some(row);
    }
    for (choice, option) in options(sizes) {
        if row[choice].is_none() {
            row[choice] = Some(option);
            if goes(&row) {
                return Some(row);
            }
            row[choice] = None;
        }
    }
    None
}

/// Takes an option of every choice that is still open, where one goes with the others.
fn fill(row: &mut Combination, sizes: &[usize], seen: &Seen, turn: usize, goes: &impl Fn(&[Option<usize>]) -> bool) {
    for i in 0..sizes.len() {
        let choice = (i + turn) % sizes.len();
        if row[choice].is_some() {
            continue;
        }
        let gain = |option: usize| taken(row).filter(|&other| !seen.has((choice, option), other)).count();
        let mut ranked: Vec<(usize, usize)> = (0..sizes[choice]).map(|option| (gain(option), option)).collect();
        // of equal options another one first in each turn; the sort keeps this order
        ranked.rotate_left(turn % sizes[choice]);
        ranked.sort_by_key(|&(gain, _)| usize::MAX - gain);
        for (_, option) in ranked {
            row[choice] = Some(option);
            if goes(row) {
                break;
            }
            row[choice] = None;
        }
    }
}

/// Returns the options that a combination takes.
fn taken(row: &[Option<usize>]) -> impl Iterator<Item = Taken> {
    row.iter().enumerate().filter_map(|(choice, option)| option.map(|option| (choice, option)))
}

/// The pairs that are covered.
struct Seen {
    /// Index of the first option of each choice among all options.
    first: Vec<usize>,
    all: usize,
    pairs: Vec<bool>,
}

impl Seen {
    fn new(sizes: &[usize]) -> Seen {
        let first = sizes.iter().scan(0, |sum, size| Some(std::mem::replace(sum, *sum + size))).collect();
        let all = sizes.iter().sum();
        Seen { first, all, pairs: vec![false; all * all] }
    }

    fn place(&self, one: Taken, two: Taken) -> usize {
        let [one, two] = [one, two].map(|(choice, option)| self.first[choice] + option);
        one.min(two) * self.all + one.max(two)
    }

    fn has(&self, one: Taken, two: Taken) -> bool {
        self.pairs[self.place(one, two)]
    }

    /// Adds all pairs of a combination and returns the number of those that are new.
    fn add(&mut self, row: &[Option<usize>]) -> usize {
        let mut new = 0;
        for one in taken(row) {
            for two in taken(row).filter(|two| two.0 > one.0) {
                let place = self.place(one, two);
                new += usize::from(!self.pairs[place]);
                self.pairs[place] = true;
            }
        }
        new
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_that_goes_together_is_covered_and_the_others_are_named() {
        let sizes = [2, 3, 4, 2, 5];
        // option 1 of choice 0 does not go with option 2 of choice 1, and option 3 of choice 2 needs option 0 of choice
        // 3
        let goes = |row: &[Option<usize>]| {
            !(row[0] == Some(1) && row[1] == Some(2)) && (row[2] != Some(3) || row[3] == Some(0))
        };
        let found = cover(&sizes, goes);
        assert_eq!(found.refused, [[(0, 1), (1, 2)], [(2, 3), (3, 1)]]);
        let pairs: usize = (0..5).flat_map(|i| (0..i).map(move |j| sizes[i] * sizes[j])).sum();
        assert_eq!(found.covered, pairs - 2);
        assert!(found.combinations.iter().all(|row| goes(row)));
        for one in options(&sizes) {
            for two in options(&sizes).filter(|two| two.0 > one.0) {
                let together = |row: &Combination| row[one.0] == Some(one.1) && row[two.0] == Some(two.1);
                assert!(
                    found.combinations.iter().any(together) != found.refused.contains(&[one, two]),
                    "{one:?} {two:?}"
                );
            }
        }
        // the two largest choices alone need 20
        assert!(found.combinations.len() < 35, "{}", found.combinations.len());
    }
}
