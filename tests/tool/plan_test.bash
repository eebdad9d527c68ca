# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off
cat >quad.off <<'END'
OFF
4 1 0
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
END

run plan cube.off -s catmull-clark -n 3
exits 0
says_nothing
prints '^ +0 +8 +12 +6 +[0-9]+$'
prints '^ +1 +26 +48 +24 +[0-9]+$'
prints '^ +3 +386 +768 +384 +[0-9]+$'
leaves cube.off quad.off tetra.off
run plan tetra.off -s loop -n 2 --json
exits 0
prints '^\{"levels":\[\{"vertices":4,"edges":6,"faces":4,"bytes":[0-9]+\},\{"vertices":10,"edges":24,"faces":16,'
prints '"bytes_at_once":[0-9]+,"bytes_of_all_levels":[0-9]+\}$'
check "two levels and the control mesh" test "$(grep -o '"vertices"' "$results/out" | wc -l)" -eq 3

# The way, and why.
run plan cube.off -s catmull-clark -n 3 --why
exits 0
prints '^level by level: 384 faces are fewer than 12500, where templates begin to pay$'
run plan cube.off -s catmull-clark -n 9 --why --json
prints '"why":"in patches from level 6 on: [0-9]+ classes of faces, [0-9]+ with templates"\}$'
run plan cube.off -s catmull-clark -n 9 --why --limit
prints '^in patches from level 6 on: [0-9]+ classes of faces, [0-9]+ with templates$'
run plan cube.off -s catmull-clark -n 9 --why --limit --crease-angle 60
prints '^level by level: the levels between are wanted, too$'
run plan cube.off -s catmull-clark -n 3 --why --mesh cgal
exits 0
prints '^level by level: the levels between are wanted, too$'
run plan cube.off -s catmull-clark -n 3 --why --ranks 2
exits 2
says 'leave --ranks out'
for way in levels order patches; do
    run refine cube.off -s catmull-clark -n 3 -o $way.ply --way $way
    exits 0
    check "the same bytes by $way" cmp levels.ply $way.ply
    run refine cube.off -s catmull-clark -n 3 -o $way.vtu --tiles 4 --way $way
    check "the same tiles by $way" cmp levels.vtu $way.vtu
done
run refine cube.off -s catmull-clark -n 3 -o none.ply --way sideways
exits 2
says "'sideways' is not one of levels, order, patches"
run plan quad.off -s doo-sabin -n 1
prints '^ +1 +4 +4 +1 '
run plan cube.off -s sqrt3 -n 1
exits 1
says 'triangulate'
run plan quad.off -s doo-sabin -n 1 --boundary-corners kept
exits 2

run plan quad.off -s unified -n 1
exits 1
says 'edge 0 between vertices 0 and 1 is a boundary edge'

# What is planned is what refining gives, boundaries included.
for scheme in catmull-clark doo-sabin; do
    for mesh in cube.off quad.off; do
        for n in 1 2 3; do
            run plan $mesh -s $scheme -n $n
            counts=$(tail -n 2 "$results/out" | head -n 1 | awk '{ print $2 " vertices, " $3 " edges, " $4 " faces" }')
            run refine $mesh -s $scheme -n $n -o out.off
            prints "$counts"
            run info out.off
            prints "^edges +$(echo "$counts" | awk '{ print $3 }')\$"
        done
    done
done

# Far more than any memory holds is still planned; what no index numbers is refused in words.
run plan cube.off -s catmull-clark -n 13
exits 0
prints '^ +13 +402653186 +805306368 +402653184 +[0-9]{11}$'
run plan cube.off -s catmull-clark -n 20
exits 1
says 'level 14 has 1610612738 vertices and 3221225472 edges, more than a 32-bit index can number; refine at most 13 times'
prints '^ +13 +402653186 +805306368 +402653184 +[0-9]{11}$'
run plan cube.off -s catmull-clark -n 20 --json
exits 1
prints '"vertices":402653186,'
run plan cube.off -s catmull-clark -n 2000000000
exits 1
run refine cube.off -s catmull-clark -n 2000000000 -o out2.off
exits 1
check "no output file" test ! -e out2.off
run refine cube.off -s catmull-clark -n 13 -o out2.off --memory-limit 1G
exits 1
says 'bytes at once'
check "no output file" test ! -e out2.off

