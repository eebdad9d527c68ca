// SPDX-License-Identifier: BSD-3-Clause
// Writes the control meshes of the thesis's figures as OBJ files. `kith refine` reads them with their creases.
// Sample run: figures FOLDER

#include "../tests/support/figure_bodies.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace {

using creases = std::vector<std::array<std::size_t, 2>>;

bool write(const std::string& file, const figures::shape& shape, const creases& sharp = {})
{
    std::ofstream out(file);
    out.precision(17);
    for (const auto& [x, y, z] : shape.points)
        out << "v " << x << ' ' << y << ' ' << z << '\n';
    for (const auto& face : shape.faces) {
        out << 'f';
        for (const std::size_t v : face)
            out << ' ' << v + 1;
        out << '\n';
    }
    for (const auto& [a, b] : sharp) // in OpenSubdiv's form: numbers from 0, and 10 is infinitely sharp
        out << "t crease 2/1/0 " << a << ' ' << b << " 10\n";
    out.close();
    std::printf("%s: %zu vertices, %zu faces\n", file.c_str(), shape.points.size(), shape.faces.size());
    return bool(out);
}

} // namespace

int main(int count, char** words)
{
    using namespace figures;
    const std::string folder = count > 1 ? words[1] : ".";
    const bool all = write(folder + "/cube.obj", cube()) and
                     write(folder + "/triangulated_cube.obj", triangulated(cube())) and
                     write(folder + "/t_shape.obj", t_shape(), t_shape_creases()) and
                     write(folder + "/pentacube.obj", pentacube()) and write(folder + "/torus.obj", torus()) and
                     write(folder + "/hollow_cube.obj", hollow_cube()) and write(folder + "/axe.obj", axe()) and
                     write(folder + "/gourd.obj", gourd()) and write(folder + "/rook.obj", rook()) and
                     write(folder + "/cupid.obj", cupid());
    return all ? 0 : 1;
}
