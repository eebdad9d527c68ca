# SPDX-License-Identifier: BSD-3-Clause
# What files say of their meshes besides places, refined in tiles: the bytes of the program without tiles.
source "$(dirname "$0")/check.bash"
source "$(dirname "$0")/attribute_meshes.bash"
rich_cube >rich.ply
charts 6 >charts.obj

in_tiles() { # in_tiles IN ARGUMENTS...: PLY for several tilings
    local in=$1 tiling
    shift
    run refine "$in" -o whole.ply --binary --drop-isolated "$@"
    exits 0
    for tiling in '1' '5 --threads 3 --verify' '8 --partitioner block'; do
        # shellcheck disable=SC2086 # several words
        run refine "$in" -o tiles.ply "$@" --tiles $tiling
        exits 0
        same whole.ply tiles.ply
    done
}
for levels in 0 1 3; do
    for uv in none corners+1 all; do
        in_tiles rich.ply -s catmull-clark -n $levels --uv $uv
        in_tiles charts.obj -s catmull-clark -n $levels --uv $uv
    done
done
for uv in none corners corners+2 boundaries; do
    in_tiles charts.obj -s loop --triangulate -n 2 --uv $uv --crease-angle 20
    in_tiles charts.obj -s catmull-clark -n 2 --uv $uv --crease-angle 20 --crease-sharpness 1.5
done
for scheme in doo-sabin mid-edge kobbelt nasri-hasbini linear; do
    in_tiles rich.ply -s $scheme -n 2
    in_tiles charts.obj -s $scheme -n 2
done
for scheme in loop sqrt3 butterfly linear-triangles; do
    in_tiles charts.obj -s $scheme -n 2 --triangulate
done
in_tiles rich.ply -s 4-8 -n 3 # which begins with another mesh
in_tiles charts.obj -s 4-8 -n 3
in_tiles charts.obj -s catmull-clark -n 2 --limit
grid 4 >grid.obj # words, and the file of the materials
in_tiles grid.obj -s catmull-clark -n 1
has tiles.ply '^comment mtllib paint.mtl$'
check "each group has its comment" test "$(grep -ac '^comment word group ' tiles.ply)" -eq 16
run refine grid.obj -s catmull-clark -n 1 -o straight.obj
run refine tiles.ply -s catmull-clark -n 0 -o back.obj
exits 0
same straight.obj back.obj
sed '2a comment TextureFile my skin.png' rich.ply >picture.ply # as MeshLab has it
in_tiles picture.ply -s catmull-clark -n 1
has tiles.ply '^comment TextureFile my skin.png$'
run refine picture.ply -s catmull-clark -n 0 -o back.obj
says "names of texture files"
run refine charts.obj -s catmull-clark -n 2 -o linear.ply --binary
run refine charts.obj -s catmull-clark -n 2 -o smooth.ply --binary --uv none
check "they differ" test "$(cmp -l linear.ply smooth.ply | wc -l)" -gt 100

# What a file does not hold is named.
run refine rich.ply -s catmull-clark -n 1 -o out.ply --tiles 2 --binary
says "^kith: note: rich.ply: not kept: the property 'others' of faces, 1 vertex without a face$"
run refine rich.ply -s catmull-clark -n 1 -o out.vtu
says "^kith: note: rich.ply: not kept: the property 'others' of faces, 1 vertex without a face, texture coordinates$"
run refine charts.obj -s catmull-clark -n 1 -o out.ply --tiles 2 --binary
says_nothing
run refine charts.obj -s catmull-clark -n 1 -o out.vtu
says '^kith: note: charts.obj: not kept: texture coordinates$'
sed 's/ushort patch/ushort level/' rich.ply >level.ply # which is what a file of tiles says itself
run refine level.ply -s catmull-clark -n 1 -o out.vtu
exits 0
says "texture coordinates, the property 'level' of faces$"
run refine charts.obj -s kobbelt -n 1 -o out.ply --uv none --tiles 2
exits 2
says '^kith: --uv: only catmull-clark, loop and quad-tri have rules for seams'
sed '$s/\/[0-9]*//g' charts.obj >partly.obj # the last face has no texture
run refine partly.obj -s catmull-clark -n 1 -o out.ply --tiles 2 --binary
exits 0
says '^kith: note: partly.obj: not kept: texture coordinates that no corner has, texture coordinates, which some faces do not have$'
printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny
property float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n' >normals.ply
in_tiles normals.ply -s linear -n 0
has tiles.ply '^property float nz$'
run refine normals.ply -s linear -n 1 -o out.ply --tiles 2 --binary
says '^kith: note: normals.ply: not kept: normals$'
in_tiles normals.ply -s catmull-clark -n 1 --limit

