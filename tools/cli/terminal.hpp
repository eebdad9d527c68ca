// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

/// The terminal of a program: text without control characters, and a bar that shows the progress of the work.
namespace kith::tool {

/// A filter of std::cerr and, if wanted, of std::cout, during its lifetime. It replaces control characters
/// (io::printable), and erases a bar before the text. The program makes one at the beginning of main.
class printable_output {
public:
    explicit printable_output(bool with_standard_output);
    printable_output(const printable_output&) = delete;
    printable_output& operator=(const printable_output&) = delete;
    ~printable_output();

private:
    class filter;
    std::unique_ptr<filter> errors_, output_;
};

/// Allows progress bars if `wanted` is true and if standard error is a terminal. Before this call no bar is shown.
void allow_progress(bool wanted);

/// A function that returns the share of the work that is done, 0 to 1. It is called on another thread. It is empty if
/// the share is unknown.
using share_of_work = std::function<double()>;

/// A phase of the work. Once the program has run for a second, a bar shows the phase, its share and the time left. The
/// bar is drawn ten times a second until the phase ends. Phases inside another phase are not shown.
class shown_phase {
public:
    explicit shown_phase(std::string name, share_of_work share = {});
    shown_phase(const shown_phase&) = delete;
    shown_phase& operator=(const shown_phase&) = delete;
    ~shown_phase();

private:
    bool is_outermost_;
};

/// Runs `work` as a phase that is shown, and returns its result.
template <class Work>
auto shown(std::string name, share_of_work share, const Work& work)
{
    const shown_phase phase(std::move(name), std::move(share));
    return work();
}

/// Returns the share of a file that has been read or written (io::file_work).
double share_of_file();

/// Returns a measure of work that fills memory: the growth of this process's memory from now on, as a share of `bytes`.
share_of_work share_of_memory(double bytes);

/// Returns a measure of work that writes: the bytes that this process writes from now on, as a share of `bytes`.
share_of_work share_of_output(double bytes);

/// Removes the bar for good. The programs call it before a signal ends them, and on ranks that show no bar.
void erase_progress();

} // namespace kith::tool
