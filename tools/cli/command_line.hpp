// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <boost/program_options/variables_map.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kith::tool {

/// A verb of the program: its name, its help texts, and the function that `kith VERB ARGUMENTS` runs. `run` returns the
/// exit code.
struct verb {
    std::string_view name;
    std::string_view summary;
    int (*run)(const verb&, const std::vector<std::string>& arguments);
    std::string_view examples;         ///< lines for --help
    std::string_view program = "kith"; ///< name of the program in --help
};

int run_refine(const verb&, const std::vector<std::string>& arguments);
int run_tessellate(const verb&, const std::vector<std::string>& arguments);
int run_picture(const verb&, const std::vector<std::string>& arguments);
int run_view(const verb&, const std::vector<std::string>& arguments);
int run_info(const verb&, const std::vector<std::string>& arguments);
int run_compare(const verb&, const std::vector<std::string>& arguments);
int run_plan(const verb&, const std::vector<std::string>& arguments);
int run_schemes(const verb&, const std::vector<std::string>& arguments);

/// Adds an option of a verb, with a value (add_option) or without one (add_flag), as --help shows it.
template <class T>
void add_option(boost::program_options::options_description& options, const char* name, const char* value_name,
                const std::string& help)
{
    options.add_options()(name, boost::program_options::value<T>()->value_name(value_name), help.c_str());
}
inline void add_flag(boost::program_options::options_description& options, const char* name, const char* help)
{
    options.add_options()(name, help);
}

/// Returns the values of a verb's options, to which it adds --help and --version, and of its operands. Operands are
/// words without a dash; they are required, except one in brackets such as "[IN]". The last one may be a list such as
/// "IN...", of one word or more. Returns nothing if --help or --version was given, and has then printed the answer.
/// Errors: usage_error.
std::optional<boost::program_options::variables_map> parse(const verb& verb,
                                                           boost::program_options::options_description options,
                                                           const std::vector<std::string>& operands,
                                                           const std::vector<std::string>& arguments);

void print_version(std::string_view program = "kith");

/// Returns the value of a required option or operand. Errors: usage_error if it is missing.
std::string required(const boost::program_options::variables_map& values, const std::string& name);

/// Returns the value of --output, which is never empty. Errors: usage_error if it is missing or is the file of --stats,
/// file_error if it is empty.
std::string output_of(const boost::program_options::variables_map& values);

/// Returns true if --binary is given. Errors: usage_error for an output whose format has one form only, and the errors
/// of `io::output_format_of`.
bool is_binary_from(const boost::program_options::variables_map& values, const std::string& output);

/// Returns the value of --levels, 0 or more. Errors: usage_error.
int levels_of(const boost::program_options::variables_map& values);

/// Returns the value of an option that is a count: from 1 up to `most`, or 1 if the option is not given. Errors:
/// usage_error.
std::uint64_t count_from(const boost::program_options::variables_map& values, const std::string& option,
                         std::int64_t most = INT64_MAX);

/// The largest counts that options accept: more than any machine has, and small enough to be multiplied and allocated.
constexpr std::int64_t most_ranks = 1 << 20, most_tiles_per_rank = UINT32_MAX, most_threads = 4096;

/// Returns the finite number that a text stands for, or nothing for any other text.
std::optional<double> number_in(std::string_view text);

/// Returns the number of bytes that a text such as "500M" or "1.5G" stands for. K, M, G and T are powers of 1024.
/// Errors: usage_error.
std::uint64_t bytes_from(const std::string& text);

} // namespace kith::tool