# VTU: values at points and in cells under their names and in their types, the same as in PLY.
run refine rich.ply -s doo-sabin -n 2 -o whole.vtu
exits 0
for tiles in 2 6; do
    run refine rich.ply -s doo-sabin -n 2 -o tiles.vtu --tiles $tiles --verify
    exits 0
    same whole.vtu tiles.vtu
done
run refine rich.ply -s doo-sabin -n 2 -o text.ply --drop-isolated
array() { # array NAME TYPE_OF_VTK TYPE_OF_OD: its values, one a line
    local line
    line=$(grep -a "Name=\"$1\"" whole.vtu)
    check "the type of $1" grep -q "type=\"$2\"" <<<"$line"
    local start=$(($(grep -abo '^_' whole.vtu | head -n 1 | cut -d: -f1) + 1 + $(sed 's/.*offset="\([0-9]*\)".*/\1/' <<<"$line")))
    local bytes
    bytes=$(od -An -t u8 -j $start -N 8 whole.vtu)
    od -An -v -w"${3:1}" -t "$3" -j $((start + 8)) -N $bytes whole.vtu | awk '{ print $1 + 0 }'
}
column() { # column N vertex|face: the values of the text file; those of no parent are 0 in whole numbers
    awk -v n="$1" -v what="$2" '$1 == "element" { count[$2] = $3 } body { ++line } $1 == "end_header" { body = 1 }
        line && (line <= count["vertex"]) == (what == "vertex") { print (n > 0 ? $n : $(NF + n)) + 0 }' text.ply
}
vertices() { awk '$1 == "element" { count[$2] = $3 } body && ++line <= count["vertex"] { print } $1 == "end_header" { body = 1 }' "$1"; }
# ids_and_areas FILE: the properties patch and area of the faces, where they stand in a text file.
ids_and_areas() {
    awk '$1 == "element" { count[$2] = $3; what = $2; at = 0 } $1 == "property" && what == "face" && $2 != "list" { ++at; place[$3] = at; last = at }
        body && ++line > count["vertex"] { print $(NF - last + place["patch"]) + 0, $(NF - last + place["area"]) } $1 == "end_header" { body = 1 }' "$1"
}
same_values() { check "values of $1" test "$(array "$1" "$2" "$3")" = "$(column "$4" "$5")"; }
same_values px Float64 f8 4 vertex
same_values red UInt8 u1 5 vertex
same_values id Int32 d4 9 vertex
same_values patch UInt16 u2 -1 face
check "as cells, the others at points" awk '/<CellData>/ { cell = 1 } /"(patch|area)"/ { wrong += !cell } /"(px|id)"/ { wrong += cell } END { exit wrong > 0 }' whole.vtu
# It is read again with them.
for levels in 0 2; do
    run refine rich.ply -s doo-sabin -n $levels -o first.vtu
    run refine first.vtu -s doo-sabin -n 0 -o second.vtu
    exits 0
    says "^kith: note: first.vtu: not kept: the property 'parent' of faces, the property 'level' of faces$"
    run compare first.vtu second.vtu --tolerance 0
    exits 0
    run refine second.vtu -s doo-sabin -n 0 -o third.vtu
    same second.vtu third.vtu
    run refine first.vtu -s doo-sabin -n 0 -o read.ply
    run refine rich.ply -s doo-sabin -n $levels -o text.ply --drop-isolated
    check "the vertices of level $levels" test "$(vertices read.ply)" = "$(vertices text.ply)"
    check "and faces" test "$(ids_and_areas read.ply)" = "$(ids_and_areas text.ply)"
