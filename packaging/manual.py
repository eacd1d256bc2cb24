"""A manual page made of what a program says of itself:
python3 manual.py VERSION PAGE.1.gz PROGRAM [COMMAND]  runs PROGRAM [COMMAND] --help"""

import gzip
import pathlib
import re
import subprocess
import sys


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", text)


def paragraphs(lines):
    """Free text: what is indented is an example and stays as it stands."""
    page, in_example = [], False
    for line in lines:
        example = line.startswith("  ")
        if example != in_example:
            page.append(".nf" if example else ".fi")
        in_example = example
        page.append(escaped(line.strip()) if line.strip() else ".PP")
    return page + ([".fi"] if in_example else [])


def page_of(name, version, text):
    lines = text.splitlines()
    about = re.sub(r"^[\w -]+: ", "", lines[0])
    synopsis = next(line for line in lines if "[OPTIONS]" in line)  # CLI11 2.6 has no "Usage:" before it
    usage = re.sub(r"(?:Usage: )?\S*?([\w-]+)( |$)", r"\1 ", synopsis, count=1)
    page = [f'.TH {name.upper()} 1 "" "lineatlas {version}"', ".SH NAME", f"{escaped(name)} \\- {escaped(about)}",
            ".SH SYNOPSIS", escaped(usage.strip())]
    free, in_options = [], False
    for line in lines[lines.index(synopsis) + 1:]:
        option = re.match(r"  (\S.*?)(?:  +(\S.*))?$", line)
        more = re.match(r" {20,}(\S.*)$", line)
        if re.match(r"\S[^.]*:$", line) and line != "Examples:" and not free:
            page += [".SH " + escaped(line.rstrip(":")).upper()]
            in_options = True
        elif in_options and more:
            page.append(escaped(more[1]))
        elif in_options and option:
            page += [".TP", f".B {escaped(option[1])}"] + ([escaped(option[2])] if option[2] else [])
        elif line.strip() or free:
            in_options = False
            free.append(line)
    if free:
        page += [".SH MORE"] + paragraphs(free)
    return "\n".join(page + [".SH SEE ALSO", ".BR lineatlas (1)", ""])


def main(version, file, *command):
    said = subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout
    path = pathlib.Path(file)
    page = page_of(path.name.removesuffix(".1.gz"), version, said)
    path.write_bytes(gzip.compress(page.encode(), mtime=0))


main(*sys.argv[1:])
