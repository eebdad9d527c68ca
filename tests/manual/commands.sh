#!/usr/bin/env bash
# commands.sh ROOT BIN WORK: runs the command lines of the documentation that begin with kith, in a folder with a cube.obj that has texture
# coordinates. Those of kith-mpi run where it is built.
set -euo pipefail
root=$1 bin=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
cat >cube.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 3/2 4/3 2/4
f 5/1 6/2 8/3 7/4
f 1/1 2/2 6/3 5/4
f 3/1 7/2 8/3 4/4
f 1/1 5/2 7/3 3/4
f 2/1 4/2 8/3 6/4
t crease 2/1/0 0 1 10
END
export PATH=$bin:$PATH
count=0
while IFS= read -r line; do
    case $line in
    kith\ *) ;;
    mpirun*) [ -x "$bin/kith-mpi" ] || continue ;;
    *) continue ;;
    esac
    echo "$line"
    # Pages need a compiler for WebAssembly, which is not everywhere.
    "$root/tests/mpi/apart.sh" bash -c "$line" >log 2>&1 </dev/null || grep "built without its page" log || { cat log && exit 1; }
    count=$((count + 1))
done < <(find "$root/docs" "$root/README.md" -name '*.md' -exec awk '/^```sh/ {f = 1; next} /^```/ {f = 0} f' {} +)
echo "$count commands"
[ "$count" -ge 9 ]
