# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# The bytes do not depend on the tiles.
run refine cube.off -s catmull-clark -n 4 -o one.vtu --checksum
exits 0
says_nothing
prints '^one.vtu: 1538 vertices, 3072 edges, 1536 faces, checksum [0-9a-f]+$'
checksum=$(sed 's/.* //' "$results/out")
run refine cube.off -s catmull-clark -n 4 -o one.vtu --checksum --json
prints "\"checksum\":\"$checksum\""
for tiles in 2 5 6 9; do
    for partitioner in metis block; do
        run refine cube.off -s catmull-clark -n 4 -o many.vtu --tiles $tiles --partitioner $partitioner
        exits 0
        same one.vtu many.vtu
    done
done
has one.vtu 'NumberOfPoints="1538" NumberOfCells="1536"'
has one.vtu 'Name="parent"'

# Nor on the threads, which have a tile each; what is written is read back where asked for.
for threads in 1 2 5; do
    run refine cube.off -s catmull-clark -n 4 -o many.vtu --tiles 6 --threads $threads --verify
    exits 0
    prints '^many.vtu: .*, checksum [0-9a-f]+, verified$'
    same one.vtu many.vtu
done
run refine cube.off -s catmull-clark -n 4 -o many.vtu --tiles 6
prints '^many.vtu: 1538 vertices, 3072 edges, 1536 faces$'

run refine cube.off -s catmull-clark -n 4 -o TWO.VTU # needs no --tiles, in any case of letters
exits 0
same one.vtu TWO.VTU
rm TWO.VTU

