# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# Every format gives back what was written, to the last bit: positions in the digits that read back, or as doubles.
run refine cube.off -s doo-sabin -n 3 -o mesh.off
for form in "copy.off" "copy.obj" "copy.ply" "COPY.PLY" "copy.ply --binary"; do
    file=${form%% *}
    run refine cube.off -s doo-sabin -n 3 -o $form
    exits 0
    run compare mesh.off "$file" --tolerance 0
    exits 0
    prints '^largest distance 0, equal$'
done
run refine tetra.off -s sqrt3 -n 3 -o mesh.off
for form in "copy.stl" "copy.off" "copy.obj" "copy.ply"; do
    run refine tetra.off -s sqrt3 -n 3 -o $form
    exits 0
    run compare mesh.off $form --tolerance 0
    exits 0
done
run refine tetra.off -s sqrt3 -n 3 -o copy.stl --binary # floats
exits 0
run compare mesh.off copy.stl --tolerance 0
exits 1
run compare mesh.off copy.stl --tolerance 1e-7
exits 0
check "84 bytes and 50 for each triangle" test "$(stat -c %s copy.stl)" -eq $((84 + 50 * 108))

# What a format cannot hold is refused before anything is written.
run refine cube.off -s catmull-clark -n 1 -o quads.stl
exits 1
says '^kith: quads.stl: face 0 has 4 corners'
check "no output file" test ! -e quads.stl
(
    echo OFF 300 1 0
    for i in $(seq 300); do echo "$i $((i * i)) 0"; done
    echo 300 $(seq 0 299)
) >disk.off
run refine disk.off -s doo-sabin -n 0 -o disk.ply
exits 1
says 'has 300 corners, this format holds 255'
check "no output file" test ! -e disk.ply
run refine disk.off -s doo-sabin -n 0 -o disk.obj
exits 0

good() { # good FILE: holds the tetrahedron
    run compare tetra.off "$1" --tolerance 0
    exits 0
    says_nothing
    prints '^largest distance 0, equal$'
}

# OFF: comments, empty lines, one line for the header, no count of edges, other lines' ends, attributes.
printf '# a comment\n\nOFF # the keyword\n# another\n  4 4\n\n0 0 0 # first\n1 0 0\n\n0 1 0\n0 0 1\n3 0 2 1 # red\n3 0 1 3\n3 1 2 3\n3 2 0 3\n\n#end' >a.off
good a.off
tr '\n' '\r' <tetra.off >a.off
good a.off
sed 's/$/\r/' tetra.off >a.off
good a.off
sed '1d; 2s/.*/OFF 4 4 6/' tetra.off >a.off
good a.off
sed 's/^3.*/& 255 0 0/' tetra.off >a.off
good a.off
sed '3,6s/$/ 0.5 0.5 1 1/; 1s/.*/COFF/' tetra.off >a.off
good a.off
sed '4s/$/ 0.5 0.5 1 1/; 1s/.*/COFF/; 8s/$/ 7/' tetra.off >a.off # only some have colors
good a.off
sed '3,6s/$/ 0 0 1/; 1s/.*/NOFF/' tetra.off >a.off
good a.off
sed '3,6s/$/ 0.1 0.2/; 1s/.*/STOFF/' tetra.off >a.off
good a.off
sed '3,6s/$/ 9 9 9 255 0 0 255 0.1 0.2/; 1s/.*/STCNOFF/' tetra.off >a.off
good a.off
sed '1s/.*/4OFF/; 3s/.*/0 0 0 2/; 4s/.*/2 0 0 2/; 5s/.*/0 -3 0 -3/; 6s/.*/0 0 1 1/' tetra.off >a.off
good a.off
sed 's/^1 0 0/+1.0 -0 0e5/; s/^0 0 1/0. .0 1E+0/' tetra.off >a.off
good a.off

# OBJ: slashes, negative indices, forward references, tabs, continued lines, names, everything that is no polygon.
cat >a.obj <<'END'
# a comment
#without a space
mtllib "some file.mtl"
o a thing
v 0 0 0
v 1 0 0 1.0
	v	0	1	0
v 0 0 1 0.5 0.5 0.5
vt 0 0
vn 0 0 1
g back
usemtl red\green
s off
f 1/1/1 3/1/1 2/1/1
f 1//1 2//1 4//1
f	2/1	3/1	4/1
f -2 -4 \
  -1
