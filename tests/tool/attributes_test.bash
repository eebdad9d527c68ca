# SPDX-License-Identifier: BSD-3-Clause
# What files say of their meshes besides places: through all formats, and refined.
meshes=$(cd "$(dirname "$0")/../../.." && pwd)/shared/meshes # which are not ours; without them their part is left out
source "$(dirname "$0")/check.bash"
source "$(dirname "$0")/attribute_meshes.bash"

# textured FILE N FACES: each corner of the file has the texture of its group at its place, with N groups in FACES faces.
textured() {
    check "$1 should have the texture of each face" awk -v groups="$2" -v faces="$3" '
        function off(a, b) { return a - b > 1e-12 * (1 + b * b) || b - a > 1e-12 * (1 + b * b) }
        $1 == "v" { x[++v] = $2; y[v] = $3 }
        $1 == "vt" { s[++t] = $2; r[t] = $3 }
        $1 == "g" { group = substr($2, 6); seen[group] = 1 }
        $1 == "usemtl" { material = $2 }
        $1 == "f" {
            ++n
            wrong += material != (group % 3 ? "red" : "blue")
            for (i = 2; i <= NF; ++i) {
                split($i, c, "/")
                wrong += off(s[c[2]], x[c[1]] + 10 * group) + off(r[c[2]], 2 * y[c[1]] - x[c[1]] + group)
            }
        }
        END { for (g in seen) ++found; exit !(wrong == 0 && n == faces && found == groups) }' "$1"
}
grid 3 >grid.obj
for mesh in native cgal openmesh; do
    for form in "0 9" "1 36" "3 576"; do
        run refine grid.obj -s linear -n ${form% *} -o $mesh.obj --mesh $mesh
        exits 0
        says_nothing
        textured $mesh.obj 9 ${form#* }
        has $mesh.obj '^mtllib paint.mtl$'
        has $mesh.obj '^o sheet$'
    done
done
textured grid.obj 9 9
same native.obj cgal.obj
same native.obj openmesh.obj
run refine grid.obj -s linear-triangles -n 2 -o out.obj --triangulate
exits 0
textured out.obj 9 288
run refine grid.obj -s 4-8 -n 0 -o out.obj
exits 0
textured out.obj 9 18
(cat grid.obj; echo 't hole 2/0/0 0 4') >holes.obj
run refine holes.obj -s catmull-clark -n 0 -o out.obj
exits 0
textured out.obj 7 7
check "the colour is that of the vertex" awk '$1 == "v" { d = $5 - ($2 + $3) / 9; wrong += d * d > 1e-24 } END { exit wrong > 0 }' out.obj

# A face that has texture coordinates at some corners has none in PLY, which is told.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3 4\n' >part.obj
run refine part.obj -s catmull-clark -n 0 -o part.ply
exits 0
says 'part.obj: not kept: texture coordinates of faces where some corners have none'

# What is made of a vertex that has no colour has none.
printf 'COFF\n4 4 0\n0 0 0 200 10 10 255\n1 0 0\n0 1 0 10 200 10 255\n0 0 1 10 10 200 255\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' >gap.off
run refine gap.off -s loop -n 1 -o out.ply
exits 0
says 'not kept: colours around vertices without a value'
run refine gap.off -s loop -n 0 -o out.off
exits 0
says_nothing

# Words end no line and let none go on.
cat >words.ply <<'END'
ply
format ascii 1.0
comment mtllib C:\tex\
comment word material 1 C:\red\
comment word material 2 #2 of #3
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
property int material
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2 1
3 0 2 3 2
END
run refine words.ply -s loop -n 0 -o words.obj
exits 0
run info words.obj
prints 'face degrees +3 to 3 .2 of 3.'
has words.obj '^usemtl C:.red.*_$'
has words.obj '^usemtl _2 of _3$' # no comment

# Creases stay beside holes, by the numbers that are left.
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 1\nv 3 1 0\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nt hole 1/0/0 0\nt crease 2/1/0 2 6 2.5\nt corner 1/1/0 6 3\n' >creased.obj
run refine creased.obj -s catmull-clark -n 0 -o out.obj
exits 0
has out.obj '^t crease 2/1/0 1 4 2\.5$'
has out.obj '^t corner 1/1/0 4 3$'
run refine creased.obj -s catmull-clark -n 1 -o out.obj
exits 0
check "both halves of the crease are there" test "$(grep -c '^t crease 2/1/0 .* 1.5$' out.obj)" -eq 2

# The rule of corners at the boundary, which only OBJ holds.
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n' >flat.obj
for rule in 1 2; do
    (cat flat.obj; echo "t interpolateboundary 1/0/0 $rule") >ruled.obj
    run refine ruled.obj -s catmull-clark -n 1 -o out.obj
    kept=$(grep -c '^t interpolateboundary' out.obj)
    for format in ply off vtu; do
        run refine ruled.obj -s catmull-clark -n 1 -o out.$format
        exits 0
        check "what OBJ keeps is told" test "$(grep -c 'the rule for boundary corners' "$results/err")" -eq "$kept"
    done
done

# A file that is read and written has the same lines from then on, and refining it twice by one level is refining it by two.
corners() { # corners FILE: what each corner is, in digits that do not end where short numbers do
    awk 'function near(x) { return sprintf("%.10f", x + 3.14159265e-11) }
        $1 == "v" { p[++v] = near($2) " " near($3) " " near($4) " " near($5) " " near($6) }
        $1 == "vt" { q[++t] = near($2) " " near($3) }
        $1 ~ /^(g|o|s|usemtl)$/ { word[$1] = $2 }
        $1 == "f" { for (i = 2; i <= NF; ++i) { split($i, c, "/"); print p[c[1]], q[c[2]], word["g"], word["s"], word["usemtl"] } }' "$1" | sort
}
twice() { # twice FILE SCHEME
    run refine $1 -s $2 -n 0 -o copy.obj
    exits 0
    says_nothing
    check "nothing is lost of $1" test "$(corners $1 | md5sum)" = "$(corners copy.obj | md5sum)"
    run refine copy.obj -s $2 -n 0 -o copy2.obj
    same copy.obj copy2.obj
    run refine $1 -s $2 -n 1 -o once.obj
    run refine once.obj -s $2 -n 1 -o by_steps.obj
    exits 0
    run refine $1 -s $2 -n 2 -o at_once.obj
    check "by steps is at once" test "$(corners by_steps.obj | md5sum)" = "$(corners at_once.obj | md5sum)"
    check "with as many seams" test "$(grep -c '^vt' by_steps.obj)" -eq "$(grep -c '^vt' at_once.obj)"
    for kind in '' --binary; do # through PLY, too
        # shellcheck disable=SC2086 # no word where it is empty
        run refine $1 -s $2 -n 0 -o through.ply $kind
        exits 0
        says_nothing
        run refine through.ply -s $2 -n 0 -o back.obj
        exits 0
        says_nothing
        same copy.obj back.obj
        # shellcheck disable=SC2086
        run refine $1 -s $2 -n 1 -o through.ply $kind
        run refine through.ply -s $2 -n 1 -o back.obj
        same by_steps.obj back.obj
    done
}
twice grid.obj catmull-clark
if [ -f "$meshes/fish_control_mesh.obj" ]; then
    cp "$meshes/fish_control_mesh.obj" fish.obj
    twice fish.obj catmull-clark
    check "the seam of the fish is whole" test "$(grep -c '^vt' copy.obj)" -eq "$(grep -c '^vt' fish.obj)"
fi

# PLY has numbers at faces, and words for them where others skip what they do not know.
for mesh in native cgal openmesh; do
    run refine grid.obj -s linear -n 1 -o $mesh.ply --mesh $mesh
    exits 0
    says_nothing
done
same native.ply cgal.ply
same native.ply openmesh.ply
has native.ply '^comment mtllib paint.mtl$'
has native.ply '^comment word object 1 sheet$'
has native.ply '^comment word group 9 cell_8$'
has native.ply '^comment word smoothing_group 3 3$'
check "materials" test "$(grep -c '^comment word material ' native.ply)" -eq 2
check "faces have their numbers" awk '
    $1 == "element" && $2 == "face" { faces = $3 }
    $1 == "property" && $2 == "int" { names = names " " $3 }
    $1 == "4" && NF == 18 { f = int(n / 4); ++n; wrong += $15 != 1 || $16 != f + 1 || $17 != 1 + (f % 3 > 0) || $18 != int(f / 3) + 1 }
    END { exit !(wrong == 0 && n == faces && n == 36 && names == " object group material smoothing_group") }' native.ply

# PLY: all numbers of vertices and faces, in their types. Those that say where a vertex is stay there, by the masks.
rich_cube >rich.ply
for mesh in native cgal openmesh; do
    run refine rich.ply -s catmull-clark -n 2 -o $mesh.ply --mesh $mesh
    exits 0
    says "^kith: note: rich.ply: not kept: the property 'others' of faces$"
done
same native.ply cgal.ply
same native.ply openmesh.ply
header='x y z px red pz green blue id '
check "the same properties" test "$(awk '/^element face/ { exit } $1 == "property" { printf "%s ", $3 }' native.ply)" = "$header"
for line in 'property double px' 'property uchar red' 'property int id' 'property ushort patch' 'property double area' \
    'property list uchar float texcoord'; do
    has native.ply "^$line\$"
done
check "values are where they should be" awk '
    body && NF == 9 && ++v < 99 {
        d = $5 - 127.5 - 127.5 * $1
        wrong += $1 != $4 || $3 != $6 || d * d > 0.2501 || $5 != int($5) || $7 != 7 || $8 != 9 || $9 != 1000
    }
    body && v == 99 && NF == 9 { wrong += $0 != "5 5 5 5 1 5 2 3 -4" }
    body && NF == 16 { ++f; ++faces[$15]; wrong += $15 != 4 * $16 }
    $1 == "end_header" { body = 1 }
    END { for (id in faces) wrong += faces[id] != 16; exit !(wrong == 0 && v == 99 && f == 96) }' native.ply
run refine rich.ply -s catmull-clark -n 2 -o binary.ply --binary
run refine binary.ply -s catmull-clark -n 0 -o out.ply
same out.ply native.ply
run refine rich.ply -s catmull-clark -n 0 -o out.ply --drop-isolated
check "the isolated vertex is gone" test "$(grep -c '^5 5 5' out.ply)" -eq 0
has out.ply '^element vertex 8$'
run refine rich.ply -s catmull-clark -n 1 -o out.obj
exits 0
says "not kept: the property 'others' of faces, the property 'px' of vertices, the property 'pz' of vertices, the property 'id' of vertices, the property 'patch' of faces, the property 'area' of faces$"
has out.obj '^v -0.5555555555555556 -0.5555555555555556 -0.5555555555555556 0.2235294117647[0-9]* 0.027[0-9]* 0.035[0-9]*$'
run refine rich.ply -s catmull-clark -n 1 -o out.off
has out.off '^COFF$'
has out.off '^-0.5555555555555556 -0.5555555555555556 -0.5555555555555556  57 7 9 255$'

# OFF: normals are those of the file only where the mesh is, or those of the limit.
printf 'CNOFF\n4 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 0 0 255\n1 1 0 0 0 1 0 0 0 255\n0 1 0 0 0 1 0 0 0 5\n4 0 1 2 3 .5 1 0\n' >quad.off
run refine quad.off -s linear -n 0 -o out.off
exits 0
says_nothing
has out.off '^0 1 0 0 0 1  0 0 0 5$'
has out.off '^4  0 1 2 3  0.5 1.0 0.0 1.0$'
run refine quad.off -s linear -n 1 -o out.off
says '^kith: note: quad.off: not kept: normals$'
has out.off '^COFF$'
has out.off '^0.5 0.5 0  64 0 0 193$'
check "all faces have the color" test "$(grep -c '  0.5 1.0 0.0 1.0$' out.off)" -eq 4
run refine quad.off -s catmull-clark -n 1 -o out.off --limit
says_nothing
has out.off '^CNOFF$'
check "the normals are those of the limit" test "$(grep -cE '^[^4].*  -?0 -?0 1  [0-9]* 0 0 [0-9]*$' out.off)" -eq 9
run refine quad.off -s linear-triangles -n 1 -o out.stl --triangulate
exits 0
says 'not kept: normals, colours, colours of faces$'

# Texture coordinates that are as smooth as the surface: two squares, each with the whole texture. Where a chart has a single face at
# a vertex, it is a corner unless nothing is to be linear.
cat >charts.obj <<'END'
v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 5/3 4/4
f 2/1 3/2 6/3 5/4
END
for mesh in native cgal openmesh; do
    for word in none corners corners+1 corners+2 boundaries all; do
        run refine charts.obj -s catmull-clark -n 1 -o $mesh.obj --mesh $mesh --uv $word
        exits 0
        says_nothing
        has $mesh.obj '^vt 0.5 0.5$'
        has $mesh.obj '^vt 0 0$'
        check "the corner at the seam" test "$(grep -c '^vt 0.875 0.125$' $mesh.obj)" -eq $([ $word = none ] && echo 1 || echo 0)
    done
    run refine charts.obj -s catmull-clark -n 1 -o linear.obj --mesh $mesh
    same linear.obj $mesh.obj
done
run refine charts.obj -s linear -n 1 -o out.obj --uv none
exits 0
same out.obj linear.obj
run refine charts.obj -s doo-sabin -n 1 -o out.obj --uv none
exits 2
says '^kith: --uv: only catmull-clark, loop and quad-tri have rules for seams of texture coordinates; leave it out, or use all$'
run refine charts.obj -s doo-sabin -n 1 -o out.obj --uv all
exits 0
run refine charts.obj -s loop -n 1 -o out.obj --uv round
exits 2
says "^kith: --uv: 'round' is not one of none, corners, corners.1, corners.2, boundaries, all$"
finish
