#!/usr/bin/env python3
"""degrees.py: exact degrees of generation and reproduction with the tensions free, in python-flint 0.9.

    python3 benches/peers/flint/degrees.py a43

prints, as one JSON object, the strata of the scheme: generic first, then every set on which a degree rises,
down to single points. Symbol, method and output are those of pari/degrees.gp; read its header first.
"""

import sys
from math import comb, factorial

from flint import fmpq, fmpq_mat, fmpq_poly


def binomial(i, k):
    return comb(i, k) if i >= 0 else (-1) ** k * comb(k - i - 1, k)


def forms(number):
    """Derivatives at -1 and at 1 (less those that reproduction asks for), divided by k!, as rows on (1, alpha, b)."""
    n = number // 2 - 1
    m, top = 2 * n + 3, 2 * n + 8
    z = fmpq_poly([0, 1])
    d = (z**2 - 1) ** 2  # z^2 D
    e = fmpq_poly([0])
    for k in range(n + 1):
        e += fmpq(comb(2 * k, k), 16**k) * (-d) ** k * z ** (2 * (n - k))
    # z^(2N+3) times the parts of a: exponent i of a is row i + m
    parts = (z**m + e * z**2 * (1 + z**2) / 2, -z * (-d) ** (n + 1), d ** (n + 1) * (1 + z**2))
    parts = parts if number % 2 else parts[:2]
    mask = fmpq_mat(2 * m + 1, len(parts), [p[i] for i in range(2 * m + 1) for p in parts])
    table = [[binomial(i, k) for i in range(-m, m + 1)] for k in range(top + 1)]
    at1 = fmpq_mat(top + 1, 2 * m + 1, [x for row in table for x in row]) * mask
    signed = [(-1) ** ((i + k) % 2) * table[k][i + m] for k in range(top + 1) for i in range(-m, m + 1)]
    at_1 = fmpq_mat(top + 1, 2 * m + 1, signed) * mask
    tau = at1[1, 0] / 2
    if any(at1[1, j] != 0 for j in range(1, len(parts))):
        raise ArithmeticError("tau depends on the parameters")
    wanted = fmpq(2)  # 2 tau (tau-1) ... (tau-k+1)
    for k in range(top + 1):
        at1[k, 0] -= wanted / factorial(k)
        wanted *= tau - k
    return at_1, at1, tau


def restrict(f, k, s):
    """Row k of f on the stratum s, a matrix whose columns parametrise it: (1, alpha, b) = s (1, ...)."""
    return (fmpq_mat(1, f.ncols(), [f[k, j] for j in range(f.ncols())]) * s).entries()


def stop(f, s):
    """Order of the first form that does not vanish on s."""
    for k in range(f.nrows()):
        if any(x != 0 for x in restrict(f, k, s)):
            return k
    raise ArithmeticError("more derivatives needed")


def cut(g, s):
    """The zeros on s of the form g: a stratum of one dimension less, or None. Solves for the last unknown."""
    n = len(g)
    j = max(i for i in range(n) if g[i] != 0)
    if j == 0:
        return None
    cols = [i for i in range(n) if i != j]
    return s * fmpq_mat(n, n - 1, [-g[c] / g[j] if r == j else int(r == c) for r in range(n) for c in cols])


def strata(number):
    at_1, at1, tau = forms(number)
    size = at1.ncols()
    todo = [fmpq_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])]
    out = []
    for s in todo:  # grows
        g = stop(at_1, s) - 1
        r = min(g, stop(at1, s) - 1)
        out.append((s, g, r))
        for f, k in [(at_1, g + 1)] + ([(at1, r + 1)] if r < g else []):
            t = cut(restrict(f, k, s), s)
            if t is not None and t not in todo:
                todo.append(t)
    return out, tau


def parameters(s):
    """alpha and beta = b/(1-alpha) of a stratum, as far as they are determined."""
    rows = s.tolist()
    if len(rows[0]) == len(rows):
        return {}
    if len(rows) == 2:
        return {"alpha": str(rows[1][0])}
    if len(rows[0]) == 1:
        (alpha,), (b,) = rows[1:]
        if alpha == 1:
            raise ArithmeticError("alpha = 1")
        return {"alpha": str(alpha), "beta": str(b / (1 - alpha))}
    if rows[1] != [0, 1]:
        return {"alpha": str(rows[1][0])}  # a line alpha = constant
    p = fmpq_poly(rows[2])
    top = str(p.numer()).replace("x", "alpha").replace("(", "").replace(")", "").replace("+ -", "- ")
    return {"beta": f"({top})/({p.denom()}*(1 - alpha))"}


def main(name):
    if name[0] != "a" or int(name[1:]) < 2:
        raise ValueError("a2, a3, a4, ... expected")
    found, tau = strata(int(name[1:]))
    rows = []
    for s, g, r in found:
        p = parameters(s)
        condition = ", ".join(f"{k} = {v}" for k, v in p.items()) or "generic"
        values = ", ".join(f'"{k}": {{"exact": "{v}"}}' for k, v in p.items())
        rows.append(
            f'{{"condition": "{condition}", "parameters": {{{values}}}, '
            f'"generation": {g}, "reproduction": {r}, "tau": "{tau}"}}'
        )
    print(f'{{"tool": "python-flint", "scheme": "{name}", "strata": [{", ".join(rows)}]}}')


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: degrees.py SCHEME, e.g. a43")
    main(sys.argv[1])
