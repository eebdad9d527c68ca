# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off
tetrahedron >tetra.off

# size FILE: width and height in the header of a PNG.
size() { echo "$((0x$(od -An -tx1 -j16 -N4 "$1" | tr -d ' '))) $((0x$(od -An -tx1 -j20 -N4 "$1" | tr -d ' ')))"; }
# drawn FILE ARGUMENTS...: draws a picture, which is not empty.
drawn() {
    local file=$1
    shift
    run picture "$@" -o "$file"
    exits 0
    says_nothing
    prints "^$file: [0-9]+ x [0-9]+ pixels, [0-9]+ polygons$"
    check "writes $file" test -s "$file"
}

if "$kith" picture cube.off -s catmull-clark -o plain.png 2>&1 | grep -q 'without libpng'; then
    echo "no PNG in this build"
    end=svg
else
    end=png
    drawn plain.png cube.off -s catmull-clark
    check "has the default size" test "$(size plain.png)" = "800 600"
    for threads in 1 3; do
        OMP_NUM_THREADS=$threads drawn again.png cube.off -s catmull-clark
        same plain.png again.png
    done
    drawn small.png cube.off -s catmull-clark --size 64x48 --transparent
    check "has the size" test "$(size small.png)" = "64 48"
    drawn side.png cube.off -s catmull-clark,doo-sabin -n 0,1,2
    check "has rows and columns" test "$(size side.png)" = "1200 800"
fi

# What is drawn changes the picture.
drawn base.$end cube.off -s catmull-clark
for more in "--wire 1" --cage "--color parent" "--color mean" "--color gaussian" "--color reflection" "--view front" \
    "--view 10,20" "--color tile --tiles 2 --partitioner block" "-n 2" "--crease-angle 30"; do
    drawn other.$end cube.off -s catmull-clark $more
    check "$more changes the picture" test "$(cmp -s base.$end other.$end && echo same)" != same
done
drawn up.$end cube.off -s catmull-clark --up y --color parent
for scheme in doo-sabin mid-edge 4-8 linear unified; do
    drawn other.$end cube.off -s $scheme --wire 1 --color parent
done
drawn other.$end tetra.off -s loop --wire 2
drawn other.$end tetra.off -s sqrt3 --wire 1

# SVG has a polygon per face of a level that is seen, and the titles.
drawn levels.svg cube.off -s catmull-clark -n 0,1 --view front
check "has the face of the cube in front and the twelve of level 1" test "$(grep -c '<path' levels.svg)" -eq $((1 + 12))
has levels.svg '>level 0</text>'
has levels.svg '>level 1</text>'
run picture cube.off -s catmull-clark -n 1 -o one.svg --json
exits 0
prints '^\{"output":"one.svg","width":800,"height":600,"polygons":24\}$'
run_from cube.off picture - -s catmull-clark -n 1 -o two.svg
exits 0
same one.svg two.svg

# Attributes with a legend.
cat >valued.ply <<'END'
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
property double quality
element face 4
property list uchar int vertex_indices
property int part
end_header
1 1 1 1
1 -1 -1 2
-1 1 -1 3
-1 -1 1 4
3 0 1 2 0
3 0 3 1 0
3 0 2 3 5
3 1 3 2 5
END
drawn quality.svg valued.ply -s loop --color attribute:quality -n 0
has quality.svg '>quality</text>'
has quality.svg '>4</text>'
drawn part.svg valued.ply -s loop --color attribute:part -n 1
has part.svg '>5</text>'

# Images lie on the surface by its texture coordinates: the first quarter of a square has the lower left corner.
cat >square.obj <<'END'
v 0 0 0
v 1 0 0
v 1 0 1
v 0 0 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
END
drawn checker.svg square.obj -s linear -n 3 --view front --color checker
check "64 squares have three colors, one of them once" test "$(
    grep -o "<path fill='#[0-9a-f]*'" checker.svg | sort | uniq -c | awk '{ print $1 }' | sort -n | tr '\n' ' ')" = "1 31 32 "
if [ $end = png ]; then
    drawn checker.png square.obj -s linear --view front --color checker --size 64x64
    drawn again.png square.obj -s linear --view front --color texture:checker.png --size 64x64
    check "an image of an image is another one" test "$(cmp -s again.png checker.png && echo same)" != same
fi

# Each level has a color of its own.
drawn levels.svg cube.off -s catmull-clark -n 0,2,3 --color level
has levels.svg '>level</text>'
for level in 0 2 3; do has levels.svg ">$level</text>"; done