done
# So are words, whose numbers are in cells: an OBJ file that goes through VTU has its groups and materials again, a line to a change.
run refine grid.obj -s catmull-clark -n 1 -o grid.vtu
exits 0
says '^kith: note: grid.obj: not kept: texture coordinates, materials$' # the name of their file
for tiles in 2 7; do
    run refine grid.obj -s catmull-clark -n 1 -o tiles.vtu --tiles $tiles --verify
    same grid.vtu tiles.vtu
done
run refine grid.vtu -s catmull-clark -n 0 -o back.obj
exits 0
run refine grid.obj -s catmull-clark -n 1 -o straight.obj
words() { sed 's/\/[0-9]*//g' "$1" | grep -v '^vt\|^mtllib\|^vn'; }
check "the words are the same" test "$(words back.obj)" = "$(words straight.obj)"
check "and there are some" test "$(grep -cE '^(g|usemtl|s|o) ' back.obj)" -gt 25
run refine rich.ply -s catmull-clark -n 2 -o out.pvtu --tiles 3 --verify
exits 0
has out.pvtu '^<PDataArray type="Int32" Name="id"/>$'
has out.pieces/1.vtu 'type="UInt16" Name="patch"'

# A journal keeps them with the mesh, and goes on to the same bytes.
for output in out.ply out.vtu; do
    run refine charts.obj -s catmull-clark -n 3 -o $output --uv none --tiles 6
    exits 0
    mv $output whole.${output#*.}
    run refine charts.obj -s catmull-clark -n 3 -o $output --uv none --tiles 6 --journal kept --only 1..3
    exits 0
    run refine charts.obj -s catmull-clark -n 3 -o $output --tiles 6 --journal kept
    exits 1
    says "kept: is the journal of another refinement: its uv is 'none', not 'all'"
    sed '0,/^v /s/^\(v .* \)[0-9.]* \([0-9.]*\) \([0-9.]*\)$/\10.875 \2 \3/' charts.obj >other.obj
    run refine other.obj -s catmull-clark -n 3 -o $output --uv none --tiles 6 --journal kept
    exits 1
    says "kept: is the journal of another refinement: its control mesh, creases or attributes differ"
    run refine --journal kept --verify
    exits 0
    prints ', verified$'
    same $output whole.${output#*.}
done

# A value that is another one in the file is found.
run refine charts.obj -s catmull-clark -n 3 -o out.vtu --uv none --tiles 6 --journal kept --only 0..4
exits 0
cp kept/surface before
offset=$(grep -a 'Name="green"' before | sed 's/.*offset="\([0-9]*\)".*/\1/')
at=$(($(grep -abo '^_' before | head -n 1 | cut -d: -f1) + 1 + offset + 8 + 8))
printf '\x55' | dd of=kept/surface bs=1 seek=$at conv=notrunc status=none
run refine --journal kept --verify
exits 0
says "^kith: note: tile [0-4] is damaged, byte $at of kept/surface is wrong; the tile is written again$"
same out.vtu whole.vtu

# They take memory, which is counted: a limit that is enough for the mesh alone is not for the attributes.
export OMP_NUM_THREADS=1
run refine charts.obj -s catmull-clark -n 3 -o control.ply --binary
run refine control.ply -s catmull-clark -n 3 -o out.ply --tiles 6 --memory-limit 100
exits 1
with=$(sed -n 's/.*largest tile needs \([0-9]*\).*/\1/p' "$results/err")
awk '$1 == "v" { print $1, $2, $3, $4; next } $1 == "f" { gsub(/\/[0-9]*/, ""); print }' charts.obj >plain.obj
run refine plain.obj -s catmull-clark -n 3 -o plain.ply --binary
run refine plain.ply -s catmull-clark -n 3 -o out.ply --tiles 6 --memory-limit 100
without=$(sed -n 's/.*largest tile needs \([0-9]*\).*/\1/p' "$results/err")
check "there are more bytes for attributes: $with, $without" test "$with" -gt $((without * 3 / 2))
finish