l 1 2 3
END
good a.obj
sed 's/$/\r/' a.obj >b.obj
good b.obj
printf 'f 1 3 2\nf 1 2 4 # a face\nf 2 3 4\nf 3 1 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1' >a.obj
good a.obj
(cat a.obj; printf '\nt crease 2/1/0 0 1 2.0\n') >b.obj
good b.obj

# PLY: text and both byte orders, other types, other elements, comments before the format, any ends of lines.
ply() { # ply FORMAT: a header
    printf 'ply\nformat %s 1.0\ncomment written by hand\nelement vertex 4\nproperty float x\nproperty float y\n' "$1"
    printf 'property float z\nproperty uchar red\nelement edge 1\nproperty list uchar short ends\n'
    printf 'element face 4\nproperty list uchar int vertex_index\nproperty double area\nend_header\n'
}
one=3f800000
zero=00000000
bytes() { # bytes HEX...: in this order
    local hex
    hex=$(echo "$*" | tr -d ' ')
    printf "$(echo "$hex" | sed 's/../\\x&/g')"
}
(
    ply binary_big_endian
    bytes $zero $zero $zero ff $one $zero $zero 00 $zero $one $zero 80 $zero $zero $one 01
    bytes 02 0000 0001
    for face in "0 2 1" "0 1 3" "1 2 3" "2 0 3"; do
        set -- $face
        bytes 03 0000000$1 0000000$2 0000000$3 3ff0000000000000
    done
) >big.ply
good big.ply
one=0000803f
(
    ply binary_little_endian
    bytes $zero $zero $zero ff $one $zero $zero 00 $zero $one $zero 80 $zero $zero $one 01
    bytes 02 0000 0100
    for face in "0 2 1" "0 1 3" "1 2 3" "2 0 3"; do
        set -- $face
        bytes 03 0${1}000000 0${2}000000 0${3}000000 000000000000f03f
    done
) >little.ply
good little.ply
(
    ply ascii
    printf '0 0 0 255 1 0 0 0\n0 1 0 128\n\n0 0 1 1\n2 0 -1\n'
    printf '3 0 2 1 1e0\n3 0 1 3 1\n3 1 2 3 nine\n3 2 0 3 1\n' | sed 's/nine/9/'
) >a.ply
good a.ply
sed 's/$/\r/' a.ply >b.ply
good b.ply
sed '2d; 3s/.*/&\nobj_info none\nformat ascii 1.0/' a.ply >b.ply
check "the format comes late" test "$(sed -n 4p b.ply)" = 'format ascii 1.0'
good b.ply
sed 's/uchar int vertex_index/uint32 uint32 vertex_indices/; s/float/float64/' a.ply >b.ply
good b.ply

# STL: text and binary; triangles that share points share vertices; a binary header may begin with "solid".
run refine tetra.off -s loop -n 0 -o a.stl
good a.stl
run info a.stl
exits 0
prints '^vertices +4$'
sed '1s/.*/solid facet of solid things\r/; $s/.*/  endsolid facet/; s/^/\t /; s/normal .*/normal vertex nan 0/' a.stl >b.stl
good b.stl
(cat a.stl; sed 's/vertex /vertex 1/' a.stl) >b.stl # two solids
run info b.stl
exits 0
prints '^components +2$'
run refine tetra.off -s loop -n 0 -o a.stl --binary
good a.stl
(printf 'solid with a name'; tail -c +18 a.stl) >b.stl
good b.stl
(cat a.stl; printf more) >b.stl
run compare tetra.off b.stl --tolerance 0
exits 0
says '^kith: note: b.stl: 4 bytes after the last of 4 triangles are left aside$'
run refine b.stl -s loop -n 1 -o c.off
exits 0
says 'b.stl: 4 bytes after the last of 4 triangles are left aside'

# What editors and other programs make of the same files: a byte order mark, capitals, everything on one line.
run refine tetra.off -s loop -n 0 -o a.stl
run refine tetra.off -s loop -n 0 -o a.obj
run refine tetra.off -s loop -n 0 -o a.ply
for file in tetra.off a.obj a.ply a.stl; do
    (printf '\357\273\277'; cat $file) >b.${file##*.}
    good b.${file##*.}
    tr '\n' '\r' <$file >b.${file##*.}
    good b.${file##*.}
done
sed 's/solid/SOLID/; s/facet/Facet/' a.stl >b.stl
good b.stl
tr '\n' ' ' <tetra.off >b.off
good b.off
sed '1s/.*/off/' tetra.off >b.off
good b.off
sed 's/double x/int x/; s/double y/short y/; s/uchar int/int16 uint8/' a.ply >b.ply
good b.ply
finish
