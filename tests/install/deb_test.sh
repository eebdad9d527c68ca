#!/usr/bin/env bash
# deb_test.sh BUILD WORK PROJECT: makes the Debian packages, installs them into a root of their own, builds and runs a project
# with what is there, removes them again and looks whether anything is left.
set -euo pipefail
build=$1 work=$2 project=$3
rm -rf "$work"
mkdir -p "$work/root/var/lib/dpkg/"{info,updates}
touch "$work/root/var/lib/dpkg/status"
package() { dpkg --log="$work/log" --force-not-root --force-depends --root="$work/root" "$@" 2>"$work/warnings"; }

cpack --config "$build/CPackConfig.cmake" -G DEB -B "$work" >"$work/cpack.log"
package -i "$work"/*.deb >/dev/null || { cat "$work/warnings" && exit 1; }
[ ! -e "$work"/kith_*.deb ] || "$work/root/usr/bin/kith" --version

cmake -S "$project" -B "$work/app" -D CMAKE_PREFIX_PATH="$work/root/usr" -D COMPONENTS="schemes;io" >"$work/configure.log"
cmake --build "$work/app"
"$work/app/app"

package -r libkith-dev $([ ! -e "$work"/kith_*.deb ] || echo kith) >/dev/null || { cat "$work/warnings" && exit 1; }
left=$(find "$work/root/usr" -type f 2>/dev/null || true)
[ -z "$left" ] || { echo "left behind: $left" && exit 1; }
