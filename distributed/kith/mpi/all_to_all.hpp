// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"
#include "collective_phase.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::mpi {

/// An exchange of messages of known sizes between all ranks, with the bytes that they carry. Move only.
class pending_exchange {
public:
    /// Prepares the messages, with all memory that they need. Rank r will send `sizes[r]` bytes. Local.
    pending_exchange(std::vector<std::vector<std::byte>> to, const std::vector<std::uint64_t>& sizes, int self)
        : sent_(std::move(to)), received_(sizes.size())
    {
        for (std::size_t r = 0; r < sizes.size(); ++r)
            if (r != std::size_t(self))
                received_[r].resize(sizes[r]);
        requests_.reserve(2 * sizes.size());
    }
    pending_exchange(pending_exchange&&) noexcept =
        default; // a list that was moved from is empty, so there is no second wait
    pending_exchange& operator=(pending_exchange&&) = delete;
    ~pending_exchange() { MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

    /// Starts all messages; the message of a rank to itself is moved. Local. Errors: mpi::error.
    void start(communicator& comm)
    {
        const auto self = std::size_t(comm.rank());
        try {
            for (std::size_t r = 0; r < received_.size(); ++r)
                if (r != self)
                    comm.start_receive(received_[r], int(r), requests_);
            for (std::size_t r = 0; r < received_.size(); ++r)
                if (r != self)
                    comm.start_send(sent_[r], int(r), requests_);
        } catch (...) {
            // This rank must not wait for messages that others will never send. Those that have begun still write to
            // their buffers, which stay until the job ends.
            static_cast<void>(new std::pair(std::move(sent_), std::move(received_)));
            requests_.clear();
            throw;
        }
        received_[self] = std::move(sent_[self]);
    }

    /// Waits, and returns the received bytes by rank. Errors: mpi::error.
    std::vector<std::vector<std::byte>> finish()
    {
        auto requests = std::exchange(requests_, {});
        detail::check(MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
        sent_.clear();
        return std::move(received_);
    }

private:
    std::vector<std::vector<std::byte>> sent_, received_;
    std::vector<MPI_Request> requests_;
};

namespace detail {

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values)
{
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}
template <class T>
std::vector<T> values_in(const std::vector<std::byte>& bytes)
{
    std::vector<T> result(bytes.size() / sizeof(T));
    if (not bytes.empty())
        std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
}

} // namespace detail

/// Makes lists, one for each rank, by make(), sends list r to rank r, and returns the list that came from each rank. A
/// list is a std::vector of std::byte or of another type that can be copied as bytes. Collective.
/// Errors: phase_error for an exception of `make` and for lack of memory, on all ranks; mpi::error.
/// Cost: three agreements, a number to each rank, and the messages that are not empty.
template <class Make>
auto all_to_all(communicator& comm, const Make& make)
    requires std::invocable<const Make&>
{
    using value = typename std::remove_cvref_t<std::invoke_result_t<const Make&>>::value_type::value_type;
    static_assert(std::is_trivially_copyable_v<value>, "values that are plain bytes can be sent, others not");
    std::vector<std::vector<std::byte>> to;
    std::vector<std::uint64_t> sizes;
    collective_phase(comm, [&] {
        decltype(auto) lists = make();
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(lists)>, decltype(to)>)
            to = std::move(lists);
        else
            for (const auto& list : lists)
                to.push_back(detail::bytes_of(list));
        for (const auto& bytes : to)
            sizes.push_back(bytes.size());
    });
    sizes = comm.to_each(std::move(sizes));
    auto messages = collective_phase(comm, [&] { return pending_exchange(std::move(to), sizes, comm.rank()); });
    messages.start(comm);
    auto came = messages.finish();
    if constexpr (std::is_same_v<value, std::byte>)
        return came;
    else
        return collective_phase(comm, [&] {
            std::vector<std::vector<value>> result;
            for (const auto& bytes : came)
                result.push_back(detail::values_in<value>(bytes));
            return result;
        });
}
/// Sends list r of `to` to rank r and returns the list that came from each rank. Collective. Errors and cost: as above.
template <class T>
std::vector<std::vector<T>> all_to_all(communicator& comm, std::vector<std::vector<T>> to)
{
    return all_to_all(comm, [&]() -> std::vector<std::vector<T>>& { return to; });
}

/// Returns the values of all ranks, in the order of the ranks, on all ranks. Collective.
/// Errors: phase_error for lack of memory; mpi::error.
template <class T>
    requires std::is_trivially_copyable_v<T>
std::vector<T> all_of_ranks(communicator& comm, const std::vector<T>& mine)
{
    const auto came = all_to_all(comm, [&] {
        std::vector<std::vector<T>> to(std::size_t(comm.size()));
        to[0] = mine;
        return to;
    });
    const auto all = comm.broadcast(collective_phase(comm, [&] {
        std::vector<T> joined;
        for (const auto& part : came)
            joined.insert(joined.end(), part.begin(), part.end());
        return detail::bytes_of(joined);
    }));
    return collective_phase(comm, [&] { return detail::values_in<T>(all); });
}

} // namespace kith::mpi
