// SPDX-License-Identifier: BSD-3-Clause
#include "run_stats.hpp"

#include "errors.hpp"
#include "job/available_memory.hpp"

#include <kith/io/text/printable.hpp>
#include <kith/output_file.hpp>

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <ostream>

#include <sys/resource.h>

namespace kith::tool {

double processor_seconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

json json_of(const phase_seconds& seconds)
{
    auto result = json::object();
    for (std::size_t p = 0; p < phase_names.size(); ++p)
        result[std::string(phase_names[p])] = std::round(1e6 * seconds.all()[p]) / 1e6;
    return result;
}

void write_stats(const std::string& path, const phase_seconds& seconds)
{
    io::output_file file(path);
    file.stream() << text_of({{"seconds", json_of(seconds)},
                              {"processor_seconds", processor_seconds()},
                              {"peak_bytes", peak_memory()}})
                  << '\n';
    file.commit();
}

void print_result(std::ostream& out, const std::string& line, const std::string& output)
{
    errno = 0;
    if (not(out << io::printable(line) << '\n').flush())
        throw file_error("standard output: cannot be written" +
                         (errno != 0 ? std::string(": ").append(std::strerror(errno)) : std::string()) + "; " + output +
                         " is complete");
}

} // namespace kith::tool
