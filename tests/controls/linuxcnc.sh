#!/bin/sh
# LinuxCNC's interpreter and kinematics modules, unpacked under DIR; nothing is installed on the machine.
# usage: sh tests/controls/linuxcnc.sh DIR     (Debian 12 or Ubuntu 24.04 with apt; 6 MB)
set -e
mkdir -p "$1"
cd "$1"
[ -x root/usr/bin/rs274 ] && exit 0
boost=$(apt-cache depends linuxcnc-uspace | sed -n 's/.*Depends: \(libboost-python[0-9.]*\).*/\1/p' | head -1)
[ -n "$boost" ] || { echo "this system's apt has no linuxcnc-uspace: Debian 12 and Ubuntu 24.04 have" >&2; exit 1; }
apt-get download -q linuxcnc-uspace "$boost"
for d in *.deb; do dpkg -x "$d" root; done
