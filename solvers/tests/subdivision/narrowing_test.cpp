/// What narrows a box never loses a solution in it.

#include <catch2/catch.hpp>

#include "solvers/certificates/krawczyk_test.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/subdivision/linear_narrowing.hpp"
#include "solvers/subdivision/square_narrowing.hpp"
#include "solvers/subdivision/start_box.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// A scene with a solution that is known exactly: coordinates of few bits, whose squared distances are doubles.
struct KnownScene {
  ProblemStatement problem;
  Figure figure;
};

double few_bits(double x) { return std::ldexp(std::round(std::ldexp(x, 10)), -10); }

DistanceConstraint squared_distance_of(const std::string& id, std::array<int, 2> between, double square) {
  return {id, between, {square, ""}, true};
}

/// In the frame of the first points.
KnownScene known_points(int dimension, int points, RandomNumbers& random) {
  Eigen::Matrix3Xd placed = random.points(dimension, points, 1).unaryExpr(&few_bits);
  placed.col(0).setZero();
  placed.col(1) = Eigen::Vector3d(std::abs(placed(0, 1)) + 0.125, 0, 0);
  if (dimension == 3) placed.col(2) = Eigen::Vector3d(placed(0, 2), std::abs(placed(1, 2)) + 0.125, 0);
  const samples::Edges edges = samples::random_rigid_graph(dimension, points, random);
  KnownScene known{samples::problem_of(dimension, points, edges, std::vector<double>(edges.size(), 1)),
                   {placed, {}}};
  for (DistanceConstraint& c : known.problem.constraints)
    c = squared_distance_of(c.id, c.between,
                            (placed.col(c.between[0]) - placed.col(c.between[1])).squaredNorm());
  known.problem.reference = Reference{0, 1, dimension == 3 ? 2 : -1};
  return known;
}

/// The line on the x-axis and the first point above it.
KnownScene known_pyramid(RandomNumbers& random) {
  const samples::Edges edges{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {2, 3}, {3, 4}, {4, 1}};
  Eigen::Matrix3Xd placed = random.points(3, 5, 1).unaryExpr(&few_bits);
  placed.col(0) = Eigen::Vector3d(0, 0, std::abs(placed(2, 0)) + 0.125);
  KnownScene known{samples::problem_of(3, 5, edges, std::vector<double>(edges.size(), 1)),
                   {placed, {LinePosition{}}}};
  known.problem.lines = {"L"};
  for (DistanceConstraint& c : known.problem.constraints)
    c = squared_distance_of(c.id, c.between,
                            (placed.col(c.between[0]) - placed.col(c.between[1])).squaredNorm());
  for (int p = 0; p < 5; ++p)
    known.problem.constraints.push_back(
        squared_distance_of("l" + std::to_string(p), {p, 5}, placed.col(p).tail<2>().squaredNorm()));
  known.problem.reference = Reference{.line = 0, .height = 0};
  return known;
}

/// A line along the x-axis beside four given points.
KnownScene known_tangent(RandomNumbers& random) {
  const Eigen::Matrix3Xd centers = random.points(3, 4, 1).unaryExpr(&few_bits);
  Eigen::Vector3d through = random.point(3, 1).unaryExpr(&few_bits);
  through.x() = 0;
  KnownScene known;
  known.figure = {centers, {{through, Eigen::Vector3d::UnitX()}}};
  known.problem.points = {"c1", "c2", "c3", "c4"};
  known.problem.lines = {"L"};
  known.problem.fixed_lines.resize(1);
  for (int p = 0; p < 4; ++p) {
    known.problem.fixed_points.emplace_back(centers.col(p));
    known.problem.constraints.push_back(squared_distance_of(
        "a" + std::to_string(p), {p, 4}, (centers.col(p) - through).tail<2>().squaredNorm()));
  }
  return known;
}

/// The equations of a scene, and the unknowns of its figure with the signs that start_box has.
class KnownSystem {
 public:
  explicit KnownSystem(const KnownScene& known)
      : scene_(Scene::unchecked(known.problem)), of_scene_(scene_), system(of_scene_.system()) {
    const auto x = of_scene_.coordinates(known.figure.scaled(-scene_.unit_exponent()));
    const SignMasks mirror = of_scene_.system().mirror;
    for (const std::complex<double>& coordinate : x) solution.push_back(coordinate.real());
    for (const int unknown : signed_unknowns(scene_, of_scene_)) {
      if (solution[unknown] >= 0) continue;
      for (std::size_t i = 0; i < solution.size(); ++i)
        if (mirror[i] == mirror[unknown]) solution[i] *= -1;
    }
  }

  double size() const { return scene_.size(); }
  IntervalBox start() const { return start_box(scene_, of_scene_); }
  bool is_in(const IntervalBox& box) const {
    for (std::size_t i = 0; i < box.size(); ++i)
      if (!box[i].contains(solution[i])) return false;
    return true;
  }
  /// With the solution inside, of a size up to `width`, or at an end.
  IntervalBox random_box(double width, RandomNumbers& random) const {
    IntervalBox box;
    for (const double x : solution) {
      const double low = random.index(8) == 0 ? 0 : random.uniform(0, width);
      const double high = random.index(8) == 0 ? 0 : random.uniform(0, width);
      box.push_back({x - low, x + high});
    }
    return box;
  }

