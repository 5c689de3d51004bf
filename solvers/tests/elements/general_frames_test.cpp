/// Scenes with given lines and planes, scenes of lines and planes with few points, and parallel planes: their numbers of
/// solutions by geometry.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/tests/elements/checked_counts.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// A scene that can be written in another order of its elements and constraints, and in another unit.
class Draft {
 public:
  Draft(int dimension, std::uint64_t seed) : dimension_(dimension), random_(seed) {}

  Draft& points(std::vector<std::string> names) {
    points_ = std::move(names);
    return *this;
  }
  Draft& lines(std::vector<std::string> names) {
    lines_ = std::move(names);
    return *this;
  }
  Draft& planes(std::vector<std::string> names) {
    planes_ = std::move(names);
    return *this;
  }
  Draft& distance(const std::string& a, const std::string& b, double length) {
    return state([=](Problem& p, double unit) { p.distance(a, b, unit * length); });
  }
  Draft& angle(const std::string& a, const std::string& b, double degrees) {
    return state([=](Problem& p, double) { p.angle(a, b, degrees); });
  }
  Draft& on(const std::string& a, const std::string& b) {
    return state([=](Problem& p, double) { p.on(a, b); });
  }
  Draft& parallel(const std::string& a, const std::string& b) {
    return state([=](Problem& p, double) { p.parallel(a, b); });
  }
  Draft& perpendicular(const std::string& a, const std::string& b) {
    return state([=](Problem& p, double) { p.perpendicular(a, b); });
  }
  /// At random, near `where`.
  Draft& fix_point(const std::string& name, const Eigen::Vector3d& where) {
    const Eigen::Vector3d at = near(where);
    return state([=, d = dimension_](Problem& p, double unit) {
      if (d == 2)
        p.fix(name, {unit * at[0], unit * at[1]});
      else
        p.fix(name, {unit * at[0], unit * at[1], unit * at[2]});
    });
  }
  Draft& fix_line(const std::string& name, const Eigen::Vector3d& through, const Eigen::Vector3d& along) {
    const Eigen::Vector3d at = near(through), to = near(along);
    return state([=, d = dimension_](Problem& p, double unit) {
      if (d == 2)
        p.fix(name, {unit * at[0], unit * at[1]}, {to[0], to[1]});
      else
        p.fix(name, {unit * at[0], unit * at[1], unit * at[2]}, {to[0], to[1], to[2]});
    });
  }
  Draft& fix_plane(const std::string& name, const Eigen::Vector3d& across, double offset) {
    const Eigen::Vector3d normal = near(across);
    return state([=](Problem& p, double unit) {
      p.fix(name, {normal[0], normal[1], normal[2]}, unit * offset);
    });
  }
  /// A body of four points, as they stand or nearly.
  Draft& body(const std::vector<std::string>& names, bool is_exact = true) {
    Eigen::Matrix<double, 3, 4> at;
    at << 0, 1, 0.3, 0.2, 0, 0, 0.9, 0.4, 0, 0, 0, 0.8;
    for (int i = 0; i < 4; ++i)
      if (!is_exact || i > 1) at.col(i) = near(at.col(i));
    return state([=](Problem& p, double unit) {
      const auto placed = [&](int i) {
        return Placed(names[static_cast<std::size_t>(i)],
                      {unit * at(0, i), unit * at(1, i), unit * at(2, i)});
      };
      p.body("body", {placed(0), placed(1), placed(2), placed(3)});
    });
  }
  Draft& fix_exactly(const std::string& name, std::array<double, 3> at) {
    return state([=](Problem& p, double unit) { p.fix(name, {unit * at[0], unit * at[1], unit * at[2]}); });
  }

  Problem problem(double unit, bool is_reversed) const {
    Problem result(dimension_);
    for (const std::string& name : in_order(points_, is_reversed)) result.points(name);
    for (const std::string& name : in_order(lines_, is_reversed)) result.lines(name);
    for (const std::string& name : in_order(planes_, is_reversed)) result.planes(name);
    for (const auto& statement : in_order(statements_, is_reversed)) statement(result, unit);
    return result;
  }

 private:
  using Statement = std::function<void(Problem&, double)>;

  Draft& state(Statement statement) {
    statements_.push_back(std::move(statement));
    return *this;
  }
  Eigen::Vector3d near(const Eigen::Vector3d& where) { return where + random_.point(dimension_, 0.1); }
  template <class Value>
  static std::vector<Value> in_order(std::vector<Value> values, bool is_reversed) {
    if (is_reversed) std::ranges::reverse(values);
    return values;
  }

  int dimension_;
  RandomNumbers random_;
  std::vector<std::string> points_, lines_, planes_;
  std::vector<Statement> statements_;
};

std::ptrdiff_t real_solutions(const Answer& answer) {
  return std::ranges::count_if(answer.solutions, [](const AssessedSolution& s) { return s.is_real(); });
}

