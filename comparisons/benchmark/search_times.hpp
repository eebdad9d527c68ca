// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "correctness/random_meshes.hpp"
#include "timing.hpp"

#include <kith/closest_points.hpp>
#include <kith/ray_hits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace kith::comparison {

/// The times of one run in seconds.
struct search_times {
    double set_up, rays, nearest;
};

/// Times ray hits and nearest points, for which there is no peer.
template <class Scheme>
void time_searches(const std::string& name, const basic_mesh<>& mesh, const Scheme& scheme, int repeats)
{
    constexpr std::size_t queries = 2000;
    double size = 0;
    for (const auto& p : mesh.points())
        for (const double x : p)
            size = std::max(size, std::abs(x));
    random_numbers random(2);
    std::vector<kith::surface_ray> rays;
    std::vector<std::array<double, 3>> points;
    for (std::size_t i = 0; i < queries; ++i) {
        const auto any = [&] {
            return std::array{size * random.coordinate(), size * random.coordinate(), size * random.coordinate()};
        };
        const auto from = any(), to = any();
        rays.push_back({from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}});
        points.push_back(from);
    }
    std::vector<search_times> all;
    for (int i = 0; i < repeats; ++i) {
        search_times& one = all.emplace_back();
        std::optional<kith::ray_hits<Scheme>> hits;
        std::optional<kith::closest_points<Scheme>> nearest;
        one.set_up = seconds([&] { hits.emplace(mesh, scheme); });
        nearest.emplace(mesh, scheme);
        one.rays = seconds([&] { static_cast<void>(hits->of(rays)); });
        one.nearest = seconds([&] { static_cast<void>(nearest->of(points)); });
    }
    constexpr double microseconds = 1e6;
    std::cout << std::fixed << std::setprecision(1) << name << ", " << mesh.face_count() << " faces: set-up "
              << median(all, &search_times::set_up) * microseconds / double(mesh.face_count()) << " us a face, "
              << median(all, &search_times::rays) * microseconds / double(queries) << " us a ray, "
              << median(all, &search_times::nearest) * microseconds / double(queries) << " us a nearest point\n";
}

} // namespace kith::comparison
