# SPDX-License-Identifier: BSD-3-Clause
# Sourced by every test here with the path of the program as $1: runs it in an empty directory of its own and compares
# what it does with what it should do. Each test ends with `finish`.
set -u
kith=$1
results=$(mktemp -d)
work=$(mktemp -d)
trap 'rm -rf "$results" "$work"' EXIT
cd "$work" || exit 1
failures=0
checks=0

# run ARGUMENTS...: remembers exit code, standard output and standard error.
run() {
    command="kith $*"
    timeout 60 "$kith" "$@" >"$results/out" 2>"$results/err" </dev/null
    code=$?
}

# run_from FILE ARGUMENTS...: the same with FILE on standard input.
run_from() {
    local input=$1
    shift
    command="kith $* < $input"
    timeout 60 "$kith" "$@" >"$results/out" 2>"$results/err" <"$input"
    code=$?
}

check() { # check WHAT CONDITION...: fails unless the condition holds
    local what=$1
    shift
    checks=$((checks + 1))
    "$@" && return
    failures=$((failures + 1))
    echo "line ${BASH_LINENO[1]}: $command (exit code $code): $what"
    sed 's/^/    out: /' "$results/out"
    sed 's/^/    err: /' "$results/err"
}

exits() { check "should exit with $1" test "$code" -eq "$1"; }
prints() { check "should print '$1'" grep -qE -- "$1" "$results/out"; }
prints_nothing() { check "should print nothing" test ! -s "$results/out"; }
says() { check "should say '$1'" grep -qE -- "$1" "$results/err"; }
says_nothing() { check "should say nothing" test ! -s "$results/err"; }
same() { check "$1 and $2 should be the same" cmp -s "$1" "$2"; }
has() { check "$1 should have a line '$2'" grep -qE -- "$2" "$1"; }
# leaves FILES...: these and no others are in the directory.
leaves() { check "should leave only: $*" test "$(ls -A | tr '\n' ' ')" = "$(printf '%s\n' "$@" | sort | tr '\n' ' ')"; }
only_input_left() { check "should leave nothing but its input, there is: $(ls -A)" test "$(ls -A)" = "$1"; }

finish() {
    echo "$checks checks, $failures failed"
    test "$checks" -gt 0 && test "$failures" -eq 0
    exit
}

cube() {
    cat <<'END'
OFF
8 6 12
-1 -1 -1
1 -1 -1
1 1 -1
-1 1 -1
-1 -1 1
1 -1 1
1 1 1
-1 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END
}

tetrahedron() {
    cat <<'END'
OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
END
}
