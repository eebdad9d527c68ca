# SPDX-License-Identifier: BSD-3-Clause
# planned_test.bash KITH KITH_MPI SHIM: what is planned for ranks is what they do; pieces are the same on any ranks.
source "$(dirname "$0")/on_ranks.bash"
cube >cube.off
run refine cube.off -s catmull-clark -n 2 -o control.off

# of NAME RANK FILE: a number out of JSON, a rank to a line.
of() { sed -n "$(($2 + 1))s/.*\"$1\":\([0-9]*\).*/\1/p" "$3"; }
for scheme in catmull-clark kobbelt 'catmull-clark --crease-angle 10'; do
    run plan control.off -s $scheme -n 3 --ranks 3 --tiles-per-rank 2 --json
    exits 0
    sed 's/},{/\n/g' "$results/out" >plan
    test "$scheme" = catmull-clark && cp plan smooth.plan
    on 3 refine control.off -s $scheme -n 3 -o out.vtu --tiles-per-rank 2 --stats stats
    exits 0
    for phase in read partition cut send refine write wait; do
        check "seconds of $phase on each rank" test "$(grep -cE "^\{\"rank\":.*\"$phase\":[0-9.e-]+" stats)" -eq 3
        check "and of all" grep -qE "^\{\"ranks\":3,.*\"$phase\":\{\"minimum\":[0-9.e-]+,\"mean\":[0-9.e-]+,\"maximum\":[0-9.e-]+\}" stats
    done
    bytes=0
    for rank in 0 1 2; do
        check "tiles of rank $rank" test "$(of tiles $rank plan)" -eq "$(of tiles $rank stats)"
        check "faces of rank $rank" test "$(of last_faces $rank plan)" -eq "$(of owned_faces $rank stats)"
        bytes=$((bytes + $(of output_bytes $rank plan)))
        test $rank -eq 0 && continue # which sends itself nothing; every message has its size before it
        check "bytes for rank $rank" test $(($(of message_bytes $rank plan) + 2 * 8)) -eq "$(of bytes_received $rank stats)"
    done
    # All but the head of the file, and what is rounded off for each tile.
    head=$((8 * 6 + $(grep -abo '^_' out.vtu | head -n 1 | cut -d: -f1) + 32))
    check "bytes of the file" test $(($(stat -c %s out.vtu) - head - bytes)) -lt 12 -a $((head + bytes - $(stat -c %s out.vtu))) -lt 12
done

check "creases are sent, too" test "$(of message_bytes 1 plan)" -gt "$(of message_bytes 1 smooth.plan)"

run refine control.off -s doo-sabin -n 3 -o one.pvtu --tiles 4
exits 0
for mode in spmd manager; do
    on 2 refine control.off -s doo-sabin -n 3 -o out.pvtu --tiles-per-rank 2 --mode $mode
    exits 0
    check "the pieces of one process" diff -r one.pieces out.pieces
done
finish
