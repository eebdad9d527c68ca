# SPDX-License-Identifier: BSD-3-Clause
# Files as other programs write them: what they say is kept, or told.
source "$(dirname "$0")/check.bash"
no_commands() { # what is printed cannot upset a terminal
    check "no control characters" test "$(cat "$results/out" "$results/err" | LC_ALL=C tr -d '\n\t -~' | LC_ALL=C tr -d '\302-\364\240-\277' | wc -c)" -eq 0
}

# OFF: each colour is of its own kind, bytes or shares of 1.
tetrahedron >plain.off
paint() { # paint COLOR...: a colour for each face, which may be empty
    awk 'BEGIN { for (i = 1; i < ARGC; ++i) color[i] = ARGV[i]; ARGC = 1; ARGV[1] = "plain.off"; ARGC = 2 }
        { print $0, (NR > 6 ? color[NR - 6] : "") }' "$@"
}
paint '255 0 51' '0.0 1.0 0.0' '0.5 0.5 1.0' '0 0 255' >mixed.off
for levels in 0 1; do
    run refine mixed.off -s loop -n $levels -o out.off
    exits 0
    says_nothing
    for color in '1.0 0.0 0.2 1.0' '0.0 1.0 0.0 1.0' '0.5 0.5 1.0 1.0' '0.0 0.0 1.0 1.0'; do
        check "$((4 ** levels)) faces should be $color" test "$(grep -c "  ${color//./\\.}$" out.off)" -eq $((4 ** levels))
    done
done
run refine mixed.off -s loop -n 1 -o out.ply
has out.ply '^property double red$'
check "colours in PLY" test "$(grep -c ' 1 0 0.2$' out.ply) $(grep -c ' 0 1 0$' out.ply)" = '4 4'

# What has no colour has none, and where the format cannot say so it is told, also in tiles.
paint '249 215 44' '249 215 44 128' >some.off
for levels in 0 1; do
    faces=$((4 ** levels))
    run refine some.off -s loop -n $levels -o out.off
    exits 0
    says_nothing
    check "half of the faces have colours" awk -v n=$faces 'NF == 8 { ++c } NF == 4 && NR > 3 { ++none } END { exit !(c == 2 * n && none == 2 * n) }' out.off
    for kind in '' --binary; do
        # shellcheck disable=SC2086 # no word where it is empty
        run refine some.off -s loop -n $levels -o out.ply $kind
        exits 0
        says "^kith: note: out.ply: this format cannot mark missing values; it has 0 for: the colours of $((2 * faces)) of $((4 * faces)) faces\$"
        check "one note" test "$(wc -l <"$results/err")" -eq 1
    done
    run refine some.off -s loop -n $levels -o tiles.ply --tiles 2 --binary
    exits 0
    says 'tiles.ply: this format cannot mark missing values; it has 0 for: the colours of 2 of 4 faces$'
    same out.ply tiles.ply
    run refine some.off -s loop -n $levels -o out.vtu --tiles 2
    says 'out.vtu: this format cannot mark missing values; it has 0 for: the colours of 2 of 4 faces$'
done
printf 'v 0 0 0 1 .5 .25\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n' >dots.obj
run refine dots.obj -s loop -n 0 -o out.ply
exits 0
says 'the colours of 3 of 4 vertices$'
check "no nan" test "$(grep -c nan out.ply)" -eq 0
run refine dots.obj -s loop -n 1 -o out.ply
says 'dots.obj: not kept: colours around vertices without a value$'
says 'has 0 for: the colours of [0-9] of 9 vertices$'
check "no nan" test "$(grep -c nan out.ply)" -eq 0
run refine dots.obj -s loop -n 1 -o serial.ply --binary
run refine dots.obj -s loop -n 1 -o tiles.ply --tiles 2
says 'has 0 for: the colours of 3 of 4 vertices$'
same serial.ply tiles.ply
run refine dots.obj -s loop -n 0 -o out.obj
says_nothing
check "a colour at one vertex" test "$(grep -c '^v .* .* .* .* .* ' out.obj)" -eq 1
# Faces that are born by edges and vertices have no colour, either.
run refine mixed.off -s doo-sabin -n 1 -o out.ply
exits 0
says 'has 0 for: the colours of 10 of 14 faces$'
check "no nan" test "$(grep -c nan out.ply)" -eq 0
run refine mixed.off -s doo-sabin -n 1 -o serial.ply --binary
run refine mixed.off -s doo-sabin -n 1 -o tiles.ply --tiles 2
says 'has 0 for: the values of faces made at edges or vertices$'
same serial.ply tiles.ply
run refine mixed.off -s loop -n 1 -o tiles.ply --tiles 2
says '^kith: note: tiles.ply is binary'
check "nothing else" test "$(wc -l <"$results/err")" -eq 1
printf 'NSTOFF\n3 1 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n0 1 0\n3 0 1 2\n' >part.off
run refine part.off -s loop -n 0 -o out.off
says 'has 0 for: the normals of 1 of 3 vertices, the texture coordinates of 1 of 3 vertices$'

# Binary STL has colours behind its triangles, in two ways.
stl() { # stl HEADER BYTES...: a tetrahedron with these two bytes behind each triangle, as printf writes them
    header=$1
    shift
    printf "$header"
    head -c $((80 - $(printf "$header" | wc -c))) /dev/zero | tr '\0' ' '
    printf '\4\0\0\0'
    zero='\0\0\0\0' one='\0\0\200\77'
    for triangle in "$zero$zero$zero$zero$one$zero$one$zero$zero" "$zero$zero$zero$one$zero$zero$zero$zero$one" \
        "$one$zero$zero$zero$one$zero$zero$zero$one" "$zero$one$zero$zero$zero$zero$zero$zero$one"; do
        printf "$zero$zero$zero$triangle$1"
        shift
    done
}
stl 'any words' '\0\374' '\340\203' '\37\200' '\0\0' >viscam.stl
stl 'COLOR=\12\24\36\377' '\37\0' '\340\3' '\0\174' '\0\200' >materialise.stl
for file in viscam materialise; do
    run info $file.stl
    exits 0
    prints '^attributes +colours of faces$'
    run refine $file.stl -s loop -n 1 -o out.off
    exits 0
    says_nothing
    for color in '255 0 0' '0 255 0' '0 0 255'; do
        check "four faces of $file.stl should be $color" test "$(grep -c "  $color 255$" out.off)" -eq 4
    done
    run refine $file.stl -s loop -n 0 -o out.stl
    exits 0
    says "^kith: note: $file.stl: not kept: colours of faces$"
    run refine $file.stl -s loop -n 1 -o out.stl --binary
    exits 0
    run refine out.stl -s loop -n 0 -o again.off
    check "four red faces" test "$(grep -c '  255 0 0 255$' again.off)" -eq 4
done
check "four faces have the colour of the part" test "$(grep -c '  8 16 33 255$' again.off)" -eq 4
run refine viscam.stl -s loop -n 0 -o out.stl --binary
says_nothing
check "the bytes of the colours are those of the file" cmp -s <(tail -c +85 viscam.stl | tail -c 2 | od -tx1) <(tail -c 2 out.stl | od -tx1)
run refine materialise.stl -s loop -n 0 -o out.stl --binary
says 'not kept: colours of faces beyond 32 shades of red, green and blue$'
stl 'any words' '\1\0' '\2\0' '\3\0' '\4\0' >bytes.stl
run refine bytes.stl -s loop -n 0 -o out.off
says 'not kept: the two attribute bytes of each triangle$'

# Binary STL rounds to floats: triangles that fall together are left out, which is told, and what is left can be read.
far=16777216
{
    echo "OFF 7 5 0"
    echo "$far 0 0 $((far + 2)) 0 0 $((far + 4)) 0 0 $far 1 0 $((far + 2)) 1 0 $far.5 1 0 $((far + 4)) 1 0"
    echo "3 0 1 4 3 0 4 5 3 0 5 3 3 1 2 6 3 1 6 4"
} >strip.off
run refine strip.off -s loop -n 0 -o out.stl --binary
exits 0
says '^kith: note: out.stl: the floats of binary STL move coordinates by up to 0.5; 1 of 5 triangles collapses and is left out; '
run info out.stl
exits 0
prints '^faces +4$'
prints '^vertices +6$'
echo "OFF 3 1 0 $far 0 0 $((far + 8)) 0 0 $((far + 3)) 9 0 3 0 1 2" >wide.off
run refine wide.off -s linear-triangles -n 0 -o out.stl --binary
exits 0
says '^kith: note: out.stl: the floats of binary STL move coordinates by up to 1; text, .off, .obj and .ply keep doubles$'
run refine plain.off -s loop -n 4 -o out.stl --binary
exits 0
says_nothing
run refine strip.off -s loop -n 0 -o out.stl
exits 0
says_nothing
run info out.stl
prints '^faces +5$'
tetrahedron | awk 'NR > 2 && NR < 7 { $1 = 4500000.01 + $1 / 100; $2 = 5300000.02 + $2 / 100; $3 = 100.001 + $3 / 100; print $1 + 0 " " $2 " " $3; next } { print }' OFMT=%.12g CONVFMT=%.12g >utm.off
rm -f out.stl
run refine utm.off -s loop -n 1 -o out.stl --binary
exits 1
says '^kith: out.stl: [0-9]+ of 16 triangles collapse in the floats of binary STL, and the others form no surface that can be read; write text, .off, .obj or .ply, or move the mesh to the origin$'
check "nothing is written" test ! -e out.stl
for format in stl ply off obj; do
    run refine utm.off -s loop -n 1 -o out.$format
    exits 0
    says_nothing
    run info out.$format
    exits 0
    prints '^faces +16$'
done

# OFF: colours before normals, as MeshLab writes them, and after, as Geomview does.
for word in CNOFF NCOFF; do
    printf "$word\n3 1 0\n0 0 0 255 0 0 255 0 0 1\n1 0 0 0 255 0 255 0 0 1\n0 1 0 0 0 255 255 0 0 1\n3 0 1 2\n" >colors_first.off
    printf "$word\n3 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 255 0 255\n0 1 0 0 0 1 0 0 255 255\n3 0 1 2\n" >normals_first.off
    for file in colors_first normals_first; do
        run refine $file.off -s loop -n 0 -o $file.ply
        exits 0
        says_nothing
        has $file.ply '^1 0 0 0 0 1 0 255 0 255$'
    done
done
for word in NCSTOFF CSTOFF NSTOFF STNOFF; do
    numbers=
    case $word in *C*) numbers=' 9 8 7 255' ;; esac
    case $word in *N*) numbers="$numbers 0 1 0" ;; esac
    printf "$word\n3 1 0\n0 0 0$numbers 0 .5\n1 0 0$numbers 0 .5\n0 1 0$numbers 0 .5\n3 0 1 2\n" >a.off
    run refine a.off -s loop -n 0 -o out.ply
    exits 0
    says_nothing
    case $word in *C*) has out.ply ' 9 8 7 255 0 0.5$' ;; esac
    case $word in *N*) has out.ply '^1 0 0 0 1 0 ' ;; esac
