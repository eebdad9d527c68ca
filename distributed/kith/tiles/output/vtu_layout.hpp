// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "offset_file.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kith {

/// The layout of the arrays of a file in VTK's XML format: raw binary, appended, each array after its length. Arrays
/// are declared in the order of the file, within elements that are opened and closed. `finish` makes the header before
/// them.
class vtu_layout {
public:
    /// The bytes after the arrays.
    static constexpr std::string_view tail = "\n</AppendedData>\n</VTKFile>\n";

    /// Opens an element (open) or closes it (close). VTK expects this order: Points, Cells, ...
    vtu_layout& open(const std::string& element)
    {
        arrays_ += "<" + element + ">\n";
        return *this;
    }
    vtu_layout& close(const std::string& element)
    {
        arrays_ += "</" + element + ">\n";
        return *this;
    }
    /// Declares an array of `bytes` bytes and returns its number, counted from 0.
    std::size_t add(std::uint64_t bytes, const std::string& attributes)
    {
        arrays_ += "<DataArray " + attributes + " format=\"appended\" offset=\"" + std::to_string(end_) + "\"/>\n";
        places_.push_back({end_, bytes});
        end_ += sizeof(std::uint64_t) + bytes;
        return places_.size() - 1;
    }
    /// Adds the words that the numbers of the array of this name stand for, as data of the whole file.
    void add_words(const std::string& name, const std::vector<std::string>& words)
    {
        words_ += "<DataArray type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" + std::to_string(words.size()) +
                  "\" format=\"ascii\">\n";
        for (const std::string& word : words) {
            for (const char letter : word)
                words_ += std::to_string(static_cast<unsigned char>(letter)) + " ";
            words_ += "0\n";
        }
        words_ += "</DataArray>\n";
    }
    /// Ends the declarations of a file with these numbers of points and cells. `type` is the type of the file;
    /// `counted_by` is the attribute that counts its cells.
    void finish(std::uint64_t points, std::uint64_t cells, const std::string& type = "UnstructuredGrid",
                const std::string& counted_by = "NumberOfCells")
    {
        static_assert(std::endian::native == std::endian::little, "the file says it is little-endian");
        head_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
                "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + type + ">\n" +
                (words_.empty() ? "" : "<FieldData>\n" + words_ + "</FieldData>\n") + "<Piece NumberOfPoints=\"" +
                std::to_string(points) + "\" " + counted_by + "=\"" + std::to_string(cells) + "\">\n" + arrays_ +
                "</Piece>\n</" + type + ">\n<AppendedData encoding=\"raw\">\n_";
    }

    /// Returns the bytes before the arrays. Precondition: finish was called.
    [[nodiscard]] const std::string& head() const { return head_; }
    /// Returns the size of the file. Precondition: finish was called.
    [[nodiscard]] std::uint64_t size() const { return head_.size() + end_ + tail.size(); }
    /// Returns the offset of the first byte of an array. Precondition: finish was called.
    [[nodiscard]] std::uint64_t offset(std::size_t array) const
    {
        return head_.size() + places_[array].offset + sizeof(std::uint64_t);
    }
    /// Writes all bytes that are not in arrays. Errors: write_error.
    void write_frame(placed_bytes& file) const
    {
        file.write(0, head_.data(), head_.size());
        file.write(size() - tail.size(), tail.data(), tail.size());
        for (const place& array : places_)
            file.write(head_.size() + array.offset, &array.bytes, sizeof array.bytes);
    }

private:
    struct place {
        std::uint64_t offset, bytes; // offset of the length, which the bytes follow
    };
    std::string head_, arrays_, words_;
    std::vector<place> places_;
    std::uint64_t end_ = 0;
};

/// Returns VTK's cell type of a polygon of this degree.
constexpr std::uint8_t vtk_cell_type(std::size_t degree)
{
    constexpr std::uint8_t triangle = 5, polygon = 7, quad = 9;
    return degree == 3 ? triangle : degree == 4 ? quad : polygon;
}

} // namespace kith
