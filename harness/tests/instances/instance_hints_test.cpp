/// The parts of an instance that say where things are and how to go about solving.

#include <catch2/catch.hpp>

#include "harness/tests/instances/instance_samples.hpp"

using namespace gcs::samples;
using nlohmann::json;

TEST_CASE("a reference in space names three points or a line and a height") {
  const json points = {{"origin", "p2"}, {"axis", "p1"}, {"plane", "p4"}};
  CHECK(parsed(with(space(), "/reference", points)).problem.reference->plane == 3);
  const auto line = parsed(with(space(), "/reference", {{"line", "L"}, {"height", "p2"}})).problem.reference;
  CHECK(line->line == 0);
  CHECK(line->height == 1);
  CHECK(line->origin == -1);
}

TEST_CASE("a plan may leave out the points that the frame gives") {
  const json whole = plane()["construction"];
  for (const json& plan : {json::array({whole[2]}), json::array({whole[1], whole[2]})}) {
    const gcs::ProblemStatement problem = parsed(with(plane(), "/construction", plan)).problem;
    REQUIRE(problem.construction.size() == 3);
    CHECK(problem.construction[0].place == 0);
    CHECK(problem.construction[0].from.empty());
    CHECK(problem.construction[1].place == 1);
    CHECK(problem.construction[1].from.at(0).constraint == 0);
    CHECK(problem.construction[2].from.size() == 2);
  }
  CHECK(parsed(with(plane(), "/construction", json::array())).problem.construction.empty());
}

TEST_CASE("a plan may have driving parameters and then leaves constraints out") {
  const gcs::ProblemStatement problem = parsed(with(plane(), "/construction/2/from/1/1", "k1")).problem;
  CHECK(problem.construction[2].from[1].constraint == -1);
  CHECK(problem.construction[2].from[1].driving == "k1");
}

TEST_CASE("fixed positions are refused when they do not make sense") {
  check_refused(with(tangents(), "/fixed/p9", {0, 0, 0}), "/fixed/p9", "no point or line 'p9'");
  check_refused(with(tangents(), "/fixed/p1", {0, 0}), "/fixed/p1", "exactly 3");
  check_refused(with(space(), "/fixed", {{"p1", {0, 0, 0}}, {"p2", {0, 0, 0}}, {"p3", {0, 1, 0}}}), "/fixed",
                "'p1' and 'p2' are fixed at the same place");
  check_refused(with(tangents(), "/reference", {{"line", "L"}, {"height", "p1"}}), "/reference", "exclude");
  check_refused(with(tangents(), "/fixed/p4", nullptr), "/fixed", "free ones ('p4')");
  check_refused(with(plane(), "/fixed", {{"p1", {0, 0}}}), "/fixed", "movable as a whole");
  check_refused(
      with(space(), "/fixed", {{"p1", {0.1, 0.2, 0.3}}, {"p2", {0.2, 0.4, 0.6}}, {"p3", {0.3, 0.6, 0.9}}}),
      "/fixed", "not all on one line");
  check_refused(with(plane(), "/fixed", {{"p1", {0, 0}}, {"p2", {3, 0}}}), "/constraints/0/between",
                "both fixed");
}

TEST_CASE("a line may be sought from four points wherever they are") {
  const json coincident = with(tangents(), "/fixed/p1", {1, -1, -1});
  CHECK(parsed(coincident).problem.fixed_points[0] == Eigen::Vector3d(1, -1, -1));
  json collinear = tangents();
  for (int i = 1; i <= 4; ++i) collinear["fixed"]["p" + std::to_string(i)] = {i, 2 * i, 0};
  CHECK(parsed(collinear).problem.fixed_points[3] == Eigen::Vector3d(4, 8, 0));
  SECTION("but not with a fifth point") {
    collinear["points"].push_back("p5");
    collinear["fixed"]["p5"] = {5, 10, 0};
    check_refused(collinear, "/fixed", "not all on one line");
  }
  SECTION("but not without one of the distances") {
    check_refused(with(coincident, "/constraints/3", nullptr), "/constraints", "under-constrained");
  }
  SECTION("but not at the same place with different distances") {
    check_refused(with(coincident, "/constraints/0/length", 0.7), "/constraints/0",
                  "no figure has these lengths");
  }
}

TEST_CASE("fixed lines hold a figure together with a point off them") {
  json document = with(space(), "/fixed", {{"L", {{"point", {0, 0, 0}}, {"direction", {0, 0, 0}}}}});
  check_refused(document, "/fixed/L/direction", "direction is zero");
  document["fixed"]["L"]["direction"] = {1, 0, 0};
  check_refused(document, "/fixed", "movable as a whole");
  document["fixed"]["p1"] = {5, 0, 0};
  check_refused(document, "/fixed", "movable as a whole");
  document["fixed"]["p1"] = {5, 1, 0};
  check_refused(document, "/constraints/6/between", "both fixed");
}