done
sed 's/ 9 8 7 255//; s/NSTOFF/NCOFF/; s/ 0 .5$/ 0 0 1/; s/STNOFF/NCOFF/' a.off >open.off
run refine open.off -s loop -n 0 -o out.ply
exits 0
says '^kith: note: open.off: the order of vertex colours and normals is ambiguous; colours are read first, as MeshLab'

# OBJ: normals that the faces refer to and the file does not have.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nf 1/1/1 2/2/2 3/1/3\nf 2/2/4 4/1/5 3/1/6\n' >bare.obj
run refine bare.obj -s loop -n 1 -o out.obj
exits 0
says '^kith: note: bare.obj: faces refer to normals, and the file has none; the references are left out$'
check "one note" test "$(wc -l <"$results/err")" -eq 1
check "texture coordinates stay" test "$(grep -c '^vt' out.obj)" -gt 2
(sed 's/^vt 0 0/&\nvn 0 0 1/' bare.obj; echo 'f 1//9 2//1 3//1') >few.obj
run refine few.obj -s loop -n 1 -o out.off
exits 1
says '^kith: few.obj: line 8: face 1: normal 2 does not exist, there are 1; correct the index$'

# Control characters in names and paths stay off the terminal, whatever the format and the message.
escape=$(printf '\033[31mRED\007')
ply() { # ply PROPERTY VALUE
    printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float %s\n' "$1"
    printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 %s\n1 0 0 1\n0 1 0 1\n3 0 1 2\n' "$2"
}
for value in q 1; do
    ply "$escape" $value >name.ply
    ply "quality" $value >"$escape.ply"
    for file in name.ply "$escape.ply"; do
        for arguments in "info" "info --json" "refine -s loop -n 1 -o out.off" "plan -s loop -n 1"; do
            run ${arguments%% *} "$file" $(test "${arguments#* }" != "$arguments" && echo "${arguments#* }")
            no_commands
        done
    done
