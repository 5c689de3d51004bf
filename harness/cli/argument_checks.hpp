#pragma once
/// Checks of words on the command line that the parser's own let through or read otherwise than people do.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace gcs {

/// Adds the positional INSTANCE, which has to be given.
void add_instance_argument(CLI::App& command, std::string& instance);

/// Adds --threads. What commands compute does not depend on it, so that by default `threads` is set to all cores that the
/// process may use, or its part of them where it is one of several ranks on a machine.
void add_threads_option(CLI::App& command, int& threads, int ranks_here = 1);

/// A decimal whole number in [least, most]; the parser takes 010 for octal, and −1 for the largest there is.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

/// A number in [least, most], as `expected` says ("a percentage from 0 to 100"). NaN is none.
CLI::Validator number_between(double least, double most, std::string expected);

/// The name of a place to write to, and no forgotten one: neither empty nor what looks like an option.
CLI::Validator place_name();

/// Likewise, or "-" for standard output.
CLI::Validator output_name();

/// Throws UsageError when `out`, given by the option, is the same file as `used`, which the run reads or keeps: it would
/// be replaced. "-" and names of no file are no files.
void require_another_file(const std::string& out, const std::string& used, std::string_view option = "--out");

}  // namespace gcs