/// The count by two homotopies in two orders and units, and the real ones among them by Newton's method from random starts.
void check_counts(const Draft& draft, std::size_t count, bool has_real = true) {
  for (const auto& [unit, is_reversed] : {std::pair(1.0, false), std::pair(0x1p-30, true)}) {
    const Scene scene = draft.problem(unit, is_reversed);
    INFO("in a unit of " << unit);
    const Answer loops = solve(scene, Monodromy{.seed = 3, .certify = true});
    samples::check_proven(loops, count);
    samples::check_proven(solve(scene, Polyhedral{.seed = 3, .certify = true}), count);
    const Answer some = solve(scene, NewtonMultistart{.seed = 3});
    CHECK(real_solutions(some) == real_solutions(loops));
    if (has_real) CHECK(real_solutions(loops) > 0);
  }
}

const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), nothing(0, 0, 0);

}  // namespace

TEST_CASE("a point at distances from a given line, a given plane and a given point, Bézout's 2 · 1 · 2") {
  check_counts(Draft(3, 1)
                   .points({"p", "q"})
                   .lines({"L"})
                   .planes({"E"})
                   .fix_point("q", nothing)
                   .fix_line("L", nothing, z)
                   .fix_plane("E", z, 0.4)
                   .distance("p", "L", 0.8)
                   .distance("p", "E", 0.1)
                   .distance("p", "q", 0.95),
               4);
}

TEST_CASE("points beside a given line and given points alone, 4 for each, a cylinder and two spheres") {
  check_counts(Draft(3, 2)
                   .points({"p", "q", "r", "s"})
                   .lines({"L"})
                   .fix_point("q", nothing)
                   .fix_point("r", x)
                   .fix_line("L", nothing, z)
                   .distance("p", "L", 0.8)
                   .distance("p", "q", 1)
                   .distance("p", "r", 0.9)
                   .distance("s", "L", 0.7)
                   .distance("s", "q", 1.1)
                   .distance("s", "p", 0.5),
               16);
}

TEST_CASE("a point on a given line at a distance from a given point, 2; from a given line, 2") {
  check_counts(Draft(3, 3)
                   .points({"p", "q", "r"})
                   .lines({"L", "M"})
                   .fix_point("q", nothing)
                   .fix_line("L", nothing, x)
                   .fix_line("M", 0.3 * z, y)
                   .on("p", "L")
                   .distance("p", "q", 1)
                   .on("r", "M")
                   .distance("r", "L", 1),
               4);
}

TEST_CASE("a line in a given plane at distances from two given points, the four tangents of two circles") {
  check_counts(Draft(3, 4)
                   .points({"p", "q"})
                   .lines({"L"})
                   .planes({"E"})
                   .fix_point("p", nothing)
                   .fix_point("q", 3 * x)
                   .fix_plane("E", z, 0.2)
                   .on("L", "E")
                   .distance("p", "L", 0.9)
                   .distance("q", "L", 0.7),
               4);
}

TEST_CASE("planes across a given line and beside given planes lie on either side") {
  const auto draft = [] {
    return Draft(3, 5)
        .points({"p"})
        .lines({"L"})
        .planes({"E", "F", "G"})
        .fix_point("p", nothing)
        .fix_line("L", y, x);
  };
  check_counts(draft()
                   .fix_plane("E", z, 0.5)
                   .perpendicular("L", "F")
                   .distance("p", "F", 0.3)
                   .parallel("E", "G")
                   .distance("p", "G", -0.4),
               4);
  check_counts(draft()
                   .fix_plane("E", z, 0.5)
                   .perpendicular("L", "F")
                   .on("p", "F")
                   .parallel("F", "G")
                   .distance("F", "G", 0.3),
               2);
}

TEST_CASE("planes at angles to given planes, through a given point, two") {
  check_counts(Draft(3, 6)
                   .points({"p"})
                   .planes({"E", "F", "G"})
                   .fix_point("p", nothing)
                   .fix_plane("E", x, 0)
                   .fix_plane("F", y, 0)
                   .on("p", "G")
                   .angle("E", "G", 70)
                   .angle("F", "G", 50),
               2);
}

TEST_CASE("in the plane, a point at distances from a given line and a given point, 2 · 2") {
  check_counts(Draft(2, 7)
                   .points({"p", "q"})
                   .lines({"L"})
                   .fix_point("q", nothing)
                   .fix_line("L", nothing, x)
                   .distance("p", "L", 0.8)
                   .distance("p", "q", 1.2),
               4);
}

