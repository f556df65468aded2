"""timing.py BINARY REPETITIONS: the table of benches/peers/run, which see. Standard library only."""

import json
import os
import platform
import shutil
import subprocess
import sys
import time
from fractions import Fraction
from statistics import median

HERE = os.path.dirname(os.path.abspath(__file__))
TOLERANCE = Fraction(1, 10**9)
TIMEOUT = 600  # seconds


def gp(script, call):
    """A command (arguments, standard input) that runs a call in a GP script."""
    return ["gp", "-fq", "-s", "256M", os.path.join(HERE, script)], call + "\n"


def flint(script, *args):
    return [sys.executable, os.path.join(HERE, script), *args], ""


def tasks(binary):
    """[(title, kind, {tool: command})], refinable first."""
    out = []
    for scheme, n, level in (("a4", 0, 6), ("a12", 5, 6)):
        args = ["range", scheme, "--continuity", str(n), "--level", str(level), "--format", "json"]
        commands = {
            "refinable": ([binary, *args], ""),
            "PARI/GP": gp("contractivity.gp", f'contractivity("{scheme}", {n}, {level})'),
            # The textbook algorithm alone: roots of all coefficients, then of all signed sums.
            "PARI/GP, textbook": gp(
                "contractivity.gp", f'bisections=0; contractivity("{scheme}", {n}, {level})'
            ),
            "python-flint": flint("contractivity.py", scheme, str(n), str(level)),
        }
        out.append((" ".join(args[:-2]), "range", commands))
    commands = {
        "refinable": ([binary, "degrees", "a43", "--format", "json"], ""),
        "PARI/GP": gp("degrees.gp", 'degrees("a43")'),
        "python-flint": flint("degrees.py", "a43"),
    }
    out.append(("degrees a43", "degrees", commands))
    special = "231/4194304"  # of a12: the value at which the order of the zero at -1 rises
    for scheme in [f"dd{k}" for k in range(4, 17, 2)] + ["a12"]:
        settings = ["--set", f"alpha={special}"] if scheme == "a12" else []
        args = ["regularity", scheme, *settings, "--format", "json"]
        # The exact exponent against a bracket of relative width 1e-3 in floating point.
        peer = [sys.executable, os.path.join(HERE, "gripenberg.py"), scheme, "--delta", "1e-3", "--alpha", special]
        commands = {"refinable": ([binary, *args], ""), "numpy, Gripenberg": (peer, "")}
        out.append((" ".join(args[:-2]), "exponent", commands))
    commands = {
        "refinable": ([binary, "--version"], ""),
        "numpy, Gripenberg": ([sys.executable, "-c", "import numpy"], ""),
        "PARI/GP": (["gp", "-fq", "-s", "256M"], "print(1)\n"),
        "python-flint": ([sys.executable, "-c", "import flint"], ""),
    }
    out.append(("start-up alone", "none", commands))
    return out


def missing_peers():
    """{tool: why it cannot run}"""
    out = {}
    if not shutil.which("gp"):
        out["PARI/GP"] = "no `gp` on the PATH (apt install pari-gp)"
        out["PARI/GP, textbook"] = out["PARI/GP"]
    if subprocess.run([sys.executable, "-c", "import flint"], capture_output=True).returncode:
        out["python-flint"] = "no module `flint` (pip install python-flint)"
    if subprocess.run([sys.executable, "-c", "import numpy"], capture_output=True).returncode:
        out["numpy, Gripenberg"] = "no module `numpy` (pip install numpy)"
    return out


def versions(binary, missing):
    commands = {
        "refinable": ([binary, "--version"], ""),
        "PARI/GP": (["gp", "-fq"], 'v = version(); print(v[1], ".", v[2], ".", v[3])\n'),
        "python-flint": ([sys.executable, "-c", "import flint; print(flint.__version__)"], ""),
        "numpy, Gripenberg": ([sys.executable, "-c", "import numpy; print(numpy.__version__)"], ""),
    }
    for tool, (args, text) in commands.items():
        if tool not in missing:
            run = subprocess.run(args, input=text, capture_output=True, text=True)
            yield f"{tool} {(run.stdout.split() or ['?'])[-1]}"


def run(command):
    """(seconds, standard output, or None and the complaint)"""
    args, text = command
    start = time.perf_counter()
    try:
        done = subprocess.run(args, input=text, capture_output=True, text=True, timeout=TIMEOUT)
    except (OSError, subprocess.TimeoutExpired) as error:
        return time.perf_counter() - start, None, str(error)
    seconds = time.perf_counter() - start
    # gp exits with 0 on errors, and complains on standard error
    if done.returncode or "***" in done.stderr:
        return seconds, None, done.stderr.strip() or f"exit status {done.returncode}"
    return seconds, done.stdout, ""


# ---- comparing results ---------------------------------------------------------------------------------------------


