# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"

# refused FILE MESSAGE: what the file holds is refused by every verb, in words with its path, and nothing is left.
refused() {
    local file=$1 message=$2
    for arguments in "refine $file -s catmull-clark -n 2 -o out.off" "plan $file -s catmull-clark -n 2" \
        "compare $file $file --tolerance 1"; do
        run $arguments
        exits 1
        says "^kith: $file:"
        says "$message"
        prints_nothing
        only_input_left "$file"
    done
    rm -rf "$file"
}
# not_refined MESSAGE: the file in.off can be read, and what is wrong with its mesh is told by `info` and before refining.
not_refined() {
    local message=$1
    run info in.off
    exits 1
    prints "$message"
    for mesh in native cgal openmesh; do
        run refine in.off -s ${2:-catmull-clark} -n 1 -o out.off --mesh $mesh
        exits 1
        says "$message"
        prints_nothing
        only_input_left in.off
    done
}

# No file, no mesh.
run refine nothing.off -s loop -n 1 -o out.off
exits 1
says '^kith: nothing.off: cannot be opened: No such file or directory'
run info nothing.off
exits 1
mkdir a.off
refused a.off 'is a directory'
: >a.off
refused a.off 'the file is empty'
printf ' \n\n\t\n' >a.ply
refused a.ply 'the file is empty'
cube >a.3ds
refused a.3ds 'the extension decides the format and must be .off, .obj, .ply, .stl, .vtu, .pvtu, .vtp or .pvtp'
cube >a
refused a 'the extension decides'
head -c 3000 /dev/zero >a.off
refused a.off 'begins with the word OFF'
head -c 3000 /dev/zero >a.obj
refused a.obj 'is not a statement'
head -c 3000 /dev/zero >a.ply
refused a.ply "begins with a line 'ply'"
head -c 3000 /dev/zero | tr '\0' '\377' >a.stl
refused a.stl 'neither text'
for extension in obj ply stl; do
    cube >a.$extension
    refused a.$extension 'line 1: |neither text'
done

# OFF: every line that is not what it should be.
off() { # off SED-SCRIPT MESSAGE
    cube | sed "$1" >a.off
    refused a.off "$2"
}
off '1s/.*/offset/' "line 1: an OFF file begins with the word OFF, this one with 'offset'"
off '1d' "line 1: an OFF file begins with the word OFF, this one with '8'"
off '1s/.*/nOFF/' 'line 2: vertices have 8 coordinates, but three are needed'
off '1s/.*/OFF BINARY/' 'binary OFF is not read'
off '2s/.*/8/' "line 2: the number of faces should be a whole number, it is ''"
off '2s/.*/8 six 12/' "line 2: the number of faces should be a whole number, it is 'six'"
off '2s/.*/-8 6 12/' 'the number of vertices'
off '2s/.*/8 -6 12/' 'the number of faces'
off '2s/.*/8.5 6 12/' 'the number of vertices'
off '2s/.*/8 6 12 1/' 'line 2: this line holds more than'
off '2s/.*/4000000000 6 12/' 'line 2: the file is too short for 4000000000 vertices'
off '2s/.*/8 4000000000 12/' 'line 2: the file is too short for 8 vertices and 4000000000 faces'
off '2s/.*/18446744073709551615 18446744073709551615 0/' 'too short'
off '2s/.*/99999999999999999999999 6 12/' 'whole number'
off '2s/.*/9 6 12/' 'the file ends where face 5 of 6 should be|line'
off '2s/.*/8 7 12/' 'the file ends where face 6 of 7 should be'
off '2s/.*/8 5 12/' 'line 16: the file goes on after its 8 vertices and 5 faces'
off '2s/.*/7 6 12/' 'line 10: face 0'
off '5s/.*/1 1/' 'line 5: vertex 2 has 2 coordinates'
off '5s/.*/1 1 x/' "line 5: vertex 2 should be a number, it is 'x'"
off '5s/.*/1 1 1x/' "line 5: vertex 2 should be a number, it is '1x'"
off '5s/.*/1 1 1,5/' "line 5: vertex 2 should be a number"
off '5s/.*/1 1 nan/' "line 5: vertex 2 is 'nan', which is not a finite number; correct it"
off '5s/.*/1 -inf 1/' "line 5: vertex 2 is '-inf', which is not a finite number"
off '5s/.*/1 1e999 1/' "line 5: vertex 2 is '1e999', which is not a finite number"
off '5s/.*/1 0x10 1/' "line 5: vertex 2 should be a number, it is '0x10'"
off '5s/.*/1 1 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0/' 'line 5: vertex 2 has too many numbers'
off '3{N;s/\n/ /}' 'ends where face 5|line'
off '11s/.*/4 3 2 1/' 'line 11: face 0 should have 4 corners, 3 are there'
off '11s/.*/5 3 2 1 0/' 'line 11: face 0 should have 5 corners, 4 are there'
off '11s/.*/99999999999 3 2 1 0/' 'line 11: face 0 should have 99999999999 corners'
off '11s/.*/-4 3 2 1 0/' "line 11: face 0: its number of corners should be a whole number, it is '-4'"
off '11s/.*/4 3 2 1 8/' 'line 11: face 0: vertex 8 does not exist, there are 8; correct the index'
off '11s/.*/4 3 2 1 -1/' 'line 11: face 0: vertex -1 does not exist'
off '11s/.*/4 3 2 1 0.5/' "line 11: face 0: a vertex should be a whole number, it is '0.5'"
off '11s/.*/4 3 2 one 0/' "it is 'one'"
off '11s/.*/4 3 2 1 0 red/' "line 11: face 0: its color should be a number, it is 'red'"
off '11s/.*/3 3 2 1 3 3 1 0 0/' 'line 11: face 0 has too many numbers'
off '1s/.*/4OFF/; 3,10s/$/ 1/; 4s/1$/0/' 'vertex 1 lies at infinity'
off '1s/.*/4OFF/' 'line 3: vertex 0 has 3 coordinates, 4 are needed'
for bytes in 1 2 4 8 12 20 50 80 110 124; do
    cube | head -c $bytes >a.off
    refused a.off 'the file ends where|should be|begins with|too short|corners|coordinates'
