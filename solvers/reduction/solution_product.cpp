#include "solvers/reduction/solution_product.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/reduction/precise_base.hpp"

namespace gcs {
namespace {

/// Choices to look at before counting or listing is given up: seconds.
constexpr std::int64_t most_visits = 50'000;

/// A base whose squared distances are given, somewhere.
Simplex canonical_base(const Scene& scene, const Part& part) {
  const auto square = [&](int pair) {
    const double length = scene.target_lengths()[part.base_constraints[pair]];
    return length * length;
  };
  Simplex base = Simplex::Zero(3, static_cast<Eigen::Index>(part.base.size()));
  const double a = square(0);
  base(0, 1) = std::sqrt(a);
  if (base.cols() == 2) return base;
  const double b = square(1), c = square(2);
  const double along = (a + b - c) / 2 / std::sqrt(a);
  base(0, 2) = along;
  base(1, 2) = std::sqrt(std::complex<double>(b - along * along));
  return base;
}

bool is_among(const std::vector<int>& points, int point) {
  return std::find(points.begin(), points.end(), point) != points.end();
}

}  // namespace

SolutionProduct::SolutionProduct(const Scene& scene, const std::vector<Part>& parts,
                                 std::vector<std::vector<PartSolution>> solved)
    : scene_(scene),
      parts_(parts),
      squares_(target_squares(scene)),
      placer_(scene),
      solutions_(std::move(solved)),
      home_(static_cast<std::size_t>(scene.point_count()), -1),
      depends_on_(parts.size()),
      is_across_(parts.size(), false),
      side_matters_(parts.size(), false),
      placed_at_(parts.size()),
      choices_(parts.size()),
      positions_(Simplex::Zero(3, scene.point_count())) {
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
    for (const int point : parts[part].points) home_[point] = part;
  leave_out_collinear_bases();
  find_dependences();
}

void SolutionProduct::leave_out_collinear_bases() {
  for (std::size_t part = 1; part < parts_.size(); ++part) {
    if (parts_[part].is_hung_point()) continue;
    const std::string why = why_not_on_base(scene_, parts_[part]);
    if (why.empty()) continue;
    note(scene_.problem().name(parts_[part].points.front()) + " and others are not placed: " + why);
    solutions_[part].clear();
  }
}

bool SolutionProduct::is_inside(const std::vector<int>& points, int part) const {
  return std::all_of(points.begin(), points.end(), [&](int point) {
    return is_among(parts_[part].points, point) || is_among(parts_[part].base, point);
  });
}

int SolutionProduct::last_home(const std::vector<int>& points) const {
  int last = 0;
  for (const int point : points) last = std::max(last, home_[point]);
  return last;
}

void SolutionProduct::find_dependences() {
  for (int part = 0; part < static_cast<int>(parts_.size()); ++part) {
    if (!parts_[part].is_hung_point()) continue;
    if (parts_[part].has_given_base()) {
      solutions_[part] = placed(part, exact_place(scene_, parts_[part]));
      continue;
    }
    std::set<int> all;
    const auto add_with_base = [&](int other, const auto& recurse) -> void {
      if (!all.insert(other).second) return;
      for (const int point : parts_[other].base) recurse(home_[point], recurse);
    };
    const int last = last_home(parts_[part].base);
    is_across_[part] = !is_inside(parts_[part].base, last);
    if (is_across_[part]) {
      for (const int point : parts_[part].base) add_with_base(home_[point], add_with_base);
      for (const int other : all) side_matters_[other] = true;
    } else {
      all.insert(last);
      all.insert(depends_on_[last].begin(), depends_on_[last].end());
    }
    depends_on_[part].assign(all.begin(), all.end());
  }
}

void SolutionProduct::note(const std::string& sentence) {
  if (std::find(undecided_.begin(), undecided_.end(), sentence) == undecided_.end())
    undecided_.push_back(sentence);
}

bool SolutionProduct::is_exhausted() {
  if (++visits_ <= most_visits) return false;
  note("there are more choices on which points depend than can be looked at");
  return true;
}

// ---- placing

Simplex SolutionProduct::positions_in_part(int part, const std::vector<int>& points) {
  const Part& where = parts_[part];
  const PartSolution& chosen = solutions_[part][choices_[part].solution];
  Simplex base;
  std::optional<SimplexFrame> frame;
  if (!where.base.empty()) {
    base = depends_on_[part].empty() ? canonical_base(scene_, where) : measured_base(part);
    frame.emplace(base);
  }
  Simplex result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto in_base = std::find(where.base.begin(), where.base.end(), points[i]);
    const auto place = std::find(where.points.begin(), where.points.end(), points[i]) - where.points.begin();
    const auto column = static_cast<Eigen::Index>(i);
    if (in_base != where.base.end())
      result.col(column) = base.col(in_base - where.base.begin());
    else
      result.col(column) = frame ? frame->point(chosen.points[place]) : chosen.points[place];
  }
  return result;
}

