/// gcsbench manual: the manual page.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "harness/base/environment.hpp"
#include "harness/cli/commands.hpp"

namespace gcs {

namespace {

/// One line of text: no character of it is taken for a request or changed when set, and a long list is broken at a comma.
std::string escaped(std::string_view line) {
  std::string text;
  if (line.starts_with('.') || line.starts_with('\'')) text += "\\&";
  for (const char c : line) {
    if (c == '\\') {
      text += "\\e";
    } else if (c == '-') {
      text += "\\-";
    } else if (c == '`') {
      text += "\\(ga";
    } else if (c == ',') {
      text += ",\\:";
    } else {
      text += c;
    }
  }
  return text;
}

/// As it is set in the help, line by line.
std::string verbatim(const std::string& text) {
  std::string lines = ".PP\n.nf\n";
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines += escaped(line) + "\n";
  return lines + ".fi\n";
}

/// "--seed N=1".
std::string usage_of(const CLI::Option& option) {
  std::string text = option.get_name();
  if (option.get_items_expected_max() == 0) return text;
  if (!option.get_type_name().empty()) text += " " + option.get_type_name();
  if (!option.get_default_str().empty()) text += "=" + option.get_default_str();
  return text;
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    text += fmt::format(".TP\n.B {}\n{}\n", escaped(usage_of(*option)), escaped(option->get_description()));
  return text;
}

std::string command_text(const CLI::App& command) {
  std::string text =
      fmt::format(".SS gcsbench {}\n{}.\n", command.get_name(), escaped(command.get_description()));
  text += options_of(command);
  if (!command.get_footer().empty()) text += verbatim(command.get_footer());
  return text;
}

/// The page gcsbench(1) in the language of man(7), made from what the program says with --help: every command with its
/// options and examples.
std::string manual_page(const CLI::App& program, const std::string& version) {
  std::string text = fmt::format(".TH GCSBENCH 1 \"\" \"gcsbench {}\" \"User Commands\"\n.ad l\n", version);
  text += fmt::format(".SH NAME\ngcsbench \\- {}\n", escaped(program.get_description()));
  text += ".SH SYNOPSIS\n.B gcsbench\n.I COMMAND\n[\\fIOPTION\\fR]...\n.SH OPTIONS\n" + options_of(program);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({}))
    if (!command->get_group().empty()) text += command_text(*command);
  return text + ".SH NOTES\n" + verbatim(program.get_footer());
}

}  // namespace

void add_manual_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("manual", "Write this help as a manual page");
  command->footer("\nExample:\n  gcsbench manual | man -l -\n");
  command->callback([&app, &invocation] {
    invocation.action = [&app] {
      std::cout << manual_page(app, program_version());
      return ExitCode::done;
    };
  });
}

}  // namespace gcs
