#!/usr/bin/env python3
"""Figures of drawings in docs/quality.md: measures them, and prints the page's table.

    scripts/figures.py measure MODEL...   # runs the benchmark, then writes docs/figures/drawings.json
    scripts/figures.py print              # the table of that file

`measure` refuses a tree with changes that are not committed, and models without one that the file has.

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
TOOL = ROOT / "build/release/lineatlas"
METHODS = ["EX", "SAhi"]

#: Heading, key of the benchmark's JSON, factor, decimal places, target.
COLUMNS = [("missed %", "missed", 100, 4, 0.05), ("false %", "false", 100, 4, 0.01),
           ("strictly hidden %", "strict_hidden", 100, 3, 0.3), ("surely wrong px", "surely_wrong_pixels", 1, 1, 2),
           ("missed ink %", "missed_ink", 100, 4, 0.02), ("false ink %", "false_ink", 100, 4, 0.1)]


def measure(models, up, commit):
    """Runs the benchmark by the tool in LINEATLAS_TOOL, else by that of build/release."""
    arguments = ["bench", "quality", "--paths", "--methods", ",".join(METHODS), "--scenes", "clevis,house,ship,office", "--up", up]
    given = [argument for model in models for argument in ("--model", model)]
    measured = ROOT / "build/drawings.json"  # FILE stays whole if the run fails
    measured.parent.mkdir(exist_ok=True)
    subprocess.run([os.environ.get("LINEATLAS_TOOL", TOOL), *arguments, *given, "--json", measured], check=True)
    names = [argument for model in models for argument in ("--model", pathlib.Path(model).name)]
    processor = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    run = {"command": " ".join(["lineatlas", *arguments, *names]), "commit": commit,
           "date": datetime.date.today().isoformat(),
           "machine": f"{processor[1] if processor else 'unknown'}, {os.cpu_count()} cores"}
    measured.write_text(json.dumps({"run": run, **json.loads(measured.read_text())}, indent=1) + "\n")
    measured.replace(FILE)


def left_out(models):
    """The models of the file's run that are not among `models`."""
    before = re.findall(r"--model (\S+)", json.loads(FILE.read_text())["run"]["command"])
    return [name for name in before if name not in [pathlib.Path(model).name for model in models]]


def head():
    """The commit of this tree; None if the tool may be of another one."""
    def git(*arguments):
        return subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
    if "LINEATLAS_TOOL" in os.environ or git("status", "--porcelain", "--untracked-files=no"):
        return None
    return git("rev-parse", "--short=8", "HEAD")


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
    parser.add_argument("--commit", help="the commit of the tool that is run; by default HEAD, if the tool is that of build/release")
    arguments = parser.parse_args()
    if arguments.what == "measure":
        if missing := left_out(arguments.models):
            parser.error(f"the table would lose the rows of {', '.join(missing)}: name these models, too")
        commit = arguments.commit or head()
        if commit is None:
            parser.error("the tool may be of another commit than HEAD: commit the changes, or name the tool's --commit")
        measure(arguments.models, arguments.up, commit)
    print(table(), end="")


if __name__ == "__main__":
    main()
