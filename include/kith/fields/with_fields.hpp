// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field.hpp"

#include <kith/numbering/step/scheme.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// A scheme with fields: with_fields(catmull_clark{}, on_faces(materials), on_corners(texture_coordinates)). In all
/// else it is that scheme: points keep their bits, and a function that takes the scheme takes this one. The fields go
/// where state of a level goes: through `refine_with_fields` and `hierarchy`, into tiles, to ranks and into messages.
template <scheme Scheme, class... Fields>
class with_fields : public Scheme {
public:
    explicit with_fields(Scheme scheme, Fields... fields) : Scheme(std::move(scheme)), fields_(std::move(fields)...) {}

    /// Returns field number I, of the level that this scheme refines.
    template <std::size_t I = 0>
    [[nodiscard]] auto& field()
    {
        return std::get<I>(fields_);
    }
    template <std::size_t I = 0>
    [[nodiscard]] const auto& field() const
    {
        return std::get<I>(fields_);
    }
    /// Returns all fields of the level that this scheme refines.
    [[nodiscard]] std::tuple<Fields...>& fields() { return fields_; }
    [[nodiscard]] const std::tuple<Fields...>& fields() const { return fields_; }
    /// Returns the scheme without its fields, as at this level.
    [[nodiscard]] const Scheme& plain() const { return *this; }

    static constexpr auto traits()
    {
        constexpr auto& own = traits_of<Scheme>;
        return scheme_traits{.name = own.name,
                             .faces = own.faces,
                             .closed_only = own.closed_only,
                             .trusted = own.trusted,
                             .valence = own.valence,
                             .require = own.require,
                             .reach = own.reach,
                             .is_marked = own.is_marked,
                             .state = [](auto& scheme) { return with_fields::states(scheme); },
                             .closure = own.closure};
    }

private:
    template <class Self>
    static auto states(Self& scheme)
    {
        const auto fields = std::apply([](auto&... each) { return std::tie(each...); }, scheme.fields_);
        using plain_scheme = std::conditional_t<std::is_const_v<Self>, const Scheme, Scheme>;
        if constexpr (has_state<Scheme>)
            return std::tuple_cat(std::tie(static_cast<plain_scheme&>(scheme)), fields);
        else
            return fields;
    }

    std::tuple<Fields...> fields_;
};

} // namespace kith
