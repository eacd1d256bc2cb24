# Functions that install a Debian in a folder and run commands in it. Needs root, mmdebstrap and a mirror.
# shellcheck shell=bash
mirror=${LINEATLAS_DEBIAN_MIRROR:-http://deb.debian.org/debian}
[ "$(id -u)" = 0 ] || { echo "making a root folder and entering it needs root" >&2; exit 1; }

# Installs a minimal Debian. Expired dates are allowed, because mirrors of past days (snapshot.debian.org) have them.
make_debian() { # SUITE TARGET (a folder, or a .tar)
    mmdebstrap --variant=minbase --mode=root --aptopt='Acquire::Check-Valid-Until "false"' \
        "$1" "$2" "$mirror"
}

# Runs a command in a root folder. Processes that start themselves again need /proc, PoCL needs /sys. The mounts end with the
# last process.
enter() { # ROOT COMMAND...
    # shellcheck disable=SC2016 # the inner shell's
    unshare --mount --pid --fork sh -ec 'root=$0
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
for device in null zero full random urandom; do touch "$root/dev/$device"; mount --bind "/dev/$device" "$root/dev/$device"; done
mkdir -p "$root/dev/shm"
mount -t tmpfs tmpfs "$root/dev/shm"
exec chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"' \
        "$@"
}
