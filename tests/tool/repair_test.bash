# SPDX-License-Identifier: BSD-3-Clause
# Faces that form no manifold: refused unless --repair or --weld says how they may be changed.
source "$(dirname "$0")/check.bash"

refused() { # refused FILE MESSAGE REMEDY: refine and info say so, and name the options
    run refine "$1" -s linear -n 1 -o out.off
    exits 1
    says "$2"
    says "$3"
    run info "$1"
    exits 1
    prints "$2"
    prints "$3"
}
mended() { # mended FILE COUNTS OPTIONS...: refined with these options, to so many vertices, edges and faces
    local file=$1 counts=$2
    shift 2
    run refine "$file" -s linear -n 0 -o out.off --ignore-tags "$@"
    exits 0
    prints "^out.off: $counts\$"
    run info "$file" "$@"
    exits 0
    prints '^problems +none$'
}

# Points that differ by rounding, as in the corners of an STL file.
cat >rounded.stl <<'END'
solid r
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 1 1e-16 0
vertex 0 0 1
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 1e-16 0 1
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 1e-16 1 0
endloop
endfacet
endsolid r
END
refused rounded.stl 'vertex 0: its 3 faces form several fans' \
    'vertex 3 coincides with vertex 2, one of 3 such vertices at the boundary; --weld joins such vertices, try it first$'
prints '^coinciding vertices +3 at the boundary coincide with others, 0 exactly, the rest within [0-9.e-]+: 3 at 2, 5 at 4, 6 at 1; --weld joins them$'
run info rounded.stl --json
prints '"coinciding_vertices":\{"equal":0,"within_distance":3,"distance":1.7320508075688774e-06\}'
for weld in '--weld' '--weld 1e-9' '--weld=1e-9' '--repair weld' '--repair weld=1e-9'; do
    mended rounded.stl '4 vertices, 6 edges, 4 faces' $weld
done
says '^kith: note: rounded.stl: vertex 3: joined with vertex 2$'
run refine rounded.stl --weld -s linear-triangles -n 1 -o out.off
exits 0
prints '^out.off: 10 vertices, 24 edges, 16 faces$'
run refine --weld 0 rounded.stl -s linear -n 1 -o out.off
exits 1
says '^kith: rounded.stl, numbered as after the repair:$'

# Points that are doubled along seams: no problem, but told.
cat >soup.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 1 0 0
v 2 0 0
v 2 1 0
v 1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
f 5/1 6/2 7/3 8/4
t crease 2/1/0 1 2 3
t corner 1/1/0 7 2
END
run info soup.obj
exits 0
prints '^coinciding vertices +2 at the boundary coincide with others, exactly: 5 at 2, 8 at 3; --weld joins them$'
prints '^problems +none$'
mended soup.obj '6 vertices, 7 edges, 2 faces' --weld 0
run refine soup.obj -s catmull-clark -n 0 -o out.obj --weld
exits 0
has out.obj '^f +1/1 2/2 3/3 4/4$'
has out.obj '^t crease 2/1/0 1 2 3$'
has out.obj '^t corner 1/1/0 2 2$' # the vertex that it was joined with
run info soup.obj --weld
prints '^boundary loops +1$'

# Texture coordinates of vertices that are joined become those of corners; other values are told.
cat >seam.ply <<'END'
ply
format ascii 1.0
element vertex 8
property double x
property double y
property double z
property float s
property float t
property uchar quality
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0 1
1 0 0 1 0 2
1 1 0 1 1 3
0 1 0 0 1 4
1 0 0 0 0 5
2 0 0 1 0 6
2 1 0 1 1 7
1 1 0 0 1 8
4 0 1 2 3
4 4 5 6 7
END
run refine seam.ply -s linear -n 0 -o out.obj --weld 0
exits 0
has out.obj '^f +1/1 2/2 3/3 4/4$'
has out.obj '^vt 0 0$'
check "the second face begins at the seam with other values" grep -qE '^f +2/5 5/6 6/7 3/8$' out.obj
says "^kith: note: seam.ply: the property 'quality' of vertices: 2 joined vertices had other values than the vertex that is kept\$"

# A strip that is joined the wrong way round.
(echo OFF; echo 6 3 0; echo 0 0 0; echo 1 0 0; echo 0 1 0; echo 0 0 1; echo 1 0 1; echo 0 1 1
    echo 4 0 1 4 3; echo 4 1 2 5 4; echo 4 2 3 0 5) >strip.off
refused strip.off 'edge 0-3: faces 0 and 2 run through it in the same direction, and reversing faces does not help, as the surface is one-sided' \
    '^ *--repair changes such faces: orient \(reverses faces\), split \(gives each sheet an edge of its own and each fan a vertex of its own\), drop \(removes faces\)$'
mended strip.off '8 vertices, 10 edges, 3 faces' --repair split
says '^kith: note: strip.off: edge 0-3: cut, as faces 0 and 2 run through it in the same direction$'
mended strip.off '8 vertices, 10 edges, 3 faces' --repair orient,split
says '^kith: note: strip.off: vertex 0: split into 2 vertices, one for each fan of faces$'
mended strip.off '6 vertices, 7 edges, 2 faces' --repair drop
run refine strip.off -s linear -n 1 -o out.off --repair orient
exits 1
says 'reversing faces does not help'

