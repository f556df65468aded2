#!/usr/bin/env python3
"""gripenberg.py: brackets of the joint spectral radius (JSR) of difference schemes by branch and bound, in numpy.

    python3 benches/peers/numpy/gripenberg.py dd8 --delta 1e-3    one case, as one JSON object; a12 --alpha 3/1024 as well

Cases: dd4 .. dd16, the Deslauriers-Dubuc schemes 1 + e_N (dd_{2N+2}); a12, that is 1 - alpha (-D)^6 + e_5, by default
at alpha = C(12,6)/16^6 = 231/4194304, where the order of the zero at -1 rises from 12 to 14. If (1+z)^m,
m maximal, divides the symbol a, then c = 2^(m-1) a/(1+z)^m, A_eps[i][j] = c_{M-1+eps+i-2j} for 0 <= i, j < M, and the
Hoelder exponent is m - 1 - log2 JSR(A_0, A_1): exactly if the shifts are stable, else it is a lower bound.

Algorithm: G. Gripenberg, Computing the joint spectral radius, Linear Algebra Appl. 234 (1996) 43-60. For a product of
length k, p = min ||prefix of length i||^(1/i), i <= k; it is extended only if p > lower + delta, lower the largest
(spectral radius)^(1/length) so far. If none is left, lower <= JSR <= the largest p that was cut <= lower + delta.
  * The norm is the 2-norm after a similarity that makes the Gramians K = sum A'KA / mu and L = sum ALA' / mu (leading
    eigenvectors) equal and diagonal: a balanced realisation. Repeated, as the first one is ill-conditioned.
  * The masks are symmetric, A_1 = JA_0J with J the reversal, and so is this norm: only words that start with A_0.
  * Products are extended in chunks, deepest first: breadth first while they are few, in bounded memory when many.
    Frobenius norms first, 2-norms where these do not decide, eigenvalues of what is left, up to length DEPTH.
delta is relative to the spectral radius of A_0, by which the matrices are divided first.
Rounding errors are not bounded, so the bracket is no proof. One thread.
"""

import os

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse
import json
import time
from fractions import Fraction
from math import comb, inf, log2

import numpy as np

DD = [f"dd{k}" for k in range(4, 17, 2)]
ALPHA = Fraction(comb(12, 6), 16**6)
CHUNK = 2048  # products extended at once
DEPTH = 32  # the longest words whose eigenvalues are computed
PASSES = 4  # of balancing
frobenius = lambda products: np.sqrt(np.einsum("nij,nij->n", products, products))
spectral = lambda products: np.linalg.svd(products, compute_uv=False)[:, 0]
radius = lambda products, k: abs(np.linalg.eigvals(products)).max(1) ** (1 / k)


# ---- the matrices ----------------------------------------------------------------------------------------------------


def symbol(n, alpha):
    """1 + e_n - alpha (-D)^(n+1), times z^(2n+2)."""
    d, power = np.array([Fraction(x) for x in (-1, 0, 2, 0, -1)]), np.array([Fraction(1)])  # z^2 (-D), its k-th power
    out = np.array([Fraction(0)] * (4 * n + 5))
    out[2 * n + 2] += 1
    for k in range(n + 1):
        half = Fraction(comb(2 * k, k), 2 * 16**k)
        out[2 * (n - k) + 1 : 2 * (n + k) + 4] += np.convolve(power, np.array([half, Fraction(0), half]))
        power = np.convolve(power, d)
    out -= alpha * power
    return out if alpha else out[1:-1]


def matrices(a):
    """(m, A_0 and A_1 as one array)"""
    m = 0
    while True:
        quotient, rest = [], Fraction(0)
        for x in a:
            rest = x - rest
            quotient.append(rest)
        if quotient.pop() != 0:
            break
        a, m = quotient, m + 1
    c = np.array([float(2 ** (m - 1) * x) for x in a])
    n = len(c) - 1
    k = np.array([[[n - 1 + e + i - 2 * j for j in range(n)] for i in range(n)] for e in (0, 1)])
    return m, np.where((k >= 0) & (k <= n), c[k.clip(0, n)], 0.0)


