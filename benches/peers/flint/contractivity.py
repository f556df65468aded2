#!/usr/bin/env python3
"""contractivity.py: exact contractivity ranges of one-parameter subdivision schemes, in python-flint 0.9.

    python3 benches/peers/contractivity.py a4 0 6

prints, as one JSON object, for each level l = 1..L the exact set of parameters with ||c_n^l|| < 1, and under "proved"
the union of these sets. Schemes, method, order of the steps and output are those of contractivity.gp; read its header
first. Every decision is exact: fmpz_mat for the Bernstein coefficients, fmpz_poly factorisation, and certified balls
(complex_roots, whose real roots are marked as such), taken as enclosures once an exact sign change confirms them.
"""

import sys
from functools import cmp_to_key
from math import comb, lcm

from flint import ctx, fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_mat, fmpz_poly

BISECTIONS = 40  # at most so many before exact_node; 0 runs the textbook algorithm alone (same result, slower)


# ---- the symbols ---------------------------------------------------------------------------------------------------


def z(k=1):
    return fmpq_poly([0] * k + [1])


def scheme(name):
    """(u, v, parameter): a = u + t v up to a power of z."""
    kind, m = name[0], int(name[1:])
    if kind == "i" and m >= 4 and m % 2 == 0:
        n = m // 2 - 2
    elif kind == "a" and m >= 2:
        n = (m - 3) // 2 if m % 2 else m // 2 - 1
    else:
        raise ValueError(f"no such scheme: {name}")
    d = (z(2) - 1) ** 2  # z^2 D
    e = z(2 * n + 1)  # z^(2N+1) (1 + e_N)
    for k in range(n + 1):
        e += fmpq(comb(2 * k, k), 16**k * 2) * (-d) ** k * z(2 * (n - k)) * (1 + z(2))
    v = -((-d) ** (n + 1))  # z^(2N+2), z^(2N+3) times the two displacements
    w = d ** (n + 1) * (1 + z(2))
    if kind == "i":
        return z(2) * e, w, "beta"
    if m % 2 == 0:
        return z() * e, v, "alpha"
    # all three parts have (1+z)^(2N+2); b(alpha) makes the sum of their next Taylor coefficients at -1 vanish
    k0, k1, k2 = (divmod(p, (1 + z()) ** (2 * n + 2))[0](fmpq(-1)) for p in (z(2) * e, z() * v, w))
    return z(2) * e - k0 / k2 * w, z() * v - k1 / k2 * w, "alpha"


def difference(name, n):
    """(u, v, T, parameter): T c_n = u + t v up to a power of z, u and v integer polynomials in z."""
    u, v, par = scheme(name)
    q = (1 + z()) ** (n + 1)
    (u, r), (v, s) = divmod(2**n * u, q), divmod(2**n * v, q)
    if r != 0 or s != 0:
        raise ValueError(f"{name} is not divisible by (1+z)^{n + 1} for every {par}")
    scale = lcm(int(u.denom()), int(v.denom()))
    u, v = (list((p * scale).numer().coeffs()) for p in (u, v))
    k = min(next(i for i, x in enumerate(p) if x != 0) for p in (u, v))
    return fmpz_poly(u[k:]), fmpz_poly(v[k:]), fmpz(scale), par


# ---- points: (P, lo, hi), the only root in [lo, hi] of the irreducible P ---------------------------------------------


def sign(x):
    return (x > 0) - (x < 0)


def rational(x):
    return (fmpz_poly([-x.p, x.q]), x, x)


def changes(p, a, b):
    return sign(p(a)) * sign(p(b)) < 0


def roots(p, a, b):
    """The real roots of the integer polynomial p in the closed interval [a, b]."""
    found = []
    if p == 0:
        return found
    for f, _ in p.factor()[1]:
        if f.leading_coefficient() < 0:
            f = -f
        if f.degree() == 1:
            x = fmpq(-f[0], f[1])
            if a <= x <= b:
                found.append(rational(x))
            continue
        before = None
        for x in sorted(fmpq(*dyadic(c.real)) for c, _ in f.complex_roots() if c.imag == 0):
            lo, hi = fmpq((x * 2**100).floor() - 1, 2**100), fmpq((x * 2**100).floor() + 2, 2**100)
            if before is not None and lo <= before or not changes(f, lo, hi):
                raise ArithmeticError("roots not separated")
            before = hi
            point = (f, lo, hi)
            while point[1] < a < point[2] or point[1] < b < point[2]:
                point = refine(point)
            if a <= point[1] and point[2] <= b:
                found.append(point)
    return found


def dyadic(x):
    """The midpoint of a ball as numerator and denominator."""
    man, exp = x.mid().man_exp()
    return (man << int(exp), 1) if exp >= 0 else (man, fmpz(1) << int(-exp))


