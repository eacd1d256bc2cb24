#!/bin/bash
# Draws a sequence by several processes of this machine, or of others by ssh (GNU parallel).
#   farm/sequence_parallel.sh 8 model.obj --turntable 240 -o out/turn.%04d.png
# The first argument is how many shares there are; the others go to `lineatlas draw`. Options of
# parallel stand in PARALLEL, e.g. PARALLEL="--jobs 4 --retries 3 --sshloginfile nodes".
set -eu

shares=$1
shift
seq 0 $((shares - 1)) |
    parallel --halt soon,fail=1 --joblog lineatlas.joblog \
        "${LINEATLAS:-lineatlas}" draw "${@@Q}" --resume --frames "{}-x$shares"
