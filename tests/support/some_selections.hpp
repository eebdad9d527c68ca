// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>
#include <vector>

/// A flag for each face: chosen with a chance of sixteenths, always the same ones for the same generator.
inline std::vector<unsigned char> some_faces(std::size_t count, std::mt19937& random, unsigned sixteenths)
{
    std::vector<unsigned char> result(count);
    for (auto& flag : result)
        flag = random() % 16 < sixteenths;
    return result;
}

/// Adds levels in which faces are chosen at random.
template <class Levels>
void refine_some(Levels& levels, int count, unsigned seed, unsigned sixteenths)
{
    std::mt19937 random(seed);
    for (int i = 0; i < count; ++i)
        levels.refine_flagged(some_faces(levels.elements(levels.depth()).face_count(), random, sixteenths));
}
