# SPDX-License-Identifier: BSD-3-Clause
# gltf_test.bash KITH DIR: validates .glb with the validator of Khronos, which npm installs in DIR.
source "$(dirname "$0")/check.bash"
source "$(dirname "$0")/attribute_meshes.bash"
for program in node npm; do
    if ! command -v "$program" >"$results/out"; then
        echo "skipped: there is no $program"
        exit 77
    fi
done
mkdir -p "$2"
if ! test -d "$2/node_modules/gltf-validator" &&
    ! timeout 120 npm install --prefix "$2" --silent --no-save --no-package-lock gltf-validator >"$results/out" 2>&1; then
    echo "skipped: npm cannot install gltf-validator"
    exit 77
fi

# validate FILE: prints errors and warnings, and what the file has.
validate() {
    command="validate $1"
    NODE_PATH="$gltf/node_modules" node -e '
        const file = require("fs").readFileSync(process.argv[1]);
        require("gltf-validator").validateBytes(new Uint8Array(file)).then(report => {
            for (const issue of report.issues.messages)
                if (issue.severity < 2) console.log(issue.code, issue.message, issue.pointer);
            const head = JSON.parse(file.toString("utf8", 20, 20 + file.readUInt32LE(12)));
            console.log(report.issues.numErrors, "errors", report.issues.numWarnings, "warnings",
                report.info.totalTriangleCount, "triangles",
                Object.keys(head.meshes[0].primitives[0].attributes).sort().join(),
                (head.materials || []).map(material => material.name).sort().join());
        });' "$1" >"$results/out" 2>"$results/err"
    code=$?
}
# valid WHAT ARGUMENTS...: refines to .glb; the validator finds nothing wrong and WHAT in the file.
valid() {
    local what=$1
    shift
    run refine "$@" -o fine.glb
    exits 0
    validate fine.glb
    exits 0
    prints "^0 errors 0 warnings $what\$"
}
gltf=$2
cube >cube.off
tetrahedron >tetra.off
rich_cube >rich.ply
grid 4 >grid.obj
charts 4 >charts.obj

valid '512 triangles COLOR_0,NORMAL,POSITION,TEXCOORD_0 blue,red' grid.obj -s catmull-clark -n 2 --limit
valid '512 triangles COLOR_0,POSITION,TEXCOORD_0 ' charts.obj -s catmull-clark -n 2
valid '48 triangles COLOR_0,POSITION,TEXCOORD_0 ' rich.ply -s catmull-clark -n 1
valid '192 triangles NORMAL,POSITION ' cube.off -s catmull-clark -n 2 --limit --crease-angle 30
valid '188 triangles NORMAL,POSITION ' cube.off -s doo-sabin -n 2 --limit
valid '64 triangles NORMAL,POSITION ' tetra.off -s loop -n 2 --limit

# The validator notices what is wrong: the type of an index beyond the types.
sed 's/"componentType":5125/"componentType":9999/' fine.glb >wrong.glb
validate wrong.glb
check "finds errors" grep -qE '^[1-9][0-9]* errors' "$results/out"
finish
