// SPDX-License-Identifier: BSD-3-Clause
// compare_off A.off B.off: whether two files hold the same surface to 1e-12, in any order.
#include "support/same_surface.hpp"

#include <fstream>
#include <iostream>
#include <string>

namespace {

surface read(const char* file)
{
    std::ifstream in(file);
    std::string magic;
    std::size_t points = 0, faces = 0, edges = 0;
    in >> magic >> points >> faces >> edges;
    surface result{std::vector<std::array<double, 3>>(points), std::vector<std::vector<std::size_t>>(faces)};
    for (auto& [x, y, z] : result.points)
        in >> x >> y >> z;
    for (auto& face : result.faces) {
        std::size_t degree = 0;
        in >> degree;
        face.resize(degree);
        for (std::size_t& v : face)
            in >> v;
    }
    if (not in)
        throw std::runtime_error(std::string(file) + " is no file that CGAL writes");
    return result;
}

} // namespace

int main(int, char** words)
try {
    const std::string why = difference(read(words[1]), read(words[2]));
    std::cout << (why.empty() ? "the same surface" : why) << '\n';
    return why.empty() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
