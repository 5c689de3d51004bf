#include <fmt/format.h>

#include <array>
#include <cmath>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"

namespace gcs {
namespace {

/// All pairs of six points but 1–4, 2–5 and 3–6, without lengths.
Draft octahedron() {
  return {
      .points = 6,
      .edges =
          {{0, 1}, {0, 2}, {0, 4}, {0, 5}, {1, 2}, {1, 3}, {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}},
      .sketch = {{0, 0, 0}, {1, 0, 0}, {0.5, 1.3, 0}, {1.2, 0.5, 1.5}, {0, 1.8, 0.9}, {-0.2, -0.7, 1.3}}};
}

/// The lengths of the shipped octahedron.
const std::vector<double>& octahedron_lengths() {
  static const std::vector<double> lengths{1.1, 1.3, 1.7, 1.6, 1.2, 1.8, 1.6, 1.7, 1.3, 1.9, 2.2, 2.7};
  return lengths;
}

std::string scaled_octahedron(const std::string& id, double scale) {
  Draft draft = octahedron();
  draft.interpolation = fmt::format(R"({{"bend": {}}})", 2 * scale);
  for (const double length : octahedron_lengths()) draft.squares.emplace_back(length * scale);
  for (auto& point : draft.sketch)
    for (double& x : point) x *= scale;
  return text_of(id, draft, "length");
}

std::string scale_of_two(const std::string& id, const std::string& exponent) {
  return scaled_octahedron(id, std::ldexp(1.0, std::stoi(exponent)));
}

std::string scale_of_ten(const std::string& id, const std::string& exponent) {
  return scaled_octahedron(id, std::stod("1e" + exponent));
}

std::string octahedron_at(const std::string& id, const std::vector<ExactPoint>& points) {
  return text_of(id, measured_at(points, octahedron()));
}

std::string short_edge(const std::string& id, const std::string& epsilon) {
  return octahedron_at(id, {{"0", "0", "0"},
                            {epsilon, "0", "0"},
                            {"0.5", "1.3", "0"},
                            {"1.1", "0.6", "1.4"},
                            {"0.1", "1.7", "1"},
                            {"-0.3", "-0.6", "1.2"}});
}

/// At ε = 0 the closed chain of the edges 1–2, 2–4, 4–5 and 5–1 can be stretched flat, 1.8 + 1.8 = 1.9 + 1.7,
/// and a complex solution is at infinity; else its coordinates grow as 1/ε and its condition number as 1/ε².
std::string escaping(const std::string& id, const std::string& epsilon) {
  Draft draft = octahedron();
  for (const double length : octahedron_lengths()) draft.squares.emplace_back(fmt::format("{}", length));
  draft.squares[0] = LongDecimal("1.8") + LongDecimal(epsilon);
  return text_of(id, draft, "length");
}

/// Cyclohexane's octahedron, whose solutions share diagonals, with edges of slightly different lengths.
std::string cyclohexane(const std::string& id, const std::string& epsilon) {
  static const std::vector<const char*> shifts{"0.31", "-0.17", "0.23", "0.05", "-0.29", "0.11",
                                               "0.19", "-0.07", "0.13", "0.02", "-0.21", "0.27"};
  Draft draft = octahedron();
  for (std::size_t e = 0; e < 12; ++e)
    draft.squares.push_back(LongDecimal(e < 9 ? "4" : "3") + LongDecimal(epsilon) * LongDecimal(shifts[e]));
  return text_of(id, draft);
}

std::string longer_by(const std::string& epsilon, const std::string& id,
                      const std::vector<ExactPoint>& points) {
  Draft draft = measured_at(points, octahedron());
  draft.squares.back() = draft.squares.back() + LongDecimal(epsilon);
  return text_of(id, draft);
}

/// A half-turn about the z-axis carries three points to the opposite ones: Bricard's first type, which moves,
/// since nine coordinates less one turn about the axis and one shift along it meet six different lengths.
std::string bricard(const std::string& id, const std::string& epsilon) {
  return longer_by(epsilon, id,
                   {{"1", "0.3", "0.2"},
                    {"0.2", "1.1", "-0.5"},
                    {"0.6", "-0.7", "0.9"},
                    {"-1", "-0.3", "0.2"},
                    {"-0.2", "-1.1", "-0.5"},
                    {"-0.6", "0.7", "0.9"}});
}

/// A reflection in z = 0 carries two points to the opposite ones and keeps the two others: Bricard's second
/// type, which moves, since ten coordinates less the three of a motion of the plane meet six different
/// lengths.
std::string bricard_two(const std::string& id, const std::string& epsilon) {
  return longer_by(epsilon, id,
                   {{"1", "0.3", "0.6"},
                    {"0.2", "1.1", "0.8"},
                    {"0.9", "1.4", "0"},
                    {"1", "0.3", "-0.6"},
                    {"0.2", "1.1", "-0.8"},
                    {"-0.4", "0.1", "0"}});
}

}  // namespace

std::span<const InstanceFamily> octahedron_families() {
  static const std::array all{
      InstanceFamily{"cyclohexane", "an octahedron with solutions that share diagonals but for ε",
                     shrinking(), cyclohexane},
      InstanceFamily{"short-edge", "an octahedron with an edge of length ε", shrinking(), short_edge},
      InstanceFamily{"escaping", "an octahedron with a complex solution as far away as 1/ε",
                     shrinking_to_zero(), escaping},
      InstanceFamily{"bricard",
                     "Bricard's octahedron of type I, which moves, but for ε",
                     shrinking_to_zero(),
                     bricard,
                     {"0"}},
      InstanceFamily{"bricard-two",
                     "Bricard's octahedron of type II, which moves, but for ε",
                     shrinking_to_zero(),
                     bricard_two,
                     {"0"}},
      InstanceFamily{"scale-of-two",
                     "the octahedron times 2^k",
                     {"0", "100", "-100", "500", "-500", "1000", "-1000"},
                     scale_of_two},
      InstanceFamily{"scale-of-ten", "the octahedron times 10^k", {"0", "100", "-100"}, scale_of_ten},
  };
  return all;
}

}  // namespace gcs
