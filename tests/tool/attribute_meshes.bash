# SPDX-License-Identifier: BSD-3-Clause
# Sourced after check.bash: meshes with attributes of all kinds.

# A grid of shaken quads, each of which has a texture of its own: u and v are affine in x and y, differently in each group.
grid() { # grid ROWS: an OBJ file
    awk -v n="$1" 'BEGIN {
        srand(7)
        print "mtllib paint.mtl\no sheet"
        for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) {
            x[i, j] = j + rand() / 4; y[i, j] = i + rand() / 4
            printf "v %.17g %.17g %.17g %.17g 0.5 0\n", x[i, j], y[i, j], rand(), (x[i, j] + y[i, j]) / (3 * n)
        }
        for (f = i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
            face = sprintf("%sg cell_%d\nusemtl %s\ns %d\nf", face, f, f % 3 ? "red" : "blue", i + 1)
            for (k = 0; k < 4; ++k) {
                a = i + (k > 1); b = j + (k == 1 || k == 2)
                face = sprintf("%s %d/%d", face, a * (n + 1) + b + 1, ++t)
                lines = sprintf("%svt %.17g %.17g\n", lines, x[a, b] + 10 * f, 2 * y[a, b] - x[a, b] + f)
            }
            face = face "\n"; ++f
        }
        printf "%s%s", lines, face
    }'
}

# A cube as PLY, and a vertex without a face: numbers of vertices and faces in several types, also those that say where a vertex is,
# texture coordinates of corners, and a list that is not kept.
rich_cube() {
    cube | awk 'NR == 2 {
            print "ply\nformat ascii 1.0\nelement vertex 9\nproperty double px\nproperty uchar red\nproperty float y\nproperty float x"
            print "property float z\nproperty double pz\nproperty uchar green\nproperty uchar blue\nproperty int id\nelement face 6"
            print "property ushort patch\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord"
            print "property list uchar int others\nproperty double area\nend_header"
        }
        NR > 2 && NR < 11 { print $1, $1 < 0 ? 0 : 255, $2, $1, $3, $3, 7, 9, 1000 }
        NR == 11 { print 5, 1, 5, 5, 5, 5, 2, 3, -4 }
        NR >= 11 { print NR, $0, 8, 0, 0, 1, 0, 1, 1, 0, 1, 0, NR / 4 }'
}

# A shaken grid of quads with colours, whose texture goes on over faces but for a seam down the middle: OBJ.
charts() { # charts ROWS, an even number
    awk -v n="$1" 'BEGIN {
        srand(11)
        for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j)
            printf "v %.17g %.17g %.17g %.4f %.4f 0.25\n", j + rand() / 3, i + rand() / 3, 2 * rand(), rand(), rand()
        for (side = 0; side < 2; ++side) for (i = 0; i <= n; ++i) for (j = side * n / 2; j <= (1 + side) * n / 2; ++j) {
            printf "vt %.17g %.17g\n", (j + rand() / 3) / n + side, (i + rand() / 3) / n
            texture[side, i, j] = ++textures
        }
        for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
            if (j % (n / 2) == 0) printf "g row_%d_%d\n", i, j
            printf "f"
            for (k = 0; k < 4; ++k) {
                y = i + (k > 1); x = j + (k == 1 || k == 2); side = (2 * j >= n)
                printf " %d/%d", y * (n + 1) + x + 1, texture[side, y, x]
            }
            printf "\n"
        }
    }'
}
