// SPDX-License-Identifier: BSD-3-Clause
#include <kith/picture.hpp>

#include <stdexcept>
#include <string>

#if defined(KITH_HAS_PNG)
#include <png.h>
#endif

namespace kith::picture {

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

#else

bool writes_png()
{
    return false;
}

void write_png(std::ostream&, const image&)
{
    throw std::runtime_error("picture: this build has no libpng, so it writes no PNG; write SVG");
}

#endif

} // namespace kith::picture
