// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>
#include <vector>

/// Returns a flag for each face, set with a probability of `sixteenths` / 16. The state of the generator determines the
/// flags.
inline std::vector<unsigned char> some_faces(std::size_t count, std::mt19937& random, unsigned sixteenths)
{
    std::vector<unsigned char> result(count);
    for (auto& flag : result)
        flag = random() % 16 < sixteenths;
    return result;
}

/// Adds `count` levels, each refined in faces chosen at random.
template <class Levels>
void refine_some(Levels& levels, int count, unsigned seed, unsigned sixteenths)
{
    std::mt19937 random(seed);
    for (int i = 0; i < count; ++i)
        levels.refine_flagged(some_faces(levels.elements(levels.depth()).face_count(), random, sixteenths));
}
