"""degrees.py: exact degrees of generation and reproduction with the tensions free, in SymPy.

    python3 benches/peers/sympy/degrees.py a43

prints, as one JSON object, the strata of the scheme, generic first; symbol and conditions are those of pari/degrees.gp.
The textbook way: derivatives of the symbol at -1 and at 1, one after the other, set to zero and solved for a tension."""

import json
import sys

from sympy import Rational, binomial, expand, factor, simplify, solve, symbols

z, alpha, beta, b = symbols("z alpha beta b")


def forms(m):
    """The derivatives at -1 and at 1, less what reproduction asks for, and tau."""
    n, d = m // 2 - 1, z**-2 - 2 + z**2
    edge = sum(binomial(2 * k, k) * Rational(1, 16**k) * (-d) ** k for k in range(n + 1)) * (z + 1 / z) / 2
    a = 1 - alpha * (-d) ** (n + 1) + edge
    if m % 2:
        a += b * d ** (n + 1) * (z + 1 / z)
    a = expand(a)
    tau, wanted, at_1, at1 = a.diff(z).subs(z, 1) / 2, 2, [], []
    for k in range(m + 6):
        at_1.append(expand(a.subs(z, -1)))
        at1.append(expand(a.subs(z, 1) - wanted))
        a, wanted = a.diff(z), wanted * (tau - k)
    return at_1, at1, tau


def stop(forms, s):
    """Order of the first form that does not vanish on a stratum, {parameter: value}; and what it is there."""
    return next((k, f) for k, form in enumerate(forms) if (f := simplify(form.subs(s))) != 0)


def cut(f, s):
    """The stratum on which a form vanishes as well, or None."""
    if not f.free_symbols:
        return None
    x = b if f.has(b) else alpha
    (value,) = solve(f, x)
    return {x: value} | {y: simplify(v.subs(x, value)) for y, v in s.items()}


def parameters(s):
    values = {beta if x == b else x: factor((v / (1 - alpha)).subs(s)) if x == b else v for x, v in s.items()}
    return {str(x): {"exact": str(v)} for x, v in values.items()}


def main(name):
    at_1, at1, tau = forms(int(name[1:]))
    todo, out = [{}], []
    for s in todo:  # grows
        (g, f), (r, h) = stop(at_1, s), stop(at1, s)
        degrees = {"generation": g - 1, "reproduction": min(g, r) - 1, "tau": str(tau)}
        out.append({"parameters": parameters(s), **degrees})
        for form in [f, h] if r < g else [f]:
            t = cut(form, s)
            if t is not None and t not in todo:
                todo.append(t)
    print(json.dumps({"strata": out}))


main(sys.argv[1])