# What ranks would do. A torus of 8 x 6 quads in blocks: every tile is a ring of the torus, with a ring on either side.
awk 'BEGIN {
    m = 8; n = 6; pi = atan2(0, -1); print "OFF\n" m * n, m * n, 0
    for (i = 0; i < m; ++i) for (j = 0; j < n; ++j) {
        r = 3 + cos(2 * pi * j / n); print r * cos(2 * pi * i / m), r * sin(2 * pi * i / m), sin(2 * pi * j / n)
    }
    for (i = 0; i < m; ++i) for (j = 0; j < n; ++j) {
        a = (i + 1) % m; b = (j + 1) % n; print 4, i * n + j, a * n + j, a * n + b, i * n + b
    }
}' >torus.off
run plan torus.off -s catmull-clark -n 3 --ranks 2 --tiles-per-rank 2 --partitioner block
exits 0
says_nothing
prints '^rings of ghosts on level 0: 1$'
# 24 faces, of which 12 are in a tile, which has 12 ghosts; a quad becomes 64, of 24+8+1, 8+4+1 and 16 bytes in memory.
for rank in 0 1; do prints "^ +$rank +2 +24 +24 +[0-9]+ +1536 +$((768 * 62)) +$((1536 * 74))\$"; done
prints '^refining the largest tile needs [0-9]+ bytes at once$'
run plan torus.off -s butterfly -n 1 --ranks 2
exits 1
says 'triangulate the mesh first, with --triangulate$'
run plan torus.off -s butterfly -n 1 --ranks 2 --triangulate
exits 0
run plan torus.off -s doo-sabin -n 2 --ranks 3 --partitioner block --json
exits 0
prints '^\{"rings":2,"bytes_at_once":[0-9]+,"ranks":\[(\{"tiles":1,"faces":16,"ghosts":[0-9]+,"message_bytes":[0-9]+,"last_faces":256,.*){3}\]\}$'
# As many tiles as keep each small, on each rank as many; the refinement takes as many by itself.
run plan cube.off -s catmull-clark -n 8 --ranks 1
prints '^ +0 +1 +6 '
run plan cube.off -s catmull-clark -n 9 --ranks 1
prints '^ +0 +4 +6 '
run plan cube.off -s catmull-clark -n 9 --ranks 3
for rank in 0 1 2; do prints "^ +$rank +2 +2 "; done
run refine cube.off -s catmull-clark -n 9 -o out.vtu --json
prints '"tiles":4,'
rm out.vtu
# The messages are as long as kith-mpi counts them, the faces as many: see tests/mpi.
run plan cube.off -s catmull-clark -n 13 --ranks 8
exits 0
prints '^ +7 +1 +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+$'
# 64 bits suffice for 2.7e16 faces and their bytes, not for those of one level more. Columns do not run into each other.
run plan cube.off -s catmull-clark -n 26 --ranks 2 --tiles-per-rank 1
exits 0
says_nothing
prints '^ +0 +1 +3 +[0-9]+ +[0-9]+ +13510798882111488 +[0-9]+ +[0-9]+$'
check "columns of one width" test "$(sed -n '2,4p' "$results/out" | awk '{ print length }' | sort -u | wc -l)" -eq 1
run plan cube.off -s catmull-clark -n 27 --ranks 2
exits 1
says 'level 27 has 108086391056891906 vertices and 216172782113783808 edges, whose size in bytes exceeds 64 bits'
run plan cube.off -s catmull-clark -n 20 --ranks 2 --tiles-per-rank 1
exits 0
prints '^ +1 +1 +3 +[0-9]+ +[0-9]+ +3298534883328 +[0-9]+ +[0-9]+$'
run plan cube.off -s catmull-clark -n 2 --ranks 2 --mesh cgal
exits 2
says '--mesh and --ranks do not go together'
run plan cube.off -s unified -n 2 --ranks 2
exits 2
says '--ranks: unified is not refined in tiles: it takes closed meshes only, and a tile has a boundary; plan without ranks'
# Creases, holes and schemes without rules for them are what `refine` says of them.
run plan cube.off -s doo-sabin -n 2 --crease-angle 30
plan_code=$code
cp "$results/err" plan.err
run refine cube.off -s doo-sabin -n 2 --crease-angle 30 -o out.off
exits "$plan_code"
same plan.err "$results/err"
says 'crease-angle'
run refine cube.off -s linear -n 0 -o cube.obj
(cat cube.obj; echo; echo 't crease 2/1/0 0 1 2') >creased.obj
(cat cube.obj; echo; echo 't hole 1/0/0 1') >holes.obj
run plan creased.obj -s doo-sabin -n 2
exits 1
says 'doo-sabin has no rules for the creases, corners or holes of the file; only catmull-clark, loop and quad-tri have them; use one of these, or --ignore-tags'
run plan creased.obj -s doo-sabin -n 2 --ignore-tags
exits 0
run plan holes.obj -s catmull-clark -n 2
exits 0
run plan holes.obj -s catmull-clark -n 2 --ranks 2
exits 1
says 'the file has holes, which tiles cannot leave out'
run plan cube.off -s catmull-clark -n 2 --ranks 0
exits 2
says '.-ranks: 0 ranks were asked for; ask for 1 or more'
run plan cube.off -s catmull-clark -n 2 --ranks 1048577
exits 2
says '.-ranks: 1048577 ranks were asked for; ask for 1 or more, up to 1048576'
run plan cube.off -s catmull-clark -n 2 --ranks 2 --tiles-per-rank 4294967296
exits 2
says '.-tiles-per-rank: 4294967296 tiles per rank were asked for; ask for 1 or more, up to 4294967295'
run plan cube.off -s catmull-clark -n 2 --tiles-per-rank 2
exits 2
says '--tiles-per-rank: needs --ranks; name the number of ranks as well'

