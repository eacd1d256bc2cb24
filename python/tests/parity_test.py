"""Python has what C++ has: every public name of the headers has a counterpart, or a reason why not (counterparts.py)."""

import re
import unittest

from counterparts import ELSEWHERE, NOT_IN_PYTHON, SAME
from public_headers import public_names
from stubs_test import compiled_parameters
from support import cube

import lineatlas



COUNTERPARTS = {name: name for name in SAME.split()} | ELSEWHERE
EXCEPTIONS = {name: reason for reason, names in NOT_IN_PYTHON.items() for name in names.split()}


def covers(entry: str, name: str) -> bool:
    whole = entry.removesuffix(".*")
    return name == whole or (entry.endswith(".*") and name.startswith(whole + "."))


def parameters_of(function: object) -> set:
    """Of a class those of its constructor."""
    function = function.__init__ if isinstance(function, type) else function
    return {name for name, _ in compiled_parameters(function)}


class Parity(unittest.TestCase):
    def setUp(self) -> None:
        self.names = {name for names in public_names().values() for name in names}

    def test_headers_are_read(self) -> None:
        """Some of each sort, so that a header the reader does not understand is no parity."""
        self.assertLessEqual({"Renderer.set_transforms()", "View.fov_y", "KnownEdge.Kind.marked", "extract_lines()",
                              "Renderer.Samples.alpha", "Method.item_buffer", "to_svg()", "UsageError"}, self.names)
        self.assertGreater(len(self.names), 400)

    def test_every_public_name_has_a_counterpart_or_a_reason(self) -> None:
        entries = [*COUNTERPARTS, *EXCEPTIONS]
        missing = sorted(name for name in self.names if not any(covers(entry, name) for entry in entries))
        self.assertEqual(missing, [], "public in C++, and counterparts.py knows neither where Python has it nor why not")

    def test_nothing_is_listed_that_is_gone_or_listed_twice(self) -> None:
        entries = [*COUNTERPARTS, *EXCEPTIONS]
        self.assertEqual([entry for entry in entries if not any(covers(entry, name) for name in self.names)], [])
        self.assertEqual(set(COUNTERPARTS) & set(EXCEPTIONS), set())

    def test_counterparts_are_there(self) -> None:
        found = lineatlas.intervals(cube())
        for name, counterpart in COUNTERPARTS.items():
            with self.subTest(name):
                path, call, inside = re.fullmatch(r"([\w.]+)(?:([(\[])([\w-]*)[)\]])?", counterpart).groups()
                real = lineatlas
                for part in path.split("."):
                    real = getattr(real, part)
                if call == "[":
                    known = lineatlas.Style().settings() if path == "Style" else found.dtype.names
                    self.assertIn(inside, known)
                elif call == "(":
                    self.assertTrue(callable(real))
                    if inside:
                        self.assertIn(inside, parameters_of(real))


if __name__ == "__main__":
    unittest.main()
