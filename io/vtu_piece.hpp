// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtu_numbers.hpp"

#include <kith/polygon_soup.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace kith::io {

/// The words in the field data of a file, by the name of the array whose numbers stand for them.
struct vtu_words {
    std::map<std::string, std::vector<std::string>> by_name;
    std::set<std::string> used; ///< by arrays of cells
};

/// A piece as its file declares it.
struct vtu_declaration {
    bool is_poly_data = false; ///< of the type PolyData, not UnstructuredGrid
    xml_tag piece;
    std::map<std::string, std::vector<xml_tag>> arrays; ///< by the section they stand in
    std::map<std::string, xml_tag> sections;
};

/// The content of a piece. Vertices are numbered within the piece.
struct vtu_piece {
    polygon_soup soup;
    std::vector<double> point_ids, cell_ids; ///< GlobalIds of vertices and of faces; empty if the piece has none
    std::vector<bool> is_ghost;              ///< of faces: true if another piece owns it; empty if there is none
};

/// Reads the points, the faces and the attributes of a piece. If `is_joined`, ids and ghosts are not attributes.
/// Errors: file_error.
vtu_piece read_piece(const vtu_declaration& declared, const vtu_numbers& numbers, vtu_words& words, bool is_joined);

/// Joins the pieces of a mesh. Vertices and faces with the same id become one, and are numbered by their ids; vertices
/// without ids stay apart. Attributes that some pieces lack are left out. Errors: file_error for ids that are not whole
/// numbers, and for vertices of one id at several places. Cost: O(n log n).
polygon_soup joined_pieces(std::vector<vtu_piece> pieces);

} // namespace kith::io
