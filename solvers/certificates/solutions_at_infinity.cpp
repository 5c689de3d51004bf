#include "solvers/certificates/solutions_at_infinity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "solvers/certificates/certificate.hpp"
#include "solvers/certificates/coincidences.hpp"
#include "solvers/certificates/equations_at_infinity.hpp"
#include "solvers/elements/dense_equations.hpp"
#include "solvers/numeric/rounding.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

using Point = std::vector<std::complex<double>>;

/// Sets of points that may be at infinity together, those of them that are tried for a solution, and frames. There are more
/// where lengths are equal in many ways.
constexpr std::size_t most_guesses = 32, most_tries = 8, most_frames = 32;

/// Another frame is chosen by so many solutions that are not proven in the first one.
constexpr std::size_t sample_size = 8;

/// Newton's method in doubles, until rounding keeps it from coming nearer. Nothing where it does not settle, or moves an
/// unknown by many times their size.
std::optional<Point> settled(const DenseEquations& system, const Point& start) {
  constexpr int most_steps = 40;
  constexpr double settled_change = 1e-5, far = 16;
  Point x = start;
  Eigen::Map<Eigen::VectorXcd> at(x.data(), system.unknowns());
  const Eigen::Map<const Eigen::VectorXcd> from(start.data(), system.unknowns());
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXcd change = system.jacobian(x).partialPivLu().solve(system.residuals(x).value);
    at -= change;
    const double size = 1 + at.cwiseAbs().maxCoeff(), length = change.cwiseAbs().maxCoeff();
    if (!((at - from).cwiseAbs().maxCoeff() <= far * size)) return std::nullopt;
    if (length <= settled_change * size && (length > last / 2 || length <= epsilon * size)) return x;
    last = length;
  }
  return std::nullopt;
}

/// One solution, of a guess.
struct AtInfinity {
  std::size_t guess = 0;
  Point place;
  Enclosure marks;  ///< of the unknowns that tell solutions apart
  int bits = 0;
};

/// The equations around solutions with certain points at infinity.
struct Guess {
  explicit Guess(EquationsAtInfinity from)
      : equations(std::move(from)), at_infinity(equations.at_infinity()), around(equations.around()) {
    for (const Escape& escape : equations.escapes())
      points.insert(escape.points.begin(), escape.points.end());
  }

  /// How much farther than those that stay the points are that escape.
  double gap(const ComplexPoints& places) const {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (int point = 0; point < places.cols(); ++point) {
      const double size = places.col(point).cwiseAbs().maxCoeff();
      if (points.contains(point))
        nearest = std::min(nearest, size);
      else
        farthest = std::max(farthest, size);
    }
    return nearest / farthest;
  }

  EquationsAtInfinity equations;
  Certifier at_infinity;
  Certifier around;
  std::set<int> points{};  ///< that escape
};

/// Whether the one zero of `around` is (y, 0) for the zero y in the other enclosure.
bool is_that_zero(const Enclosure& at_infinity, const Enclosure& around) {
  constexpr double margin = 1 + 8 * epsilon;
  for (std::size_t i = 0; i < around.mid.size(); ++i) {
    const bool is_w = i >= at_infinity.mid.size();
    const double offset =
        is_w ? std::abs(around.mid[i])
             : std::abs(around.mid[i] - at_infinity.mid[i]) + std::abs(at_infinity.radius[i]);
    if (!(offset * margin < around.unique)) return false;
  }
  return true;
}

bool is_that_zero(const BallKrawczyk::Proof& at_infinity, const BallKrawczyk::Proof& around, slong bits) {
  Ball offset;
  for (slong i = 0; i < around.solution.rows(); ++i) {
    acb_get_mid(offset, around.solution(i, 0));
    if (i < at_infinity.solution.rows()) acb_sub(offset, offset, at_infinity.solution(i, 0), bits);
    if (!(magnitude(offset) < around.unique)) return false;
  }
  return true;
}

/// Proofs in one frame.
class FrameOfInfinity {
 public:
  FrameOfInfinity(const Scene& scene, const Reference& frame, const std::vector<ClosedWalk>& walks)
      : frame_(frame) {
    const std::vector<Escape> all = escapes(scene, frame, walks);
    std::vector<std::pair<std::vector<Escape>, std::size_t>> sets{
        {{}, 0}};  // and the first that may be added
    for (std::size_t i = 0; i < sets.size(); ++i)
      for (std::size_t next = sets[i].second; next < all.size() && guesses_.size() < most_guesses; ++next) {
        std::vector<Escape> more = sets[i].first;
        more.push_back(all[next]);
        if (!EquationsAtInfinity::know(scene, frame, more)) continue;
        guesses_.push_back(std::make_unique<Guess>(EquationsAtInfinity(scene, frame, more)));
        sets.emplace_back(std::move(more), next + 1);
      }
  }

