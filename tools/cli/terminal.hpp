// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

/// The terminal on which a program runs: texts that cannot upset it, and a bar that shows how far the work is.
namespace kith::tool {

/// Filters std::cerr, and on wish std::cout, during its lifetime: control characters are replaced (io::printable), and
/// a bar is erased before the text. Made once, at the beginning of main.
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

/// Lets bars be shown if `wanted` and if standard error is a terminal. Before this call none is shown.
void allow_progress(bool wanted);

/// Returns the share of the work that is done, 0 to 1; called on another thread. Empty if the share is unknown.
using share_of_work = std::function<double()>;

/// A phase of the work. Once the program has run for a second, a bar shows the phase, its share and how long the rest
/// of it will take, ten times a second, until the phase ends. Phases inside of another one are not shown.
class shown_phase {
public:
    explicit shown_phase(std::string name, share_of_work share = {});
    shown_phase(const shown_phase&) = delete;
    shown_phase& operator=(const shown_phase&) = delete;
    ~shown_phase();

private:
    bool is_outermost_;
};

/// Returns what `work` returns, which is shown as a phase.
template <class Work>
auto shown(std::string name, share_of_work share, const Work& work)
{
    const shown_phase phase(std::move(name), std::move(share));
    return work();
}

/// The share of a file that has been read or written (io::file_work).
double share_of_file();

/// Measures work that fills memory: the share of so many bytes by which the memory of this process has grown.
share_of_work share_of_memory(double bytes);

/// Measures the share of so many bytes that this process has written.
share_of_work share_of_output(double bytes);

/// Takes the bar away for good, as before a signal ends the program and on ranks that show none.
void erase_progress();

} // namespace kith::tool
