# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# near LINE FILE NUMBERS...: the numbers of that line of a text file, to 1e-15.
near() {
    local line=$1 file=$2
    shift 2
    sed -n "${line}p" "$file" | awk -v wanted="$*" 'function away(a, b) { return a > b ? a - b : b - a }
        { n = split(wanted, w, " "); good = NF >= n
          for (i = 1; i <= n; ++i) good = good && away($i, w[i]) < 1e-15
          exit !good }'
}

# Catmull-Clark on the cube: its corners come to one half, normals along the diagonals; the points of the faces, which are
# symmetric, have the normals of the faces. (9 + 4 - 1)/24 is the mask of Halstead, Kass & DeRose for n = 3.
third=0.577350269189625764
run refine cube.off -s catmull-clark -n 1 --limit -o limit.off
exits 0
says_nothing
prints '^limit.off: 26 vertices, 48 edges, 24 faces$'
check "says that there are normals" test "$(head -n 1 limit.off)" = NOFF
check "the first vertex" near 4 limit.off -0.5 -0.5 -0.5 -$third -$third -$third
check "the middle of a face" grep -qxE -- '-?0 -?0 -0.[0-9]+  -?0 -?0 -1' limit.off
run refine cube.off -s catmull-clark -n 0 --limit -o coarse.off
check "the limit is the same on all levels" near 4 coarse.off -0.5 -0.5 -0.5 -$third -$third -$third

# Other formats: v and vn with references to them, properties of PLY, and nothing in STL, which has no room.
run refine cube.off -s catmull-clark -n 1 --limit -o limit.obj
exits 0
check "26 normals" test "$(grep -c '^vn ' limit.obj)" -eq 26
check "faces refer to them" grep -qxE 'f  3//3 [0-9]+//[0-9]+ .*' limit.obj
check "26 places" test "$(grep -c '^v ' limit.obj)" -eq 26
run refine cube.off -s catmull-clark -n 1 --limit -o limit.ply
exits 0
for name in nx ny nz; do has limit.ply "^property double $name$"; done
body=$(grep -n end_header limit.ply | cut -d: -f1)
check "the first vertex" near $((body + 1)) limit.ply -0.5 -0.5 -0.5 -$third -$third -$third
run refine cube.off -s catmull-clark -n 1 --limit --binary -o binary.ply
exits 0
for file in limit.obj limit.ply binary.ply; do
    run compare limit.off $file --tolerance 0
    exits 0
    says_nothing
done
run refine tetra.off -s loop -n 1 --limit -o limit.stl
exits 0
run refine tetra.off -s loop -n 1 --limit -o loop.off
run compare loop.off limit.stl --tolerance 0
exits 0
# Loop at n = 3: beta = 3/16, so every neighbor weighs 1/5.
check "Loop's vertex" near 4 loop.off 0.2 0.2 0.2 -$third -$third -$third

# Without --limit nothing changes, and all kinds of meshes give the same bits, of all schemes.
run refine cube.off -s catmull-clark -n 1 -o plain.off
check "no normals" test "$(head -n 1 plain.off)" = OFF
run schemes
sed -n 's/^\([a-z0-9-]*\)  *\(triangles\|quads\|any polygons\|closed meshes\) .*/\1 \2/p' "$results/out" >list
check "all schemes" test "$(wc -l <list)" -ge 14
while read -r scheme takes; do
    input=cube.off
    test "$takes" = triangles && input=tetra.off
    run refine $input -s "$scheme" -n 2 --limit -o native.off
    exits 0
    says_nothing
    check "normals of length one" awk 'NF == 6 { size = $4 * $4 + $5 * $5 + $6 * $6
        if (size < 1 - 1e-14 || size > 1 + 1e-14) bad = 1 } END { exit bad }' native.off
    for mesh in cgal openmesh; do
        run refine $input -s "$scheme" -n 2 --limit --mesh $mesh -o $mesh.off
        exits 0
        same native.off $mesh.off
    done
    # Tiles: the same surface, the same normals, the same bytes however it is cut.
    test "$scheme" = unified && continue
    test "$scheme" = interpolatory-sqrt3 && continue
    test "$scheme" = quad-tri && continue
    run refine $input -s "$scheme" -n 2 --limit --binary -o native.ply
    exits 0
    for tiles in 1 3; do
        run refine $input -s "$scheme" -n 2 --limit --tiles $tiles -o tiles.ply
        exits 0
        for name in nx ny nz; do has tiles.ply "^property double $name$"; done
        run compare native.ply tiles.ply --tolerance 0
        exits 0
        run refine $input -s "$scheme" -n 2 --limit --tiles $tiles -o $tiles.vtu
        exits 0
        has $tiles.vtu '<PointData Normals="Normals">'
    done
    same 1.vtu 3.vtu
done <list
run refine cube.off -s catmull-clark -n 2 --limit --tiles 2 -o limit.pvtu
exits 0
has limit.pvtu 'PDataArray type="Float64" Name="Normals" NumberOfComponents="3"'
has limit.pieces/0.vtu 'Normals="Normals"'

# The linear scheme stays where it is; its normals are the means of the faces'.
run refine cube.off -s linear -n 0 --limit -o linear.off
check "the corner of a cube" near 4 linear.off -1 -1 -1 -$third -$third -$third

