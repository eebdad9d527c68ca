// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/neighbourhood/scheme_forecast.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/ranks/deal_tiles.hpp>
#include <kith/mpi/ranks/field_exchange.hpp>
#include <kith/mpi/ranks/grow_ghosts.hpp>
#include <kith/mpi/ranks/require_tiles.hpp>
#include <kith/mpi/ranks/runs_of_ranks.hpp>
#include <kith/refine.hpp>
#include <kith/tiles/number/corners_at_vertices.hpp>
#include <kith/tiles/number/global_lineage.hpp>
#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/part/require_control.hpp>
#include <kith/tiles/part/scheme_members.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/pack.hpp>
#include <kith/tiles/refine/tile_step.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// A control mesh that lies on rank 0 or in tiles on all ranks and is refined on all ranks level by level. It serves
/// schemes whose reach over many levels is not known: after each step the tiles fetch the ghosts that the next step
/// needs. The caller gives one number: the rings of faces around a tile that a step needs so that one ring around its
/// children is correct, too. Bits and numbers are those of `refine`. All tiles of a rank are in memory.
///
/// The scheme declares its edges and takes meshes with a boundary. Its state, such as creases, can be joined
/// (level_state).
template <class Point, std::unsigned_integral Index, scheme Scheme>
class exchanging_refinement {
    static_assert(numbering_of<Scheme, Index>::has_edges,
                  "the edges of a tile need numbers in the whole mesh; let the scheme's columns declare new_edges");
    static_assert(not needs_closed<Scheme>, "a tile has a boundary, so a scheme for closed meshes cannot refine it");

public:
    using tile_type = tile<Point, Index>;
    using numbering_type = global_numbering<columns_type<Scheme>>;
    using kept_type = kept_tile<tile_type, Scheme>;

    /// Cuts tiles out of a mesh on rank 0. `mesh`, `parts` and the state (creases) of the scheme are read on rank 0
    /// only. The options of the scheme and `rings_per_step` > 0 are the same on all ranks. Collective. Errors:
    /// phase_error for everything that `refine` refuses, for a mesh of face-vertex lists only and for a partition of
    /// another mesh.
    exchanging_refinement(communicator& comm, const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                          const partition& parts, int rings_per_step)
        : exchanging_refinement(comm, scheme, rings_per_step)
    {
        std::optional<tile_cutter<Point, Index, Scheme>> cutter;
        auto setting = collective_phase(comm, [&] {
            packer out;
            if (not comm.is_root())
                return out.take();
            kith::detail::require_control(mesh, scheme_, 0);
            cutter.emplace(mesh, scheme_, parts.part_of, parts.parts);
            runs_ = cutter->runs();
            return out.add(cutter->counts()).add(std::uint64_t(parts.parts)).add(mesh.generation()).take();
        });
        setting = comm.broadcast(std::move(setting));
        std::uint64_t all = 0;
        collective_phase(comm, [&] {
            unpacker in(setting);
            counts_.push_back(in.get<global_counts>());
            all = in.get<std::uint64_t>();
            generation_ = in.get<int>();
        });
        const auto packed = deal_tiles(comm, all, [&](std::uint64_t t) { return pack(cutter->cut(t, rings_)); });
        collective_phase(comm, [&] {
            for (std::size_t i = 0; i < packed.size(); ++i) {
                auto job = unpack<Point, Index>(packed[i], scheme_);
                tiles_.push_back({std::uint64_t(comm.rank()) + i * std::uint64_t(comm.size()), std::move(job.part)});
                schemes_.push_back(std::move(job.scheme));
            }
            kith::detail::restrict_state(scheme_, scheme_, part_numbers<Index>());
        });
    }