  /// At the solution next to a figure.
  std::optional<AtInfinity> prove(const Figure& near) const {
    // Of points far away doubles lose the distances on the way to another frame.
    const ComplexPoints points = narrowed(in_frame(widened(complex_points(near)), frame_));
    if (!points.allFinite()) return std::nullopt;
    std::vector<std::size_t> order(guesses_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return guesses_[a]->gap(points) > guesses_[b]->gap(points);
    });
    order.resize(std::min(order.size(), most_tries));
    for (const std::size_t guess : order)
      if (auto proven = prove(guess, points)) return proven;
    return std::nullopt;
  }

  /// Of those that are not proven to be different one counts. In one frame they differ where their points at infinity do.
  std::vector<const AtInfinity*> different(const std::vector<std::optional<AtInfinity>>& all) const {
    std::map<std::set<int>, std::vector<const AtInfinity*>> alike;
    for (const auto& one : all)
      if (one) alike[guesses_[one->guess]->points].push_back(&*one);
    std::vector<const AtInfinity*> result;
    for (const auto& [points, solutions] : alike) append_different(solutions, result);
    return result;
  }

  const Reference& frame() const { return frame_; }
  const std::vector<Escape>& way(const AtInfinity& solution) const {
    return guesses_[solution.guess]->equations.escapes();
  }

  std::optional<DyadicBox> box(const AtInfinity& solution) const {
    const Guess& guess = *guesses_[solution.guess];
    std::optional<DyadicBox> box = dyadic_box(guess.at_infinity, guess.around, solution.place);
    if (!box) return std::nullopt;
    // The sums of squared distances say nothing new.
    const auto marks = box->numbers.begin() + std::ssize(guess.equations.mirror());
    box->numbers.erase(marks - std::ssize(guess.equations.escapes()), marks);
    return box;
  }

 private:
  /// Of the same points at infinity. Where these escape together in other ways, the marks of those that stay have to tell.
  void append_different(const std::vector<const AtInfinity*>& solutions,
                        std::vector<const AtInfinity*>& result) const {
    const EquationsAtInfinity& first = guesses_[solutions.front()->guess]->equations;
    const bool is_one_way = std::ranges::all_of(solutions, [&](const AtInfinity* solution) {
      return guesses_[solution->guess]->equations.is_escape_of_same_points(first);
    });
    const std::size_t marks =
        is_one_way ? first.mirror().size() : first.mirror().size() - first.escapes().size();
    SignMasks mirror;
    for (std::size_t i = 0; i < marks; ++i) mirror.push_back(first.mirror()[i]);
    std::vector<Enclosure> places;
    for (const AtInfinity* solution : solutions) {
      places.push_back(solution->marks);
      places.back().mid.resize(marks);
      places.back().radius.resize(marks);
    }
    std::set<int> same;
    for (const Coincidence& pair : coincidences(places, mirror)) same.insert(pair.second);
    for (std::size_t i = 0; i < solutions.size(); ++i)
      if (!same.contains(static_cast<int>(i))) result.push_back(solutions[i]);
  }

  std::optional<AtInfinity> prove(std::size_t number, const ComplexPoints& points) const {
    const Guess& guess = *guesses_[number];
    const Point near = guess.equations.unknowns_near(points);
    const auto start = settled(DenseEquations(guess.at_infinity.system()), near);
    if (!start) return std::nullopt;
    const Certificate at_infinity = guess.at_infinity.certify(*start);
    if (!at_infinity.is_proven || !guess.equations.holds_solution(at_infinity.enclosure)) return std::nullopt;
    const std::optional<int> bits = regular_in_bits(guess, at_infinity.enclosure);
    if (!bits) return std::nullopt;
    AtInfinity result{number, at_infinity.enclosure.mid, at_infinity.enclosure,
                      std::max(at_infinity.bits, *bits)};
    result.marks.mid.resize(guess.equations.mirror().size());
    result.marks.radius.resize(guess.equations.mirror().size());
    return result;
  }

  /// The precision in which the solution is proven to be a regular zero of all equations around it.
  static std::optional<int> regular_in_bits(const Guess& guess, const Enclosure& at_infinity) {
    Point x = at_infinity.mid;
    x.resize(static_cast<std::size_t>(guess.around.system().unknowns));
    const Certificate around = guess.around.certify(x);
    if (!around.is_proven) return std::nullopt;
    if (is_that_zero(at_infinity, around.enclosure)) return around.bits;
    for (const slong bits : ball_precisions) {
      const auto inner = guess.at_infinity.prove(at_infinity.mid, bits), outer = guess.around.prove(x, bits);
      if (inner && outer && is_that_zero(*inner, *outer, bits)) return static_cast<int>(bits);
    }
    return std::nullopt;
  }

  Reference frame_;
  std::vector<std::unique_ptr<Guess>> guesses_;
};

