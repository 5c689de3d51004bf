#pragma once
/// Legs, and what follows them, as bytes for another process (see Crew).

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solvers/homotopies/leg_block.hpp"
#include "solvers/lanes/instruction_set.hpp"

namespace gcs {

/// All that legs of one system have in common.
struct LegTask {
  std::variant<SquareSystem, MonomialSystem> system;
  Elimination elimination;
  TrackingOptions options;
  InstructionSet set = InstructionSet::portable;
  int threads = 1;
  bool all_wide = false;
};

/// Legs with what they refer to.
struct SentLegs {
  SentLegs() = default;
  SentLegs(std::span<const Leg> legs, int unknowns);

  std::vector<Route> routes;
  std::vector<ComplexVectorX> starts;
  std::vector<int> route_of;
  std::vector<double> shortest_steps;

  /// They refer to these.
  std::vector<Leg> legs() const;
};

std::string to_message(const LegTask& task);
std::string to_message(std::span<const Leg> legs, int unknowns);
std::string to_message(const FollowedLegs& followed);

// Each throws std::invalid_argument for bytes that are none of these.
LegTask read_task(std::string_view message);
SentLegs read_legs(std::string_view message);
FollowedLegs read_followed(std::string_view message);

}  // namespace gcs
