// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part_recorder.hpp"
#include "patch_filler.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kith {

#ifdef KITH_HAS_LANES

/// The patches of the faces that have no template. Some faces at a time are cut out with their rings and refined as a
/// mesh of their own, level by level. The operations of the scheme on their values are recorded, and played once.
template <class Point, std::unsigned_integral Index>
class face_clusters {
    using scalar = scalar_of<Point>;
    using value = recorded<scalar>;

public:
    using output = patch_output<Point, Index>;

    /// Takes the recorder of a level, and faces of that level in increasing order.
    face_clusters(std::shared_ptr<const part_recorder<scalar, Index>> recorder, std::vector<Index> faces)
        : recorder_(std::move(recorder)), faces_(std::move(faces))
    {
    }

    /// Writes the patches of these faces of the mesh, on several threads if that is worth it. Cost: that of the steps.
    void fill(const basic_mesh<Point, Index>& mesh, const output& to, bool parallel) const
    {
        detail::for_shared_parts(faces_.size(), at_once, parallel, [&](detail::parts_to_do parts) {
            worker one(*this, mesh);
            parts.for_each([&](std::size_t begin, std::size_t end) {
                one.fill(std::span(faces_).subspan(begin, end - begin), to);
            });
        });
    }

private:
    using numbers_in_whole = part_of_whole<owned_number<Index>>;
    // Faces with successive numbers. In a well-ordered mesh they lie closer together than in the order of the surface.
    static constexpr std::size_t at_once = 64;

    /// The working memory of a thread.
    class worker {
    public:
        worker(const face_clusters& clusters, const basic_mesh<Point, Index>& mesh)
            : recorder_(*clusters.recorder_), mesh_(mesh), cutter_(mesh), is_one_(mesh.face_count(), false)
        {
        }

        void fill(std::span<const Index> faces, const output& to)
        {
            auto part = cutter_.cut(cutter_.faces_around(faces, recorder_.rings()));
            auto numbers = numbers_of(part, faces, to.coarse_numbers);
            storage<value> values(part.mesh.vertex_count());
            for (std::size_t v = 0; v < values.size(); ++v)
                values[v] = value(std::uint32_t(v));
            tape_.restart(values.size());
            const recording<scalar> here(tape_);
            const auto made = recorder_.record(
                basic_mesh<value, Index>(std::move(values), part.mesh.topology(), mesh_.generation()),
                part.numbers(),
                std::move(numbers));
            player_.play(tape_, part.mesh.points());
            copy_owned(made, to);
        }

    private:
        /// Returns the numbers of a part's elements in the whole mesh. `given` are numbers of the coarse elements that
        /// replace those of the mesh, or nothing.
        [[nodiscard]] numbers_in_whole numbers_of(const submesh<Point, Index>& part, std::span<const Index> faces,
                                                  const element_numbers<Index>* given)
        {
            const connectivity<Index>& whole = mesh_.topology();
            for (const Index f : faces)
                is_one_[f] = true;
            const auto owned = [&](tuple_kind kind, std::span<const Index> from, const auto& is_owned) {
                storage<owned_number<Index>> result(from.size());
                for (std::size_t i = 0; i < from.size(); ++i)
                    result[i] = {given == nullptr ? from[i] : given->of(kind)[from[i]], is_owned(from[i])};
                return result;
            };
            const std::size_t degree = recorder_.degree();
            numbers_in_whole numbers{
                owned(tuple_kind::v,
                      part.vertex_from,
                      [&](Index v) { return is_one_[whole.face_of(whole.vertex_corner[v])]; }),
                owned(tuple_kind::e,
                      part.edge_from,
                      [&](Index e) { return is_one_[whole.face_of(whole.halfedge_corner[2 * std::size_t(e)])]; }),
                owned(tuple_kind::f, part.face_from, [&](Index f) { return is_one_[f]; }),
                {},
                degree};
            if (degree == 0) {
                numbers.first_corners = storage<owned_number<Index>>(part.face_from.size());
                for (std::size_t f = 0; f < part.face_from.size(); ++f)
                    numbers.first_corners[f] = {whole.first_corner(part.face_from[f]), is_one_[part.face_from[f]]};
            }
            for (const Index f : faces)
                is_one_[f] = false;
            return numbers;
        }

        void copy_owned(const typename part_recorder<scalar, Index>::owned_part& part, const output& to) const
        {
            const connectivity<Index>& fine = part.mesh.topology();
            const numbers_in_whole& numbers = part.numbers;
            const auto corner_in_whole = [&](Index c) {
                const Index face = fine.face_of(c);
                return numbers.corner(face, c - fine.first_corner(face)).number;
            };
            const auto halfedge_in_whole = [&](Index h) { return Index(2 * numbers.edges[h / 2].number + h % 2); };
            for (std::size_t v = 0; v < numbers.vertices.size(); ++v)
                if (const auto [number, owned] = numbers.vertices[v]; owned) {
                    to.points[number] = player_.value(part.mesh.point(v).value);
                    if (to.has_edges())
                        to.vertex_corner[number] = corner_in_whole(fine.vertex_corner[v]);
                    if (to.writer != nullptr)
                        to.writer->set_start(number, halfedge_in_whole(fine.corner_halfedge[fine.vertex_corner[v]]));
                }
            std::vector<face_line<Index>> lines;
            for (std::size_t f = 0; to.writer != nullptr and f < fine.faces; ++f) {
                if (not numbers.faces[f].owned)
                    continue;
                lines.clear();
                for (Index c = fine.first_corner(f); c < fine.first_corner(f + 1); ++c)
                    lines.push_back(
                        {numbers.vertices[fine.corner_vertex[c]].number, halfedge_in_whole(fine.corner_halfedge[c])});
                to.writer->set_face(numbers.faces[f].number, lines);
            }
            for (std::size_t c = 0; to.has_faces() and c < fine.corners(); ++c) {
                if (not numbers.faces[fine.face_of(Index(c))].owned)
                    continue;
                const Index corner = corner_in_whole(Index(c));
                to.corner_vertex[corner] = numbers.vertices[fine.corner_vertex[c]].number;
                if (not to.has_edges())
                    continue;
                const Index side = fine.corner_halfedge[c];
                const Index halfedge = halfedge_in_whole(side);
                to.corner_halfedge[corner] = halfedge;
                to.halfedge_corner[halfedge] = corner;
                if (fine.is_boundary(side / 2))
                    to.halfedge_corner[halfedge ^ 1] = fine.none;
            }
        }

        const part_recorder<scalar, Index>& recorder_;
        const basic_mesh<Point, Index>& mesh_;
        submesh_cutter<Point, Index> cutter_;
        std::vector<bool> is_one_;
        tape<scalar> tape_; // reused for one part after the other
        tape_player<Point> player_;
    };

    std::shared_ptr<const part_recorder<scalar, Index>> recorder_;
    std::vector<Index> faces_;
};

#endif

} // namespace kith
