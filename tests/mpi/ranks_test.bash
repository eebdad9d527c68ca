# SPDX-License-Identifier: BSD-3-Clause
# ranks_test.bash KITH KITH_MPI SHIM RANKS...: drives kith-mpi at these numbers of ranks, in a directory of its own.
source "$(dirname "$0")/on_ranks.bash"
shift 3

cube >cube.off
tetrahedron >tetra.off
# A sheet of 5 x 7 quads with a hole, and the same in triangles: boundaries, corners and vertices of many valences.
sheet() { # sheet FACES_OF_A_CELL...
    awk -v triangles="$1" 'BEGIN {
        m = 6; n = 8
        for (i = 0; i < m; ++i) for (j = 0; j < n; ++j)
            points = points sprintf("%g %g %g\n", i + 0.1 * sin(3 * j), j + 0.2 * sin(5 * i), sin(i * 2 + j))
        for (i = 0; i + 1 < m; ++i) for (j = 0; j + 1 < n; ++j) {
            if (i == 2 && j == 3) continue
            a = i * n + j; b = a + n; c = b + 1; d = a + 1
            if (!triangles) { faces = faces "4 " a " " b " " c " " d "\n"; ++count }
            else if ((i + j) % 3) { faces = faces "3 " a " " b " " c "\n3 " a " " c " " d "\n"; count += 2 }
            else { faces = faces "3 " a " " b " " d "\n3 " b " " c " " d "\n"; count += 2 }
        }
        print "OFF\n" m * n, count, 0; printf "%s%s", points, faces
    }'
}
sheet 0 >quads.off
sheet 1 >triangles.off
# Polygons: the sheet with some of its cells left in triangles.
awk 'NR == 2 { $2 += 1 } { print }' quads.off | awk 'NR == 51 { print "3", $2, $3, $4; print "3", $2, $4, $5; next } { print }' >mixed.off

# The same bytes, whatever the ranks, as the bytes of one rank; that those are the surface, --verify has looked.
compare() { # compare NAME IN SCHEME LEVELS [ARGUMENTS...]
    local name=$1 in=$2 scheme=$3 levels=$4 mode
    shift 4
    on 1 refine "$in" -s "$scheme" -n "$levels" -o one.vtu --verify "$@"
    exits 0
    prints 'verified'
    for ranks in $rank_counts; do
        for mode in spmd manager; do
            on "$ranks" refine "$in" -s "$scheme" -n "$levels" -o many.vtu --mode "$mode" --tiles-per-rank 2 "$@"
            exits 0
            check "the file of one rank" cmp -s one.vtu many.vtu
            test "$name" = catmull-clark || continue # with threads, which have a tile each
            on "$ranks" refine "$in" -s "$scheme" -n "$levels" -o many.vtu --mode "$mode" --tiles-per-rank 4 --threads 2
            exits 0
            check "the file of one rank" cmp -s one.vtu many.vtu
        done
    done
}
rank_counts=$*
compare catmull-clark mixed.off catmull-clark 3
compare loop triangles.off loop 3 --partitioner block
compare doo-sabin mixed.off doo-sabin 3
compare sqrt3 triangles.off sqrt3 4
compare butterfly triangles.off butterfly 3
compare kobbelt quads.off kobbelt 3
compare nasri-hasbini quads.off nasri-hasbini 2
compare mid-edge mixed.off mid-edge 4
compare 4-8 mixed.off 4-8 4
compare creases quads.off catmull-clark 3 --crease-angle 20
compare closed cube.off catmull-clark 4
# A repaired mesh is the mesh that it was made.
on 1 refine cube.off -s catmull-clark -n 2 -o one.vtu
sed '11s/.*/4 0 1 2 3/' cube.off >turned.off
for ranks in $rank_counts; do
    on "$ranks" refine turned.off -s catmull-clark -n 2 -o many.vtu --repair orient
    exits 0
    says '^kith: note: turned.off: face 0: turned round$'
    check "the file of the good mesh" cmp -s one.vtu many.vtu
done

finish
