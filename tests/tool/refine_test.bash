# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# at LINE FILE X Y Z: the vertex in that line of an OFF file, to 1e-15.
at() {
    sed -n "$1p" "$2" | awk -v x="$3" -v y="$4" -v z="$5" 'function away(a, b) { return a > b ? a - b : b - a }
        { exit !(NF == 3 && away($1, x) < 1e-15 && away($2, y) < 1e-15 && away($3, z) < 1e-15) }'
}

# Catmull-Clark on the cube: vertices at 5/9, edge points at 3/4, face points where they were.
run refine cube.off -s catmull-clark -n 1 -o out.off
exits 0
says_nothing
prints '^out.off: 26 vertices, 48 edges, 24 faces$'
check "has one line on standard output" test "$(wc -l <"$results/out")" -eq 1
check "first vertex" at 4 out.off -0.555555555555555556 -0.555555555555555556 -0.555555555555555556
check "an edge point" grep -qxE -- '0 -0.75 -0.75' out.off
check "a face point" grep -qxE -- '0 0 -1' out.off
check "the shortest digits that read back as the same number" grep -qxE -- '(-?0\.5555555555555556 ?){3}' out.off
leaves cube.off out.off tetra.off

# Loop on the tetrahedron: valence 3 has weight 3/16, so its vertex 0 comes to 7/16 of 0 + 3/16 of each neighbor.
run refine tetra.off -s loop -n 1 -o out.off
exits 0
prints '10 vertices, 24 edges, 16 faces'
check "first vertex" at 4 out.off 0.1875 0.1875 0.1875
# sqrt(3): alpha(3) = 5/9; the new vertex of a face is its center.
run refine tetra.off -s sqrt3 -n 1 -o out.off
exits 0
prints '8 vertices, 18 edges, 12 faces'
check "first vertex" at 4 out.off 0.185185185185185185 0.185185185185185185 0.185185185185185185
check "a face point" at 10 out.off 0.333333333333333333 0.333333333333333333 0.333333333333333333
# Doo-Sabin on quads: 9/16, 3/16, 1/16, 3/16; the corner of a face of the cube comes to half.
run refine cube.off -s doo-sabin -n 1 -o out.off
exits 0
prints '24 vertices, 48 edges, 26 faces'
check "a corner point" grep -qxE -- '-0.5 -0.5 -1' out.off

# The unified scheme, degree 3: the corner comes to 1/2 + 1/4 of 1/3 + 1/4 of 1/3; degree 2 is Doo-Sabin.
run refine cube.off -s unified -n 1 -o out.off
exits 0
prints '26 vertices, 48 edges, 24 faces'
check "first vertex" at 4 out.off -0.666666666666666667 -0.666666666666666667 -0.666666666666666667
run refine cube.off -s unified --degree 2 -n 1 -o out.off
exits 0
prints '24 vertices, 48 edges, 26 faces'
check "a corner point" grep -qxE -- '-0.5 -0.5 -1' out.off

# Refining twice is refining once and once more, and level 0 is the mesh itself.
run refine cube.off -s catmull-clark -n 2 -o twice.off
run refine cube.off -s catmull-clark -n 1 -o once.off
run refine once.off -s catmull-clark -n 1 -o again.off
exits 0
run compare twice.off again.off --tolerance 1e-15
exits 0
run refine cube.off -s catmull-clark -n 0 -o same.off
exits 0
prints '8 vertices, 12 edges, 6 faces'
run compare cube.off same.off --tolerance 0
exits 0

# Every scheme that `kith schemes` lists runs, on what it takes, with the same bits on every kind of mesh.
run schemes
sed -n 's/^\([a-z0-9-]*\)  *\(triangles\|quads\|any polygons\|closed meshes\) .*/\1 \2/p' "$results/out" >list
check "there are some" test "$(wc -l <list)" -ge 4
while read -r scheme takes; do
    input=cube.off
    test "$takes" = triangles && input=tetra.off
    run plan $input -s "$scheme" -n 2
    exits 0
    counts=$(tail -n 2 "$results/out" | head -n 1 | awk '{ print $2 " vertices, " $3 " edges, " $4 " faces" }')
    for mesh in native cgal openmesh; do
        run refine $input -s "$scheme" -n 2 --mesh $mesh -o $mesh.off
        exits 0
        prints "^$mesh.off: $counts\$"
    done
    same native.off cgal.off
    same native.off openmesh.off
    run info native.off
    exits 0
    prints '^Euler characteristic +2$'
