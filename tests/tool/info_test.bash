# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off

run info cube.off
exits 0
says_nothing
prints '^vertices +8$'
prints '^edges +12$'
prints '^faces +6$'
prints '^components +1$'
prints '^boundary loops +0$'
prints '^Euler characteristic +2$'
prints '^valences +3 to 3 \(8 of 3\)$'
prints '^face degrees +4 to 4 \(6 of 4\)$'
prints '^bounding box +-1 -1 -1 to 1 1 1$'
prints '^problems +none$'
run info cube.off --json
exits 0
prints '^\{"file":"cube.off","vertices":8,"edges":12,"faces":6,"components":1,"boundary_loops":0,"euler_characteristic":2,"valences":\{"3":8\},"face_degrees":\{"4":6\},"bounding_box":\[\[-1\.0,-1\.0,-1\.0\],\[1\.0,1\.0,1\.0\]\],"tags":\[\],"schemes":\["catmull-clark","quad-tri","doo-sabin","kobbelt","nasri-hasbini","4-8","mid-edge","unified","linear"\],"problems":\[\]\}$'

# A pipe of six quads with two boundary loops and a triangle by itself.
cat >'pipe "1".off' <<'END'
OFF
11 5 0
0 0 0
1 0 0
0 1 0
0 0 1
1 0 1
0 1 1
5 0 0
6 0 0
5 1.5 -2
0 0 2
1 0 2
4 0 1 4 3
4 1 2 5 4
4 2 0 3 5
3 6 7 8
4 3 4 10 9
END
run info 'pipe "1".off'
exits 0
prints '^edges +15$'
prints '^components +2$'
prints '^boundary loops +3$'
prints '^Euler characteristic +1$'
prints '^valences +2 to 4 \(5 of 2, 4 of 3, 2 of 4\)$'
prints '^face degrees +3 to 4 \(1 of 3, 4 of 4\)$'
prints '^bounding box +0 0 -2 to 6 1.5 2$'
run info 'pipe "1".off' --json
exits 0
prints '"file":"pipe \\"1\\".off"'
prints '"boundary_loops":3,'

# The schemes that take a mesh as it is, and what an OBJ file says of creases and holes.
run info cube.off
prints '^tags +none$'
prints '^refined by +catmull-clark, quad-tri, doo-sabin, kobbelt, nasri-hasbini, 4-8, mid-edge, unified, linear$'
tetrahedron >tetra.off
run info tetra.off
prints '^refined by +catmull-clark, loop, '
cat >tagged.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
v 2 1 0
f 1 2 3 4
f 2 5 6 3
t crease 2/1/0 1 2 1.5
t corner 1/1/0 4 12
t hole 1/0/0 0
t interpolateboundary 1/0/0 1
t creasemethod 0/0/1 chaikin
END
run info tagged.obj
exits 0
prints '^tags +1 sharp edge, 1 sharp vertex, 1 hole, 1 boundary rule, 1 crease method$'
prints '^  edge 1-2: sharpness 1.5$'
prints '^  vertex 4: infinitely sharp$'
prints '^  face 0: a hole$'
prints '^  boundary: its corners are kept$'
prints "^  creases: by Chaikin's rule$"
prints '^refined by +catmull-clark, quad-tri$'
run info tagged.obj --json
prints '"tags":\["edge 1-2: sharpness 1.5",.*\],"schemes":\["catmull-clark","quad-tri"\],"problems":\[\]'
# What `refine` refuses in the tags is a problem here, too.
echo 't crease 2/1/0 0 2 1' >>tagged.obj
run info tagged.obj
exits 1
prints '^problems +found$'
prints '^  crease 0-2: there is no such edge; correct the tag$'
sed -i '$d' tagged.obj
echo 't hole 1/0/0 1' >>tagged.obj
run info tagged.obj
exits 1
prints '^  all 2 faces are holes, nothing would be left; correct the tags$'
# All that is wrong is told at once.
echo 't crease 2/1/0 0 2 1' >>tagged.obj
run info tagged.obj --json
exits 1
prints '"schemes":\[\],"problems":\["crease 0-2: there is no such edge; correct the tag","all 2 faces are holes, .*"\]\}$'

# What is wrong is named with its elements; the rest is counted all the same.
bad() { # bad MESSAGE: the file bad.off has this problem
    run info bad.off
    exits 1
    prints "$1"
    prints '^problems +found$'
    prints '^vertices +[0-9]'
    run info bad.off --json
    exits 1
    prints '"problems":\["'
}
cat >bad.off <<'END'
OFF
5 3 0
0 0 0
1 0 0
0 1 0
0 0 1
0 -1 0
3 0 1 2
3 0 1 3
3 0 1 4
END
bad 'edge 0-1: 3 faces \(0, 1, 2\)'
run info bad.off
check "a bad mesh has no boundary loops to count" test -z "$(grep 'boundary loops' "$results/out")"
(cube | sed '$d'; echo '4 7 4 0 3') >bad.off
bad 'edge 0-3'
(cube | sed 's/^4 3 2 1 0/4 3 2 1 2/') >bad.off
bad 'face 0: contains vertex 2 twice'
(cube | sed 's/^8 6/8 7/'; echo '2 0 1') >bad.off
bad 'face 6: has 2 corners'
cat >bad.off <<'END'
OFF
5 2 0
0 0 0
1 0 0
0 1 0
-1 0 0
0 -1 0
3 0 1 2
3 0 3 4
END
bad 'vertex 0'
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >bad.off
bad 'no faces'

# What can be refined has no problem: a vertex without a face is kept. What refining loses is told.
(cube | sed 's/^8 6/9 6/; s/^4 3 2 1 0/0 0 7\n&/') >point.off
run info point.off
exits 0
prints '^isolated vertices +1$'
prints '^problems +none$'
run info point.off --json
prints '"isolated_vertices":1,"tags":\[\],"schemes":\["catmull-clark",.*\],"problems":\[\]\}$'
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\ng a\nf 1//1 2//1 3//1 4//1\n' >quad.obj
printf 't crease 3/1/0 0 1 2 2\nt corner 1/1/0 3 1\nt strange 0/0/0\n' >>quad.obj
run info quad.obj
exits 0
prints '^tags +2 sharp edges, 1 sharp vertex, 1 unknown tag$'
prints '^attributes +groups$'
prints '^not refined +normals$'
run info quad.obj --json
prints '"tags":\["edge 0-1: sharpness 2","edge 1-2: sharpness 2","vertex 3: sharpness 1","line 10: .strange. is not understood"\],"attributes":\["groups"\],"not_refined":\["normals"\],"schemes":\["catmull-clark","quad-tri"\],"problems":\[\]\}$'
echo 't crease 2/1/0 0 2 1' >>quad.obj
run info quad.obj
exits 1
prints 'crease 0-2: there is no such edge; correct the tag'
finish