done

# OBJ.
obj() { # obj TEXT MESSAGE
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n%b\n' "$1" >a.obj
    refused a.obj "$2"
}
obj '' 'the file has 3 vertices and 0 faces'
obj 'f 1 2 4' 'line 4: face 1: vertex 4 does not exist, there are 3; correct the index'
obj 'f 1 2 0' 'line 4: face 1: vertex 0 does not exist'
obj 'f 1 2 -4' 'line 4: face 1: vertex -4 does not exist, there are 3 so far'
obj 'f 1 2 -99999999999999999999' 'should be a whole number'
obj 'f 1 2 4294967299' 'vertex 4294967299 does not exist'
obj 'f 1 2 9223372036854775807' 'does not exist'
obj 'f 1 2 three' "line 4: face 1: a vertex should be a whole number, it is 'three'"
obj 'f 1 2 3.0' 'should be a whole number'
obj 'f 1/1/x 2 3' 'a texture coordinate or normal should be a whole number'
obj 'f 1 2 3\n1 2 3' "line 5: '1' is not a statement"
obj 'f 1, 2, 3' "it is '1,'"
obj 'v 1 1\nf 1 2 3' 'line 4: vertex 4 has 2 coordinates'
obj 'v 1 1 up\nf 1 2 3' "line 4: vertex 4 should be a number, it is 'up'"
obj 'v 1 1 nan\nf 1 2 3' 'not a finite number'
obj 'F 1 2 3' "line 4: 'F' is not a statement of an OBJ file"
obj 't crease 2/1/0 0 1\nf 1 2 3' 'line 4: the tag has fewer arguments than it says'
obj 't crease 2/1/0 0 1 2 3\nf 1 2 3' 'line 4: the tag has more arguments than it says'
obj 't crease 2/1 0 1 2\nf 1 2 3' 'line 4: a tag gives the numbers of its arguments as in 2/1/0'
obj 't crease 2/1/0 0 -1 2\nf 1 2 3' 'line 4: an argument of the tag should be a whole number'
obj 't crease 2/1/0 0 1 hard\nf 1 2 3' 'line 4: an argument of the tag should be a number'
obj 't crease 2/1/0 0 1 -2\nf 1 2 3' 'line 4: a sharpness is 0 or more'
obj 't crease 1/1/0 0 2\nf 1 2 3' 'line 4: a crease runs from one vertex to another'
obj 't crease 3/3/0 0 1 2 1 1 1\nf 1 2 3' 'line 4: the tag should have one sharpness, or 2'
obj 't crease 999999999999/1/0 0 1 2\nf 1 2 3' 'line 4: .*argument'
printf 'f 1 2 3\n' >a.obj
refused a.obj 'vertex 3 does not exist, there are 0'
printf 'hello, world\n' >a.obj
refused a.obj "line 1: 'hello,' is not a statement"

