"""timing.py: runs the tasks of benches/peers/run, which see, and prints one table. Standard library only.

Time is processor time, that of the whole process and all its threads, which other work on the machine disturbs less than
the clock on the wall. One run of each process is not timed: it warms the caches and gives the results. Then the processes
of a task take turns. Start-up, the least time a tool takes to do nothing, is taken off; peers in floats state their time
themselves, without what is imported and compiled. Ratios are to refinable in the same turn."""

import argparse
import csv
import os
import platform
import resource
import subprocess
import sys
from statistics import median

from tasks import START, base, missing, tasks

LIMIT = 60  # seconds of processor time
SLOW = 3  # seconds from which on a task is repeated SLOW times only
RESOLUTION = 1e-4  # seconds: what is less after start-up is noise
COLUMNS = ["task", "unit", "tool", "median", "least", "most", "ratio", "ratio_least", "ratio_most", "result"]


def processor():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command):
    """(seconds of processor time, standard output, or None and the complaint)"""
    start = processor()
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))
    done = subprocess.run(command.args, input=command.text, capture_output=True, text=True, preexec_fn=limit)
    seconds = processor() - start
    if seconds >= LIMIT * 0.99:
        return seconds, None, "slow"
    # gp exits with 0 on errors, and complains on standard error; Maxima complains in what it prints
    if done.returncode or "***" in done.stderr or "-- an error" in done.stdout:
        return seconds, None, (done.stderr.strip() or done.stdout.strip() or f"exit status {done.returncode}")[-300:]
    return seconds, done.stdout, ""


def start_up(absent, repetitions):
    """{tool: the least seconds to do nothing}, and lines with versions."""
    least, versions = {}, []
    for tool, command in START.items():
        if tool not in absent:
            times = [run(command) for _ in range(repetitions + 1)]
            least[tool] = min(seconds for seconds, _, _ in times[1:])
            said = times[0][1].replace('"', " ").split()
            version = next((word for word in said if word[:1].isdigit()), "?")
            versions.append(f"{tool} {version} ({least[tool] * 1e3:.0f} ms)")
    return least, versions


def measure(task, start, repetitions):
    """[(tool, seconds after start-up for each turn or None, verdict)]"""
    first = {tool: run(command) for tool, command in task.commands.items()}
    order = [tool for tool in task.commands if first[tool][1] is not None]
    times = {tool: [] for tool in order}
    if any(first[tool][0] > SLOW for tool in order):
        repetitions = min(repetitions, SLOW)
    for i in range(repetitions if order else 0):
        for tool in order[i % len(order) :] + order[: i % len(order)]:
            seconds, out, why = run(task.commands[tool])
            if out is None:
                raise RuntimeError(f"{task.title}, {tool}: {why}")
            stated, _ = task.commands[tool].read(out)
            times[tool].append(max(seconds - start[base(tool)], RESOLUTION) if stated is None else stated)
    results = {tool: task.commands[tool].read(first[tool][1])[1] for tool in order}
    if task.result:
        results["refinable"] = task.result.read(run(task.result)[1])[1]
    for tool in task.commands:
        if tool not in order:
            yield tool, None, first[tool][2]
        elif tool == "refinable" or "refinable" not in order or results[tool] is None:
            yield tool, times[tool], ""
        else:
            difference = task.agree(results["refinable"], results[tool])
            yield tool, times[tool], f"differ: {difference}" if difference else "agree"


def digits(x, count):
    """So many digits, or all before the point."""
    return f"{x:.{count}g}" if x < 10**count else f"{x:.0f}"


def rows(task, start, repetitions):
    """The rows of a task in the table, and whether all is well."""
    ours, scale = None, 1e3 if task.unit == "ms" else 1e9
    for tool, times, verdict in measure(task, start, repetitions):
        row = [task.title, task.unit, tool]
        if times is None:
            slow = verdict == "slow"
            row += [f"> {LIMIT} s", "", "", "", "", "", "" if slow else f"failed: {verdict}"]
            if slow and ours:
                row[6] = f"> {LIMIT / median(ours):.0f}"
            yield row, slow
            continue
        ours = times if tool == "refinable" else ours
        row += [digits(f(times) * scale, 3) for f in (median, min, max)]
        ratios = [t / o for t, o in zip(times, ours)] if ours and tool != "refinable" else []
        row += [digits(f(ratios), 2) for f in (median, min, max)] if ratios else [""] * 3
        yield row + [verdict], not verdict.startswith("differ")


def line(row, previous):
    title, unit, tool, mid, low, high, ratio, ratio_low, ratio_high, result = row
    label = f"{title} [{unit}]" if title != previous else ""
    times, ratios = (f"{a}..{b}" if a else "" for a, b in ((low, high), (ratio_low, ratio_high)))
    return f"{label:<50} {tool:<18} {mid:>7} {times:>15} {ratio:>7} {ratios:>14}  {result}".rstrip()


def main():
    parser = argparse.ArgumentParser(prog="benches/peers/run", description=__doc__)
    parser.add_argument("--only", default="", help="the tasks whose titles contain this")
    parser.add_argument("--csv", help="a file for the table")
    options = parser.parse_args()
    repetitions, absent = int(os.environ.get("REPETITIONS", 11)), missing()
    for tool, why in absent.items():
        print(f"{tool}: skipped, {why}")
    start, versions = start_up(absent, repetitions)
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"
    notes = [machine, "with start-up taken off: " + ", ".join(versions), f"{repetitions} turns"]
    print("\n".join(notes) + "\n")
    heads = line(["task", "unit", "tool", "median", "min", "max", "ratio", "min", "max", ""], "")
    print(heads + "\n" + "-" * 120)
    good, table, previous = True, [], ""
    for task in tasks():
        if options.only not in task.title:
            continue
        task.commands = {tool: c for tool, c in task.commands.items() if base(tool) not in absent}
        for row, well in rows(task, start, repetitions):
            print(line(row, previous), flush=True)
            good, previous = good and well, row[0]
            table.append(row)
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            file.writelines(f"# {note}\n" for note in notes)
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *table])
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
