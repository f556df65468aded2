"""refine.py: refinement of curves and surfaces in Python, one thread, beside `cargo bench -p refinable-refine`.

    python3 benches/peers/numpy/refine.py curve numpy 25       or: convolve, numba; how many runs
    python3 benches/peers/numpy/refine.py surface numpy 9      or: ndimage, numba

S_a5 at alpha = 1/16, beta = -1/48. Curves: closed, 2-D, 1000 points, ten levels. Surfaces: closed in both directions,
3-D, 100 x 100 points, five levels. Prints one JSON object: the least seconds for each point of the last level, and a small
polygon or net after three levels, to be compared. What is compiled is compiled before. The last level is a new array each
time, the levels before it are written over those of the run before: new memory costs as much as the arithmetic."""

import json
import sys
import time

import numpy as np

try:
    from numba import njit
except ImportError:  # the others do without
    njit = lambda **_: lambda f: None

ALPHA, B = 1 / 16, -1 / 48 * (1 - 1 / 16)
# Half of each rule, from the outside: both are symmetric, which saves multiplications.
V2, V1, V0 = -ALPHA, 4 * ALPHA, 1 - 6 * ALPHA
E2, E1, E0 = B, -1 / 16 - 3 * B, 9 / 16 + 2 * B
VERTEX, EDGE = np.array([V2, V1, V0, V1, V2]), np.array([E2, E1, E0, E0, E1, E2])
BLOCK = 1 << 15  # numbers of a temporary: those in use stay in the cache


# ---- levels ----------------------------------------------------------------------------------------------------------


def scratch(f, count):
    """Arrays for all levels but the last, with two rows before and three after."""
    refined = 2 if f.ndim == 3 else 1  # directions
    sizes = ([n << k for n in f.shape[:refined]] + [*f.shape[refined:]] for k in range(count))
    out = [np.empty((n + 5, *rest)) for n, *rest in sizes]
    out[0][2:-3] = f
    close(out[0])
    return out


def close(p):
    p[:2], p[-3:] = p[-5:-3], p[2:5]


def refine(step, arrays):
    for p, q in zip(arrays, arrays[1:]):
        step(p, q[2:-3])
        close(q)
    p = arrays[-1]
    rows = 2 * (len(p) - 5)
    new = np.empty((rows, 2 * p.shape[1], 3) if p.ndim == 3 else (rows, *p.shape[1:]))
    step(p, new)
    return new


# ---- numpy slices ----------------------------------------------------------------------------------------------------


def rules(x, t, u, even, odd):
    """Both rules of six shifted slices, without new arrays: t and u are scratch."""
    np.add(x[0], x[4], t)
    np.multiply(t, V2, t)
    np.add(x[1], x[3], u)
    np.multiply(u, V1, u)
    np.add(t, u, t)
    np.multiply(x[2], V0, u)
    np.add(t, u, even)
    np.add(x[0], x[5], t)
    np.multiply(t, E2, t)
    np.add(x[1], x[4], u)
    np.multiply(u, E1, u)
    np.add(t, u, t)
    np.add(x[2], x[3], u)
    np.multiply(u, E0, u)
    np.add(t, u, odd)


CURVE = np.empty((4, BLOCK))


