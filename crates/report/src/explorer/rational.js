// ---- rational.js: exact numbers in big integers. What is decided is decided here, never in floats.

const signOf = (n) => (n > 0n ? 1 : n < 0n ? -1 : 0);

function gcd(a, b) {
  while (b) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
}

/** n/d in lowest terms, d > 0. */
function ratio(n, d = 1n) {
  const g = gcd(n, d) * (d < 0n ? -1n : 1n);
  return { n: n / g, d: d / g };
}

const ZERO = ratio(0n);
const ONE = ratio(1n);
const plus = (a, b) => ratio(a.n * b.d + b.n * a.d, a.d * b.d);
const minus = (a, b) => ratio(a.n * b.d - b.n * a.d, a.d * b.d);
const times = (a, b) => ratio(a.n * b.n, a.d * b.d);
const over = (a, b) => ratio(a.n * b.d, a.d * b.n);
const compare = (a, b) => signOf(a.n * b.d - b.n * a.d);
const isZero = (a) => a.n === 0n;
const equal = (a, b) => a.n === b.n && a.d === b.d;
const toText = (a) => (a.d === 1n ? `${a.n}` : `${a.n}/${a.d}`);

/** The nearest float or one beside it; numerators and denominators may be beyond all floats. */
function toFloat({ n, d }) {
  const [top, bottom] = [Number(n), Number(d)];
  if (Number.isFinite(top) && Number.isFinite(bottom)) return top / bottom;
  const digits = Math.max(n.toString(16).length, d.toString(16).length);
  const cut = BigInt(4 * (digits - 200));
  return Number(n >> cut) / Number(d >> cut);
}

/** The most characters of a number that is typed: more would only make the page slow. */
const LONGEST_NUMBER = 80;

/** `1/16`, `-0.05`, `3`; null for anything else. */
function parseRational(text) {
  const plain = text.trim().replace("\u2212", "-");
  if (plain.length > LONGEST_NUMBER) return null;
  const parts = /^([+-]?)(\d*)(?:\.(\d*))?(?:\s*\/\s*(\d+))?$/.exec(plain);
  if (!parts) return null;
  const [, sign, whole, decimals = "", below] = parts;
  if (whole + decimals === "" || (below !== undefined && /^0*$/.test(below))) return null;
  const top = BigInt(whole + decimals) * (sign === "-" ? -1n : 1n);
  return ratio(top, 10n ** BigInt(decimals.length) * BigInt(below ?? "1"));
}

/** The multiple of 1/count next to a float. */
const nearest = (x, count) => ratio(BigInt(Math.round(x * count)), BigInt(count));

/** Embedded terms `[c, i, j]`, read once. */
const readTerms = (terms) => terms.map(([c, i, j]) => ({ c: parseRational(c), i, j }));

/** The value at a point of one, two or no coordinates. */
function evaluate(terms, point) {
  const power = (k, e) => (e === 0 ? ONE : ratio(point[k].n ** BigInt(e), point[k].d ** BigInt(e)));
  return terms.reduce(
    (sum, { c, i, j }) => plus(sum, times(c, times(power(0, i), power(1, j)))),
    ZERO,
  );
}

const evaluateFloat = (terms, [x, y = 0]) =>
  terms.reduce((sum, { c, i, j }) => sum + toFloat(c) * x ** i * y ** j, 0);

/** An embedded end: a rational number, or the only root of a polynomial between two of them. */
function readNumber(value) {
  if (value === null) return null;
  if (typeof value === "string") return { exact: parseRational(value) };
  const [lower, upper] = [value.lower, value.upper].map(parseRational);
  return { polynomial: value.polynomial.map(BigInt), lower, upper };
}

const numberToFloat = (end) => toFloat(end.exact ?? over(plus(end.lower, end.upper), ratio(2n)));

/** The sign of a polynomial, ascending, at n/d: of Σ c_k n^k d^(m-k). */
function signAt(polynomial, { n, d }) {
  let [sum, power] = [0n, 1n];
  for (const c of [...polynomial].reverse()) {
    sum = sum * n + c * power;
    power *= d;
  }
  return signOf(sum);
}

/** The sign of x - end. Inside of the isolating interval the polynomial tells: it changes its sign once. */
function sideOf(x, end) {
  if (end.exact) return compare(x, end.exact);
  if (compare(x, end.lower) <= 0) return -1;
  if (compare(x, end.upper) >= 0) return 1;
  const sign = signAt(end.polynomial, x);
  return sign === 0 ? 0 : sign === signAt(end.polynomial, end.lower) ? -1 : 1;
}

/** Whether x is in an embedded interval. */
function isInside(x, { lower, upper, closed }) {
  const below = lower === null ? 1 : sideOf(x, lower);
  const above = upper === null ? -1 : sideOf(x, upper);
  return (below > 0 || (below === 0 && closed[0])) && (above < 0 || (above === 0 && closed[1]));
}

const readInterval = (interval) => ({
  ...interval,
  lower: readNumber(interval.lower),
  upper: readNumber(interval.upper),
});

/** The least common denominator of numbers, and their numerators over it. */
function cleared(numbers) {
  const common = numbers.reduce((m, { d }) => (m / gcd(m, d)) * d, 1n);
  return { common, tops: numbers.map(({ n, d }) => n * (common / d)) };
}

/** Whether a determinant of integers vanishes, by Bareiss' elimination. */
function isSingular(rows) {
  const size = rows.length;
  let last = 1n;
  for (let k = 0; k < size; k++) {
    const pivot = rows.findIndex((row, i) => i >= k && row[k] !== 0n);
    if (pivot < 0) return true;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let i = k + 1; i < size; i++) {
      for (let j = k + 1; j < size; j++) {
        rows[i][j] = (rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j]) / last;
      }
    }
    last = rows[k][k];
  }
  return false;
}

/** Whether the resultant of two polynomials does not vanish, the shorter one padded with zeros to the formal
    degree of the longer one: the determinant of Bezout's matrix. */
function areCoprime(a, b) {
  const [long, short] = a.length >= b.length ? [a, b] : [b, a];
  const n = long.length - 1;
  if (n < 1) return [...long, ...short].some((c) => c !== 0n);
  const at = (list, k) => list[k] ?? 0n;
  const rows = Array.from({ length: n }, () => Array(n).fill(0n));
  for (let i = 0; i < n; i++) {
    for (let j = i; j < n; j++) {
      const carried = i > 0 && j + 1 < n ? rows[i - 1][j + 1] : 0n;
      rows[i][j] = at(long, j + 1) * at(short, i) - at(long, i) * at(short, j + 1) + carried;
      rows[j][i] = rows[i][j];
    }
  }
  return !isSingular(rows);
}

/** Up to a sign f(z) f(-z) as a polynomial in z². */
function ofSquares(f) {
  const squares = f.map(() => 0n);
  f.forEach((a, i) =>
    f.forEach((b, j) => {
      if ((i + j) % 2 === 0) squares[(i + j) / 2] += j % 2 === 0 ? a * b : -a * b;
    }),
  );
  return squares;
}
