// SPDX-License-Identifier: BSD-3-Clause
#include "letters.hpp"

#include <cstddef>

namespace kith::picture {

namespace {

/// The letters from ' ' to '~': polylines apart by blanks, whose points are pairs of digits. The first digit counts to
/// the right from 0 to 4; the second upward from 0, with the base line at 2, small letters up to 6 and capitals to 8.
constexpr std::array<std::string_view, 95> letters{
    "", // blank
    "2824 2222",
    "1817 3837",
    "1218 3238 0444 0646",
    "463605143443321203 2921",
    "0248 0707 4343",
    "42061728362503123244",
    "2827",
    "38262432",
    "18262412",
    "1337 1733 0545",
    "0545 2327",
    "2211",
    "0545",
    "2222",
    "0248",
    "123243473818070312",
    "172822 1232",
    "07183847460242",
    "07183847463525 354443321203",
    "32380444",
    "4808053544433202",
    "38180703123243443505",
    "084812",
    "180706153544433212030415 3546473818",
    "12324347381807061545",
    "2323 2626",
    "2626 2211",
    "471543",
    "0444 0646",
    "073503",
    "071838474625 2524 2222",
    "44342425354544 454738180703123242",
    "022842 1434",
    "02083847463505 3544433202",
    "4738180703123243",
    "02082846442202",
    "48080242 0535",
    "480802 0535",
    "47381807031232434525",
    "0208 4248 0545",
    "1838 2822 1232",
    "4843321203",
    "0208 480542",
    "080242",
    "0208254842",
    "02084248",
    "123243473818070312",
    "02083847463505",
    "123243473818070312 2442",
    "02083847463505 2542",
    "473818070615354443321203",
    "0848 2822",
    "080312324348",
    "082248",
    "0812263248",
    "0248 0842",
    "082548 2522",
    "08480242",
    "38282232",
    "0842",
    "18282212",
    "062846",
    "0141",
    "1827",
    "16364542 441403123243",
    "0802 0516364543321203",
    "4536160503123243",
    "4842 4536160503123243",
    "044445361605031232",
    "38281712 0636",
    "4641301001 4536160504133344",
    "0802 0516364542",
    "162622 1232 2828",
    "262110 2828",
    "0802 4604 1442",
    "18282332",
    "0602 05162522 25364542",
    "0602 0516364542",
    "123243453616050312",
    "0600 0516364543321203",
    "4640 4536160503123243",
    "0602 05163645",
    "45361605143443321203",
    "18132232 0636",
    "0603123243 4642",
    "062246",
    "0612253246",
    "0246 0642",
    "0622 461000",
    "06460242",
    "382726152423 2332",
    "2820",
    "182726352423 2312",
    "05163445",
};

constexpr double unit = .1, advance = 6 * unit; // of the height of a line

} // namespace

double width_of_text(std::string_view text, double size)
{
    std::size_t count = 0;
    for (const char c : text)
        count += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0; // not inside a character of UTF-8
    return double(count) * advance * size;
}

std::vector<stroke> strokes_of_text(std::string_view text, double x, double y, double size)
{
    std::vector<stroke> result;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xc0) == 0x80)
            continue;
        const std::string_view letter = letters[std::size_t((c < ' ' or c > '~' ? '?' : c) - ' ')];
        const auto at = [&](std::size_t i) {
            return std::array{x + size * unit * (.5 + (letter[i] - '0')), y - size * unit * (letter[i + 1] - '2')};
        };
        for (std::size_t i = 0; i + 3 < letter.size(); i += 2) {
            if (letter[i + 2] == ' ') {
                ++i;
                continue;
            }
            result.push_back({at(i), at(i + 2)});
        }
        x += advance * size;
    }
    return result;
}

} // namespace kith::picture
