// SPDX-License-Identifier: BSD-3-Clause
// A program that is compiled without OpenMP and links the compiled parts, which may use OpenMP. It has one thread until
// it asks for more. Its exit code is the number of the failed check, or 0.
#include <kith/compiled_schemes.hpp>
#include <kith/refine.hpp>
#include <kith/schemes.hpp>

#include "support/shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>

namespace {

/// Returns the number of threads of the process; 0 if there is no /proc. Threads of OpenMP remain after their loop.
std::size_t threads()
{
    const std::filesystem::path tasks("/proc/self/task");
    using entries = std::filesystem::directory_iterator;
    return std::filesystem::exists(tasks) ? std::size_t(std::distance(entries(tasks), entries())) : 0;
}

} // namespace

int main()
{
    const auto torus = shapes::torus(60, 60);
    const auto one = kith::refine(torus.points, torus.faces, kith::catmull_clark{}, 3);
    if (threads() > 1)
        return 1;
    kith::set_threads(2);
    const auto two = kith::refine(torus.points, torus.faces, kith::catmull_clark{}, 3);
#ifdef PARTS_HAVE_OPENMP
    if (threads() == 1)
        return 2;
#endif
    return std::ranges::equal(one.points(), two.points()) ? 0 : 3;
}
