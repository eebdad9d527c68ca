// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy.hpp"

#include <kith/field/field.hpp>
#include <kith/property/averaged_value.hpp>
#include <kith/property/property_access.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// What has become of the properties of a mesh, by their names.
struct property_report {
    std::vector<std::string> carried;
    std::vector<std::string>
        left_out; ///< of a type that is not known, on half-edges and not to be averaged, or normals
};

namespace detail {

/// T(), which elements have that inherit nothing; zero where its constructor leaves it open, as those of OpenMesh's vectors do.
template <class T>
const T& value_of_nothing()
{
    static const T value = T(); // what is static is cleared before it is constructed
    return value;
}

/// The properties of elements of one kind: those to be averaged each by itself, the others by the number of the element that
/// they inherit from, which is carried once.
template <class Handle, mesh M, scheme Scheme>
class property_carrier {
    using traits = mesh_traits<M>;
    using access = property_access<M>;
    using number = typename access::number;
    static constexpr bool of_vertices = std::same_as<Handle, typename traits::vertex>;
    static constexpr bool of_edges = std::same_as<Handle, typename traits::edge>;
    static constexpr bool of_halfedges = std::same_as<Handle, typename traits::halfedge>;

public:
    property_carrier(const hierarchy<M, Scheme>& levels, int from, int to, M& fine)
        : levels_(levels), from_(from), to_(to), fine_(fine)
    {
        for_each_handle<Handle>(source(), [&](Handle x) { handles_.push_back(x); });
    }

    template <class... T>
    void carry_all(std::tuple<T...>*, property_report& report)
    {
        for (const std::string& name : access::template names<Handle>(source())) {
            const bool is_carried = not access::follows_from_points(name) and (carry<T>(name) or ...);
            (is_carried ? report.carried : report.left_out).push_back(name);
        }
    }

private:
    const M& source() const { return levels_[from_]; }

    template <class T>
    bool carry(const std::string& name)
    {
        constexpr bool averages = (of_vertices or of_halfedges) and can_be_averaged<T>;
        if constexpr (not averages and
                      (of_halfedges or (of_edges and not numbering_of<Scheme, std::uint32_t>::has_edges))) {
            return false;
        } else {
            const auto from = access::template find<Handle, T>(source(), name);
            if (not from)
                return false;
            auto to = access::template add<Handle, T>(fine_, name);
            if constexpr (averages)
                average<T>(*from, to);
            else
                inherit<T>(*from, to);
            return true;
        }
    }
    template <class T, class From, class To>
    void average(const From& from, To& to) const
    {
        storage<four_numbers<number>> coarse(handles_.size());
        std::transform(handles_.begin(), handles_.end(), coarse.begin(), [&](Handle x) {
            return averaged_value<T>::template load<number>(from[x]);
        });
        const auto write = [&](const auto& result) {
            std::size_t i = 0;
            for_each_handle<Handle>(fine_,
                                    [&](Handle x) { to[x] = averaged_value<T>::template store<number>(result[i++]); });
        };
        if constexpr (of_vertices)
            write(levels_.carry(from_, to_, on_vertices(coarse, by_mask())));
        else
            write(levels_.carry(from_, to_, on_corners(coarse)));
    }
    template <class T, class From, class To>
    void inherit(const From& from, To& to)
    {
        if (heirs_.empty())
            heirs_ = find_heirs();
        std::size_t i = 0;
        for_each_handle<Handle>(fine_, [&](Handle x) {
            const std::uint32_t heir = heirs_[i++];
            to[x] = heir == 0 ? value_of_nothing<T>() : T(from[handles_[heir - 1]]);
        });
    }
    /// One more than the number of what an element inherits from, 0 for those that inherit nothing.
    storage<std::uint32_t> find_heirs() const
    {
        storage<std::uint32_t> numbers(handles_.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = std::uint32_t(i + 1);
        const auto carried = [&](auto field) {
            return storage<std::uint32_t>(levels_.carry(from_, to_, std::move(field)).values());
        };
        if constexpr (of_vertices)
            return carried(on_vertices(numbers, from_vertex()));
        else if constexpr (of_edges)
            return carried(on_edges(numbers));
        else
            return carried(on_faces(numbers));
    }

    const hierarchy<M, Scheme>& levels_;
    int from_, to_;
    M& fine_;
    std::vector<Handle> handles_;
    storage<std::uint32_t> heirs_;
};

} // namespace detail

/// Gives `fine`, which has the elements of level `to` of a hierarchy, the properties of level `from` under their names: on
/// vertices, half-edges, edges and faces, of the types that property_access knows, and More.
/// On vertices, what can be averaged goes by the masks of the scheme, as the points do, and the rest stays with the vertices that
/// come from a vertex. Faces inherit from their parent, edges from the edge along which they lie; all others have T(). On
/// half-edges, corners that is, what can be averaged is linear in each face, with its seams.
/// Errors: mesh_error unless from <= to, or where `fine` has other elements. Cost: a step of the scheme without connectivity
/// per property that is averaged, and one pass over the levels for the others of a kind.
template <class... More, mesh M, scheme Scheme>
property_report carry_properties(const hierarchy<M, Scheme>& levels, int from, int to, M& fine)
{
    using traits = mesh_traits<M>;
    const auto count = [](const M& mesh) {
        return std::array{traits::vertex_bound(mesh), traits::edge_bound(mesh), traits::face_bound(mesh)};
    };
    if (count(fine) != count(levels[to]))
        throw mesh_error("the mesh that is to have the properties is not level " + std::to_string(to) +
                         " of the hierarchy; give a copy of that level");
    using types = decltype(std::tuple_cat(std::declval<typename property_access<M>::value_types>(),
                                          std::declval<std::tuple<More...>>()));
    property_report report;
    const auto carry = [&]<class Handle>(Handle) {
        detail::property_carrier<Handle, M, Scheme>(levels, from, to, fine)
            .carry_all(static_cast<types*>(nullptr), report);
    };
    carry(typename traits::vertex());
    carry(typename traits::halfedge());
    carry(typename traits::edge());
    carry(typename traits::face());
    return report;
}

/// `refine`, to the same points, with all properties that can be carried. Errors: as hierarchy::refine. Cost: that of both;
/// keeps all levels meanwhile.
template <class... More, mesh M, scheme Scheme>
std::pair<M, property_report> refine_with_properties(const M& mesh, const Scheme& scheme, int levels)
{
    hierarchy<M, Scheme> all(mesh, scheme);
    all.refine(levels);
    std::pair<M, property_report> result(all[levels], property_report());
    result.second = carry_properties<More...>(all, 0, levels, result.first);
    return result;
}

} // namespace kith
