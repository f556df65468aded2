"""agreement.py: compares results. Each function takes ours and the peer's, and returns what differs, or None."""

import re
from fractions import Fraction

TOLERANCE = Fraction(1, 10**9)


def value(text, **parameters):
    """An expression in exact numbers and parameters."""
    text = re.sub(r"\d+", r"Fraction(\g<0>)", text.replace("^", "**"))
    return eval(text, {"__builtins__": {}, "Fraction": Fraction, **parameters})


def mask(ours, peer):
    """Affine in alpha: two values tell."""
    for at in (Fraction(0), Fraction(2, 7)):
        a, b = ({c["index"]: value(c["coefficient"], alpha=at) for c in side["mask"]} for side in (ours, peer))
        if a != b:
            return f"coefficients at {sorted(i for i in a.keys() | b.keys() if a.get(i) != b.get(i))}"


def same_end(x, y):
    if x is None or y is None:
        return x is y
    gap = max(Fraction(x["lower"]), Fraction(y["lower"])) - min(Fraction(x["upper"]), Fraction(y["upper"]))
    return gap <= TOLERANCE


def exact_range(ours, peer):
    a, b = ours["proved"], peer["proved"]
    if len(a) != len(b):
        return f"{len(a)} proved intervals, the peer has {len(b)}"
    for i, (x, y) in enumerate(zip(a, b), 1):
        for end in ("lo", "hi"):
            if not same_end(x[end], y[end]):
                show = [v and v["exact"] for v in (x[end], y[end])]
                return f"end `{end}` of interval {i}: {show[0]}, the peer has {show[1]}"


def stratum(s):
    """Degrees, and the values of parameters that are numbers."""
    point = []
    for name, number in sorted(s["parameters"].items()):
        try:
            point.append((name, Fraction(number["exact"])))
        except ValueError:  # an expression in the other parameter
            pass
    tau = s["tau"]["exact"] if isinstance(s["tau"], dict) else s["tau"]
    return s["generation"], s["reproduction"], Fraction(str(tau)), tuple(point)


def degrees(ours, peer):
    a, b = ([stratum(s) for s in x["strata"]] for x in (ours, peer))
    if a[0] != b[0]:
        return "the generic stratum"
    only = sorted(set(a) ^ set(b))
    if only or len(a) != len(b):
        return f"strata (generation, reproduction, tau, point) of one side only: {only}"


def exponent(ours, peer):
    """Whether the certified bounds are inside the bracket, up to its rounding errors."""
    lower, upper = (Fraction(ours["holder"][end]) for end in ("lower", "upper"))
    below, above = (Fraction(x) for x in peer["hoelder"])
    if not peer["reached"]:
        return "the peer's bracket is too wide"
    if lower < below - Fraction(1, 10**6) or upper > above + Fraction(1, 10**6):
        return f"{float(lower)}..{float(upper)}, the peer has {float(below)}..{float(above)}"


def norms(ours, peer):
    pairs = list(zip(ours, peer["values"], strict=True))
    far = [k for k, ((x,), y) in enumerate(pairs) if abs(Fraction(x) - Fraction(y)) > TOLERANCE]
    if far:
        return f"{len(far)} of {len(pairs)} norms"


def continuity(ours, peer):
    """Norms prove less than we do; but nothing that we refute. They know C^3 at most."""
    pairs = list(zip(ours, peer["values"], strict=True))
    wrong = [k for k, ((n, next), y) in enumerate(pairs) if y > int(n) and next == "refuted"]
    if wrong:
        return f"{len(wrong)} of {len(pairs)} orders"


def points(ours, peer):
    pairs = zip(ours, peer["points"], strict=True)
    if any(abs(x - y) > 1e-9 for p, q in pairs for x, y in zip(p, q, strict=True)):
        return "the refined points"


def fastest(table, name):
    """The least seconds of a benchmark in the table that divan prints."""
    number, unit = re.search(rf"{name} +([\d.]+) (\S+)", table).groups()
    return float(number) * {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1}[unit]
