// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random_meshes.hpp"

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace kith::comparison {

/// The settings of a program that compares on random meshes, and the number of its failed comparisons.
class random_runs {
public:
    std::size_t count = 1000; ///< random meshes per scheme
    std::uint64_t seed = 1;   ///< of the first mesh; the next meshes use the following seeds
    int levels = 3;

    /// Runs a comparison, which throws if it finds a difference.
    template <class Compare>
    void attempt(const std::string& what, const Compare& compare)
    {
        try {
            compare();
        } catch (const std::exception& error) {
            std::cout << what << ": DIFFERENT: " << error.what() << '\n';
            ++different_;
        }
    }
    /// Runs a comparison for each seed and passes it the random numbers of that seed.
    template <class Compare>
    void attempt_seeds(const Compare& compare)
    {
        for (std::uint64_t i = seed; i < seed + count; ++i)
            attempt("seed " + std::to_string(i), [&] {
                random_numbers random(i);
                compare(random);
            });
    }
    [[nodiscard]] std::size_t different() const { return different_; }
    /// Throws std::runtime_error if a comparison has failed.
    void require_same() const
    {
        if (different_ != 0)
            throw std::runtime_error(std::to_string(different_) + " comparisons are different");
    }

private:
    std::size_t different_ = 0;
};

/// Reads --count, --seed and --levels. Returns no value after printing the help text for --help. Errors: those of
/// boost::program_options.
inline std::optional<random_runs> parse_random_runs(int count, char** words, const char* what)
{
    namespace options = boost::program_options;
    random_runs runs;
    options::options_description description(what);
    description.add_options()("help", "this text")(
        "count", options::value(&runs.count)->default_value(runs.count), "so many random meshes for each scheme")(
        "seed", options::value(&runs.seed)->default_value(runs.seed), "of the first mesh; the next ones follow it")(
        "levels", options::value(&runs.levels)->default_value(runs.levels), "how often to refine");
    options::variables_map values;
    store(parse_command_line(count, words, description), values);
    notify(values);
    if (values.count("help") == 0)
        return runs;
    std::cout << description;
    return std::nullopt;
}

} // namespace kith::comparison
