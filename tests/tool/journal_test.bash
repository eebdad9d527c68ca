# SPDX-License-Identifier: BSD-3-Clause
# A refinement that is interrupted goes on from its journal, and gives the bytes of one that was not.
source "$(dirname "$0")/check.bash"
cube >cube.off
run refine cube.off -s catmull-clark -n 4 -o whole.vtu --tiles 6
exits 0
run refine cube.off -s catmull-clark -n 4 -o whole.ply --tiles 6
exits 0

# In pieces, in any order, some tiles twice; the last call finishes.
run refine cube.off -s catmull-clark -n 4 -o out.vtu --tiles 6 --journal kept --only 2..3
exits 0
says_nothing
prints '^kept: 2 of 6 tiles are finished$'
leaves cube.off kept whole.ply whole.vtu
run refine --journal kept --only 5
exits 0
prints '^kept: 3 of 6 tiles are finished$'
run refine --journal kept --only 3..5 --json
exits 0
prints '"tiles":6,"finished_tiles":4,"levels":4,.*"output":"kept"'
# Another number of tiles is another way to the same surface: the tiles are those of the journal.
run refine cube.off -s catmull-clark -n 4 -o out.vtu --tiles 4 --journal kept
exits 0
prints '^out.vtu: 1538 vertices, 3072 edges, 1536 faces, checksum [0-9a-f]+$'
same whole.vtu out.vtu
leaves cube.off out.vtu whole.ply whole.vtu

rm out.vtu

