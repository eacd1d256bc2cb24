#!/usr/bin/env bash
# ./run farm-test: a real Slurm on this machine draws a sequence as an array of 8 tasks. One task is
# killed in the middle and requeued. In the end all frames must equal those of one process, byte by
# byte. The same is tried with two processes at the same time, and with GNU parallel, which is killed
# and started again.
set -euo pipefail

tool=$PWD/build/release/lineatlas
jobs=$PWD/farm
frames=40
sequence=(--scene house --size 320x240 --turntable "$frames")
folder=$(mktemp -d)
pids=()

stop() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$folder"
}
trap stop EXIT
fail() {
    echo "farm-test: $*" >&2
    tail -n 20 "$folder"/*.log >&2 || true
    exit 1
}
wait_for() { # SECONDS WHAT COMMAND...
    local left=$(($1 * 5)) what=$2
    shift 2
    until "$@" >/dev/null 2>&1; do
        ((left-- > 0)) || fail "waited in vain for $what"
        sleep 0.2
    done
}

start_slurm() {
    local host
    host=$(hostname -s)
    mkdir -p "$folder"/{state,spool,run}
    chmod 700 "$folder/run"
    dd if=/dev/urandom of="$folder/munge.key" bs=128 count=1 status=none
    chmod 400 "$folder/munge.key"
    munged --force --foreground --socket="$folder/munge.socket" --key-file="$folder/munge.key" \
        --pid-file="$folder/run/munged.pid" --seed-file="$folder/run/seed" \
        >"$folder/munged.log" 2>&1 &
    pids+=($!)
    wait_for 10 munged test -S "$folder/munge.socket"
    cat >"$folder/slurm.conf" <<CONF
ClusterName=farmtest
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
JobRequeue=1
MinJobAge=3600
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=farm Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
CONF
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -D >"$folder/slurmctld.log" 2>&1 &
    pids+=($!)
    wait_for 30 slurmctld scontrol ping
    slurmd -D >"$folder/slurmd.log" 2>&1 &
    pids+=($!)
    wait_for 30 "an idle node" bash -c "sinfo -h -o %t | grep -q idle"
}

task_state() { squeue -h -t all -r -j "$1" -o %T 2>/dev/null; }
frames_there() { find "$1" -name 'turn.*.png' | wc -l; }
at_least() { (($(frames_there "$1") >= $2)); }
same() { # FOLDER NAME
    diff -rq "$folder/alone" "$1" >/dev/null || fail "$2: not the frames of one process"
    echo "farm-test: $2: all $frames frames are there and equal those of one process"
}

mkdir "$folder/alone" "$folder/slurm" "$folder/parallel" "$folder/twice"
"$tool" draw "${sequence[@]}" -o "$folder/alone/turn.%04d.png"
[ "$(frames_there "$folder/alone")" = "$frames" ] || fail "one process left frames out"

start_slurm
export LINEATLAS=$tool
cd "$folder"
job=$(sbatch --parsable "$jobs/sequence.sbatch" "${sequence[@]}" -o "$folder/slurm/turn.%04d.png")
wait_for 120 "the first frames" at_least "$folder/slurm" 4
# Kills one task in the middle of a frame and requeues it, as an operator would.
victim=$(squeue -h -r -t RUNNING -j "$job" -o %i | head -n 1)
[ -n "$victim" ] || fail "no task runs that could be killed"
scontrol requeue "$victim" || fail "$victim could not be requeued"
echo "farm-test: task $victim was killed and requeued at frame $(frames_there "$folder/slurm")"
wait_for 600 "the end of the array" bash -c "! squeue -h -j $job | grep -q ."
grep -q "were there already" "lineatlas.${job}.${victim#*_}.log" ||
    fail "the requeued task did not go on where it was"
bad=$(task_state "$job" | grep -vc COMPLETED || true)
[ "$bad" = 0 ] || fail "$bad tasks did not complete"
same "$folder/slurm" "Slurm, 8 tasks, one requeued"

# Two processes do the same work in the same folder at the same time.
"$tool" draw "${sequence[@]}" -o "$folder/twice/turn.%04d.png" --resume 2>/dev/null &
first=$!
"$tool" draw "${sequence[@]}" -o "$folder/twice/turn.%04d.png" --resume 2>/dev/null
wait "$first"
same "$folder/twice" "two processes with the same frames"

# GNU parallel: all its processes are killed and started again.
PARALLEL="--jobs 2" setsid "$jobs/sequence_parallel.sh" 8 "${sequence[@]}" \
    -o "$folder/parallel/turn.%04d.png" 2>/dev/null &
group=$!
wait_for 120 "the first frames of parallel" at_least "$folder/parallel" 4
kill -KILL -- "-$group"
wait "$group" 2>/dev/null || true
pkill -KILL -f "$folder/parallel/" || true
echo "farm-test: parallel was killed at frame $(frames_there "$folder/parallel")"
PARALLEL="--jobs 2" "$jobs/sequence_parallel.sh" 8 "${sequence[@]}" \
    -o "$folder/parallel/turn.%04d.png" 2>/dev/null
find "$folder/parallel" -name '.lineatlas-*.part' -delete # left by killed processes
same "$folder/parallel" "GNU parallel, killed and started again"
