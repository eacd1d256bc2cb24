#!/usr/bin/env bash
# A file of tests in Blender as it is installed: run.sh FILE. Exit code 77: there is no Blender.
set -euo pipefail
if ! command -v blender >/dev/null; then
    echo "Nothing was tested: there is no Blender (apt install blender)"
    exit 77
fi
# Settings and add-ons of whoever runs the tests stay out of it.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export BLENDER_USER_CONFIG=$folder/config BLENDER_USER_SCRIPTS=$folder/scripts
blender --background --factory-startup --python-exit-code 1 --python "$(dirname "$0")/run.py" -- "$1"