# What is finished is not refined again. Its bytes are read before the surface gets its name: one that has changed, here
# in places, faces and the last byte, is found, and nothing appears under the name of the output.
change() { # change FILE OFFSET: another byte there
    printf "\\x$(printf '%02x' $(($(od -An -tu1 -j"$2" -N1 "$1") ^ 0x55)))" |
        dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
written_from() { # written_from FILE WHOLE OFFSET: the first byte from there on that is finished
    {
        cmp -l "$1" "$2" 2>/dev/null | awk '{ print "differs", $1 - 1 }'
        od -An -v -tu1 -w1 -j"$3" "$2" | awk -v at="$3" '{ print "has", at++, $1 }'
    } | awk '$1 == "differs" { differs[$2] } $1 == "has" && $3 != 0 && !($2 in differs) { print $2; exit }'
}
damage='is damaged, its bytes differ from those that were written; run again with --verify, which rewrites damaged tiles'
size=$(stat -c %s whole.ply)
for from in 302 20000 $((size - 17 * 1400)) $((size - 17 * 700)); do
    run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..4
    exits 0
    at=$(written_from kept/surface whole.ply "$from")
    change kept/surface "$at"
    cp kept/surface before
    run refine --journal kept
    exits 1
    prints_nothing
    says "^kith: kept/surface: $damage"
    leaves before cube.off kept whole.ply whole.vtu
    check "the changed byte is still there" cmp -s -i "$at" -n 1 before kept/surface
    run refine --journal kept # says so again
    exits 1
    run refine --journal kept --verify
    exits 0
    same whole.ply out.ply
    rm before out.ply
done
# What belongs to no tile is written again by every job.
run refine cube.off -s catmull-clark -n 4 -o out.vtu --tiles 6 --journal kept --only 0..4
for at in 2 $(($(stat -c %s whole.vtu) - 3)); do change kept/surface "$at"; done
run refine --journal kept
exits 0
same whole.vtu out.vtu
rm out.vtu
# Pieces: one that has changed, two that have changed places, one that is longer or shorter. One that is lost is written
# again.
run refine cube.off -s catmull-clark -n 3 -o whole.pvtu --tiles 3
for harm in 'change 1.vtu 3000' 'mv 0.vtu x; mv 1.vtu 0.vtu; mv x 1.vtu' 'truncate -s 100 1.vtu' 'truncate -s +1 1.vtu' 'rm 1.vtu'; do
    run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --journal kept --only 0..1
    pushd kept/surface.pieces >/dev/null
    eval "$harm"
    popd >/dev/null
    run refine --journal kept
    if [ "$harm" != 'rm 1.vtu' ]; then
        exits 1
        says "^kith: kept/surface: $damage"
        run refine --journal kept --verify
    fi
    exits 0
    check "the same pieces" diff -r whole.pieces out.pieces
    rm -r out.p*
done
rm -r whole.p*s whole.pvtu
# The recipe: every byte of it, that of the name of the output, too.
run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..4
cp kept/recipe recipe
at=$(grep -abo 'out.ply' recipe | head -n 1 | cut -d: -f1)
for at in 20 "$at" "$((at + 5))" $(($(stat -c %s recipe) / 2)) $(($(stat -c %s recipe) - 1)); do
    change kept/recipe "$at"
    run refine --journal kept
    exits 1
    says '^kith: kept/recipe: .*; remove kept and start again$'
    cp recipe kept/recipe
done
leaves cube.off kept recipe whole.ply whole.vtu
rm -r kept recipe

# With --verify the file is read, the tile named and written again.
run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..4
exits 0
printf '\x55' | dd of=kept/surface bs=1 seek=302 conv=notrunc status=none
run refine --journal kept --verify
exits 0
prints ', verified$'
says '^kith: note: tile [0-4] is damaged, byte 302 of kept/surface is wrong; the tile is written again$'
same whole.ply out.ply
rm out.ply
# Every byte of a finished tile that is another one is found, here in a face, by a job that refines another tile.
run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0
exits 0
at=$(($(stat -c %s whole.ply) - 17 * 1536))
written=$(cmp -l kept/surface whole.ply | awk -v at=$at '$1 > at { differ[$1] } END { for (i = at + 2;; ++i) if (!(i in differ)) { print i; exit } }')
run refine --journal kept --only 1 --verify
exits 0
says_nothing
prints '^kept: 2 of 6 tiles are finished, verified$'
printf '\x77' | dd of=kept/surface bs=1 seek=$((written - 1)) conv=notrunc status=none
run refine --journal kept --verify
exits 0
says "^kith: note: tile 0 is damaged, byte $((written - 1)) of kept/surface is wrong; the tile is written again$"
same whole.ply out.ply
rm out.ply
# A piece that was cut off.
run refine cube.off -s catmull-clark -n 3 -o whole.pvtu --tiles 3
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --journal kept --only 0..1
truncate -s 100 kept/surface.pieces/1.vtu
run refine --journal kept --verify
exits 0
says '^kith: note: tile 1 is damaged, the size of kept/surface.pieces/1.vtu is wrong; the tile is written again$'
check "the same pieces" diff -r whole.pieces out.pieces
rm -r out.p* whole.p*s whole.pvtu
# A tile that overflows is not finished; nothing appears under the name of the output.
sed '3,10s/1/1e308/g' cube.off >large.off
run refine large.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept
exits 1
says 'out.ply: vertex [0-9]+ would not have finite coordinates'
leaves cube.off kept large.off whole.ply whole.vtu
rm -r kept large.off

# Jobs at work in one journal at the same time all end well, and one of them gives the file its name.
command="three restarts of one journal"
run refine cube.off -s catmull-clark -n 7 -o whole7.vtu --tiles 12
for begun in yes no; do
    restart="refine cube.off -s catmull-clark -n 7 -o out.vtu --tiles 12 --journal kept"
    if [ $begun = yes ]; then
        # shellcheck disable=SC2086 # several words
        run $restart --only 0
        restart="refine --journal kept"
    fi
    jobs=()
    for i in 1 2 3; do
        # shellcheck disable=SC2086
        timeout 60 "$kith" $restart >"$results/out$i" 2>>"$results/err" &
        jobs+=($!)
    done
    for job in "${jobs[@]}"; do
        wait "$job"
        code=$?
        # One that began after the end of the others finds no journal.
        test $code -eq 1 && grep -q 'holds no recipe to resume' "$results/err" && continue
        exits 0
    done
    same whole7.vtu out.vtu
    check "the journal is gone" test ! -e kept
    rm out.vtu
done
rm whole7.vtu

# A record that was torn, at whatever byte, is none; the tile is refined once more, and others stay.
size=$(stat -c %s whole.ply)
for torn in 0 1 7 8 15 16 23 24 31; do
    run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..3
    exits 0
    # The record of tile 2, of 32 bytes, ends at this byte.
    dd if=/dev/zero of=kept/surface bs=1 seek=$((size + 2 * 32 + torn)) count=$((32 - torn)) conv=notrunc status=none
    run refine --journal kept --only 1
    prints '^kept: 3 of 6 tiles are finished$'
    run refine --journal kept
    exits 0
    same whole.ply out.ply
    rm out.ply
done
# A journal that was only begun, or whose surface is gone, is begun again.
run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..3
rm kept/surface
run refine --journal kept
exits 0
same whole.ply out.ply
rm out.ply

# A job that was killed, or found no way, when it cut the records off and had not named the surface: the records come back,
# so that finished tiles are not refined again.
cut_records() { # cut_records SIZE PLACE: what such a job leaves of `kept`
    tail -c +$(($1 + 1)) kept/surface >kept/surface.records
    test -z "$2" || printf '%s %s' "$(stat -c %i kept/surface.pieces)" "$2" >>kept/surface.records
    truncate -s "$1" kept/surface
}
run refine cube.off -s catmull-clark -n 4 -o out.ply --tiles 6 --journal kept --only 0..4
at=$(written_from kept/surface whole.ply 302)
change kept/surface "$at"
cut_records "$size" ""
run refine --journal kept --only 0
exits 0
prints '^kept: 5 of 6 tiles are finished$'
run refine --journal kept
exits 1
says "^kith: kept/surface: $damage"
change kept/surface "$at"
run refine --journal kept
exits 0
same whole.ply out.ply
leaves cube.off out.ply whole.ply whole.vtu
rm out.ply
# Pieces that have their place already, and an index that has not.
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --journal kept --only 0..1
change kept/surface.pieces/1.vtu 1500
cut_records $(($(stat -c %s kept/surface) - 3 * 32)) "$PWD/out.pieces"
mv kept/surface.pieces out.pieces
run refine --journal kept --only 0
exits 0
prints '^kept: 2 of 3 tiles are finished$'
leaves cube.off kept whole.ply whole.vtu
run refine --journal kept
exits 1
says "^kith: kept/surface: $damage"
change kept/surface.pieces/1.vtu 1500
run refine --journal kept
exits 0
leaves cube.off out.pieces out.pvtu whole.ply whole.vtu
rm -r out.*

# What another refinement has put there since is not taken for them.
run refine cube.off -s catmull-clark -n 3 -o whole.pvtu --tiles 3
exits 0
mv whole.pieces expected
rm whole.pvtu
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --journal kept --only 0..1
cut_records $(($(stat -c %s kept/surface) - 3 * 32)) "$PWD/out.pieces"
mv kept/surface.pieces out.pieces
run refine cube.off -s linear -n 3 -o out.pvtu --tiles 3
exits 0
run refine --journal kept --only 0
prints '^kept: 1 of 3 tiles are finished$'
check "the pieces of the other one are still there" test -e out.pieces/0.vtu
run refine --journal kept
exits 0
check "all pieces are those of a job that was not interrupted" diff -r expected out.pieces
rm -r out.* expected

# What cannot be named at the end is refused at the beginning. Who may write anywhere becomes somebody else for it.
privileged=$kith
if test "$(id -u)" -eq 0; then
    printf '#!/bin/sh\nexec setpriv --reuid=65534 --regid=65534 --clear-groups "%s" "$@"\n' "$kith" >"$results/kith"
    chmod 755 "$results/kith"
    chmod 777 .
    kith=$results/kith
fi
run --version
if test "$code" -eq 0; then
    mkdir closed
    chmod 555 closed
    run refine cube.off -s catmull-clark -n 3 -o closed/out.vtu --tiles 6 --journal kept --only 0..3
    exits 1
    says 'closed/out.vtu: cannot be written: Permission denied'
    chmod 777 closed
    run refine cube.off -s catmull-clark -n 3 -o closed/out.vtu --tiles 6 --journal kept --only 0..3
    exits 0
    chmod 555 closed
    run refine --journal kept
    exits 1
    says 'closed/out.vtu: cannot be written: Permission denied'
    chmod 777 closed
    run refine --journal kept --only 0..0
    prints '^kept: 4 of 6 tiles are finished$'
    rm -r kept closed
    # What is there and may not be replaced, as without a journal, the index and a directory of pieces, too.
    for output in out.vtu out.ply out.pvtu; do
        echo mine >$output
        chmod 444 $output
        run refine cube.off -s catmull-clark -n 1 -o $output --tiles 2 --journal kept
        exits 1
        says "$output: cannot be written: Permission denied"
        check "$output is untouched" test "$(cat $output)" = mine
        rm -f $output
    done
    mkdir out.pieces
    chmod 555 out.pieces
    for journal in "" "--journal kept"; do
        # shellcheck disable=SC2086 # two words
        run refine cube.off -s catmull-clark -n 1 -o out.pvtu --tiles 2 $journal
        exits 1
        says 'out.pieces: cannot be written: Permission denied'
    done
    rm -r out.pieces
    leaves cube.off whole.ply whole.vtu
fi
kith=$privileged

# An output in the directory of the journal keeps away from the files there.
for call in "" "--only 0"; do
    # shellcheck disable=SC2086 # several words
    run refine cube.off -s catmull-clark -n 2 -o kept/surface.pvtu --tiles 3 --journal kept $call
    exits 1
    says 'kept/surface.pieces: is a file of the journal itself; name another output, or another directory'
done
ln -s kept/surface linked.vtu
run refine cube.off -s catmull-clark -n 2 -o linked.vtu --tiles 3 --journal ./kept
exits 1
says 'kept/surface: is a file of the journal itself'
rm linked.vtu
leaves cube.off whole.ply whole.vtu
mkdir kept
run refine cube.off -s catmull-clark -n 3 -o kept/out.pvtu --tiles 3 --journal kept
exits 0
check "the pieces are there" test "$(ls kept/out.pieces | wc -l)" -eq 3
# Nor is a file of that name, which was there before, taken for the surface.
rm -r kept/*
echo mine >kept/surface
run refine cube.off -s catmull-clark -n 3 -o out.vtu --tiles 3 --journal kept
exits 1
says "kept/surface: exists without a recipe, so it may belong to another program; remove it, or name another directory"
check "it is untouched" test "$(cat kept/surface)" = mine
leaves cube.off kept whole.ply whole.vtu
rm -r kept

# Creases of the file, of an angle, and words of the scheme come back from the recipe.
run refine cube.off -s linear -n 1 -o cube.obj
(cat cube.obj; printf 't crease 2/1/0 0 8 2.5\n') >creased.obj
for words in "-s catmull-clark --crease-angle 30 --crease-sharpness 1.5" "-s loop --weights warren" \
    "-s doo-sabin --weights averaging" "-s kobbelt --tension 0.7" "-s 4-8" "-s catmull-clark --preset opensubdiv"; do
    input=cube.obj
    case $words in
    *loop*) tetrahedron >tetra.off && input=tetra.off ;;
    *preset*) input=creased.obj ;;
    esac
    # shellcheck disable=SC2086 # words are several
    run refine $input $words -n 3 -o one.vtu
    exits 0
    # shellcheck disable=SC2086
    run refine $input $words -n 3 -o out.vtu --tiles 4 --journal kept --only 1
    exits 0
    run refine --journal kept
    exits 0
    same one.vtu out.vtu
done
rm -f ./*.vtu ./*.obj tetra.off

# Another refinement is refused, and the journal stays.
run refine cube.off -s catmull-clark -n 4 -o out.vtu --tiles 6 --journal kept --only 0
exits 0
refused() { # refused MESSAGE ARGUMENTS...
    local message=$1
    shift
    run "$@"
    exits 1
    says "kept: is the journal of another refinement: $message; finish that one, or name another directory"
}
refused "its levels is '4', not '3'" refine cube.off -s catmull-clark -n 3 -o out.vtu --tiles 6 --journal kept
refused "its scheme is 'catmull-clark', not 'doo-sabin'" refine cube.off -s doo-sabin -n 4 -o out.vtu --journal kept
refused "its format is '.vtu', not '.ply'" refine cube.off -s catmull-clark -n 4 -o out.ply --journal kept
refused "its boundary-corners is '', not 'smoothed'" \
    refine cube.off -s catmull-clark -n 4 -o out.vtu --journal kept --boundary-corners smoothed
refused 'its control mesh, creases or attributes differ' \
    refine cube.off -s catmull-clark -n 4 -o out.vtu --journal kept --crease-angle 40
sed '3s/.*/-1 -1 -1.5/' cube.off >moved.off
refused 'its control mesh, creases or attributes differ' refine moved.off -s catmull-clark -n 4 -o out.vtu --journal kept
rm moved.off
run refine --journal kept
exits 0
run refine cube.off -s catmull-clark -n 4 -o again.vtu
same out.vtu again.vtu
rm ./*.vtu

# A recipe that is damaged, or not there, is told; what is missing in the call, too.
run refine cube.off -s catmull-clark -n 2 -o out.vtu --tiles 3 --journal kept --only 0
cp -r kept cut
head -c 700 kept/recipe >cut/recipe
run refine --journal cut
exits 1
says 'cut/recipe: .*remove cut and start again'
cp kept/recipe cut/recipe
printf '\x55' | dd of=cut/recipe bs=1 seek=900 conv=notrunc status=none
run refine --journal cut
exits 1
says 'cut/recipe: the recipe is damaged, its checksum is wrong; remove cut and start again'
rm -r cut
run refine --journal nowhere
exits 1
says 'nowhere: holds no recipe to resume; name the input mesh, the scheme and the other options'
run refine cube.off -s catmull-clark -n 2 -o out.vtu --only 1
exits 2
says '--only: needs --journal; name the directory of the tiles as well'
run refine --journal kept -s loop
exits 2
says '--scheme: without IN, the journal sets this option'
for range in 1..x 2..1 .. -1; do
    run refine --journal kept --only="$range"
    exits 2
    says "'$range' is not a range of tiles; write e.g. 100..199 or 7"
done
run refine --journal kept --only 2..3
exits 2
says 'tile 3 does not exist, there are 3, numbered from 0'
run refine cube.off -s catmull-clark -n 40 -o out.vtu --journal other
exits 1
check "nothing was begun" test ! -e other
if mkdir /dev/shm/kith.$$ 2>/dev/null; then
    run refine cube.off -s catmull-clark -n 1 -o out.vtu --journal /dev/shm/kith.$$/kept
    exits 1
    says 'kept: is on another file system than out.vtu; put the journal next to the output'
    rm -r /dev/shm/kith.$$
fi

# The rule of the file for corners at the boundary is in the journal.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\nt interpolateboundary 1/0/0 2\n' >rule.obj
run refine rule.obj -s catmull-clark -n 1 -o rule.ply --tiles 2
exits 0
run refine rule.obj -s catmull-clark -n 1 -o resumed.ply --tiles 2 --journal rules --only 0
exits 0
run refine --journal rules
exits 0
same rule.ply resumed.ply
finish
