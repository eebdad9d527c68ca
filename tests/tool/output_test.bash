# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
refine() { run refine cube.off -s catmull-clark -n "${2:-1}" -o "$1"; }

# A file that is there is replaced, through a link as well, and keeps its permissions.
echo old >out.off
chmod 640 out.off
ln -s out.off link.off
refine link.off
exits 0
prints '^link.off: 26 vertices'
check "still a link" test -L link.off
has out.off '^26 24 0$'
check "same permissions" test "$(stat -c %a out.off)" = 640
rm out.off link.off
# Tiles do the same.
for output in out.vtu out.ply out.pvtu; do
    echo old >"$output"
    chmod 640 "$output"
    ln -s "$output" "link.${output#*.}"
    run refine cube.off -s catmull-clark -n 1 -o "link.${output#*.}" --tiles 2
    exits 0
    check "still a link" test -L "link.${output#*.}"
    check "same permissions" test "$(stat -c %a "$output")" = 640
    check "replaced" test "$(wc -l <"$output")" -gt 1
done
check "the pieces are next to their index" test "$(ls out.pieces)" = "$(printf '%s\n' 0.vtu 1.vtu)"
rm -r out.* link.*
# A directory of pieces may lie elsewhere; a link may lead to what is not there yet.
mkdir elsewhere
chmod 750 elsewhere
ln -s elsewhere out.pieces
run refine cube.off -s catmull-clark -n 1 -o out.pvtu --tiles 2
exits 0
check "still a link" test -L out.pieces
check "the pieces are elsewhere" test "$(ls elsewhere)" = "$(printf '%s\n' 0.vtu 1.vtu)"
check "same permissions" test "$(stat -c %a elsewhere)" = 750
ln -s new.off link.off
refine link.off
exits 0
check "made through the link" test -L link.off -a -f new.off
ln -s circle.off circle.off
refine circle.off
exits 1
says 'circle.off: cannot be written: its symbolic links lead in a circle'
rm -r elsewhere out.* new.off link.off circle.off
refine ./sub/../out.off
exits 1
says 'sub/../out.off: cannot be written: No such file or directory'
only_input_left cube.off
mkdir sub
refine sub/out.off
exits 0
check "written in another directory" test "$(ls -A sub)" = out.off
rm -r sub

# What cannot be written is reported, and nothing is left.
refine no/such/directory/out.off
exits 1
says '^kith: no/such/directory/out.off: cannot be written'
prints_nothing
mkdir directory.off
refine directory.off
exits 1
says 'directory.off: is a directory'
rmdir directory.off
refine out.xyz
exits 1
says '^kith: out.xyz: the extension decides the format and must be .off, .obj, .ply, .stl, .vtp or .glb, or .vtu or .pvtu, which are written'
refine out
exits 1
says 'the extension'
refine .off
exits 1
refine ''
exits 1
says '^kith: the output has no name; name a file with -o$'
only_input_left cube.off

# A disk that is full: a limit on the size of files, or the device that is always full.
command="kith refine, files limited to 8 KiB"
echo old >out.off
(
    ulimit -f 8
    "$kith" refine cube.off -s catmull-clark -n 5 -o out.off >"$results/out" 2>"$results/err"
)
code=$?
exits 1
says '^kith: out.off: could not be written completely: File too large'
prints_nothing
leaves cube.off out.off
has out.off '^old$'
rm out.off
if test -w /dev/full; then
    refine /dev/full
    exits 1 # a device has no extension
    ln -s /dev/full full.off
    refine full.off
    exits 1
    says 'full.off: could not be written completely: No space left'
    check "the device is still there" test -c /dev/full
    ln -s /dev/null null.off
    refine null.off
    exits 0
    check "the device is still there" test -c /dev/null
    rm full.off null.off
    ln -s /dev/full full.ply
    run refine cube.off -s catmull-clark -n 1 -o full.ply --tiles 2
    exits 1
    says 'cannot be written .No space left'
    run refine cube.off -s catmull-clark -n 1 -o full.ply --journal kept
    exits 1
    says 'full.ply: is not a regular file, but the output of a journal must be one; name a file'
    ln -s /dev/null null.ply
    run refine cube.off -s catmull-clark -n 1 -o null.ply --tiles 2
    exits 0
    check "the devices are still there" test -c /dev/full -a -c /dev/null
    rm full.ply null.ply
    # What is complete is there, and the message says so.
    for output in x.off x.vtu; do
        command="kith refine -o $output > /dev/full"
        "$kith" refine cube.off -s catmull-clark -n 1 -o $output >/dev/full 2>"$results/err"
        code=$?
        exits 1
        says "^kith: standard output: cannot be written: No space left on device; $output is complete\$"
        check "the file is there" test -s $output
        rm $output
    done
    command="kith refine -o - > /dev/full"
    "$kith" refine cube.off -s catmull-clark -n 1 -o - >/dev/full 2>"$results/err"
    code=$?
    exits 1
