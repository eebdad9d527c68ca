# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
tetrahedron >a.off

equal() { # equal TOLERANCE: a.off and b.off, both ways
    run compare a.off b.off --tolerance "$1"
    exits 0
    prints "^largest distance ${2:-0}, equal\$"
    run compare b.off a.off -t "$1"
    exits 0
}
different() { # different TOLERANCE MESSAGE
    run compare a.off b.off --tolerance "$1"
    exits 1
    prints "$2"
    says_nothing
    run compare b.off a.off --tolerance "$1"
    exits 1
    prints "$2"
}

# Other numbers and other first corners, the same mesh.
cat >b.off <<'END'
OFF
4 4 0
0 0 1
0 1 0
0 0 0
1 0 0
3 1 0 3
3 1 3 2
3 2 0 1
3 0 2 3
END
equal 0
# Moved a little.
sed -i '3s/.*/0 0 1.25/' b.off
equal 0.25 0.25
different 0.2499 '^largest distance 0.25, different, vertices without partner: 2$'
run compare a.off b.off --tolerance 0.2 --json
exits 1
prints '^\{"equal":false,"largest_distance":0.25,"unmatched_vertices":2,"unmatched_faces":0,"same_faces":false\}$'
run compare a.off a.off --tolerance 0.2 --json
exits 0
prints '^\{"equal":true,"largest_distance":0\.0,"unmatched_vertices":0,"unmatched_faces":0,"same_faces":true\}$'
# A face turned round, a face missing, a face twice, a quad instead of two triangles.
sed '7s/.*/3 0 1 2/' a.off >b.off
different 0.1 '^largest distance 0, different, faces without partner: 2$'
sed '2s/.*/4 3 0/; 7d' a.off >b.off
different 0.1 'different, faces without partner: 1$'
sed '2s/.*/4 5 0/; 7s/.*/&\n&/' a.off >b.off
different 0.1 'different, faces without partner: 1$'
# A vertex more.
sed '2s/.*/5 4 0/; 6s/.*/&\n-2 0 0/' a.off >b.off
different 0.1 '^largest distance 2, different, vertices without partner: 1$'
sed '2s/.*/5 4 0/; 6s/.*/&\n0 0 1/' a.off >b.off
different 0.1 '^largest distance 0, different, vertices without partner: 1$'

# Coinciding vertices: two triangles side by side whose common edge is there twice, one triangle on each copy.
cat >a.off <<'END'
OFF
6 2 0
0 0 0
1 0 0
0 1 0
1 0 0
0 1 0
1 1 0
3 0 1 2
3 3 5 4
END
cat >b.off <<'END'
OFF
6 2 0
0 0 0
1 0 0
0 1 0
1 0 0
0 1 0
1 1 0
3 0 3 2
3 4 1 5
END
equal 0
equal 1e-9
# One mesh is cut along the edge, the other is not and has two vertices to spare.
sed 's/^3 4 1 5/3 2 3 5/' b.off >c.off
run compare a.off c.off --tolerance 0
exits 1
prints 'vertices that coincide are joined to other faces$'
# A tolerance that reaches from one end of the mesh to the other still finds what belongs together.
tetrahedron >a.off
sed '3s/.*/0.1 0 0/' a.off >b.off
equal 3 0.1
sed '7s/.*/3 0 1 2/' a.off >b.off
different 3 'faces'

# Refined by different programs' meshes and numbers: a large one, in time.
cube >a.off
(echo OFF 8 6 0; cube | sed -n '3,10p' | tac; cube | sed -n '11,16p' | awk '{ print 4, 7 - $3, 7 - $4, 7 - $5, 7 - $2 }') >b.off
equal 0
run refine a.off -s catmull-clark -n 7 -o fine_a.ply
run refine b.off -s catmull-clark -n 7 -o fine_b.obj
run compare fine_a.ply fine_b.obj --tolerance 1e-14
exits 0
run compare fine_a.ply a.off --tolerance 1e-14
exits 1

# Bit by bit: numbers of vertices and faces, first corners, signs of zeros, last bits.
differs() { # differs MESSAGE SED_SCRIPT: a.off and what the script makes of it
    sed "$2" a.off >b.off
    run compare a.off b.off --bitwise
    exits 1
    prints "^different, $1\$"
    says_nothing
}
tetrahedron >a.off
run compare a.off a.off --bitwise
exits 0
prints '^equal, bit for bit$'
differs 'vertex 0, y: 0 and -0' '3s/.*/0 -0 0/'
differs 'vertex 2, y: 1 and 1.0000000000000002' '5s/.*/0 1.0000000000000002 0/'
differs 'vertex 1, x: 1 and 0' '4{h;d};5{G}'
differs 'vertices: 4 and 5' '2s/.*/5 4 6/;6s/.*/&\n0 0 2/'
differs 'faces: 4 and 3' '2s/.*/4 3 6/;$d'
differs 'face 1: 0 1 3 and 1 3 0' '8s/.*/3 1 3 0/'
differs 'face 0: 0 2 1 and 0 1 3' '7{h;d};8{G}'
differs 'face 3: 2 0 3 and 2 0 1 3' '10s/.*/4 2 0 1 3/'
run compare a.off b.off --bitwise --json
exits 1
prints '^\{"equal":false,"difference":"face 3: 2 0 3 and 2 0 1 3"\}$'
run compare a.off a.off --bitwise --json
exits 0
prints '^\{"equal":true,"difference":""\}$'
run compare a.off b.off --bitwise --tolerance 0
exits 2
says '--bitwise and --tolerance do not go together; leave one of them out'
# Text with 17 digits and binary hold the same bits; tiles give those of the whole.
run refine a.off -s loop -n 4 -o text.obj
run refine a.off -s loop -n 4 -o tiles.ply --tiles 3
run compare text.obj tiles.ply --bitwise
exits 0
finish
