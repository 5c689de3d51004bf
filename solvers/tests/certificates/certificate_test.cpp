/// Certificates for solutions that are known exactly: points with whole coordinates, whose squared distances
/// are whole numbers, and triangles whose third point has the height √(1 − b²/4).

#include "solvers/certificates/certificate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/answers/certify.hpp"
#include "solvers/certificates/coincidences.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;
using Point = std::vector<std::complex<double>>;
using Realness = Certificate::Realness;

namespace {

/// Sides 1 and 1 over a base that is given in decimals, in the plane.
ProblemStatement triangle(const std::string& base) {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"a", "b", "c"};
  problem.constraints = {{"a1", {0, 1}, {std::stod(base), base}, false},
                         {"a2", {0, 2}, {1, "1"}, false},
                         {"a3", {1, 2}, {1, "1"}, false}};
  problem.reference = Reference{0, 1, -1, -1, -1};
  return problem;
}

/// b on the axis, then c, in the file's unit.
Certificate certify_triangle(const std::string& base, double b, std::complex<double> x,
                             std::complex<double> y) {
  const Scene scene = Scene::unchecked(triangle(base));
  const double unit = std::ldexp(1.0, -scene.unit_exponent());
  return Certifier(SceneEquations(scene).system()).certify({b * unit, x * unit, y * unit});
}

using Whole = Eigen::Matrix<long long, 3, Eigen::Dynamic>;

/// The octahedron's graph on six points, in the frame of the first three.
const std::vector<std::array<int, 2>> octahedron{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {0, 4}, {1, 4},
                                                 {1, 5}, {2, 5}, {2, 3}, {3, 4}, {4, 5}, {3, 5}};

Whole whole_placement(RandomNumbers& random) {
  Whole points(3, 6);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = std::llround(random.uniform(-20, 20));
  points.col(0).setZero();
  points.col(1) << std::llround(random.uniform(5, 20)), 0, 0;
  points.col(2) << std::llround(random.uniform(-20, 20)), std::llround(random.uniform(5, 20)), 0;
  return points;
}

ProblemStatement problem_of(const Whole& points) {
  ProblemStatement problem;
  problem.points = {"p1", "p2", "p3", "p4", "p5", "p6"};
  for (const auto& [a, b] : octahedron) {
    const long long square = (points.col(a) - points.col(b)).squaredNorm();
    problem.constraints.push_back({"a", {a, b}, {static_cast<double>(square), std::to_string(square)}, true});
  }
  problem.reference = Reference{0, 1, 2, -1, -1};
  return problem;
}

/// The coordinates in the scene's unit, each off by up to `shift`.
Point coordinates(const SceneEquations& equations, const Scene& scene, const Whole& points, double shift,
                  RandomNumbers& random) {
  Figure figure;
  figure.points = points.cast<double>() * std::ldexp(1.0, -scene.unit_exponent());
  Point x = equations.coordinates(figure);
  for (auto& value : x) value += shift * random.uniform(-1, 1);
  return x;
}

LinearForm whole_form(int unknowns, RandomNumbers& random) {
  LinearForm form{{}, exactly(random.index(9) - 4)};
  for (int i = 0; i < unknowns; ++i) form.terms.push_back({i, exactly(random.index(9) - 4)});
  return form;
}

/// Precondition: all numbers are doubles, and so are all sums and products.
std::complex<double> value_of(const LinearForm& form, const Point& x) {
  std::complex<double> sum = form.constant.value;
  for (const ScaledUnknown& term : form.terms)
    sum += term.coefficient.value * x[static_cast<std::size_t>(term.unknown)];
  return sum;
}

/// As many equations as unknowns, of three products of forms with small whole coefficients, which x solves.
QuadraticSystem products_of_forms(const Point& x, RandomNumbers& random) {
  QuadraticSystem system;
  system.unknowns = static_cast<int>(x.size());
  for (int e = 0; e < system.unknowns; ++e) {
    QuadraticEquation equation;
    std::complex<double> sum = 0;
    for (int i = 0; i < 3; ++i) {
      FormProduct product{whole_form(system.unknowns, random), whole_form(system.unknowns, random)};
      sum += value_of(product.left, x) * value_of(product.right, x);
      equation.products.push_back(std::move(product));
    }
    equation.given = exactly(sum);
    system.equations.push_back(std::move(equation));
  }
  return system;
}

bool holds(const Enclosure& enclosure, const Point& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i].real() - enclosure.mid[i].real()) > enclosure.radius[i].real()) return false;
    if (std::abs(x[i].imag() - enclosure.mid[i].imag()) > enclosure.radius[i].imag()) return false;
  }
  return true;
}

