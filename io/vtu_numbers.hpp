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
    bool rounded = false; ///< whole numbers of eight bytes among them had more digits than a double
};

/// Where the numbers of all arrays are, and how they are written.
class vtu_numbers {
public:
    explicit vtu_numbers(const xml_tag& file);
    /// Tells what comes behind the arrays: the element AppendedData, and all that follows.
    void set_appended(const xml_tag& tag, std::string_view rest);

    /// Returns so many values for each component. Errors: file_error where they are not there, or do not fit their
    /// type, and for an order of bytes or a compressor that is not read.
    [[nodiscard]] vtu_values values(const vtu_array& array, std::size_t count) const;

private:
    [[nodiscard]] vtu_values text_values(const vtu_array& array, std::size_t numbers) const;
    [[nodiscard]] std::string bytes_of(const vtu_array& array, std::size_t size) const;
    [[nodiscard]] std::string inflated(const vtu_array& array, std::string_view text, bool raw, std::size_t size) const;

    bool is_big_endian_;     ///< what is not text
    std::string compressor_; ///< of what is not text; empty: none
    std::size_t bytes_of_length_ = 4;
    std::string_view appended_;
    bool raw_ = false;
};

/// Errors: file_error for a type or a number of components that is none.
vtu_array vtu_array_of(const xml_tag& tag);

} // namespace kith::io