# The program needs what is planned, and not much less: its peak in kilobytes beside what it has for the cube.
if test -x /usr/bin/time; then
    peak() { # peak ARGUMENTS...: of kith refine
        command="kith refine $*"
        /usr/bin/time -f %M -o "$results/peak" "$kith" refine "$@" >"$results/out" 2>"$results/err" </dev/null
        code=$?
        exits 0
        peak=$(tail -n 1 "$results/peak")
    }
    planned() { # planned BASE ARGUMENTS... -- ARGUMENTS...: those of plan, and those of refine
        local base=$1 plan=()
        shift
        while test "$1" != --; do
            plan+=("$1")
            shift
        done
        shift
        run plan "${plan[@]}"
        exits 0
        need=$(sed -n 's/^refining.* needs \([0-9]*\) bytes at once.*/\1/p' "$results/out")
        peak "$@"
        percent=$(((peak - base) * 102400 / need))
        check "$percent % of the plan should be used, which are $need bytes" test "$percent" -ge 80 -a "$percent" -le 100
    }
    peak cube.off -s catmull-clark -n 0 -o out.off
    base=$peak
    peak cube.off -s catmull-clark -n 1 -o out.vtu --tiles 2
    base_of_tiles=$peak
    run refine cube.off -s catmull-clark -n 5 -o control.ply --binary
    planned "$base" cube.off -s linear -n 9 -- cube.off -s linear -n 9 -o out.ply --binary --way levels
    # Where the last steps are made in patches, the level before the last is not there: less of the plan is used.
    run plan cube.off -s catmull-clark -n 9
    need=$(sed -n 's/^refining.* needs \([0-9]*\) bytes at once.*/\1/p' "$results/out")
    peak cube.off -s catmull-clark -n 9 -o out.ply --binary
    check "patches should use less than 4/5 of the plan, which are $need bytes" test $(((peak - base) * 1024)) -lt $((need * 4 / 5))
    planned "$base" control.ply -s doo-sabin -n 4 -- control.ply -s doo-sabin -n 4 -o out.off
    for mesh in cgal openmesh; do
        planned "$base" cube.off -s catmull-clark -n 8 --mesh $mesh -- \
            cube.off -s catmull-clark -n 8 --mesh $mesh -o out.ply --binary
    done
    planned "$base" cube.off -s linear -n 8 --limit -- cube.off -s linear -n 8 --limit -o out.ply --binary
    # Limits of regular vertices need no numbers of vertices.
    run plan cube.off -s catmull-clark -n 8 --limit
    need=$(sed -n 's/^refining.* needs \([0-9]*\) bytes at once.*/\1/p' "$results/out")
    peak cube.off -s catmull-clark -n 8 --limit -o out.ply --binary
    check "regular limits should use less than 4/5 of the plan, which are $need bytes" \
        test $(((peak - base) * 1024)) -lt $((need * 4 / 5))
    # On sharp edges each side has normals of its own.
    run plan cube.off -s catmull-clark -n 8 --limit --crease-angle 30
    need=$(sed -n 's/^refining.* needs \([0-9]*\) bytes at once.*/\1/p' "$results/out")
    peak cube.off -s catmull-clark -n 8 --limit --crease-angle 30 -o out.ply --binary
    check "limits on creases should use no more than the plan, which are $need bytes" \
        test $(((peak - base) * 1024)) -le "$need"
    # The same in tiles, step by step and in patches.
    planned "$base_of_tiles" control.ply -s doo-sabin -n 4 --ranks 1 --tiles-per-rank 1 -- \
        control.ply -s doo-sabin -n 4 -o out.vtu --tiles 1 --threads 1 --way levels
    for job in "catmull-clark -n 5 --tiles 1" "catmull-clark -n 5 --tiles 8" "doo-sabin -n 4 --tiles 1"; do
        run plan control.ply -s ${job%--*} --ranks 1 --tiles-per-rank ${job##* }
        need=$(sed -n 's/^refining.* needs \([0-9]*\) bytes at once.*/\1/p' "$results/out")
        peak control.ply -s $job -o out.vtu --threads 1
        check "patches should use less than 4/5 of the plan, which are $need bytes" \
            test $(((peak - base_of_tiles) * 1024)) -lt $((need * 4 / 5))
    done
    for tiles in 1 8; do
        planned "$base_of_tiles" control.ply -s catmull-clark -n 4 --limit --ranks 1 --tiles-per-rank $tiles -- \
            control.ply -s catmull-clark -n 4 -o out.vtu --limit --tiles $tiles --threads 1
    done
    rm control.ply out.*
fi
finish
