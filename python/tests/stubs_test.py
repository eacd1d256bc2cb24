"""Stubs, docstrings and the module agree."""

import ast
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import lineatlas
from lineatlas import _lineatlas

PACKAGE = pathlib.Path(lineatlas.__file__).parent
STUB = ast.parse((PACKAGE / "_lineatlas.pyi").read_text())
PUBLIC_STUB = ast.parse((PACKAGE / "__init__.pyi").read_text())


def value_of(node: ast.expr) -> object:
    value = ast.literal_eval(node)
    return tuple(value) if isinstance(value, list) else value


def stub_parameters(function: ast.FunctionDef) -> list:
    """Names in order, "*" before those by keyword alone, with defaults."""
    arguments = function.args
    plain = [a.arg for a in arguments.args]
    defaults = [None] * (len(plain) - len(arguments.defaults)) + list(arguments.defaults)
    result = [(n, d and repr(value_of(d))) for n, d in zip(plain, defaults)]
    if arguments.vararg:
        result.append(("*" + arguments.vararg.arg, None))
    elif arguments.kwonlyargs:
        result.append(("*", None))
    result += [(a.arg, d and repr(value_of(d)))
               for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    if arguments.kwarg:
        result.append(("**" + arguments.kwarg.arg, None))
    return [p for p in result if p[0] not in ("self", "/")]


def at_depth_zero(text: str, separator: str) -> list:
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == separator and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def compiled_parameters(function: object) -> list:
    """The same of the signature in the first line of a docstring."""
    line = function.__doc__.splitlines()[0]
    inside = line[line.index("(") + 1:line.rindex(")", 0, line.rindex(" -> "))]
    result = []
    for part in at_depth_zero(inside, ","):
        left, *default = at_depth_zero(part, "=")
        default = repr(value_of(ast.parse(default[0], mode="eval").body)) if default else None
        result.append((at_depth_zero(left, ":")[0], default))
    return [p for p in result if p[0] not in ("self", "")]


def functions(body: list) -> dict:
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def is_property(node: ast.FunctionDef) -> bool:
    return any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)


def classes(tree: ast.Module) -> dict:
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


def public(names: object) -> set:
    return {name for name in names if not name.startswith("_")}


class Compiled(unittest.TestCase):
    def test_names(self) -> None:
        stub = set(functions(STUB.body)) | set(classes(STUB))
        stub |= {node.target.id for node in STUB.body if isinstance(node, ast.AnnAssign)}
        self.assertEqual(public(stub), public(vars(_lineatlas)))

    def test_functions(self) -> None:
        for name, node in functions(STUB.body).items():
            self.assertEqual(compiled_parameters(getattr(_lineatlas, name)), stub_parameters(node),
                             name)

    def test_classes(self) -> None:
        compared = 0
        for name, node in classes(STUB).items():
            real = getattr(_lineatlas, name)
            members = functions(node.body)
            self.assertEqual(public(members), public(vars(real)), name)
            for member, declared in members.items():
                found = vars(real)[member]
                if is_property(declared):
                    self.assertIsInstance(found, property, f"{name}.{member}")
                else:
                    self.assertEqual(compiled_parameters(found), stub_parameters(declared),
                                     f"{name}.{member}")
                    compared += 1
        self.assertGreater(compared, 15)

    def test_options_are_those_of_the_table(self) -> None:
        """The docstring is made of the table, a line per option; the signature is not."""
        lines = (lineatlas.Options.__doc__ or "").splitlines()
        documented = [line.split(":")[0] for line in lines if ": " in line]
        declared = stub_parameters(functions(classes(STUB)["Options"].body)["__init__"])
        self.assertEqual(documented, [name for name, _ in declared if name != "*"])

    def test_bases_of_errors(self) -> None:
        for name, node in classes(STUB).items():
            if node.bases:
                self.assertEqual([base.id for base in node.bases],
                                 [base.__name__ for base in getattr(_lineatlas, name).__bases__])


class Public(unittest.TestCase):
    def test_names(self) -> None:
        imported = {alias.name for node in PUBLIC_STUB.body
                    if isinstance(node, ast.ImportFrom) and node.module == "_lineatlas"
                    for alias in node.names if alias.asname}
        own = set(functions(PUBLIC_STUB.body)) | set(classes(PUBLIC_STUB))
        self.assertEqual(imported | own, set(lineatlas.__all__))
        self.assertEqual(public(lineatlas.__all__),
                         {n for n in public(vars(lineatlas)) if n != "annotations"})

    def test_functions_take_what_the_renderer_does(self) -> None:
        renderer = functions(classes(STUB)["Renderer"].body)
        made = [p for p in stub_parameters(renderer["__init__"])
                if p[0] != "one_picture"]  # which these functions set themselves
        for name, node in functions(PUBLIC_STUB.body).items():
            used = [p for p in stub_parameters(renderer[name]) if p[0] != "*" and p not in made]
            self.assertEqual(stub_parameters(node), made + used, name)
        self.assertEqual([p[0] for p in made if p[0] not in ("model", "*")],
                         list(lineatlas._OF_RENDERER))

    def test_line_kinds(self) -> None:
        stub = {node.targets[0].id: node.value.value
                for node in classes(PUBLIC_STUB)["LineKind"].body}
        self.assertEqual(stub, {kind.name: kind.value for kind in lineatlas.LineKind})

    def test_everything_is_documented(self) -> None:
        for name in public(lineatlas.__all__) - {"SCENES"}:
            item = getattr(lineatlas, name)
            self.assertTrue(item.__doc__, name)
            if isinstance(item, type):
                for member, found in vars(item).items():
                    if not member.startswith("_") and not isinstance(found, int):
                        text = found.__doc__ or ""
                        lines = text.splitlines()[1:] if callable(found) else text
                        self.assertTrue(lines, f"{name}.{member}")

    def test_type_checker_agrees(self) -> None:
        """The stubs make sense, and the command line uses the package as they say."""
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed")
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(["mypy", "--strict", "--cache-dir", cache, "-p", "lineatlas"],
                                  capture_output=True, text=True, cwd=PACKAGE.parent)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