 private:
  Scene scene_;
  SceneEquations of_scene_;

 public:
  IntervalEquations system;
  std::vector<double> solution;
};

std::vector<KnownScene> known_scenes(RandomNumbers& random) {
  std::vector<KnownScene> scenes;
  for (int i = 0; i < 4; ++i) {
    scenes.push_back(known_points(2, 6 + i, random));
    scenes.push_back(known_points(3, 5 + i, random));
    scenes.push_back(known_pyramid(random));
    scenes.push_back(known_tangent(random));
  }
  return scenes;
}

Box as_box(const IntervalBox& sides) {
  Box box{Eigen::VectorXd(sides.size()), Eigen::VectorXd(sides.size())};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    box.mid[static_cast<Eigen::Index>(i)] = sides[i].middle();
    box.radius[static_cast<Eigen::Index>(i)] = sides[i].reach(sides[i].middle());
  }
  return box;
}

double widths(const IntervalBox& box) {
  double sum = 0;
  for (const Interval& side : box) sum += side.width();
  return sum;
}

}  // namespace

TEST_CASE("the box of a scene holds its solution") {
  RandomNumbers random(2000);
  for (const KnownScene& scene : known_scenes(random)) {
    const KnownSystem known(scene);
    const IntervalBox box = known.start();
    CHECK(known.is_in(box));
    for (const Interval& side : box) CHECK(side.is_finite());
  }
}

TEST_CASE("the frame leaves as many mirror images as there are signs") {
  RandomNumbers random(2001);
  for (const KnownScene& known : known_scenes(random)) {
    if (known.problem.is_anchored()) continue;
    const Scene scene = Scene::unchecked(known.problem);
    const FrameImages images = frame_images(known.problem);
    const auto kinds = signed_unknowns(scene, SceneEquations(scene)).size();
    CHECK(1 << kinds == images.in_frame * images.by_signs);
  }
}

TEST_CASE("no reduction loses a solution") {
  RandomNumbers random(2009);
  int by_equations = 0, linearly = 0, proven = 0, tried = 0;
  for (const KnownScene& scene : known_scenes(random)) {
    const KnownSystem known(scene);
    const KrawczykTest test(known.system, known.size());
    for (int i = 0; i < 60; ++i) {
      ++tried;
      IntervalBox box = known.random_box(std::pow(10, random.uniform(-9, 0.3)), random);
      const double before = widths(box);
      CHECK_FALSE(are_contradictory(known.system, forms_over(known.system, box)));
      const auto image = test.image(as_box(box));
      if (image) CHECK_FALSE(image->misses(as_box(box).radius));
      std::int64_t iterations = 0;
      if (const auto solution = test.only_solution_around(as_box(box), iterations)) {
        ++proven;
        for (std::size_t k = 0; k < box.size(); ++k) {
          const auto j = static_cast<Eigen::Index>(k);
          CHECK(std::abs(known.solution[k] - solution->enclosure.mid[j]) <=
                solution->enclosure.radius[j] * (1 + 1e-9) + 1e-300);
        }
      }

      const auto forms = narrow_by_equations(known.system, box);
      REQUIRE(forms);
      CHECK(known.is_in(box));
      by_equations += widths(box) < 0.9 * before ? 1 : 0;
      IntervalBox at_solution;
      for (const double x : known.solution) at_solution.push_back(exact_interval(x));
      const std::vector<Interval> exact = forms_over(known.system, at_solution);
      for (std::size_t k = 0; k < exact.size(); ++k)
        CHECK_FALSE(intersection(exact[k], (*forms)[k]).is_empty());

      const double between = widths(box);
      LinearWork work;
      CHECK(narrow_linearly(known.system, *forms, box, work));
      CHECK(known.is_in(box));
      linearly += widths(box) < 0.9 * between ? 1 : 0;
    }
  }
  // They do something.
  CHECK(by_equations > tried / 10);
  CHECK(linearly > tried / 3);
  CHECK(proven > tried / 10);
}

TEST_CASE("boxes beside all solutions are found to hold none") {
  RandomNumbers random(2010);
  int tried = 0, emptied = 0;
  for (const KnownScene& scene : known_scenes(random)) {
    const KnownSystem known(scene);
    for (int i = 0; i < 20; ++i) {
      // Small enough that the solution is the only one around, where it is regular.
      IntervalBox box = known.random_box(1e-6, random);
      const auto side = static_cast<std::size_t>(random.index(static_cast<int>(box.size())));
      box[side] = exact_interval(known.solution[side] + 1e-3) + interval_around_zero(1e-6);
      ++tried;
      const auto forms = narrow_by_equations(known.system, box);
      LinearWork work;
      if (!forms || !narrow_linearly(known.system, *forms, box, work)) ++emptied;
    }
  }
  CHECK(emptied > tried * 9 / 10);
}