done <list
for scheme in catmull-clark doo-sabin; do
    for mesh in native cgal openmesh; do
        run refine cube.off -s $scheme -n 3 --mesh $mesh -o $mesh.off
        exits 0
    done
    same native.off cgal.off
    same native.off openmesh.off
done
cat >strip.off <<'END'
OFF
6 4 0
0 0 0
1 0 0
2 0 0.5
0 1 0
1 1 0.25
2 1 0
3 0 1 4
3 0 4 3
3 1 2 5
3 1 5 4
END
for scheme in loop sqrt3; do
    for mesh in native cgal openmesh; do
        run refine strip.off -s $scheme -n 2 --mesh $mesh -o $mesh.off
        exits 0
    done
    same native.off cgal.off
    same native.off openmesh.off
done

# Choices reach the scheme: a corner stays or is smoothed, and a preset decides for itself.
run refine strip.off -s loop -n 1 -o kept.off --boundary-corners kept
exits 0
check "the corner stays" at 6 kept.off 2 0 0.5
run refine strip.off -s loop -n 1 -o smoothed.off --boundary-corners smoothed
exits 0
check "the corner moves" at 6 smoothed.off 1.875 0.125 0.375
run refine strip.off -s loop -n 1 -o preset.off --preset cgal
same smoothed.off preset.off
run refine strip.off -s loop -n 1 -o preset.off --preset cgal --boundary-corners kept
same kept.off preset.off
run refine cube.off -s doo-sabin -n 2 -o cosine.off --weights cosine
exits 0
run refine cube.off -s doo-sabin -n 2 -o averaging.off --weights averaging
exits 0
check "the weights differ on triangles" test "$(cmp -s cosine.off averaging.off; echo $?)" = 1
cat >quad.off <<'END'
OFF
4 1 0
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
END
run refine quad.off -s doo-sabin -n 1 -o thesis.off
check "a corner stays" grep -qx '1 1 0' thesis.off
run refine quad.off -s doo-sabin -n 1 -o drop.off --boundary drop
check "the surface recedes" grep -qx '0.75 0.75 0' drop.off
run refine quad.off -s doo-sabin -n 1 -o cgal.off --preset cgal
same drop.off cgal.off


# Creases: by angle all edges of the cube stay where they are; a tag of the file holds for as many levels as it says.
run refine cube.off -s catmull-clark -n 2 -o sharp.off --crease-angle 89
exits 0
check "a corner stays" at 4 sharp.off -1 -1 -1
run refine cube.off -s catmull-clark -n 2 -o smooth.off
run refine cube.off -s catmull-clark -n 2 -o same.off --crease-angle 91
same smooth.off same.off
run refine cube.off -s linear -n 0 -o cube.obj
for crease in 0:no 1:once 2:twice; do
    (cat cube.obj; echo; echo "t crease 2/1/0 0 1 ${crease%:*}") >creased.obj
    for mesh in native cgal openmesh; do
        run refine creased.obj -s catmull-clark -n 2 -o $mesh.off --mesh $mesh
        exits 0
        says_nothing
    done
    same native.off cgal.off
    same native.off openmesh.off
    mv native.off "${crease#*:}.off"
