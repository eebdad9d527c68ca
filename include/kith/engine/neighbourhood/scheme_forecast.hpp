// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

/// Advances a scheme to the next level without any elements: its state may count levels.
template <mesh Mesh, scheme Scheme>
void advance_without_elements(Scheme& scheme, int generation)
{
    if constexpr (has_state<Scheme>) {
        const Mesh nothing;
        const level_of<Mesh> level(nothing);
        const numbering_of<Scheme, typename level_of<Mesh>::index_type> ids(level, columns_of(scheme, generation));
        advance(scheme, level, generation, ids, nothing);
    }
}

template <class... Columns>
constexpr bool know_all_tuples(const std::tuple<Columns...>*)
{
    return (std::is_empty_v<decltype(Columns::where)> and ...);
}
template <class State>
concept has_parts = requires(const State& state) { state.of_part(part_numbers<std::uint32_t>()); };
template <class... State>
constexpr bool have_parts(const std::tuple<State&...>*)
{
    return (has_parts<State> and ...);
}

/// Returns true if the columns of a scheme may look at its state.
template <scheme Scheme>
constexpr bool may_ask_state()
{
    using columns = columns_type<Scheme>;
    return has_state<Scheme> and not(know_all_tuples(static_cast<const decltype(columns::vertices.list)*>(nullptr)) and
                                     know_all_tuples(static_cast<const decltype(columns::edges.list)*>(nullptr)) and
                                     know_all_tuples(static_cast<const decltype(columns::faces.list)*>(nullptr)));
}

} // namespace detail

/// The schemes of future levels, one after the other, as far as their columns are concerned. If the columns may look at
/// the state, it is the state of a part without elements.
template <scheme Scheme>
class scheme_forecast {
    static constexpr bool changes = detail::may_ask_state<Scheme>() and
                                    detail::have_parts(
                                        static_cast<const decltype(detail::states_of(std::declval<const Scheme&>()))*>(
                                            nullptr));

public:
    /// Begins with the scheme of a control mesh of this generation. The scheme must outlive this.
    scheme_forecast(const Scheme& scheme, int generation) : control_(scheme), generation_(generation)
    {
        if constexpr (changes)
            later_.emplace(detail::scheme_of_part(scheme, part_numbers<std::uint32_t>()));
    }

    [[nodiscard]] const Scheme& operator*() const { return later_ ? *later_ : control_; }
    [[nodiscard]] int generation() const { return generation_; }
    scheme_forecast& operator++()
    {
        if constexpr (changes)
            detail::advance_without_elements<basic_mesh<>>(*later_, generation_);
        ++generation_;
        return *this;
    }

private:
    const Scheme& control_;
    std::optional<Scheme> later_;
    int generation_;
};

} // namespace kith
