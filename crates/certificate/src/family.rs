//! The symbol of a family, its difference symbol and its matrices, in integers.

use refinable_algebra::{
    Domain, GcdDomain, Integer, Polynomial, Rational, Ring, clear_denominators, integer,
};

use crate::gcd::primitive;
use crate::limits;
use crate::model::{Coefficients, Curve, Family};
use crate::work::{Check, Work, ensure, fail, largest_bits, polynomial_bits, rational_bits};

/// `Σ (p_i + q_i t) z^i / denominator`, the number of coefficients as the mask has it.
#[derive(Clone, Debug)]
pub(crate) struct AffineSymbol {
    /// The constant parts.
    pub p: Vec<Integer>,
    /// The slopes.
    pub q: Vec<Integer>,
    /// The common denominator, positive.
    pub denominator: Integer,
}

impl AffineSymbol {
    fn of_mask(mask: &[Coefficients], constant: bool) -> Check<Self> {
        let zero = Rational::from(integer(0));
        let mut numbers = Vec::with_capacity(2 * mask.len());
        for coefficient in mask {
            let polynomial = Polynomial::new(coefficient.iter().map(|c| c.0.clone()).collect());
            let degree = polynomial.degree().unwrap_or(0);
            ensure(degree <= 1, "a coefficient of the mask is not affine in the parameter")?;
            ensure(degree == 0 || !constant, "the mask is not constant but has no parameter")?;
            let at = |k: usize| polynomial.coefficients().get(k).unwrap_or(&zero).clone();
            numbers.extend([at(0), at(1)]);
        }
        let (denominator, cleared) = clear_denominators(numbers.iter());
        let (p, q) = cleared.chunks(2).map(|pair| (pair[0].clone(), pair[1].clone())).unzip();
        Ok(AffineSymbol { p, q, denominator })
    }

    /// The coefficients of a symbol without parameter.
    pub fn values(&self) -> Vec<Rational> {
        self.p.iter().map(|p| Rational::new(p.clone(), self.denominator.clone())).collect()
    }

    /// The degree that the number of coefficients gives.
    pub fn degree(&self) -> usize {
        self.p.len() - 1
    }

    /// The symbol at one value of the parameter.
    pub fn at(&self, t: &Rational, work: &mut Work) -> Check<Self> {
        let bits = rational_bits(t).max(largest_bits(self.p.iter().chain(&self.q)));
        work.products(2 * self.p.len(), bits, bits)?;
        let value = |(p, q): (&Integer, &Integer)| p * t.denom() + q * t.numer();
        let p = self.p.iter().zip(&self.q).map(value).collect();
        let q = vec![Integer::zero(); self.q.len()];
        Ok(AffineSymbol { p, q, denominator: &self.denominator * t.denom() })
    }

    /// The symbol times a positive integer.
    pub fn scaled(mut self, factor: &Integer) -> Self {
        let common = GcdDomain::gcd(factor, &self.denominator);
        let factor = factor / &common;
        self.denominator /= common;
        self.p.iter_mut().chain(&mut self.q).for_each(|c| *c *= &factor);
        self
    }

    /// The quotient by `σ^times` for arity `m`, if it is one identically in the parameter.
    pub fn divided_by_geometric(&self, m: usize, times: usize) -> Option<Self> {
        let mut quotient = self.clone();
        for _ in 0..times {
            quotient.p = divide_by_geometric(&quotient.p, m)?;
            quotient.q = divide_by_geometric(&quotient.q, m)?;
        }
        Some(quotient)
    }

