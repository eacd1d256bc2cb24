#!/usr/bin/env bash
# Makes a bundle of build/bundle, moves it, and runs the short parts of its check. It is no part of the
# suite, because it needs a second build.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$root/scripts/bundle.sh" "$folder/made"
mv "$folder/made" "$folder/moved"
cd "$folder"
parts=(devices picture sharing_modes_test "interop copy" "frames clevis" pictures_test)
status=0
env -i PATH="$PATH" HOME="$HOME" moved/check "${parts[@]/#/--part=}" || status=$?
python3 - "${#parts[@]}" <<'END' || status=$?
import json, sys

parts = json.load(open("check.json"))["parts"]
for part in parts:
    for skipped in part.get("tests", {}).get("skipped", []):
        print("skipped:", skipped["name"], "-", skipped["message"].replace("\n", " "))
    for failed in part.get("tests", {}).get("failed", []):
        print("failed:", failed["name"], "-", failed["message"].replace("\n", " "))
    if part["outcome"] != "ok":
        print(part["name"], part["outcome"], part.get("output", ""))
if len(parts) != int(sys.argv[1]):
    sys.exit("bundle-test: check.json has %d parts" % len(parts))
END
exit "$status"
