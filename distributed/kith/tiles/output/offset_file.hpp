// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/mask/hash_value.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// The error of a file that cannot be written, or read back; the message begins with its path.
struct write_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Returns where a share begins if `size` things are cut into so many shares, whose sizes differ by one at most. Share
/// number `shares` begins at `size`. Precondition: shares * shares does not overflow.
constexpr std::uint64_t begin_of_share(std::uint64_t size, std::uint64_t share, std::uint64_t shares)
{
    return size / shares * share + size % shares * share / shares;
}

/// The interface for writing bytes at given offsets.
struct placed_bytes {
    placed_bytes() = default;
    placed_bytes(const placed_bytes&) = delete;
    placed_bytes& operator=(const placed_bytes&) = delete;
    virtual ~placed_bytes() = default;
    virtual void write(std::uint64_t offset, const void* data, std::size_t size) = 0;
};

/// A file that many processes write at the same time, each its own bytes at their offsets. It uses POSIX only: in every
/// implementation of MPI-IO some version overflowed its offsets.
class offset_file final : public placed_bytes {
public:
    /// Makes the file with this size (create), or opens an existing one (open). Errors: write_error.
    static offset_file create(const std::string& path, std::uint64_t size)
    {
        offset_file file(path, O_RDWR | O_CREAT | O_TRUNC);
        file.resize(size);
        return file;
    }
    static offset_file open(const std::string& path) { return offset_file(path, O_RDWR); }
    /// Opens a file and keeps its contents, or makes it; its size is then `size`. Errors: write_error.
    static offset_file create_or_keep(const std::string& path, std::uint64_t size)
    {
        offset_file file(path, O_RDWR | O_CREAT);
        file.resize(size);
        return file;
    }

    offset_file(offset_file&& other) noexcept
        : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1))
    {
    }
    offset_file& operator=(offset_file&&) = delete;
    ~offset_file() override
    {
        if (descriptor_ >= 0)
            ::close(descriptor_);
    }

    [[nodiscard]] const std::string& path() const { return path_; }
    /// Closes the file. Errors: write_error, also for a full disk that is noticed only now.
    void close()
    {
        if (::close(std::exchange(descriptor_, -1)) != 0)
            refuse("cannot be written");
    }
    void resize(std::uint64_t size)
    {
        if (::ftruncate(descriptor_, off_t(size)) != 0)
            refuse("cannot be made " + std::to_string(size) + " bytes large");
    }
    /// Returns when all written bytes are on the disk. Errors: write_error.
    void flush()
    {
        if (::fdatasync(descriptor_) != 0)
            refuse("cannot be written");
    }
    /// Reads `size` bytes at this offset. Errors: write_error, also when the file ends before.
    void read(std::uint64_t offset, void* data, std::size_t size)
    {
        transfer(::pread, offset, static_cast<char*>(data), size, "cannot be read back");
    }
    /// Writes `size` bytes at this offset. Errors: write_error.
    void write(std::uint64_t offset, const void* data, std::size_t size) override
    {
        transfer(::pwrite, offset, static_cast<const char*>(data), size, "cannot be written");
    }

private:
    static constexpr std::size_t largest = std::size_t(256) << 20; // some systems transfer at most 2 GiB in one call

    template <class Call, class Byte>
    void transfer(const Call& call, std::uint64_t offset, Byte* bytes, std::size_t size, const std::string& failure)
    {
        while (size > 0) {
            const ssize_t count = call(descriptor_, bytes, std::min(size, largest), off_t(offset));
            if (count == 0)
                throw write_error(path_ + ": " + failure + " (it ends early)");
            if (count < 0 and errno == EINTR)
                continue;
            if (count < 0)
                refuse(failure);
            bytes += count;
            offset += std::uint64_t(count);
            size -= std::size_t(count);
        }
    }
    offset_file(const std::string& path, int flags) : path_(path), descriptor_(::open(path.c_str(), flags, 0666))
    {
        if (descriptor_ < 0)
            refuse("cannot be opened for writing");
    }
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw write_error(path_ + ": " + what + " (" + std::strerror(errno) + ")");
    }

    std::string path_;
    int descriptor_ = -1;
};

/// A comparison with the bytes of a file, made by writing to this object instead of the file.
class compared_bytes final : public placed_bytes {
public:
    explicit compared_bytes(offset_file& file) : file_(&file) {}

    /// Compares bytes with those of the file. Errors: write_error, also when the file ends before.
    void write(std::uint64_t offset, const void* data, std::size_t size) override
    {
        found_.resize(size);
        file_->read(offset, found_.data(), size);
        const auto* const expected = static_cast<const char*>(data);
        const auto differs = std::mismatch(found_.begin(), found_.end(), expected).first;
        if (differs != found_.end() and not difference_)
            difference_ = offset + std::uint64_t(differs - found_.begin());
    }
    /// Returns the offset of a byte that differs in the file: the first in the first write that found a difference.
    [[nodiscard]] std::optional<std::uint64_t> difference() const { return difference_; }

private:
    offset_file* file_;
    std::vector<char> found_;
    std::optional<std::uint64_t> difference_;
};

