#!/bin/sh
# Runs a command in a root as on a machine of its own: without a display, a terminal or a GPU, but with all that a
# running system mounts.
#   unshare --mount --pid --fork --kill-child=KILL -- enter_root.sh ROOT PACKAGES FOLDER NAME=VALUE... COMMAND...
# PACKAGES: where downloaded packages are kept; FOLDER: where the command starts. Everything is mounted in namespaces
# that end with the command, so that no mount and no process outlives it, however it ends.
set -eu
root=$1 packages=$2 folder=$3
shift 3

mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
mount -t tmpfs -o nosuid,mode=0755 tmpfs "$root/dev"
for node in null zero full random urandom tty; do
  : >"$root/dev/$node"
  mount --bind "/dev/$node" "$root/dev/$node"
done
mkdir "$root/dev/pts" "$root/dev/shm"
mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$root/dev/pts"
mount -t tmpfs -o nosuid,nodev,mode=1777 tmpfs "$root/dev/shm"
ln -s pts/ptmx "$root/dev/ptmx"
ln -s /proc/self/fd "$root/dev/fd"
for stream in 0:stdin 1:stdout 2:stderr; do
  ln -s "/proc/self/fd/${stream%:*}" "$root/dev/${stream#*:}"
done
mount --bind "$packages" "$root/var/cache/apt/archives"

# Not exec: this shell is process 1 here, and takes the ends of orphans.
status=0
chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
  LANG=C.UTF-8 TERM=dumb \
  sh -c 'cd "$0" && exec env "$@"' "$folder" "$@" || status=$?
exit "$status"
