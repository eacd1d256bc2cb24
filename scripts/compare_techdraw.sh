#!/usr/bin/env bash
# Compares isometric drawings by lineatlas and by FreeCAD's TechDraw, of models with exact surfaces, from file to SVG. Checks
# both by rays: scripts/compare_techdraw.sh FOLDER MODEL...
# Needs FreeCAD as a Python module (Debian: apt install freecad-python3) and a build of lineatlas with its module for rays.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "$0")/.." && pwd)
tool=${LINEATLAS:-$root/build/release/lineatlas}
python=${PYTHON:-/usr/bin/python3}
if (($# < 2)); then
    echo "usage: compare_techdraw.sh FOLDER MODEL..." >&2
    exit 2
fi
folder=$1
shift


figure() { # TABLE ROW
    sed -n "s/^$2 *\([0-9.]*\) %.*/\1/p" "$1"
}

pieces() { # SVG DRAWING; its paths, and its arcs: as commands of FreeCAD's SVG, or as curves of our JSON
    local arcs
    arcs=$(($(grep -o ' d="[^"]*"' "$1" | tr -cd A | wc -c) + $(grep -o '"major"' "$2" | wc -l)))
    echo "$(grep -o '<path' "$1" | wc -l) | $arcs"
}

report() { # PROGRAM SECONDS MEGABYTES SVG DRAWING
    local table=$folder/$name-$1.txt
    "$tool" check "$5" "$model" --worst 20 >"$table"
    printf '| %s | %s | %s | %s | %s | %s / %s | %s / %s |\n' "$name" "$1" "$2" "$3" "$(pieces "$4" "$5")" \
        "$(figure "$table" "missed within 1.5 px")" "$(figure "$table" "false within 1.5 px")" \
        "$(figure "$table" "missed within 0.5 px")" "$(figure "$table" "false within 0.5 px")"
}

timed() { # COMMAND...; leaves seconds, on the clock and of processors, and MB
    /usr/bin/time -f '%e %U %S %M' -o "$folder/time.txt" "$@" >"$folder/log.txt" 2>&1
    read -r clock user system kilobytes <"$folder/time.txt"
    seconds="$clock | $(awk "BEGIN { printf \"%.2f\", $user + $system }")"
    megabytes=$((kilobytes / 1024))
}

mkdir -p "$folder"
echo "| model | program | seconds, file to SVG | of processors | MB | paths | arcs | missed / false % at 1.5 px | at 0.5 px |"
echo "|---|---|---|---|---|---|---|---|---|"
for model; do
    name=$(basename "$model")
    # Draws as a user would. A second drawing has very fine triangles, which rays need.
    draw=("$tool" draw "$model" --size 1024x768 --view isometric)
    timed "${draw[@]}" -o "$folder/$name.svg"
    "${draw[@]}" -o "$folder/$name.json" --lines crease,boundary,silhouette \
        --deflection "${DEFLECTION:-0.01}" >/dev/null 2>&1
    report lineatlas "$seconds" "$megabytes" "$folder/$name.svg" "$folder/$name.json"
    timed "$python" "$root/scripts/techdraw.py" "$model" "$folder/$name-techdraw.svg"
    "$python" "$root/scripts/techdraw.py" "$model" - "$folder/$name.json" "$folder/$name-techdraw.json" >"$folder/log.txt"
    report TechDraw "$seconds" "$megabytes" "$folder/$name-techdraw.svg" "$folder/$name-techdraw.json"
done