def curve_slices(p, new):
    """In blocks, and flat, so that all slices are contiguous; a point is moved to its place as a complex number."""
    flat, pairs, n = p.reshape(-1), new.view(complex).reshape(-1, 2), len(p) - 5
    for i in range(0, n, BLOCK // 2):
        k = min(BLOCK // 2, n - i)
        t, u, even, odd = CURVE[:, : 2 * k]
        rules([flat[2 * j : 2 * (j + k)] for j in range(i, i + 6)], t, u, even, odd)
        pairs[i : i + k, 0], pairs[i : i + k, 1] = even.view(complex), odd.view(complex)


def along(f, new):
    """A level along the rows."""
    n, m, _ = f.shape
    p = np.concatenate((f[:, -2:], f, f[:, :3]), 1).reshape(n, -1)
    t, u, even, odd = np.empty((4, n, 3 * m))
    rules([p[:, 3 * j : 3 * (j + m)] for j in range(6)], t, u, even, odd)
    for c in range(3):  # three long loops, not many of three numbers
        new[:, 0::2, c], new[:, 1::2, c] = even[:, c::3], odd[:, c::3]


def surface_slices(p, new):
    """Along the rows, then across them straight into the result, in blocks of rows; five rows are kept for the next."""
    n, m = len(p) - 5, p.shape[1]
    size = max(1, min(n, BLOCK // (6 * m)))
    rows, scratch = np.empty((size + 5, 2 * m, 3)), np.empty((2, size, 2 * m, 3))
    along(p[:5], rows[:5])
    for i in range(0, n, size):
        k = min(size, n - i)
        along(p[i + 5 : i + 5 + k], rows[5 : 5 + k])
        t, u = scratch[:, :k]
        rules([rows[j : j + k] for j in range(6)], t, u, new[2 * i : 2 * (i + k) : 2], new[2 * i + 1 : 2 * (i + k) : 2])
        rows[:5] = rows[k : k + 5].copy()


# ---- np.convolve, ndimage --------------------------------------------------------------------------------------------


def curve_convolve(p, new):
    """Of one coordinate. np.convolve turns its second argument round: turned before, it is contiguous, and faster."""
    n = len(p) - 5
    for i in range(0, n, BLOCK):
        k = min(BLOCK, n - i)
        new[2 * i : 2 * (i + k) : 2] = np.convolve(p[i : i + k + 4], VERTEX[::-1], "valid")
        new[2 * i + 1 : 2 * (i + k) : 2] = np.convolve(p[i : i + k + 5], EDGE[::-1], "valid")


def ndimage_levels(f, arrays):
    from scipy import ndimage

    new = np.empty((arrays[-1].shape[0], 2 * arrays[-1].shape[1], 3))
    for k, out in enumerate([*arrays, new]):
        axis = k % 2
        at = (slice(None),) * axis
        ndimage.convolve1d(f, VERTEX, axis, out[at + (slice(0, None, 2),)], "wrap")
        ndimage.convolve1d(f, EDGE, axis, out[at + (slice(1, None, 2),)], "wrap")
        f = out
    return new


# ---- numba -----------------------------------------------------------------------------------------------------------


@njit(fastmath=True, cache=True)
def curve_numba(p, new):
    x, y = p.reshape(-1), new.reshape(-1)
    for i in range(len(p) - 5):
        for c in range(2):
            j, k = 2 * i + c, 4 * i + c
            y[k] = V2 * (x[j] + x[j + 8]) + V1 * (x[j + 2] + x[j + 6]) + V0 * x[j + 4]
            y[k + 2] = E2 * (x[j] + x[j + 10]) + E1 * (x[j + 2] + x[j + 8]) + E0 * (x[j + 4] + x[j + 6])


@njit(fastmath=True, cache=True)
def surface_numba(p, new):
    """Along each row into a ring of six rows, then across them: the result is written once, and nothing else."""
    height, m, _ = p.shape
    f, out = p.reshape(height, 3 * m), new.reshape(2 * height - 10, 6 * m)
    ring, x = np.empty((6, 6 * m)), np.empty(3 * m + 15)
    for i in range(height):
        x[:6], x[6 : 3 * m + 6], x[3 * m + 6 :] = f[i, 3 * m - 6 :], f[i], f[i, :9]
        row = ring[i % 6]
        for j in range(m):
            for c in range(3):
                k, l = 3 * j + c, 6 * j + c
                row[l] = V2 * (x[k] + x[k + 12]) + V1 * (x[k + 3] + x[k + 9]) + V0 * x[k + 6]
                row[l + 3] = E2 * (x[k] + x[k + 15]) + E1 * (x[k + 3] + x[k + 12]) + E0 * (x[k + 6] + x[k + 9])
        if i < 5:
            continue
        r0, r1, r2 = ring[(i + 1) % 6], ring[(i + 2) % 6], ring[(i + 3) % 6]
        r3, r4, r5 = ring[(i + 4) % 6], ring[(i + 5) % 6], row
        even, odd = out[2 * i - 10], out[2 * i - 9]
        for k in range(6 * m):
            even[k] = V2 * (r0[k] + r4[k]) + V1 * (r1[k] + r3[k]) + V0 * r2[k]
        for k in range(6 * m):
            odd[k] = E2 * (r0[k] + r5[k]) + E1 * (r1[k] + r4[k]) + E0 * (r2[k] + r3[k])


# ---- the rivals -------------------------------------------------------------------------------------------------------


def curves(f, count):
    """{rival: a call that refines}"""
    arrays, columns = scratch(f, count), [scratch(x.copy(), count) for x in f.T]
    return {
        "numpy": lambda: refine(curve_slices, arrays),
        "convolve": lambda: [refine(curve_convolve, x) for x in columns],
        "numba": lambda: refine(curve_numba, arrays),
    }


def surfaces(f, count):
    arrays, (n, m, _) = scratch(f, count), f.shape
    halves = [np.empty((2 * n << k // 2, m << (k + 1) // 2, 3)) for k in range(2 * count - 1)]
    return {
        "numpy": lambda: refine(surface_slices, arrays),
        "ndimage": lambda: ndimage_levels(f, halves),
        "numba": lambda: refine(surface_numba, arrays),
    }


def literal(f, count, axes):
    """The two rules as they are written, again and again along each axis."""
    for axis in [axis for _ in range(count) for axis in axes]:
        at = lambda k: np.roll(f, -k, axis)
        even = -ALPHA * at(-2) + 4 * ALPHA * at(-1) + (1 - 6 * ALPHA) * f + 4 * ALPHA * at(1) - ALPHA * at(2)
        inner, outer = (9 / 16 + 2 * B) * (f + at(1)), (1 / 16 + 3 * B) * (at(-1) + at(2))
        odd = B * at(-2) - outer + inner + B * at(3)
        f = np.stack((even, odd), axis + 1).reshape(*f.shape[:axis], -1, *f.shape[axis + 1 :])
    return f


def wave(*shape):
    """Points, those of `cargo bench -p refinable-refine`."""
    i = np.arange(np.prod(shape))
    return (i * i % 1013 / 7.0).reshape(shape)


def points(result):
    """An array; one coordinate at a time comes as a list."""
    return np.stack(result, 1) if isinstance(result, list) else result


def main(what, rival, rounds):
    """The least time is taken over rounds: the first ones meet memory and clocks that are not ready yet."""
    rivals, axes, count = (curves, [0], 10) if what == "curve" else (surfaces, [0, 1], 5)
    small = wave(12, 2) if what == "curve" else wave(12, 14, 3)
    refined = points(rivals(small, 3)[rival]())
    if abs(refined - literal(small, 3, axes)).max() > 1e-12:
        raise ArithmeticError("not the two rules as they are written")
    run, times = rivals(wave(1000, 2) if what == "curve" else wave(100, 100, 3), count)[rival], []
    for _ in range(rounds):
        start = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - start)
    seconds = min(times) / (points(result).size // points(result).shape[-1])
    print(json.dumps({"seconds": seconds, "points": refined.reshape(-1, refined.shape[-1]).tolist()}))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
