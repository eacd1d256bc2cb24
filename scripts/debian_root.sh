# Sourced: a Debian in a folder, and commands in it. Needs root, mmdebstrap and a mirror.
# shellcheck shell=bash
mirror=${LINEATLAS_DEBIAN_MIRROR:-http://deb.debian.org/debian}
[ "$(id -u)" = 0 ] || { echo "making a root folder and entering it needs root" >&2; exit 1; }

# The smallest there is. Mirrors that keep a day's state (snapshot.debian.org) are old by their dates.
make_debian() { # SUITE TARGET (a folder, or a .tar)
    mmdebstrap --variant=minbase --mode=root --aptopt='Acquire::Check-Valid-Until "false"' \
        "$1" "$2" "$mirror"
}

# /proc for processes that start themselves anew, /sys for PoCL. Mounts go with the last process.
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
