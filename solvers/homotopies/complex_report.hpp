#pragma once
/// From the ends of paths to solutions of a scene, with what they prove or leave open.

#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/lanes/square_system.hpp"

namespace gcs {

/// The end of a path as reports have it.
PathRecord path_record(const PathEnd& end);

/// Whether a path was stopped on the way.
bool is_any_stopped(const std::vector<PathEnd>& ends);

/// Status and reason of a report: stopped; infinite where it has motions, which is said in words; partial where something
/// is missing, likewise.
void conclude(bool is_stopped, const std::string& moving, const std::string& missing, SolveReport& report);

/// A report with doubts that may not have been looked into, as stop was asked for, says that it was stopped.
void conclude_stopped(const std::stop_token& stop, SolveReport& report);

/// The report of all paths: candidates from their finite ends, distinct up to reflections and real where
/// Newton's method on the real part agrees; a record for every path. The status is partial where paths
/// failed, where two ended at one regular solution (a step has jumped), where the conjugate of a finite end
/// is not among the ends, or where a singular end is no multiple solution but lies between some; infinite where ends lie
/// on motions, which are reported instead of them. Of `means` threads, crew and stop are used.
SolveReport complex_report(const Scene& scene, const DistanceSystem& system, const std::vector<PathEnd>& ends,
                           const WorkCounters& work, std::mt19937_64& random, const SolveMeans& means);

}  // namespace gcs
