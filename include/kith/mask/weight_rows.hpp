// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace kith {

/// Rows of weights by valence, for masks whose weights differ around a ring: computed at once for the valences that meshes
/// have, on the spot for the rare others.
template <class Scalar>
class weight_rows {
public:
    using row_function = std::function<std::vector<double>(std::size_t)>;

    explicit weight_rows(row_function row) : row_(std::move(row))
    {
        for (std::size_t n = 1; n <= kept; ++n)
            rows_.push_back(convert(row_(n)));
    }

    /// The row for valence n > 0, as long as n says or the row function makes it. `spare` holds it if it is not kept.
    [[nodiscard]] const Scalar* operator()(std::size_t n, std::vector<Scalar>& spare) const
    {
        if (n <= kept)
            return rows_[n - 1].data();
        spare = convert(row_(n));
        return spare.data();
    }

private:
    static constexpr std::size_t kept = 16;

    static std::vector<Scalar> convert(const std::vector<double>& row)
    {
        std::vector<Scalar> result;
        for (const double weight : row)
            result.push_back(Scalar(weight));
        return result;
    }

    row_function row_;
    std::vector<std::vector<Scalar>> rows_;
};

} // namespace kith