done
same smooth.off no.off
check "1 and 2 are not the same" test "$(cmp -s once.off twice.off; echo $?)" = 1
# After two levels of an edge of sharpness 2 its quarter points lie on it: (-1/2, -1, -1), moved by its ends alone.
run refine creased.obj -s catmull-clark -n 1 -o one.off
check "the middle of the edge" grep -qxE -- '0 -1 -1' one.off
(cat cube.obj; echo; echo 't corner 1/1/0 0 12') >creased.obj
run refine creased.obj -s catmull-clark -n 3 -o corner.off
check "the vertex stays" at 4 corner.off -1 -1 -1
run refine creased.obj -s doo-sabin -n 1 -o refused.off
exits 1
says 'doo-sabin has no rules for the creases, corners or holes of the file; only catmull-clark, loop and quad-tri have them; use one of these, or --ignore-tags'
check "no output file" test ! -e refused.off
run refine creased.obj -s doo-sabin -n 1 -o ignored.off --ignore-tags
exits 0
says_nothing
run refine cube.off -s doo-sabin -n 1 -o plain.off
same plain.off ignored.off
run refine cube.off -s catmull-clark -n 2 -o for_ever.off --crease-angle 89
exits 0
run refine cube.off -s catmull-clark -n 1 -o once.off --crease-angle 89 --crease-sharpness 1
exits 0
run refine once.off -s catmull-clark -n 1 -o then_smooth.off
exits 0
run refine cube.off -s catmull-clark -n 2 -o once.off --crease-angle 89 --crease-sharpness 1
exits 0
run compare then_smooth.off once.off --tolerance 1e-15
exits 0
check "for ever is longer" test "$(cmp -s for_ever.off once.off; echo $?)" = 1
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary 1/0/0 2\nt smoothtriangles 0/0/1 smooth\n' >quad.obj
run refine quad.obj -s catmull-clark -n 1 -o smoothed.off
exits 0
says "note: 1 tag of the file is not understood: 'smoothtriangles' in line 7"
check "the corner is smoothed" at 4 smoothed.off 0.125 0.125 0
run refine quad.obj -s catmull-clark -n 1 -o kept.off --boundary-corners kept
check "unless the command line says otherwise" at 4 kept.off 0 0 0
run refine quad.obj -s catmull-clark -n 1 -o preset.off --preset opensubdiv
says 'note: --preset opensubdiv overrides the rule of the file for boundary corners; .* add --boundary-corners smoothed$'
run refine quad.obj -s catmull-clark -n 1 -o preset.off --preset opensubdiv --boundary-corners smoothed
check "which goes before the preset" at 4 preset.off 0.125 0.125 0

# What is left of sharpness is written as tags: refining a file twice by one level is refining it by two.
run refine cube.off -s linear -n 0 -o plain.obj
(cat plain.obj; echo 't crease 5/1/0 0 1 2 3 0 2.5'; echo 't crease 2/1/0 4 5 10'; echo 't corner 1/1/0 6 3'
    echo 't creasemethod 0/0/1 chaikin') >creased.obj
for mesh in native cgal; do
    run refine creased.obj -s catmull-clark -n 1 -o once.obj --mesh $mesh
    exits 0
    says_nothing
    has once.obj '^t crease 2/1/0 [0-9]+ [0-9]+ 1\.5$'
    has once.obj '^t corner 1/1/0 6 2$'
    has once.obj '^t creasemethod 0/0/1 chaikin$'
    run refine once.obj -s catmull-clark -n 2 -o by_steps.obj --mesh $mesh
    run refine creased.obj -s catmull-clark -n 3 -o at_once.obj --mesh $mesh
    run compare by_steps.obj at_once.obj --tolerance 1e-15
    exits 0
    check "the same tags" test "$(grep -c '^t' by_steps.obj)" = "$(grep -c '^t' at_once.obj)"
done
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary 1/0/0 2\n' >quad.obj
run refine quad.obj -s catmull-clark -n 1 -o once.obj
has once.obj '^t interpolateboundary 1/0/0 2$'
run refine once.obj -s catmull-clark -n 1 -o by_steps.off
run refine quad.obj -s catmull-clark -n 2 -o at_once.off
run compare by_steps.off at_once.off --tolerance 1e-15
exits 0
run refine creased.obj -s catmull-clark -n 1 -o once.off
exits 0
says '^kith: note: creased.obj: not kept: the remaining sharpness of 5 edges and 1 vertex \(.obj can hold it\)$'
run refine creased.obj -s catmull-clark -n 1 -o once.vtu --tiles 2
says 'not kept: the remaining sharpness of 5 edges and 1 vertex'
run refine creased.obj -s catmull-clark -n 3 -o out.off --ignore-tags
says_nothing