TEST_CASE("a reference that is no frame is refused") {
  const json points = {{"origin", "p1"}, {"axis", "p2"}, {"plane", "p3"}};
  check_refused(with(plane(), "/reference/axis", "p9"), "/reference/axis", "no point 'p9'");
  check_refused(with(plane(), "/reference/axis", "p1"), "/reference", "named twice");
  check_refused(with(plane(), "/reference/axis", nullptr), "/reference", "'axis' is missing");
  check_refused(with(plane(), "/reference/plane", "p3"), "/reference/plane", "no plane point");
  check_refused(with(plane(), "/reference", {{"line", "L"}, {"height", "p1"}}), "/reference", "no line");
  check_refused(with(plane(), "/reference", "p1"), "/reference", "an object is needed");
  const json in_space = with(space(), "/reference", points);
  check_refused(with(in_space, "/reference/plane", nullptr), "/reference", "'plane' is missing");
  check_refused(with(in_space, "/reference/plane", "p2"), "/reference", "named twice");
  check_refused(with(in_space, "/reference/plane", "L"), "/reference/plane", "'L' is a line");
  check_refused(with(in_space, "/reference/line", "L"), "/reference", "mixes");
  check_refused(with(space(), "/reference", {{"line", "L"}}), "/reference", "'height' is missing");
  check_refused(with(space(), "/reference", {{"line", "p1"}, {"height", "p1"}}), "/reference/line",
                "is a point");
}

TEST_CASE("an incomplete or unusable sketch is refused") {
  check_refused(with(plane(), "/sketch/p2", nullptr), "/sketch", "no position for 'p2'");
  check_refused(with(space(), "/sketch/L", nullptr), "/sketch", "no position for 'L'");
  check_refused(with(plane(), "/sketch/p9", {0, 0}), "/sketch/p9", "did you mean 'p1'?");
  check_refused(with(plane(), "/sketch/p2", {0, 0, 0}), "/sketch/p2", "exactly 2");
  check_refused(with(space(), "/sketch/p2", {0, 0}), "/sketch/p2", "exactly 3");
  check_refused(with(plane(), "/sketch/p2", {0, "0"}), "/sketch/p2/1", "a number is needed");
  check_refused(with(plane(), "/sketch/p3", {2, 0}), "/sketch", "'p2' and 'p3' of 'a3'");
  check_refused(with(plane(), "/sketch/p3", {7, 0}), "/sketch", "on one line");
  check_refused(with(space(), "/sketch/L", {{"point", {0, 0, 3}}, {"direction", {0, 0, 1}}}), "/sketch",
                "'p1' and 'L' of 'a7'");
  check_refused(with(space(), "/sketch/L/direction", {0, 0, 0}), "/sketch/L/direction", "direction is zero");
}

TEST_CASE("a sketch in space must not be flat and must show the frame") {
  json flat = bipyramid();
  CHECK(parsed(flat).problem.sketch.has_value());
  flat["sketch"]["p4"] = {3, 3, 0};
  flat["sketch"]["p5"] = {3, 4, 0};
  check_refused(flat, "/sketch", "in one plane");
  json degenerate = with(bipyramid(), "/sketch/p3", {-4, 0, 0});
  check_refused(degenerate, "/sketch", "'p1', 'p2' and 'p3' are on one line");
  degenerate["reference"] = {{"origin", "p1"}, {"axis", "p2"}, {"plane", "p4"}};
  CHECK(parsed(degenerate).problem.sketch.has_value());
  json coincident = with(bipyramid(), "/sketch/p5", {0, 0, 1});  // p4 and p5 have no given distance
  CHECK(parsed(coincident).problem.sketch.has_value());
  coincident["reference"] = {{"origin", "p4"}, {"axis", "p5"}, {"plane", "p1"}};
  check_refused(coincident, "/sketch", "'p4' and 'p5' are at the same place");
  check_refused(with(with(space(), "/sketch/L", {{"point", {0, 0, 0.5}}, {"direction", {1, 0, -0.5}}}),
                     "/reference", {{"line", "L"}, {"height", "p2"}}),
                "/sketch", "'p2' and 'L'");
}

TEST_CASE("a sketch repeats fixed positions") {
  json document = with(tangents(), "/sketch", tangents()["fixed"]);
  document["sketch"]["L"] = {{"point", {9, 0, 0}}, {"direction", {0, 0, 1}}};
  CHECK(parsed(document).problem.sketch.has_value());
  check_refused(with(document, "/sketch/p2", {1, -1, 5}), "/sketch/p2", "fixed somewhere else");
}

