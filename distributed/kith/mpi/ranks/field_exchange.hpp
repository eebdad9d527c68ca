// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::mpi {

/// An exchange of values that users keep at the elements of a level's tiles: the owner of an element sends its value to
/// all tiles that have the element as a ghost. These pairs are found once per level and kind of element. Then any
/// number of fields of any trivially copyable type are exchanged between them. A field is an array per tile of this
/// rank, with a value per element.
class field_exchange {
public:
    /// Finds the owners of all ghosts. `tiles` are the tiles of one level that lie on this rank, none or several; each
    /// has its edges (connect::everything). Collective. Errors: phase_error if no tile owns an element that a tile has,
    /// which means that tiles are missing.
    /// Cost: at most four messages to each rank; O(tiles) work; messages and memory for the elements near the cuts.
    template <tile_like Tile>
    field_exchange(communicator& comm, std::span<const numbered_tile<Tile>> tiles, element_kind kind) : comm_(comm)
    {
        const auto ranks = std::size_t(comm.size());
        double rings = collective_phase(comm, [&] {
            double most = 0;
            for (const auto& tile : tiles)
                most = std::max(most, double(rings_of_ghosts(tile.part)));
            return most;
        });
        rings = comm.maximum(std::array{rings})[0];
        std::vector<std::vector<offer>> offers;
        std::vector<std::vector<global_id>> questions;
        std::vector<std::vector<slot>> asking;
        collective_phase(comm, [&] {
            offers.resize(ranks), questions.resize(ranks), asking.resize(ranks);
            for (std::size_t t = 0; t < tiles.size(); ++t) {
                const auto& part = tiles[t].part;
                const auto ids = ids_of(part, kind);
                const auto marks = marks_of(part, kind);
                sizes_.emplace_back(tiles[t].number, ids.size());
                const auto is_seen = seen_by_others(part, kind, int(rings));
                for (std::size_t x = 0; x < ids.size(); ++x) {
                    const std::size_t directory = ids[x] % ranks;
                    if ((marks[x] & owned_mark) == 0) {
                        questions[directory].push_back(ids[x]);
                        asking[directory].push_back({t, x});
                    } else if (is_seen[x] != 0) {
                        offers[directory].push_back({ids[x], {t, x}});
                    }
                }
            }
        });
        const auto owners = find_owners(std::move(offers), std::move(questions));
        send_ = all_to_all(comm, [&] {
            std::vector<std::vector<request>> wanted(ranks);
            receive_.resize(ranks);
            for (std::size_t directory = 0; directory < ranks; ++directory)
                for (std::size_t i = 0; i < owners[directory].size(); ++i) {
                    const auto& [rank, there] = owners[directory][i];
                    const slot here = asking[directory][i];
                    if (rank == no_rank)
                        throw mesh_error("tile " + std::to_string(tiles[here.tile].number) +
                                         " has a ghost without an owner; give all tiles of the level, each once");
                    wanted[rank].push_back({there, tiles[here.tile].number, here.element});
                    receive_[rank].push_back(here);
                }
            return wanted;
        });
        collective_phase(comm, [&] { put_sums_in_order(); });
    }

    /// Starts an exchange, which goes on until `finish` while this rank computes. Collective.
    /// Errors: phase_error for fields of other sizes than the tiles, and for lack of memory.
    template <class Fields>
    [[nodiscard]] pending_exchange begin(const Fields& fields)
    {
        return start<value_of<Fields>>(fields, send_, receive_, [&](const request& r) { return at(fields, r.where); });
    }
    /// Waits for the exchange that `begin` started and stores the values at the ghosts of fields of the same type.
    /// Collective. Errors: phase_error for fields of other sizes than the tiles.
    template <class Fields>
    void finish(pending_exchange& started, Fields& fields)
    {
        const auto coming = started.finish();
        collective_phase(comm_, [&] {
            require_sizes(fields);
            for (std::size_t rank = 0; rank < coming.size(); ++rank)
                for (std::size_t i = 0; i < receive_[rank].size(); ++i)
                    at(fields, receive_[rank][i]) = value<value_of<Fields>>(coming[rank], i);
        });
    }
    /// Gives ghosts the values of their owners. Collective. Errors: as begin.
    template <class Fields>
    void exchange(Fields& fields)
    {
        auto started = begin(fields);
        finish(started, fields);
    }

    /// Adds the values of ghosts to that of their owner, by `add(owner's, ghost's)`, in the order of the tiles'
    /// numbers. The bits then do not depend on the ranks, but on the tiles, as sums of floats must. Collective.
    /// Errors: as begin, and phase_error for an exception of `add`.
    template <class Fields, class Add>
    void sum_to_owners(Fields& fields, const Add& add)
    {
        using value_type = value_of<Fields>;
        const auto value_at = [&](slot where) { return at(fields, where); };
        const auto coming = start<value_type>(fields, receive_, send_, value_at).finish();
        collective_phase(comm_, [&] {
            for (const auto& [rank, i] : sums_) {
                auto& sum = at(fields, send_[rank][i].where);
                sum = add(sum, value<value_type>(coming[rank], i));
            }
        });
    }

    /// Returns the number of values that this rank sends or receives in an exchange, including those to itself. Local.
    [[nodiscard]] std::size_t sent_values() const { return count(send_); }
    [[nodiscard]] std::size_t received_values() const { return count(receive_); }

private:
    struct slot {
        std::uint64_t tile, element; // both as indices on a rank
    };
    struct offer {
        global_id id;
        slot where;
    };
    struct owner {
        std::uint64_t rank;
        slot where;
    };
    struct request {
        slot where;                         // on the owner's rank
        std::uint64_t asking_tile, element; // of the ghost: the number of its tile, and its index there
    };
    static constexpr std::uint64_t no_rank = ~std::uint64_t(0);

