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
says '^kith: out.xyz: the extension decides the format'
refine out
exits 1
says 'the extension'
refine .off
exits 1
refine ''
exits 1
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
    command="kith refine -o - > /dev/full"
    "$kith" refine cube.off -s catmull-clark -n 1 -o - >/dev/full 2>"$results/err"
    code=$?
    exits 1
fi
command="kith refine -o - | true"
"$kith" refine cube.off -s catmull-clark -n 6 -o - 2>"$results/err" | true
code=${PIPESTATUS[0]}
exits 1
says 'standard output'
only_input_left cube.off

# A signal that ends the program leaves nothing either.
interrupted() { # interrupted SIGNAL ARGUMENTS...: ends `kith refine` while it writes
    local signal=$1 process
    shift
    command="kith refine $*, ended by $signal"
    "$kith" refine "$@" >"$results/out" 2>"$results/err" &
    process=$!
    for _ in $(seq 500); do
        compgen -G 'out.*.incomplete-*' >/dev/null && break
        sleep 0.02
    done
    check "the file is being written" compgen -G 'out.*.incomplete-*' >/dev/null
    kill -"$signal" $process
    wait $process
    code=$?
    exits $((128 + $(kill -l "$signal")))
    only_input_left cube.off
}
for signal in TERM HUP; do
    interrupted $signal cube.off -s catmull-clark -n 9 -o out.off
    interrupted $signal cube.off -s catmull-clark -n 10 -o out.ply --tiles 6
done 2>/dev/null

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
