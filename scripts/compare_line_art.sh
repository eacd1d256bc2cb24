#!/usr/bin/env bash
# Draws the built-in scenes by lineatlas, by its add-on in Blender, and by Blender's Line Art and Freestyle. Checks all
# drawings by rays: scripts/compare_line_art.sh [FOLDER [SCENE...]]
# PROGRAMS="addon line_art freestyle" chooses the rivals. Freestyle takes 7 GB and many minutes for the ship.
# Needs Blender 3.3 or newer (Debian: apt install blender) and a build of lineatlas with its Python package and its module
# for rays.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "$0")/.." && pwd)
tool=${LINEATLAS:-$root/build/release/lineatlas}
folder=${1:-$root/build/line_art}
shift $(($# > 0 ? 1 : 0))
scenes=("$@")
((${#scenes[@]})) || scenes=(clevis house ship office)
lines=crease,boundary,silhouette # kinds that all programs know
export LINEATLAS_PYTHONPATH=${LINEATLAS_PYTHONPATH-$root/build/release/python}

for program in "$tool" blender; do
    if ! command -v "$program" >/dev/null; then
        echo "compare_line_art: there is no $program (apt install blender; ./run build)" >&2
        exit 1
    fi
done

# The view from within a scene, as in bench quality --paths.
inside() { # SCENE
    case $1 in
    clevis) echo --eye 0.09,0.05,0 --target 0,0.06,0 --fov 60 ;;
    house) echo --eye -3.6,2.8,2.7 --target 4,2,-3 --fov 60 ;;
    *) # the drawing of lineatlas tells the camera
        "$tool" draw --scene "$1" --at 0.3 --no-tags -o "$folder/inside.json" >/dev/null
        grep -om1 -- '--eye [^"]*' "$folder/inside.json"
        ;;
    esac
}

figure() { # TABLE ROW
    sed -n "s/^$2 *\([0-9.]*\) %.*/\1/p" "$1"
}

report() { # PROGRAM SECONDS
    local table=$folder/table.txt
    "$tool" check "$folder/drawing.json" "$model" --worst 20 >"$table"
    cp "$table" "$folder/$name-$1.txt"
    printf '| %s | %s | %s / %s | %s / %s | %s |\n' "$name" "$1" \
        "$(figure "$table" "missed within 1.5 px")" "$(figure "$table" "false within 1.5 px")" \
        "$(figure "$table" "missed within 0.5 px")" "$(figure "$table" "false within 0.5 px")" "$2"
}

mkdir -p "$folder"
echo "| view | program | missed / false % at 1.5 px | at 0.5 px | seconds, file to drawing |"
echo "|---|---|---|---|---|"
for scene in "${scenes[@]}"; do
    model=$folder/$scene.obj
    "$tool" scene "$scene" -o "$model"
    for view in outside inside; do
        name="$scene $view"
        camera=()
        if [ $view = inside ]; then read -ra camera <<<"$(inside "$scene")"; fi
        begin=$EPOCHREALTIME
        "$tool" draw "$model" -o "$folder/drawing.json" --lines $lines "${camera[@]}" 2>"$folder/draw.log"
        end=$EPOCHREALTIME
        cp "$folder/drawing.json" "$folder/own.json"
        report lineatlas "$(awk "BEGIN { printf \"%.1f\", $end - $begin }")"
        for program in ${PROGRAMS-addon line_art freestyle}; do
            if blender --background --factory-startup --python-exit-code 1 \
                --python "$root/scripts/line_art.py" -- "$program" "$model" "$folder/own.json" \
                "$folder/drawing.json" >"$folder/$program.log" 2>&1; then
                report "$program" "$(sed -n 's/^seconds //p' "$folder/$program.log")"
            else
                echo "| $name | $program | failed: $folder/$program.log | | |"
            fi
        done
    done
done
