# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# The corners of the cube come to one half, as with --limit.
run tessellate cube.off -s catmull-clark --segments 2 -o out.off
exits 0
says_nothing
prints '^out.off: 26 vertices, 48 triangles$'
check "says that there are normals" test "$(head -n 1 out.off)" = NOFF
check "has a corner of the cube at its limit" test "$(sed -n 4p out.off | awk '{ printf "%.9f %.9f %.9f", $1, $2, $3 }')" = \
    "-0.500000000 -0.500000000 -0.500000000"
run tessellate cube.off -s catmull-clark --segments 2 -o out.obj
exits 0
check "has a normal per vertex" test "$(grep -c '^vn ' out.obj)" -eq 26
run info out.obj
exits 0
prints 'boundary loops +0$'

# Fine by error, length or angle; triangles for Loop.
for fine in "--chord-error 0.01" "--longest-edge 0.2" "--angle 10"; do
    run tessellate tetra.off -s loop $fine -o fine.ply --binary --json
    exits 0
    prints '^\{"scheme":"loop","vertices":[0-9]{2,},"faces":[0-9]{2,},"output":"fine.ply"\}$'
    run info fine.ply
    exits 0
    prints 'Euler characteristic +2$'
done
run_from cube.off tessellate - -s catmull-clark --segments 3 -o -
exits 0
check "writes OFF to standard output" test "$(head -n 1 "$results/out")" = NOFF

# Creases of a file count, holes are left out, values of vertices and faces go along, texture coordinates are named.
{
    sed -n '3,10s/^/v /p' cube.off
    echo 'vt 0 0'
    echo 'usemtl red'
    sed -n '11,16p' cube.off | while read -r _ a b c d; do
        echo "f $((a + 1))/1 $((b + 1))/1 $((c + 1))/1 $((d + 1))/1"
    done
    echo 't hole 1/0/0 0'
} >tagged.obj
run tessellate tagged.obj -s catmull-clark --segments 2 -o tagged_out.obj
exits 0
says 'texture coordinates'
prints '^tagged_out.obj: 25 vertices, 40 triangles$'
has tagged_out.obj '^usemtl red$'
cat >valued.ply <<'END'
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
property double quality
element face 4
property list uchar int vertex_indices
end_header
1 1 1 1
1 -1 -1 2
-1 1 -1 3
-1 -1 1 4
3 0 1 2
3 0 3 1
3 0 2 3
3 1 3 2
END
run tessellate valued.ply -s loop --segments 2 -o valued_out.ply
exits 0
says_nothing
has valued_out.ply '^property double quality$'

wrong() { # wrong MESSAGE ARGUMENTS...
    local message=$1
    shift
    run tessellate "$@"
    exits 2
    says "$message"
    prints_nothing
}
wrong 'name --chord-error, --longest-edge, --angle or --segments' cube.off -s catmull-clark -o no.off
wrong '--chord-error: give a positive number' cube.off -s catmull-clark --chord-error -1 -o no.off
wrong '--angle: give a positive number' cube.off -s catmull-clark --angle inf -o no.off
wrong 'segments' cube.off -s catmull-clark --segments 0 -o no.off
wrong 'segments' cube.off -s catmull-clark --segments 100000 -o no.off
wrong "'doo-sabin' is not possible here; the schemes are catmull-clark and loop" cube.off -s doo-sabin --segments 2 -o no.off
wrong '--binary: only PLY and STL are either text or binary; leave it out for no.off' cube.off -s loop --segments 2 --binary -o no.off
wrong 'levels' cube.off -s catmull-clark --levels 2 --segments 2 -o no.off
run tessellate cube.off -s loop --segments 2 -o no.off
exits 1
says 'triangulate'
run tessellate cube.off -s catmull-clark --chord-error 1e-12 -o no.off
exits 1
says 'an edge would have more than 4096 segments; ask for less'
check "leaves nothing behind" test ! -e no.off
finish
