# SPDX-License-Identifier: BSD-3-Clause
# errors_test.bash KITH KITH_MPI SHIM: what goes wrong on ranks ends the job, soon, with one message and no file.
source "$(dirname "$0")/on_ranks.bash"

cube >cube.off
tetrahedron >tetra.off

for help in --help -h; do
    on 2 $help
    exits 0
    prints '^kith-mpi refine \[IN\] \[options\]'
    check "it is said once" test "$(grep -c 'Exit codes' "$results/out")" -eq 1
done
on 2 --version
exits 0
prints '^kith-mpi [0-9]+\.[0-9]+\.[0-9]+$'
on 2 refine --help
exits 0
prints '^kith-mpi refine \[IN\] \[options\]$'
prints '^  mpirun -n 64 kith-mpi refine '
on 2
exits 2
says 'the verb is missing; use refine, see `kith-mpi --help`'
one_message
on 2 info cube.off
exits 2
says "'info' is not a verb; use refine, see .kith-mpi --help."
one_message

on 3 refine cube.off -s loop -n 1 -o out.vtu
exits 1
says 'loop: face 0 has 4 vertices; triangulate the mesh first, with --triangulate$'
one_message
on 3 refine nothing.off -s loop -n 1 -o out.vtu
exits 1
says 'nothing.off'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o ""
exits 1
says '^kith-mpi: the output has no name; name a file with -o$'
one_message
on 2 refine cube.off -s catmull-clark -n 1 -o out.ply --cell-origin
exits 2
says '--cell-origin: out.ply cannot hold it; write .vtu or .pvtu'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o out.stl
exits 2
says 'tiles are written to .vtu, .ply or .pvtu'
one_message
on 3 refine cube.off -s unified -n 1 -o out.vtu
exits 2
says 'unified is not refined in tiles: it takes closed meshes only, and a tile has a boundary; use kith refine'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --mode some
exits 2
says "'some' is not one of spmd, manager"
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --tiles-per-rank 9223372036854775807
exits 2
says 'tiles-per-rank: 9223372036854775807 tiles per rank were asked for; ask for 1 or more, up to 4294967295'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --tiles-per-rank 4294967295
exits 1
says '12884901885 parts were asked for, and the mesh has 6 faces; ask for at most 1048576'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --threads 4294967297
exits 2
says 'threads: 4294967297 threads were asked for; ask for 1 or more, up to 4096'
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --partitioner some
exits 2
says "'some' is not one of metis, block, file:PATH"
on 3 refine cube.off -s catmull-clark -n 1 -o nowhere/out.vtu
exits 1
says 'nowhere/out.vtu'
one_message
on 2 refine cube.off -s catmull-clark -n 15 -o nowhere/out.vtu --memory-per-rank 1G # more than 32 bits number
exits 1
says 'the largest tile needs .* the limit is 1073741824 \(1.0 GiB\); refine fewer times, since not even one tile per face'
one_message
on 2 refine cube.off -s catmull-clark -n 15 -o out.vtu
exits 1
says '9/10 of the available memory; refine fewer times'
one_message
on 3 refine cube.off -s catmull-clark -n 15 -o out.ply
exits 1
says 'PLY numbers 2147483647 vertices at most'
one_message
on 3 refine cube.off -s catmull-clark -n 40 -o out.vtu
exits 1
says 'whose size in bytes exceeds 64 bits; refine at most 26 times'
printf '0 1 2\n' >short.part
on 2 refine cube.off -s catmull-clark -n 1 -o out.vtu --partitioner file:short.part
exits 1
says 'the partition file has 3 numbers, the mesh has 6 faces'
run refine cube.off -s linear -n 0 -o cube.obj
(cat cube.obj; echo; echo 't hole 1/0/0 1') >holes.obj
on 2 refine holes.obj -s catmull-clark -n 1 -o out.vtu
exits 1
says 'the file has holes, which tiles cannot leave out'
one_message
# Coordinates that overflow, on whichever rank.
sed '3,10s/1/1e308/g' cube.off >large.off
for output in out.vtu out.ply out.pvtu; do
    on 3 refine large.off -s catmull-clark -n 2 -o $output
    exits 1
    says "^kith-mpi: (rank [12]: )?$output: vertex [0-9]+ would not have finite coordinates; the coordinates of the input are too large\$"
    one_message
done
check "no output is left" test -z "$(ls | grep -E 'out|incomplete')"

# A tile that needs more memory than its rank has: no rank waits for another.
for mode in spmd manager; do
    command="mpirun -n 3 with little memory, $mode"
    timeout 60 mpirun -n 3 bash -c 'ulimit -v 900000; exec "$@"' sh "$kith_mpi" refine tetra.off -s loop -n 12 -o out.vtu \
        --mode $mode >"$results/out" 2>"$results/err" </dev/null
    code=$?
    exits 1
    says 'not enough memory'
    check "no output is left" test -z "$(ls | grep -E 'vtu|incomplete')"
done

# A file of parts is a partition like any other; parts may be empty, and scattered.
printf '0\n3\n0\n5\n3\n0\n' >some.part
on 1 refine cube.off -s doo-sabin -n 3 -o one.ply
on 3 refine cube.off -s doo-sabin -n 3 -o many.ply --partitioner file:some.part --verify
exits 0
same one.ply many.ply
run info many.ply
exits 0
prints '386'

# Refinement itself sends nothing: counted by a library between kith and MPI, not by kith.
command="mpirun -n 3 with a library that counts"
timeout 60 mpirun -n 3 -x LD_PRELOAD="$shim" "$kith_mpi" refine cube.off -s catmull-clark -n 4 -o out.vtu \
    --tiles-per-rank 2 >"$results/out" 2>"$results/err" </dev/null
code=$?
exits 0
check "three ranks have counted" test "$(grep -c '^refinement: 0 calls' "$results/err")" -eq 3
check "and saw the rest" test "$(grep -c '^elsewhere: [1-9][0-9]* calls' "$results/err")" -eq 3

finish