done
ply "$escape" q >name.ply
run info name.ply
exits 1
says "^kith: name.ply: line 11: vertex 0: \?\[31mRED\? should be a number, it is 'q'$"
run info "$escape.ply"
prints '^file +\?\[31mRED\?.ply$'
run refine plain.off -s loop -n 1 -o "$escape.off"
exits 0
no_commands
prints '^\?\[31mRED\?.off: '
run refine plain.off -s "$escape" -n 1 -o out.off
exits 2
no_commands
run refine "$escape.obj" -s loop -n 1 -o out.off
exits 1
no_commands
says '^kith: \?\[31mRED\?.obj: cannot be opened'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\ng %s\nusemtl %s\nf 1 2 3\nt %s 1/0/0 1\n' "$escape" "$escape" "$escape" >words.obj
for verb in info refine; do
    run $verb words.obj $(test $verb = refine && echo -s loop -n 1 -o out.off)
    exits 0
    no_commands
done
cp plain.off höhe.off # while letters stay
run info höhe.off
prints '^file +höhe.off$'

# PLY of several textures: their numbers are lost in OBJ, not the coordinates.
cat >textured.ply <<'END'
ply
format ascii 1.0
comment TextureFile a.png
comment TextureFile b.png
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
property list uchar float texcoord
property int texnumber
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2 6 0 0 .5 0 .5 1 0
3 0 2 3 6 0 0 1 1 0 1 1
END
run refine textured.ply -s loop -n 0 -o out.obj
exits 0
says '^kith: note: textured.ply: not kept: texture numbers, names of texture files$'
has out.obj '^vt 0.5 1$'
run refine textured.ply -s loop -n 1 -o out.ply
exits 0
says_nothing
check "each face has its texture" test "$(grep -c '^3 .* 0$' out.ply) $(grep -c '^3 .* 1$' out.ply)" = '4 4'
finish
