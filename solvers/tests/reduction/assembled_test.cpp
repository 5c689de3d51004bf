/// Scenes of bodies that are solved in parts, one after another: counts from theory, and the same solutions as of the scene
/// in one piece.

#include <catch2/catch.hpp>
#include <set>

#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/reduction/compared_answers.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

/// Bodies somewhere, each in a position of its own in the file. Those of `flat` have all their points on a line, in space in
/// a plane, so that they are their own mirror images.
class Assembly {
 public:
  Assembly(int dimension, int bodies, std::uint64_t seed, std::set<int> flat = {})
      : random_(seed), flat_(std::move(flat)) {
    problem_.dimension = dimension;
    for (int body = 0; body < bodies; ++body) {
      problem_.bodies.push_back({"b" + std::to_string(body), {}});
      turns_.push_back(random_turn(dimension, random_));
      shifts_.push_back(random_.point(dimension, 1));
    }
    problem_.reference_body = 0;
  }

  /// Between points of both that they have for these alone.
  void bars(int a, int b, int count) {
    for (int i = 0; i < count; ++i) {
      const int from = point_of({a}), to = point_of({b});
      const double length = (place(from) - place(to)).norm();
      problem_.constraints.push_back(
          {"c" + std::to_string(problem_.constraints.size()), {from, to}, {length, ""}, false});
    }
  }
  void share_point(int a, int b) { point_of({a, b}); }

  ProblemStatement problem(int at_rest = 0) const {
    ProblemStatement result = problem_;
    result.reference_body = at_rest;
    return result;
  }

 private:
  const Eigen::Vector3d& place(int point) const { return places_[static_cast<std::size_t>(point)]; }

  int point_of(const std::vector<int>& bodies) {
    const int point = static_cast<int>(problem_.points.size());
    problem_.points.push_back("p" + std::to_string(point));
    places_.push_back(random_.point(problem_.dimension, 1));
    for (const int body : bodies) {
      const auto i = static_cast<std::size_t>(body);
      Eigen::Vector3d at = turns_[i] * places_.back() + shifts_[i];
      if (flat_.contains(body)) at[problem_.dimension - 1] = 0;
      if (flat_.contains(body)) places_.back() = turns_[i].conjugate() * (at - shifts_[i]);
      BodyElement element{point, {}};
      for (int axis = 0; axis < problem_.dimension; ++axis) element.numbers.push_back({at[axis], ""});
      problem_.bodies[i].elements.push_back(element);
    }
    return point;
  }

  RandomNumbers random_;
  std::set<int> flat_;
  ProblemStatement problem_;
  std::vector<Eigen::Quaterniond> turns_;
  std::vector<Eigen::Vector3d> shifts_;
  std::vector<Eigen::Vector3d> places_;
};

/// Octahedra, each of five points and a plane: all pairs of elements constrained but the opposite ones. The first three
/// points are a face of each.
ProblemStatement octahedra_on_a_face(int count, RandomNumbers& random) {
  ProblemStatement problem;
  std::vector<Eigen::Vector3d> places;
  const auto apart = [&](int a, int b) {
    const double length = (places[static_cast<std::size_t>(a)] - places[static_cast<std::size_t>(b)]).norm();
    problem.constraints.push_back(
        {"c" + std::to_string(problem.constraints.size()), {a, b}, {length, ""}, false});
  };
  for (int i = 0; i < 3 + 2 * count; ++i) {
    problem.points.push_back("p" + std::to_string(i));
    places.push_back(random.point(3, 1));
  }
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) apart(a, b);
  for (int i = 0; i < count; ++i) {
    const int first = 3 + 2 * i;
    apart(1, first);
    apart(2, first);
    apart(0, first + 1);
    apart(2, first + 1);
    apart(first, first + 1);
    problem.planes.push_back("h" + std::to_string(i));
    const Eigen::Vector3d normal = random.point(3, 1).normalized();
    const double offset = random.uniform(-1, 1);
    for (const int point : {0, 1, first, first + 1}) {
      const double distance = normal.dot(places[static_cast<std::size_t>(point)]) - offset;
      problem.relations.push_back({"h" + std::to_string(i) + std::to_string(point),
                                   "distance",
                                   {{point}, {3 + 2 * count + i}},
                                   Relation::Form::length,
                                   {distance, ""}});
    }
  }
  return problem;
}

void check_all_are_proven(const Answer& answer) {
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->are_complete());
}

}  // namespace

TEST_CASE("platforms on one base: the product of their postures") {
  Assembly plane(2, 3, 1);
  plane.bars(0, 1, 3);
  plane.bars(0, 2, 3);
  CHECK(cores_of(plane.problem()) == 2);
  check_same_in_one_piece(plane.problem(), 6 * 6);
  check_all_are_proven(answer_to(plane.problem()));
}

