"""The Python package lineatlas, from where it is installed or from the folder of the preferences."""

import importlib
import os
import sys

import bpy

from .errors import DrawingError

ADDON = __package__


def folder_of_preferences():
    addon = bpy.context.preferences.addons.get(ADDON)
    return bpy.path.abspath(addon.preferences.folder) if addon and addon.preferences.folder else ""


def load():
    """The package. A folder of the preferences, then LINEATLAS_PYTHONPATH, go before Python's own:
    Blender itself does not look at PYTHONPATH."""
    if "lineatlas" in sys.modules:
        return sys.modules["lineatlas"]
    folder = folder_of_preferences() or os.environ.get("LINEATLAS_PYTHONPATH", "")
    if folder and folder not in sys.path:
        sys.path.insert(0, folder)
    try:
        return importlib.import_module("lineatlas")
    except ImportError as error:
        version = ".".join(map(str, sys.version_info[:2]))
        raise DrawingError(
            f"the Python package lineatlas cannot be imported ({error}): install it for Blender's "
            f"Python {version}, or name its folder in the preferences of this add-on") from None
