// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "creases.hpp"

#include <algorithm>

namespace kith {

/// The weight of the sharper rule at a vertex in the last step in which elements are sharp there. It is the mean
/// sharpness of the elements whose sharpness ends in this step. DeRose, Kass & Truong 1998, section 3; as in
/// OpenSubdiv.
class fading {
public:
    explicit fading(crease_method method) : method_(method) {}

    void add_vertex(double now)
    {
        if (now > 0 and now <= 1)
            add(now);
    }
    /// Adds an edge at the vertex. `later` is the sharpness of its half at the vertex. Precondition: now > 0.
    void add_edge(double now, double later)
    {
        if (method_ == crease_method::chaikin ? later == 0 : now <= 1)
            add(now);
    }
    [[nodiscard]] double weight() const { return count_ == 0 ? 0. : std::min(1., total_ / count_); }

private:
    void add(double sharpness) { total_ += sharpness, ++count_; }

    crease_method method_;
    double total_ = 0;
    int count_ = 0;
};

} // namespace kith
