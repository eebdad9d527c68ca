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

/// What `kith VERB ARGUMENTS` runs; it returns the exit code.
struct verb {
    std::string_view name;
    std::string_view summary;
    int (*run)(const verb&, const std::vector<std::string>& arguments);
    std::string_view examples;         ///< lines for --help
    std::string_view program = "kith"; ///< which --help names
};

int run_refine(const verb&, const std::vector<std::string>& arguments);
int run_tessellate(const verb&, const std::vector<std::string>& arguments);
int run_info(const verb&, const std::vector<std::string>& arguments);
int run_compare(const verb&, const std::vector<std::string>& arguments);
int run_plan(const verb&, const std::vector<std::string>& arguments);
int run_schemes(const verb&, const std::vector<std::string>& arguments);

/// One option of a verb, with a value or without, as --help shows it.
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

/// The options of a verb with --help and --version, and its operands: words without a dash, needed but for "[IN]".
/// Empty when --help or --version was asked for, which is then answered. Errors: usage_error.
std::optional<boost::program_options::variables_map> parse(const verb& verb,
                                                           boost::program_options::options_description options,
                                                           const std::vector<std::string>& operands,
                                                           const std::vector<std::string>& arguments);

void print_version(std::string_view program = "kith");

/// The value of a required option or operand. Errors: usage_error when it is missing.
std::string required(const boost::program_options::variables_map& values, const std::string& name);

/// --output, which has a name. Errors: usage_error when it is missing or the file of --stats, file_error when it is
/// empty.
std::string output_of(const boost::program_options::variables_map& values);

/// Returns true if --binary is given. Errors: usage_error for an output whose format has one form only, and those of
/// `io::output_format_of`.
bool is_binary_from(const boost::program_options::variables_map& values, const std::string& output);

/// --levels: 0 or more. Errors: usage_error.
int levels_of(const boost::program_options::variables_map& values);

/// An option that counts: from 1 up to `most`, and 1 when it is not given. Errors: usage_error.
std::uint64_t count_from(const boost::program_options::variables_map& values, const std::string& option,
                         std::int64_t most = INT64_MAX);

/// What counts may be asked for: more than any machine has, and little enough to multiply and to allocate.
constexpr std::int64_t most_ranks = 1 << 20, most_tiles_per_rank = UINT32_MAX, most_threads = 4096;

/// A finite number, or nothing for other words.
std::optional<double> number_in(std::string_view text);

/// A number of bytes: 500M, 1.5G; K, M, G and T are powers of 1024. Errors: usage_error.
std::uint64_t bytes_from(const std::string& text);

} // namespace kith::tool
