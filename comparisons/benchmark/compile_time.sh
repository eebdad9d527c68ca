#!/usr/bin/env bash
# compile_time.sh [RUNS]: how long one file takes to compile that refines a mesh of CGAL or OpenMesh once by Loop, as a multiple of a
# file with the mesh library alone: which includes kith, which refines by headers only, which refines where kith::compiled_schemes is
# linked, and where kith::compiled_cgal or kith::compiled_openmesh is; and beside them, without kith, one that makes a triangle by the
# library's own functions. Processor seconds, medians of RUNS runs (5) that take turns, so that other work on the machine meets all of
# them. CXX is the compiler.
set -euo pipefail
runs=${1:-5}
here=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compiler=${CXX:-g++}
flags=(-std=c++20 -ffp-contract=off -I"$here/include" -I"$here/schemes" -I"$here/adapters")
case $("$compiler" --version | head -n 1) in *clang*) ;; *) flags+=(-fno-ipa-modref) ;; esac

# sources NAME ADAPTER POINT: reads the lines that make a type `mesh` of the library.
sources() {
    local alone=$work/$1-alone.cpp making=$work/$1-making.cpp including=$work/$1-including.cpp headers=$work/$1-headers.cpp
    cat >"$alone"
    sed "/^using mesh/i #include <kith/$2>\n#include <kith/loop.hpp>\n#include <kith/refine.hpp>" "$alone" >"$including"
    cp "$including" "$headers"
    cp "$alone" "$making"
    cat >>"$making" <<<"mesh triangle()
{
    mesh m;
    const auto a = m.add_vertex($3(0, 0, 0)), b = m.add_vertex($3(1, 0, 0)), c = m.add_vertex($3(0, 1, 0));
    m.add_face(a, b, c);
    return m;
}"
    tee -a "$alone" >>"$including" <<<'mesh copy(const mesh& m) { return m; }'
    echo 'mesh refined(const mesh& m) { return kith::refine(m, kith::loop{}, 3); }' >>"$headers"
    { echo '#define KITH_COMPILED_SCHEMES' && cat "$headers"; } >"$work/$1-schemes.cpp"
    { echo "#define KITH_COMPILED_${1^^}_MESHES" && cat "$work/$1-schemes.cpp"; } >"$work/$1-meshes.cpp"
}
sources CGAL cgal.hpp 'CGAL::Simple_cartesian<double>::Point_3' <<'LINES'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
LINES
sources OpenMesh openmesh.hpp mesh::Point <<'LINES'
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
using mesh = OpenMesh::TriMesh_ArrayKernelT<>;
LINES

seconds() { # FILE OPTION...
    local TIMEFORMAT=%U
    { time "$compiler" "${flags[@]}" "${@:2}" -c "$work/$1.cpp" -o "$work/$1.o" 2>"$work/errors"; } 2>&1
}
median() { sort -n | sed -n "$(((runs + 1) / 2))p"; }

row='%-10s %-14s %8s %9s %10s %13s %17s %14s\n'
printf "$row" mesh options alone triangle including 'headers only' compiled_schemes compiled_mesh
for options in -O2 '-O2 -DNDEBUG' -O0; do
    for library in CGAL OpenMesh; do
        rm -f "$work"/times-*
        for ((run = 0; run < runs; ++run)); do
            for way in alone making including headers schemes meshes; do
                if ! seconds $library-$way $options >>"$work/times-$way"; then
                    cat "$work/errors" >&2
                    exit 1
                fi
            done
        done
        alone=$(median <"$work/times-alone")
        ratio() { median <"$work/times-$1" | awk -v alone="$alone" '{ printf "%.2f", $1 / alone }'; }
        printf "$row" $library "$options" "$alone s" "$(ratio making)" "$(ratio including)" "$(ratio headers)" "$(ratio schemes)" \
            "$(ratio meshes)"
    done
done