# ---- the search ------------------------------------------------------------------------------------------------------


def root(a):
    """R with R'R = the leading eigenvector of P -> sum A'PA (power method)."""
    p = np.eye(len(a[0]))
    for _ in range(200):
        q = (a.swapaxes(1, 2) @ p @ a).sum(0)
        q /= np.trace(q)
        p, change = q, abs(q - p).max()
        if change < 1e-3:
            break
    w, u = np.linalg.eigh(p)
    return np.sqrt(w.clip(1e-15 * w[-1]))[:, None] * u.T


def balance(a):
    t = np.eye(len(a[0]))
    for _ in range(PASSES):
        b = t @ a @ np.linalg.inv(t)
        r, l = root(b), root(b.swapaxes(1, 2))
        u, s, _ = np.linalg.svd(r @ l.T)
        t = (u.T @ r) / np.sqrt(s)[:, None] @ t
    return t @ a @ np.linalg.inv(t)


def search(a, delta, seconds, budget):
    """lower and upper bound of the JSR of a, lower attained by a word; counts."""
    end = time.process_time() + seconds
    lower, word, upper, products, depth = radius(a[:1], 1)[0], "0", 0.0, 0, 0
    stack = [(0, np.eye(len(a[0]))[None], np.array([inf]), np.array([0]))]  # length, products, p, words as bits
    while stack and time.process_time() < end and products < budget:
        k, f, p, w = stack.pop()
        if len(f) > CHUNK:
            stack.append((k, f[:-CHUNK], p[:-CHUNK], w[:-CHUNK]))
            f, p, w = f[-CHUNK:], p[-CHUNK:], w[-CHUNK:]
        letters = 2 if k else 1
        k += 1
        f = (f[:, None] @ a[:letters]).reshape(-1, *f.shape[1:])
        p = np.repeat(p, letters)
        w = (2 * w[:, None] + np.arange(letters)).ravel() if k <= DEPTH else np.zeros(len(f), int)
        products, depth = products + len(f), max(depth, k)
        for norm in (frobenius, spectral):
            p = np.minimum(p, norm(f) ** (1 / k))
            keep = p > lower + delta
            upper = max(upper, p[~keep].max(initial=0))
            f, p, w = f[keep], p[keep], w[keep]
            if not len(f):
                break
        else:
            stack.append((k, f, p, w))
            if 1 < k <= DEPTH:
                r = radius(f, k)
                best = r.argmax()
                if r[best] > lower * (1 + 1e-12):  # more than the rounding errors of a power of the word
                    lower, word = r[best], f"{w[best]:0{k}b}"
    upper = max([lower, upper] + [p.max() for _, _, p, _ in stack])
    counts = {"word": word, "products": products, "depth": depth}
    return {"reached": bool(upper <= lower + delta), "lower": lower, "upper": upper, **counts}


def bracket(name, options):
    start = time.process_time()
    n = 5 if name == "a12" else int(name[2:]) // 2 - 1
    m, a = matrices(symbol(n, options.alpha if name == "a12" else 0))
    if not np.allclose(a[1], a[0, ::-1, ::-1]):
        raise ArithmeticError("A_1 is not JA_0J")
    scale = radius(a[:1], 1)[0]
    out = search(balance(a / scale), options.delta, options.limit - (time.process_time() - start), options.products)
    out["lower"], out["upper"] = lower, upper = out["lower"] * scale, out["upper"] * scale
    out["hoelder"] = [m - 1 - log2(upper), m - 1 - log2(lower)]
    out["seconds"] = time.process_time() - start
    return {"tool": "numpy", "case": name, "m": m, "size": len(a[0]), **out}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", choices=[*DD, "a12"])
    parser.add_argument("--delta", type=float, default=1e-3)
    parser.add_argument("--alpha", type=Fraction, default=ALPHA, help="of a12")
    parser.add_argument("--limit", type=float, default=60, help="seconds of processor time for the search")
    parser.add_argument("--products", type=int, default=10**8, help="budget for the search")
    options = parser.parse_args()
    print(json.dumps(bracket(options.case, options)))
