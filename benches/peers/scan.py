"""C^0 to C^4 of S_{a5} on a grid of (alpha, beta) by norms of difference schemes up to level 6, in floats.

Compiled with numba, two threads. C^n is asked only where C^(n-1) held; what level 6 does not show is
taken for refuted. Run with `python scan.py 1000`, the number of points in each direction."""
import sys
import time

import numba
import numpy as np

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


@numba.njit(cache=False)
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


@numba.njit(parallel=True, cache=False)
def scan(parts, alphas, betas):
    out = np.empty((len(alphas), len(betas)), np.int8)
    for i in numba.prange(len(alphas)):
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


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    numba.set_num_threads(2)
    # C^4 holds on a line only.
    parts = np.array([[divided(p, n + 1) for p in mask_parts()] for n in range(4)])
    alphas, betas = np.linspace(0, 1 / 8, count), np.linspace(-1 / 10, 0, count)
    scan(parts, alphas[:2], betas[:2])
    start = time.perf_counter()
    out = scan(parts, alphas, betas)
    seconds = time.perf_counter() - start
    print(f"{count * count} points, {seconds:.2f} s, {seconds / count**2 * 1e6:.2f} µs a point")
    print({int(n): int((out == n).sum()) for n in np.unique(out)})


main()
