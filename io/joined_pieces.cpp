// SPDX-License-Identifier: BSD-3-Clause
#include "vtu_piece.hpp"

#include <kith/io/text/text_cursor.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace kith::io {

namespace {

/// A list of joined attributes, to which the attributes of one piece after the other are appended. Where pieces have
/// different types, numbers become doubles.
class joined_attributes {
public:
    /// Appends the attributes of a piece. Precondition: the piece has elements of the kind.
    void append(std::vector<attribute>&& attributes)
    {
        ++pieces_;
        for (attribute& a : attributes) {
            const auto [place, is_new] = column_of_.try_emplace(a.name, columns_.size());
            if (is_new)
                columns_.push_back({attribute{a.name, a.type, {}, a.labels}, 0});
            auto& [joined, times] = columns_[place->second];
            if (++times != pieces_)
                continue; // an earlier piece lacks it
            const ply_number &type = joined.type, &other = a.type;
            if (type.bytes != other.bytes or type.floating != other.floating or type.is_signed != other.is_signed)
                joined.type = {8, true, true};
            if (joined.labels != a.labels)
                joined.labels.clear();
            joined.values.insert(joined.values.end(), a.values.begin(), a.values.end());
        }
    }
    /// Returns the attributes that all pieces have, and adds the names of the others to `not_kept`.
    std::vector<attribute> take(std::vector<std::string>& not_kept)
    {
        std::vector<attribute> result;
        for (auto& [joined, times] : columns_)
            if (times == pieces_)
                result.push_back(std::move(joined));
            else
                not_kept.push_back("the array '" + shown(joined.name) + "', which some pieces lack");
        return result;
    }

private:
    struct column {
        attribute joined;
        std::size_t times; ///< how many pieces have it
    };

    std::vector<column> columns_;
    std::unordered_map<std::string, std::size_t> column_of_;
    std::size_t pieces_ = 0;
};

/// The elements of all pieces in the order of their ids, each id once.
class elements_by_id {
public:
    explicit elements_by_id(const std::vector<double>& ids) : order_(ids.size()), number_(ids.size())
    {
        std::iota(order_.begin(), order_.end(), 0);
        std::ranges::stable_sort(order_, {}, [&](std::size_t element) { return ids[element]; });
        std::size_t kept = 0;
        for (const std::size_t element : order_) {
            if (kept == 0 or ids[order_[kept - 1]] != ids[element])
                order_[kept++] = element;
            number_[element] = kept - 1;
        }
        order_.resize(kept);
    }

    [[nodiscard]] std::size_t size() const { return order_.size(); }
    /// Returns the first element with the n-th id.
    [[nodiscard]] std::size_t element(std::size_t n) const { return order_[n]; }
    /// Returns n for every element with the n-th id.
    [[nodiscard]] std::size_t number(std::size_t element) const { return number_[element]; }
    void sort(std::vector<attribute>& attributes) const
    {
        for (attribute& a : attributes) {
            std::vector<double> values;
            for (const std::size_t element : order_)
                values.push_back(a.values[element]);
            a.values = std::move(values);
        }
    }

private:
    std::vector<std::size_t> order_, number_;
};

void sort_vertices(polygon_soup& soup, const std::vector<double>& ids)
{
    const elements_by_id by_id(ids);
    std::vector<std::array<double, 3>> points;
    for (std::size_t n = 0; n < by_id.size(); ++n)
        points.push_back(soup.points[by_id.element(n)]);
    for (std::size_t v = 0; v < ids.size(); ++v)
        if (soup.points[v] != points[by_id.number(v)])
            throw file_error("the pieces have the vertex with the id " + std::to_string(std::size_t(ids[v])) +
                             " at several places; give different vertices different GlobalPointIds");
    for (std::size_t& v : soup.faces.vertices)
        v = by_id.number(v);
    soup.points = std::move(points);
    by_id.sort(soup.attributes.vertices);
}

void sort_faces(polygon_soup& soup, const std::vector<double>& ids)
{
    const elements_by_id by_id(ids);
    face_list faces;
    for (std::size_t n = 0; n < by_id.size(); ++n)
        faces.push_back(soup.faces[by_id.element(n)]);
    for (std::size_t f = 0; f < ids.size(); ++f)
        if (not std::ranges::equal(soup.faces[f], faces[by_id.number(f)]))
            throw file_error("the pieces have two cells with the id " + std::to_string(std::size_t(ids[f])) +
                             "; give different cells different GlobalCellIds");
    soup.faces = std::move(faces);
    by_id.sort(soup.attributes.faces);
}

/// Removes the faces that, as the piece says, belong to another piece.
void leave_out_ghosts(vtu_piece& piece)
{
    if (piece.is_ghost.empty())
        return;
    const auto keep = [&](auto& values) {
        std::size_t kept = 0;
        for (std::size_t f = 0; f < piece.is_ghost.size(); ++f)
            if (not piece.is_ghost[f])
                values[kept++] = values[f];
        values.resize(kept);
    };
    face_list faces;
    for (std::size_t f = 0; f < piece.is_ghost.size(); ++f)
        if (not piece.is_ghost[f])
            faces.push_back(piece.soup.faces[f]);
    for (attribute& a : piece.soup.attributes.faces)
        keep(a.values);
    if (not piece.cell_ids.empty())
        keep(piece.cell_ids);
    piece.soup.faces = std::move(faces);
}

} // namespace

polygon_soup joined_pieces(std::vector<vtu_piece> pieces)
{
    polygon_soup result;
    joined_attributes of_vertices, of_faces;
    std::vector<double> point_ids, cell_ids;
    std::unordered_set<std::string> told; // names of what is not kept
    for (vtu_piece& piece : pieces) {
        leave_out_ghosts(piece);
        polygon_soup& soup = piece.soup;
        const std::size_t first = result.points.size();
        result.points.insert(result.points.end(), soup.points.begin(), soup.points.end());
        for (std::size_t& v : soup.faces.vertices)
            v += first;
        for (std::size_t f = 0; f < soup.faces.size(); ++f)
            result.faces.push_back(soup.faces[f]);
        if (not soup.points.empty())
            of_vertices.append(std::move(soup.attributes.vertices));
        if (soup.faces.size() != 0)
            of_faces.append(std::move(soup.attributes.faces));
        point_ids.insert(point_ids.end(), piece.point_ids.begin(), piece.point_ids.end());
        cell_ids.insert(cell_ids.end(), piece.cell_ids.begin(), piece.cell_ids.end());
        for (const std::string& what : soup.not_kept)
            if (told.insert(what).second)
                result.not_kept.push_back(what);
        piece = {};
    }
    result.attributes.vertices = of_vertices.take(result.not_kept);
    result.attributes.faces = of_faces.take(result.not_kept);
    if (point_ids.size() == result.points.size())
        sort_vertices(result, point_ids);
    else
        result.notes.emplace_back("not all vertices of its pieces have GlobalPointIds; vertices of different pieces "
                                  "are not joined, even if they coincide");
    if (cell_ids.size() == result.faces.size())
        sort_faces(result, cell_ids);
    return result;
}

} // namespace kith::io
