// SPDX-License-Identifier: BSD-3-Clause
#include "terminal.hpp"

#include "job/available_memory.hpp"

#include <kith/io/text/printable.hpp>
#include <kith/io/text/work_counter.hpp>
#include <kith/tiles/part/phase_seconds.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kith::tool {

namespace {

/// Returns a duration as text, in whole seconds, rounded up: "1 s", "2 min 5 s", "3 h 20 min".
std::string duration(double seconds)
{
    const auto s = std::uint64_t(std::ceil(seconds));
    if (s < 60)
        return std::to_string(s) + " s";
    if (s < 3600)
        return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
    return std::to_string(s / 3600) + " h " + std::to_string(s / 60 % 60) + " min";
}

/// Returns the number of bytes that this process has written so far, to any files.
double written_bytes()
{
    std::ifstream in("/proc/self/io"); // lines such as wchar: 4096
    double bytes = 0;
    for (std::string name; in >> name >> bytes;)
        if (name == "wchar:")
            return bytes;
    return 0;
}

/// Returns true if standard error is a terminal, or a pipe to mpirun whose own standard error is a terminal.
bool leads_to_terminal()
{
    if (::isatty(STDERR_FILENO) == 1)
        return true;
    struct stat status = {};
    if (std::getenv("OMPI_COMM_WORLD_RANK") == nullptr or ::fstat(STDERR_FILENO, &status) != 0 or
        not S_ISFIFO(status.st_mode))
        return false;
    const int descriptor = ::open(("/proc/" + std::to_string(::getppid()) + "/fd/2").c_str(),
                                  O_WRONLY | O_CLOEXEC | O_NOCTTY);
    const bool result = descriptor >= 0 and ::isatty(descriptor) == 1;
    if (descriptor >= 0)
        ::close(descriptor);
    return result;
}

/// The progress bar of this process, and the thread that draws it.
class progress_bar {
public:
    void allow(bool wanted)
    {
        const char* const kind = std::getenv("TERM");
        const bool has_commands = kind == nullptr or std::string_view(kind) != "dumb";
        is_allowed_ = wanted and not is_over_ and has_commands and leads_to_terminal();
        if (is_allowed_ and not drawing_.joinable())
            drawing_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
    }
    /// Begins a phase. Returns true if the bar shows this phase.
    bool begin(std::string name, share_of_work share)
    {
        const std::lock_guard lock(mutex_);
        if (not is_allowed_ or phase_)
            return false;
        phase_.emplace(phase{std::move(name), std::move(share), {}, 0});
        return true;
    }
    void end()
    {
        const std::lock_guard lock(mutex_);
        phase_.reset();
        erase();
    }
    void end_for_good()
    {
        const std::lock_guard lock(mutex_);
        is_allowed_ = false;
        is_over_ = true;
        phase_.reset();
        erase();
    }
    /// Calls write() while no bar is on the terminal.
    template <class Write>
    void without_bar(const Write& write)
    {
        const std::lock_guard lock(mutex_);
        erase();
        write();
    }

private:
    struct phase {
        std::string name;
        share_of_work share;
        stopwatch since;
        double most = 0; ///< largest share so far: the bar does not go back when memory is freed
    };

    void draw_until(const std::stop_token& stop)
    {
        using namespace std::chrono_literals;
        std::unique_lock lock(mutex_);
        while (not wake_.wait_for(lock, stop, 100ms, [&] { return stop.stop_requested(); }))
            if (phase_ and since_begin_.seconds() > 1)
                draw();
        erase();
    }
    void draw()
    {
        std::string line = phase_->name;
        const double seconds = phase_->since.seconds();
        if (phase_->share) {
            constexpr double almost_all = 0.99;
            const double share = phase_->most = std::clamp(phase_->share(), phase_->most, almost_all);
            constexpr std::size_t width = 30;
            const auto full = std::size_t(share * width);
            line += " [" + std::string(full, '#') + std::string(width - full, '.') + "] " +
                    std::to_string(int(100 * share)) + " %";
            if (share > 0.01)
                line += ", " + duration(seconds * (1 - share) / share) + " left";
        } else {
            line += ", " + duration(seconds);
        }
        winsize window{};
        if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 and window.ws_col > 1)
            line.resize(std::min<std::size_t>(line.size(), window.ws_col - 1U)); // a longer one could not be erased
        put("\r" + line + "\x1b[K");
        is_drawn_ = true;
    }
    void erase()
    {
        if (std::exchange(is_drawn_, false))
            put("\r\x1b[K");
    }
    static void put(std::string_view text)
    {
        if (::write(STDERR_FILENO, text.data(), text.size()) < 0)
            return; // a terminal that is gone needs no bar
    }

    std::mutex mutex_;
    std::condition_variable_any wake_;
    stopwatch since_begin_;
    std::optional<phase> phase_;
    bool is_allowed_ = false, is_over_ = false, is_drawn_ = false;
    std::jthread drawing_; ///< ends before the other members, which it uses
};

progress_bar& bar()
{
    static progress_bar one;
    return one;
}

} // namespace

/// A stream buffer that collects text up to the next flush, and then writes it on.
class printable_output::filter : public std::streambuf {
public:
    explicit filter(std::ostream& stream) : stream_(stream), to_(stream.rdbuf(this)) {}
    filter(const filter&) = delete;
    filter& operator=(const filter&) = delete;
    ~filter() override
    {
        write_out();
        stream_.rdbuf(to_);
    }

protected:
    int_type overflow(int_type c) override
    {
        if (not traits_type::eq_int_type(c, traits_type::eof())) {
            const char letter = traits_type::to_char_type(c);
            xsputn(&letter, 1);
        }
        return traits_type::not_eof(c);
    }
    std::streamsize xsputn(const char* text, std::streamsize size) override
    {
        const std::lock_guard lock(mutex_);
        text_.append(text, std::size_t(size));
        return size;
    }
    int sync() override { return write_out() ? 0 : -1; }

private:
    bool write_out()
    {
        const std::lock_guard lock(mutex_);
        if (text_.empty())
            return to_->pubsync() == 0;
        const std::string text = io::printable(std::exchange(text_, {}));
        bool is_written = false;
        bar().without_bar([&] {
            is_written = to_->sputn(text.data(), std::streamsize(text.size())) == std::streamsize(text.size()) and
                         to_->pubsync() == 0;
        });
        return is_written;
    }

    std::ostream& stream_;
    std::streambuf* to_;
    std::mutex mutex_;
    std::string text_;
};

printable_output::printable_output(bool with_standard_output) : errors_(std::make_unique<filter>(std::cerr))
{
    (void)bar(); // which outlives this
    if (with_standard_output)
        output_ = std::make_unique<filter>(std::cout);
}

printable_output::~printable_output() = default;

void allow_progress(bool wanted)
{
    bar().allow(wanted);
}

shown_phase::shown_phase(std::string name, share_of_work share)
    : is_outermost_(bar().begin(std::move(name), std::move(share)))
{
}

shown_phase::~shown_phase()
{
    if (is_outermost_)
        bar().end();
}

double share_of_file()
{
    return io::file_work.share();
}

share_of_work share_of_memory(double bytes)
{
    return [bytes, before = double(resident_memory())] { return (double(resident_memory()) - before) / bytes; };
}

share_of_work share_of_output(double bytes)
{
    return [bytes, before = written_bytes()] { return (written_bytes() - before) / bytes; };
}

void erase_progress()
{
    bar().end_for_good();
}

} // namespace kith::tool
