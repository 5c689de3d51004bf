#include "solvers/homotopies/shortcomings.hpp"

#include <iomanip>
#include <sstream>

#include "solvers/running/words.hpp"

namespace gcs {
namespace {

std::string one_digit(double value) {
  std::ostringstream text;
  text << std::setprecision(1) << value;
  return text.str();
}

}  // namespace

std::string Shortcomings::in_words() const {
  std::string text;
  const auto append = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  for (const auto& [cause, paths] : lost)
    append(counted(paths.count, "path") + " failed: " + cause + ", at condition numbers up to " +
           one_digit(paths.condition));
  if (jumps > 0)
    append("several paths ended at each of " + counted(jumps, "regular solution") + ": a step has jumped");
  if (not_isolated > 0)
    append(
        "the Jacobian loses rank at " + counted(not_isolated, "end") +
        ": solutions there are not isolated to working precision, as where the scene flexes or nearly does");
  if (lonely > 0) append("the conjugates of " + counted(lonely, "solution") + " are missing");
  if (too_far > 0)
    append("the coordinates of " + counted(too_far, "end") + " are " + too_large_for_doubles());
  if (in_between > 0)
    append("solutions next to " + counted(in_between, "end") +
           " are so close together that their paths were not told apart");
  return text;
}

}  // namespace gcs
