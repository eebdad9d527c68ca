// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>

#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The weights of the vertices of an earlier level that give a point, by increasing vertex number: a row of the
/// subdivision matrix. A scheme evaluated over rows gives the matrix.
struct stencil_row {
    std::vector<std::pair<std::size_t, double>> entries;

    friend bool operator==(const stencil_row&, const stencil_row&) = default;
};

template <>
struct affine<stencil_row> {
    using scalar = double;
    using sum = stencil_row;

    static const stencil_row& load(const stencil_row& row) { return row; }
    static const stencil_row& store(const stencil_row& total) { return total; }
    static void add(stencil_row& total, const stencil_row& more)
    {
        std::vector<std::pair<std::size_t, double>> merged;
        merged.reserve(total.entries.size() + more.entries.size());
        auto a = total.entries.begin();
        auto b = more.entries.begin();
        while (a != total.entries.end() or b != more.entries.end()) {
            if (b == more.entries.end() or (a != total.entries.end() and a->first < b->first))
                merged.push_back(*a++);
            else if (a == total.entries.end() or b->first < a->first)
                merged.push_back(*b++);
            else {
                merged.emplace_back(a->first, a->second + b->second);
                ++a, ++b;
            }
        }
        total.entries = std::move(merged);
    }
    static void scale(stencil_row& total, double weight)
    {
        for (auto& entry : total.entries)
            entry.second *= weight;
    }
};

/// An entry of a sparse matrix, which other libraries accept in any order: the weight of point `column` in point `row`.
struct matrix_entry {
    std::size_t row, column;
    double weight;

    friend bool operator==(const matrix_entry&, const matrix_entry&) = default;
};

/// The subdivision matrix in compressed rows. Point i of the finer level is the sum over k in [row_start[i],
/// row_start[i+1]) of weight[k] times point column[k] of the coarser level. The indices are signed as in other
/// libraries, so that these can use the same arrays: kith/eigen.hpp, or SciPy's csr_matrix.
struct subdivision_matrix {
    using index_type = std::ptrdiff_t;

    std::size_t columns = 0;
    std::vector<index_type> row_start{0};
    std::vector<index_type> column;
    std::vector<double> weight;

    [[nodiscard]] std::size_t rows() const { return row_start.size() - 1; }

    /// Returns the position in `column` and `weight` where row i begins, and row i-1 ends.
    [[nodiscard]] std::size_t begin_of_row(std::size_t i) const { return std::size_t(row_start[i]); }

    /// Returns all entries, row by row. Cost: O(entries).
    [[nodiscard]] std::vector<matrix_entry> triplets() const
    {
        std::vector<matrix_entry> result;
        result.reserve(weight.size());
        for (std::size_t i = 0; i < rows(); ++i)
            for (std::size_t k = begin_of_row(i); k < begin_of_row(i + 1); ++k)
                result.push_back({i, std::size_t(column[k]), weight[k]});
        return result;
    }

    /// Returns values at the vertices of the finer level, computed from one value per vertex of the coarser level. A
    /// row without entries gives T(), or zero where T() leaves memory uninitialised. Runs on the threads of OpenMP if
    /// values are trivially copyable.
    /// Errors: mesh_error unless there are `columns` values. Cost: O(entries).
    template <affine_value T>
    [[nodiscard]] std::vector<T> apply(std::span<const T> values) const
    {
        using traits = affine<T>;
        if (values.size() != columns)
            throw mesh_error("a subdivision matrix over " + std::to_string(columns) + " elements was given " +
                             std::to_string(values.size()) + " values; give it one for each");
        const auto term = [&](std::size_t k) {
            typename traits::sum result = traits::load(values[std::size_t(column[k])]);
            traits::scale(result, static_cast<typename traits::scalar>(weight[k]));
            return result;
        };
        static const T nothing = T(); // static memory is cleared before construction
        std::vector<T> result(rows());
        detail::for_parts(rows(), std::is_trivially_copyable_v<T>, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (begin_of_row(i) == begin_of_row(i + 1)) {
                    result[i] = nothing;
                    continue;
                }
                typename traits::sum total = term(begin_of_row(i));
                for (std::size_t k = begin_of_row(i) + 1; k < begin_of_row(i + 1); ++k)
                    traits::add(total, term(k));
                result[i] = traits::store(total);
            }
        });
        return result;
    }

    template <std::ranges::contiguous_range Values>
        requires affine_value<std::ranges::range_value_t<Values>>
    [[nodiscard]] auto apply(const Values& values) const
    {
        return apply(std::span<const std::ranges::range_value_t<Values>>(values));
    }

    /// Returns the transposed matrix: the restriction that belongs to this prolongation. Cost: O(entries).
    [[nodiscard]] subdivision_matrix transposed() const
    {
        subdivision_matrix result;
        result.columns = rows();
        result.row_start.assign(columns + 1, 0);
        for (const index_type j : column)
            ++result.row_start[std::size_t(j) + 1];
        for (std::size_t j = 0; j < columns; ++j)
            result.row_start[j + 1] += result.row_start[j];
        result.column.resize(column.size());
        result.weight.resize(weight.size());
        std::vector<index_type> end(result.row_start.begin(), result.row_start.end() - 1);
        for (std::size_t i = 0; i < rows(); ++i)
            for (std::size_t k = begin_of_row(i); k < begin_of_row(i + 1); ++k) {
                const auto place = std::size_t(end[std::size_t(column[k])]++);
                result.column[place] = index_type(i);
                result.weight[place] = weight[k];
            }
        return result;
    }

    friend bool operator==(const subdivision_matrix&, const subdivision_matrix&) = default;
};

/// Returns the rows of the identity matrix: each vertex is itself with weight 1.
inline std::vector<stencil_row> unit_rows(std::size_t vertices)
{
    std::vector<stencil_row> result(vertices);
    for (std::size_t v = 0; v < vertices; ++v)
        result[v].entries = {{v, 1.}};
    return result;
}

/// Returns the rows as a matrix over `columns` coarse elements.
inline subdivision_matrix make_matrix(std::span<const stencil_row> rows, std::size_t columns)
{
    subdivision_matrix result;
    result.columns = columns;
    std::size_t entries = 0;
    for (const auto& row : rows)
        entries += row.entries.size();
    result.row_start.reserve(rows.size() + 1);
    result.column.reserve(entries);
    result.weight.reserve(entries);
    for (const auto& row : rows) {
        for (const auto& [column, weight] : row.entries) {
            result.column.push_back(subdivision_matrix::index_type(column));
            result.weight.push_back(weight);
        }
        result.row_start.push_back(subdivision_matrix::index_type(result.column.size()));
    }
    return result;
}

} // namespace kith
