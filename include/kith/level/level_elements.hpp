// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements.hpp"

#include <concepts>
#include <cstddef>

namespace kith {

/// All elements of one kind of a level, for loops: `for (auto v : coarse.vertices())` or `for_each`.
template <class Level, class Element>
class all_elements {
public:
    class iterator {
    public:
        using difference_type = std::ptrdiff_t;
        using value_type = Element;
        iterator(const Level& level, std::size_t i) : level_(&level), i_(i) {}
        Element operator*() const { return all_elements::at(*level_, i_); }
        iterator& operator++()
        {
            ++i_;
            return *this;
        }
        void operator++(int) { ++i_; }
        friend bool operator==(const iterator& a, const iterator& b) { return a.i_ == b.i_; }

    private:
        const Level* level_;
        std::size_t i_;
    };

    all_elements(const Level& level, std::size_t size) : level_(&level), size_(size) {}

    [[nodiscard]] const Level& level() const { return *level_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Element operator[](std::size_t i) const { return at(*level_, i); }
    [[nodiscard]] iterator begin() const { return {*level_, 0}; }
    [[nodiscard]] iterator end() const { return {*level_, size_}; }

private:
    static Element at(const Level& level, std::size_t i)
    {
        if constexpr (std::same_as<Element, vertex<Level>>)
            return {level, level.vertex_at(i)};
        else if constexpr (std::same_as<Element, edge<Level>>)
            return {level, level.edge_at(i)};
        else if constexpr (std::same_as<Element, face<Level>>)
            return {level, level.face_at(i)};
        else
            return {level, level.corner_at(i)};
    }

    const Level* level_;
    std::size_t size_;
};

/// A level with its element ranges: what a scheme calls `coarse`.
template <class Level>
class level_elements : public Level {
public:
    using Level::Level;
    using vertex_type = vertex<level_elements>;
    using edge_type = edge<level_elements>;
    using face_type = face<level_elements>;
    using corner_type = corner<level_elements>;

    [[nodiscard]] auto vertices() const
    {
        return all_elements<level_elements, vertex_type>(*this, this->vertex_count());
    }
    [[nodiscard]] auto edges() const { return all_elements<level_elements, edge_type>(*this, this->edge_count()); }
    [[nodiscard]] auto faces() const { return all_elements<level_elements, face_type>(*this, this->face_count()); }
    [[nodiscard]] auto corners() const
    {
        return all_elements<level_elements, corner_type>(*this, this->corner_count());
    }
};

} // namespace kith
