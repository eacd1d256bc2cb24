#!/usr/bin/env bash
# Plants a wrong formula in every stage, in a copy of kernels/, and runs the tests with known answers on
# it:   planted_formulas.sh FOLDER [STAGE...]     FOLDER has the built tests. Without STAGE all stages.
# Prints the test that fails for each. Ends with 1 if the tests of a stage all pass.
set -euo pipefail
tests=$(realpath "$1")
shift
stages=" $* "
cd "$(dirname "$0")/.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LINEATLAS_KERNEL_DIR=$work/kernels
missed=0

plant() { # STAGE FILE FROM TO PROGRAM FILTER: with FROM replaced by TO in FILE a test fails
    [[ $stages == "  " || $stages == *" $1 "* ]] || return 0
    rm -rf "$LINEATLAS_KERNEL_DIR"
    cp -r kernels "$LINEATLAS_KERNEL_DIR"
    grep -qF -- "$3" "kernels/$2" || { echo "$2 does not hold: $3"; exit 1; }
    FROM=$3 TO=$4 perl -0pi -e 's/\Q$ENV{FROM}\E/$ENV{TO}/' "$LINEATLAS_KERNEL_DIR/$2"
    local seen
    if ("$tests/$5" --gtest_filter="$6") >"$work/output" 2>&1; then
        echo "$1: NOT SEEN, $3 -> $4"
        missed=1
        return
    fi
    seen=$(sed -nE 's/^\[  FAILED  \] ([^ ,]*).* \([0-9]+ ms\)$/\1/p' "$work/output" | sort -u)
    # A test that ends the program has no verdict.
    [ -n "$seen" ] || seen=$(sed -nE 's/^\[ RUN      \] (.*)$/\1/p' "$work/output" | tail -1)
    if [ -z "$seen" ]; then
        tail -5 "$work/output"
        exit 1
    fi
    echo "$1: $3 -> $4: $(wc -l <<<"$seen") tests, $(head -1 <<<"$seen" | sed -E 's|^OnDevice/||; s|/.*||')"
}
stage() { plant "$1" "$2" "$3" "$4" compute_test "$5*Portable*"; }
exact() { plant "$1" "$2" "$3" "$4" exact_test "*ExactTest*Portable*"; }

stage transform transform.cl "moved(m + 8, v)" "moved(m + 4, v)" "*TransformStage."
stage depth depth_triangle.h "view.half_size - 0.5f" "view.half_size" "*DepthStage."
stage planes planes.cl "dot_of(n, way_to(m.y, a))" "dot_of(n, way_to(m.x, a))" "*PlanesStage."
stage pyramid pyramid.cl "row_farthest = fmax(" "row_farthest = fmin(" "*PyramidStage."
stage cull cull.cl "box.low.z * 0.5f" "box.high.z * 0.5f" "*CullStage."
stage facing facing.cl "? 1 : 0;" "? 0 : 1;" "*FacingStage."
stage contour contour.cl "at_a / (at_a - at_b)" "0.5f" "*ContourStage."
stage silhouette shared/silhouette.h "[face_b & LA_FACE_INDEX] ^ flipped" "[face_b & LA_FACE_INDEX]" "*SilhouetteStage."
stage chain chain.cl "segment.from_start = place.before;" "segment.from_start = place.after;" "*ChainStage."
stage project_clip project_clip.cl "ceil(length_px / args.step)" "ceil(length_px)" "*ProjectClipStage."
stage scan scan.cl "sum += (v0 + v1) + (v2 + v3)" "sum += (v0 + v1) + v2" "*Scan."
stage atlas shared/spine.h "side_texels * -spine.along.y" "side_texels * spine.along.y" "*AtlasStage."
stage temporal temporal.cl "u * wp / (u * wp + (1.0f - u) * wq)" "u" "*TemporalStage."
stage intervals intervals.cl "if (shown_at(line, middle, depth) == shown)" "if (shown_at(line, middle, depth) != shown)" "*IntervalsStage."
stage compact compact.cl "(float)end + 0.5f" "(float)end" "*CompactStage."
stage halo halo.cl "fmin(1.0f / crossing.sine" "fmin(crossing.sine" "*HaloStage."
stage filter filter.cl "gap < filter.fill_holes)" "gap < 2.0f * filter.fill_holes)" "*FilterStage."
stage density density.cl "3u * row[at * stride]" "2u * row[at * stride]" "*DensityStage."
stage fill fill.cl "dot_of(n, to_eye) < none" "seen.z < none" "*FillStage."
exact surfaces surfaces.cl "enclose(&face, xy(c));" "enclose(&face, xy(b));"
exact tile_lists tile_lists.cl "(count + LA_GROUP - 1u) / LA_GROUP" "count / LA_GROUP"
exact visible visible.cl "fmin(high, root)" "fmax(high, root)"
exact spans spans.cl "const bool visible = n % 2u != 0;" "const bool visible = n % 2u == 0;"
export LINEATLAS_DEVICE=opencl:Portable
plant outline outline.cl "side == 0 ? inside : -inside" "side == 0 ? -inside : inside" outlines_test "Outlines.*"
plant pens pens.cl "const float u = (from - run->start_sample) * scale;" "const float u = 0.0f;" outlines_test "Pens.*"
exit $missed
