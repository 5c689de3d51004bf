#include "solvers/construction/closed_forms.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace gcs {
namespace {

using AllGiven = std::vector<GivenFrom>;

template <class Condition>
AllGiven where(const AllGiven& given, const Condition& condition) {
  AllGiven result;
  std::ranges::copy_if(given, std::back_inserter(result), condition);
  return result;
}

AllGiven first(AllGiven given, std::size_t count) {
  if (given.size() > count) given.erase(given.begin() + static_cast<std::ptrdiff_t>(count), given.end());
  return given;
}

AllGiven joined(AllGiven given, const AllGiven& more) {
  given.insert(given.end(), more.begin(), more.end());
  return given;
}

class ClosedForm {
 public:
  ClosedForm(const ProblemStatement& problem, int element, int zeros, const AllGiven& given)
      : problem_(problem), element_(element), zeros_(static_cast<std::size_t>(zeros)), given_(given) {}

  AllGiven used() const {
    if (problem_.is_point(element_)) return problem_.dimension == 2 ? of_point_in_plane() : of_point();
    if (problem_.is_plane(element_)) return of_plane();
    return problem_.dimension == 2 ? of_line_in_plane() : of_line();
  }

 private:
  AllGiven distances(int rank) const {
    return where(given_, [&](const GivenFrom& from) {
      return from.met_by == MetBy::distance && rank_of(problem_, from.other) == rank &&
             !is_on_line(problem_, element_, from);
    });
  }
  AllGiven on_lines() const {
    return where(given_, [&](const GivenFrom& from) { return is_on_line(problem_, element_, from); });
  }
  AllGiven met_by(MetBy kind) const {
    return where(given_, [&](const GivenFrom& from) { return from.met_by == kind; });
  }

  AllGiven of_point() const {
    const AllGiven surfaces = joined(distances(0), distances(1)), lines = on_lines();
    const AllGiven tubes = where(distances(2), [](const GivenFrom& from) { return from.value > 0; });
    if (!lines.empty()) {
      const AllGiven other = first(joined(surfaces, tubes), 1);
      return other.empty() ? other : joined(other, first(lines, 1));
    }
    const std::size_t cuts = surfaces.size() + zeros_;
    if (cuts >= 3) return surfaces;
    if (!distances(0).empty() || (cuts > 0 && !tubes.empty())) return joined(surfaces, first(tubes, 1));
    return tubes.size() > 1 ? first(tubes, 2) : AllGiven();
  }

  AllGiven of_point_in_plane() const {
    const AllGiven circles = distances(0), lines = distances(2);
    const bool has_places = !circles.empty() || lines.size() > 1;
    return has_places ? first(joined(circles, lines), 2) : AllGiven();
  }

  AllGiven of_plane() const {
    const AllGiven points = distances(0), along = met_by(MetBy::one_direction);
    if (points.empty()) return {};
    if (!along.empty()) return joined(first(points, 1), first(along, 1));
    return joined(points, met_by(MetBy::product));
  }

  AllGiven of_line_in_plane() const {
    const AllGiven points = distances(0);
    if (points.empty()) return {};
    return first(joined(joined(points, met_by(MetBy::product)), met_by(MetBy::one_direction)), 2);
  }

  AllGiven of_line() const {
    const AllGiven through = on_lines(), along = met_by(MetBy::one_direction), beside = distances(0);
    if (through.empty() && along.empty()) return {};
    if (through.empty()) return beside.empty() ? beside : joined(first(beside, 2), first(along, 1));
    if (through.size() > 1) return first(through, 2);
    if (!along.empty()) return joined(through, first(along, 1));
    return joined(through, first(joined(beside, met_by(MetBy::product)), 2));
  }

  const ProblemStatement& problem_;
  int element_;
  std::size_t zeros_;
  const AllGiven& given_;
};

}  // namespace

int rank_of(const ProblemStatement& problem, int element) {
  if (problem.is_point(element)) return 0;
  return problem.is_plane(element) ? 1 : 2;
}

bool is_on_line(const ProblemStatement& problem, int element, const GivenFrom& from) {
  return from.conditions == 2 && from.met_by == MetBy::distance &&
         (problem.is_line(element) || problem.is_line(from.other));
}

std::vector<GivenFrom> used_in_closed_form(const ProblemStatement& problem, int element, int zeros,
                                           const std::vector<GivenFrom>& given) {
  return ClosedForm(problem, element, zeros, given).used();
}

}  // namespace gcs
