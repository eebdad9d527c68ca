#!/usr/bin/env bash
# The floors of the library: a header includes what lies in its own folder and in those before it, and no folder has more
# than twelve headers. Prints what breaks this.
set -euo pipefail
cd "$(dirname "$0")/.."

# root: its folders from the ground up; `.` is what lies in the root itself, which most people include, but for a header of
# its own name, an umbrella over floors above. `<` names the root below.
floors='
include     : base mesh mask level association step field .
schemes     < include : split crease kernel nasri_hasbini . limit_rules limit schemes.hpp
distributed < include : part number tile output mpi ranks slices .
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
    below=()
    case $rest in '<'*) read -r _ lower _ <<<"$rest" && below=("$lower") ;; esac
    allowed=()
    for folder in ${below[@]+$(folders_of "${below[0]}")}; do
        allowed+=("${below[0]}/kith/$folder")
    done
    for folder in $(folders_of "$root"); do
        if [[ $folder == *.hpp ]]; then
            headers=("$root/kith/$folder")
        else
            allowed+=("$root/kith/$folder")
            headers=("$root/kith/$folder"/*.hpp)
        fi
        [ "$folder" = . ] || [ ${#headers[@]} -le 12 ] || complain "$root/kith/$folder has ${#headers[@]} headers, more than twelve"
        for header in "${headers[@]}"; do
            [ "$folder" != . ] || [[ " $(folders_of "$root") " != *" ${header##*/} "* ]] || continue
            while read -r name; do
                found=
                for place in "${allowed[@]}"; do
                    case $name in
                    */*) [ -f "${place%%/*}/kith/$name" ] && [ "${place#*/kith/}" = "${name%/*}" ] && found=1 ;;
                    *) [ "${place#*/kith/}" = . ] && [ -f "$place/$name" ] && found=1 ;;
                    esac
                done
                [ -n "$found" ] || complain "$header includes <kith/$name>, which is not below it"
            done < <(sed -n 's|^#include <kith/\(.*\)>.*|\1|p' "$header")
        done
    done
    for folder in "$root"/kith/*/; do
        folder=$(basename "$folder")
        [[ " $(folders_of "$root") " == *" $folder "* ]] || complain "$root/kith/$folder has no floor; see tools/floors.sh"
    done
done <<<"$floors"
exit $status