def refine(x):
    """Shrink the interval of a point to a half."""
    p, a, b = x
    if a == b:
        return x
    m = (a + b) / 2
    return (p, a, m) if changes(p, a, m) else (p, m, b)


def compare(x, y):
    """(sign of x - y, x, y), the intervals refined to be disjoint, or x = y."""
    lo, hi = max(x[1], y[1]), min(x[2], y[2])
    if lo <= hi and x[0] == y[0] and (lo == hi or changes(x[0], lo, hi)):
        return 0, x, x
    while x[2] >= y[1] and y[2] >= x[1]:
        x, y = refine(x), refine(y)
    return (-1 if x[2] < y[1] else 1), x, y


def below(x, y):
    return compare(x, y)[0] < 0


def distinct(points):
    """The distinct points of a list in order, their intervals disjoint."""
    out = []
    for x in points:
        k, c = 0, -1
        while k < len(out):
            c, y, x = compare(out[k], x)
            out[k] = y
            if c >= 0:
                break
            k += 1
        if k == len(out) or c > 0:
            out.insert(k, x)
    return out


# ---- sets: lists of open intervals (x, y) of points ------------------------------------------------------------------


def union(sets):
    key = cmp_to_key(lambda x, y: compare(x[0], y[0])[0] or compare(x[1], y[1])[0])
    out = []
    for x, y in sorted(sets, key=key):
        if not out or not below(x, out[-1][1]):
            out.append((x, y))
        elif below(out[-1][1], y):
            out[-1] = (out[-1][0], y)
    return out


def intersection(f, g):
    out = []
    for x0, y0 in f:
        for x1, y1 in g:
            x = x1 if below(x0, x1) else x0
            y = y0 if below(y0, y1) else y1
            if below(x, y):
                out.append((x, y))
    return out


# ---- the textbook algorithm, for what bisection leaves ---------------------------------------------------------------


def exact_row(p, scale, a, b):
    """Where, in the open interval (a, b), sum |p_i| < scale; p a list of integer polynomials in t."""

    def between(x, k):
        return (x[k][2] + x[k + 1][1]) / 2

    def signed(m):  # R - T on the piece around m
        return sum((sign(q(m)) * q for q in p), fmpz_poly([-scale]))

    x = distinct([rational(a), rational(b)] + [r for q in p for r in roots(q, a, b)])
    pieces = [signed(between(x, k)) for k in range(len(x) - 1)]
    cuts = distinct(x + [r for s in pieces for r in roots(s, a, b)])  # R - T keeps its sign between these
    out = []
    for k in range(len(cuts) - 1):
        m = between(cuts, k)
        s = signed(m)
        if s(m) >= 0:
            continue
        # join to the interval before, unless R = T at the point between them
        if out and out[-1][1] is cuts[k] and fmpq_poly(s) % fmpq_poly(cuts[k][0]) != 0:
            out[-1] = (out[-1][0], cuts[k + 1])
        else:
            out.append((cuts[k], cuts[k + 1]))
    return out


# ---- bisection in the Bernstein basis --------------------------------------------------------------------------------


