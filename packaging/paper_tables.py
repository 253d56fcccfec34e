"""Prints the paper's Table 1 and Table 2 as Markdown, from the reports of graftsman-cli.

Usage: paper_tables.py SCENARIOS REPORTS, where REPORTS holds a NAME.RUN.json for each run of SCENARIOS/NAME.json.
"""

import json
import re
import statistics
import sys
from pathlib import Path

MESHES = ["M1", "M2", "F1", "F2", "Fc", "Mc"]


def title(scenario_file):
    """'Fig. 8(b) cone, head' for fig8b_cone_nose.json, whose meshes are cone.stl and head.obj."""
    scenario = json.loads(scenario_file.read_text())
    figure, part = re.match(r"fig(\d+)([a-z]?)", scenario_file.stem).groups()
    letter = f"({part})" if part else ""
    return f"Fig. {figure}{letter} {Path(scenario['m1']).stem}, {Path(scenario['m2']).stem}"


def markdown(head, rows):
    """A Markdown table whose first column is text and whose others are numbers."""
    lines = [head, ["---"] + ["---:"] * (len(head) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def times(reports):
    """The columns of Table 1 in milliseconds: the medians over the reports of one scenario."""

    def median(milliseconds):
        return f"{statistics.median(milliseconds(report) for report in reports):.1f}"

    return [
        median(lambda report: report["paths_milliseconds"]["part"]),
        median(lambda report: report["paths_milliseconds"]["base"]),
        median(lambda report: report["milliseconds"]["adjust"]),
        median(lambda report: report["milliseconds"]["embed"] + report["milliseconds"]["overlay"]),
        median(lambda report: report["milliseconds"]["total"]),
    ]


def sizes(report):
    """The columns of Table 2: the number of pairs, and the vertices and faces of each mesh."""
    counts = [report["counts"][mesh] for mesh in MESHES]
    return [str(report["cvps"])] + [f"{count['v']}, {count['f']}" for count in counts]


def main():
    scenarios, reports = map(Path, sys.argv[1:])
    table1, table2 = [], []
    for scenario in sorted(scenarios.glob("*.json")):
        runs = [json.loads(file.read_text()) for file in reports.glob(f"{scenario.stem}.*.json")]
        table1.append([title(scenario)] + times(runs))
        table2.append([title(scenario)] + sizes(runs[0]))
    print("Table 1: times in milliseconds; Corres. = embedding and overlay, Total = from reading to writing.\n")
    print(markdown(["", "Short. Path M1", "Short. Path M2", "Adj.", "Corres.", "Total"], table1))
    print("\nTable 2: the number of pairs, and of vertices, faces.\n")
    print(markdown(["", "CVPs"] + MESHES, table2))


main()
