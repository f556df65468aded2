"""tasks.py: what benches/peers/run computes, and with which tools; `refinable` comes first in each task."""

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass

import agreement

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
BINARY = os.environ.get("REFINABLE", "refinable")


@dataclass
class Command:
    """A process; `read` turns its standard output into (seconds that it states itself or None, its result)."""

    args: list
    text: str = ""
    read: callable = lambda out: (lambda result: (result.get("seconds"), result))(json.loads(out[out.index("{") :]))


@dataclass
class Task:
    title: str
    agree: callable  # (our result, the peer's) -> what differs, or None
    commands: dict
    unit: str = "ms"
    # For what our own command does not print.
    result: Command = None


# ---- how tools are called --------------------------------------------------------------------------------------------


def refinable(*args, read=None):
    command = Command([BINARY, *args])
    return Command(command.args, read=read) if read else Command([*command.args, "--format", "json"])


def pari(task, call, before=""):
    return Command(["gp", "-fq", "-s", "256M", os.path.join(HERE, "pari", task + ".gp")], f"{before}{task}({call})\n")


def maxima(task, call):
    path = os.path.join(HERE, "maxima", task + ".mac")
    return Command(["maxima", "--very-quiet", f'--batch-string=load("{path}")$ {task}({call})$'])


def python(folder, task, *args):
    return Command([sys.executable, os.path.join(HERE, folder, task + ".py"), *map(str, args)])


# A tool is called by the name before the comma; start-up is what it takes to do nothing.
NOTHING = lambda out: (None, out)
START = {
    "refinable": Command([BINARY, "--version"], read=NOTHING),
    "PARI/GP": Command(["gp", "-fq", "-s", "256M"], 'print("GP ", strjoin([Str(x) | x <- version()], "."))\n', NOTHING),
    "python-flint": Command([sys.executable, "-c", "import flint; print('flint', flint.__version__)"], read=NOTHING),
    "SymPy": Command([sys.executable, "-c", "import sympy; print('sympy', sympy.__version__)"], read=NOTHING),
    "Maxima": Command(["maxima", "--very-quiet", "--batch-string=?princ(build_info())$"], read=NOTHING),
    "numpy": Command([sys.executable, "-c", "import numpy; print('numpy', numpy.__version__)"], read=NOTHING),
    "scipy": Command([sys.executable, "-c", "import scipy.ndimage; print('scipy', scipy.__version__)"], read=NOTHING),
    "numba": Command([sys.executable, "-c", "import numba; print('numba', numba.__version__)"], read=NOTHING),
}
base = lambda tool: tool.split(",")[0]


# ---- the tasks -------------------------------------------------------------------------------------------------------


def mask(m):
    name = f"a{m}"
    peers = {
        "PARI/GP": pari("mask", f'"{name}"'),
        "python-flint": python("flint", "mask", name),
        "SymPy": python("sympy", "mask", name),
        "Maxima": maxima("mask", m),
    }
    return Task(f"mask of {name}", agreement.mask, {"refinable": refinable("show", name), **peers})


def degrees(m):
    name = f"a{m}"
    peers = {
        "PARI/GP": pari("degrees", f'"{name}"'),
        "python-flint": python("flint", "degrees", name),
        "SymPy": python("sympy", "degrees", name),
        "Maxima": maxima("degrees", m),
    }
    return Task(f"degrees of {name}", agreement.degrees, {"refinable": refinable("degrees", name), **peers})


def exact_range(m, n, levels):
    name = f"a{m}"
    call = f'"{name}", {n}, {levels}'
    ours = refinable("range", name, "--continuity", str(n), "--level", str(levels))
    peers = {
        "PARI/GP": pari("contractivity", call),
        # The textbook algorithm alone: roots of all coefficients, then of all signed sums.
        "PARI/GP, textbook": pari("contractivity", call, "bisections=0; "),
        "python-flint": python("flint", "contractivity", name, n, levels),
        "SymPy, textbook": python("sympy", "contractivity", name, n, levels),
        "Maxima, textbook": maxima("contractivity", f"{m}, {n}, {levels}"),
    }
    return Task(f"C^{n} of {name}, norms to level {levels}", agreement.exact_range, {"refinable": ours, **peers})