/// Of a part that depends on others: where they put its base.
Simplex SolutionProduct::measured_base(int part) {
  const std::vector<int>& base = parts_[part].base;
  if (!is_across_[part]) return positions_in_part(last_home(base), base);
  for (const int other : depends_on_[part]) place(other);
  return columns(positions_, base);
}

std::vector<PartSolution> SolutionProduct::placed(int part, const HungPlace& place) {
  if (place.undecided.empty())
    return {
        {{place.coordinates}, {}, place.is_real, place.is_flat, place.is_stiff, 1, place.is_flat ? 2 : 1}};
  note(scene_.problem().name(parts_[part].points.front()) + " is not placed: " + place.undecided);
  return {};
}

const std::vector<PartSolution>& SolutionProduct::solutions(int part) {
  if (depends_on_[part].empty()) return solutions_[part];
  std::vector<Choice> now;
  for (const int other : depends_on_[part])
    now.push_back(side_matters_[other] ? choices_[other] : Choice{choices_[other].solution});
  if (now == placed_at_[part]) return solutions_[part];
  placed_at_[part] = std::move(now);
  double condition = 1;
  for (const int other : depends_on_[part])
    condition = std::max(condition, solutions_[other][choices_[other].solution].condition);
  HungPlace place = measured_place(scene_, parts_[part], measured_base(part), condition);
  if (!place.undecided.empty())
    if (const auto base = proven_base(part)) {
      place = precise_place(scene_, parts_[part], *base);
      place.is_stiff = true;
    }
  solutions_[part] = placed(part, place);
  return solutions_[part];
}

std::optional<MeasuredSquares> SolutionProduct::proven_base(int part) {
  const std::vector<int>& base = parts_[part].base;
  const int last = last_home(base);
  if (is_across_[part] || parts_[last].is_hung_point()) return std::nullopt;
  const PartProblem alone = part_problem(scene_.problem(), parts_[last]);
  return precise_base(scene_, alone, positions_in_part(last, alone.points), base);
}

void SolutionProduct::place(int part) {
  const Part& where = parts_[part];
  const PartSolution& chosen = solutions_[part][choices_[part].solution];
  if (where.base.empty()) {
    for (std::size_t i = 0; i < where.points.size(); ++i) positions_.col(where.points[i]) = chosen.points[i];
    return;
  }
  placer_.place(where, chosen.points, choices_[part].side, chosen.is_flat, positions_);
}

// ---- counting

std::optional<Natural> SolutionProduct::count(bool only_real) {
  visits_ = 0;
  std::vector<int> all(parts_.size());
  std::iota(all.begin(), all.end(), 0);
  Natural sided = weigh(all, only_real, Weighing::sides);
  sided += weigh(all, only_real, Weighing::flat_only);
  return visits_ > most_visits ? std::nullopt : std::optional(sided / 2);
}

Natural SolutionProduct::weigh(const std::vector<int>& open, bool only_real, Weighing weighing) {
  Natural product = 1;
  for (const std::vector<int>& together : connected(open)) {
    product = product * weigh_connected(together, only_real, weighing);
    if (product.is_zero()) break;
  }
  return product;
}

