"""refine.py: refinement of curves and surfaces as experts write it in Python, to be set beside `cargo bench -p refinable-refine`.

    python3 benches/peers/refine.py            (pip install numpy scipy numba)

S_a5 at alpha = 1/16, beta = -1/48. Curves: closed, 2-D, 1000 points, ten levels. Surfaces: closed in both directions,
3-D, 100 x 100 points, five levels. Prints nanoseconds per point of the last level, least and median of several runs.
"""
import time

import numpy as np
from numba import njit
from scipy import ndimage

a, b = 1 / 16, -1 / 48 * (1 - 1 / 16)
VERTEX = np.array([-a, 4 * a, 1 - 6 * a, 4 * a, -a])
EDGE = np.array([b, -1 / 16 - 3 * b, 9 / 16 + 2 * b, 9 / 16 + 2 * b, -1 / 16 - 3 * b, b])


def slices(f):
    """A level along the first axis, by slices of a padded array."""
    n = len(f)
    p = np.concatenate((f[-2:], f, f[:3]))
    new = np.empty((2 * n,) + f.shape[1:])
    even, odd = new[0::2], new[1::2]
    np.multiply(p[0:n], VERTEX[0], out=even)
    np.multiply(p[0:n], EDGE[0], out=odd)
    for k in range(1, 5):
        even += VERTEX[k] * p[k:n + k]
    for k in range(1, 6):
        odd += EDGE[k] * p[k:n + k]
    return new


def convolved(columns):
    """A level of coordinates kept apart, by np.convolve."""
    new = []
    for x in columns:
        p = np.concatenate((x[-2:], x, x[:3]))
        y = np.empty(2 * len(x))
        y[0::2] = np.convolve(p[:-1], VERTEX[::-1], "valid")
        y[1::2] = np.convolve(p, EDGE[::-1], "valid")
        new.append(y)
    return new


@njit(cache=False)
def compiled(f, v, e):
    n, d = f.shape
    new = np.empty((2 * n, d))
    for i in range(n):
        inside = 2 <= i < n - 3
        for c in range(d):
            s = 0.0
            t = 0.0
            if inside:
                for k in range(5):
                    s += v[k] * f[i + k - 2, c]
                for k in range(6):
                    t += e[k] * f[i + k - 2, c]
            else:
                for k in range(5):
                    s += v[k] * f[(i + k - 2) % n, c]
                for k in range(6):
                    t += e[k] * f[(i + k - 2) % n, c]
            new[2 * i, c] = s
            new[2 * i + 1, c] = t
    return new


@njit(cache=False)
def compiled_surface(f, v, e):
    n, m, d = f.shape
    rows = np.empty((2 * n, m, d))
    for i in range(n):
        for j in range(m):
            for c in range(d):
                s = 0.0
                t = 0.0
                for k in range(5):
                    s += v[k] * f[(i + k - 2) % n, j, c]
                for k in range(6):
                    t += e[k] * f[(i + k - 2) % n, j, c]
                rows[2 * i, j, c] = s
                rows[2 * i + 1, j, c] = t
    new = np.empty((2 * n, 2 * m, d))
    for i in range(2 * n):
        for j in range(m):
            inside = 2 <= j < m - 3
            for c in range(d):
                s = 0.0
                t = 0.0
                if inside:
                    for k in range(5):
                        s += v[k] * rows[i, j + k - 2, c]
                    for k in range(6):
                        t += e[k] * rows[i, j + k - 2, c]
                else:
                    for k in range(5):
                        s += v[k] * rows[i, (j + k - 2) % m, c]
                    for k in range(6):
                        t += e[k] * rows[i, (j + k - 2) % m, c]
                new[i, 2 * j, c] = s
                new[i, 2 * j + 1, c] = t
    return new


def by_ndimage(f):
    for axis in (0, 1):
        shape = list(f.shape)
        shape[axis] *= 2
        new = np.empty(shape)
        even = [slice(None)] * 3
        odd = [slice(None)] * 3
        even[axis], odd[axis] = slice(0, None, 2), slice(1, None, 2)
        new[tuple(even)] = ndimage.correlate1d(f, VERTEX, axis=axis, mode="wrap")
        # Six weights around i + 1/2: the centre of the filter is moved by one.
        new[tuple(odd)] = ndimage.correlate1d(f, EDGE, axis=axis, mode="wrap", origin=-1)
        f = new
    return f


def by_slices(f):
    return np.ascontiguousarray(np.swapaxes(slices(np.ascontiguousarray(np.swapaxes(slices(f), 0, 1))), 0, 1))


def levels(step, f, count):
    for _ in range(count):
        f = step(f)
    return f


def report(name, points, run, runs):
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        run()
        times.append((time.perf_counter() - start) / points * 1e9)
    times.sort()
    print(f"{name:28} {times[0]:8.1f} {times[len(times) // 2]:8.1f}")


rng = np.random.default_rng(7)
small, net = rng.random((40, 2)), rng.random((12, 14, 3))
for other in (np.stack(levels(convolved, list(small.T), 3), 1), levels(lambda f: compiled(f, VERTEX, EDGE), small, 3)):
    assert abs(levels(slices, small, 3) - other).max() < 1e-12
for other in (levels(by_ndimage, net, 2), levels(lambda f: compiled_surface(f, VERTEX, EDGE), net, 2)):
    assert abs(levels(by_slices, net, 2) - other).max() < 1e-12

curve, surface = rng.random((1000, 2)), rng.random((100, 100, 3))
columns = [np.ascontiguousarray(x) for x in curve.T]
fine, mesh = levels(slices, curve, 10), levels(by_slices, surface, 5)
print(f"{'ns per point':28} {'least':>8} {'median':>8}")
report("curve, numpy slices", len(fine), lambda: levels(slices, curve, 10), 15)
report("curve, np.convolve", len(fine), lambda: levels(convolved, columns, 10), 15)
report("curve, numba, one thread", len(fine), lambda: levels(lambda f: compiled(f, VERTEX, EDGE), curve, 10), 15)
report("curve, copy", len(fine), fine.copy, 15)
points = mesh.shape[0] * mesh.shape[1]
report("surface, numpy slices", points, lambda: levels(by_slices, surface, 5), 5)
report("surface, ndimage", points, lambda: levels(by_ndimage, surface, 5), 5)
report("surface, numba, one thread", points, lambda: levels(lambda f: compiled_surface(f, VERTEX, EDGE), surface, 5), 5)
report("surface, copy", points, mesh.copy, 5)