# The PLY file is the surface that is refined without tiles.
run refine tetra.off -s loop -n 5 -o tiles.ply --tiles 3
exits 0
run refine tetra.off -s loop -n 5 -o whole.ply --binary
exits 0
run compare tiles.ply whole.ply --tolerance 0
exits 0
prints 'largest distance 0, equal'
run refine cube.off -s doo-sabin -n 3 -o tiles.ply --tiles 4 # faces of several degrees
run refine cube.off -s doo-sabin -n 3 -o whole.ply --binary
run compare tiles.ply whole.ply --tolerance 0
exits 0
prints 'largest distance 0, equal'
run refine cube.off -s 4-8 -n 5 -o tiles.ply --tiles 4 # of marked edges
run refine cube.off -s 4-8 -n 5 -o whole.ply --binary
run compare tiles.ply whole.ply --tolerance 0
exits 0
prints 'largest distance 0, equal'
run refine cube.off -s catmull-clark -n 2 -o tiles.ply --tiles 2 --json
exits 0
prints '"tiles":2.*"faces":96'
rm ./*.ply ./*.vtu

# A file per tile and an index; tests/vtu_pieces_test.cpp looks at what they hold.
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --threads 2 --verify
exits 0
prints '^out.pvtu: 386 vertices, 768 edges, 384 faces, checksum [0-9a-f]+, verified$'
has out.pvtu 'Source="out.pieces/2.vtu"'
check "three pieces" test "$(ls out.pieces)" = "$(printf '%s\n' 0.vtu 1.vtu 2.vtu)"
check "all faces" test $(($(grep -ahoP 'NumberOfCells="\K[0-9]+' out.pieces/*.vtu | paste -sd+))) -eq 384
mv out.pieces whole.pieces
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 3 --journal kept --only 0..1
exits 0
check "no pieces yet" test ! -e out.pieces
rm kept/surface.pieces/1.vtu # its tile is not finished, then
run refine --journal kept
exits 0
check "the same pieces" diff -r whole.pieces out.pieces
check "nothing is left of the journal" test ! -e kept
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 2
exits 0
check "two pieces, the old ones are gone" test "$(ls out.pieces)" = "$(printf '%s\n' 0.vtu 1.vtu)"
touch out.pieces/mine
run refine cube.off -s catmull-clark -n 3 -o out.pvtu --tiles 2
exits 1
says 'out.pieces: would be replaced by the pieces, but holds mine; remove it, or name another output'
leaves cube.off out.pieces out.pvtu tetra.off whole.pieces
rm -r out.pvtu ./*.pieces

# What tiles cannot do is refused, and nothing is left.
run refine cube.off -s catmull-clark -n 1 -o out.off --tiles 2
exits 2
says 'tiles are written to .vtu, .ply or .pvtu'
run refine cube.off -s catmull-clark -n 1 -o out.ply --tiles 0
exits 2
says '^kith: --tiles: 0 tiles were asked for; ask for 1 or more$'
run refine cube.off -s catmull-clark -n 1 -o out.ply --tiles 2 --mesh cgal
exits 2
says '--mesh and tiles do not go together; leave one of them out'
run refine cube.off -s catmull-clark -n 1 -o out.vtu --mesh cgal
exits 2
says '--mesh and tiles do not go together; out.vtu is written in tiles, so leave out the option or write .off, .obj'
run refine cube.off -s unified -n 1 -o out.ply --tiles 2
exits 2
says 'unified is not refined in tiles: it takes closed meshes only, and a tile has a boundary; leave out --tiles'
run refine cube.off -s catmull-clark -n 1 -o nowhere/out.ply --tiles 2
exits 1
says 'nowhere/out.ply'
run refine cube.off -s catmull-clark -n 40 -o out.ply --tiles 2
exits 1
leaves cube.off tetra.off

# Coordinates that overflow are refused, and nothing is left.
sed '3,10s/1/1e308/g' cube.off >large.off
for output in out.vtu out.ply out.pvtu; do
    run refine large.off -s catmull-clark -n 2 -o $output --tiles 3
    exits 1
    says "^kith: $output: vertex [0-9]+ would not have finite coordinates; the coordinates of the input are too large\$"
    leaves cube.off large.off tetra.off
done
rm large.off

# Seconds of each phase, in a file and in the result line.
phases='"seconds":\{"read":[0-9.e-]+,"partition":[0-9.e-]+,"cut":[0-9.e-]+,"send":0\.0,"refine":[0-9.e-]+,"write":[0-9.e-]+,"wait":[0-9.e-]+\}'
for arguments in '-o out.off' '-o out.vtu --tiles 3'; do
    # shellcheck disable=SC2086 # several words
    run refine cube.off -s catmull-clark -n 3 $arguments --json --stats stats
    exits 0
    prints "$phases\}\$"
    has stats "^\{$phases,\"processor_seconds\":[0-9.e-]+,\"peak_bytes\":[0-9]+\}\$"
done
rm out.* stats

# That all tiles are binary is said where a format has text, too.
run refine cube.off -s catmull-clark -n 1 -o out.ply --tiles 2
exits 0
says '^kith: note: out.ply is binary, since tiles are written at fixed byte positions$'
run refine cube.off -s catmull-clark -n 1 -o out.ply --tiles 2 --binary
exits 0
says_nothing
rm out.ply

# Tiles that need more memory than there is are refused before any work, with as many as would fit.
export OMP_NUM_THREADS=1
run refine cube.off -s catmull-clark -n 15 -o out.vtu --tiles 2
exits 1
says '^kith: catmull-clark: the largest tile needs [0-9]+ \([0-9.]+ [GT]iB\) bytes at once, the limit is '
says '9/10 of the available memory; refine fewer times, (or use more tiles: --tiles [0-9]+|since not even)'
leaves cube.off tetra.off
run refine cube.off -s catmull-clark -n 4 -o control.ply --binary
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles 2 --memory-limit 40M --threads 1
exits 1
says 'the limit is 41943040 \(40.0 MiB\); refine fewer times, or use more tiles: --tiles [0-9]+$'
more=$(sed -n 's/.*--tiles //p' "$results/err")
check "it is a few" test "$more" -gt 2 -a "$more" -lt 40
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$more" --memory-limit 40M
exits 0
says_nothing
# The number that the program chooses itself fits the limit.
run refine control.ply -s catmull-clark -n 5 -o usual.vtu --memory-limit 40M
exits 0
says_nothing
same out.vtu usual.vtu
rm usual.vtu
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles 2000 --memory-limit 200K
exits 1
says 'refine fewer times, since not even one tile per face of the mesh would fit$'
# Limits need more, and what a journal has kept is looked at like what is new.
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$more" --memory-limit 40M --limit
exits 1
says 'the limit is 41943040 \(40.0 MiB\); refine fewer times, or use more tiles: --tiles [0-9]+$'
for_limit=$(sed -n 's/.*--tiles //p' "$results/err")
check "it is more" test "$for_limit" -gt "$more"
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$for_limit" --memory-limit 40M --limit
exits 0
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$more" --journal kept --only 0
exits 0
run refine --journal kept --memory-limit 10M
exits 1
says 'the limit is 10485760 \(10.0 MiB\)'
run refine --journal kept --memory-limit 40M
exits 0
unset OMP_NUM_THREADS
# So do threads, which have a tile each; fewer of them are a way, too.
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$more" --memory-limit 40M --threads "$more"
exits 1
says "^kith: catmull-clark: $more tiles, one per thread, need [0-9]+ \([0-9.]+ MiB\) bytes at once, the limit is 41943040 "
says '; refine fewer times, or use fewer threads: --threads [0-9]+(, or use more tiles: --tiles [0-9]+)?$'
threads=$(sed -n 's/.*--threads \([0-9]*\).*/\1/p' "$results/err")
run refine control.ply -s catmull-clark -n 5 -o out.vtu --tiles "$more" --memory-limit 40M --threads "$threads"
exits 0
rm control.ply out.vtu

# A surface too large for the memory is refined in tiles: 6 million faces, whose points and corners take 250 MB, in 220 MB.
command="kith refine with little memory"
(ulimit -v 220000 && OMP_NUM_THREADS=1 timeout 60 "$kith" refine cube.off -s catmull-clark -n 10 -o whole.ply --binary) \
    >"$results/out" 2>"$results/err"
code=$?
exits 1
says 'not enough memory'
run refine cube.off -s catmull-clark -n 4 -o control.ply --binary
(ulimit -v 220000 && OMP_NUM_THREADS=1 timeout 60 "$kith" refine control.ply -s catmull-clark -n 6 -o tiles.ply --tiles 48) \
    >"$results/out" 2>"$results/err"
code=$?
exits 0
prints '6291456 faces'
finish
