"""mask.py: the mask of a_{2N+2} from its closed form, in SymPy; the formula is that of pari/mask.gp.

    python3 benches/peers/sympy/mask.py a20"""

import json
import sys

from sympy import Poly, Rational, binomial, symbols

z, alpha = symbols("z alpha")


def main(name):
    n = int(name[1:]) // 2 - 1
    m = 2 * n + 2
    minus_d = -((z**2 - 1) ** 2)  # z^2 (-D)
    edge = sum(binomial(2 * k, k) * Rational(1, 16**k) * minus_d**k * z ** (2 * (n - k) + 1) for k in range(n + 1))
    a = Poly(z**m - alpha * minus_d ** (n + 1) + edge * (1 + z**2) / 2, z)  # z^M a, expanded
    coefficients = enumerate(reversed(a.all_coeffs()), -m)
    print(json.dumps({"mask": [{"index": i, "coefficient": str(c)} for i, c in coefficients]}))


main(sys.argv[1])
