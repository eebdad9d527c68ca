// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements.hpp"

#include <concepts>
#include <cstddef>

namespace kith {

/// The range of all elements of one kind of a level, for loops: `for (auto v : coarse.vertices())` or `for_each`.
template <walkable_level Level, element Element>
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

/// A level with ranges of its elements, which schemes use under the name `coarse`.
template <walkable_level Level>
class level_elements : public Level {
public:
    using Level::Level;

    // The element types need a complete level type. It is complete when these functions are called, but not where they
    // are declared; hence `auto`.
    [[nodiscard]] auto vertices() const { return all<vertex<level_elements>>(this->vertex_count()); }
    [[nodiscard]] auto edges() const { return all<edge<level_elements>>(this->edge_count()); }
    [[nodiscard]] auto faces() const { return all<face<level_elements>>(this->face_count()); }
    [[nodiscard]] auto corners() const { return all<corner<level_elements>>(this->corner_count()); }

private:
    template <element Element>
    [[nodiscard]] auto all(std::size_t size) const
    {
        return all_elements<level_elements, Element>(*this, size);
    }
};

/// Returns the number that the user's mesh gives to an element of its level, for messages. Removed elements, which
/// levels leave out, may be counted in these numbers.
template <walkable_level Level, element Element>
std::size_t number_in_mesh(const Level& level, const Element& x)
{
    if constexpr (requires { level.number_in_mesh(x.handle()); })
        return level.number_in_mesh(x.handle());
    else
        return x.index();
}

} // namespace kith
