# SPDX-License-Identifier: BSD-3-Clause
# faults_test.bash KITH KITH_MPI SHIM: whatever happens to a rank, the job ends soon, says why once and leaves nothing under
# the name of the output; what was finished is in the journal, and a job of any size goes on from there to the same bytes.
source "$(dirname "$0")/on_ranks.bash"
cube >cube.off
run refine cube.off -s catmull-clark -n 1 -o control.off
run refine control.off -s catmull-clark -n 4 -o whole.vtu
exits 0

# failing FAULT RANKS ARGUMENTS...: a job with this fault (see faults.cpp), which has ten seconds to end.
failing() {
    local fault=$1 ranks=$2
    shift 2
    command="mpirun -n $ranks kith-mpi $* with fault $fault"
    KITH_FAULT=$fault timeout 10 mpirun -n "$ranks" -x LD_PRELOAD="$shim" -x KITH_FAULT "$kith_mpi" "$@" \
        >"$results/out" 2>"$results/err" </dev/null
    code=$?
    check "ends by itself, with an error" test "$code" -ne 0 -a "$code" -ne 124
    check "no output" test ! -e out.vtu
}
# Of how many tiles the ranks of the last job wrote.
refined_tiles() { echo $(($(grep '"rank":' stats | sed 's/.*"tiles":\([0-9]*\),.*/\1/' | paste -sd+))); }

# goes_on RANKS ARGUMENTS...: the job goes on, with some of its 8 tiles.
goes_on() {
    local ranks=$1 tiles
    shift
    on "$ranks" refine "$@" --journal kept --stats stats
    exits 0
    tiles=$(refined_tiles)
    check "some tiles were finished, $tiles were missing" test "$tiles" -ge 1 -a "$tiles" -le 7
    same whole.vtu out.vtu
    check "the journal is gone" test ! -e kept
    rm -f out.vtu stats
}
job="control.off -s catmull-clark -n 4 -o out.vtu"
tiles='--tiles-per-rank 4'

# A rank that throws and a full disk, seen by one rank. A tile is about 80 writes.
# shellcheck disable=SC2086 # several words
failing 1:150:throw 2 refine $job $tiles --journal kept
exits 1
says '^kith-mpi: rank 1: a write failed on purpose$'
one_message
# shellcheck disable=SC2086
goes_on 3 $job
# shellcheck disable=SC2086
failing 1:150:full 2 refine $job $tiles --partitioner block --journal kept --mode manager
exits 1
says '^kith-mpi: rank 1: kept/surface: cannot be written \(No space left on device\)$'
one_message
goes_on 1

# A rank that is killed, whose job MPI ends, and one that throws no std::exception, which all ranks are told of.
# shellcheck disable=SC2086
failing 1:150:kill 2 refine $job $tiles --journal kept
says 'signal 9'
goes_on 4
# shellcheck disable=SC2086
failing 0:150:odd 2 refine $job $tiles --journal kept
exits 1
says '^kith-mpi: an exception not derived from std::exception$'
# Now without MPI, by a part of an array of jobs and a last one; with another fault in between.
run refine --journal kept --only 0..1
exits 0
prints '^kept: [2-6] of 8 tiles are finished$'
# shellcheck disable=SC2086
failing 1:12:kill 3 refine --journal kept
run refine --journal kept
exits 0
same whole.vtu out.vtu
check "the journal is gone" test ! -e kept
rm out.vtu

# Without MPI from the beginning, killed and ended by hand.
command="kith refine, killed"
# shellcheck disable=SC2086
OMPI_COMM_WORLD_RANK=0 KITH_FAULT=0:300:kill LD_PRELOAD=$shim "$kith" refine $job --tiles 8 --journal kept \
    >"$results/out" 2>"$results/err"
code=$?
exits $((128 + 9))
check "no output" test ! -e out.vtu
goes_on 2

# A job that is ended from outside while a rank is slow. In the foreground the signal comes once: after a second one mpirun
# kills the ranks at once.
command="mpirun -n 2 kith-mpi, ended from outside"
# shellcheck disable=SC2086
KITH_FAULT=1:150:slow timeout --foreground -s TERM 4 mpirun -n 2 -x LD_PRELOAD="$shim" -x KITH_FAULT "$kith_mpi" \
    refine $job $tiles --journal kept >"$results/out" 2>"$results/err" </dev/null
code=$?
check "was ended" test "$code" -ne 0
check "no output" test ! -e out.vtu
goes_on 2