fi
mkfifo pipe.ply
run refine cube.off -s catmull-clark -n 1 -o pipe.ply --tiles 2
exits 1
says 'pipe.ply: is a pipe, and tiles are written in any order; name a file'
rm pipe.ply
command="kith refine -o - | true"
"$kith" refine cube.off -s catmull-clark -n 6 -o - 2>"$results/err" | true
code=${PIPESTATUS[0]}
exits 1
says 'standard output'
only_input_left cube.off

# A signal that ends the program leaves nothing either.
ended() { # ended SIGNAL ARGUMENTS...: ends `kith refine` while it writes
    local signal=$1 process
    shift
    command="kith refine $*, ended by $signal"
    env --default-signal=INT "$kith" refine "$@" >"$results/out" 2>"$results/err" &
    process=$!
    for _ in $(seq 500); do
        compgen -G 'out.*.incomplete-*' >/dev/null && break
        sleep 0.02
    done
    case $* in *pvtu*)
        for _ in $(seq 500); do
            compgen -G 'out.*.pieces/*' >/dev/null && break
            sleep 0.02
        done
        ;;
    esac
    check "the file is being written" compgen -G 'out.*.incomplete-*' >/dev/null
    kill -"$signal" $process
    wait $process
    code=$?
    exits $((128 + $(kill -l "$signal")))
}
for signal in TERM HUP INT; do
    ended $signal cube.off -s catmull-clark -n 9 -o out.off
    only_input_left cube.off
    for output in out.ply out.pvtu; do
        ended $signal cube.off -s catmull-clark -n 10 -o $output --tiles 6
        only_input_left cube.off
    done
done 2>/dev/null

# What a process leaves that is killed is removed by the next one; what another one is writing is not.
for arguments in '-n 9 -o out.off' '-n 10 -o out.ply --tiles 6' '-n 10 -o out.pvtu --tiles 6'; do
    # shellcheck disable=SC2086 # several words
    ended KILL cube.off -s catmull-clark $arguments 2>/dev/null
    check "something is left" compgen -G 'out.*.incomplete-*' >/dev/null
    # shellcheck disable=SC2086
    run refine cube.off -s catmull-clark -n 1 ${arguments#-n * }
    exits 0
    check "and removed" test -z "$(ls | grep incomplete)"
    rm -r out.*
done
exec 9>out.off.incomplete-1
flock 9
touch out.off.incomplete-2 out.off.incomplete-2x
refine out.off
exits 0
leaves cube.off out.off out.off.incomplete-1 out.off.incomplete-2x
exec 9>&-
rm out.*

# A file may be its own result.
cp cube.off mine.off
run refine mine.off -s catmull-clark -n 1 -o mine.off
exits 0
has mine.off '^26 24 0$'
if test "$(id -u)" -ne 0; then
    mkdir closed
    chmod 555 closed
    refine closed/out.off
    exits 1
    says 'Permission denied'
    chmod 000 mine.off
    run info mine.off
    exits 1
    says 'Permission denied'
fi
finish
