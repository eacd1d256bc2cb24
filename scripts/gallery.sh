#!/usr/bin/env bash
# Draws every style and every effect into build/gallery, with a sheet of each, and the small pictures of
# docs/gallery.md into docs/gallery. ./run gallery [SHEET...] calls this; without names it draws all.
set -euo pipefail
cd "$(dirname "$0")/.."

out=build/gallery
scenes=(clevis house ship office)
styles=(technical ink pencil charcoal blueprint haloed)

# What is drawn: a sheet, the picture's name in it, and the options of `lineatlas draw`.
effects='
overshoot  none          --scene house
overshoot  overshoot     --scene house --overshoot 12
overshoot  varied        --scene house --overshoot 18 --overshoot-variation 1
overshoot  undershoot    --scene house --undershoot 6
halo       without       --scene ship
halo       with          --scene ship --halo 5
halo       hidden        --scene clevis --hidden --hidden-pen solid
halo       hidden-halo   --scene clevis --hidden --hidden-pen solid --halo 8
filter     none          --scene office --at 0.6
filter     fill-holes    --scene office --at 0.6 --fill-holes 16
filter     drop-runs     --scene office --at 0.6 --drop-runs 16
filter     both          --scene office --at 0.6 --fill-holes 16 --drop-runs 16
density    none          --scene ship
density    limited       --scene ship --density 0.12
density    office        --scene office --at 0.6
density    office-limited --scene office --at 0.6 --density 0.08
hidden     without       --scene clevis
hidden     dashed        --scene clevis --hidden
hidden     dotted        --scene clevis --hidden --hidden-pen dotted
hidden     house         --scene house --hidden --hidden-pen solid --hidden-width 0.7 --hidden-color silver
focus      without       --scene house --hidden
focus      window        --scene house --hidden --focus 0.4,0.55
focus      scene         --scene house --hidden --focus 0,4,0 --focus-radius 0.15 --focus-falloff 0.1
focus      pen           --scene house --width 3 --focus 0.4,0.55 --focus-pen pencil --focus-width 1 --focus-opacity 0.6
caps       butt          --scene clevis --width 12 --cap butt --path-cap butt
caps       round         --scene clevis --width 12 --cap round --path-cap round
caps       taper         --scene clevis --width 12 --cap taper --path-cap taper --cap-length 60
caps       texture       --scene clevis --width 12 --cap texture --path-cap texture --cap-length 60 --pen brush
joins      mitre         --scene clevis --width 12 --join mitre
joins      round         --scene clevis --width 12 --join round
joins      bevel         --scene clevis --width 12 --join bevel
joins      mitre-limit   --scene clevis --width 12 --join mitre --mitre-limit 1
profiles   none          --scene clevis --width 6
profiles   swell         --scene clevis --width 6 --width-profile 0.2,1,1.6,1,0.2
profiles   decay         --scene clevis --width 6 --width-profile 1.6,0.3
profiles   opacity       --scene clevis --width 6 --opacity-profile 1,0.1
pens       solid         --scene clevis --width 8 --pen solid
pens       fine          --scene clevis --width 8 --pen fine
pens       pencil        --scene clevis --width 8 --pen pencil
pens       charcoal      --scene clevis --width 8 --pen charcoal
pens       brush         --scene clevis --width 8 --pen brush
pens       dashed        --scene clevis --width 3 --pen dashed
pens       dotted        --scene clevis --width 4 --pen dotted
fill       none          --scene house
fill       flat          --scene house --fill flat
fill       lambert       --scene house --fill lambert
fill       toon          --scene house --fill toon --toon-steps 4
paper      none          --scene clevis --width 5 --pen charcoal --paper #ece4d6
paper      quarter       --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 0.25
paper      half          --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 0.5
paper      full          --scene clevis --width 5 --pen charcoal --paper #ece4d6 --paper-grain 1
'

# The pictures of docs/gallery.md: a drawing and the part of it that is shown, WIDTHxHEIGHT+X+Y.
shown='
'

draw() { # SHEET NAME OPTIONS...
    mkdir -p "$out/$1"
    echo "$1/$2"
    LINEATLAS_STYLE_DIR=styles build/release/lineatlas draw "${@:3}" -o "$out/$1/$2.png" >/dev/null
}

wanted() { ((${#only[@]} == 0)) || [[ " ${only[*]} " == *" $1 "* ]]; }

only=("$@")
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
    read -ra words <<<"$options"
    draw "$sheet" "$name" "${words[@]}"
    sheets[$sheet]+=" $out/$sheet/$name.png"
done <<<"$effects"
for sheet in "${!sheets[@]}"; do
    read -ra pictures <<<"${sheets[$sheet]}"
    oiiotool "${pictures[@]}" --mosaic:pad=8 "2x$(((${#pictures[@]} + 1) / 2))" --resize 50% -o "$out/$sheet.png"
done
while read -r picture part; do
    if [ -z "$picture" ] || ! wanted "${picture%/*}"; then continue; fi
    oiiotool "$out/$picture.png" --cut "$part" --resize 480x0 --ch R,G,B \
        --compression jpeg:80 -o "docs/gallery/${picture/\//-}.jpg"
done <<<"$shown"
echo "Sheets: $out/*.png"
