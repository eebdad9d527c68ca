# SPDX-License-Identifier: BSD-3-Clause
source "$(dirname "$0")/check.bash"
cube >cube.off

run --help
exits 0
says_nothing
for verb in refine tessellate picture view info compare plan schemes; do prints "^  $verb "; done
prints 'OFF, OBJ, PLY, STL or VTU'
prints '\.vtu, \.pvtu'
run -h
exits 0
run --version
exits 0
prints '^kith [0-9]+\.[0-9]+\.[0-9]+$'
for verb in refine tessellate picture view info compare plan schemes; do
    run $verb --help
    exits 0
    prints "^kith $verb"
    prints '--help'
    prints '^Examples:$'
    prints "^  kith $verb "
    says_nothing
    run $verb --version
    exits 0
    prints '^kith [0-9]'
    run $verb --no-such-option
    exits 2
    says 'no-such-option'
    prints_nothing
done

wrong() { # wrong MESSAGE ARGUMENTS...: wrong use, which says so and does nothing
    local message=$1
    shift
    run "$@"
    exits 2
    says "$message"
    prints_nothing
    only_input_left cube.off
}
run
exits 2
says 'refine'
prints_nothing
wrong 'not a verb; the verbs are refine, tessellate, picture, view, info, compare, plan, schemes' smooth cube.off
wrong 'IN is missing' refine -s loop -n 1 -o out.off
wrong 'output is missing' refine cube.off -s catmull-clark -n 1
wrong 'scheme is missing' refine cube.off -n 1 -o out.off
wrong 'levels is missing' refine cube.off -s catmull-clark -o out.off
wrong 'too many operands' refine cube.off other.off -s catmull-clark -n 1 -o out.off
wrong "'catmull' is not a scheme; the schemes are catmull-clark, loop, quad-tri, doo-sabin, sqrt3, " refine cube.off -s catmull -n 1 -o out.off
wrong 'ask for 0 or more' refine cube.off -s catmull-clark -n -1 -o out.off
wrong '^kith: --levels: -1 levels were asked for; ask for 0 or more$' refine cube.off -s catmull-clark -n -1 -o out.off
wrong 'levels' refine cube.off -s catmull-clark -n two -o out.off
wrong 'levels' refine cube.off -s catmull-clark -n 1.5 -o out.off
wrong 'levels' refine cube.off -s catmull-clark -n 99999999999 -o out.off
wrong 'once' refine cube.off -s catmull-clark -n 1 -n 2 -o out.off
wrong "'maya' is not one of kith, cgal" refine cube.off -s catmull-clark -n 1 -o out.off --preset maya
wrong 'does not have it' refine cube.off -s catmull-clark -n 1 -o out.off --preset libigl
wrong 'catmull-clark has no such option' refine cube.off -s catmull-clark -n 1 -o out.off --weights warren
wrong 'sqrt3 has no such option' refine cube.off -s sqrt3 -n 1 -o out.off --boundary-corners kept
wrong 'loop has no such option' refine cube.off -s loop -n 1 -o out.off --tension 1
wrong 'between 0 and 2.472' refine cube.off -s kobbelt -n 1 -o out.off --tension 2.5
wrong 'between 0 and 2.472' refine cube.off -s kobbelt -n 1 -o out.off --tension nan
wrong 'not between 1 and 9' refine cube.off -s unified -n 1 -o out.off --degree 10
wrong 'degree' refine cube.off -s unified -n 1 -o out.off --degree three
wrong 'kobbelt has no such option' refine cube.off -s kobbelt -n 1 -o out.off --degree 3
wrong "'cosine' is not one of loop, warren" refine cube.off -s loop -n 1 -o out.off --weights cosine
wrong "'round' is not one of kept, smoothed" refine cube.off -s loop -n 1 -o out.off --boundary-corners round
wrong "'blender' is not one of native, cgal, openmesh" refine cube.off -s catmull-clark -n 1 -o out.off --mesh blender
wrong 'doo-sabin has no creases; only catmull-clark, loop and quad-tri have them' refine cube.off -s doo-sabin -n 1 -o out.off --crease-angle 30
wrong 'catmull-clark, loop and quad-tri have' refine cube.off -s doo-sabin -n 1 -o out.off --crease-angle 30
wrong 'needs --crease-angle, which selects the edges' refine cube.off -s loop -n 1 -o out.off --crease-sharpness 2
wrong 'is not 0 or more' refine cube.off -s loop -n 1 -o out.off --crease-angle 30 --crease-sharpness -1
wrong 'is not 0 or more' refine cube.off -s loop -n 1 -o out.off --crease-angle 30 --crease-sharpness nan
wrong 'sqrt3 has no such option' refine cube.off -s sqrt3 -n 1 -o out.off --crease-method chaikin
wrong "'soft' is not one of uniform, chaikin" refine cube.off -s loop -n 1 -o out.off --crease-method soft
wrong 'not between 0 and 180' refine cube.off -s catmull-clark -n 1 -o out.off --crease-angle 181
wrong 'not between 0 and 180' refine cube.off -s catmull-clark -n 1 -o out.off --crease-angle nan
wrong 'not a number of bytes' refine cube.off -s catmull-clark -n 1 -o out.off --memory-limit lots
wrong 'not a number of bytes' refine cube.off -s catmull-clark -n 1 -o out.off --memory-limit -5
wrong 'not a number of bytes' refine cube.off -s catmull-clark -n 1 -o out.off --memory-limit 5Q
wrong 'not a number of bytes' refine cube.off -s catmull-clark -n 1 -o out.off --memory-limit 0
wrong 'only PLY and STL' refine cube.off -s catmull-clark -n 1 -o out.off --binary
wrong 'quad-tri is not refined in tiles: a tile does not know how many triangles come before its own' refine cube.off -s quad-tri -n 1 -o out.vtu
wrong 'B is missing' compare cube.off --tolerance 1
wrong '--tolerance or --bitwise is missing' compare cube.off cube.off
wrong 'tolerance' compare cube.off cube.off --tolerance -1
wrong '^kith: --tolerance: nan is not a distance; give a number of 0 or more$' compare cube.off cube.off --tolerance nan
wrong '^kith: --tolerance: inf is not a distance' compare cube.off cube.off --tolerance inf
wrong '^kith: --tolerance: -1 is not a distance' compare cube.off cube.off --tolerance -1
wrong 'tolerance' compare cube.off cube.off --tolerance much
wrong 'FILE is missing' info
wrong 'levels is missing' plan cube.off -s loop
wrong 'is not a scheme' plan cube.off -s butter -n 1

run schemes
exits 0
prints '^catmull-clark +any polygons +Catmull & Clark 1978'
prints '^loop +triangles'
prints '^quad-tri +any polygons +Stam & Loop 2003'
prints '^doo-sabin +any polygons'
prints '^sqrt3 +triangles'
prints '--boundary thesis, clamped, drop'
prints '--boundary cubic, thirds'
prints '^unified +closed meshes +Zorin & Schroeder 2001'
prints '--degree a number from 1 to 9'
prints '^interpolatory-sqrt3 +triangles +Labsik'
check "columns are apart" test "$(grep -c '^[a-z0-9][a-z0-9-]*  ' "$results/out")" -eq "$(grep -c '^[a-z0-9]' "$results/out")"
run schemes --json
exits 0
prints '^\[\{"name":"catmull-clark","takes":"any polygons",.*\}\]$'
check "JSON has all schemes" test "$(grep -o '"name":' "$results/out" | wc -l)" -eq "$("$kith" schemes | grep -c '^[a-z0-9]')"

# What cannot be printed is an error, too.
if test -w /dev/full; then
    command="kith info cube.off > /dev/full"
    "$kith" info cube.off >/dev/full 2>"$results/err"
    code=$?
    exits 1
    says 'standard output'
fi
finish
