// SPDX-License-Identifier: BSD-3-Clause
#include <kith/registry.hpp>

#include <kith/compiled_schemes.hpp>
#include <kith/limits/limit.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace {

const std::filesystem::path test_dir = KITH_TEST_DIR;

/// Calls test(type*, header) for each scheme of the registry.
template <class Test>
void for_each_registered(const Test& test){
#define KITH_TESTED(type, header, numbers, paper) test(static_cast<const kith::type*>(nullptr), std::string(#header));
    KITH_SCHEMES(KITH_TESTED)
#undef KITH_TESTED
}

TEST(registry, has_limit_masks_of_each_scheme)
{
    for_each_registered([]<class Scheme>(const Scheme*, const std::string&) {
        using level = kith::level_of<kith::basic_mesh<>>;
        EXPECT_TRUE((kith::has_limit_positions<Scheme, kith::vertex<level>, level> or
                     kith::has_limit_positions<Scheme, kith::face<level>, level>))
            << kith::scheme_name<Scheme>();
    });
}

TEST(registry, has_a_page_of_each_scheme)
{
    std::string text;
    for (const auto& page : {"schemes.md", "schemes/order.md"}) {
        std::ifstream in(test_dir / ".." / "docs" / page);
        text.append(std::istreambuf_iterator<char>(in), {});
    }
    for_each_registered([&]<class Scheme>(const Scheme*, const std::string& header) {
        EXPECT_TRUE(text.find("`" + header + "`") != std::string::npos or
                    text.find(std::string(kith::scheme_name<Scheme>())) != std::string::npos)
            << header;
        EXPECT_FALSE(kith::paper_of<Scheme>.empty()) << header;
    });
}

TEST(registry, has_tests_and_golden_vectors_of_each_scheme)
{
    // Tests and compare_openmesh compare interpolatory_sqrt3 with OpenMesh. The test of quad_tri evaluates it in
    // another way.
    const std::set<std::string> without_vectors{"interpolatory_sqrt3", "quad_tri"};
    for_each_registered([&](const auto*, const std::string& header) {
        EXPECT_TRUE(std::filesystem::exists(test_dir / "schemes" / (header + "_test.cpp"))) << header;
        bool has_vectors = false;
        for (const auto& file : std::filesystem::directory_iterator(test_dir / "golden"))
            has_vectors = has_vectors or file.path().filename().string().starts_with(header + "_");
        EXPECT_NE(has_vectors, without_vectors.contains(header)) << header;
    });
}

TEST(registry, lists_each_scheme_once)
{
    std::set<std::string_view> names;
    std::apply([&]<class... Scheme>(const Scheme&...) { (names.insert(kith::scheme_name<Scheme>()), ...); },
               kith::all_schemes());
    EXPECT_EQ(names.size(), std::tuple_size_v<kith::all_schemes>);
    EXPECT_EQ(names.size(), 14);
}

} // namespace