# What steps that are not alike know of the last one: sqrt3 in OBJ and PLY, so that refining twice by one level is refining by two.
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >open.off
for output in once.obj once.ply 'once.ply --tiles 2 --binary'; do
    for levels in '1 1' '1 2' '2 1' '3 2'; do
        run refine open.off -s sqrt3 -n ${levels% *} -o $output
        exits 0
        says_nothing
        check "the tag" test "$(grep -ac 't generation 1/0/0 1$' ${output%% *})" = $((${levels% *} % 2))
        run refine ${output%% *} -s sqrt3 -n ${levels#* } -o by_steps.off
        exits 0
        run refine open.off -s sqrt3 -n $((${levels% *} + ${levels#* })) -o at_once.off
        run compare by_steps.off at_once.off --tolerance 1e-15
        exits 0
    done
done
run refine open.off -s sqrt3 -n 1 -o odd.obj
run refine odd.obj -s sqrt3 -n 1 -o plain.off
run refine odd.obj -s sqrt3 -n 1 -o cut.off --triangulate # of what are triangles already
same plain.off cut.off
run refine open.off -s sqrt3 -n 1 -o whole.ply --binary
run refine open.off -s sqrt3 -n 1 -o tiles.ply --tiles 2
same whole.ply tiles.ply
run refine whole.ply -s loop -n 1 -o out.obj # of no meaning there
check "no tag" test "$(grep -c generation out.obj)" = 0
for output in once.off 'once.vtu --tiles 2'; do
    for levels in 1 2 3; do
        run refine open.off -s sqrt3 -n $levels -o $output
        exits 0
        test $levels = 2 && says_nothing
        test $levels = 2 || says '^kith: note: open.off: not kept: the parity of sqrt3 steps \(the next one splits the boundary\)$'
    done
    run refine tetra.off -s sqrt3 -n 1 -o $output # closed
    says_nothing
    run refine cube.off -s 4-8 -n 2 -o $output
    exits 0
    says '^kith: note: cube.off: not kept: the edges that 4-8 splits next$'
done

# What an output has no room for is named in a line; OBJ and PLY hold what OBJ has, and VTU all but texture coordinates.
printf 'o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\ng b\nusemtl c\nf 1/1 2/1 3/1 4/1\n' >rich.obj
not_kept_in() { # FILE WORDS
    run refine rich.obj -s catmull-clark -n 1 -o "$1"
    exits 0
    says "^kith: note: rich.obj: not kept: $2\$"
    check "in one line" test "$(wc -l <"$results/err")" -eq 1
}
not_kept_in out.off 'texture coordinates, objects, groups, materials'
not_kept_in out.vtu 'texture coordinates'
run refine out.vtu -s catmull-clark -n 0 -o back.obj
exits 0
check "words come back" test "$(grep -E '^(o|g|usemtl) ' back.obj | tr '\n' ' ')" = 'o a g b usemtl c '
check "for all faces" test "$(sed -n '/^usemtl c$/,$p' back.obj | grep -c '^f ')" -eq 4
for format in obj ply; do
    run refine rich.obj -s catmull-clark -n 1 -o out.$format
    exits 0
    says_nothing
done
rm out.* back.obj

# What is wrong with a crease is told in the numbers of the file, also where a vertex has no face.
printf 'v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 5\nt crease 2/1/0 1 3 2\n' >wrong.obj
run refine wrong.obj -s catmull-clark -n 1 -o out.obj
exits 1
says 'crease 1-3: there is no such edge; correct the tag'
sed -i 's/1 3 2$/1 2 2/' wrong.obj
run refine wrong.obj -s catmull-clark -n 1 -o out.obj
exits 0
rm -f wrong.obj out.obj

# Options that are of no use are refused.
for option in '--partitioner nonsense' --verify --checksum; do
    run refine cube.off -s catmull-clark -n 1 -o out.off $option
    exits 2
    says "$(echo "$option" | cut -d ' ' -f 1): applies to tiles only; name --tiles as well"
done

# Vertices without a face are kept as they are, behind the others.
(cube | sed '2s/8/9/; 5s/^/7 8 9\n/' | awk 'NR > 11 { for (i = 2; i <= NF; ++i) if ($i > 1) ++$i } { print }') >point.off
run refine point.off -s catmull-clark -n 1 -o out.off
exits 0
says '^kith: note: 1 vertex without a face is written after the others; --drop-isolated leaves out such vertices$'
prints '^out.off: 27 vertices, 48 edges, 24 faces$'
check "it is the last vertex" test "$(sed -n 30p out.off)" = '7 8 9'
run refine cube.off -s catmull-clark -n 1 -o cube1.off
check "the others are as without it" test "$(sed -n '4,29p;31,$p' out.off)" = "$(sed -n '4,$p' cube1.off)"
run refine point.off -s catmull-clark -n 1 -o out.off --drop-isolated
exits 0
says_nothing
same out.off cube1.off
run refine point.off -s catmull-clark -n 1 -o out.vtu
exits 0
says 'point.off: not kept: 1 vertex without a face'
rm out.*

# Holes shape what is around them and are not written: the rest is as without them, vertices that only they had are gone.
(cat cube.obj; echo; echo 't hole 2/0/0 1 3') >holes.obj
cat >cube_without.awk <<'END'
# Of an OFF file the faces but those numbered in [from, to) of each range in `holes`, as points in place of indices.
NR == 2 { vertices = $1 }
NR > 2 && NF == 3 { point[n++] = $0 }
NF == 5 && n == vertices {
    if (!(f in hole)) print point[$2] "|" point[$3] "|" point[$4] "|" point[$5]
    ++f
}
BEGIN { split(holes, list, " "); for (i in list) hole[list[i]] = 1 }
END
faces() { awk -v holes="$2" -f cube_without.awk "$1" | sort; }
run refine cube.off -s catmull-clark -n 1 -o whole.off
for mesh in native cgal openmesh; do
    run refine holes.obj -s catmull-clark -n 1 -o $mesh.off --mesh $mesh
    exits 0
    says_nothing
    prints '23 vertices, 38 edges, 16 faces'
done
same native.off cgal.off
same native.off openmesh.off
check "the rest is the same" test "$(faces whole.off '4 5 6 7 12 13 14 15')" = "$(faces native.off '')"
run refine cube.off -s catmull-clark -n 2 -o whole.off
run refine holes.obj -s catmull-clark -n 2 -o native.off
prints '77 vertices, 140 edges, 64 faces'
check "and on the next level" \
    test "$(faces whole.off "$(seq -s ' ' 16 31) $(seq -s ' ' 48 63)")" = "$(faces native.off '')"
run refine holes.obj -s catmull-clark -n 0 -o native.off
prints '8 vertices, 11 edges, 4 faces'
run refine holes.obj -s catmull-clark -n 1 -o refused.vtu --tiles 2
exits 1
says 'the file has holes, which tiles cannot leave out'
run refine holes.obj -s linear -n 1 -o refused.off
exits 1
says 'linear has no rules for the creases, corners or holes'
(cat cube.obj; echo; echo 't hole 1/0/0 6') >holes.obj
run refine holes.obj -s catmull-clark -n 1 -o refused.off
exits 1
says 'hole 6: there is no such face; correct the tag'
(cat cube.obj; echo; echo 't hole 6/0/0 0 1 2 3 4 5') >holes.obj
run refine holes.obj -s catmull-clark -n 1 -o refused.off
exits 1
says 'all 6 faces are holes, nothing would be left'
# Loop: of the tetrahedron three faces are left, each of four on level 1.
run refine tetra.off -s loop -n 0 -o holes.obj
echo 't hole 1/0/0 2' >>holes.obj
run refine holes.obj -s loop -n 2 -o native.off
prints '31 vertices, 78 edges, 48 faces'
run refine tetra.off -s loop -n 1 -o whole.off
run refine holes.obj -s loop -n 1 -o native.off
triangles() { awk 'NR == 2 { vertices = $1 } NR > 2 && NF == 3 { point[n++] = $0 }
    NF == 4 && n == vertices { print point[$2] "|" point[$3] "|" point[$4] }' "$1" | sort; }
triangles whole.off >whole.list
triangles native.off >native.list
check "they are faces of the whole" test "$(comm -12 whole.list native.list | wc -l)" -eq 12
# Where the boundary is not interpolated, the faces that touch it are holes: of 3 x 3 quads the middle one is left.
{
    for v in 0 1 2 3; do for u in 0 1 2 3; do echo "v $u $v 0"; done; done
    for v in 0 1 2; do for u in 1 2 3; do
        a=$((4 * v + u)); echo "f $a $((a + 1)) $((a + 5)) $((a + 4))"
    done; done
    echo 't interpolateboundary 1/0/0 0'
} >grid.obj
run refine grid.obj -s catmull-clark -n 1 -o grid.off
exits 0
says_nothing
prints '9 vertices, 12 edges, 4 faces'
check "the B-spline of the grid" test "$(sed -n '4,12p' grid.off | sort | tr '\n' ' ')" = \
    "1 1 0 1 1.5 0 1 2 0 1.5 1 0 1.5 1.5 0 1.5 2 0 2 1 0 2 1.5 0 2 2 0 "

(echo 'v 0 0 0'; echo 'v 1 0 0'; echo 'v 0 1 0'; echo 'f 1 2 3'; echo 't hole 1/0/0 0') >holes.obj
run refine holes.obj -s loop -n 1 -o refused.off
exits 1
says '^kith: the only face is a hole, nothing would be left; correct the tags$'

# Faces are cut into triangles where that is asked for: quads in two, an L of six corners without leaving it. Creases stay
# where they are, and the triangles of a hole are holes.
for mesh in native cgal openmesh; do
    run refine cube.off -s loop -n 2 --triangulate -o $mesh.off --mesh $mesh
    exits 0
    says_nothing
    prints '98 vertices, 288 edges, 192 faces'
done
same native.off cgal.off
same native.off openmesh.off
run refine cube.off -s linear-triangles -n 0 --triangulate -o cut.off
prints '8 vertices, 18 edges, 12 faces'
run refine cut.off -s loop -n 2 -o again.off
same native.off again.off
run refine tetra.off -s loop -n 2 -o tetra2.off
run refine tetra.off -s loop -n 2 --triangulate -o again.off
same tetra2.off again.off
printf 'OFF 6 1 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n6 0 1 2 3 4 5\n' >ell.off
run refine ell.off -s linear-triangles -n 0 --triangulate -o cut.off
exits 0
prints '6 vertices, 9 edges, 4 faces'
# Its area is 3, and no triangle is turned round: their areas have one sign.
check "the triangles cover the L" awk 'NF == 3 { x[n] = $1; y[n++] = $2 }
    NF == 4 && n == 6 {
        a = ((x[$3] - x[$2]) * (y[$4] - y[$2]) - (x[$4] - x[$2]) * (y[$3] - y[$2])) / 2
        if (a <= 0) bad = 1
        area += a
    }
    END { exit bad || area != 3 }' n=0 <(sed 1,3d cut.off | sed '/^$/d')
# Faces of many corners take no time that grows with their square: two waves around a circle, one of them the other way
# round on a tilted plane. The triangles have the area of the face, and each side of it is a side of one.
waves() { # waves CORNERS
    awk -v n="$1" 'BEGIN {
        print "OFF", 2 * n, 2, 0
        for (i = 0; i < 2 * n; ++i) {
            a = 6.283185307179586 * i / n; r = 1 + .3 * sin(17 * a)
            if (i < n) printf "%.17g %.17g 0\n", r * cos(a), r * sin(a)
            else printf "%.17g %.17g %.17g\n", 5 + r * cos(a), -r * sin(a), -r * sin(a)
        }
        for (f = 0; f < 2; ++f) { printf n; for (i = f * n; i < (f + 1) * n; ++i) printf " %d", i; print "" }
    }'
}
for n in 1500 100000; do
    waves $n >waves.off
    run refine waves.off -s linear-triangles -n 0 --triangulate -o cut.off
    exits 0
    prints "$((2 * n)) vertices, $((4 * n - 3 * 2)) edges, $((2 * n - 4)) faces"
    check "the triangles cover the faces" awk -v n=$n -v v=0 'v < 2 * n && NF == 3 && NR > 2 { x[v] = $1; y[v] = $2; ++v }
        NF == 4 {
            a = ((x[$3] - x[$2]) * (y[$4] - y[$2]) - (x[$4] - x[$2]) * (y[$3] - y[$2])) / 2
            side = $2 < n ? 0 : 1
            if (side != ($3 < n ? 0 : 1) || side != ($4 < n ? 0 : 1) || (side ? a >= 0 : a <= 0)) bad = 1
            area[side] += a
            for (i = 2; i <= 4; ++i) {
                from = $i; to = $(i == 4 ? 2 : i + 1)
                if (to - from == 1 || from - to == n - 1) ++sides[side]
            }
        }
        END {
            for (i = 0; i < n; ++i) { j = (i + 1) % n; whole += (x[i] * y[j] - x[j] * y[i]) / 2 }
            e = 1e-9
            exit bad || area[0] - whole > e || whole - area[0] > e || area[1] + whole > e || -area[1] - whole > e ||
                sides[0] != n || sides[1] != n
        }' cut.off
done
(cat cube.obj; echo; echo 't hole 1/0/0 1'; echo 't crease 2/1/0 0 1 12') >tagged.obj
run refine tagged.obj -s loop -n 0 --triangulate -o cut.off
exits 0
prints '8 vertices, 17 edges, 10 faces'
run refine tagged.obj -s loop -n 1 --triangulate -o cut.off
check "the middle of the crease" grep -qxE -- '0 -1 -1' cut.off
run refine cube.off -s loop -n 3 --triangulate -o one.vtu
exits 0
run refine cube.off -s loop -n 3 --triangulate -o many.vtu --tiles 3
exits 0
same one.vtu many.vtu
printf 'OFF 4 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 1 2 3\n' >line.off
run refine line.off -s loop -n 1 --triangulate -o refused.off
exits 1
says '^kith: face 0: its corners lie on a line, or its sides cross; it cannot be cut into triangles, correct it$'
check "no output file" test ! -e refused.off
rm ./*.vtu

run refine cube.off -s kobbelt -n 1 -o kobbelt.off
exits 0
run refine cube.off -s kobbelt -n 1 -o tight.off --tension 0.001
exits 0
run refine cube.off -s linear -n 1 -o linear.off
exits 0
run compare linear.off kobbelt.off --tolerance 0.01
exits 1
prints 'different'
run compare linear.off tight.off --tolerance 0.01
exits 0

# JSON, standard input and output, threads, memory.
run refine cube.off -s catmull-clark -n 3 -o out.off --json
prints '^\{"scheme":"catmull-clark","mesh":"native","levels":3,"vertices":386,"edges":768,"faces":384,"output":"out.off"\}$'
run_from cube.off refine - -s catmull-clark -n 3 -o -
exits 0
says '^-: 386 vertices, 768 edges, 384 faces$'
check "standard output is the mesh" cmp -s out.off "$results/out"
run refine cube.off -s catmull-clark -n 3 -o limited.off --memory-limit 1M
exits 0
same out.off limited.off
run refine cube.off -s catmull-clark -n 3 -o refused.off --memory-limit 1K
exits 1
says '^kith: catmull-clark: 3 levels need [0-9]+ bytes at once, the limit is 1024; refine fewer times$'
run refine cube.off -s catmull-clark -n 8 -o refused.off --memory-limit 10M # a tile of a cube sees all of it
exits 1
says 'the limit is 10485760 \(10.0 MiB\); refine fewer times$'
run refine cube.off -s catmull-clark -n 4 -o control.off
run refine control.off -s catmull-clark -n 5 -o refused.off --memory-limit 40M
exits 1
says 'the limit is 41943040 \(40.0 MiB\); refine fewer times, or refine in tiles and write .vtu, .pvtu or .ply: --tiles [0-9]+( --threads 1)?$'
# shellcheck disable=SC2046 # several words
run refine control.off -s catmull-clark -n 5 -o tiles.vtu --memory-limit 40M $(grep -o -- '--tiles .*' "$results/err")
exits 0
rm -f control.off tiles.vtu
run refine cube.off -s catmull-clark -n 20 -o refused.off
exits 1
says 'level 14 has .* more than a 32-bit index can number; refine fewer times'
check "no output file" test ! -e refused.off
run refine cube.off -s catmull-clark -n 1 -o refused.off --stats ./refused.off
exits 2
says 'refused.off is the output; name another file'
if "$kith" refine --help | grep -q -- --threads; then
    for threads in 1 2; do
        run refine cube.off -s catmull-clark -n 6 -o threads$threads.off --threads $threads
        exits 0
    done
    same threads1.off threads2.off
    for threads in 0 -1 4097 4294967297; do
        run refine cube.off -s catmull-clark -n 1 -o refused.off --threads=$threads
        exits 2
        says "threads: $threads threads were asked for; ask for 1 or more, up to 4096"
    done
fi
finish
