// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "xml_tags.hpp"

#include <kith/io/format/mesh_attributes.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The arrays of numbers in a file of VTK's XML format.
namespace kith::io {

/// An array as the file declares it. Types have up to eight bytes.
struct vtu_array {
    xml_tag tag;
    std::string name;
    ply_number type;
    std::size_t components = 1;
};

/// The values of an array, one component after the other.
struct vtu_values {
    std::vector<double> numbers;
    bool rounded = false; ///< some whole numbers of eight bytes had more digits than a double
};

/// A reader of the numbers of all arrays in a file.
class vtu_numbers {
public:
    explicit vtu_numbers(const xml_tag& file);
    /// Sets the data behind the arrays: the element AppendedData, and everything that follows it.
    void set_appended(const xml_tag& tag, std::string_view rest);

    /// Returns `count` values for each component. Errors: file_error if the values are missing or do not fit their
    /// type, and for an order of bytes or a compressor that is not read.
    [[nodiscard]] vtu_values values(const vtu_array& array, std::size_t count) const;

private:
    [[nodiscard]] vtu_values text_values(const vtu_array& array, std::size_t numbers) const;
    [[nodiscard]] std::string bytes_of(const vtu_array& array, std::size_t size) const;
    [[nodiscard]] std::string inflated(const vtu_array& array, std::string_view text, bool raw, std::size_t size) const;

    bool is_big_endian_;     ///< byte order of numbers that are not text
    std::string compressor_; ///< of numbers that are not text; empty: none
    std::size_t bytes_of_length_ = 4;
    std::string_view appended_;
    bool raw_ = false;
};

/// Returns the array that a tag declares. Errors: file_error for a type, or a number of components, that does not
/// exist.
vtu_array vtu_array_of(const xml_tag& tag);

} // namespace kith::io