/// A checksum of the bytes of a file and their places. It is a sum over all bytes, so sums of disjoint parts add up to
/// that of the whole, in any order. A change of one word of four bytes changes the sum. Bytes that are 0 add nothing.
struct byte_sum {
    std::uint64_t bits = 0;

    /// Adds bytes at this offset. Cost: O(size).
    void add(std::uint64_t offset, const void* data, std::size_t size)
    {
        constexpr std::size_t word_bytes = 4;
        const auto* bytes = static_cast<const unsigned char*>(data);
        while (size > 0) {
            const std::size_t begin = offset % word_bytes, count = std::min(size, word_bytes - begin);
            std::uint32_t word = 0;
            if (count == word_bytes)
                std::memcpy(&word, bytes, word_bytes);
            else
                std::memcpy(reinterpret_cast<unsigned char*>(&word) + begin, bytes, count);
            bits += word * (mix_bits(offset / word_bytes) | 1);
            bytes += count;
            offset += count;
            size -= count;
        }
    }
    byte_sum& operator+=(byte_sum other)
    {
        bits += other.bits;
        return *this;
    }
    friend bool operator==(byte_sum, byte_sum) = default;
};

/// Returns the sum of the bytes [begin, end) of a file. Errors: write_error, also when the file ends before.
inline byte_sum sum_of_bytes(offset_file& file, std::uint64_t begin, std::uint64_t end)
{
    constexpr std::uint64_t largest = std::uint64_t(1) << 20;
    std::vector<char> bytes(std::size_t(std::min(end - begin, largest)));
    byte_sum result;
    for (std::uint64_t at = begin; at < end; at += bytes.size()) {
        bytes.resize(std::size_t(std::min<std::uint64_t>(end - at, bytes.size())));
        file.read(at, bytes.data(), bytes.size());
        result.add(at, bytes.data(), bytes.size());
    }
    return result;
}

/// A sum of all bytes that are written to a file. Without a file it only sums.
class summed_bytes final : public placed_bytes {
public:
    explicit summed_bytes(placed_bytes* file) : file_(file) {}

    /// Adds the bytes to the sum and writes them to the file, if there is one. Errors: those of the file.
    void write(std::uint64_t offset, const void* data, std::size_t size) override
    {
        sum_.add(offset, data, size);
        if (file_ != nullptr)
            file_->write(offset, data, size);
    }
    [[nodiscard]] byte_sum sum() const { return sum_; }

private:
    placed_bytes* file_;
    byte_sum sum_;
};

/// A buffer that joins small writes to consecutive offsets into large ones.
class joined_writes {
public:
    explicit joined_writes(placed_bytes& out) : out_(&out), bytes_(largest) {}

    template <class T>
    void put(std::uint64_t offset, const T& value)
    {
        put(offset, &value, sizeof(T));
    }
    void put(std::uint64_t offset, const void* data, std::size_t size)
    {
        if (offset != start_ + size_ or size_ + size > largest) {
            flush();
            start_ = offset;
            if (size > largest)
                return out_->write(offset, data, size);
        }
        std::memcpy(bytes_.data() + size_, data, size);
        size_ += size;
    }
    /// Stores value(i) for each i below `count`, one after the other.
    template <std::invocable<std::size_t> F>
    void put_each(std::uint64_t offset, std::size_t count, const F& value)
    {
        using type = std::invoke_result_t<const F&, std::size_t>;
        store_each<sizeof(type)>(offset, count, [&](std::size_t i, char* to) {
            const type one = value(i);
            std::memcpy(to, &one, sizeof(type));
        });
    }
    /// Calls store(i, to) for each i below `count`; each call stores `Bytes` bytes at `to`. They lie one after the
    /// other.
    template <std::size_t Bytes, std::invocable<std::size_t, char*> F>
    void store_each(std::uint64_t offset, std::size_t count, const F& store)
    {
        constexpr std::size_t at_once = 4096 / Bytes;
        for (std::size_t first = 0; first < count; first += at_once) {
            const std::size_t last = std::min(first + at_once, count);
            char* to = room(offset + Bytes * first, Bytes * (last - first));
            for (std::size_t i = first; i < last; ++i, to += Bytes)
                store(i, to);
        }
    }
    void flush()
    {
        if (size_ != 0)
            out_->write(start_, bytes_.data(), size_);
        size_ = 0;
    }

private:
    static constexpr std::size_t largest = std::size_t(1) << 20;

    /// Returns the memory for `size` bytes at this offset, to be filled before the next call. Precondition: they fit.
    char* room(std::uint64_t offset, std::size_t size)
    {
        if (offset != start_ + size_ or size_ + size > largest) {
            flush();
            start_ = offset;
        }
        return bytes_.data() + std::exchange(size_, size_ + size);
    }

    placed_bytes* out_;
    std::uint64_t start_ = 0; // of the bytes that are not yet written
    std::size_t size_ = 0;
    storage<char> bytes_;
};

} // namespace kith