    /// `a(z) q(z)/q(z²)` for a symbol without parameter, as many coefficients fewer as `q` has
    /// degrees.
    fn reduced(self, factor: &Polynomial<Integer>, work: &mut Work) -> Check<Self> {
        let q = primitive(factor, work)?;
        let regular = !q.coefficient(0).is_zero() && !q.evaluate(&integer(1)).is_zero();
        ensure(regular, "the factor vanishes at zero or at one")?;
        let degree = q.degree().unwrap_or(0);
        ensure(degree < self.p.len(), "the factor does not divide")?;
        let squares = Polynomial::new(with_squares(q.coefficients()));
        // If the division is not exact, every step may add the length of the divisor.
        let steps = self.p.len() - degree;
        let (bits, step) = (largest_bits(&self.p), polynomial_bits(&q) + 1);
        work.products(self.p.len() * (degree + 1), bits, step)?;
        work.products(steps * (2 * degree + 1), bits + (steps as u64 + 2) * step, step)?;
        // The divisor is primitive: the quotient has integer coefficients if it is one.
        let Some(quotient) = Polynomial::new(self.p.clone()).times(&q).divide_exactly(&squares)
        else {
            return fail("the factor does not divide");
        };
        let mut p = quotient.coefficients().to_vec();
        p.resize(self.p.len() - degree, Integer::zero());
        Ok(AffineSymbol { q: vec![Integer::zero(); p.len()], p, denominator: self.denominator })
    }

    /// Whether `c_i = c_{M-i}` identically in the parameter.
    pub fn is_symmetric(&self) -> bool {
        self.p.iter().eq(self.p.iter().rev()) && self.q.iter().eq(self.q.iter().rev())
    }

    /// Whether the parameter does not occur.
    pub fn is_constant(&self) -> bool {
        self.q.iter().all(Ring::is_zero)
    }
}

/// `p(z²)`.
pub(crate) fn with_squares(p: &[Integer]) -> Vec<Integer> {
    let mut spread = vec![Integer::zero(); (2 * p.len()).saturating_sub(1)];
    for (i, c) in p.iter().enumerate() {
        spread[2 * i] = c.clone();
    }
    spread
}

/// `p / (1 + z + … + z^(m-1))`, from `q (1 - z^m) = p (1 - z)`.
pub(crate) fn divide_by_geometric<R: Ring>(p: &[R], m: usize) -> Option<Vec<R>> {
    let length = p.len().checked_sub(m - 1).filter(|&n| n > 0)?;
    let zero = R::zero();
    let mut quotient: Vec<R> = Vec::with_capacity(p.len() + 1);
    for i in 0..=p.len() {
        let before = i.checked_sub(1).map_or(&zero, |k| &p[k]);
        let difference = p.get(i).unwrap_or(&zero).minus(before);
        quotient.push(
            i.checked_sub(m).map_or_else(|| difference.clone(), |k| difference.plus(&quotient[k])),
        );
    }
    let exact = quotient.split_off(length).iter().all(Ring::is_zero);
    exact.then_some(quotient)
}

/// A family, or one member of it, with the order of its difference symbol.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The arity `m`.
    pub arity: usize,
    /// The order `k`.
    pub order: usize,
    /// The symbol `a`.
    pub symbol: AffineSymbol,
    /// The difference symbol `c`.
    pub difference: AffineSymbol,
    /// Whether there is no parameter.
    pub constant: bool,
}

impl Scheme {
    /// The family of a certificate, checked to be affine, normalised and divisible.
    pub fn new(family: &Family, work: &mut Work) -> Check<Self> {
        ensure(family.arity >= 2, "the arity is less than two")?;
        ensure(family.mask.len() >= family.arity, "the mask is shorter than the arity")?;
        let symbol = AffineSymbol::of_mask(&family.mask, family.parameter.is_none())?;
        for j in 0..family.arity {
            let sum = |c: &[Integer]| c.iter().skip(j).step_by(family.arity).sum::<Integer>();
            let normalised = sum(&symbol.p) == symbol.denominator && sum(&symbol.q).is_zero();
            ensure(normalised, "a stencil does not sum to one")?;
        }
        Scheme::of_symbol(family.arity, family.order, symbol, family.parameter.is_none(), work)
    }

    /// The member at one value of the parameter, with an order of its own.
    pub fn at(&self, t: &Rational, order: usize, work: &mut Work) -> Check<Self> {
        Scheme::of_symbol(self.arity, order, self.symbol.at(t, work)?, true, work)
    }

    /// The member at one value of the parameter, its symbol multiplied by `q(z)/q(z²)`.
    pub fn reduced(
        &self,
        t: &Rational,
        factor: &Polynomial<Integer>,
        order: usize,
        work: &mut Work,
    ) -> Check<Self> {
        ensure(self.arity == 2, "a `reduced` lemma is for arity two only")?;
        let symbol = self.symbol.at(t, work)?.reduced(factor, work)?;
        Scheme::of_symbol(self.arity, order, symbol, true, work)
    }

