// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part_recorder.hpp"
#include "template_assembler.hpp"

#include <kith/core/level/native_level.hpp>
#include <kith/engine/neighbourhood/face_walk.hpp>
#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The elements of a list that each model owns, model by model, as indices in the list.
class owned_elements {
public:
    template <std::unsigned_integral Index>
    owned_elements(const storage<affine_number<Index>>& numbers, const sources_of_part<Index>& sources,
                   std::size_t models)
        : begin_(models + 1, 0)
    {
        std::vector<std::uint32_t> owners(numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            owners[i] = sources.owner(numbers[i].source);
            if (owners[i] != sources.no_model)
                ++begin_[owners[i] + 1];
        }
        for (std::size_t m = 0; m < models; ++m)
            begin_[m + 1] += begin_[m];
        places_.resize(begin_[models]);
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (owners[i] != sources.no_model)
                places_[next[owners[i]]++] = std::uint32_t(i);
    }

    [[nodiscard]] std::span<std::uint32_t> of(std::size_t model)
    {
        return std::span(places_).subspan(begin_[model], begin_[model + 1] - begin_[model]);
    }

private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> places_;
};

/// A maker of templates for the faces of one level, for points or values in their place.
template <class Point, std::unsigned_integral Index>
class template_maker {
    using scalar = scalar_of<Point>;
    using value = recorded<scalar>;

public:
    /// Takes the level with which a plan begins. The level has its edges and, if refined faces have one degree, that
    /// degree. `rings` are those of the plan. The mesh and the recorder must outlive this. Cost: O(elements).
    template_maker(const basic_mesh<Point, Index>& mesh, const part_recorder<scalar_of<Point>, Index>& recorder,
                   int rings)
        : mesh_(mesh)
        , recorder_(recorder)
        , cutter_(mesh)
        , walk_(mesh.topology(), rings)
        , marks_(recorder.marks_on(mesh.topology()))
    {
    }

    /// Makes the templates of some faces, the models. They are refined together, since their neighbourhoods often
    /// overlap. Calls take(i, key, template) for the i-th model, with the key of its walk and of the state there.
    /// Models for which template_assembler returns nothing are skipped.
    template <class Take>
    void make(std::span<const Index> models, const Take& take)
    {
        // Neighbourhoods of one ring have little in common, and a tape of few of them stays in the caches.
        const std::size_t most_at_once = recorder_.rings() == 1 ? 8 : 64;
        constexpr std::size_t most_faces = 4096; // around the models: their tape has some megabytes
        std::size_t count = 0;
        for (std::size_t first = 0; first < models.size(); first += count) {
            count = std::min(most_at_once, models.size() - first);
            std::vector<Index> faces = faces_around(models.subspan(first, count));
            while (faces.size() > most_faces and count > 1) {
                count /= 2;
                faces = faces_around(models.subspan(first, count));
            }
            make_together(
                models.subspan(first, count), faces, [&](std::size_t i, const std::u16string& key, auto&& one) {
                    take(first + i, key, std::move(one));
                });
        }
    }

private:
    [[nodiscard]] std::vector<Index> faces_around(std::span<const Index> models)
    {
        std::vector<Index> seeds(models.begin(), models.end());
        std::ranges::sort(seeds);
        return cutter_.faces_around(seeds, recorder_.rings());
    }
    template <class Take>
    void make_together(std::span<const Index> models, std::span<const Index> faces_around_them, const Take& take)
    {
        const auto part = cutter_.cut(faces_around_them);
        sources_of_part<Index> sources(
            part.mesh.topology(), recorder_.degree(), part.face_from, part.edge_is_turned, models);
        storage<value> points(part.mesh.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = value(std::uint32_t(v));
        tape_.restart(points.size());
        const recording<scalar> here(tape_);
        const auto [fine, numbers] = recorder_.record(
            basic_mesh<value, Index>(std::move(points), part.mesh.topology(), mesh_.generation()),
            part.numbers(),
            sources);

        owned_elements vertices(numbers.vertices, sources, models.size());
        owned_elements faces(numbers.faces, sources, models.size());
        for (std::size_t i = 0; i < models.size(); ++i) {
            walk_.around(models[i]);
            sources.walked(walk_.faces());
            if (auto one = assembler_.assemble(walk_, vertices.of(i), faces.of(i), sources, numbers, fine, tape_))
                take(i, marks_.key(walk_), std::move(*one));
        }
    }

    const basic_mesh<Point, Index>& mesh_;
    const part_recorder<scalar, Index>& recorder_;
    submesh_cutter<Point, Index> cutter_;
    face_walk<Index> walk_;
    state_marks<Index> marks_;
    tape<scalar> tape_; // reused for one group of models after the other
    template_assembler<scalar, Index> assembler_;
};

} // namespace kith