# PLY.
ply() { # ply SED-SCRIPT MESSAGE
    cat <<'END' | sed "$1" >a.ply
ply
format ascii 1.0
element vertex 3
property float x
property double y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
END
    refused a.ply "$2"
}
ply '2d' "the header has no line 'format'"
ply '2s/ascii/asci/' "line 2: 'asci' is no format"
ply '2s/1.0/2.0/' 'version 1.0'
ply '3s/vertex/point/' "one element 'vertex'"
ply '3s/3/-3/' "the number of elements 'vertex' should be a whole number"
ply '3s/3/4/' 'vertex_indices|vertex 3'
ply '3s/3/9000000000000000000/' 'the file ends where vertex'
ply '3s/$/\nelement nothing 9000000000000000000/' "the elements 'vertex' have no property|no property"
ply '3d' "line 3: the property belongs to no element"
ply '4s/float/long/' "line 4: 'long' is no type"
ply '4s/float x/list uchar float x/' "no property 'x' that is a number"
ply '6s/z/w/' "no property 'z'"
ply '6s/.*/property float/' 'the property has no name'
ply '7s/1/2/' 'the file ends where face 1: vertex_indices, its length should be'
ply '7s/1/0/' 'line 13: the file goes on after its last element'
ply '8s/int/float/' "no list 'vertex_indices' of whole numbers"
ply '8s/vertex_indices/corners/' "no list 'vertex_indices'"
ply '8s/uchar/float/' 'the length of a list must be a whole number'
ply '9d' "'0' is no line of a PLY header"
ply '9,$d' "the file ends where 'end_header' should be"
ply '8s/$/\n/' "'' is no line of a PLY header"
ply '11s/1/one/' "line 11: vertex 1: x should be a number, it is 'one'"
ply '11s/1/nan/' 'line 11: vertex 1: x is .nan., which is not a finite number'
ply '11s/1/1e39/' 'line 11: vertex 1: x is too large for the type float'
ply '12d' 'the file ends where face 0: vertex_indices should be'
ply '13s/2$/3/' 'line 13: face 0: vertex 3 does not exist, there are 3'
ply '13s/2$/-1/' 'line 13: face 0: vertex -1 does not exist'
ply '13s/2$/2.5/' 'should be a whole number'
ply '13s/^3/300/' 'its length is 300, which does not fit its type'
ply '13s/^3/-1/' 'its length is -1, which does not fit its type'
ply '13s/$/ 7/' 'the file goes on after its last element'
ply '7s/face/halfedge/' "half-edges|one element"
binary() { # binary COUNT BYTES MESSAGE: three vertices, then the bytes as the only face
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n' >a.ply
    printf 'property float z\nelement face 1\nproperty list %s int vertex_indices\nend_header\n' "$1" >>a.ply
    head -c 36 /dev/zero >>a.ply
    printf "$2" >>a.ply
    refused a.ply "$3"
}
binary uchar '\3\0\0\0\0\1\0\0\0\2\0\0' 'the file ends where face 0: vertex_indices should be'
binary uchar '\3\0\0\0\0\1\0\0\0\3\0\0\0' 'face 0: vertex 3 does not exist'
binary uchar '\3\0\0\0\0\1\0\0\0\377\377\377\377' 'face 0: vertex -1 does not exist'
binary uchar '\3\0\0\0\0\1\0\0\0\2\0\0\0!' 'the file goes on for 1 byte after'
binary int '\377\377\377\377\0\0\0\0' 'the list has -1 entries'
binary uint '\377\377\377\377\0\0\0\0' 'the file ends where face 0: vertex_indices should be'
binary uchar '' 'the file ends where face 0: vertex_indices, its length should be'

