#include "harness/sweeps/sweep_main.hpp"

#include <fmt/format.h>

#include <exception>
#include <iostream>

#include "harness/base/environment.hpp"
#include "harness/base/stop_conditions.hpp"

namespace gcs {

int sweep_main(int argc, char** argv, const std::string& name, const std::string& description,
               const std::function<void(CLI::App&)>& add_options, const std::function<int()>& sweep) {
  try {
    CLI::App app(description, name);
    add_options(app);
    CLI11_PARSE(app, argc, argv);
    catch_interrupts();
    return sweep();
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  }
}

std::string where_measured() {
  const Environment environment = capture_environment(1);
  return fmt::format("Commit {}, {}, {}", environment.commit, environment.compiler, environment.cpu);
}

}  // namespace gcs
