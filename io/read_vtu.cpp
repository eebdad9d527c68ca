// SPDX-License-Identifier: BSD-3-Clause
#include "read_vtu.hpp"

#include "vtu_piece.hpp"
#include "written_parts.hpp"

#include <kith/io/text/counted.hpp>
#include <kith/io/text/file_bytes.hpp>
#include <kith/io/text/text_cursor.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

/// The sections of a piece that are read. Other sections, and information about an array inside of it, are skipped.
constexpr std::array<std::string_view, 7> sections_that_are_read{
    "FieldData", "Points", "Cells", "Polys", "Strips", "PointData", "CellData"};

/// A file as its tags declare it: its pieces, or the names of the files that have them.
class vtu_file_reader {
public:
    explicit vtu_file_reader(std::string_view bytes) : tags_(bytes) { collect(); }

    /// Returns true if the file is an index of other files.
    [[nodiscard]] bool is_index() const { return is_index_; }
    [[nodiscard]] const std::vector<std::string>& sources() const { return sources_; }
    [[nodiscard]] std::size_t size() const { return declared_.size(); }
    /// Appends the contents of the pieces. If the pieces are joined with others, some may be empty.
    void read_pieces(bool is_joined, vtu_words& words, std::vector<vtu_piece>& pieces) const
    {
        for (const vtu_declaration& declared : declared_)
            pieces.push_back(read_piece(declared, *numbers_, words, is_joined));
    }
    /// Adds the words that the file declares. Words of one name in several files count only if they are the same.
    void add_words(vtu_words& words) const
    {
        for (const auto& [name, own] : words_)
            if (const auto [place, is_new] = words.by_name.try_emplace(name, own); not is_new and place->second != own)
                place->second.clear();
    }

private:
    /// Reads the declarations in the file.
    void collect()
    {
        xml_tag tag;
        std::string section;
        while (tags_.next(tag)) {
            if (tag.name == "VTKFile") {
                begin_file(tag);
            } else if (tag.name == "AppendedData") {
                require_begun().set_appended(tag, tags_.rest());
                break;
            } else if (tag.name == "Piece" and is_index_) {
                sources_.push_back(tag.attribute("Source"));
            } else if (tag.name == "Piece") {
                declared_.push_back({is_poly_data_, tag, {}, {}});
                section.clear();
            } else if (tag.name == "DataArray" and section == "FieldData") {
                add_words_of(tag);
            } else if (tag.name == "DataArray" and not section.empty() and not declared_.empty()) {
                declared_.back().arrays[section].push_back(tag);
            } else if (tag.name == "/" + section or tag.name == "/Piece") {
                section.clear();
            } else if (not tag.attributes.ends_with('/') and
                       std::ranges::find(sections_that_are_read, tag.name) != sections_that_are_read.end()) {
                section = tag.name;
                if (not declared_.empty())
                    declared_.back().sections[section] = tag;
            }
        }
        (void)require_begun();
        if (declared_.empty() and sources_.empty())
            throw file_error("has no piece with points and cells");
    }
    void begin_file(const xml_tag& tag)
    {
        const auto type = tag.attribute("type");
        is_index_ = type == "PUnstructuredGrid" or type == "PPolyData";
        is_poly_data_ = type == "PolyData";
        if (not is_index_ and not is_poly_data_ and type != "UnstructuredGrid")
            throw file_error("holds " + shown(type) +
                             ", which is not read; save it as an UnstructuredGrid (.vtu) or as PolyData (.vtp)");
        numbers_.emplace(tag);
    }
    vtu_numbers& require_begun()
    {
        if (not numbers_)
            throw file_error("a file of VTK begins with the element VTKFile, which is missing");
        return *numbers_;
    }
    /// Reads the words for which the numbers of an array of that name stand. They are data of the whole file.
    void add_words_of(const xml_tag& tag)
    {
        std::vector<std::string> words;
        if (tag.attribute("type") == "String" and tag.attribute("format") == "ascii") {
            std::string word;
            text_cursor<text_kind::plain> text(tag.text);
            while (text.to_content()) {
                const int letter = text.whole<int>([] { return std::string("a letter of a word"); });
                if (letter < std::numeric_limits<signed char>::min() or
                    letter > std::numeric_limits<unsigned char>::max())
                    throw file_error("the strings '" + shown(tag.attribute("Name")) + "' have the character code " +
                                     std::to_string(letter) + ", which does not exist");
                if (letter != 0)
                    word += letter > 0 and letter < ' ' ? '_' : char(letter); // lines of OBJ end there
                else
                    words.push_back(std::exchange(word, {}));
            }
        }
        words_[tag.attribute("Name")] = words;
    }

    xml_tags tags_;
    std::optional<vtu_numbers> numbers_;
    bool is_index_ = false, is_poly_data_ = false;
    std::vector<vtu_declaration> declared_;
    std::vector<std::string> sources_;
    std::map<std::string, std::vector<std::string>> words_;
};

/// Reads the files of an index. Errors: file_error, which begins with the name of the piece.
void read_sources(const std::vector<std::string>& sources, const std::string& directory, vtu_words& words,
                  std::vector<vtu_piece>& pieces)
{
    std::set<std::string> read;
    for (const std::string& source : sources) {
        const std::string path = (std::filesystem::path(directory) / source).string();
        if (source.empty())
            throw file_error("has a piece without a Source; name its file");
        if (not read.insert(source).second)
            throw file_error("names the piece " + shown(source) + " twice; name it once");
        const file_bytes bytes(path);
        try {
            const vtu_file_reader file(bytes.view());
            if (file.is_index())
                throw file_error("is an index of pieces, not a piece");
            file.add_words(words);
            file.read_pieces(true, words, pieces);
        } catch (const file_error& error) {
            throw file_error("its piece " + path + ": " + error.what());
        }
    }
}

polygon_soup read_vtu(std::string_view bytes, const std::string* directory)
{
    const vtu_file_reader file(bytes);
    vtu_words words;
    std::vector<vtu_piece> pieces;
    file.add_words(words);
    const bool is_joined = file.is_index() or file.size() > 1;
    if (file.is_index() and directory == nullptr)
        throw file_error("has its pieces in files of their own; read it by its path");
    if (file.is_index())
        read_sources(file.sources(), *directory, words, pieces);
    else
        file.read_pieces(is_joined, words, pieces);
    polygon_soup result = is_joined ? joined_pieces(std::move(pieces)) : std::move(pieces.front().soup);
    for (const auto& [name, own] : words.by_name)
        if (not words.used.contains(name))
            result.not_kept.push_back("the field data '" + shown(name) + "'");
    return result;
}

} // namespace

polygon_soup read_vtu(std::string_view bytes)
{
    return read_vtu(bytes, nullptr);
}

polygon_soup read_vtu(std::string_view bytes, const std::string& directory)
{
    return read_vtu(bytes, &directory);
}

extern const file_format vtu_format{.format = mesh_format::vtu,
                                    .extension = ".vtu",
                                    .index = ".pvtu",
                                    .read = read_vtu,
                                    .read_in_folder = read_vtu,
                                    .zeros = whole_numbers};

} // namespace kith::io
