"""mask.py: the mask of a_{2N+2} from its closed form, in python-flint 0.9; the formula is that of pari/mask.gp.

    python3 benches/peers/flint/mask.py a20"""

import json
import sys
from math import comb

from flint import fmpq, fmpq_poly


def main(name):
    n = int(name[1:]) // 2 - 1
    m, z = 2 * n + 2, fmpq_poly([0, 1])
    minus_d = -((z**2 - 1) ** 2)  # z^2 (-D)
    edge = sum((fmpq(comb(2 * k, k), 2 * 16**k) * minus_d**k * z ** (2 * (n - k) + 1) for k in range(n + 1)), z * 0)
    base, by_alpha = z**m + edge * (1 + z**2), -(minus_d ** (n + 1))  # z^M a = base + alpha by_alpha
    coefficient = lambda i: f"{base[i]} + {by_alpha[i]}*alpha"
    print(json.dumps({"mask": [{"index": i - m, "coefficient": coefficient(i)} for i in range(2 * m + 1)]}))


main(sys.argv[1])
