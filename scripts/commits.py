#!/usr/bin/env python3
"""Names commits that break the rules of CONTRIBUTING.md: commits.py [SINCE]. Without SINCE it checks the commits that
the branch's upstream lacks. Exit code 0: no commit breaks a rule, 1: some do, 2: SINCE is no commit."""

import re
import subprocess
import sys

LONGEST = 72

# Verbs that begin a second subject. Words of the second list are also nouns; after a comma they are verbs.
VERBS = """add allow ask build calculate choose close compile describe divide draw find fix give heed hold include join keep
leave let load make measure mend move pack put read refuse remove rename replace run say send sort spare split stop take teach
tell throw try turn update use wait write"""
NOUNS_TOO = "bend call check compare copy count cover cut drop list name order plan show start test"
SECOND = re.compile(rf"; |,? and ({'|'.join(VERBS.split())}) |, and ({'|'.join(NOUNS_TOO.split())}) ")


def faults(title, body):
    """The rules that a commit's message breaks, in words."""
    found = []
    if len(title) > LONGEST:
        found.append(f"title of {len(title)} letters")
    if SECOND.search(title):
        found.append("two subjects")
    if not body.strip():
        found.append("no body")
    return found


def messages(since):
    """Hash, title and body of the commits after `since`, the oldest first."""
    said = subprocess.run(["git", "log", "--no-merges", "--reverse", "--format=%h%x00%s%x00%b%x01", f"{since}.."],
                          capture_output=True, text=True)
    if said.returncode != 0:
        print(f"commits: git knows no \"{since}\" here; name a commit of this branch: ./run commits SINCE", file=sys.stderr)
        sys.exit(2)
    for entry in said.stdout.split("\x01\n")[:-1]:
        yield entry.split("\x00")


def main(since):
    commits = list(messages(since))
    wrong = [(*commit, found) for commit in commits if (found := faults(*commit[1:]))]
    for name, title, _, found in wrong:
        print(f"{name} {title}: {', '.join(found)}")
    print(f"{len(commits) - len(wrong)} of {len(commits)} commits keep the rules.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "@{upstream}"))
