// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/text/text_cursor.hpp>
#include <kith/io/text/text_writer.hpp>

#include <gtest/gtest.h>

#include <clocale>
#include <cstddef>
#include <limits>
#include <new>
#include <sstream>
#include <string>

using namespace kith;

namespace {

using cursor = io::text_cursor<io::text_kind::plain>;

double number_in(const std::string& text)
{
    return cursor(text).number([] { return std::string("it"); });
}
double any_number_in(const std::string& text)
{
    return cursor(text).any_number([] { return std::string("it"); });
}

/// Expects the values of numbers that lie outside the range of doubles, or that they are refused.
void expect_unusual_numbers()
{
    EXPECT_EQ(number_in("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(number_in("1.5e-400"), 0);
    EXPECT_EQ(number_in("-123.5e-410"), 0);
    EXPECT_EQ(any_number_in("1.5e-400"), 0);
    EXPECT_EQ(any_number_in("1.5e+400"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(any_number_in("-1.5e400"), -std::numeric_limits<double>::infinity());
    EXPECT_THROW(number_in("1.5e400"), io::file_error);
}

} // namespace

TEST(printable, leaves_letters_and_takes_commands)
{
    EXPECT_EQ(io::printable("a\x1b[31mred\a \t\n\x7f"), "a?[31mred? \t\n?");
    EXPECT_EQ(io::printable("h\xc3\xb6he \xe2\x82\xac \xf0\x9f\x90\x84"), "h\xc3\xb6he \xe2\x82\xac \xf0\x9f\x90\x84");
    EXPECT_EQ(io::printable("\xc2\x9b"
                            "31m \x9b"
                            "31m"),
              "?31m ?31m"); // a command of one character, and of one byte
    EXPECT_EQ(io::printable("\xe2\x80\xae"
                            "abc"),
              "?abc"); // from right to left
    EXPECT_EQ(io::printable("\xc3"), "?");
    EXPECT_EQ(io::printable("\xc0\x9b \xed\xa0\x80 \xf4\x90\x80\x80"), "?? ??? ????"); // no UTF-8
    EXPECT_EQ(io::printable(std::string("a\0b", 3)), "a?b");
    EXPECT_STREQ(io::file_error("\x1b]0;title\a.ply: no").what(), "?]0;title?.ply: no");
}

TEST(text, has_numbers_that_are_too_small_or_too_large)
{
    expect_unusual_numbers();
}

TEST(text, has_the_same_numbers_where_others_write_a_comma)
{
    const std::string before = std::setlocale(LC_ALL, nullptr);
    bool is_set = false;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8", "nl_NL.UTF-8"})
        is_set = is_set or std::setlocale(LC_ALL, name) != nullptr;
    if (not is_set)
        GTEST_SKIP() << "no locale with a decimal comma is installed";
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
    expect_unusual_numbers();
    std::setlocale(LC_ALL, before.c_str());
}

TEST(text, is_not_written_when_a_part_of_it_fails)
{
    std::ostringstream out;
    const auto write = [](io::text_block& text, std::size_t i) {
        if (i == 60000)
            throw std::bad_alloc();
        text << i << '\n';
    };
    EXPECT_THROW(io::write_blocks(out, 100000, write), std::bad_alloc);
    EXPECT_EQ(out.str(), "");
}

TEST(text, is_written_in_its_order)
{
    std::ostringstream out, expected;
    const std::size_t count = 200000; // more blocks than are processed at once
    io::write_blocks(out, count, [](io::text_block& text, std::size_t i) { text << i << ' '; });
    for (std::size_t i = 0; i < count; ++i)
        expected << i << ' ';
    EXPECT_EQ(out.str(), expected.str());
}
