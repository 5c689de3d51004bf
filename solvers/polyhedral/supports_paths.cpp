#include "solvers/polyhedral/supports_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

std::string what_is_missing(const MixedCells& cells) {
  switch (cells.status) {
    case MixedCellStatus::complete:
    case MixedCellStatus::stopped:
      return "";
    case MixedCellStatus::ties:
      return "no random lifting of the equations' monomials had mixed cells that doubles tell apart";
    case MixedCellStatus::too_large:
      return "the volume of a mixed cell does not fit 60 bits";
  }
  return "";
}

std::string what_is_missing(const GenericZeros& zeros) {
  if (zeros.unsolved_cells > 0)
    return "the binomial systems of " + counted(zeros.unsolved_cells, "mixed cell") +
           " were too large to be solved";
  if (zeros.lost > 0) return counted(zeros.lost, "path") + " from mixed cells got lost";
  if (zeros.repeated > 0)
    return counted(zeros.repeated, "path") + " from mixed cells ended where another had: a step has jumped";
  return "";
}

class Following {
 public:
  Following(const Supports& supports, const ComplexVectorX& coefficients, const SignMasks& signs,
            const SupportsRequest& request, std::mt19937_64& random, WorkCounters& work)
      : supports_(supports),
        coefficients_(coefficients),
        signs_(signs),
        request_(request),
        random_(random),
        work_(work) {}

  SupportsPaths run() {
    request_.progress("mixed cells", -1);
    const MixedCells cells = mixed_cells(supports_, {request_.seed, request_.setup.threads, request_.stop});
    result_.missing = what_is_missing(cells);
    result_.counts.mixed_volume = cells.total_volume();
    result_.counts.cells = static_cast<std::int64_t>(cells.cells.size());
    if (cells.status == MixedCellStatus::complete) follow_from(cells);
    result_.is_stopped = stopped_();
    return std::move(result_);
  }

 private:
  void follow_from(const MixedCells& cells) {
    GenericZeros zeros = follow_polyhedral_homotopies(
        cells, signs_, request_.setup, random_, stopped_,
        [&](double fraction) { request_.progress("polyhedral homotopies", fraction); }, work_);
    result_.counts.start_paths = zeros.paths;
    result_.missing = what_is_missing(zeros);
    if (!zeros.stopped && !zeros.zeros.empty()) follow_coefficients(std::move(zeros));
  }

  /// Whether coefficients of one equation differ so much that zeros would change next to the end of a straight way only.
  bool are_of_many_sizes(const MonomialSystem& system) const {
    constexpr double far_apart = 1e-4;
    for (int e = 0; e < system.equations(); ++e) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (int j = system.first[e]; j < system.first[e + 1]; ++j)
        if (const double size = std::abs(coefficients_[j]); size > 0) {
          least = std::min(least, size);
          most = std::max(most, size);
        }
      if (least < far_apart * most) return true;
    }
    return false;
  }

  /// From coefficients of modulus 1 to others of the same arguments that are as large as those at the end: in logarithms the
  /// way is no longer than these, and the arguments, at random, keep it clear of coefficients with multiple zeros.
  void follow_sizes(LegTracking& tracking, GenericZeros& zeros) {
    std::vector<double> rates;
    for (std::size_t j = 0; j < coefficients_.size(); ++j) {
      const double size = coefficients_[j] == 0.0 ? 1 : std::abs(coefficients_[j]);
      zeros.coefficients[j] *= size;
      rates.push_back(std::log(size));
    }
    const ComplexVectorX rest(coefficients_.size());
    const Route route{{zeros.coefficients, rest, rest, rest}, zeros.coefficients, std::move(rates)};
    std::vector<Leg> legs;
    for (const ComplexVectorX& start : zeros.zeros) legs.push_back({start.data(), &route});
    std::vector<ComplexVectorX> arrived;
    for (const LegResult& end : tracking.follow(legs, stopped_, work_))
      if (end.state.end == LegEnd::arrived) arrived.push_back(end.x);
    if (const std::size_t lost = zeros.zeros.size() - arrived.size(); lost > 0 && result_.missing.empty())
      result_.missing = counted(static_cast<std::int64_t>(lost), "path") +
                        " got lost where coefficients change their sizes";
    zeros.zeros = std::move(arrived);
  }

  void follow_coefficients(GenericZeros zeros) {
    const MonomialSystem system = monomial_system(supports_);
    const Elimination elimination = order_elimination(system, samples(system, zeros.coefficients));
    LegTracking tracking(system, elimination, request_.setup);
    if (are_of_many_sizes(system)) follow_sizes(tracking, zeros);
    const std::string stage = "paths to " + request_.destination;
    result_.ends = follow_to_end(
        tracking, zeros.zeros, zeros.coefficients, coefficients_, [](const ComplexVectorX&) { return true; },
        stopped_, [&](double fraction) { request_.progress(stage, fraction); }, work_);
    settle(system, coefficients_, request_.setup.threads, result_.ends);
    for (const PathEnd& end : result_.ends)
      result_.counts.at_infinity += end.kind == PathEnd::Kind::at_infinity;
  }

  std::vector<ComplexVectorX> samples(const MonomialSystem& system, const ComplexVectorX& from) {
    constexpr int count = 3;  // at each end
    std::vector<ComplexVectorX> jacobians;
    for (const ComplexVectorX* coefficients : {&from, &coefficients_})
      for (int i = 0; i < count; ++i)
        jacobians.push_back(
            jacobian_at(system, *coefficients, random_complex_vector(system.unknowns, random_)));
    return jacobians;
  }

  const Supports& supports_;
  const ComplexVectorX& coefficients_;
  const SignMasks& signs_;
  const SupportsRequest& request_;
  std::mt19937_64& random_;
  WorkCounters& work_;
  const std::function<bool()> stopped_ = [this] { return request_.stop.stop_requested(); };
  SupportsPaths result_;
};

}  // namespace

SupportsPaths follow_supports(const Supports& supports, const ComplexVectorX& coefficients,
                              const SignMasks& signs, const SupportsRequest& request, std::mt19937_64& random,
                              WorkCounters& work) {
  return Following(supports, coefficients, signs, request, random, work).run();
}

std::string why_not_all(const std::vector<PathEnd>& ends, int distinct, const std::string& destination) {
  std::map<std::string, int> causes;
  int regular = 0;
  for (const PathEnd& end : ends) {
    regular += end.kind == PathEnd::Kind::regular;
    if (end.kind == PathEnd::Kind::failed) ++causes[end.cause];
    if (end.kind == PathEnd::Kind::singular) ++causes["it seems to end at a singular solution"];
  }
  if (regular > distinct)
    return counted(regular - distinct, "path") + " to " + destination + " ended where another had";
  if (causes.empty()) return "";
  const auto& [cause, count] = *causes.begin();
  return counted(count, "path") + " to " + destination + " failed: " + cause;
}

}  // namespace gcs
