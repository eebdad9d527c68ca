#!/usr/bin/env bash
# The floors of the library: a header includes what lies in its own folder and in those before it, and no folder has more
# than twelve headers, but for the one that has a file per scheme. Prints what breaks this.
set -euo pipefail
cd "$(dirname "$0")/.."

# root: its folders from the ground up; `.` is what lies in the root itself, which most people include, but for headers that
# are named, which lie above it or know what does. `<` names the roots below.
floors='
include     : core/base core/mesh core/repair core/mask core/level core/query fields/property numbering/association numbering/step engine/lane engine/neighbourhood engine/strategy engine/patch engine fields/rules fields hierarchy .
schemes     < include : schemes/compiled schemes/split schemes/kernel schemes/crease schemes/seam schemes/nasri_hasbini schemes/selected . presets.hpp compiled_schemes.hpp limits/rules limits surface/spline surface/shape surface surface/tessellation surface.hpp surface/search limits.hpp closest_points.hpp ray_hits.hpp schemes.hpp
distributed < include schemes : tiles/part tiles/number tiles/refine tiles/ply tiles/output mpi mpi/ranks mpi/slices .
adapters    < include schemes : . in_place cgal openmesh cgal_subdivision.hpp openmesh_subdivision.hpp
io          < include schemes distributed : io/text io/format .
picture     < include : picture .
'

status=0
complain() {
    echo "$1"
    status=1
}

# folders_of ROOT: what stands after the colon.
folders_of() { sed -n "s/^$1 .*: //p" <<<"$floors"; }

while read -r root rest; do
    [ -n "$root" ] || continue
    folders=" $(folders_of "$root") "
    allowed=()
    for lower in $(sed -n 's/^< \(.*\) : .*/\1/p' <<<"$rest"); do
        for folder in $(folders_of "$lower"); do
            allowed+=("$lower/kith/$folder")
        done
    done
    above=$folders # what is on no floor so far
    for folder in $folders; do
        above=${above/ $folder / }
        headers=()
        if [[ $folder == *.hpp ]]; then
            headers=("$root/kith/$folder")
        else
            allowed+=("$root/kith/$folder")
            for header in "$root/kith/$folder"/*.hpp; do
                [[ $folder == . && $folders == *" ${header##*/} "* ]] || headers+=("$header")
            done
        fi
        [ "$root/$folder" = schemes/. ] || [ ${#headers[@]} -le 12 ] ||
            complain "$root/kith/$folder has ${#headers[@]} headers, more than twelve"
        for header in "${headers[@]}"; do
            while read -r name; do
                found=
                for place in "${allowed[@]}"; do
                    case $name in
                    */*) [ -f "${place%%/*}/kith/$name" ] && [ "${place#*/kith/}" = "${name%/*}" ] && found=1 ;;
                    *) [ "${place#*/kith/}" = . ] && [ -f "$place/$name" ] && [[ $above != *" $name "* ]] && found=1 ;;
                    esac
                done
                [ -n "$found" ] || complain "$header includes <kith/$name>, which is not below it"
            done < <(sed -n 's|^#include <kith/\(.*\)>.*|\1|p' "$header")
            while read -r name; do
                [ -f "${header%/*}/$name" ] && [[ $name != */* && $above != *" $name "* ]] ||
                    complain "$header includes \"$name\", which is not in its folder or not below it"
            done < <(sed -n 's|^#include "\(.*\)".*|\1|p' "$header")
        done
    done
    while read -r folder; do
        [[ $folders == *" $folder "* ]] || complain "$root/kith/$folder has no floor; see tools/floors.sh"
    done < <(find "$root/kith" -mindepth 2 -name '*.hpp' -printf '%P\n' | sed 's|/[^/]*$||' | sort -u)
done <<<"$floors"
exit $status
