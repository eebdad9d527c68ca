// SPDX-License-Identifier: BSD-3-Clause
#include "support/own_state.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/presets.hpp>
#include <kith/schemes.hpp>
#include <kith/tiles/part/scheme_members.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

/// A scheme without members or traits, from which other test schemes are made.
struct own_columns {
    static constexpr auto columns() { return kith::quad_split::columns(); }
};
#define KITH_OWN_SCHEME                                                                                                \
    static constexpr auto columns()                                                                                    \
    {                                                                                                                  \
        return kith::quad_split::columns();                                                                            \
    }                                                                                                                  \
    template <class R>                                                                                                 \
    void operator()(const R&) const                                                                                    \
    {                                                                                                                  \
    }

template <class... Members>
struct holds;
template <class A>
struct holds<A> {
    A a;
    KITH_OWN_SCHEME
};
template <class A, class B>
struct holds<A, B> {
    A a;
    B b;
    KITH_OWN_SCHEME
};
template <class A, class B, class C>
struct holds<A, B, C> {
    A a;
    B b;
    C c;
    KITH_OWN_SCHEME
};
template <class... Members>
constexpr bool is_taken = kith::detail::names_all_state<holds<Members...>>();

struct options {
    double tension = 0;
    std::array<double, 3> weights{};
    kith::boundary_corner corners{};
};
struct options_with_values {
    double tension = 0;
    std::vector<float> at_vertex;
};
enum class rule : unsigned char { smooth, sharp };

/// A scheme that names the first of its fields as its state.
template <class Other>
struct with_field {
    own_state::numbers kept;
    Other other;

    static constexpr auto traits() { return kith::scheme_traits{.name = "with field", .state = &with_field::kept}; }
    KITH_OWN_SCHEME
};
template <class Other>
constexpr bool is_taken_beside_state = kith::detail::names_all_state<with_field<Other>>();

struct with_table {
    std::vector<double> weights;
    std::function<double(int)> of_valence;

    static constexpr auto traits() { return kith::scheme_traits{.name = "with table", .constants_only = true}; }
    KITH_OWN_SCHEME
};

/// A scheme whose members cannot be listed.
class closed_class {
public:
    closed_class() : sharp_(kith::crease_method::chaikin) {}
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "closed class", .state = [](auto& s) -> auto& { return s.sharp_; }};
    }
    KITH_OWN_SCHEME

private:
    kith::creases sharp_;
    rule rule_ = rule::smooth;
};
class closed_class_with_values {
public:
    closed_class_with_values() = default;
    KITH_OWN_SCHEME

private:
    std::vector<double> at_face_;
};
struct derived : options_with_values {
    KITH_OWN_SCHEME
};
struct twelve {
    char a, b, c, d, e, f, g, h, i, j, k;
    std::vector<int> l;
    KITH_OWN_SCHEME
};
struct thirteen {
    char a, b, c, d, e, f, g, h, i, j, k, l;
    std::vector<int> m;
    KITH_OWN_SCHEME
};

#undef KITH_OWN_SCHEME

} // namespace

TEST(scheme_members, options_are_no_state)
{
    EXPECT_TRUE((is_taken<double, int, rule>));
    EXPECT_TRUE((is_taken<options, std::string, std::optional<double>>));
    EXPECT_TRUE((is_taken<double (*)(int), std::string_view, std::array<double, 7>>));
    EXPECT_TRUE((is_taken<double[4], options>));
    EXPECT_TRUE((is_taken<options[2], std::array<std::array<double, 2>, 3>, own_columns>));
    const double weight = 0.5;
    const auto rule = [weight](auto v) { return weight * v; };
    EXPECT_TRUE((is_taken<decltype(rule)>));
    EXPECT_TRUE(kith::detail::names_all_state<with_table>());
}

