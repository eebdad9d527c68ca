# SPDX-License-Identifier: BSD-3-Clause
# attributes_test.bash KITH KITH_MPI SHIM: what files say of their meshes besides places, on ranks.
source "$(dirname "$0")/on_ranks.bash"
source "$(dirname "$0")/../tool/attribute_meshes.bash"
rich_cube >rich.ply
charts 6 >charts.obj

compare() { # compare IN ARGUMENTS...: the bytes of the program without tiles
    local in=$1 ranks mode
    shift
    run refine "$in" -o whole.ply --binary --drop-isolated "$@"
    exits 0
    for ranks in 1 2 3 4; do
        for mode in spmd manager; do
            on "$ranks" refine "$in" -o ranks.ply --mode "$mode" --tiles-per-rank 2 "$@"
            exits 0
            same whole.ply ranks.ply
        done
    done
}
compare rich.ply -s catmull-clark -n 3 --uv none
compare rich.ply -s doo-sabin -n 2
compare rich.ply -s 4-8 -n 3
compare charts.obj -s sqrt3 -n 1 --triangulate # the next step is the odd one, which the file says
has ranks.ply "^comment t generation 1/0/0 1$"
compare charts.obj -s catmull-clark -n 3 --uv corners+1 --crease-angle 20
compare charts.obj -s loop -n 2 --triangulate --uv none --threads 2
compare charts.obj -s kobbelt -n 2
compare charts.obj -s catmull-clark -n 2 --limit
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\nt interpolateboundary 1/0/0 2\n' >rule.obj
compare rule.obj -s catmull-clark -n 2 # by the rule of the file on ranks that have not read it, too
grid 4 >grid.obj # words, too
compare grid.obj -s doo-sabin -n 2

run refine rich.ply -s doo-sabin -n 2 -o whole.vtu
for ranks in 2 4; do
    for mode in spmd manager; do
        on $ranks refine rich.ply -s doo-sabin -n 2 -o ranks.vtu --mode $mode --verify
        exits 0
        says "^kith: note: rich.ply: not kept: the property 'others' of faces, 1 vertex without a face, texture coordinates$"
        prints 'verified'
        same whole.vtu ranks.vtu
    done
done
run refine grid.obj -s catmull-clark -n 2 -o whole.vtu
for mode in spmd manager; do
    on 3 refine grid.obj -s catmull-clark -n 2 -o ranks.vtu --mode $mode --journal kept
    exits 0
    same whole.vtu ranks.vtu
done
run refine rich.ply -s catmull-clark -n 2 -o one.pvtu --tiles 4
on 2 refine rich.ply -s catmull-clark -n 2 -o out.pvtu --tiles-per-rank 2
exits 0
check "the pieces of one process" diff -r one.pieces out.pieces

# A journal goes on with them, on other ranks and on none.
run refine charts.obj -s catmull-clark -n 3 -o whole.ply --uv corners --tiles 6
run refine charts.obj -s catmull-clark -n 3 -o out.ply --uv corners --tiles 6 --journal kept --only 1..2
exits 0
on 3 refine --journal kept --verify
exits 0
same whole.ply out.ply
run refine charts.obj -s catmull-clark -n 3 -o out.ply --uv corners --tiles 6 --journal kept --only 1..2
on 2 refine charts.obj -s catmull-clark -n 3 -o out.ply --uv corners --journal kept --mode manager
exits 0
same whole.ply out.ply

# What is planned counts them: the messages and the file.
of() { sed -n "$(($2 + 1))s/.*\"$1\":\([0-9]*\).*/\1/p" "$3"; } # of NAME RANK FILE: a number out of JSON, a rank to a line
run refine rich.ply -s catmull-clark -n 2 -o control.ply --binary --drop-isolated
run plan control.ply -s catmull-clark -n 3 --ranks 3 --tiles-per-rank 2 --json
exits 0
sed 's/},{/\n/g' "$results/out" >plan
on 3 refine control.ply -s catmull-clark -n 3 -o out.vtu --tiles-per-rank 2 --stats stats
exits 0
planned=0
for rank in 0 1 2; do
    planned=$((planned + $(of output_bytes $rank plan)))
    test $rank -eq 0 && continue # which sends itself nothing; every message has its size before it
    check "bytes for rank $rank" test $(($(of message_bytes $rank plan) + 2 * 8)) -eq "$(of bytes_received $rank stats)"
done
head=$((8 * 14 + $(grep -abo '^_' out.vtu | head -n 1 | cut -d: -f1) + 32))
difference=$((planned + head - $(stat -c %s out.vtu)))
check "bytes of the file" test $difference -lt 12 -a $difference -gt -12
finish