class Level:
    """The set with ||c^l|| < 1; c[i]: coefficient of t^i in T^l c^l, an integer polynomial in z."""

    def __init__(self, c, scale, l):
        self.d, self.scale = l, scale**l
        m, q = max(p.degree() for p in c), 2**l
        # one row of each mirrored pair: a list of polynomials in t, as integer coefficient lists
        columns = [[p[i] for p in c] for i in range(m + 1)]
        self.rows = {j: columns[j::q] for j in range(min(q, m + 1)) if j <= (m - j) % q}
        n = l + 1
        self.left = fmpz_mat(n, n, [comb(k, j) << (l - k) if j <= k else 0 for j in range(n) for k in range(n)])
        self.right = fmpz_mat(n, n, [self.left[l - j, l - k] for j in range(n) for k in range(n)])
        self.ones = fmpz_mat(n, 1, [1] * n)

    def solve(self, a, b):
        n = self.d + 1
        # powers of t -> powers of s, t = a + (b-a) s -> Bernstein coefficients on (a, b)
        at = [(i, j) for i in range(n) for j in range(n)]
        shift = fmpq_mat(n, n, [comb(i, j) * a ** (i - j) * (b - a) ** j if j <= i else 0 for i, j in at])
        lift = fmpq_mat(n, n, [fmpq(comb(k, j), comb(self.d, j)) if j <= k else 0 for j, k in at])
        conv, den = (shift * lift).numer_denom()
        rows = [(j, fmpz_mat(len(r), n, [x for p in r for x in p])) for j, r in self.rows.items()]
        return self.node(rows, conv, self.scale * den, a, b, BISECTIONS)

    def node(self, rows, half, scale, a, b, depth):
        """Where, in the open interval (a, b), every row is < scale. rows: list of (row id, matrix), whose product with
        `half` holds the Bernstein coefficients on (a, b); rows most likely to exclude the node first."""
        n = self.d + 1
        active = []
        for row in rows:
            bern = row[1] * half
            e = [abs(x) for x in bern.entries()]
            w = [sum(e[k::n]) for k in range(n)]
            top = max(w)
            if top < scale:
                continue
            signs = [sign(x) for x in (bern * self.ones).entries()]
            s = (fmpz_mat(1, len(signs), signs) * bern).entries()
            low = min(s)
            if low >= scale:
                return []
            if top == scale and min(w) < scale:
                continue
            active.append((row[0], bern, s, s == w, low))
        if not active:
            return [(rational(a), rational(b))]
        if len(active) == 1 and active[0][3]:
            s = [x - scale for x in active[0][2]]
            nz = [sign(x) for x in s if x != 0]
            if sum(x != y for x, y in zip(nz, nz[1:])) == 1:
                x = self.inside(s, a, b)
                return [(rational(a), x) if nz[0] < 0 else (x, rational(b))]
        if depth == 0:
            return self.exact_node(active, a, b)
        active.sort(key=lambda r: r[4], reverse=True)
        m, scale = (a + b) / 2, scale << self.d
        f = self.node(active, self.left, scale, a, m, depth - 1)
        g = self.node(active, self.right, scale, m, b, depth - 1)
        # join across m if all rows are < T there
        if f and g and f[-1][1][1] == f[-1][1][2] == m == g[0][0][1] == g[0][0][2]:
            col = fmpz_mat(self.d + 1, 1, [self.right[k, 0] for k in range(n)])
            if all(sum(abs(x) for x in (r[1] * col).entries()) < scale for r in active):
                return f[:-1] + [(f[-1][0], g[0][1])] + g[1:]
        return f + g

    def inside(self, s, a, b):
        """The only root in the open interval (a, b) of the polynomial with Bernstein coefficients s."""
        d = self.d
        left, right = fmpq_poly([-a, 1]), fmpq_poly([b, -1])
        p = sum((comb(d, k) * s[k] * left**k * right ** (d - k) for k in range(d + 1)), fmpq_poly([0]))
        return next(x for x in roots(p.numer(), a, b) if x[2] > a and x[1] < b)

    def exact_node(self, active, a, b):
        out = [(rational(a), rational(b))]
        for r in active:
            out = intersection(out, exact_row([fmpz_poly(p) for p in self.rows[r[0]]], self.scale, a, b))
        return out


def levels(name, n, top):
    """(parameter, [set of level 1, ..., set of level top])"""
    u, v, scale, par = difference(name, n)
    if v[0] == 0:
        raise ValueError("the end coefficient does not depend on the parameter")
    # the end coefficient of c^l is c_0^l: |c_0(t)| < 1 is necessary at every level
    a, b = sorted(fmpq(scale * s - u[0], v[0]) for s in (-1, 1))
    c, sets = [fmpz_poly([1])], []
    for l in range(1, top + 1):
        up, vp = u.inflate(2 ** (l - 1)), v.inflate(2 ** (l - 1))
        c = [x + y for x, y in zip([p * up for p in c] + [0], [fmpz_poly([0])] + [p * vp for p in c])]
        sets.append(Level(c, scale, l).solve(a, b))
    return par, sets


# ---- output ----------------------------------------------------------------------------------------------------------


def number(x, par):
    """A JSON number; exact is p/q, or root(POLY, k), the k-th real root, from 1, of the minimal polynomial."""
    p, lo, hi = x
    if lo == hi:
        exact = str(lo)
    else:
        k = 1 + sum(below(y, x) for y in roots(p, lo - 2**100, hi))
        exact = f"root({str(p).replace('x', par).replace('(', '').replace(')', '').replace('+ -', '- ')}, {k})"
    mid = (lo + hi) / 2 * 10**24
    digits = str(abs(int(mid.round()))).rjust(25, "0")
    approx = ("-" if mid < 0 else "") + digits[:-24] + "." + digits[-24:]
    return f'{{"exact": "{exact}", "lower": "{lo}", "upper": "{hi}", "approx": {approx}}}'


def intervals(f, par):
    return "[" + ", ".join(f'{{"lo": {number(x, par)}, "hi": {number(y, par)}}}' for x, y in f) + "]"


def main(name, n, top):
    ctx.prec = 192
    par, sets = levels(name, n, top)
    each = ", ".join(f'{{"level": {l}, "proved": {intervals(f, par)}}}' for l, f in enumerate(sets, 1))
    proved = intervals(union([i for f in sets for i in f]), par)
    print(
        f'{{"tool": "python-flint", "scheme": "{name}", "parameter": "{par}", "continuity": {n}, "level": {top}, '
        f'"levels": [{each}], "proved": {proved}}}'
    )


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: contractivity.py SCHEME CONTINUITY LEVEL, e.g. a4 0 6")
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
