#!/usr/bin/env bash
# Draws every style and every effect into build/gallery, with a sheet of each, and the small pictures of
# docs/gallery.md into docs/gallery. ./run gallery [SHEET...] calls this script; without names it draws
# all sheets.
set -euo pipefail
cd "$(dirname "$0")/.."

out=build/gallery
scenes=(clevis house ship office)
styles=(technical ink pencil charcoal blueprint haloed)

# The drawings: a sheet, the picture's name in it, and the options of `lineatlas draw`. "chart" is a model of
# two lines, a wave and a zigzag.
effects='
overshoot  none          --scene house --width 1.3
overshoot  overshoot     --scene house --width 1.3 --overshoot 7
overshoot  varied        --scene house --width 1.3 --overshoot 12 --overshoot-variation 1
overshoot  undershoot    --scene house --width 1.3 --undershoot 6
halo       without       --scene ship --width 1.3
halo       with          --scene ship --width 1.3 --halo 5
halo       hidden        --scene clevis --hidden --hidden-pen solid
halo       hidden-halo   --scene clevis --hidden --hidden-pen solid --halo 8
filter     none          --scene office --at 0.6
filter     fill-holes    --scene office --at 0.6 --fill-holes 16
filter     drop-runs     --scene office --at 0.6 --drop-runs 16
filter     both          --scene office --at 0.6 --fill-holes 16 --drop-runs 16
density    none          --scene ship --width 1.3 --density 0
density    limited       --scene ship --width 1.3 --density 0.12
density    office        --scene office --at 0.6 --density 0
density    office-limited --scene office --at 0.6 --density 0.08
hidden     without       --scene clevis
hidden     dashed        --scene clevis --hidden
hidden     dotted        --scene clevis --hidden --hidden-pen dotted
hidden     house         --scene house --hidden --hidden-pen solid --hidden-width 0.7 --hidden-color silver
focus      without       --scene house --hidden
focus      window        --scene house --hidden --focus 0.4,0.55
focus      scene         --scene house --hidden --focus 0,4,0 --focus-radius 0.15 --focus-falloff 0.1
focus      pen           --scene house --width 3 --focus 0.4,0.55 --focus-pen pencil --focus-width 1 --focus-opacity 0.6
caps       butt          chart --width 16 --path-cap butt
caps       round         chart --width 16 --path-cap round
caps       taper         chart --width 16 --path-cap taper --cap-length 80
caps       texture       chart --width 16 --path-cap texture --cap-length 80 --pen brush
joins      mitre         chart --width 16 --join mitre
joins      round         chart --width 16 --join round
joins      bevel         chart --width 16 --join bevel
profiles   swell         chart --width 12 --path-cap butt --width-profile 0.1,1,1.6,1,0.1
profiles   decay         chart --width 12 --path-cap butt --width-profile 1.6,0.2
profiles   opacity       chart --width 12 --path-cap butt --opacity-profile 1,0.1
pens       solid         chart --width 14 --pen solid
pens       fine          chart --width 14 --pen fine
pens       pencil        chart --width 14 --pen pencil
pens       charcoal      chart --width 14 --pen charcoal
pens       brush         chart --width 14 --pen brush
pens       dashed        chart --width 6 --pen dashed
pens       dotted        chart --width 8 --pen dotted
fill       none          --scene house
fill       flat          --scene house --fill flat
fill       lambert       --scene house --fill lambert
fill       toon          --scene house --fill toon --toon-steps 4
paper      none          --scene clevis --width 5 --pen charcoal --paper #ece4d6
paper      quarter       --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 0.25
paper      half          --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 0.5
paper      full          --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 1
'

# The pictures of docs/gallery.md: name, columns, the part of each drawing that is shown, the drawings.
shown='
technical  1  1024x768+0+0    technical/clevis
ink        1  1024x768+0+0    ink/house
pencil     1  1024x768+0+0    pencil/house
charcoal   1  1024x768+0+0    charcoal/ship
blueprint  1  1024x768+0+0    blueprint/office
haloed     1  1024x768+0+0    haloed/ship
overshoot  2  480x400+460+290 overshoot/none overshoot/overshoot
halo       2  480x400+260+90  halo/hidden halo/hidden-halo
density    2  480x400+120+220 density/none density/limited
hidden     2  480x400+260+90  hidden/dashed focus/window
fill       2  480x400+480+60  fill/lambert fill/toon
strokes    1  960x80+0+0      pens/fine pens/pencil pens/charcoal pens/brush pens/dotted caps/taper joins/bevel profiles/swell
'

# Writes the two lines of "chart" as an OBJ file.
chart() {
    awk 'BEGIN {
        for (i = 0; i <= 60; i++) printf "v %g %g 0\n", 0.15 * i, 0.45 * sin(i * 3.1416 / 20)
        for (i = 0; i <= 6; i++) printf "v %g %g 0\n", 10 + 1.1 * i, i % 2 ? 0.3 : -0.3
        printf "l"; for (i = 1; i <= 61; i++) printf " %d", i
        printf "\nl"; for (i = 62; i <= 68; i++) printf " %d", i
        print ""
    }'
}
in_chart="$out/chart.obj --size 960x80 --eye 8.3,0,40 --target 8.3,0,0 --fov 2.1"

draw() { # SHEET NAME OPTIONS...
    mkdir -p "$out/$1"
    echo "$1/$2"
    LINEATLAS_STYLE_DIR=styles build/release/lineatlas draw "${@:3}" -o "$out/$1/$2.png" >/dev/null
}

wanted() { ((${#only[@]} == 0)) || [[ " ${only[*]} " == *" $1 "* ]]; }

only=("$@")
mkdir -p "$out" docs/gallery
chart >"$out/chart.obj"
declare -A sheets=()
for style in "${styles[@]}"; do
    wanted "$style" || continue
    for scene in "${scenes[@]}"; do
        draw "$style" "$scene" --scene "$scene" --style "$style"
        sheets[$style]+=" $out/$style/$scene.png"
    done
done
while read -r sheet name options; do
    if [ -z "$sheet" ] || ! wanted "$sheet"; then continue; fi
    read -ra words <<<"${options/#chart/$in_chart}"
    draw "$sheet" "$name" "${words[@]}"
    sheets[$sheet]+=" $out/$sheet/$name.png"
done <<<"$effects"
for sheet in "${!sheets[@]}"; do
    read -ra pictures <<<"${sheets[$sheet]}"
    columns=2
    if [[ " caps joins profiles pens " == *" $sheet "* ]]; then columns=1; fi
    rows=$(((${#pictures[@]} + columns - 1) / columns))
    oiiotool "${pictures[@]}" --mosaic "${columns}x$rows" -o "$out/$sheet.png"
done
((${#only[@]} == 0)) || exit 0
while read -r name columns part pictures; do
    [ -n "$name" ] || continue
    words=()
    for picture in $pictures; do words+=("$out/$picture.png" --cut "$part"); done
    read -ra drawings <<<"$pictures"
    oiiotool "${words[@]}" --mosaic "${columns}x$((${#drawings[@]} / columns))" --resize 480x0 --ch R,G,B \
        --compression jpeg:80 -o "docs/gallery/$name.jpg"
done <<<"$shown"
echo "Sheets: $out/*.png"
