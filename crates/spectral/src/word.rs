//! Words over the letters of a pencil.

use std::fmt;

/// The most words of one length that are looked at: those of eight of four letters.
const MOST_WORDS: usize = 1 << 16;

/// A product of matrices: letters are applied from left to right, `Π_w = B_{w_l} ⋯ B_{w_1}`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Word(Vec<u8>);

impl Word {
    /// The letters.
    pub fn letters(&self) -> &[u8] {
        &self.0
    }

    /// One word of each class under rotation, and under the mirror image `ε ↔ m-1-ε` if `mirrored`,
    /// that is no power of a shorter one; shorter words first. The product of any word has the
    /// spectral radius of a power of one of these.
    ///
    /// No longer than `longest`, and no longer than that there are 65 536 words of one length: with two to
    /// four letters of eight letters, with ten of four.
    ///
    /// # Panics
    /// If there are more than 256 letters.
    ///
    /// # Cost
    /// `letters^length` words are looked at.
    pub fn necklaces(letters: usize, longest: usize, mirrored: bool) -> Vec<Word> {
        assert!(letters <= 256, "a letter is a byte");
        let mut all = Vec::new();
        for length in 1..=longest {
            let count = letters.checked_pow(length as u32);
            let Some(count) = count.filter(|count| *count <= MOST_WORDS) else { break };
            let words = (0..count).map(|code| Word::from_code(code, letters, length));
            all.extend(words.filter(|word| {
                word.is_lyndon() && (!mirrored || *word <= word.mirrored(letters).least_rotation())
            }));
        }
        all
    }

    fn from_code(mut code: usize, letters: usize, length: usize) -> Word {
        let mut word = vec![0; length];
        for letter in word.iter_mut().rev() {
            *letter = (code % letters) as u8;
            code /= letters;
        }
        Word(word)
    }

    fn rotations(&self) -> impl Iterator<Item = Vec<u8>> {
        (1..self.0.len()).map(|k| [&self.0[k..], &self.0[..k]].concat())
    }

    /// Strictly less than all its rotations: the representative of an aperiodic necklace.
    fn is_lyndon(&self) -> bool {
        self.rotations().all(|rotation| self.0 < rotation)
    }

    fn least_rotation(&self) -> Word {
        Word(self.rotations().chain([self.0.clone()]).min().unwrap_or_default())
    }

    /// Whether the second half is the first with `ε` replaced by `m-1-ε`.
    pub(crate) fn is_its_mirror_image(&self, letters: usize) -> bool {
        let (first, second) = self.0.split_at(self.0.len() / 2);
        self.0.len().is_multiple_of(2) && Word(first.to_vec()).mirrored(letters).0 == second
    }

    /// The word with `ε` replaced by `m-1-ε`.
    fn mirrored(&self, letters: usize) -> Word {
        Word(self.0.iter().map(|&letter| (letters - 1) as u8 - letter).collect())
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|letter| write!(f, "{letter}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(mirrored: bool) -> Vec<String> {
        Word::necklaces(2, 4, mirrored).iter().map(Word::to_string).collect()
    }

    #[test]
    fn binary_necklaces_up_to_length_four() {
        assert_eq!(texts(false), ["0", "1", "01", "001", "011", "0001", "0011", "0111"]);
        assert_eq!(texts(true), ["0", "01", "001", "0001", "0011"]);
    }

    /// Witt's formula: 2, 1, 2, 3, 6, 9, 18, 30 aperiodic binary necklaces.
    #[test]
    fn as_many_as_witt_says() {
        let all = Word::necklaces(2, 8, false);
        let counts: Vec<usize> =
            (1..=8).map(|l| all.iter().filter(|w| w.letters().len() == l).count()).collect();
        assert_eq!(counts, [2, 1, 2, 3, 6, 9, 18, 30]);
    }

    /// By Moreau's formula there are `(m^l - m) / l` aperiodic necklaces of a prime length.
    #[test]
    fn words_over_many_letters_are_short() {
        for (letters, longest) in [(2, 8), (3, 8), (4, 8), (5, 6), (6, 6), (7, 5), (10, 4)] {
            let last = Word::necklaces(letters, 8, false).pop().expect("there are words");
            assert_eq!(last.letters().len(), longest, "{letters} letters");
        }
        assert_eq!(Word::necklaces(200, 8, false).len(), 200 + (200 * 200 - 200) / 2);
        assert_eq!(Word::necklaces(256, 1, true).len(), 128);
    }
}
