"""What docs/python.md says runs."""

import os
import pathlib
import re

from support import FolderTest

DOCUMENT = pathlib.Path(__file__).parents[2] / "docs" / "python.md"


class Tutorial(FolderTest):
    def test_runs(self) -> None:
        text = DOCUMENT.read_text(encoding="utf-8").split("\n## Recipes\n")[0]  # recipes_test runs the recipes
        blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        self.assertGreaterEqual(len(blocks), 4)
        before = pathlib.Path.cwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        names: dict = {}
        for block in blocks:
            exec(block, names)
        self.assertEqual(names["picture"].shape, (400, 640, 4))
        self.assertTrue((self.folder / "torus.png").exists())
        self.assertTrue((self.folder / "turn.png").exists())


if __name__ == "__main__":
    import unittest

    unittest.main()