double largest_radius(const Enclosure& enclosure) {
  double largest = 0;
  for (const std::complex<double>& radius : enclosure.radius) largest = std::max(largest, std::abs(radius));
  return largest;
}

}  // namespace

TEST_CASE("an enclosure holds the exact solution, in doubles and in balls") {
  RandomNumbers random(20260101);
  for (int i = 0; i < 50; ++i) {
    const Whole points = whole_placement(random);
    const Scene scene = Scene::unchecked(problem_of(points));
    const SceneEquations equations(scene);
    const Certifier certifier(equations.system());
    const Point exact = coordinates(equations, scene, points, 0, random);
    const Point near = coordinates(equations, scene, points, 1e-9, random);
    const Certificate fast = certifier.certify(near), slow = certifier.certify(near, 128);
    INFO("placement " << i);
    REQUIRE(slow.is_proven);
    CHECK(holds(slow.enclosure, exact));
    CHECK(slow.bits >= 128);
    CHECK(largest_radius(slow.enclosure) < 1e-30);
    // Newton's correction is 0.
    CHECK(largest_radius(certifier.certify(exact, 128).enclosure) < 1e-30);
    if (!fast.is_proven) continue;
    CHECK(holds(fast.enclosure, exact));
    CHECK(fast.realness == Realness::real);
    // What was moved by 1e-9 is that far off.
    for (std::size_t k = 0; k < near.size(); ++k)
      CHECK(fast.offset(k, near[k]) >= std::abs(near[k] - exact[k]));
  }
}

TEST_CASE(
    "an enclosure of a system of forms with coefficients holds the exact solution, in doubles and in balls") {
  RandomNumbers random(20260102);
  int in_doubles = 0;
  for (int i = 0; i < 60; ++i) {
    const bool is_real = i % 2 == 0;
    Point exact, near;
    for (int k = 0; k < 7; ++k) {
      const double re = random.index(65) - 32, im = is_real ? 0 : random.index(65) - 32;
      exact.emplace_back(re / 16, im / 16);
      near.push_back(exact.back() + 1e-9 * random.uniform(-1, 1));
    }
    const Certifier certifier(products_of_forms(exact, random));
    const Certificate fast = certifier.certify(near), slow = certifier.certify(near, 128);
    INFO("system " << i);
    if (!slow.is_proven) continue;
    CHECK(holds(slow.enclosure, exact));
    in_doubles += fast.bits == 53;
    CHECK(holds(fast.enclosure, exact));
    for (std::size_t k = 0; k < near.size(); ++k) {
      CHECK(fast.offset(k, near[k]) >= std::abs(near[k] - exact[k]));
      CHECK(std::abs(fast.enclosure.radius[k]) <= 1e-11);
    }
  }
  CHECK(in_doubles >= 50);
}

TEST_CASE("a number and the cosine of so many degrees are two") {
  // (x + cos 60°)(x + 60) = 0
  ExactNumber degrees = exactly(60);
  degrees.decimal = "60";
  ExactNumber cosine = degrees;
  cosine.is_cosine_of_degrees = true;
  QuadraticSystem system;
  system.unknowns = 1;
  system.equations = {{{{{{{0}}, cosine}, {{{0}}, degrees}}}, {}}};
  const Certifier certifier(system);
  for (const double x : {-0.5, -60.0}) {
    const Certificate certificate = certifier.certify({x});
    REQUIRE(certificate.is_proven);
    CHECK(certificate.bits == 53);
    CHECK(holds(certificate.enclosure, {x}));
  }
}

TEST_CASE("well-conditioned solutions are proven in doubles") {
  const Certificate certificate = certify_triangle("1.1", 1.1, 0.55, std::sqrt(1 - 0.55 * 0.55));
  REQUIRE(certificate.is_proven);
  CHECK(certificate.bits == 53);
  for (const auto& radius : certificate.enclosure.radius) CHECK(radius.real() <= 1e-14);
}

TEST_CASE("a double solution is rejected as singular, and its cluster is proven") {
  const Certificate certificate = certify_triangle("2", 2, 1, 0);
  CHECK_FALSE(certificate.is_proven);
  CHECK(certificate.cluster == 2);
  const double unit = std::ldexp(1.0, -Scene::unchecked(triangle("2")).unit_exponent());
  CHECK(holds(certificate.enclosure, {2 * unit, unit, 0}));
  CHECK(meeting_images(certificate.enclosure, {-1, -1, 1}) == 2);
  CHECK(certificate.cause.find("singular") != std::string::npos);
}

TEST_CASE("a near miss is rejected: there is no real solution next to it") {
  // c would have the square −1e-6 of a height.
  const Certificate certificate = certify_triangle("2.000001", 2.000001, 1.0000005, 0);
  CHECK_FALSE(certificate.is_proven);
}