# Tile t lies on rank t modulo the ranks; without --tiles each rank has a tile.
drawn ranks.svg cube.off -s catmull-clark -n 0 --color rank --ranks 2 --tiles 6 --partitioner block
has ranks.svg '>rank</text>'
has ranks.svg '>1</text>'
check "the last of two ranks is 1" test "$(grep -c '>2</text>' ranks.svg)" -eq 0
drawn tiles.svg cube.off -s catmull-clark -n 0 --color tile --tiles 2 --partitioner block
drawn again.svg cube.off -s catmull-clark -n 0 --color rank --ranks 2 --partitioner block
check "a rank each is a tile each" cmp -s <(sed 's/>rank</>tile</' again.svg) tiles.svg

# Holes are left out.
{
    sed -n '3,10s/^/v /p' cube.off
    sed -n '11,16p' cube.off | while read -r _ a b c d; do
        echo "f $((a + 1)) $((b + 1)) $((c + 1)) $((d + 1))"
    done
    echo 't hole 1/0/0 0'
} >hole.obj
run picture hole.obj -s catmull-clark -n 1 -o hole.svg --json
exits 0
prints '"polygons":20\}$'
drawn hole.svg hole.obj -s catmull-clark --wire 0

rm -f ./*.png ./*.svg
wrong() { # wrong MESSAGE ARGUMENTS...
    local message=$1
    shift
    run picture "$@"
    exits 2
    says "$message"
    prints_nothing
}
wrong 'give one that ends with .png or .svg' cube.off -s catmull-clark -o out.jpg
wrong 'give one that ends with .png or .svg' cube.off -s catmull-clark -o -
wrong 'output is missing' cube.off -s catmull-clark
wrong 'scheme is missing' cube.off -o no.svg
wrong "'smooth' is not a scheme" cube.off -s catmull-clark,smooth -o no.svg
wrong "--view: 'below' is not one of isometric, front" cube.off -s catmull-clark --view below -o no.svg
wrong "--view: '1,2,3' is not one of" cube.off -s catmull-clark --view 1,2,3 -o no.svg
wrong "--up: 'w' is not one of x, y, z" cube.off -s catmull-clark --up w -o no.svg
wrong "--size: '800' is no size; give width and height" cube.off -s catmull-clark --size 800 -o no.svg
wrong "--size: '0x9' is no size" cube.off -s catmull-clark --size 0x9 -o no.svg
wrong "--levels: '1.5' is no level; give levels from 0 to 20" cube.off -s catmull-clark -n 0,1.5 -o no.svg
wrong '--wire: give a level from 0 to 20' cube.off -s catmull-clark --wire -1 -o no.svg
wrong '--wire: applies to the limit surface' cube.off -s catmull-clark --wire 1 -n 2 -o no.svg
wrong "--color: 'nice' is not one of plain, parent, tile, rank, level, mean, gaussian, reflection, checker, attribute:NAME, texture:FILE" \
    cube.off -s catmull-clark --color nice -o no.svg
wrong 'the file has none' cube.off -s catmull-clark --color attribute:heat -o no.svg
wrong 'the attributes are quality, part' valued.ply -s loop --color attribute:heat -o no.svg
wrong 'the file has no texture coordinates' cube.off -s catmull-clark --color checker -o no.svg
run picture cube.off -s catmull-clark --color texture:cube.off -o no.svg
exits 1
says '^kith: cube.off: picture: '
wrong 'name --levels as well' cube.off -s catmull-clark --color level -o no.svg
wrong 'name --tiles as well' cube.off -s catmull-clark --color tile -o no.svg
wrong 'name --ranks as well' cube.off -s catmull-clark --color rank -o no.svg
wrong '--ranks: applies to --color rank only' cube.off -s catmull-clark --color tile --tiles 2 --ranks 2 -o no.svg
wrong '--tiles: applies to --color tile and rank only' cube.off -s catmull-clark --tiles 3 -o no.svg
wrong 'leave out --levels' cube.off -s catmull-clark --color mean -n 1 -o no.svg
wrong "'doo-sabin' is not possible here; the schemes are catmull-clark and loop" \
    cube.off -s doo-sabin --color mean -o no.svg
run picture cube.off -s loop -o no.svg
exits 1
says 'triangulate'
run picture missing.off -s loop -o no.svg
exits 1
run picture cube.off -s catmull-clark -o there/no.svg
exits 1
says 'there/no.svg'
(ulimit -f 1 && exec "$kith" picture cube.off -s catmull-clark -n 6 -o no.svg) >"$results/out" 2>"$results/err"
code=$?
exits 1
says 'no.svg: could not be written completely'
leaves cube.off hole.obj square.obj tetra.off valued.ply
finish