# STL.
stl() { # stl SED-SCRIPT MESSAGE
    cat <<'END' | sed "$1" >a.stl
solid one triangle
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid one triangle
END
    refused a.stl "$2"
}
stl '9d' "the file ends where 'endsolid' should be"
stl '8,$d' "the file ends where 'endfacet' should be"
stl '6d' "line 6: 'vertex' is expected here, not 'endloop'"
stl '6s/$/\nvertex 1 1 0/' "line 7: 'endloop' is expected here, not 'vertex'"
stl '5s/1/one/' "line 5: triangle 0 should be a number, it is 'one'"
stl '5s/1/inf/' 'line 5: triangle 0 is .inf., which is not a finite number'
stl '5s/ 0$//' "line 6: triangle 0 should be a number, it is 'vertex'"
stl '9s/$/\nmore/' "line 10: 'solid' is expected here, not 'more'"
stl '2s/1$//; 3,$d; $s/$/\n/' 'the file ends where the normal of triangle 0 should be'
stl '2s/facet/face/' "'facet' or 'endsolid' is expected here, not 'face'"
binary_stl() { # binary_stl COUNT BYTES MESSAGE: a binary file with so many bytes after its count
    (head -c 80 /dev/zero; printf "$1"; head -c "$2" /dev/zero) >a.stl
    refused a.stl "$3"
}
binary_stl '\1\0\0\0' 49 '1 triangle would need 134 bytes, the file has 133'
binary_stl '\0\0\0\0' 51 '0 triangles would need 84 bytes, the file has 135'
binary_stl '\377\377\377\377' 50 '4294967295 triangles would need 214748364834 bytes'
(head -c 80 /dev/zero; printf '\1\0\0\0'; head -c 12 /dev/zero; printf '\0\0\300\177'; head -c 34 /dev/zero) >a.stl
refused a.stl 'triangle 0: a coordinate is not a finite number'

# Meshes that can be read and not refined.
cat >in.off <<'END'
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
not_refined 'edge 0-1: 3 faces'
(cube | sed '$d'; echo '4 7 4 0 3') >in.off
not_refined 'edge 0-3.*reverse one of them'
(cube | sed '2s/8 6/8 7/'; echo '4 3 2 1 0') >in.off
not_refined 'edge'
cube | sed '11s/.*/4 3 2 1 2/' >in.off
not_refined 'face 0: contains vertex 2 twice; remove'
(cube | sed '2s/6/7/'; echo '2 0 1') >in.off
not_refined 'face 6: has 2 corners; remove it'
(cube | sed '2s/6/7/'; echo 0) >in.off
not_refined 'face 6: has 0 corners; remove it'
cat >in.off <<'END'
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
not_refined 'vertex 0.*fans'
printf 'OFF\n0 0 0\n' >in.off
not_refined 'the mesh has no faces'
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >in.off
not_refined 'the mesh has no faces'
# A Moebius strip of five quads cannot be turned to one side.
(echo OFF 10 5 0; for i in 0 1 2 3 4; do echo "$i 0 0"; echo "$i 1 0"; done
    echo 4 0 2 3 1; echo 4 2 4 5 3; echo 4 4 6 7 5; echo 4 6 8 9 7; echo 4 8 1 0 9) >in.off
not_refined 'edge 0-1.*|edge 1-8|edge 0-9'
# All problems are told at once.
cube | sed '2s/8/9/; 10s/$/\n5 5 5/; 12s/.*/4 4 5 6 4/' >in.off
run refine in.off -s catmull-clark -n 1 -o out.off
exits 1
says 'face 1: contains vertex 4 twice'
rm in.off
# An OBJ file counts from 1, and so do the words about its mesh.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 3\n' >in.obj
run refine in.obj -s catmull-clark -n 1 -o out.off
exits 1
says 'face 2: contains vertex 3 twice'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 3 4\n' >in.obj
run info in.obj
exits 1
prints 'edge 2-3: faces 1 and 2 run through it in the same direction'
rm in.obj

# Coordinates that are finite and whose sums are not.
cube | sed '3,10s/1/1e308/g' >in.off
run refine in.off -s catmull-clark -n 1 -o out.off
exits 1
says '^kith: out.off: vertex 0 would not have finite coordinates'
only_input_left in.off
run_from in.off refine - -s no-such-scheme -n 1 -o out.off
exits 2
printf 'OFF\n1 1' >in.off
run_from in.off refine - -s linear -n 1 -o out.off
exits 1
says '^kith: standard input: line 2: '
rm in.off
tetrahedron | sed '3,6s/1/1e39/g' >in.off
run refine in.off -s loop -n 1 -o out.stl --binary
exits 1
says '^kith: out.stl: vertex [0-9]+ is too far away for the floats of binary STL; write text'
only_input_left in.off
rm in.off

