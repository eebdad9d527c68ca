// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpi_calls.hpp"
#include "mpi_header.hpp"

#include <kith/tiles/part/phase_seconds.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// The messages between two ranks that a rank has sent and received through a communicator of kith, including those
/// with sizes. Collective calls (broadcast, sum, to_each, ...) are not counted.
struct traffic {
    std::uint64_t bytes_sent = 0, messages_sent = 0, bytes_received = 0, messages_received = 0;
};

/// A duplicated communicator, so that messages of kith cannot meet others. It reports errors instead of ending the
/// program. Move only. Comments of local calls say so; all other calls are collective or need a partner.
class communicator {
public:
    /// Duplicates `parent`. Messages longer than `largest` bytes are sent in chunks, since MPI 3.1 counts in int.
    /// Collective. Precondition: 0 < largest < 2^31. Errors: mpi::error.
    explicit communicator(MPI_Comm parent, std::size_t largest = std::size_t(1) << 30) : largest_(largest)
    {
        detail::check(MPI_Comm_dup(parent, &comm_), "MPI_Comm_dup");
        detail::check(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
        detail::check(MPI_Comm_rank(comm_, &rank_), "MPI_Comm_rank");
        detail::check(MPI_Comm_size(comm_, &size_), "MPI_Comm_size");
    }
    communicator(communicator&& other) noexcept
        : comm_(std::exchange(other.comm_, MPI_COMM_NULL))
        , rank_(other.rank_)
        , size_(other.size_)
        , largest_(other.largest_)
        , traffic_(other.traffic_)
        , seconds_(other.seconds_)
    {
    }
    communicator& operator=(communicator&&) = delete;
    /// Frees the communicator. Collective, except during stack unwinding, when nothing is freed.
    ~communicator()
    {
        if (comm_ != MPI_COMM_NULL and std::uncaught_exceptions() == 0)
            MPI_Comm_free(&comm_);
    }

    /// Returns the number of this rank. Local.
    [[nodiscard]] int rank() const { return rank_; }
    /// Returns the number of ranks. Local.
    [[nodiscard]] int size() const { return size_; }
    /// Returns true on rank 0. Local.
    [[nodiscard]] bool is_root() const { return rank_ == 0; }
    /// Returns the traffic of this rank so far. Local.
    [[nodiscard]] const traffic& sent_and_received() const { return traffic_; }

    /// Returns the seconds for which this rank has sent (phase::send) and waited for others (phase::wait). Local.
    [[nodiscard]] phase_seconds& seconds() { return seconds_; }

    /// Sends bytes to one rank, which calls receive. Returns when the bytes may be changed.
    void send(std::span<const std::byte> bytes, int to)
    {
        const phase_timer timer(seconds_[phase::send]);
        const std::uint64_t size = bytes.size();
        detail::check(MPI_Send(&size, 1, MPI_UINT64_T, to, size_tag, comm_), "MPI_Send");
        count_sent(sizeof size);
        for_each_chunk(bytes, [&](std::span<const std::byte> chunk) {
            detail::check(MPI_Send(chunk.data(), int(chunk.size()), MPI_BYTE, to, bytes_tag, comm_), "MPI_Send");
            count_sent(chunk.size());
        });
    }
    /// Starts a message as `send` does; `size` is the number of bytes. Local. The function appends to `requests`;
    /// `size` and `bytes` must stay in place until these requests have been waited for.
    void start_message(const std::uint64_t& size, std::span<const std::byte> bytes, int to,
                       std::vector<MPI_Request>& requests)
    {
        detail::check(MPI_Isend(&size, 1, MPI_UINT64_T, to, size_tag, comm_, &requests.emplace_back(MPI_REQUEST_NULL)),
                      "MPI_Isend");
        count_sent(sizeof size);
        start_send(bytes, to, bytes_tag, requests);
    }
    /// Receives a message of rank `from` or, for any_rank, of the first rank that sends; `from` is then set to this
    /// rank.
    std::vector<std::byte> receive(int& from)
    {
        std::uint64_t size = 0;
        MPI_Status status;
        detail::wait_until(seconds_[phase::wait], [&] {
            int is_there = 0;
            detail::check(MPI_Iprobe(from, size_tag, comm_, &is_there, &status), "MPI_Iprobe");
            return is_there != 0;
        });
        const phase_timer timer(seconds_[phase::wait]);
        from = status.MPI_SOURCE;
        detail::check(MPI_Recv(&size, 1, MPI_UINT64_T, from, size_tag, comm_, &status), "MPI_Recv");
        count_received(sizeof size);
        auto bytes = room_for(size);
        for_each_chunk(std::span(bytes), [&](std::span<std::byte> chunk) {
            detail::check(
                MPI_Recv(chunk.data(), int(chunk.size()), MPI_BYTE, from, bytes_tag, comm_, MPI_STATUS_IGNORE),
                "MPI_Recv");
            count_received(chunk.size());
        });
        return bytes;
    }
    static constexpr int any_rank = MPI_ANY_SOURCE;

    /// Starts to send (start_send) or to receive (start_receive) a message whose size both sides know. Local. The
    /// functions append to `requests`; the bytes must stay in place until these requests have been waited for.
    void start_send(std::span<const std::byte> bytes, int to, std::vector<MPI_Request>& requests)
    {
        start_send(bytes, to, known_tag, requests);
    }
    void start_receive(std::span<std::byte> bytes, int from, std::vector<MPI_Request>& requests)
    {
        start(MPI_Irecv, "MPI_Irecv", bytes, from, known_tag, requests, &communicator::count_received);
    }

    /// Sends number r of each rank to rank r; returns the received numbers by rank. Allocates nothing. Collective.
    [[nodiscard]] std::vector<std::uint64_t> to_each(std::vector<std::uint64_t> numbers)
    {
        detail::check(MPI_Alltoall(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, numbers.data(), 1, MPI_UINT64_T, comm_),
                      "MPI_Alltoall");
        return numbers;
    }

    /// Returns the bytes of the root on all ranks. Collective. Errors: phase_error if a rank has no memory for them.
    std::vector<std::byte> broadcast(std::vector<std::byte> bytes)
    {
        std::uint64_t size = bytes.size();
        MPI_Request request = MPI_REQUEST_NULL;
        detail::check(MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, comm_, &request), "MPI_Ibcast");
        detail::wait_for(request, seconds_[phase::wait], "MPI_Ibcast");
        std::string problem;
        try {
            bytes.resize(size);
        } catch (const std::bad_alloc&) {
            problem = "no memory"; // fits into a string without memory of its own
        }
        agree(problem);
        const phase_timer timer(seconds_[phase::send]);
        for_each_chunk(std::span(bytes), [&](std::span<std::byte> chunk) {
            detail::check(MPI_Bcast(chunk.data(), int(chunk.size()), MPI_BYTE, 0, comm_), "MPI_Bcast");
        });
        return bytes;
    }
    /// Returns the sums over all ranks. Sums of integers do not depend on the order. Collective.
    template <std::size_t N>
    [[nodiscard]] std::array<std::uint64_t, N> sum(std::array<std::uint64_t, N> values)
    {
        MPI_Request request = MPI_REQUEST_NULL;
        detail::check(MPI_Iallreduce(MPI_IN_PLACE, values.data(), int(N), MPI_UINT64_T, MPI_SUM, comm_, &request),
                      "MPI_Iallreduce");
        detail::wait_for(request, seconds_[phase::wait], "MPI_Iallreduce");
        return values;
    }
    /// Returns the sums of lists, which have one length on all ranks. Collective.
    [[nodiscard]] std::vector<std::uint64_t> sum(std::vector<std::uint64_t> values)
    {
        for_each_chunk(std::span(values), [&](std::span<std::uint64_t> chunk) {
            detail::check(MPI_Allreduce(MPI_IN_PLACE, chunk.data(), int(chunk.size()), MPI_UINT64_T, MPI_SUM, comm_),
                          "MPI_Allreduce");
        });
        return values;
    }
    /// Returns the least (minimum) or the greatest (maximum) of each value over all ranks. Unlike sums of floats they
    /// do not depend on the order. Collective.
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> minimum(std::array<double, N> values)
    {
        detail::check(MPI_Allreduce(MPI_IN_PLACE, values.data(), int(N), MPI_DOUBLE, MPI_MIN, comm_), "MPI_Allreduce");
        return values;
    }
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> maximum(std::array<double, N> values)
    {
        detail::check(MPI_Allreduce(MPI_IN_PLACE, values.data(), int(N), MPI_DOUBLE, MPI_MAX, comm_), "MPI_Allreduce");
        return values;
    }