TEST_CASE("lengths are the decimals of the file, not their doubles") {
  // The double nearest to this base is 2, where the solution is double; here the height is 1e-20.
  const Certificate certificate = certify_triangle("1.9999999999999999999999999999999999999999", 2, 1, 1e-20);
  REQUIRE(certificate.is_proven);
  CHECK(certificate.bits > 53);
  CHECK(certificate.realness == Realness::real);
  CHECK(certificate.enclosure.mid[2].real() > 0);
  // And slightly longer than 2 it is imaginary.
  const Certificate imaginary =
      certify_triangle("2.0000000000000000000000000000000000000001", 2, 1, {0, 1e-20});
  REQUIRE(imaginary.is_proven);
  CHECK(imaginary.realness == Realness::not_real);
}

TEST_CASE("a real solution is recognised in complex numbers") {
  const double height = std::sqrt(1 - 0.3025);
  CHECK(certify_triangle("1.1", 1.1, {0.55, 1e-18}, {height, -1e-17}).realness == Realness::real);
  const double depth = std::sqrt(1.2 * 1.2 - 1);
  CHECK(certify_triangle("2.4", 2.4, 1.2, {0, depth}).realness == Realness::not_real);
}

TEST_CASE("equal solutions and mirror images coincide, and no others") {
  const Scene scene = Scene::unchecked(triangle("1.1"));
  const QuadraticSystem system = SceneEquations(scene).system();
  const Certifier certifier(system);
  const double height = std::sqrt(1 - 0.3025);
  std::vector<Enclosure> boxes;
  for (const double sign : {1.0, -1.0, 1.0}) {
    const Certificate certificate = certifier.certify({1.1, 0.55, sign * height});
    REQUIRE(certificate.is_proven);
    boxes.push_back(certificate.enclosure);
  }
  // Far from its own place: another class as far as boxes tell.
  boxes.push_back(boxes[0]);
  boxes.back().mid[2] += 1e-9;
  const std::vector<Coincidence> pairs = coincidences(boxes, system.mirror);
  REQUIRE(pairs.size() == 3);
  for (const Coincidence& pair : pairs) {
    CHECK(pair.second < 3);
    CHECK(pair.is_proven);
  }
  for (const Enclosure& box : boxes) CHECK(meeting_images(box, system.mirror) == 1);
}

TEST_CASE("solutions that differ by the side of one point are different classes") {
  RandomNumbers random(7);
  const Whole points = whole_placement(random);
  const Scene scene = Scene::unchecked(problem_of(points));
  const SceneEquations equations(scene);
  const Point x = coordinates(equations, scene, points, 0, random);
  Enclosure box{x, Point(x.size(), {1e-15, 0}), 1e-3};
  Enclosure other = box;
  int moved = 0;
  for (std::size_t i = 0; i < x.size() && moved == 0; ++i)
    if (equations.system().mirror[i] == 4 && x[i] != 0.0) {
      other.mid[i] = -other.mid[i];
      ++moved;
    }
  REQUIRE(moved == 1);
  CHECK(coincidences({box, other}, equations.system().mirror).empty());
}

TEST_CASE(
    "neighbours are told apart from figures that are further from these than they are from each other") {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"a", "b", "c", "d"};
  problem.constraints = {{"a1", {0, 1}, {1, "1"}, true},
                         {"a2", {0, 2}, {0.89, "0.89"}, true},
                         {"a3", {1, 2}, {0.89, "0.89"}, true},
                         {"a4", {0, 3}, {0.2500000001, "0.2500000001"}, true},
                         {"a5", {1, 3}, {0.2500000001, "0.2500000001"}, true}};
  problem.reference = Reference{0, 1, -1, -1, -1};
  const Scene scene = Scene::unchecked(std::move(problem));
  constexpr double height = 1e-5, off = 1e-3;
  std::vector<Figure> figures;
  for (const double d : {height, -height, height}) {
    Figure figure;
    figure.points.resize(3, 4);
    figure.points.transpose() << 0, 0, 0, 1, 0, 0, 0.5 + off, 0.8, 0, 0.5, d, 0;
    figures.push_back(scene.in_scene_unit(figure));
  }
  const std::vector<SolutionProof> proofs = prove_solutions(SceneEquations(scene), {}, figures, {});
  REQUIRE(proofs.size() == 3);
  for (const SolutionProof& proof : proofs) {
    CHECK(proof.certificate.is_proven);
    CHECK(std::ldexp(proof.place.reach, scene.unit_exponent()) > 2 * height);
  }
  CHECK(proofs[0].counts());
  CHECK(proofs[1].counts());
  CHECK(proofs[2].same_as == 0);
  CHECK(proofs[2].is_proven_same);
}
