#include "harness/cli/argument_checks.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <thread>

#include "harness/cli/commands.hpp"

namespace gcs {
namespace {

template <typename Number>
bool reads_as(const std::string& text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

CLI::Validator check(std::function<std::string(std::string&)> problem_with) {
  return CLI::Validator(std::move(problem_with), "");
}

/// 0 where it is not known.
unsigned usable_cores() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return static_cast<unsigned>(CPU_COUNT(&cores));
  return std::thread::hardware_concurrency();
}

}  // namespace

void add_instance_argument(CLI::App& command, std::string& instance) {
  command
      .add_option(
          "INSTANCE", instance,
          "A file, - for standard input, or what `gcsbench list` shows: a shipped instance, or a member "
          "of a family (short-edge@1e-8)")
      ->required();
}

void add_threads_option(CLI::App& command, int& threads, int ranks_here) {
  // More than any machine has, and few enough to start.
  constexpr unsigned most = 1024;
  threads = static_cast<int>(std::clamp(usable_cores() / static_cast<unsigned>(ranks_here), 1U, most));
  command.add_option("--threads", threads, "Threads to use; the result does not depend on them")
      ->transform(whole_number(1, most))
      ->type_name("N")
      ->default_str("all cores");
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  return check([least, most](std::string& text) -> std::string {
    std::uint64_t value = 0;
    if (!reads_as(text, value) || value < least || value > most)
      return fmt::format("expected a whole number from {} to {}, not '{}'", least, most, text);
    text = std::to_string(value);
    return "";
  });
}

CLI::Validator number_between(double least, double most, std::string expected) {
  return check([expected = std::move(expected), least, most](std::string& text) -> std::string {
    double value = 0;
    if (reads_as(text, value) && value >= least && value <= most) return "";
    return fmt::format("expected {}, not '{}'", expected, text);
  });
}

CLI::Validator place_name() {
  return check([](std::string& text) -> std::string {
    if (text.empty()) return "expected a name, not an empty one";
    if (!text.starts_with('-')) return "";
    return fmt::format("expected a name, not '{0}' (what has this name is ./{0})", text);
  });
}

CLI::Validator output_name() {
  return check([](std::string& text) { return text == "-" ? std::string() : place_name()(text); });
}

void require_another_file(const std::string& out, const std::string& used, std::string_view option) {
  std::error_code ignored;
  if (out.empty() || out == "-" || used.empty() || used == "-") return;
  const bool is_same =
      std::filesystem::path(out).lexically_normal() == std::filesystem::path(used).lexically_normal() ||
      std::filesystem::equivalent(out, used, ignored);
  if (is_same)
    throw UsageError(
        fmt::format("{} {} would replace {}, which this run uses; name another file", option, out, used));
}

}  // namespace gcs