TEST_CASE("an interpolation that no path can follow is refused") {
  check_refused(with(plane(), "/interpolation/bent", "a4"), "/interpolation/bent", "no constraint 'a4'");
  check_refused(with(plane(), "/interpolation/bend", 0), "/interpolation/bend", "> 0");
  check_refused(with(plane(), "/interpolation/bend", -2), "/interpolation/bend", "> 0");
  check_refused(with(plane(), "/interpolation/bend", "2"), "/interpolation/bend", "a number is needed");
}

TEST_CASE("bends by polynomials are read, and refused where no path can follow them") {
  const auto bent = [](const json& bends) { return with(plane(), "/interpolation", {{"bends", bends}}); };
  const auto choice = parsed(bent({{"a3", {1.5, -0.25, 1e-3}}, {"a1", json::array()}})).problem.interpolation;
  REQUIRE(choice.bends);
  REQUIRE(choice.bends->size() == 2);
  for (const gcs::BentLength& length : *choice.bends) {
    const bool third = length.constraint == 2;
    CHECK((third || length.constraint == 0));
    CHECK(length.coefficients == (third ? std::vector<double>{1.5, -0.25, 1e-3} : std::vector<double>{}));
  }
  CHECK(parsed(bent(json::object())).problem.interpolation.bends->empty());

  const std::string place = "/interpolation/bends";
  check_refused(with(plane(), place, {{"a3", {1}}}), "/interpolation", "exclude each other");
  check_refused(bent({{"a4", {1}}}), place + "/a4", "no constraint 'a4'");
  check_refused(bent({{"a3", 1}}), place + "/a3", "an array is needed");
  check_refused(bent(json::array({1})), place, "an object is needed");
  check_refused(bent({{"a3", {1, "2"}}}), place + "/a3/1", "a number is needed");
  check_refused(bent({{"a3", std::vector<int>(17, 1)}}), place + "/a3", "at most 16");
  // The sketch's a1 is 2 long and the given one 3: 2 + t + c·t(1 − t) is least at (c + 1)/(2c), where it vanishes for
  // (c + 1)² = −8c, c = −5 − √24.
  CHECK(parsed(bent({{"a1", {-9.8989}}})).problem.interpolation.bends);
  check_refused(bent({{"a1", {-9.899}}}), place + "/a1", "'a1' is not positive near t = 0.4");
  check_refused(bent({{"a2", {1}}, {"a3", {0, 0, -100}}}), place + "/a3", "keep it above 0");
  json without_sketch = bent({{"a1", {-100}}});
  without_sketch.erase("sketch");
  CHECK(parsed(without_sketch).problem.interpolation.bends);
}

TEST_CASE("a construction plan that cannot be carried out is refused") {
  const std::string last = "/construction/2";
  check_refused(with(plane(), last + "/place", "p9"), last + "/place", "no point 'p9'");
  check_refused(with(plane(), last + "/place", "p2"), last + "/place", "'p2' is placed already");
  check_refused(with(plane(), last + "/from/1/0", "p3"), last + "/from/1/0", "'p3' is not placed yet");
  check_refused(with(plane(), last + "/from/1/0", "p1"), last + "/from/1/0", "'p1' is used twice");
  check_refused(with(plane(), last + "/from/1/1", "a2"), last + "/from/1/1", "'a2' joins 'p1' and 'p3'");
  check_refused(with(plane(), last + "/from/1/1", "x1"), last + "/from/1/1", "begin with k");
  check_refused(with(plane(), last + "/from/1", {"p2"}), last + "/from/1", "exactly 2");
  check_refused(with(plane(), last + "/from/1", nullptr), last + "/from", "exactly 2 radii");
  check_refused(with(plane(), last, nullptr), "/construction", "does not place 'p3'");
  check_refused(with(with(plane(), last + "/from/0/1", "k1"), last + "/from/1/1", "k1"), last + "/from/1/1",
                "'k1' is used twice");
  check_refused(with(space(), "/construction", plane()["construction"]), "/construction",
                "cannot place lines");
  json without_reference = with(plane(), "/reference", nullptr);
  without_reference["construction"].erase(0);
  without_reference["construction"].erase(0);
  check_refused(without_reference, "/construction/0", "begin with the origin");
  json unconstrained = bipyramid();
  unconstrained["reference"] = {{"origin", "p4"}, {"axis", "p5"}, {"plane", "p1"}};
  unconstrained["construction"] =
      json::parse(R"([{"place": "p2", "from": [["p1", "a1"], ["p4", "a5"], ["p5", "a8"]]}])");
  check_refused(unconstrained, "/construction/0", "'p5' and 'p4' have no given distance");
}