    /// Takes tiles of level 0, all of one generation, such as those of read_tiles. Each has at least one ring of
    /// ghosts; if it has fewer than `rings_per_step` rings, the missing ones are fetched from the owners. The state of
    /// the scheme (creases) is that of the whole mesh, in its numbers, as far as the tiles of this rank reach.
    /// Collective. Errors: phase_error for a mesh that the scheme cannot take, and for a tile without a complete ring.
    exchanging_refinement(communicator& comm, std::vector<numbered_tile<tile_type>> tiles, const global_counts& counts,
                          const Scheme& scheme, int rings_per_step)
        : exchanging_refinement(comm, scheme, rings_per_step)
    {
        static_assert(not marks_edges<Scheme>, "marked edges can be counted only on a whole mesh; cut it on one rank");
        tiles_ = std::move(tiles);
        collective_phase(comm, [&] {
            counts_.push_back(counts);
            require_tiles(tiles_, scheme_);
            for (const auto& [number, part] : tiles_) {
                schemes_.push_back(kith::detail::scheme_of_tile(scheme_, part));
                runs_.append(control_runs_of<Scheme>(part));
            }
            kith::detail::restrict_state(scheme_, scheme_, part_numbers<Index>());
        });
        generation_ = generation_of_tiles(comm, tiles_);
        grow_ghosts(comm, std::span(tiles_), std::span(schemes_), rings_);
    }

    /// Returns the number of the level that the tiles are on. Local.
    [[nodiscard]] int level() const { return level_; }
    /// Returns the counts of the whole mesh on this level. Local.
    [[nodiscard]] const global_counts& counts() const { return counts_.back(); }
    /// Returns the numbering of this level; its `origin` leads to the level before. Local. Precondition: level() > 0.
    [[nodiscard]] const numbering_type& numbering() const { return steps_.back(); }
    /// Returns the tiles of this rank on this level, with their edges and one ring of ghosts (on level 0 more). Local.
    [[nodiscard]] std::span<const numbered_tile<tile_type>> tiles() const { return tiles_; }
    /// Returns the scheme of each of these tiles, with its state (fields, creases) of this level. Local.
    [[nodiscard]] std::span<const Scheme> schemes() const { return schemes_; }
    /// Moves tiles and schemes out of a refinement that is no longer needed: std::move(refinement).take_tiles(). Local.
    [[nodiscard]] std::vector<kept_type> take_tiles() &&
    {
        std::vector<kept_type> result;
        for (std::size_t t = 0; t < tiles_.size(); ++t)
            result.push_back({tiles_[t].number, level_, std::move(tiles_[t].part), std::move(schemes_[t])});
        return result;
    }

    /// Returns the ancestors and descendants over all levels so far, in the numbers of the whole mesh. The result is
    /// the same on all ranks; all use of it is local, wherever the tiles are moved. Collective. Errors: mpi::error.
    /// Cost: that of runs_of_ranks (a mesh of one face degree has one run), and O(boundary) memory.
    [[nodiscard]] global_lineage<columns_type<Scheme>> lineage()
    {
        const auto runs = runs_of_ranks(comm_, runs_);
        return collective_phase(
            comm_, [&] { return global_lineage<columns_type<Scheme>>(counts_, steps_, corners_, runs.joined()); });
    }

