// SPDX-License-Identifier: BSD-3-Clause
#include <kith/picture/image.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>

#if defined(KITH_HAS_PNG)
#include <png.h>
#endif

namespace kith::picture {

color color_at(const image& texture, double u, double v)
{
    if (not std::isfinite(u) or not std::isfinite(v))
        return gray;
    // Between the middles of two pixels, by a share of the way; at the rim of the image the rim has the color.
    const auto place_of = [](double x, std::size_t size) {
        const double share = 0 <= x and x <= 1 ? x : x - std::floor(x);
        const double place = std::clamp(share * double(size) - .5, 0., double(size - 1));
        const auto pixel = std::size_t(place);
        return std::tuple(pixel, std::min(pixel + 1, size - 1), float(place - double(pixel)));
    };
    const auto [left, right, to_right] = place_of(u, texture.width);
    const auto [top, bottom, downward] = place_of(1 - v, texture.height);
    const auto pixel = [&](std::size_t x, std::size_t y) {
        const auto& p = texture.at(x, y);
        return color{float(p[0]) / 255, float(p[1]) / 255, float(p[2]) / 255, float(p[3]) / 255};
    };
    return mix(mix(pixel(left, top), pixel(right, top), to_right),
               mix(pixel(left, bottom), pixel(right, bottom), to_right),
               downward);
}

#if defined(KITH_HAS_PNG)

bool writes_png()
{
    return true;
}

void write_png(std::ostream& out, const image& image)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGBA;
    png.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<char> bytes(size);
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0)
        throw std::runtime_error(std::string("picture: PNG: ") + png.message);
    if (not out.write(bytes.data(), std::streamsize(size)))
        throw std::runtime_error("picture: the image could not be written");
}

image read_png(std::istream& in)
{
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    image result;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0) {
        png.format = PNG_FORMAT_RGBA;
        result = {png.width, png.height, std::vector<std::array<std::uint8_t, 4>>(std::size_t(png.width) * png.height)};
        if (png_image_finish_read(&png, nullptr, result.pixels.data(), 0, nullptr) != 0)
            return result;
    }
    const std::string why = png.message;
    png_image_free(&png);
    throw std::runtime_error("picture: PNG: " + why);
}

#else

bool writes_png()
{
    return false;
}

void write_png(std::ostream&, const image&)
{
    throw std::runtime_error("picture: this build has no libpng, so it writes no PNG; write SVG");
}

image read_png(std::istream&)
{
    throw std::runtime_error("picture: this build has no libpng, so it reads no PNG");
}

#endif

} // namespace kith::picture