def exponent(scheme, alpha=None):
    """The exact exponent against a bracket of relative width 1e-3 in floats."""
    ours = refinable("regularity", scheme, *([f"--set=alpha={alpha}"] if alpha else []))
    peer = python("numpy", "gripenberg", scheme, "--delta", "1e-3")
    title = f"exponent of {scheme}" + (f" at {alpha}" if alpha else "")
    return Task(title, agreement.exponent, {"refinable": ours, "numpy, Gripenberg": peer})


def scan(what, count, tool):
    rows = lambda out: (None, [line.split(",")[2:] for line in out.splitlines()[1:]])
    steps = count - 1
    args = ["scan", "a5", f"--grid=alpha=0..1/8:{steps},beta=-1/10..0:{steps}", f"--what={what}"]
    args += ["--continuity=1", "--level=3"] if what == "norm" else []
    title = f"{'‖c_1^3‖' if what == 'norm' else 'C^0 to C^3'} of a5, {count} x {count} points"
    agree = agreement.norms if what == "norm" else agreement.continuity
    return Task(title, agree, {"refinable": refinable(*args, read=rows), tool: python("numpy", "scan", what, count)})


def benchmark(name, points, runs):
    """One of crates/refine/benches, which states its time."""
    args = ["cargo", "bench", "--quiet", "--manifest-path", os.path.join(ROOT, "Cargo.toml")]
    args += ["--package=refinable-refine", "--bench=refine", "--", "--exact", f"refine::{name}", f"--sample-count={runs}"]
    return Command(args, read=lambda out: (agreement.fastest(out, name) / points, None))


def refinement(what, rivals):
    """The least time for a point of many runs; a small polygon or net is compared."""
    points, levels, runs = (1000 << 10, 10, 200) if what == "curve" else (3200 * 3200, 5, 20)
    closed = ["--closed"] if what == "curve" else ["--closed", "both"]
    size, dimension = (12, 2) if what == "curve" else (12 * 14, 3)
    values = [i * i % 1013 / 7 for i in range(size * dimension)]
    lines = [",".join(map(repr, values[k : k + dimension])) + "\n" for k in range(0, len(values), dimension)]
    if what == "surface":
        lines = ["".join(lines[k : k + 14]) + "\n" for k in range(0, size, 14)]
    args = [what, "a5", "--set=alpha=1/16", "--set=beta=-1/48", "-", *closed, "--levels=3", "--format=csv"]
    rows = lambda out: (None, [list(map(float, x.split(",")[-dimension:])) for x in out.splitlines()[1:] if x])
    result = Command([BINARY, *args], "".join(lines), rows)
    ours = {"refinable": what, "refinable, a copy": what + "_copy"}
    if what == "surface":
        ours["refinable, by rows"] = "surface_rows"
    commands = {tool: benchmark(name, points, runs) for tool, name in ours.items()}
    commands |= {tool: python("numpy", "refine", what, rival, runs) for tool, rival in rivals.items()}
    title = "a5, a curve of 1000 points" if what == "curve" else "a5 by a5, a net of 100 x 100"
    return Task(f"{title}, {levels} levels", agreement.points, commands, "ns a point", result)


def tasks():
    curves = {"numpy, slices": "numpy", "numpy, convolve": "convolve", "numba": "numba"}
    surfaces = {"numpy, slices": "numpy", "scipy, ndimage": "ndimage", "numba": "numba"}
    return [
        *map(mask, (12, 20, 80)),
        *map(degrees, (4, 12, 43)),
        *(exact_range(*case) for case in ((4, 0, 3), (4, 0, 6), (12, 5, 6))),
        *(exponent(f"dd{points}") for points in (4, 8, 12, 16)),
        exponent("a12", "231/4194304"),  # where the order of the zero at -1 rises
        scan("norm", 100, "numpy"),
        scan("continuity", 100, "numba, floats"),
        refinement("curve", curves),
        refinement("surface", surfaces),
    ]


def missing():
    """{tool: why it cannot run}"""
    out = {}
    for tool, command in START.items():
        if not shutil.which(command.args[0]):
            out[tool] = f"no `{command.args[0]}` on the PATH"
        elif subprocess.run(command.args, input=command.text, capture_output=True, text=True).returncode:
            out[tool] = "its module cannot be imported"
    return out
