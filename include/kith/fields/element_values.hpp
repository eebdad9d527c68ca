// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/base/message.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/fields/property/unset_values.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace kith {

/// The elements on which a field has its values.
enum class field_on : unsigned char { vertices, edges, faces, corners };

/// The values of a field on the elements of one kind of a level, by dense number, or none at all. They are cut, joined
/// and sent as state of a level is.
template <field_on Where, class T>
class element_values {
public:
    element_values() = default;
    explicit element_values(storage<T> values) : values_(std::move(values)) {}

    /// Returns how many elements of this kind a level, or a part of a level, has.
    template <counts_elements Level>
    static std::size_t count_on(const Level& level)
    {
        if constexpr (Where == field_on::vertices)
            return level.vertex_count();
        else if constexpr (Where == field_on::edges)
            return level.edge_count();
        else if constexpr (Where == field_on::faces)
            return level.face_count();
        else
            return level.corner_count();
    }

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool empty() const { return values_.empty(); }
    [[nodiscard]] std::span<const T> all() const { return {values_.data(), values_.size()}; }
    [[nodiscard]] const T& operator[](std::size_t element) const { return values_[element]; }
    [[nodiscard]] T& operator[](std::size_t element) { return values_[element]; }

    /// Throws mesh_error if there are values, but not one for each element of the level.
    template <counts_elements Level>
    void require_one_each(const Level& level) const
    {
        if (not empty() and size() != count_on(level))
            throw mesh_error("a field has " + std::to_string(size()) + " values, the level has " +
                             std::to_string(count_on(level)) + " " + name() + "; give it one for each");
    }
    /// Returns the values of a part of the level. Errors: mesh_error if an element of the part has none.
    template <std::unsigned_integral Index>
    [[nodiscard]] element_values of_part(const part_numbers<Index>& part) const
    {
        element_values result;
        if (empty())
            return result;
        result.values_ = storage<T>(count_on(part));
        for_each_in(part, [&](std::size_t here, std::size_t there) {
            if (there >= size())
                throw mesh_error("a field has " + std::to_string(size()) + " values, but the " + name() +
                                 " include number " + std::to_string(there) + "; give it one for each");
            result.values_[here] = values_[there];
        });
        return result;
    }
    /// Takes over the values of a part.
    template <std::unsigned_integral Index>
    void add_part(const element_values& more, const part_numbers<Index>& part)
    {
        if (more.empty())
            return;
        std::size_t end = size();
        for_each_in(part, [&](std::size_t, std::size_t there) { end = std::max(end, there + 1); });
        if (end != size()) {
            storage<T> longer(end);
            std::copy(values_.begin(), values_.end(), longer.begin());
            std::fill(longer.begin() + size(), longer.end(), detail::value_of_nothing<T>());
            values_ = std::move(longer);
        }
        for_each_in(part, [&](std::size_t here, std::size_t there) { values_[there] = more[here]; });
    }
    /// Writes the values to a message; unpack() reads them from one.
    template <message_writer Out>
    void pack(Out& out) const
    {
        if constexpr (are_plain())
            out.add_array(values_);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        if constexpr (are_plain())
            values_ = in.template get_array<storage<T>>();
    }

private:
    static constexpr const char* name()
    {
        return std::array{"vertices", "edges", "faces", "corners"}[std::size_t(Where)];
    }
    static constexpr bool are_plain()
    {
        constexpr bool are = std::is_trivially_copyable_v<T>;
        static_assert(are,
                      "the values of a field that is sent to other ranks are plain bytes, trivially copyable; others, "
                      "such as std::string, stay on one");
        return are;
    }
    /// Calls f(number in the part, number in the level) for each element of a part.
    template <std::unsigned_integral Index, class F>
    static void for_each_in(const part_numbers<Index>& part, const F& f)
    {
        const auto in_list = [&](std::span<const Index> list) {
            for (std::size_t i = 0; i < list.size(); ++i)
                f(i, std::size_t(list[i]));
        };
        if constexpr (Where == field_on::vertices)
            in_list(part.vertices);
        else if constexpr (Where == field_on::edges)
            in_list(part.edges);
        else if constexpr (Where == field_on::faces)
            in_list(part.faces);
        else
            part.for_each_corner(f);
    }

    storage<T> values_;
};

} // namespace kith
