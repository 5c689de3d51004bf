#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <string>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// What Python calls an Answer. Its arrays are made when they are first asked for.
struct SolvedInstance {
  Instance instance;
  Answer answer;
  std::map<std::string, pybind11::object> arrays = {};
};

}  // namespace gcs
