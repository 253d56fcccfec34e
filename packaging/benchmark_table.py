"""Prints what Google Benchmark measured as a Markdown table: our time, each peer's, and their ratio.

Usage: benchmark_table.py RESULT.json…, with benchmarks named stage/who/size, where "ours" is one who. Of repeated
runs the median is taken.
"""

import json
import re
import sys

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
# What Google Benchmark itself writes with each run; every other number is a counter of the benchmark.
OWN_KEYS = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations",
            "real_time", "cpu_time"}


def read(files):
    """{(stage, size): {who: (milliseconds, counters)}}, in the order of the files."""
    table = {}
    for file in files:
        with open(file) as stream:
            text = stream.read()
        # A program whose benchmarks the filter leaves out altogether writes an empty file.
        for run in json.loads(text)["benchmarks"] if text else []:
            if run.get("error_occurred"):
                sys.exit(f"{run['name']}: {run['error_message']}")
            if run.get("aggregate_name") != "median":
                continue
            # A benchmark without peers may leave "ours" out.
            parts = run["run_name"].split("/")
            stage, who, size = parts[:3] if len(parts) > 2 else (parts[0], "ours", parts[-1])
            counters = {key: value for key, value in run.items()
                        if isinstance(value, (int, float)) and key not in OWN_KEYS}
            table.setdefault((stage, size), {})[who] = (run["real_time"] * MILLISECONDS[run["time_unit"]], counters)
    return table


def size_order(size):
    """5k before 50k before 1.1M."""
    match = re.match(r"([\d.]+)([kM]?)", size)
    return float(match[1]) * {"": 1, "k": 1e3, "M": 1e6}[match[2]] if match else 0


def number(value):
    """Three digits or more, without an exponent."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def described(counters):
    return ", ".join(f"{key} {number(value) if abs(value) < 1e6 else f'{value:.3g}'}"
                     for key, value in counters.items())


def main():
    table = read(sys.argv[1:])
    stages = list(dict.fromkeys(stage for stage, _ in table))
    print("| stage | size | ours, ms | peer | peer, ms | peer / ours | ours, counters | peer, counters |")
    print("| --- | --- | ---: | --- | ---: | ---: | --- | --- |")
    for stage, size in sorted(table, key=lambda key: (stages.index(key[0]), size_order(key[1]))):
        runs = table[stage, size]
        ours, our_counters = runs.pop("ours", (None, {}))
        left = [stage, size, number(ours) if ours is not None else "–"]
        for peer, (time, counters) in runs.items() or [("–", (None, {}))]:
            ratio = number(time / ours) + " ×" if time and ours else "–"
            print("| " + " | ".join(left + [peer, number(time) if time is not None else "–", ratio,
                                            described(our_counters), described(counters)]) + " |")


main()