    /// Throws on all ranks if some ranks have a problem: the problem of the lowest of these ranks. So an error on one
    /// rank gives one message and no hang. Collective, between phases. Errors: phase_error, whose text has at most 4096
    /// bytes.
    void agree(const std::string& problem);

private:
    static constexpr int size_tag = 1, bytes_tag = 2, known_tag = 3;

    template <class T, class Use>
    void for_each_chunk(std::span<T> values, const Use& use) const
    {
        const std::size_t most = std::max(std::size_t(1), largest_ / sizeof(T));
        while (not values.empty()) {
            const auto chunk = values.first(std::min(values.size(), most));
            use(chunk);
            values = values.subspan(chunk.size());
        }
    }
    void start_send(std::span<const std::byte> bytes, int to, int tag, std::vector<MPI_Request>& requests)
    {
        start(MPI_Isend, "MPI_Isend", bytes, to, tag, requests, &communicator::count_sent);
    }
    /// Starts a call of MPI for each chunk and counts it.
    template <class Call, class Byte>
    void start(const Call& call, const char* name, std::span<Byte> bytes, int peer, int tag,
               std::vector<MPI_Request>& requests, void (communicator::*count)(std::size_t))
    {
        for_each_chunk(bytes, [&](std::span<Byte> chunk) {
            MPI_Request& request = requests.emplace_back(MPI_REQUEST_NULL);
            detail::check(call(chunk.data(), int(chunk.size()), MPI_BYTE, peer, tag, comm_, &request), name);
            (this->*count)(chunk.size());
        });
    }
    /// Allocates the bytes of a message. Lack of memory is reported as mpi::error, since the sender has begun and
    /// cannot be told.
    static std::vector<std::byte> room_for(std::uint64_t size)
    {
        try {
            return std::vector<std::byte>(size);
        } catch (const std::bad_alloc&) {
            throw error("there is not enough memory for a message of " + std::to_string(size) + " bytes");
        }
    }
    void count_sent(std::size_t bytes)
    {
        traffic_.bytes_sent += bytes;
        ++traffic_.messages_sent;
    }
    void count_received(std::size_t bytes)
    {
        traffic_.bytes_received += bytes;
        ++traffic_.messages_received;
    }

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0, size_ = 1;
    std::size_t largest_;
    traffic traffic_;
    phase_seconds seconds_;
};

/// A problem on one rank that has been reported to all ranks.
struct phase_error : std::runtime_error {
    phase_error(int rank, const std::string& text) : std::runtime_error(text), rank(rank) {}
    int rank; ///< the rank that has the problem
};

inline void communicator::agree(const std::string& problem)
{
    int first = problem.empty() ? std::numeric_limits<int>::max() : rank_;
    MPI_Request request = MPI_REQUEST_NULL;
    detail::check(MPI_Iallreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm_, &request), "MPI_Iallreduce");
    detail::wait_for(request, seconds_[phase::wait], "MPI_Iallreduce");
    if (first == std::numeric_limits<int>::max())
        return;
    std::array<char, 4096> text{}; // no memory is allocated, so a rank without memory receives the text, too
    std::uint64_t size = problem.copy(text.data(), text.size());
    detail::check(MPI_Bcast(&size, 1, MPI_UINT64_T, first, comm_), "MPI_Bcast");
    detail::check(MPI_Bcast(text.data(), int(size), MPI_CHAR, first, comm_), "MPI_Bcast");
    throw phase_error(first, std::string(text.data(), size));
}

} // namespace kith::mpi