/// That of the scene, and all of three points at given distances.
std::vector<Reference> frames_of(const Scene& scene) {
  std::vector<Reference> frames{scene.reference()};
  const Neighbours joined = neighbours_of(scene);
  const auto of = [&](int point) -> const std::map<int, int>& {
    return joined[static_cast<std::size_t>(point)];
  };
  for (int a = 0; a < scene.point_count(); ++a)
    for (auto b = of(a).upper_bound(a); b != of(a).end(); ++b)
      for (auto c = of(a).upper_bound(b->first); c != of(a).end(); ++c)
        if (of(b->first).contains(c->first) && frames.size() < most_frames)
          frames.push_back(Reference{a, b->first, c->first});
  return frames;
}

/// Empty where solutions at infinity are known of the scene.
std::string why_not_known(const Scene& scene) {
  if (scene.dimension() < 3 || scene.has_lines() || scene.is_anchored() || scene.problem().is_general())
    return "they are known of free points in space alone";
  return "";
}

/// What is proven in one frame, of each figure.
struct FrameProofs {
  FrameProofs(const Scene& scene, const Reference& reference, const std::vector<ClosedWalk>& walks,
              const std::vector<Figure>& near, int threads, const std::stop_token& stop)
      : frame(scene, reference, walks), all(near.size()) {
    share_on_threads(near.size(), threads, [&](std::size_t i) {
      if (stop.stop_requested()) return;
      all[i] = frame.prove(near[i]);
    });
  }

  std::ptrdiff_t count() const {
    return std::ranges::count_if(all, [](const auto& one) { return one.has_value(); });
  }

  FrameOfInfinity frame;
  std::vector<std::optional<AtInfinity>> all;
};

/// In the first frame in which the most are proven.
struct BestProofs {
  std::string why_none;  ///< in words; empty where there are proofs
  std::optional<FrameProofs> proofs{};
};

/// `near` is not empty.
BestProofs best_proofs(const Scene& scene, const std::vector<Figure>& near, int threads,
                       const std::stop_token& stop) {
  if (std::string why = why_not_known(scene); !why.empty()) return {std::move(why)};
  const std::vector<ClosedWalk> walks = closed_walks(scene);
  if (walks.empty()) return {"no closed walk of given distances sums to 0 with any signs"};
  const std::vector<Reference> frames = frames_of(scene);
  const auto proofs_in = [&](const Reference& frame, const std::vector<Figure>& figures) {
    return FrameProofs(scene, frame, walks, figures, threads, stop);
  };
  FrameProofs best = proofs_in(frames.front(), near);
  std::vector<Figure> missing;
  for (std::size_t i = 0; i < near.size() && missing.size() < sample_size; ++i)
    if (!best.all[i]) missing.push_back(near[i]);
  std::ptrdiff_t most = 0;
  std::optional<Reference> other;
  for (std::size_t i = 1; i < frames.size() && most < std::ssize(missing) && !stop.stop_requested(); ++i) {
    const std::ptrdiff_t proven = proofs_in(frames[i], missing).count();
    if (proven > most) other = frames[i];
    most = std::max(most, proven);
  }
  if (other) {
    FrameProofs there = proofs_in(*other, near);
    if (there.count() > best.count()) best = std::move(there);
  }
  return {"", std::move(best)};
}

}  // namespace

ProvenAtInfinity prove_at_infinity(const Scene& scene, const std::vector<Figure>& near, int threads,
                                   const std::stop_token& stop) {
  ProvenAtInfinity result;
  if (near.empty()) return result;
  const BestProofs best = best_proofs(scene, near, threads, stop);
  result.why_not_all = best.why_none;
  if (!best.proofs) return result;
  result.classes = best.proofs->frame.different(best.proofs->all).size();
  for (const auto& one : best.proofs->all)
    if (one) result.most_bits = std::max(result.most_bits, one->bits);
  if (result.classes < near.size())
    result.why_not_all =
        "in no frame is each found to be a simple solution with points next to others in isotropic planes";
  return result;
}

DyadicAtInfinity dyadic_at_infinity(const Scene& scene, const std::vector<Figure>& near, int threads) {
  DyadicAtInfinity result;
  const BestProofs best = near.empty() ? BestProofs() : best_proofs(scene, near, threads, {});
  if (!best.proofs) return result;
  const FrameOfInfinity& frame = best.proofs->frame;
  result.frame = frame.frame();
  const std::vector<const AtInfinity*> different = frame.different(best.proofs->all);
  std::vector<std::optional<DyadicBox>> boxes(different.size());
  share_on_threads(different.size(), threads, [&](std::size_t i) { boxes[i] = frame.box(*different[i]); });
  std::map<std::size_t, std::size_t> way_of;  // by guess
  for (std::size_t i = 0; i < different.size(); ++i) {
    if (!boxes[i]) continue;
    const auto [way, is_new] = way_of.emplace(different[i]->guess, result.ways.size());
    if (is_new) result.ways.push_back(frame.way(*different[i]));
    result.solutions.push_back({way->second, *std::move(boxes[i])});
  }
  return result;
}

}  // namespace gcs