    /// Makes one step. Collective. Errors: phase_error as `refine`, and when tiles disagree about an element that two
    /// of them have. They disagree when `rings_per_step` is too small; the levels are then unusable. Not every such
    /// mistake is found.
    /// Cost: that of the step and, in messages, of grow_ghosts (not on level 0); of sending the facts at the boundary
    /// to all ranks; and of a field_exchange that compares.
    void refine()
    {
        refine([](const kept_type&) {});
    }
    /// Makes one step and hands over the tiles of the level before it, each with its scheme (creases, fields) on that
    /// level: keep(kept_tile), which may move it away. The tiles have the ghosts that the step needed. Collective.
    template <std::invocable<kept_type> Keep>
    void refine(const Keep& keep)
    {
        if (level_ > 0)
            grow_ghosts(comm_, std::span(tiles_), std::span(schemes_), rings_);
        number();
        collective_phase(comm_, [&] {
            for (std::size_t t = 0; t < tiles_.size(); ++t) {
                Scheme made_scheme = schemes_[t], next_scheme = schemes_[t];
                auto next = kith::detail::refined_tile(tiles_[t].part, made_scheme, steps_.back())
                                .trim(1, [&](const auto& part) {
                                    kith::detail::restrict_state(next_scheme, made_scheme, part);
                                });
                swap_states(schemes_[t], next_scheme);
                keep(kept_type{
                    tiles_[t].number, level_, std::exchange(tiles_[t].part, std::move(next)), std::move(next_scheme)});
            }
            kith::detail::advance_without_elements<decltype(tile_type::mesh)>(scheme_, generation_);
        });
        ++level_;
        ++generation_;
        collective_phase(comm_, [&] {
            counts_.push_back(steps_.back().counts());
            corners_.emplace_back();
        });
        if constexpr (numbers_corners_at_vertices<Scheme>) {
            std::vector<corners_at_vertices::boundary_vertex> boundary;
            collective_phase(comm_, [&] {
                for (const auto& [number, part] : tiles_) {
                    const auto more = corners_at_vertices::owned_at_boundary(part);
                    boundary.insert(boundary.end(), more.begin(), more.end());
                }
            });
            boundary = all_of_ranks(comm_, boundary);
            collective_phase(comm_, [&] {
                corners_.back() = corners_at_vertices(std::move(boundary));
                for (auto& [number, part] : tiles_)
                    corners_.back().number(part);
            });
        }
        require_agreement();
    }

private:
    exchanging_refinement(communicator& comm, const Scheme& scheme, int rings_per_step)
        : comm_(comm), scheme_(scheme), rings_(rings_per_step)
    {
        kith::detail::require_named_state<Scheme>();
        require_same_refinement(comm, scheme_, 0, rings_);
        collective_phase(comm, [&] {
            if (rings_ < 1)
                throw mesh_error(std::string(scheme_name<Scheme>()) + ": " + std::to_string(rings_) +
                                 " rings per step; a step needs 1 or more");
        });
    }
    /// Numbers the elements of the next step. The messages to all ranks stand between the phases, so that no rank waits
    /// for one whose phase has failed.
    void number()
    {
        std::array<std::vector<boundary_fact>, 3> facts;
        collective_phase(comm_, [&] {
            for (std::size_t t = 0; t < tiles_.size(); ++t) {
                const auto more = numbering_type::facts_at_boundary(columns_of(schemes_[t], generation_),
                                                                    tiles_[t].part);
                for (std::size_t i = 0; i < facts.size(); ++i)
                    facts[i].insert(facts[i].end(), more[i].begin(), more[i].end());
            }
        });
        for (auto& list : facts)
            list = all_of_ranks(comm_, list);
        collective_phase(comm_,
                         [&] { steps_.emplace_back(counts(), columns_of(scheme_, generation_), std::move(facts)); });
    }

    void require_agreement()
    {
        const auto refuse = [&](const std::string& problem) {
            throw mesh_error("level " + std::to_string(level_) + ": " + problem + "; " + std::to_string(rings_) +
                             " rings per step are too few for " + std::string(scheme_name<Scheme>()) +
                             ", ask for more");
        };
        std::array<std::uint64_t, 3> owned{};
        for (const auto& [number, part] : tiles_)
            for (const auto kind : {element_kind::vertex, element_kind::edge, element_kind::face})
                owned[std::size_t(kind)] += owned_count(marks_of(part, kind));
        owned = comm_.sum(owned);
        collective_phase(comm_, [&] {
            if (owned != std::array{counts().vertices, counts().edges, counts().faces})
                refuse("not every element is owned by exactly one tile");
        });
        field_exchange exchange(comm_, tiles(), element_kind::vertex);
        auto points = collective_phase(comm_, [&] {
            std::vector<std::vector<Point>> result;
            for (const auto& [number, part] : tiles_)
                result.emplace_back(part.mesh.points().begin(), part.mesh.points().end());
            return result;
        });
        exchange.exchange(points);
        collective_phase(comm_, [&] {
            for (std::size_t t = 0; t < tiles_.size(); ++t)
                for (std::size_t v = 0; v < points[t].size(); ++v)
                    if (std::memcmp(&points[t][v], &tiles_[t].part.mesh.point(v), sizeof(Point)) != 0)
                        refuse("tile " + std::to_string(tiles_[t].number) + " has other coordinates for vertex " +
                               std::to_string(tiles_[t].part.vertex_ids[v]) + " than its owner");
        });
    }

    communicator& comm_;
    Scheme scheme_; // without elements
    int rings_;
    int level_ = 0, generation_ = 0;
    control_runs runs_;                 // the runs of the control mesh that this rank knows
    std::vector<global_counts> counts_; // per level
    std::vector<numbering_type> steps_; // to the next one
    std::vector<corners_at_vertices> corners_ = std::vector<corners_at_vertices>(1); // per level
    std::vector<numbered_tile<tile_type>> tiles_;
    std::vector<Scheme> schemes_; // of the tiles
};

} // namespace kith::mpi