# Without a journal nothing is left of a job that fails; of one that is killed, nothing under the output's name.
# shellcheck disable=SC2086
failing 1:150:full 2 refine $job $tiles
exits 1
says '^kith-mpi: rank 1: out.vtu.incomplete-[0-9]+: cannot be written \(No space left on device\)$'
check "nothing is left" test -z "$(find . -name 'out*')"
# shellcheck disable=SC2086
failing 1:150:kill 2 refine $job $tiles

# What rank 0 leaves when it is killed is removed by the next job; other processes may be writing the same, too.
# shellcheck disable=SC2086
failing 0:150:kill 2 refine $job $tiles
check "something is left" compgen -G 'out.vtu.incomplete-*' >/dev/null
exec 9>out.vtu.incomplete-1
flock 9
# shellcheck disable=SC2086
on 2 refine $job $tiles
exits 0
same whole.vtu out.vtu
check "and removed" test "$(echo out.*)" = 'out.vtu out.vtu.incomplete-1'
exec 9>&-
rm out.*
# A job that is ended from outside removes its pieces.
command="mpirun -n 2 kith-mpi, pieces, ended from outside"
# shellcheck disable=SC2086
KITH_FAULT=1:30:slow timeout --foreground -s TERM 4 mpirun -n 2 -x LD_PRELOAD="$shim" -x KITH_FAULT "$kith_mpi" \
    refine ${job%vtu}pvtu $tiles >"$results/out" 2>"$results/err" </dev/null
code=$?
check "was ended" test "$code" -ne 0
check "nothing is left" test -z "$(find . -name 'out*')"

# Finished tiles that were damaged are found when asked for, on any rank, and written again.
# shellcheck disable=SC2086
run refine $job --tiles 8 --journal kept --only 0..6
yes U | head -c 4000 | dd of=kept/surface bs=1 seek=3000 conv=notrunc status=none
# Without being asked a job notices, and gives the surface no name.
on 3 refine --journal kept
exits 1
says '^kith-mpi: .*kept/surface: is damaged, its bytes differ from those that were written; run again with --verify'
one_message
check "no output" test ! -e out.vtu
on 3 refine --journal kept --verify
exits 0
prints '^out.vtu: .*, checksum [0-9a-f]+, verified$'
says '^kith-mpi: note: tile [0-6] is damaged, byte [0-9]+ of kept/surface is wrong; the tile is written again$'
check "only finished ones are looked after" test "$(grep -c '^kith-mpi: note: tile 7' "$results/err")" -eq 0
same whole.vtu out.vtu
rm out.vtu

# What no library stands for: a file that may not grow, and a disk that is full.
command="mpirun -n 2 with ulimit -f"
# shellcheck disable=SC2086
timeout 10 mpirun -n 2 bash -c 'ulimit -f 40; exec "$@"' sh "$kith_mpi" refine $job $tiles \
    >"$results/out" 2>"$results/err" </dev/null
code=$?
exits 1
says 'out.vtu.incomplete-[0-9]+: cannot be made [0-9]+ bytes large \(File too large\)'
check "no output" test ! -e out.vtu
mkdir disk
if mount -t tmpfs -o size=100k tmpfs disk 2>/dev/null; then
    # shellcheck disable=SC2086
    on 2 refine ${job%out.vtu}disk/out.vtu $tiles --journal disk/kept
    exits 1
    says '^kith-mpi: (rank 1: )?disk/kept/surface: cannot be written \(No space left on device\)$'
    check "no output" test ! -e disk/out.vtu
    mount -o remount,size=10m disk
    on 3 refine --journal disk/kept
    exits 0
    same whole.vtu disk/out.vtu
    umount disk
fi

# An input that was cut off.
run refine control.off -s linear -n 0 -o control.ply --binary
head -c 900 control.ply >cut.ply
on 3 refine cut.ply -s catmull-clark -n 1 -o out.vtu --journal kept
exits 1
says '^kith-mpi: cut.ply: '
one_message
check "nothing was begun" test ! -e kept -a ! -e out.vtu

# Another refinement, and a journal that is none, are refused once.
# shellcheck disable=SC2086
failing 1:150:throw 2 refine $job $tiles --journal kept
# shellcheck disable=SC2086
on 2 refine ${job/-n 4/-n 3} --journal kept
exits 1
says "^kith-mpi: kept: is the journal of another refinement: its levels is '4', not '3'; finish that one"
on 3 refine --journal nowhere
exits 1
says '^kith-mpi: nowhere: holds no recipe to resume; name the input mesh, the scheme and the other options$'
on 2 refine --journal kept --tiles-per-rank 2
exits 2
says '--tiles-per-rank: without IN, the journal sets this option'
on 2 refine --journal kept --verify
exits 0
prints '^.*out.vtu: .*, verified$'
same whole.vtu out.vtu
finish
