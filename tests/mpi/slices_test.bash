# SPDX-License-Identifier: BSD-3-Clause
# slices_test.bash KITH KITH_MPI SHIM: control meshes that no rank reads as a whole.
source "$(dirname "$0")/on_ranks.bash"

cube >cube.off
tetrahedron >tetra.off
run refine cube.off -s catmull-clark -n 2 -o quads.ply --tiles 1
run refine tetra.off -s loop -n 2 -o triangles.ply --tiles 1
printf 'OFF\n9 4 0\n0 0 0\n1 0 1\n2 0 0\n0 1 1\n1 1 0\n2 1 3\n0 2 0\n1 2 1\n2 2 0\n4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n' >open.off
run refine open.off -s catmull-clark -n 1 -o open.ply --tiles 1

# The bytes of a job whose control mesh lay on rank 0.
compare() { # compare IN SCHEME LEVELS
    on 1 refine "$1" -s "$2" -n "$3" -o whole.vtu --verify
    exits 0
    for ranks in 1 2 3 5; do
        on "$ranks" refine "$1" -s "$2" -n "$3" -o slices.vtu --slices
        exits 0
        check "the file of the whole mesh" cmp -s whole.vtu slices.vtu
    done
}
compare quads.ply catmull-clark 3
compare quads.ply doo-sabin 3
compare quads.ply kobbelt 2
compare quads.ply nasri-hasbini 2
compare quads.ply mid-edge 3
compare triangles.ply loop 3
compare triangles.ply sqrt3 3
compare triangles.ply butterfly 3
compare open.ply catmull-clark 3
compare open.ply catmull-clark 0

# Numbers of vertices and faces and words go along, as if rank 0 had read them.
source "$(dirname "$0")/../tool/attribute_meshes.bash"
rich_cube >rich.ply
grid 4 >grid.obj
for name in rich.ply grid.obj; do # through VTU, which has no lists
    run refine $name -s catmull-clark -n 1 -o lists.vtu
    run refine lists.vtu -s catmull-clark -n 0 -o ${name%.*}.control.ply --binary
    exits 0
    for output in vtu ply; do
        on 1 refine ${name%.*}.control.ply -s catmull-clark -n 2 -o whole.$output
        exits 0
        for ranks in 1 2 3 5; do
            on "$ranks" refine ${name%.*}.control.ply -s catmull-clark -n 2 -o slices.$output --slices
            exits 0
            same whole.$output slices.$output
        done
    done
done
has whole.ply '^comment word group 16 cell_15$'
has whole.ply '^property int smoothing_group$'
run refine rich.control.ply -s doo-sabin -n 1 -o whole.ply --binary
on 3 refine rich.control.ply -s doo-sabin -n 1 -o slices.ply --slices
exits 0
same whole.ply slices.ply
on 1 refine rich.control.ply -s catmull-clark -n 1 -o whole.ply --limit
on 3 refine rich.control.ply -s catmull-clark -n 1 -o slices.ply --limit --slices
exits 0
same whole.ply slices.ply
sed 's/comment word group 16 cell_15/comment word other 16 cell_15/' grid.control.ply >few.ply
on 3 refine few.ply -s catmull-clark -n 1 -o out.vtu --slices
exits 1
says 'few.ply: face [0-9]*: group is a number without a name in the file; read it on one rank'
one_message

# Faces of more than 255 corners, which corners of 300 triangles become: PLY counts them in wider numbers, and by ranks and
# slices that is known before there are faces. Lists of the control mesh may count so, too.
awk 'BEGIN {
    n = 300; print "OFF", n + 2, 2 * n, 0; print "0 0 2\n0 0 -1"
    for (i = 0; i < n; ++i) { a = i * 6.283185307 / n; print cos(a), sin(a), 0 }
    for (i = 0; i < n; ++i) print 3, 0, 2 + i, 2 + (i + 1) % n
    for (i = 0; i < n; ++i) print 3, 1, 2 + (i + 1) % n, 2 + i
}' >spindle.off
run refine spindle.off -s linear-triangles -n 0 -o spindle.ply --binary
for job in 'doo-sabin 1 ushort' 'mid-edge 2 ushort' 'loop 1 uchar'; do
    read -r scheme levels type <<<"$job"
    run refine spindle.off -s "$scheme" -n "$levels" -o whole.ply --binary
    exits 0
    has whole.ply "^property list $type int vertex_indices\$"
    on 3 refine spindle.off -s "$scheme" -n "$levels" -o ranks.ply
    exits 0
    same whole.ply ranks.ply
    on 3 refine spindle.ply -s "$scheme" -n "$levels" -o slices.ply --slices
    exits 0
    same whole.ply slices.ply
