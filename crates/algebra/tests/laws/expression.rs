//! The value of printed text, by recursive descent; it knows nothing of the printer.

use refinable_algebra::{Rational, parse_rational, rational};

use crate::generate::Values;

/// The value of an expression in `+ - * / ^ ( )`, numbers and the names in `values`.
///
/// # Panics
/// If the text is no such expression.
pub fn evaluate(text: &str, values: &Values) -> Rational {
    let mut reader = Reader { rest: text.trim(), values };
    let value = reader.sum();
    assert!(reader.rest.is_empty(), "unread: {}", reader.rest);
    value
}

struct Reader<'a> {
    rest: &'a str,
    values: &'a Values,
}

impl Reader<'_> {
    fn take(&mut self, sign: char) -> bool {
        let rest = self.rest.trim_start().strip_prefix(sign);
        if let Some(rest) = rest {
            self.rest = rest.trim_start();
        }
        rest.is_some()
    }

    fn sum(&mut self) -> Rational {
        let mut sum = if self.take('-') { -self.product() } else { self.product() };
        loop {
            if self.take('+') {
                sum += self.product();
            } else if self.take('-') {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Rational {
        let mut product = self.power();
        loop {
            if self.take('*') {
                product *= self.power();
            } else if self.take('/') {
                product /= self.power();
            } else {
                return product;
            }
        }
    }

    fn power(&mut self) -> Rational {
        let base = self.atom();
        if !self.take('^') {
            return base;
        }
        let exponent: u32 = self.word().parse().expect("an exponent");
        (0..exponent).fold(rational(1, 1), |power, _| power * &base)
    }

    fn atom(&mut self) -> Rational {
        if self.take('(') {
            let value = self.sum();
            assert!(self.take(')'), "a bracket stays open before {}", self.rest);
            return value;
        }
        let word = self.word();
        let number = || parse_rational(&word).expect("a number or a known name");
        self.values.get(&word).cloned().unwrap_or_else(number)
    }

    fn word(&mut self) -> String {
        let end = self.rest.find(|c: char| !c.is_ascii_alphanumeric());
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        word.into()
    }
}