# A boundary: the curve's mask 1/6, 2/3, 1/6; corners stay, with the normal of the plane of their edges.
printf 'OFF 6 2 0\n0 0 0\n2 0 0\n4 0 0\n0 2 1\n2 2 1\n4 2 1\n4 0 1 4 3\n4 1 2 5 4\n' >strip.off
run refine strip.off -s catmull-clark -n 0 --limit -o strip_limit.off
exits 0
says_nothing
check "a corner" near 4 strip_limit.off 0 0 0 0 -0.447213595499957939 0.894427190999915878
check "a boundary vertex" near 5 strip_limit.off 2 0 0 0 -0.447213595499957939 0.894427190999915878

# Where no mask is known at once it is found all the same: the first step gives a triangle mesh its masks.
run refine tetra.off -s catmull-clark -n 0 --limit -o coarse.off
exits 0
says_nothing
run refine tetra.off -s catmull-clark -n 1 --limit -o fine.off
sed -n 4,7p coarse.off | tr -s " " >first
sed -n 4,7p fine.off | tr -s " " >second
check "four vertices" test "$(wc -l <first)" -eq 4
check "the same limits" near 2 first $(sed -n 2p second | cut -d' ' -f1-3)

# The size of coordinates does not matter to normals.
for size in 1e-160 1e160; do
    sed "3,10s/1/$size/g" cube.off >sized.off
    run refine sized.off -s catmull-clark -n 1 --limit -o sized_limit.off
    exits 0
    check "no number that is none" test "$(grep -ciE 'nan|inf' sized_limit.off)" -eq 0
    check "the normals" near 4 <(cut -d' ' -f4- sized_limit.off | tr -s ' ') -$third -$third -$third
done

# Infinitely sharp edges: each side has its normals. On a cube whose edges are all sharp they are those of its faces.
printf '%s\n' 'v -1 -1 -1' 'v 1 -1 -1' 'v 1 1 -1' 'v -1 1 -1' 'v -1 -1 1' 'v 1 -1 1' 'v 1 1 1' 'v -1 1 1' \
    'f 1 4 3 2' 'f 5 6 7 8' 'f 1 2 6 5' 'f 2 3 7 6' 'f 3 4 8 7' 'f 4 1 5 8' >hard.obj
for ends in 0/1 1/2 2/3 3/0 4/5 5/6 6/7 7/4 0/4 1/5 2/6 3/7; do
    echo "t crease 2/1/0 ${ends/\// } 10" >>hard.obj
done
run refine hard.obj -s catmull-clark -n 2 --limit -o hard_limit.obj
exits 0
says_nothing
# Every corner of a face has a normal of unit length along an axis, and it is that of the face's side of the cube.
check "normals of the sides" awk '/^v / { for (i = 2; i < 5; ++i) v[nv + 0, i] = $i; ++nv }
    /^vn / { for (i = 2; i < 5; ++i) n[nn + 0, i] = $i; ++nn }
    /^f / { ++faces
        for (c = 2; c <= NF; ++c) {
            split($c, w, "//"); off = 0
            for (i = 2; i < 5; ++i) if (n[w[2] - 1, i] * n[w[2] - 1, i] > 1e-20) { ++off; axis = i }
            if (off != 1 || v[w[1] - 1, axis] * n[w[2] - 1, axis] < 1 - 1e-12) bad = 1
        } }
    END { exit bad || faces != 96 }' hard_limit.obj
for mesh in cgal openmesh; do
    run refine hard.obj -s catmull-clark -n 2 --limit --mesh $mesh -o $mesh.obj
    exits 0
    same hard_limit.obj $mesh.obj
done
run refine hard.obj -s catmull-clark -n 2 --limit --binary -o hard.ply
exits 0
has hard.ply '^property list uchar double normal$'
for tiles in 1 3; do
    run refine hard.obj -s catmull-clark -n 2 --limit --tiles $tiles -o hard_tiles.ply
    exits 0
    same hard.ply hard_tiles.ply
done
run refine hard.obj -s catmull-clark -n 2 --limit -o hard.off
exits 0
says 'not kept: separate normals for the two sides of sharp edges'
run refine hard.obj -s catmull-clark -n 2 --limit --tiles 2 -o hard.vtu
exits 0
says 'not kept: .*separate normals for the two sides of sharp edges'
# Other meshes have the normals of their vertices alone.
run refine cube.off -s catmull-clark -n 1 --limit -o soft.ply
check "no normals of corners" test "$(grep -c '^property list .* normal$' soft.ply)" -eq 0

# A smoothed corner has the plane of its two edges, after any number of steps.
printf 'OFF 9 4 0\n0 0 0\n1 0 1\n2 0 4\n0 1 1\n1 1 2\n2 1 5\n0 2 4\n1 2 5\n2 2 8\n4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n' >bowl.off
for levels in 0 1 2 3; do
    run refine bowl.off -s catmull-clark -n $levels --boundary-corners smoothed --limit -o bowl_limit.off
    exits 0
    check "the normal after $levels steps" near 4 <(cut -d' ' -f5- bowl_limit.off) -$third -$third $third
done
finish