TEST_CASE(
    "a body with a given point and three legs to given points: the degree of SO(3); with two, a hinge: 2") {
  Draft legs(3, 8);
  legs.points({"p", "q", "r"}).body({"a", "b", "c", "d"}, false);
  legs.fix_exactly("a", {0, 0, 0}).fix_point("p", 2 * x).fix_point("q", 2 * y).fix_point("r", 2 * z);
  check_counts(legs.distance("p", "b", 1.2).distance("q", "c", 1.3).distance("r", "d", 1.4), 8, false);
  Draft hinge(3, 9);
  hinge.points({"p"}).body({"a", "b", "c", "d"});
  hinge.fix_exactly("a", {0, 0, 1}).fix_exactly("b", {0, 0, 2}).fix_point("p", x + z);
  check_counts(hinge.distance("p", "d", 1), 2);
}

TEST_CASE("planes that are parallel to each other and seen from sides may lie either way") {
  const auto draft = [](const std::string& first, const std::string& second) {
    Draft result(3, 10);
    result.points({"p", "q", "r"}).planes({"E", "F"});
    result.distance("p", "q", 1.5).distance("q", "r", 1.4).distance("r", "p", 1.3);
    result.distance("p", "E", 0.5).distance("q", "E", -0.4).distance("r", "E", 0.3);
    return result.parallel("E", "F").distance(first, second, 0.7);
  };
  // One plane E but for its mirror image; whether F goes along with it is seen from F alone.
  check_counts(draft("E", "F"), 1);
  check_counts(draft("F", "E"), 2);
}

TEST_CASE(
    "three lines, all distances and angles: two triples of directions, eight signs, up to the point "
    "reflection") {
  const auto lines = [](Draft result) {
    result.distance("K", "L", 0.5).distance("L", "M", 0.6).distance("M", "K", 0.7);
    return result.angle("K", "L", 60).angle("L", "M", 70).angle("M", "K", 80);
  };
  check_counts(lines(Draft(3, 11).lines({"K", "L", "M"})), 8);
  // Three cylinders meet in 8 points.
  const Scene with_point = lines(Draft(3, 12).points({"p"}).lines({"K", "L", "M"}))
                               .distance("p", "K", 0.9)
                               .distance("p", "L", 0.8)
                               .distance("p", "M", 1)
                               .problem(1, false);
  samples::check_proven(solve(with_point, Monodromy{.seed = 3, .certify = true}), 64);
}

TEST_CASE("lines beside a plane, eight by their signs, of which four are one up to reflection") {
  check_counts(Draft(3, 13)
                   .lines({"L", "M"})
                   .planes({"E"})
                   .distance("L", "M", 0.6)
                   .angle("L", "M", 60)
                   .parallel("L", "E")
                   .distance("L", "E", 0.5)
                   .angle("M", "E", 30),
               2);
}

TEST_CASE("planes at angles, alone or with one or two points at distances, one up to reflection") {
  const auto planes = [](Draft result) {
    return result.angle("E", "F", 60).angle("F", "G", 70).angle("G", "E", 80);
  };
  check_counts(planes(Draft(3, 14).planes({"E", "F", "G"})), 1);
  check_counts(planes(Draft(3, 15).points({"p"}).planes({"E", "F", "G"}))
                   .distance("p", "E", 0.3)
                   .distance("p", "F", -0.4)
                   .distance("p", "G", 0.5),
               1);
  check_counts(Draft(3, 16)
                   .points({"p", "q"})
                   .planes({"E", "F"})
                   .angle("E", "F", 75)
                   .distance("p", "q", 1)
                   .distance("p", "E", 0.3)
                   .distance("q", "E", -0.2)
                   .distance("p", "F", 0.4)
                   .distance("q", "F", 0.1),
               1);
}

TEST_CASE("in the plane, lines alone or with a point, four by their signs, up to the half-turn") {
  check_counts(Draft(2, 17)
                   .points({"p"})
                   .lines({"L", "M"})
                   .angle("L", "M", 50)
                   .distance("p", "L", 0.5)
                   .distance("p", "M", 0.7),
               2);
  check_counts(Draft(2, 18)
                   .lines({"K", "L", "M", "N"})
                   .parallel("K", "L")
                   .distance("K", "L", 0.5)
                   .parallel("M", "N")
                   .distance("M", "N", 0.7)
                   .angle("K", "M", 50),
               2);
}

// A position that leaves motions: figures that such a motion carries into each other are one, mirror images two.

TEST_CASE("a triangle of which one corner is given, in the plane: itself and its mirror image") {
  check_counts(Draft(2, 21)
                   .points({"p", "q", "r"})
                   .fix_point("q", x)
                   .distance("p", "q", 1)
                   .distance("p", "r", 1.2)
                   .distance("q", "r", 0.9),
               2);
}

TEST_CASE("a triangle at distances from a given plane: itself and its mirror image") {
  check_counts(Draft(3, 22)
                   .points({"p", "q", "r"})
                   .planes({"E"})
                   .fix_plane("E", z, 0.4)
                   .distance("p", "q", 1)
                   .distance("p", "r", 1.2)
                   .distance("q", "r", 0.9)
                   .distance("p", "E", 0.3)
                   .distance("q", "E", 0.5)
                   .distance("r", "E", -0.1),
               2);
}
