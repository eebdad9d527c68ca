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

/// What a program that compares on random meshes was asked for, and how many of its comparisons have failed.
class random_runs {
public:
    std::size_t count = 1000; ///< of meshes for each scheme
    std::uint64_t seed = 1;   ///< of the first mesh; the next ones follow it
    int levels = 3;

    /// Runs a comparison, which throws what is different.
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
    /// Runs a comparison for each seed, handing over its random numbers.
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
    /// Errors: std::runtime_error where a comparison has failed.
    void require_same() const
    {
        if (different_ != 0)
            throw std::runtime_error(std::to_string(different_) + " comparisons are different");
    }

private:
    std::size_t different_ = 0;
};

/// Reads --count, --seed and --levels; nothing where help was asked for, which it prints. Errors: those of
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
