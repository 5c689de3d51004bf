/// Branch and prune over boxes: all real solutions by a general solver, with proof.
///
/// Hoffmann and Yuan end their section 4.4 with "It would be interesting to test this problem on general
/// multi-variate interval Newton solvers". This is one: it knows nothing but the distance equations in the
/// coordinates of the frame (certificates/scene_equations.hpp; of lines beside given points in point and
/// direction) and a box that holds a solution of every class, from ways over given lengths and one sign for each
/// kind of mirror image that the frame leaves (subdivision/start_box.hpp). Boxes are narrowed, proven to hold
/// no solution or, in a box around them, exactly one, or halved where their
/// equations are farthest from linear:
///
/// - reduction=none: preconditioned interval Newton and bisection alone: Krawczyk's operator on every box;
/// - reduction=box: and what each equation alone leaves of a box (box consistency; square_narrowing.hpp);
/// - reduction=linear (the default): and what linear relaxations of all equations together leave, by linear
///   programs for each side of the box, as CuikSuite does it (Porta, Ros, Thomas, A linear relaxation
///   technique for the position analysis of multiloop linkages, IEEE Trans. Robotics 25, 2009), with bounds
///   that hold whatever the rounding of the programs (Neumaier, Shcherbina 2004; linear_narrowing.hpp).
///
/// Deviations from CuikSuite: Krawczyk's test proves that solutions exist, where CuikSuite returns boxes; a
/// difference of coordinates is squared as a whole, with bounds of its own, where CuikSuite has a variable for
/// each monomial, so that the programs have no columns but the unknowns; a bound that a point of the relaxation
/// reaches needs no program.
///
/// It claims all real solutions, proven for the exact decimals of the file. Where a solution is multiple, or
/// others are within 2^-36 of the scene's size, boxes become too small to be halved: what they hold is counted
/// (certificates/undecided_place.hpp). Where that proves nothing the answer is partial, and names them, and never loses
/// them. The boxes grow exponentially with the unknowns, most where many
/// lengths are loose: it refuses scenes of more than most_unknowns, and gives up after max_boxes.

#include "solvers/strategies/box_subdivision.hpp"

#include "solvers/subdivision/start_box.hpp"
#include "solvers/subdivision/subdivision_report.hpp"

namespace gcs {
namespace {

/// Unknown coordinates, those of the frame included: each distance further multiplies the boxes by two or so.
constexpr int most_unknowns = 24;

class BoxSubdivisionStrategy final : public Strategy {
 public:
  explicit BoxSubdivisionStrategy(const BoxSubdivision& asked) : asked_(asked) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    if (auto reason = why_not_certified(request.scene)) return reason;
    const int unknowns = SceneEquations(request.scene).system().unknowns;
    if (unknowns <= most_unknowns) return std::nullopt;
    return "it subdivides boxes of up to " + std::to_string(most_unknowns) +
           " unknown coordinates, and there are " + std::to_string(unknowns);
  }

  SolveReport solve(const SolveRequest& request) override {
    const Scene& scene = request.scene;
    const SceneEquations equations(scene);
    const IntervalEquations system(equations.system());
    const SubdivisionMeans means{asked_.reduction, asked_.max_boxes, request.threads, request.stop,
                                 request.monitor};
    return subdivision_report(
        scene, equations, subdivide(system, start_box(scene, equations), scene.size(), means), request.stop);
  }

 private:
  BoxSubdivision asked_;
};

}  // namespace

StrategyEntry box_subdivision_entry() {
  StrategyEntry entry = entry_of<BoxSubdivisionStrategy, BoxSubdivision>();
  entry.summary = "subdivides boxes of coordinates by interval Newton and linear relaxations, with proof";
  entry.citation = "Porta, Ros, Thomas 2009; asked for by Hoffmann, Yuan 2000, section 4.4";
  return entry;
}

}  // namespace gcs
