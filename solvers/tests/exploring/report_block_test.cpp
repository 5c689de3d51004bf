#include "solvers/exploring/report_block.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

using namespace gcs;

namespace {

Figure random_figure(std::mt19937_64& random) {
  std::uniform_real_distribution<double> in(-1e300, 1e300);
  Figure figure;
  figure.points.resize(3, 4);
  for (double& x : figure.points.reshaped()) x = in(random);
  figure.lines = {{{in(random), -0.0, 0}, {0, 0, 1}}};
  figure.planes = {{{0, 1, 0}, in(random)}};
  return figure;
}

std::vector<SolveReport> random_reports() {
  std::mt19937_64 random(1);
  std::vector<SolveReport> reports(2);
  SolveReport& report = reports.front();
  report.status = SolveStatus::partial;
  report.reason = "a doubt";
  report.candidates = {{random_figure(random), 1, 1e-300}, {random_figure(random), 2}};
  PathRecord path;
  path.end = PathRecord::End::singular;
  path.cause = "it ends";
  path.length = 5e-324;
  path.crossings = {{1, -1}, {0, 1}};
  path.winding_number = 2;
  path.pole_order = 3;
  path.proven = true;
  report.paths = {path};
  report.curves = {{4, path, {random_figure(random)}, {0, 0}}};
  report.work.iterations = std::numeric_limits<std::int64_t>::max();
  report.work.smallest_step = 1e-9;
  report.particulars = {{"singular", -3}};
  return reports;
}

void check_same(const Figure& a, const Figure& b) {
  CHECK(a.points == b.points);
  REQUIRE(a.lines.size() == b.lines.size());
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    CHECK(a.lines[i].point == b.lines[i].point);
    CHECK(std::signbit(a.lines[i].point.y()) == std::signbit(b.lines[i].point.y()));
    CHECK(a.lines[i].direction == b.lines[i].direction);
  }
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    CHECK(a.planes[i].normal == b.planes[i].normal);
    CHECK(a.planes[i].offset == b.planes[i].offset);
  }
}

void check_same(const PathRecord& a, const PathRecord& b) {
  CHECK(a.end == b.end);
  CHECK(a.cause == b.cause);
  CHECK(a.length == b.length);
  REQUIRE(a.crossings.size() == b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    CHECK(a.crossings[i].candidate == b.crossings[i].candidate);
    CHECK(a.crossings[i].direction == b.crossings[i].direction);
  }
  CHECK(a.winding_number == b.winding_number);
  CHECK(a.pole_order == b.pole_order);
  CHECK(a.proven == b.proven);
}

}  // namespace

TEST_CASE("reports come out of a journal's block as they went in") {
  const std::vector<SolveReport> in = random_reports(), out = reports_from(to_block(in));
  REQUIRE(out.size() == 2);
  const SolveReport &a = in.front(), &b = out.front();
  CHECK(a.status == b.status);
  CHECK(a.reason == b.reason);
  REQUIRE(b.candidates.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    check_same(a.candidates[i].figure, b.candidates[i].figure);
    CHECK(a.candidates[i].multiplicity == b.candidates[i].multiplicity);
    CHECK(a.candidates[i].error == b.candidates[i].error);
  }
  REQUIRE(b.paths.size() == 1);
  check_same(a.paths[0], b.paths[0]);
  REQUIRE(b.curves.size() == 1);
  CHECK(b.curves[0].released == 4);
  check_same(a.curves[0].path, b.curves[0].path);
  check_same(a.curves[0].figures.at(0), b.curves[0].figures.at(0));
  CHECK(a.curves[0].places == b.curves[0].places);
  CHECK(a.work.iterations == b.work.iterations);
  CHECK(a.work.smallest_step == b.work.smallest_step);
  CHECK_FALSE(b.work.max_driving_parameters);
  CHECK(a.particulars == b.particulars);
  CHECK(out.back().candidates.empty());
}

TEST_CASE("blocks that are none of reports are refused") {
  const Journal::Block whole = to_block(random_reports());
  CHECK_THROWS_AS(reports_from({}), std::invalid_argument);
  CHECK_THROWS_AS(reports_from({std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  for (const std::size_t left : {std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
    Journal::Block part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(left));
    CHECK_THROWS_AS(reports_from(part), std::invalid_argument);
    part.front() = static_cast<double>(6 * (left - 1));
    CHECK_THROWS_AS(reports_from(part), std::invalid_argument);
  }
  for (const double wrong : {-1.0, 0x1p48, std::numeric_limits<double>::infinity()}) {
    Journal::Block block = whole;
    block[3] = wrong;
    CHECK_THROWS_AS(reports_from(block), std::invalid_argument);
  }
}
