// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace kith::in_place {

/// The places of new elements while a mesh still holds the old ones: behind the old ones, by number. When all values
/// are written there, they are exchanged with the values in the final places.
struct staged_places {
    std::size_t vertices, edges, faces; ///< counts of handles in the old mesh
    const std::vector<std::uint32_t>* final_vertices;
    const connectivity<std::uint32_t>* topology;
};

/// The properties of a mesh on elements of one kind, while the mesh is overwritten.
template <class Handle, mesh_with_properties M>
struct properties_on {
    using access = property_access<M>;
    using traits = mesh_traits<M>;
    using places = kith::detail::written_places<Handle>;

    properties_on(const M& mesh, kith::detail::unset_values<M>& unset)
        : known(mesh, unset, static_cast<typename access::value_types*>(nullptr))
    {
    }

    /// Finds the properties whose types are not named, and the names that several properties share.
    void read_others(M& mesh)
    {
        std::vector<kith::detail::known_property> all = known.found();
        all.insert(all.end(), by_rule.begin(), by_rule.end());
        const char* why = "kith does not know its type; name the type, value_types<type>()";
        if constexpr (mesh_with_other_properties<M>) {
            others = access::template other_properties<Handle>(mesh, all);
            if (not others.empty())
                known.expect_others();
            why = "another property of these elements has its name; rename one";
        }
        std::vector<std::string> names = access::template names<Handle>(mesh);
        std::erase_if(names, access::follows_from_points);
        const auto is_here = [&](const auto& each) {
            if (const auto found = std::ranges::find(names, each.name); found != names.end())
                names.erase(found);
        };
        std::ranges::for_each(all, is_here);
        std::ranges::for_each(others, is_here);
        for (std::string& name : names)
            left_out.push_back({std::move(name), why});
    }
    /// Returns true if a property is carried by a rule of the caller.
    [[nodiscard]] bool has_rule(const std::string& name, std::type_index type) const
    {
        return std::ranges::any_of(by_rule, [&](const auto& each) { return each.name == name and each.type == type; });
    }
    [[nodiscard]] bool empty() const { return known.found().empty() and others.empty() and by_rule.empty(); }

    template <class Means>
    void write_means(M& mesh, const places& to, const Means& means)
    {
        for (std::size_t i = 0; i < means.size(); ++i)
            swaps.push_back(known.write_mean(mesh, known.means()[i], to, means[i].values()));
    }
    /// Writes the values that elements inherit. If `heirs` is empty, the scheme does not tell from which elements new
    /// ones come, and they inherit nothing.
    template <class Heirs>
    void write_heirs(M& mesh, const places& to, const Heirs& heirs)
    {
        if (not known.has_heirs())
            return;
        const storage<std::uint32_t> none(heirs.empty() ? to.elements.size() : 0, 0);
        known.write_heirs(mesh,
                          to,
                          heirs.empty() ? std::span<const std::uint32_t>(none.data(), none.size()) : heirs.values(),
                          &swaps);
    }
    template <class Heirs>
    void stage_others(const M& mesh, const places& to, const Heirs& heirs)
    {
        for (const auto& each : others)
            for (std::size_t i = 0; i < heirs.size(); ++i)
                if (heirs[i] != 0)
                    each.copy(each.array,
                              traits::index(mesh, known.handles()[heirs[i] - 1]),
                              traits::index(mesh, to.elements[i]));
    }
    /// Exchanges the values of two places for each number below `size`. The order is ascending, because a final place
    /// may be the staged place of an earlier element.
    template <class PlacesOf>
    void exchange(std::size_t size, const PlacesOf& places_of) noexcept
    {
        for (const auto& each : swaps)
            for (std::size_t i = 0; i < size; ++i)
                if (const auto [a, b] = places_of(i); a != b)
                    each->swap(a, b);
    }
    /// Exchanges values like exchange(), but of types that are not named. May fail in a library that exchanges them by
    /// copies.
    template <class PlacesOf>
    void exchange_others(std::size_t size, const PlacesOf& places_of)
    {
        for (const auto& each : others)
            for (std::size_t i = 0; i < size; ++i, ++exchanged_)
                if (const auto [a, b] = places_of(i); a != b)
                    each.swap(each.array, a, b);
    }
    /// Undoes exchange_others() as far as it came. Values whose copies fail again stay where they are.
    template <class PlacesOf>
    void exchange_others_back(std::size_t size, const PlacesOf& places_of) noexcept
    {
        for (; exchanged_ != 0; --exchanged_)
            if (const auto [a, b] = places_of((exchanged_ - 1) % size); a != b)
                try {
                    const auto& each = others[(exchanged_ - 1) / size];
                    each.swap(each.array, a, b);
                } catch (...) {
                }
    }

    /// Adds these properties to a report. Values of types that are not named are carried completely only where elements
    /// do nothing but inherit.
    void tell(property_report& report, bool is_carried, bool only_inherits) const
    {
        const auto tell_one = [&](const std::string& name, bool is_known, const char* why) {
            if (is_known)
                report.carried.push_back(name);
            else
                report.left_out.push_back({name, why});
        };
        for (const std::string& name : known.known())
            tell_one(name, is_carried, kith::detail::edges_unknown);
        for (const auto& each : by_rule)
            tell_one(each.name, is_carried, kith::detail::edges_unknown);
        for (const auto& each : others)
            tell_one(each.name,
                     is_carried and only_inherits,
                     is_carried ? "kith does not know its type: values stay where an element comes from one alone, "
                                  "others have the default; name the type, value_types<type>()"
                                : kith::detail::edges_unknown);
        report.left_out.insert(report.left_out.end(), left_out.begin(), left_out.end());
    }

    kith::detail::property_values<Handle, M> known;
    std::vector<kith::detail::any_property> others;
    std::vector<kith::detail::known_property> by_rule;
    std::vector<omission> left_out;
    std::vector<std::unique_ptr<kith::detail::value_exchange>> swaps; ///< of values that wait in staged places

private:
    std::size_t exchanged_ = 0; ///< calls of swap in exchange_others()
};

} // namespace kith::in_place
