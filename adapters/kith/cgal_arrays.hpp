// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/fields/property/property_access.hpp>

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace kith::detail {

/// A value type that stands for another one. A property array of it claims to hold `type`, and stores in `*array` the
/// array from which it is to be filled.
struct sought_values {
    const std::type_info* type = &typeid(void);
    CGAL::Properties::Base_property_array** array = nullptr;
};

} // namespace kith::detail

namespace CGAL::Properties {

/// A property array without values. When meshes are joined, CGAL passes it the array of the same name and type. In this
/// way kith reaches values of types that are not named here.
template <>
class Property_array<kith::detail::sought_values> : public Base_property_array {
    using base = Base_property_array;

public:
    using value_type = kith::detail::sought_values;
    using reference = value_type&;
    using const_reference = const value_type&;
    using iterator = value_type*;
    using const_iterator = const value_type*;

    explicit Property_array(const std::string& name, const value_type& sought = {}) : base(name), sought_(sought) {}

    void reserve(std::size_t) override {}
    void resize(std::size_t) override {}
    void shrink_to_fit() override {}
    auto push_back() -> decltype(std::declval<base&>().push_back()) override
    {
        return decltype(std::declval<base&>().push_back())();
    }
    void reset(std::size_t) override {}
    bool transfer(const base& other) override
    {
        *sought_.array = const_cast<base*>(&other); // the array of a mesh that the caller may change
        return true;
    }
    bool transfer(const base&, std::size_t, std::size_t) override { return false; }
    void swap(std::size_t, std::size_t) override {}
    [[nodiscard]] base* clone() const override { return new Property_array(name(), sought_); }
    [[nodiscard]] base* empty_clone() const override { return clone(); }
    [[nodiscard]] const std::type_info& type() const override { return *sought_.type; }

    // These override virtual functions that the base class has in later versions of CGAL.
    virtual std::size_t grow_by(std::size_t) { return 0; }
    virtual void pop_back() {}
    [[nodiscard]] virtual std::size_t capacity() const { return 0; }

private:
    value_type sought_;
};

} // namespace CGAL::Properties

namespace kith::detail {

/// Returns the property maps of these names on elements with handles of this type, except the known ones. Of several
/// maps with one name only the first is found. Cost: O(1), or that of copying the elements if there are other maps.
template <class Handle, class Point>
std::vector<any_property> other_arrays(CGAL::Surface_mesh<Point>& mesh, const std::vector<std::string>& names,
                                       const std::vector<known_property>& known)
{
    using array = CGAL::Properties::Base_property_array;
    std::vector<any_property> result;
    std::vector<array*> found(names.size(), nullptr); // does not grow, as pointers lead into it
    CGAL::Surface_mesh<Point> asks;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::type_info& type = mesh.template property_type<Handle>(names[i]);
        const auto is_it = [&](const known_property& each) { return each.name == names[i] and each.type == type; };
        if (std::find(names.begin(), names.begin() + std::ptrdiff_t(i), names[i]) ==
                names.begin() + std::ptrdiff_t(i) and
            std::ranges::none_of(known, is_it)) {
            asks.template add_property_map<Handle, sought_values>(names[i], sought_values{&type, &found[i]});
            result.push_back({names[i], nullptr, nullptr, nullptr});
        }
    }
    if (result.empty())
        return result;
    asks.join(mesh);
    std::size_t next = 0;
    for (array* const each : found)
        if (each != nullptr)
            result[next++] = {each->name(),
                              each,
                              [](void* a, std::size_t from, std::size_t to) {
                                  array& values = *static_cast<array*>(a);
                                  values.transfer(values, from, to);
                              },
                              [](void* a, std::size_t x, std::size_t y) { static_cast<array*>(a)->swap(x, y); }};
    result.resize(next);
    return result;
}

} // namespace kith::detail
