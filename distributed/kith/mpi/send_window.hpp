// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace kith::mpi {

/// A window of messages to ranks that call communicator::receive. At most `width` messages are pending; the next one
/// waits for the oldest. So the data to be sent are never in memory as a whole.
class send_window {
public:
    /// Takes the communicator, which must outlive this object, and the largest number of pending messages. Local.
    /// Precondition: width > 0.
    send_window(communicator& comm, std::size_t width) : comm_(comm), width_(width) {}
    send_window(const send_window&) = delete;
    ~send_window()
    {
        for (const auto& message : pending_exchange_)
            MPI_Waitall(int(message->requests.size()), message->requests.data(), MPI_STATUSES_IGNORE);
    }

    /// Sends a message. Returns at once while the window has room, else when the oldest message is complete. Errors:
    /// mpi::error.
    void send(std::vector<std::byte> bytes, int to)
    {
        if (pending_exchange_.size() == width_)
            wait_for_oldest();
        bytes_ += bytes.size();
        most_bytes_ = std::max(most_bytes_, bytes_);
        auto& message = pending_exchange_.emplace_back(std::make_unique<outgoing>(bytes.size(), std::move(bytes)));
        comm_.start_message(message->size, message->bytes, to, message->requests);
    }

    /// Waits until all messages are complete. Errors: mpi::error.
    void finish()
    {
        while (not pending_exchange_.empty())
            wait_for_oldest();
    }

    /// Returns the largest number of bytes that were held at once. Local.
    [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }

private:
    struct outgoing {
        std::uint64_t size;
        std::vector<std::byte> bytes;
        std::vector<MPI_Request> requests;

        outgoing(std::uint64_t size, std::vector<std::byte> bytes) : size(size), bytes(std::move(bytes)) {}
    };

    void wait_for_oldest()
    {
        const phase_timer timer(comm_.seconds()[phase::send]);
        auto& requests = pending_exchange_.front()->requests;
        detail::check(MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
        bytes_ -= pending_exchange_.front()->bytes.size();
        pending_exchange_.pop_front();
    }

    communicator& comm_;
    std::size_t width_;
    std::deque<std::unique_ptr<outgoing>> pending_exchange_; // addresses of the elements stay valid
    std::size_t bytes_ = 0, most_bytes_ = 0;
};

} // namespace kith::mpi
