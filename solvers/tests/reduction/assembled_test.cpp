/// Scenes of bodies that are solved in parts, one after another: counts from theory, and the same solutions as of the scene
/// in one piece.

#include <catch2/catch.hpp>

#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/reduction/compared_answers.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

/// Bodies somewhere, each in a position of its own in the file.
class Assembly {
 public:
  Assembly(int dimension, int bodies, std::uint64_t seed) : random_(seed) {
    problem_.dimension = dimension;
    for (int body = 0; body < bodies; ++body) {
      problem_.bodies.push_back({"b" + std::to_string(body), {}});
      turns_.push_back(random_turn(dimension, random_));
      shifts_.push_back(random_.point(dimension, 1));
    }
    problem_.reference_body = 0;
  }

  /// Bars between points of both that they have for these alone.
  void bars(int a, int b, int count) {
    for (int i = 0; i < count; ++i) {
      const int from = point_of({a}), to = point_of({b});
      problem_.constraints.push_back(
          {"c" + std::to_string(problem_.constraints.size()),
           {from, to},
           {(places_[static_cast<std::size_t>(from)] - places_[static_cast<std::size_t>(to)]).norm(), ""},
           false});
    }
  }
  void share_point(int a, int b) { point_of({a, b}); }

  ProblemStatement problem() const { return problem_; }

 private:
  int point_of(const std::vector<int>& bodies) {
    const int point = static_cast<int>(problem_.points.size());
    problem_.points.push_back("p" + std::to_string(point));
    places_.push_back(random_.point(problem_.dimension, 1));
    for (const int body : bodies) {
      const auto i = static_cast<std::size_t>(body);
      const Eigen::Vector3d at = turns_[i] * places_.back() + shifts_[i];
      BodyElement element{point, {}};
      for (int axis = 0; axis < problem_.dimension; ++axis) element.numbers.push_back({at[axis], ""});
      problem_.bodies[i].elements.push_back(element);
    }
    return point;
  }

  RandomNumbers random_;
  ProblemStatement problem_;
  std::vector<Eigen::Quaterniond> turns_;
  std::vector<Eigen::Vector3d> shifts_;
  std::vector<Eigen::Vector3d> places_;
};

}  // namespace

TEST_CASE("platforms on one base: the product of their postures, in space and in the plane") {
  Assembly plane(2, 3, 1);
  plane.bars(0, 1, 3);
  plane.bars(0, 2, 3);
  CHECK(cores_of(plane.problem()) == 2);
  check_same_in_one_piece(plane.problem(), 6 * 6);
}

TEST_CASE("a chain of platforms, each on the one before it") {
  for (const int at_rest : {0, 1, 2, 3}) {
    Assembly chain(2, 4, 2);
    for (int body = 0; body < 3; ++body) chain.bars(body, body + 1, 3);
    ProblemStatement problem = chain.problem();
    problem.reference_body = at_rest;
    CHECK(cores_of(problem) == 2);
    check_count(answer_to(problem), 6 * 6 * 6);
  }
}

TEST_CASE("a body on two that hold each other") {
  for (const int at_rest : {0, 1, 2}) {
    Assembly scene(2, 3, 3);
    scene.bars(0, 1, 3);
    scene.bars(0, 2, 2);
    scene.bars(1, 2, 1);
    ProblemStatement problem = scene.problem();
    problem.reference_body = at_rest;
    CHECK(placed_names(problem) == std::vector<std::string>{"b2"});
    check_same_in_one_piece(problem, 6 * 6);
  }
}
