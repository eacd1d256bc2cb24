"""./run commits names the commits that break the rules, and no others."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from documents import ROOT

SCRIPT = ROOT / "scripts/commits.py"
WHY = "It was said twice."


class Commits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.git("init", "-q", "-b", "main")
        self.commit("Begin", WHY)

    def git(self, *arguments):
        identity = ["-c", "user.name=A", "-c", "user.email=a@b.invalid", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", *identity, *arguments], cwd=self.folder, check=True, capture_output=True)

    def commit(self, *message):
        self.git("commit", "-q", "--allow-empty", *(word for part in message for word in ("-m", part)))

    def commits(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, *arguments], cwd=self.folder, capture_output=True, text=True)

    def faults(self, *message):
        """What is said of a commit of its own."""
        self.commit(*message)
        said = self.commits("HEAD~1")
        lines = said.stdout.splitlines()
        self.assertEqual(1 if len(lines) == 2 else 0, said.returncode)
        return lines[0].removeprefix(lines[0].split()[0] + f" {message[0]}: ") if len(lines) == 2 else ""

    def test_a_title_has_72_letters(self):
        self.assertEqual("", self.faults("é" * 72, WHY))
        self.assertEqual("title of 73 letters", self.faults("é" * 73, WHY))

    def test_a_body_says_why(self):
        self.assertEqual("no body", self.faults("Say it once"))
        self.assertEqual("title of 73 letters, no body", self.faults("e" * 73))

    def test_two_things_done_are_two_subjects(self):
        for title in ["Say it once; test it", "Find silhouettes and draw tiles once", "Make one, and try another",
                      "Say what an arc's centre is, and test arcs of ellipses", "Let rims meet, and let them turn"]:
            self.assertEqual("two subjects", self.faults(title, WHY), title)

    def test_two_nouns_are_one_subject(self):
        for title in ["Read PLY, OFF and STL by readers of our own", "Let CI refuse warnings and unformatted sources",
                      "Keep one layout of the atlas and one way to widen runs", "Say what holds, by name and order of parts",
                      "Say how right round things are, by direction and method", "Sand and handle the rim once"]:
            self.assertEqual("", self.faults(title, WHY), title)

    def test_merges_are_nobodys_words(self):
        self.git("checkout", "-q", "-b", "other")
        self.commit("Say it elsewhere", WHY)
        self.git("checkout", "-q", "main")
        self.git("merge", "-q", "--no-ff", "-m", "Merge branch 'other'; and more", "other")
        self.assertEqual("1 of 1 commits keep the rules.\n", self.commits("HEAD~1").stdout)

    def test_without_a_commit_those_that_upstream_lacks(self):
        self.git("branch", "kept")
        self.git("branch", "--set-upstream-to=kept")
        self.assertEqual("0 of 0 commits keep the rules.\n", self.commits().stdout)
        self.commit("Say it once")
        said = self.commits()
        self.assertEqual(1, said.returncode)
        self.assertIn("Say it once: no body\n0 of 1 commits", said.stdout)

    def test_an_unknown_commit_is_named(self):
        for arguments, name in [(["nowhere"], "nowhere"), ([], "@{upstream}")]:
            said = self.commits(*arguments)
            self.assertEqual(2, said.returncode)
            self.assertEqual(f'commits: git knows no "{name}" here; name a commit of this branch: ./run commits SINCE\n',
                             said.stderr)


if __name__ == "__main__":
    unittest.main()
