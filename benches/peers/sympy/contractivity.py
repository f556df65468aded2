"""contractivity.py: exact contractivity ranges of the schemes a_{2N+2}, in SymPy.

    python3 benches/peers/sympy/contractivity.py a4 0 3

prints, as one JSON object, the set of parameters with ||c_n^l|| < 1 for some l <= L; what that is, and the textbook
algorithm, are in the header of pari/contractivity.gp. A point is (lo, hi, P), the root of the irreducible P in [lo, hi],
lo == hi if it is rational; [lo, hi] is at most 2^-100 wide, and different points may not touch."""

import json
import sys
from functools import reduce

from sympy import QQ, Poly, Rational, binomial, factor_list, ring, symbols

t = symbols("t")
R, Z, T = ring("z,t", QQ)


def difference(m, n):
    """c_n times a power of z."""
    k, minus_d = m // 2 - 1, -((Z**2 - 1) ** 2)
    edge = sum(
        (minus_d**i * Z ** (2 * (k - i) + 1) * QQ(int(binomial(2 * i, i)), 2 * 16**i) for i in range(k + 1)), R.zero
    )
    a = Z**m - T * minus_d ** (k + 1) + edge * (1 + Z**2)
    return (a * 2**n).exquo((1 + Z) ** (n + 1))


def roots(p, a, b):
    """The points of [a, b] at which p vanishes."""
    found = []
    for f, _ in factor_list(p)[1]:
        for (lo, hi), _ in f.intervals(eps=Rational(1, 2**100), inf=a, sup=b):
            found.append((lo, hi, f))
    return found


def same(x, y):
    """Whether points are equal; if not, they are apart."""
    if x[1] < y[0] or y[1] < x[0]:
        return False
    if x[2] != y[2]:
        raise ArithmeticError("points too close")
    return True


def distinct(points):
    out = []
    for x in sorted(points, key=lambda x: x[0]):
        if not out or not same(out[-1], x):
            out.append(x)
    return out


def rational(x):
    return x, x, Poly(x.q * t - x.p, t)


def row_set(row, a, b):
    """Where sum |p_i| < 1 between the points a and b, as open intervals."""
    middle = lambda x, y: (x[1] + y[0]) / 2
    inside = lambda p: roots(p, a[0], b[1]) if p.degree() > 0 else []
    cuts = distinct([a, b] + [x for p in row for x in inside(p)])
    ends, out = list(cuts), []
    for x, y in zip(cuts, cuts[1:]):
        ends += inside(signed(row, middle(x, y)))
    ends = distinct(ends)
    for x, y in zip(ends, ends[1:]):
        s = signed(row, middle(x, y))
        if s.eval(middle(x, y)) < 0:
            # joined to the interval before, unless the sum is 1 at the point between
            joined = out and same(out[-1][1], x) and not s.rem(x[2]).is_zero
            out[-1:] = [(out[-1][0], y)] if joined else out[-1:] + [(x, y)]
    return out


def signed(row, at):
    """sum |p_i| - 1 on the piece around a number."""
    return sum((p if p.eval(at) > 0 else -p for p in row), Poly(0, t)) - 1


def later(x, y):
    return x if x[0] > y[0] else y


def intersection(f, g):
    pairs = [(later(i[0], j[0]), j[1] if later(i[1], j[1]) == i[1] else i[1]) for i in f for j in g]
    return [(x, y) for x, y in pairs if not same(x, y) and x[0] < y[0]]


def union(intervals):
    out = []
    for x, y in sorted(intervals, key=lambda i: i[0][0]):
        if out and not same(x, out[-1][1]) and x[0] < out[-1][1][0]:
            out[-1] = out[-1][0], later(y, out[-1][1])
        else:
            out.append((x, y))
    return out


def level_set(c, level, a, b):
    degree, step = max(i for i, _ in c), 2**level
    columns = [{} for _ in range(degree + 1)]
    for (i, j), x in c.items():
        columns[i][(j,)] = x
    columns = [Poly(x, t, domain=QQ) for x in columns]
    # one row of each mirrored pair
    rows = [columns[j::step] for j in range(min(step, degree + 1)) if j <= (degree - j) % step]
    return reduce(lambda f, row: f and intersection(f, row_set(row, a, b)), rows, [(a, b)])


def main(name, n, levels):
    c = difference(int(name[1:]), n)
    # the end coefficient of c^l is c_0^l: |c_0(t)| < 1 is necessary at every level
    u, v = (Rational(int(x.numerator), int(x.denominator)) for x in (c.get((0, 0), QQ(0)), c[(0, 1)]))
    a, b = map(rational, sorted(((1 - u) / v, (-1 - u) / v)))
    product, found = R.one, []
    for level in range(1, levels + 1):
        product *= R({(i << (level - 1), j): x for (i, j), x in c.items()})
        found += level_set(product, level, a, b)
    number = lambda x: {"exact": str(x[2].as_expr()), "lower": str(x[0]), "upper": str(x[1])}
    print(json.dumps({"proved": [{"lo": number(x), "hi": number(y)} for x, y in union(found)]}))


main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
