/// Certificates that other processes prove: here by messages alone, within one.

#include "solvers/certificates/certificate_member.hpp"

#include <catch2/catch.hpp>
#include <complex>
#include <memory>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/tests/fake_crew.hpp"

using namespace gcs;

namespace {

using Point = std::vector<std::complex<double>>;

ExactNumber written(const std::string& text, bool is_squared = false) {
  ExactNumber number = exactly(std::stod(text));
  number.decimal = text;
  number.is_squared = is_squared;
  return number;
}

ExactNumber cosine_of(double degrees) {
  ExactNumber number = exactly(degrees);
  number.is_cosine_of_degrees = true;
  return number;
}

LinearForm of(int unknown, const ExactNumber& coefficient = exactly(1)) { return {{{unknown, coefficient}}}; }

/// x² + y² = 2.5², x·(y/|(3, 4)|) = cos 84°/2: four real solutions, and about (2.5, 0) none near by.
QuadraticSystem circle_and_hyperbola() {
  ExactNumber fifth = exactly(1);
  fifth.divided_by_norm_of = {exactly(3), written("4")};
  ExactNumber given = cosine_of(84);
  given.exponent = -1;
  return {2,
          {{{{of(0), of(0)}, {of(1), of(1)}}, written("2.5", true)}, {{{of(0), of(1, fifth)}}, given}},
          SignMasks({0, 0})};
}

/// x² = 0, y = 1: twofold.
QuadraticSystem touching() {
  return {2, {{{{of(0), of(0)}}}, {{{of(1), {{}, exactly(1)}}}, exactly(1)}}, {}};
}

std::vector<Point> points_about(const std::vector<Point>& centres, int copies) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> off(-1e-4, 1e-4);
  std::vector<Point> points;
  for (int i = 0; i < copies; ++i)
    for (Point point : centres) {
      for (std::complex<double>& x : point) x += off(random);
      points.push_back(point);
    }
  return points;
}

std::vector<Certificate> all_certificates(const Certifier& certifier, const std::vector<Point>& points,
                                          const ProofSetup& setup) {
  std::vector<Certificate> certificates(points.size());
  certify_points(
      certifier, points.size(), [&](std::size_t i) { return points[i]; }, setup,
      [&](std::size_t i, Certificate certificate) { certificates[i] = std::move(certificate); });
  return certificates;
}

void check_same(const Certificate& a, const Certificate& b) {
  CHECK(a.is_proven == b.is_proven);
  CHECK(a.cluster == b.cluster);
  CHECK(a.bits == b.bits);
  CHECK(a.enclosure.mid == b.enclosure.mid);
  CHECK(a.enclosure.radius == b.enclosure.radius);
  CHECK(a.enclosure.unique == b.enclosure.unique);
  CHECK(a.realness == b.realness);
  CHECK(a.cause == b.cause);
}

}  // namespace

TEST_CASE("what a crew proves has the same bits") {
  const Certifier simple(circle_and_hyperbola()), multiple(touching());
  const std::vector<Point> four = points_about({{2.499, 0.1046}, {0.1046, 2.499}, {-2.499, -0.1046}}, 60);
  const std::vector<Point> twofold = points_about({{0, 1}}, 100);
  for (const auto& [certifier, points] : {std::pair{&simple, four}, std::pair{&multiple, twofold}}) {
    FakeCrew crew(begin_certificates);
    const std::vector<Certificate> alone = all_certificates(*certifier, points, {});
    const std::vector<Certificate> together = all_certificates(*certifier, points, {.crew = &crew});
    CHECK(crew.handed_out > 0);
    REQUIRE(together.size() == points.size());
    REQUIRE(alone.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) check_same(alone[i], together[i]);
  }
  CHECK(all_certificates(simple, four, {})[0].realness == Certificate::Realness::real);
  CHECK(all_certificates(multiple, twofold, {})[0].cluster == 2);
}

TEST_CASE("what a crew was stopped before is not tried") {
  const Certifier certifier(circle_and_hyperbola());
  FakeCrew crew(begin_certificates);
  std::stop_source stop;
  stop.request_stop();
  const std::vector<Certificate> none = all_certificates(certifier, points_about({{2.499, 0.1046}}, 100),
                                                         {.stop = stop.get_token(), .crew = &crew});
  REQUIRE(none.size() == 100);
  for (const Certificate& certificate : none) CHECK_FALSE(certificate.is_tried());
}

TEST_CASE("tasks and points that end early are refused, and other tasks left to others") {
  /// Takes down what is handed out.
  class Listener final : public Crew {
   public:
    int members() const override { return 2; }
    int members_here() const override { return 1; }
    std::unique_ptr<ItemWork> share(const std::string& task, ItemWork&) override {
      task_ = task;
      return std::make_unique<OneByOne>([this](const NumberedItem& item) {
        if (item.number == 0) item_ = item.bytes;
        return std::string();
      });
    }
    std::string task_, item_;
  } listener;
  CHECK_THROWS_AS(all_certificates(Certifier(circle_and_hyperbola()), points_about({{2.499, 0.1046}}, 100),
                                   {.crew = &listener}),
                  std::invalid_argument);
  const std::unique_ptr<ItemWork> member = begin_certificates(listener.task_);
  const auto result_of = [&](const std::string& item) {
    member->add({7, item});
    return member->advance().at(0);
  };
  CHECK(result_of(listener.item_).number == 7);
  CHECK_FALSE(result_of(listener.item_).bytes.empty());
  for (const std::size_t part : {1, 3, 10, 100}) {
    CHECK_THROWS_AS(begin_certificates(listener.task_.substr(0, listener.task_.size() - part)),
                    std::invalid_argument);
    CHECK_THROWS_AS(result_of(listener.item_.substr(0, listener.item_.size() - part)), std::invalid_argument);
  }
  CHECK_FALSE(begin_certificates("cells\n{}"));
}