def same_end(x, y):
    if x is None or y is None:
        return x is y
    gap = max(Fraction(x["lower"]), Fraction(y["lower"])) - min(Fraction(x["upper"]), Fraction(y["upper"]))
    return gap <= TOLERANCE


def compare_range(ours, peer):
    """What differs, or None."""
    a, b = ours["proved"], peer["proved"]
    if len(a) != len(b):
        return f"{len(a)} proved intervals, the peer has {len(b)}"
    for i, (x, y) in enumerate(zip(a, b), 1):
        for end in ("lo", "hi"):
            if not same_end(x[end], y[end]):
                show = [v and v["exact"] for v in (x[end], y[end])]
                return f"end `{end}` of interval {i}: {show[0]}, the peer has {show[1]}"
    return None


def stratum(s):
    """Degrees, and the parameters if all of them are numbers (a point)."""
    values = []
    for name, number in sorted(s["parameters"].items()):
        try:
            values.append((name, Fraction(number["exact"])))
        except ValueError:  # an expression in the other parameter: a curve
            values = []
            break
    point = tuple(values) if len(values) == 2 else ()
    tau = s["tau"]["exact"] if isinstance(s["tau"], dict) else s["tau"]
    return s["generation"], s["reproduction"], Fraction(str(tau)), point


def compare_degrees(ours, peer):
    a, b = ([stratum(s) for s in x["strata"]] for x in (ours, peer))
    if a[0] != b[0]:
        return "the generic stratum"
    only = set(a) ^ set(b)
    if only:
        return "strata (generation, reproduction, tau, point) of one side only: " + "; ".join(
            f"({g}, {r}, {t}, {', '.join(f'{k} = {v}' for k, v in p) or '-'})" for g, r, t, p in sorted(only)
        )
    return None


def compare_exponent(ours, peer):
    """Whether the certified bounds are inside the bracket, up to its rounding errors."""
    lower, upper = (Fraction(ours["holder"][end]) for end in ("lower", "upper"))
    below, above = (Fraction(x) for x in peer["hoelder"])
    if not peer["reached"]:
        return "the peer's bracket is too wide"
    if lower < below - Fraction(1, 10**6) or upper > above + Fraction(1, 10**6):
        return f"{float(lower)}..{float(upper)}, the peer has {float(below)}..{float(above)}"
    return None


def compare(kind, ours, peer):
    if kind == "none":
        return None
    try:
        comparisons = {"range": compare_range, "degrees": compare_degrees, "exponent": compare_exponent}
        return comparisons[kind](json.loads(ours), json.loads(peer))
    except (ValueError, KeyError, TypeError, IndexError) as error:
        return f"unreadable output: {error!r}"


# ---- the table -------------------------------------------------------------------------------------------------------


def milliseconds(x):
    x *= 1000
    return f"{x:.1f}" if x < 100 else f"{x:.0f}"


def main(binary, repetitions):
    missing = missing_peers()
    for tool, why in missing.items():
        print(f"{tool}: skipped, {why}")
    print(f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores; " + ", ".join(versions(binary, missing)))
    print(f"whole processes, milliseconds, {repetitions} interleaved repetitions after one untimed run;")
    print("ratio of medians, to refinable\n")

    head = f"{'task':<38} {'tool':<17} {'median':>8} {'min..max':>16} {'ratio':>8}  result"
    print(head + "\n" + "-" * len(head))
    good, notes = True, []
    for title, kind, commands in tasks(binary):
        commands = {tool: c for tool, c in commands.items() if tool not in missing}
        results = {tool: run(c) for tool, c in commands.items()}  # untimed: warms the caches, gives the results
        times = {tool: [] for tool in commands}
        order = [tool for tool in commands if results[tool][1] is not None]
        for i in range(repetitions):
            for tool in order[i % len(order) :] + order[: i % len(order)] if order else []:
                times[tool].append(run(commands[tool])[0])
        for tool in commands:
            label = title if tool == "refinable" else ""
            if tool not in order:
                good = False
                notes.append(f"{title}, {tool}: {results[tool][2]}")
                print(f"{label:<38} {tool:<17} {'failed':>8}")
                continue
            mid, spread = median(times[tool]), f"{milliseconds(min(times[tool]))}..{milliseconds(max(times[tool]))}"
            ratio = verdict = ""
            if "refinable" in order:
                ratio = f"{mid / median(times['refinable']):.2f}"
                if tool != "refinable" and kind != "none":
                    difference = compare(kind, results["refinable"][1], results[tool][1])
                    verdict = "differ" if difference else "agree"
                    if difference:
                        good = False
                        notes.append(f"{title}, {tool}: {difference}")
            print(f"{label:<38} {tool:<17} {milliseconds(mid):>8} {spread:>16} {ratio:>8}  {verdict}")
    if notes:
        print("\n" + "\n".join(notes))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