    fn of_symbol(
        arity: usize,
        order: usize,
        symbol: AffineSymbol,
        constant: bool,
        work: &mut Work,
    ) -> Check<Self> {
        ensure(order >= 1, "the order is less than one")?;
        let difference = difference_symbol(&symbol, arity, order, work)?;
        Ok(Scheme { arity, order, symbol, difference, constant })
    }

    /// `m^(k-1-n)`, if `n < k`.
    pub fn bound(&self, continuity: usize) -> Check<Integer> {
        match (self.order - 1).checked_sub(continuity) {
            Some(exponent) => Ok(integer(self.arity as i64).power(exponent as u32)),
            None => fail("the continuity is not less than the order"),
        }
    }

    /// `m^n a / σ^(n+1)`, the difference symbol of a lower order.
    pub fn lower_difference(&self, continuity: usize, work: &mut Work) -> Check<AffineSymbol> {
        self.bound(continuity)?;
        difference_symbol(&self.symbol, self.arity, continuity + 1, work)
    }

    /// The size of the matrices.
    pub fn dimension(&self) -> usize {
        dimension(self.difference.degree(), self.arity)
    }

    /// Whether `σ^order` divides the symbol identically.
    pub fn is_divisible(&self, order: usize) -> bool {
        let possible = order.checked_mul(self.arity - 1).is_some_and(|n| n < self.symbol.p.len());
        possible && self.symbol.divided_by_geometric(self.arity, order).is_some()
    }
}

/// `max(1, ⌈M/(m-1)⌉)`.
pub(crate) fn dimension(degree: usize, arity: usize) -> usize {
    degree.div_ceil(arity - 1).max(1)
}

/// `m^(k-1) a / σ^k`.
fn difference_symbol(
    symbol: &AffineSymbol,
    arity: usize,
    order: usize,
    work: &mut Work,
) -> Check<AffineSymbol> {
    let length = order.checked_mul(arity - 1).filter(|&n| n <= symbol.degree());
    ensure(length.is_some(), "the order is too large for the length of the mask")?;
    let bits = largest_bits(symbol.p.iter().chain(&symbol.q)) + 64;
    work.products(2 * symbol.p.len() * (order + 1), bits, 64)?;
    match symbol.divided_by_geometric(arity, order) {
        Some(quotient) => Ok(quotient.scaled(&integer(arity as i64).power(order as u32 - 1))),
        None => fail("the symbol is not divisible as often as the order says"),
    }
}

/// The matrices `B_ε(x) = (P_ε + x Q_ε) / denominator`.
#[derive(Clone, Debug)]
pub(crate) struct Letters {
    /// The size.
    pub dimension: usize,
    /// `P_ε` and `Q_ε`, row by row, for each letter.
    pub pairs: Vec<[Vec<Integer>; 2]>,
    /// The common denominator, positive.
    pub denominator: Integer,
}

impl Letters {
    /// The matrices of the pencil "parameter".
    pub fn of_parameter(scheme: &Scheme, continuity: usize) -> Check<Self> {
        let c = &scheme.difference;
        let pairs = [&c.p, &c.q].map(|part| matrices(part, scheme.arity));
        let denominator = &c.denominator * scheme.bound(continuity)?;
        Ok(Letters::new(scheme, pairs, denominator))
    }

    /// The matrices of the pencil "scale".
    pub fn of_scale(scheme: &Scheme) -> Check<Self> {
        ensure(scheme.constant, "the scale of a family with a parameter")?;
        let c = &scheme.difference;
        let zeros = vec![Integer::zero(); c.p.len()];
        let pairs = [&zeros, &c.p].map(|part| matrices(part, scheme.arity));
        Ok(Letters::new(scheme, pairs, c.denominator.clone()))
    }

    fn new(scheme: &Scheme, parts: [Vec<Vec<Integer>>; 2], denominator: Integer) -> Self {
        let [constant, slope] = parts;
        let pairs = constant.into_iter().zip(slope).map(|(p, q)| [p, q]).collect();
        Letters { dimension: scheme.dimension(), pairs, denominator }
    }

    /// The letters of a word.
    pub fn word(&self, word: &str) -> Check<Vec<usize>> {
        letters(word, self.pairs.len(), limits::WORD)
    }