TEST_CASE("platforms on one base in space, all flat: 40 postures each, in a mirror all at once") {
  Assembly space(3, 3, 1, {0, 1, 2});
  space.bars(0, 1, 6);
  space.bars(0, 2, 6);
  const Answer answer = answer_to(space.problem());
  check_count(answer, 40 * 40 / 2);
  check_all_are_proven(answer);
  CHECK(answer.counts.generic == Natural(800));
}

TEST_CASE("a chain of platforms, each on the one before it, whatever body is at rest") {
  Assembly chain(2, 4, 2);
  for (int body = 0; body < 3; ++body) chain.bars(body, body + 1, 3);
  const Answer whole = answer_to(chain.problem(), "off");
  check_count(whole, 6 * 6 * 6);
  for (const int at_rest : {0, 1, 2, 3}) {
    CHECK(cores_of(chain.problem(at_rest)) == 2);
    CHECK(placed_names(chain.problem(at_rest)).empty());
    const Answer answer = answer_to(chain.problem(at_rest));
    check_count(answer, 6 * 6 * 6);
    check_all_are_proven(answer);
    CHECK(answer.work.iterations < whole.work.iterations / 2);
  }
}

TEST_CASE("flat bodies count with their mirror images, unless another body tells these apart") {
  for (const bool is_flat : {true, false}) {
    Assembly chain(2, 3, 5, is_flat ? std::set{0, 1, 2} : std::set{0, 1});
    chain.bars(0, 1, 3);
    chain.bars(1, 2, 3);
    check_same_in_one_piece(chain.problem(), is_flat ? 6 * 6 / 2 : 6 * 6);
  }
}

TEST_CASE("a body on two that hold each other") {
  Assembly scene(2, 3, 3);
  scene.bars(0, 1, 3);
  scene.bars(0, 2, 2);
  scene.bars(1, 2, 1);
  for (const int at_rest : {0, 1, 2}) {
    CHECK(placed_names(scene.problem(at_rest)) == std::vector<std::string>{"b2"});
    check_same_in_one_piece(scene.problem(at_rest), 6 * 6);
  }
  check_all_are_proven(answer_to(scene.problem()));
}

TEST_CASE("a body on three that are hinged to each other, in two ways, in the plane") {
  Assembly scene(2, 4, 4);
  scene.share_point(0, 1);
  scene.share_point(0, 2);
  scene.share_point(1, 2);
  for (const int body : {0, 1, 2}) scene.bars(body, 3, 1);
  CHECK(placed_names(scene.problem()) == std::vector<std::string>{"b3"});
  check_same_in_one_piece(scene.problem(), 2 * 6);
}

TEST_CASE("bodies that hold each other, on others that do, in the plane") {
  Assembly two(2, 4, 8);
  two.bars(0, 1, 3);
  two.bars(2, 3, 3);
  two.bars(0, 2, 1);
  two.bars(1, 2, 1);
  two.bars(1, 3, 1);
  check_count(answer_to(two.problem()), 6 * 6 * 6);
  CHECK(placed_names(two.problem()) == std::vector<std::string>{"b2 and b3"});
  Assembly hinged(2, 4, 9);
  hinged.bars(0, 1, 3);
  hinged.share_point(2, 3);
  for (const auto& [a, b] : {std::pair(0, 2), std::pair(1, 2), std::pair(0, 3), std::pair(1, 3)})
    hinged.bars(a, b, 1);
  const Answer answer = answer_to(hinged.problem());
  CHECK(placed_names(hinged.problem()) == std::vector<std::string>{"b2 and b3"});
  check_same_in_one_piece(hinged.problem(), answer.solutions.size());
}

TEST_CASE("octahedra with a plane on a face of three points: 16 in the frame of these, each") {
  RandomNumbers random(6);
  const ProblemStatement problem = octahedra_on_a_face(2, random);
  CHECK(cores_of(problem) == 2);
  check_count(answer_to(problem), 16 * 16 / 2);
}

TEST_CASE("what is too much for a list is counted by its parts") {
  Assembly chain(2, 7, 7);
  for (int body = 0; body < 6; ++body) chain.bars(body, body + 1, 3);
  const Answer answer = solve(Scene::unchecked(chain.problem()), "monodromy", {}, {.max_solutions = 10});
  CHECK(answer.solutions.size() == 10);
  CHECK(answer.counts.complex_up_to_reflection == Natural(6 * 6 * 6 * 6 * 6 * 6));
}