/// The first of `open` depends on nothing that is open.
Natural SolutionProduct::weigh_connected(const std::vector<int>& open, bool only_real, Weighing weighing) {
  const int part = open.front();
  const std::vector<int> rest(open.begin() + 1, open.end());
  const std::size_t options = solutions(part).size();
  Natural sum;
  for (std::size_t i = 0; i < options; ++i) {
    const PartSolution& solution = solutions_[part][i];
    if ((only_real && !solution.is_real) || (weighing == Weighing::flat_only && !solution.is_flat)) continue;
    const bool both = side_matters_[part] && part > 0 && !solution.is_flat;
    const std::uint64_t weight = solution.is_flat || both ? 1 : 2;
    for (const int side : {1, -1}) {
      if (side < 0 && !both) continue;
      if (is_exhausted()) return sum;
      choices_[part] = {static_cast<int>(i), side};
      sum += Natural(weight) * weigh(rest, only_real, weighing);
    }
  }
  return sum;
}

std::vector<std::vector<int>> SolutionProduct::connected(const std::vector<int>& open) const {
  std::vector<int> root(parts_.size(), -1);
  for (const int part : open) root[part] = part;
  const auto find = [&](int part) {
    while (root[part] != part) part = root[part] = root[root[part]];
    return part;
  };
  for (const int part : open)
    for (const int other : depends_on_[part])
      if (root[other] >= 0) {
        const int a = find(part), b = find(other);
        root[std::max(a, b)] = std::min(a, b);
      }
  std::vector<std::vector<int>> groups(parts_.size());
  for (const int part : open) groups[find(part)].push_back(part);
  std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
  return groups;
}

// ---- listing

std::vector<Candidate> SolutionProduct::list(bool real, std::size_t limit) {
  limit_ = limit;
  lists_complex_ = !real;
  visits_ = 0;
  listed_.clear();
  list_from(0, false, false);
  return std::move(listed_);
}

/// Whether one of the parts from this one on may have a solution that is not real.
bool SolutionProduct::may_become_complex(int from) {
  for (int part = from; part < static_cast<int>(parts_.size()); ++part) {
    const auto& others = depends_on_[part];
    if (!others.empty() && others.back() >= from) return true;
    const auto& options = solutions(part);
    if (std::any_of(options.begin(), options.end(), [](const PartSolution& s) { return !s.is_real; }))
      return true;
  }
  return false;
}

/// `has_complex`: a chosen solution is not real. `has_side`: one is not flat, so that sides tell apart.
void SolutionProduct::list_from(int part, bool has_complex, bool has_side) {
  if (listed_.size() >= limit_ || is_exhausted()) return;
  if (part == static_cast<int>(parts_.size())) {
    if (lists_complex_ && !has_complex) return;
    visits_ = 0;
    listed_.push_back(candidate(!has_complex));
    return;
  }
  if (lists_complex_ && !has_complex && !may_become_complex(part)) return;
  const std::size_t options = solutions(part).size();
  for (std::size_t i = 0; i < options; ++i) {
    const bool is_real = solutions(part)[i].is_real, is_flat = solutions(part)[i].is_flat;
    if (!lists_complex_ && !is_real) continue;
    for (const int side : {1, -1}) {
      if (side < 0 && (is_flat || !has_side)) continue;
      choices_[part] = {static_cast<int>(i), side};
      place(part);
      list_from(part + 1, has_complex || !is_real, has_side || !is_flat);
    }
  }
}

/// A complex figure in the scene's frame. Turning by a complex rotation costs accuracy, much where directions
/// are nearly isotropic; a stiff one needs all of it.
Figure SolutionProduct::framed(const Figure& figure, bool is_stiff) const {
  const Figure turned = scene_.in_frame(figure);
  return !is_stiff && relative_residual(scene_, turned) <= double_root_residual
             ? turned
             : polished(scene_, squares_, turned);
}

Candidate SolutionProduct::candidate(bool is_real) const {
  Candidate result;
  bool is_stiff = false;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const PartSolution& chosen = solutions_[part][choices_[part].solution];
    result.multiplicity *= chosen.multiplicity;
    is_stiff = is_stiff || chosen.is_stiff;
  }
  result.figure = figure_of(positions_, solutions_[0][choices_[0].solution].lines, is_real);
  if (!is_real && !scene_.has_lines()) result.figure = framed(result.figure, is_stiff);
  if (is_stiff) result.error = proven_error(scene_, squares_, result.figure);
  return result;
}

}  // namespace gcs