    /// `B_ε(x)` times the denominators, of the letters and of `x`.
    pub fn numerators_at(&self, letter: usize, x: &Rational) -> Vec<Integer> {
        let [p, q] = &self.pairs[letter];
        let entry = |(p, q): (&Integer, &Integer)| p * x.denom() + q * x.numer();
        p.iter().zip(q).map(entry).collect()
    }

    /// The bit length of the entries.
    pub fn bits(&self) -> u64 {
        largest_bits(self.pairs.iter().flatten().flatten()).max(self.denominator.bits())
    }
}

/// `A_ε[i][j] = c_{o+ε+i-mj}`, row by row, for each `ε`.
pub(crate) fn matrices<R: Ring>(c: &[R], m: usize) -> Vec<Vec<R>> {
    let all = places(c.len(), m).into_iter();
    let entry = |place: Option<usize>| place.map_or_else(R::zero, |i| c[i].clone());
    all.map(|places| places.into_iter().map(entry).collect()).collect()
}

/// The letters of a word of digits, each below `count`.
pub(crate) fn letters(word: &str, count: usize, longest: usize) -> Check<Vec<usize>> {
    ensure(!word.is_empty(), "a word is empty")?;
    ensure(word.len() <= longest, "a word is too long")?;
    let letter = |c: char| c.to_digit(10).map(|d| d as usize).filter(|&d| d < count);
    match word.chars().map(letter).collect() {
        Some(letters) => Ok(letters),
        None => fail("a word has a letter that is no matrix"),
    }
}

/// The index of `c` of each entry of the matrices, row by row, for each `ε`; `None` for zero.
pub(crate) fn places(length: usize, m: usize) -> Vec<Vec<Option<usize>>> {
    let d = dimension(length - 1, m);
    let first = (m - 1) * (d - 1);
    let place = |letter: usize, k: usize| {
        (first + letter + k / d).checked_sub(m * (k % d)).filter(|&i| i < length)
    };
    (0..m).map(|letter| (0..d * d).map(|k| place(letter, k)).collect()).collect()
}

/// Checks that another family runs along the line of masks as the certificate says.
pub(crate) fn check_curve(family: &Family, curve: &Curve, work: &mut Work) -> Check<()> {
    ensure(curve.mask.len() == family.mask.len(), "the masks have different lengths")?;
    // Over one denominator each: mask/scale, and numerator/denominator up to the same factor.
    let numbers = curve.mask.iter().chain([&curve.denominator]).flatten().map(|c| &c.0);
    let (_, cleared) = clear_denominators(numbers);
    let mut rest = cleared.into_iter();
    let mut take = |c: &Coefficients| Polynomial::new(rest.by_ref().take(c.len()).collect());
    let mask: Vec<Polynomial<Integer>> = curve.mask.iter().map(&mut take).collect();
    let denominator = take(&curve.denominator);
    let line = [&curve.line.numerator, &curve.line.denominator];
    let (_, cleared) = clear_denominators(line.into_iter().flatten().map(|c| &c.0));
    let (top, bottom) = cleared.split_at(line[0].len());
    let [top, bottom] = [top, bottom].map(|c| Polynomial::new(c.to_vec()));
    ensure(!denominator.is_zero() && !bottom.is_zero(), "a denominator is zero")?;
    let symbol = AffineSymbol::of_mask(&family.mask, family.parameter.is_none())?;
    let longest = |p: &[Polynomial<Integer>]| {
        let bits = p.iter().map(polynomial_bits).max().unwrap_or(0);
        (p.iter().map(|p| p.coefficients().len()).max().unwrap_or(0), bits)
    };
    let (n, a) = longest(&mask);
    let (l, b) = longest(&[denominator.clone(), top.clone(), bottom.clone()]);
    work.products(mask.len() * l * (n + 2 * l), a + b, a + b)?;
    for ((p, q), coefficient) in symbol.p.iter().zip(&symbol.q).zip(&mask) {
        let left = coefficient.times(&bottom).scaled(&symbol.denominator);
        let right = denominator.times(&bottom.scaled(p).plus(&top.scaled(q)));
        ensure(left == right, "the curve does not run along the line")?;
    }
    Ok(())
}
