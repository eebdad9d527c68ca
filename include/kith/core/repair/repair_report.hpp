// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>
#include <kith/core/mesh/mesh_report.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace kith {

/// The kinds of changes that `repair` makes.
enum class repair_step : unsigned char {
    joined_vertex,
    removed_corner,
    dropped_face,
    turned_face,
    cut_edge,
    split_vertex,
    dropped_vertex,
};

/// A report of everything that `repair` did. Each change is counted; the first few of each kind are described with the
/// elements of the input.
class repair_report : public element_messages {
public:
    repair_report() : repair_report(0) {}
    /// Begins an empty report. `first_number` is the number of the first element in messages; OBJ files begin with 1.
    explicit repair_report(std::size_t first_number) : element_messages(names, first_number) {}

    [[nodiscard]] std::size_t count(repair_step kind) const { return count_of(std::size_t(kind)); }
    [[nodiscard]] bool has(repair_step kind) const { return count(kind) != 0; }

    void add_joined(std::size_t vertex, std::size_t into);
    void add_removed_corner(std::size_t face, std::size_t vertex);
    /// Reports that a face was left out. `why()` returns the reason, such as "as it has 2 corners".
    template <class Why>
    void add_dropped_face(std::size_t face, const Why& why)
    {
        add_message(std::size_t(repair_step::dropped_face), [&] { return named("face", face) + "left out, " + why(); });
    }
    void add_turned(std::size_t face);
    /// Reports that an edge was cut. `why()` returns the reason, such as "as it has 3 faces".
    template <class Why>
    void add_cut(std::size_t low, std::size_t high, const Why& why)
    {
        add_message(std::size_t(repair_step::cut_edge),
                    [&] { return "edge " + number(low) + "-" + number(high) + ": cut, " + why(); });
    }
    void add_split(std::size_t vertex, std::size_t fans);
    void add_dropped_vertex(std::size_t vertex);

private:
    static constexpr std::array<std::string_view, 7> names{"joined vertices",
                                                           "repeated corners left out",
                                                           "faces left out",
                                                           "faces turned round",
                                                           "edges cut",
                                                           "split vertices",
                                                           "vertices left out"};
};

#ifdef KITH_HAS_BODIES

KITH_IN_LIBRARY void repair_report::add_joined(std::size_t vertex, std::size_t into)
{
    add_message(std::size_t(repair_step::joined_vertex),
                [&] { return named("vertex", vertex) + "joined with vertex " + number(into); });
}
KITH_IN_LIBRARY void repair_report::add_removed_corner(std::size_t face, std::size_t vertex)
{
    add_message(std::size_t(repair_step::removed_corner), [&] {
        return named("face", face) + "its repeated corner at vertex " + number(vertex) + " is left out";
    });
}
KITH_IN_LIBRARY void repair_report::add_turned(std::size_t face)
{
    add_message(std::size_t(repair_step::turned_face), [&] { return named("face", face) + "turned round"; });
}
KITH_IN_LIBRARY void repair_report::add_split(std::size_t vertex, std::size_t fans)
{
    add_message(std::size_t(repair_step::split_vertex), [&] {
        return named("vertex", vertex) + "split into " + std::to_string(fans) + " vertices, one for each fan of faces";
    });
}
KITH_IN_LIBRARY void repair_report::add_dropped_vertex(std::size_t vertex)
{
    add_message(std::size_t(repair_step::dropped_vertex),
                [&] { return named("vertex", vertex) + "left out, it belongs to no face"; });
}

#endif

} // namespace kith
