# SPDX-License-Identifier: BSD-3-Clause
# The bar that shows on a terminal how far the work is, read through a pseudo-terminal.
source "$(dirname "$0")/check.bash"
if ! command -v python3 >/dev/null; then
    echo "no python3, which makes the pseudo-terminals"
    exit 0
fi

# on_terminal [--interrupt] COMMAND...: runs it with standard error on a terminal of 80 columns and standard output in a file.
# What the terminal gets is in $results/screen; with --interrupt Ctrl-C is typed once a bar is there.
on_terminal() {
    command="on a terminal: $*"
    TERM=xterm timeout 120 python3 - "$results/out" "$results/screen" "$@" <<'END'
import fcntl, os, pty, struct, sys, termios
out, screen, *command = sys.argv[1:]
interrupt = command[0] == "--interrupt"
command = command[1:] if interrupt else command
child, terminal = pty.fork()
if child == 0:
    os.dup2(os.open(out, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), 1)
    fcntl.ioctl(2, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    os.execvp(command[0], command)
shown = b""
while True:
    try:
        part = os.read(terminal, 65536)
    except OSError: # the other end is closed
        part = b""
    if not part:
        break
    shown += part
    if interrupt and b"] " in shown:
        os.write(terminal, b"\x03")
        interrupt = False
open(screen, "wb").write(shown)
status = os.waitpid(child, 0)[1]
sys.exit(os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128 + os.WTERMSIG(status))
END
    code=$?
    tr '\r' '\n' <"$results/screen" | sed 's/\x1b\[K//g; s/\^C//' >"$results/lines" # a line for each time that it was drawn
    cp "$results/lines" "$results/err"
}
shows() { check "the terminal should show '$1'" grep -qE -- "$1" "$results/lines"; }
# What is left on the screen: the letters of the last line, after they have been erased.
# The line of the last bar is erased before anything else comes.
leaves_no_bar() {
    check "the bar should be gone" test "$(tr '\r' '\n' <"$results/screen" | sed '/^$/d' | tail -n 1 | cut -c 1-3)" = $'\x1b[K'
}
shares_grow() {
    check "the share of '$1' should never shrink and the estimate be there" awk -v phase="$1" '
        index($0, phase " [") == 1 { share = $0; sub(/.*\] /, "", share); ++bars; wrong += share + 0 < last; last = share + 0
            wrong += length($0) > 79; estimates += / left$/ }
        END { exit !(bars > 1 && wrong == 0 && estimates > 0) }' "$results/lines"
}

cube >cube.off
# Long enough on any machine: text of some hundred megabytes, tiles one after the other.
on_terminal "$kith" refine cube.off -s catmull-clark -n 10 -o fine.off --threads 1
exits 0
shows '^writing \[#+\.*\] [0-9]+ %, [0-9]+ (s|min [0-9]+ s) left$'
shares_grow writing
leaves_no_bar
prints '^fine.off: 6291458 vertices, 12582912 edges, 6291456 faces$'

# Notes are whole lines, without the bar.
sed '1s/.*/COFF/; 4s/$/ 1 0 0/' fine.off >tinted.off
on_terminal "$kith" refine tinted.off -s catmull-clark -n 0 -o tinted.ply --binary
exits 0
shows '^reading \[#+\.*\] [0-9]+ %, '
shares_grow reading
shows '^kith: note: tinted.ply: this format cannot mark missing values; it has 0 for: the colours of 6291457 of 6291458 vertices$'
leaves_no_bar
rm -f tinted.off tinted.ply

on_terminal "$kith" refine cube.off -s doo-sabin -n 10 -o fine.vtu --tiles 6 --threads 1
exits 0
shows '^refining tiles \[#*\.*\] [0-9]+ %'
leaves_no_bar

# Nothing of it where nobody looks, with --json, on terminals that cannot erase, and when it is over soon.
on_terminal "$kith" refine fine.off -s catmull-clark -n 0 -o copy.ply --binary --json
exits 0
check "nothing is shown" test ! -s "$results/screen"
on_terminal env TERM=dumb "$kith" refine fine.off -s catmull-clark -n 0 -o copy.ply --binary
exits 0
check "nothing is shown" test ! -s "$results/screen"
run refine fine.off -s catmull-clark -n 0 -o copy.ply --binary
exits 0
says_nothing
on_terminal "$kith" refine cube.off -s catmull-clark -n 1 -o copy.ply
exits 0
check "nothing is shown" test ! -s "$results/screen"
rm -f fine.off fine.vtu copy.ply

# Ctrl-C: the exit code of the signal, no bar and no file; what was there is as it was.
cp cube.off old.off
for arguments in "cube.off -s catmull-clark -n 11 -o old.off" "cube.off -s catmull-clark -n 11 -o new.off" \
    "cube.off -s catmull-clark -n 11 -o new.vtu --tiles 40 --threads 1"; do
    on_terminal --interrupt "$kith" refine $arguments
    exits 130
    leaves_no_bar
    leaves cube.off old.off
    same cube.off old.off
done

# On ranks, of which rank 0 shows its share; mpirun passes it on.
if [ -n "${2:-}" ] && command -v mpirun >/dev/null; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_pml=ob1
    on_terminal mpirun -n 2 "$2" refine cube.off -s doo-sabin -n 10 -o ranks.vtu --tiles-per-rank 10
    exits 0
    shows 'refining tiles \[#*\.*\] [0-9]+ %'
    prints '^ranks.vtu: '
    timeout 120 mpirun -n 2 "$2" refine cube.off -s catmull-clark -n 8 -o ranks.vtu >"$results/out" 2>"$results/err"
    code=$?
    exits 0
    says_nothing
fi
finish