TEST(scheme_members, values_per_element_are_refused)
{
    EXPECT_FALSE((is_taken<std::vector<double>>));
    EXPECT_FALSE((is_taken<double, std::vector<double>, int>));
    EXPECT_FALSE((is_taken<double[3], std::vector<double>>));
    EXPECT_FALSE((is_taken<std::array<int, 3>, std::map<std::size_t, double>>));
    EXPECT_FALSE((is_taken<options, options_with_values>));
    EXPECT_FALSE((is_taken<int, std::array<std::vector<double>, 2>>));
    EXPECT_FALSE((is_taken<std::span<const double>>));
    EXPECT_FALSE((is_taken<const double*>));
    EXPECT_FALSE((is_taken<std::shared_ptr<const std::vector<double>>, int>));
    EXPECT_FALSE((is_taken<std::optional<std::vector<double>>, int>));
    EXPECT_FALSE((is_taken<std::function<double(std::size_t)>>));
    EXPECT_FALSE((is_taken<kith::creases>));
    EXPECT_FALSE(kith::detail::names_all_state<closed_class_with_values>());
    EXPECT_FALSE(kith::detail::names_all_state<derived>());
    EXPECT_FALSE(kith::detail::names_all_state<twelve>());
    EXPECT_FALSE(kith::detail::names_all_state<thirteen>());
}

TEST(scheme_members, state_covers_what_it_names)
{
    EXPECT_TRUE(is_taken_beside_state<double>);
    EXPECT_FALSE(is_taken_beside_state<std::vector<double>>);
    EXPECT_FALSE(is_taken_beside_state<own_state::numbers>); // only one of two equal fields is named
    EXPECT_TRUE(kith::detail::names_all_state<closed_class>());
    EXPECT_TRUE(kith::detail::names_all_state<own_state::wrapped>());
    EXPECT_TRUE(kith::detail::names_all_state<own_state::drawn>());
    EXPECT_TRUE(kith::detail::names_all_state<own_state::capped_dual>());
    EXPECT_TRUE(kith::detail::names_all_state<own_state::two_and_three>());
    const double weight = 0.5;
    const own_state::ruled rule{[weight](auto v) { return weight * v; }};
    EXPECT_TRUE((kith::detail::names_all_state<std::remove_const_t<decltype(rule)>>()));
    using drawn_with_fields = decltype(kith::with_fields(own_state::drawn(), kith::on_vertices(std::vector<double>())));
    EXPECT_TRUE((kith::detail::names_all_state<drawn_with_fields>()));
}

TEST(scheme_members, schemes_of_the_library_are_taken)
{
    EXPECT_TRUE(kith::detail::names_all_state<kith::catmull_clark>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::loop>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::doo_sabin>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::butterfly>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::sqrt3>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::kobbelt>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::mid_edge>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::nasri_hasbini>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::four_eight>());
    EXPECT_TRUE(kith::detail::names_all_state<kith::linear>());
}

TEST(scheme_members, options_that_differ_have_other_sums)
{
    const auto sum = [](const auto& scheme) { return kith::detail::sum_of_options(scheme); };
    EXPECT_EQ(sum(kith::catmull_clark{}), sum(kith::catmull_clark{}));
    EXPECT_NE(sum(kith::catmull_clark{}), sum(kith::catmull_clark{.corners = kith::boundary_corner::smoothed}));
    EXPECT_NE(sum(own_state::wrapped{}), sum(own_state::wrapped{{.corners = kith::boundary_corner::smoothed}}));
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(3, 2);
    EXPECT_EQ(sum(kith::catmull_clark{}), sum(creased)); // state is sent
    EXPECT_NE(sum(with_table{{1, 2}, {}}), sum(with_table{{1, 3}, {}}));
    EXPECT_NE(sum(with_table{{1, 2}, {}}), sum(with_table{{1, 2, 0}, {}}));
    const auto with_values = [](kith::catmull_clark scheme, double value) {
        return kith::with_fields(scheme, kith::on_vertices(std::vector<double>(3, value)));
    };
    EXPECT_EQ(sum(with_values({}, 1)), sum(with_values({}, 2)));
    EXPECT_NE(sum(with_values({}, 1)), sum(with_values({.corners = kith::boundary_corner::smoothed}, 1)));
}
