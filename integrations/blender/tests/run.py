"""Runs a file of tests within Blender: blender -b --factory-startup --python-exit-code 1 -P run.py -- FILE."""

import importlib
import pathlib
import sys
import unittest

here = pathlib.Path(__file__).parent
sys.path[:0] = [str(here), str(here.parent)]

import addon_utils  # noqa: E402

addon_utils.enable("lineatlas_blender", default_set=True, handle_error=lambda error: sys.exit(str(error)))
suite = unittest.defaultTestLoader.loadTestsFromModule(
    importlib.import_module(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).stem))
result = unittest.TextTestRunner(verbosity=2).run(suite)
if not result.wasSuccessful() or result.testsRun == 0:
    sys.exit(1)
