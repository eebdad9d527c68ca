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
run refine disk.off -s doo-sabin -n 0 -o disk.obj
exits 0

# PLY counts the corners of faces in as many bytes as the largest face needs: as a whole, in tiles, and read again.
(
    echo OFF 301 301 0
    echo 0 0 2
    awk 'BEGIN { for (i = 0; i < 300; ++i) { a = i * 6.283185307 / 300; print cos(a), sin(a), 0 } }'
    echo 300 $(seq 300 -1 1)
    for i in $(seq 300); do echo "3 0 $i $((i % 300 + 1))"; done
) >cone.off
for job in 'doo-sabin 0 ushort' 'doo-sabin 1 ushort' 'doo-sabin 2 ushort' 'catmull-clark 0 ushort' 'catmull-clark 1 uchar'; do
    read -r scheme levels type <<<"$job"
    run refine cone.off -s "$scheme" -n "$levels" -o cone.ply --binary
    exits 0
    has cone.ply "^property list $type int vertex_indices\$"
    run refine cone.off -s "$scheme" -n "$levels" -o whole.off
    run compare whole.off cone.ply --tolerance 0
    exits 0
    prints '^largest distance 0, equal$'
    run refine cone.off -s "$scheme" -n "$levels" -o text.ply
    run compare whole.off text.ply --tolerance 0
    exits 0
    for tiles in 1 3; do
        run refine cone.off -s "$scheme" -n "$levels" -o tiles.ply --tiles "$tiles"
        exits 0
        same cone.ply tiles.ply
    done
done
awk 'BEGIN { printf "OFF 70000 1 0\n"; for (i = 0; i < 70000; ++i) print i, i * i, 0
    printf 70000; for (i = 0; i < 70000; ++i) printf " %d", i; print "" }' >disk.off
run refine disk.off -s catmull-clark -n 0 -o disk.ply --binary
exits 0
has disk.ply '^property list uint int vertex_indices$'
run compare disk.off disk.ply --tolerance 0
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
says '^kith: note: b.stl: 4 bytes after the last of 4 triangles are ignored$'
run refine b.stl -s loop -n 1 -o c.off
exits 0
says 'b.stl: 4 bytes after the last of 4 triangles are ignored'

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
# PLY: strips of triangles; the tetrahedron as one strip, and as two.
strips() { # strips LIST
    sed -n '3,6p' tetra.off >points
    (
        printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
        printf 'element tristrips 1\nproperty list int int vertex_indices\nend_header\n'
        cat points
        echo "$1"
    ) >strips.ply
}
for list in '6 0 2 1 3 0 2' '9 0 2 1 3 -1 2 0 3 1'; do
    strips "$list"
    run refine strips.ply -s loop -n 0 -o strips.off
    exits 0
    says_nothing
    for face in '0 2 1' '1 2 3' '0 1 3' '0 3 2'; do has strips.off "^3  $face$"; done
    has strips.off '^4 4 '
done
strips '8 0 2 1 3 -1 2 0 3'
run info strips.ply
exits 0
prints '^faces +3$'
strips '3 0 2 4'
run info strips.ply
exits 1
says '^kith: strips.ply: line 14: tristrips 0: vertex 4 does not exist, there are 4; correct the index$'

# VTK: compressed by zlib, in one or in several blocks, raw and in base64, with long and short numbers in the head.
cat >vtk.py <<'END'
import base64, struct, sys, zlib
points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
way, header, block = sys.argv[1], sys.argv[2], int(sys.argv[3])
appended, word = b"", {"UInt32": "<I", "UInt64": "<Q"}[header]
def array(type, name, code, numbers, more=""):
    global appended
    data = b"".join(struct.pack("<" + code, x) for x in numbers)
    blocks = [data[i:i + block] for i in range(0, len(data), block)]
    packed = [zlib.compress(b) for b in blocks]
    head = b"".join(struct.pack(word, x) for x in [len(blocks), block, len(data) % block] + [len(p) for p in packed])
    body = b"".join(packed)
    begin = f'<DataArray type="{type}" Name="{name}"{more} '
    if way == "binary":
        return begin + 'format="binary">\n' + (base64.b64encode(head) + base64.b64encode(body)).decode() + "\n</DataArray>\n"
    offset = len(appended)
    appended += head + body if way == "raw" else base64.b64encode(head) + base64.b64encode(body)
    return begin + f'format="appended" offset="{offset}"/>\n'
text = f'<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="{header}" compressor="vtkZLibDataCompressor">\n'
text += '<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="4"><Points>'
text += array("Float32", "Points", "f", [x for p in points for x in p], ' NumberOfComponents="3"') + "</Points><Cells>"
text += array("Int64", "connectivity", "q", [v for f in faces for v in f]) + array("Int64", "offsets", "q", [3, 6, 9, 12])
text += array("UInt8", "types", "B", [5] * 4) + "</Cells></Piece></UnstructuredGrid>\n"
out = text.encode()
if way != "binary":
    out += f'<AppendedData encoding="{way}">\n_'.encode() + appended + b"\n</AppendedData>"
sys.stdout.buffer.write(out + b"\n</VTKFile>\n")
END
for way in binary raw base64; do
    for header in UInt32 UInt64; do
        for block in 16 32768; do
            python3 vtk.py $way $header $block >z.vtu
            good z.vtu
        done
    done
done
python3 vtk.py raw UInt64 32768 >z.vtu
for compressor in LZ4 LZMA; do
    sed "s/vtkZLibDataCompressor/vtk${compressor}DataCompressor/" z.vtu >other.vtu
    run info other.vtu
    exits 1
    says "^kith: other.vtu: is compressed by vtk${compressor}DataCompressor, which is not read; write it with vtkZLibDataCompressor"
done
python3 -c 'bytes = bytearray(open("z.vtu", "rb").read()); bytes[bytes.find(b"\n_") + 2 + 4 * 8 + 4] ^= 1; open("damaged.vtu", "wb").write(bytes)'
run info damaged.vtu
exits 1
says "^kith: damaged.vtu: block 0 of the array 'Points' is damaged; write the file again$"

# What kith writes in pieces is what it writes in one file: vertices between tiles are joined, all keep their numbers.
run refine cube.off -s catmull-clark -n 2 -o whole.vtu --limit
run refine whole.vtu -s catmull-clark -n 0 -o whole.ply
for tiles in 1 2 5; do
    run refine cube.off -s catmull-clark -n 2 -o pieces.pvtu --tiles $tiles --limit
    run refine pieces.pvtu -s catmull-clark -n 0 -o pieces.ply
    exits 0
    says_nothing
    same whole.ply pieces.ply
done
rm pieces.pieces/1.vtu
run info pieces.pvtu
exits 1
says '^kith: pieces.pvtu: pieces.pieces/1.vtu: cannot be opened: No such file or directory$'

# PolyData: polygons and strips; points and lines are left aside.
cat >tetra.vtp <<'END'
<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 2 1 0 1 3 1 2 3 2 0 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>
</Piece></PolyData></VTKFile>
END
good tetra.vtp
run refine tetra.off -s loop -n 1 -o out.pvtp
exits 1
says '^kith: out.pvtp: '
check "no output file" test ! -e out.pvtp
run refine tetra.off -s loop -n 2 -o out.vtp
exits 0
says_nothing
run refine tetra.off -s loop -n 2 -o out.off
run compare out.vtp out.off --tolerance 0
exits 0
for format in off vtp; do
    run refine out.$format -s linear -n 0 -o again_of_$format.off
done
check "the same bytes" cmp again_of_off.off again_of_vtp.off

finish