# A vertex with two fans, three sheets at an edge, faces against each other.
(echo OFF; echo 5 2 0; echo 0 0 0; echo 1 0 0; echo 0 1 0; echo -1 0 0; echo 0 -1 0; echo 3 0 1 2; echo 3 0 3 4) >pinch.off
refused pinch.off 'vertex 0: its 2 faces form several fans' '--repair changes such faces: split'
mended pinch.off '6 vertices, 6 edges, 2 faces' --repair split
mended pinch.off '3 vertices, 3 edges, 1 faces' --repair drop
(echo OFF; echo 5 3 0; echo 0 0 0; echo 1 0 0; echo 0 1 0; echo 0 -1 0; echo 0 0 1
    echo 3 0 1 2; echo 3 1 0 3; echo 3 0 1 4) >book.off
refused book.off 'edge 0-1: 3 faces \(0, 1, 2\)' '--repair changes such faces: split'
mended book.off '9 vertices, 9 edges, 3 faces' --repair split
mended book.off '4 vertices, 5 edges, 2 faces' --repair drop
says '^kith: note: book.off: face 2: left out, as edge 0-1 has 3 faces$'
says '^kith: note: book.off: vertex 4: left out, it belongs to no face$'
cube | sed '11s/.*/4 0 1 2 3/' >turned.off
refused turned.off 'run through it in the same direction; reverse one of them' '--repair changes such faces: orient'
mended turned.off '8 vertices, 12 edges, 6 faces' --repair orient
says '^kith: note: turned.off: face 0: turned round$'
cube >cube.off
run compare out.off cube.off -t 0
exits 0
mended turned.off '8 vertices, 12 edges, 5 faces' --repair drop
says 'face 0: left out, as another face runs through edge '

# Repeated corners, faces without area and given twice, in the numbers of the file.
cat >bad.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 9 9 9
f 1 2 2 3 4
f 3 2 1
f 1 2 3 4
f 1 2
END
run info bad.obj
exits 1
prints '^  face 1: contains vertex 2 twice; '
prints '^  --repair changes such faces: drop \(removes faces\)$'
sed -i '$d' bad.obj
run refine bad.obj -s linear -n 0 -o out.obj --repair drop
exits 0
prints '^out.obj: 4 vertices, 5 edges, 2 faces$' # a quad and a triangle on its back
says '^kith: note: bad.obj: face 1: its repeated corner at vertex 2 is left out$'
says '^kith: note: bad.obj: face 3: left out, as it repeats face 1$'
says '^kith: note: bad.obj: vertex 5: left out, it belongs to no face$'
# What does not exist is refused always.
printf 'v 0 0 0\nv 1 0 0\nf 1 2 7\n' >bad.obj
run refine bad.obj -s linear -n 0 -o out.obj --repair drop,split,orient,weld
exits 1

# Attributes, creases and holes go along; those of what is left out go with it.
cat >tags.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v -1 0 0
v 0 -1 0
v 2 2 0
usemtl red
f 1 2 3
usemtl blue
f 1 4 5
usemtl green
f 2 6 3
t crease 2/1/0 0 1 2
t crease 2/1/0 3 4 5
t corner 1/1/0 0 7
t hole 1/0/0 2
END
run refine tags.obj -s loop -n 0 -o out.obj --repair split
exits 0
has out.obj '^t crease 2/1/0 0 1 2$'
has out.obj '^t crease 2/1/0 3 4 5$'
has out.obj '^t corner 1/1/0 0 7$'
check "both copies are sharp" test "$(grep -c '^t corner' out.obj)" -eq 2
check "the hole is left out" test "$(grep -c '^f ' out.obj)" -eq 2
run refine tags.obj -s loop -n 0 -o out.obj --repair drop
exits 0
says '^kith: note: tags.obj: face 2: left out, as it does not join the larger fan of faces at vertex 1$'
says '^kith: note: tags.obj: 1 crease is lost with the elements that the repair removes$'
has out.obj '^usemtl red$'
check "the blue face has gone" test "$(grep -c blue out.obj)" -eq 0

# Repair comes before --triangulate; in tiles and from a journal it gives the same surface.
run refine turned.off -s loop -n 2 --triangulate --repair orient -o whole.ply --binary
exits 0
run refine turned.off -s loop -n 2 --triangulate --repair orient -o tiles.ply --tiles 3
exits 0
same whole.ply tiles.ply
run refine turned.off -s loop -n 2 --triangulate --repair orient -o kept.ply --tiles 3 --journal kept --only 1
exits 0
run refine turned.off -s loop -n 2 --triangulate --repair orient,split -o kept.ply --tiles 3 --journal kept
exits 1
says "its repair is 'orient', not 'split,orient'"
run refine --journal kept --repair orient
exits 2
says '--repair: without IN, the journal sets this option; leave it out or name IN'
run refine --journal kept
exits 0
same whole.ply kept.ply
run plan turned.off -s catmull-clark -n 1 --repair orient
exits 0
prints '26 '

# Words that are none.
run refine cube.off -s linear -n 0 -o out.off --repair mend
exits 2
says "^kith: --repair: 'mend' is not one of drop, split, orient, weld$"
run refine cube.off -s linear -n 0 -o out.off --repair ''
exits 2
says '^kith: --repair: name one or more of drop, split, orient, weld$'
for distance in -1 nan x; do
    run refine cube.off -s linear -n 0 -o out.off --weld=$distance
    exits 2
    says "^kith: --weld: '$distance' is not a distance; give a number of 0 or more$"
done
# Good meshes stay as they are, without a word.
run refine cube.off -s linear -n 0 -o out.off --repair drop,split,orient --weld
exits 0
says_nothing
run refine cube.off -s linear -n 0 -o plain.off
same out.off plain.off
finish