# Tags that name what is not there.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt crease 2/1/0 0 2 1\n' >in.obj
run refine in.obj -s catmull-clark -n 1 -o out.off
exits 1
says 'crease 0-2: there is no such edge'
only_input_left in.obj
sed -i 's/^t.*/t corner 1\/1\/0 4 1/' in.obj
run refine in.obj -s catmull-clark -n 1 -o out.off
exits 1
says 'corner 4: there is no such vertex'
only_input_left in.obj
rm in.obj

# Faces that the scheme does not take.
cube >in.off
for scheme in loop sqrt3; do
    for mesh in native cgal openmesh; do
        run refine in.off -s $scheme -n 1 -o out.off --mesh $mesh
        exits 1
        says "^kith: $scheme: face 0 has 4 vertices; triangulate the mesh first, with --triangulate$"
        only_input_left in.off
    done
done

# Triangles back to back, of which every level would have edges with the same ends.
printf 'OFF\n3 2 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n' >in.off
back_to_back='vertex 0 lies between 2 faces only, the scheme needs three; remove these triangles, which are back to back'
run info in.off
exits 0
prints '^between two faces +3; dual schemes and schemes for triangles refuse such vertices$'
for scheme in loop sqrt3 butterfly linear-triangles; do
    for options in '--mesh native' '--mesh cgal' '--mesh openmesh' '--tiles 2'; do
        run refine in.off -s $scheme -n 1 -o out.ply $options
        exits 1
        says "^kith: $scheme: $back_to_back"
        only_input_left in.off
    done
    run plan in.off -s $scheme -n 1
    exits 1
    says "$back_to_back"
done
run refine in.off -s catmull-clark -n 2 -o out.off
exits 0
run refine out.off -s catmull-clark -n 1 -o again.off
exits 0
rm out.off again.off
cube >in.off

# More than memory and indices hold: refused at once, on every kind of mesh.
for mesh in native cgal openmesh; do
    for levels in 11 16 40 2147483647; do
        run refine in.off -s catmull-clark -n $levels -o out.off --mesh $mesh --memory-limit 512M
        exits 1
        says 'bytes at once|32-bit|64 bits'
        only_input_left in.off
    done
done
run refine in.off -s catmull-clark -n 2147483647 -o out.vtu --tiles 2
exits 1
says '^kith: catmull-clark: level 27 has [0-9]{18} vertices and [0-9]{18} edges, whose size in bytes exceeds 64 bits; refine at most 26 times$'
only_input_left in.off
for partitioner in metis block; do
    run refine in.off -s catmull-clark -n 1 -o out.vtu --tiles 4294967295 --partitioner $partitioner
    exits 1
    says '4294967295 parts were asked for, and the mesh has 6 faces; ask for at most 1048576'
    only_input_left in.off
done
printf '0 1 4294967294 3 4 5\n' >in.part
run refine in.off -s catmull-clark -n 1 -o out.vtu --partitioner file:in.part
exits 1
says 'in.part: the partition file gives face 2 part 4294967294, the mesh has 6 faces; number the parts from 0, below'
printf '0 1 2 3 4 5\n' >in.part
run refine in.off -s 4-8 -n 1 -o out.vtu --partitioner file:in.part
exits 1
says 'has 6 numbers, the mesh has 12 faces; give one number per face; these are the faces that `kith plan` counts on level 0'
rm in.part
only_input_left in.off

# Faces and boundaries that a scheme does not take, with what there is to be done.
tetrahedron >in.off
run refine in.off -s kobbelt -n 1 -o out.off
exits 1
says 'face 0 has 3 vertices; split it into quads first, by one step of the linear scheme: `kith refine IN -s linear -n 1'
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >in.off
for scheme in unified interpolatory-sqrt3; do
    run refine in.off -s $scheme -n 1 -o out.off
    exits 1
    says 'a boundary edge; .*scheme with a boundary rule such as catmull-clark or loop; kith fills no holes$'
done
only_input_left in.off
finish
