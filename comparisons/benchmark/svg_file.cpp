// SPDX-License-Identifier: BSD-3-Clause
#include "svg_file.hpp"

#include <kith/io/text/file_error.hpp>

#include <fstream>

namespace kith::comparison {

void write_svg_file(const std::string& path, double width, double height, const std::string& style,
                    const std::string& body)
{
    std::ofstream file(path);
    file << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
         << "\" font-family=\"sans-serif\" font-size=\"12\">\n<style>" << style
         << "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
         << body << "</svg>\n";
    if (not file.flush())
        throw io::file_error(path + ": could not be written completely");
}

} // namespace kith::comparison