    template <class Fields>
    using value_of = std::remove_cvref_t<decltype(std::declval<Fields&>()[0][0])>;

    template <class Fields>
    static decltype(auto) at(Fields& fields, slot where)
    {
        return (fields[where.tile][where.element]);
    }
    template <class T>
    static T value(const std::vector<std::byte>& bytes, std::size_t i)
    {
        T result;
        std::memcpy(&result, bytes.data() + i * sizeof(T), sizeof(T));
        return result;
    }
    template <class Lists>
    static std::size_t count(const Lists& lists)
    {
        std::size_t sum = 0;
        for (const auto& list : lists)
            sum += list.size();
        return sum;
    }

    /// Marks the elements that a tile with `rings` rings of ghosts may share: those of faces within rings + 1 rings of
    /// a cut.
    template <tile_like Tile>
    static std::vector<unsigned char> seen_by_others(const Tile& part, element_kind kind, int rings)
    {
        using index = typename Tile::index_type;
        const auto& mesh = part.mesh;
        std::vector<unsigned char> result(ids_of(part, kind).size(), 0);
        for (const index f : submesh_cutter(mesh).faces_around(faces_at_cuts(part), rings + 1))
            for (std::size_t c = mesh.topology().first_corner(f); c < mesh.topology().first_corner(f + 1); ++c)
                result[kind == element_kind::vertex ? mesh.topology().corner_vertex[c]
                       : kind == element_kind::edge ? mesh.topology().corner_halfedge[c] / 2
                                                    : f] = 1;
        return result;
    }

    /// Finds the owners of the asked elements. Element i is looked up on rank i modulo ranks, so that no rank has to
    /// know all owners.
    std::vector<std::vector<owner>> find_owners(std::vector<std::vector<offer>> offers,
                                                std::vector<std::vector<global_id>> questions)
    {
        const auto offered = all_to_all(comm_, std::move(offers));
        const auto known = collective_phase(comm_, [&] {
            std::vector<std::pair<global_id, owner>> result;
            for (std::size_t rank = 0; rank < offered.size(); ++rank)
                for (const offer& o : offered[rank])
                    result.push_back({o.id, {rank, o.where}});
            std::ranges::sort(result, {}, &std::pair<global_id, owner>::first);
            return result;
        });
        const auto asked = all_to_all(comm_, std::move(questions));
        return all_to_all(comm_, [&] {
            std::vector<std::vector<owner>> answers(asked.size());
            for (std::size_t rank = 0; rank < asked.size(); ++rank)
                for (const global_id id : asked[rank]) {
                    const auto found = std::ranges::lower_bound(known, id, {}, &std::pair<global_id, owner>::first);
                    answers[rank].push_back(found != known.end() and found->first == id ? found->second
                                                                                        : owner{no_rank, {}});
                }
            return answers;
        });
    }

    /// Throws mesh_error unless `fields` has a value for each element of each tile. Types without sizes are not
    /// checked.
    template <class Fields>
    void require_sizes(const Fields& fields) const
    {
        if constexpr (requires { std::size(fields), std::size(fields[0]); }) {
            if (std::size(fields) != sizes_.size())
                throw mesh_error("the values of " + std::to_string(std::size(fields)) +
                                 " tiles were given; this rank has " + std::to_string(sizes_.size()));
            for (std::size_t t = 0; t < sizes_.size(); ++t)
                if (std::size(fields[t]) != sizes_[t].second)
                    throw mesh_error("tile " + std::to_string(sizes_[t].first) + " was given " +
                                     std::to_string(std::size(fields[t])) + " values; it has " +
                                     std::to_string(sizes_[t].second) + " elements of this kind, ghosts included");
        }
    }
    template <class T, class Fields, class To, class From, class Value>
    pending_exchange start(const Fields& fields, const To& to, const From& from, const Value& value_at)
    {
        static_assert(std::is_trivially_copyable_v<T>, "values that are plain bytes can be sent, others not");
        auto result = collective_phase(comm_, [&] {
            require_sizes(fields);
            std::vector<std::vector<std::byte>> bytes(to.size());
            std::vector<std::uint64_t> sizes(to.size());
            for (std::size_t rank = 0; rank < to.size(); ++rank) {
                bytes[rank].resize(to[rank].size() * sizeof(T));
                sizes[rank] = from[rank].size() * sizeof(T);
                for (std::size_t i = 0; i < to[rank].size(); ++i) {
                    const T x = value_at(to[rank][i]);
                    std::memcpy(bytes[rank].data() + i * sizeof(T), &x, sizeof(T));
                }
            }
            return pending_exchange(std::move(bytes), sizes, comm_.rank());
        });
        result.start(comm_);
        return result;
    }

    void put_sums_in_order()
    {
        for (std::size_t rank = 0; rank < send_.size(); ++rank)
            for (std::size_t i = 0; i < send_[rank].size(); ++i)
                sums_.emplace_back(rank, i);
        std::ranges::sort(sums_, {}, [&](const auto& s) {
            const request& r = send_[s.first][s.second];
            return std::tuple(r.asking_tile, r.element);
        });
    }

    communicator& comm_;
    std::vector<std::pair<std::uint64_t, std::size_t>> sizes_; // per tile: its number, and the number of its elements
    std::vector<std::vector<request>> send_;                   // per rank: the values that it asks for
    std::vector<std::vector<slot>> receive_;                   // per rank: the places of the values that it sends
    std::vector<std::pair<std::size_t, std::size_t>> sums_;    // indices into send_, in the order of the additions
};

} // namespace kith::mpi
