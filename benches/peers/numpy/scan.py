"""scan.py: S_{a5} on a grid of COUNT x COUNT points of (alpha, beta) in [0, 1/8] x [-1/10, 0], in floats, one thread.

    python3 benches/peers/numpy/scan.py norm 100          ||c_1^3|| at every point, in numpy
    python3 benches/peers/numpy/scan.py continuity 100    the largest n <= 3 with ||c_n^l|| < 1 for some l <= 6, in numba

prints one JSON object: the seconds without imports and without what numba compiles, and a value for each point, beta
changing fastest. C^n is asked only where C^(n-1) held; C^4 holds on a line only."""

import json
import sys
import time

import numpy as np

try:
    from numba import njit
except ImportError:  # the norms do without
    njit = lambda **_: lambda f: None

LEVELS = 6


def mask_parts():
    """The mask of S_{a5} as base + alpha * by_alpha + b * by_b, b = beta (1 - alpha), from z^-5 to z^5."""
    d = np.array([1.0, 0.0, -2.0, 0.0, 1.0])
    base, by_alpha, by_b = (np.zeros(11) for _ in range(3))

    def add(part, coefficients):
        half = len(coefficients) // 2
        part[5 - half : 6 + half] += coefficients

    edge = np.array([1.0, 0.0, 1.0])
    add(base, np.array([1.0]))
    add(base, edge / 2)
    add(base, -np.convolve(d, edge) / 16)
    add(by_alpha, -np.convolve(d, d))
    add(by_b, np.convolve(np.convolve(d, d), edge))
    return base, by_alpha, by_b


def divided(part, order):
    """2^(order-1) part / (1+z)^order, remainders dropped: they vanish up to order 4."""
    for _ in range(order):
        part = np.polynomial.polynomial.polydiv(part, [1.0, 1.0])[0]
    out = np.zeros(11)
    out[: len(part)] = part * 2.0 ** (order - 1)
    return out


def norms(n, level, alphas, betas):
    """||c_n^level|| at all points at once: a row of coefficients for each."""
    base, by_alpha, by_b = (divided(p, n + 1)[: 10 - n] for p in mask_parts())
    alpha, beta = (x.ravel()[:, None] for x in np.meshgrid(alphas, betas, indexing="ij"))
    c = base + alpha * by_alpha + beta * (1 - alpha) * by_b
    product, size = c, c.shape[1]
    for k in range(1, level):
        longer = np.zeros((len(c), product.shape[1] + (size - 1 << k)))
        for i in range(size):
            longer[:, i << k : (i << k) + product.shape[1]] += c[:, i, None] * product
        product = longer
    return np.max([abs(product[:, j :: 1 << level]).sum(1) for j in range(1 << level)], 0)


@njit(cache=True)
def contracts(c):
    """Whether a norm of the scheme with the symbol c is below one up to the last level."""
    product = c.copy()
    size = len(c)
    for level in range(1, LEVELS + 1):
        step = 2**level
        largest = 0.0
        for j in range(step):
            row = 0.0
            for i in range(j, len(product), step):
                row += abs(product[i])
            largest = max(largest, row)
        if largest < 1.0:
            return True
        longer = np.zeros(len(product) + step * (size - 1))
        for k in range(size):
            for i in range(len(product)):
                longer[i + step * k] += product[i] * c[k]
        product = longer
    return False


@njit(cache=True)
def continuity(parts, alphas, betas):
    out = np.empty((len(alphas), len(betas)), np.int8)
    for i in range(len(alphas)):
        for j in range(len(betas)):
            b = betas[j] * (1.0 - alphas[i])
            n = 0
            while n < 4:
                c = parts[n, 0] + alphas[i] * parts[n, 1] + b * parts[n, 2]
                if not contracts(c[: 11 - n - 1]):
                    break
                n += 1
            out[i, j] = n - 1
    return out


def main(what, count):
    alphas, betas = np.linspace(0, 1 / 8, count), np.linspace(-1 / 10, 0, count)
    if what == "norm":
        scan = lambda alphas: norms(1, 3, alphas, betas)
    else:
        parts = np.array([[divided(p, n + 1) for p in mask_parts()] for n in range(4)])
        scan = lambda alphas: continuity(parts, alphas, betas)
        scan(alphas[:2])  # compiles
    start = time.process_time()
    values = scan(alphas)
    seconds = time.process_time() - start
    print(json.dumps({"seconds": seconds, "values": values.ravel().tolist()}))


main(sys.argv[1], int(sys.argv[2]))
