// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::mpi {

/// Messages between ranks that know how long they are, and the bytes they carry. Move only.
class under_way {
public:
    /// Local: starts them all. `sizes[r]` bytes come from rank r; what a rank sends to itself is handed over.
    /// Errors: mpi::error.
    under_way(communicator& comm, std::vector<std::vector<std::byte>> to, const std::vector<std::uint64_t>& sizes)
        : sent_(std::move(to)), received_(sizes.size())
    {
        const auto self = std::size_t(comm.rank());
        for (std::size_t r = 0; r < sizes.size(); ++r) // all memory before any is under way, should there not be enough
            if (r != self)
                received_[r].resize(sizes[r]);
        requests_.reserve(2 * sizes.size());
        try {
            start(comm, sizes.size());
        } catch (...) {
            // Nobody may wait for what others will never send; what has begun still writes to its buffers, which stay
            // until the job ends.
            static_cast<void>(new std::pair(std::move(sent_), std::move(received_)));
            throw;
        }
        received_[self] = std::move(sent_[self]);
    }
    under_way(under_way&&) noexcept = default; // a list that was moved from is empty, so nobody waits twice
    under_way& operator=(under_way&&) = delete;
    ~under_way() { MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

    /// Waits, and returns what has come, by rank. Errors: mpi::error.
    std::vector<std::vector<std::byte>> finish()
    {
        auto requests = std::exchange(requests_, {});
        detail::check(MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
        sent_.clear();
        return std::move(received_);
    }

private:
    void start(communicator& comm, std::size_t ranks)
    {
        const auto self = std::size_t(comm.rank());
        for (std::size_t r = 0; r < ranks; ++r)
            if (r != self)
                comm.start_receive(received_[r], int(r), requests_);
        for (std::size_t r = 0; r < ranks; ++r)
            if (r != self)
                comm.start_send(sent_[r], int(r), requests_);
    }

    std::vector<std::vector<std::byte>> sent_, received_;
    std::vector<MPI_Request> requests_;
};

/// Collective: `to[r]` goes to rank r, and what came from rank r is the r-th of the result.
/// Cost: a number to each rank, and the messages that are not empty. Errors: mpi::error.
inline std::vector<std::vector<std::byte>> all_to_all(communicator& comm, std::vector<std::vector<std::byte>> to)
{
    std::vector<std::uint64_t> sizes(to.size());
    for (std::size_t r = 0; r < to.size(); ++r)
        sizes[r] = to[r].size();
    return under_way(comm, std::move(to), comm.to_each(sizes)).finish();
}
template <class T>
    requires std::is_trivially_copyable_v<T>
std::vector<std::vector<T>> all_to_all(communicator& comm, const std::vector<std::vector<T>>& to)
{
    std::vector<std::vector<std::byte>> bytes(to.size());
    for (std::size_t r = 0; r < to.size(); ++r) {
        const auto all = std::as_bytes(std::span(to[r]));
        bytes[r].assign(all.begin(), all.end());
    }
    const auto coming = all_to_all(comm, std::move(bytes));
    std::vector<std::vector<T>> result(coming.size());
    for (std::size_t r = 0; r < coming.size(); ++r) {
        result[r].resize(coming[r].size() / sizeof(T));
        if (not coming[r].empty())
            std::memcpy(result[r].data(), coming[r].data(), coming[r].size());
    }
    return result;
}

/// Collective: what all ranks have, one rank after the other, on all ranks. Errors: mpi::error.
template <class T>
    requires std::is_trivially_copyable_v<T>
std::vector<T> all_of_ranks(communicator& comm, const std::vector<T>& mine)
{
    std::vector<std::vector<T>> to(std::size_t(comm.size()));
    to[0] = mine;
    std::vector<std::byte> all;
    for (const auto& part : all_to_all(comm, to)) {
        const auto bytes = std::as_bytes(std::span(part));
        all.insert(all.end(), bytes.begin(), bytes.end());
    }
    all = comm.broadcast(std::move(all));
    std::vector<T> result(all.size() / sizeof(T));
    if (not all.empty())
        std::memcpy(result.data(), all.data(), all.size());
    return result;
}

} // namespace kith::mpi