done
python3 - <<'END'
import struct
data = open("spindle.ply", "rb").read()
data = data[data.index(b"end_header\n") + 11:]
head = open("spindle.ply", "rb").read().split(b"end_header")[0].replace(b"list uchar int", b"list int uint")
faces = [data[24 * 302 + 13 * f:][:13] for f in range(600)]
with open("wide.ply", "wb") as out:
    out.write(head + b"end_header\n" + data[:24 * 302] + b"".join(struct.pack("<i", f[0]) + f[1:] for f in faces))
END
on 2 refine wide.ply -s doo-sabin -n 1 -o slices.ply --slices
exits 0
run refine wide.ply -s doo-sabin -n 1 -o whole.ply --binary
exits 0
same whole.ply slices.ply

# What a share of the file does not tell.
sed 's/end_header/element tristrips 1\nproperty list int int vertex_indices\nend_header/' triangles.ply >strips.ply
on 3 refine strips.ply -s loop -n 1 -o out.vtu --slices
exits 1
says "strips.ply: has strips of triangles \('tristrips'\), which cannot be read in slices; read it on one rank"
one_message
on 3 refine open.ply -s doo-sabin -n 1 -o out.vtu --slices
exits 1
says 'doo-sabin: its element numbers depend on the boundary, and the mesh has one; cut it on one rank'
one_message
on 3 refine triangles.ply -s 4-8 -n 1 -o out.vtu --slices
exits 1
says '4-8: marked edges can be counted only on a whole mesh'
one_message
on 3 refine quads.ply -s loop -n 1 -o out.vtu --slices
exits 1
says 'loop: face 0 has 4 vertices; triangulate the mesh first'
one_message
on 3 refine cube.off -s catmull-clark -n 1 -o out.vtu --slices
exits 1
says 'cube.off: is not a PLY file'
one_message
# A file that a rank cannot read: the reason, and the rank if others can.
on 3 refine missing.ply -s catmull-clark -n 1 -o out.vtu --slices
exits 1
says 'missing.ply: cannot be opened: No such file or directory$'
one_message
mkdir folder.ply elsewhere
on 3 refine folder.ply -s catmull-clark -n 1 -o out.vtu --slices
exits 1
says 'folder.ply: is a directory, not a file$'
one_message
words=(refine quads.ply -s catmull-clark -n 1 -o "$PWD/out.vtu" --slices)
command="mpirun -n 2 kith-mpi ${words[*]} : -n 1 -wdir elsewhere kith-mpi ${words[*]}"
timeout 60 mpirun -n 2 "$kith_mpi" "${words[@]}" : -n 1 -wdir "$PWD/elsewhere" "$kith_mpi" "${words[@]}" \
    >"$results/out" 2>"$results/err" </dev/null
code=$?
exits 1
says 'quads.ply: cannot be opened: No such file or directory on rank 2 of 3, .*; put the file where all ranks see it$'
one_message
rmdir folder.ply elsewhere
on 3 refine quads.ply -s catmull-clark -n 1 -o out.vtu --slices --verify
exits 2
says '.-verify: needs the whole mesh on one rank; leave out this option or --slices'
one_message
for option in --repair=split --weld; do
    on 3 refine quads.ply -s catmull-clark -n 1 -o out.vtu --slices $option
    exits 2
    says ".${option%=*}: needs the whole mesh on one rank; leave out this option or --slices"
    one_message
done
# What refine refuses --slices refuses, too, and what is not kept is named as there.
run refine cube.off -s catmull-clark -n 1 -o normals.ply --binary --limit
on 3 refine normals.ply -s catmull-clark -n 1 -o slices.vtu --slices
exits 0
says 'normals.ply: not kept: normals'
(cat quads.ply; printf '!') >longer.ply
on 1 refine longer.ply -s catmull-clark -n 1 -o out.vtu
exits 1
says 'longer.ply: the file goes on for 1 byte after its last element'
on 3 refine longer.ply -s catmull-clark -n 1 -o out.vtu --slices
exits 1
says 'longer.ply: goes on for 1 byte after its last element'
one_message
check "no output is left" test -z "$(ls | grep -E '^out|incomplete')"

finish
