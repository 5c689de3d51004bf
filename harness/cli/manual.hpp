#pragma once
/// The manual page of a program, made from what it says with --help.

#include <string>

namespace CLI {
class App;
}

namespace gcs {

/// The page gcsbench(1) in the language of man(7): every command with its options and examples.
std::string manual_page(const CLI::App& program, const std::string& version);

}  // namespace gcs
