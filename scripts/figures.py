#!/usr/bin/env python3
"""Figures of drawings in docs/quality.md: measures them, and prints the page's table.

    scripts/figures.py measure [MODEL...]   # runs the benchmark and writes docs/figures/drawings.json
    scripts/figures.py print                # the table of that file

A test compares the page with the file.
"""

import argparse
import datetime
import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILE = ROOT / "docs/figures/drawings.json"
METHODS = ["EX", "SAhi"]

#: Heading, key of the benchmark's JSON, factor, decimal places, target.
COLUMNS = [("missed %", "missed", 100, 4, 0.05), ("false %", "false", 100, 4, 0.01),
           ("strictly hidden %", "strict_hidden", 100, 3, 0.3), ("surely wrong px", "surely_wrong_pixels", 1, 1, 2),
           ("missed ink %", "missed_ink", 100, 4, 0.02), ("false ink %", "false_ink", 100, 4, 0.1)]


def measure(models, up, commit):
    """Runs the benchmark by the tool in LINEATLAS_TOOL, else by that of build/release."""
    tool = os.environ.get("LINEATLAS_TOOL", ROOT / "build/release/lineatlas")
    arguments = ["bench", "quality", "--paths", "--methods", ",".join(METHODS)]
    if models:
        arguments += ["--scenes", "clevis,house,ship,office", "--up", up]
    given = [argument for model in models for argument in ("--model", model)]
    FILE.parent.mkdir(exist_ok=True)
    subprocess.run([tool, *arguments, *given, "--json", FILE], check=True)
    names = [argument for model in models for argument in ("--model", pathlib.Path(model).name)]
    processor = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    run = {"command": " ".join(["lineatlas", *arguments, *names]), "commit": commit,
           "date": datetime.date.today().isoformat(),
           "machine": f"{processor[1] if processor else 'unknown'}, {os.cpu_count()} cores"}
    FILE.write_text(json.dumps({"run": run, **json.loads(FILE.read_text())}, indent=1) + "\n")


def cell(value, factor, places, target):
    text = f"{factor * value:.{places}f}"
    return f"**{text}**" if float(text) > target else text


def table():
    """The table as the page has it. Two figures of a cell are those of EX and SAhi."""
    views = json.loads(FILE.read_text())["paths"]
    lines = ["| view | visible px | " + " | ".join(column[0] for column in COLUMNS) + " |", "|---" * (2 + len(COLUMNS)) + "|"]
    for view, methods in views.items():
        cells = [view, f"{methods['EX']['visible']:,.0f}"]
        for _, key, *form in COLUMNS:
            cells.append(", ".join(cell(methods[method][key], *form) for method in METHODS))
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["measure", "print"])
    parser.add_argument("models", nargs="*", metavar="MODEL")
    parser.add_argument("--up", default="y", help="the upward axis of all models, or of each in turn: z,z,y")
    parser.add_argument("--commit", help="the commit of the tool that is run; by default HEAD")
    arguments = parser.parse_args()
    if arguments.what == "measure":
        head = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], cwd=ROOT, check=True, capture_output=True, text=True)
        measure(arguments.models, arguments.up, arguments.commit or head.stdout.strip())
    print(table(), end="")


if __name__ == "__main__":
    main()
