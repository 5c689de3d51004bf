#pragma once
/// General scenes with sketches, and their crossings of t = 1.

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/solving/solve.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs::samples {

/// With a random sketch: bodies nearly in a random posture, else points and planes anywhere.
ProblemStatement sketched(ProblemStatement problem, RandomNumbers& random);

/// Platforms in the plane and in space, and octahedral scenes with one, two and three planes.
std::vector<ProblemStatement> sample_scenes(std::uint64_t seed);
std::string name_of(const ProblemStatement& problem);

/// Three points and three lines, all pairs constrained: distances, and angles of the lines. Values of one random figure, the
/// sketch another one.
ProblemStatement sketched_points_and_lines(RandomNumbers& random);

/// A corner p of lines L through o and M through a, of which L turns.
/// Angles in degrees between the lines and o–a; the sketch has L at `sketched` degrees to it, counterclockwise. o, a and
/// b are a triangle, whose sides do not change.
ProblemStatement corner_of_lines(double sketched, double of_l, double of_m);

/// With the orientation of the first points stated: a general scene with the equations of the distances.
ProblemStatement with_orientation(ProblemStatement problem);

/// The same problem with other names, orders, and lengths that are 8 times as long, the sketch 3 times.
ProblemStatement renamed_and_scaled(const ProblemStatement& problem);

Answer followed(const ProblemStatement& problem, const OptionMap& options = {});

/// Whether two figures are one solution, to a millionth.
bool are_alike(const Scene& scene, const Figure& a, const Figure& b);
/// Of each crossing its figure, in the order met.
std::vector<Figure> crossed(const Answer& answer);
void check_same_crossings(const Scene& scene, const std::vector<Figure>& one,
                          const std::vector<Figure>& other);

}  // namespace gcs::samples
