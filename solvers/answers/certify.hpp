#pragma once
/// Proves what an assessment lists: that every solution exists, is the only one there, is real or not as
/// listed and in a class of its own, and that the list is complete where its length meets a limit that
/// nothing exceeds. (Krawczyk's test with the decimal lengths of the file; solvers/certificates/.)

#include "solvers/answers/assess.hpp"
#include "solvers/certificates/certificate.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/running/proof_setup.hpp"

namespace gcs {

class SceneEquations;

/// One solution of a list and what is proven about it.
struct SolutionProof {
  Certificate certificate;
  double distance = 0;  ///< at most so far from the figure, in the scene's unit; see SceneEquations::distance
  int same_as = -1;     ///< the first solution of the list that is not proven to be another class; −1: none
  bool is_proven_same = false;  ///< and it is proven to be the same class
  int least = 1;                ///< so many classes at least, with multiplicities, are in its enclosure
  int cluster = 0;              ///< so many of a cluster that no earlier solution stands for
  /// It is proven, of a general scene, and none of its own images by changes of signs in the frame.
  bool has_image = false;

  /// Whether it is a solution of its own.
  bool counts() const { return certificate.is_proven && same_as < 0; }

  /// Whether a solution may be listed with that multiplicity. Of its own mirror image it is not known whether
  /// that is it, or another solution in the enclosure.
  bool fits(int multiplicity) const {
    return certificate.is_proven ? multiplicity == 1
                                 : least <= multiplicity && multiplicity <= certificate.cluster;
  }
};

/// Adds the clusters and mirror images to `proofs`.
void count_clusters_and_images(const std::vector<SolutionProof>& solutions, Proofs& proofs);

/// Proofs for figures in the scene's unit and frame. Precondition: !why_not_certified(scene). Stopped, some are not
/// tried.
std::vector<SolutionProof> prove_solutions(const SceneEquations& equations,
                                           const std::vector<Figure>& figures, const ProofSetup& setup);

/// Sets `error` of the candidates that are proven, so that assess tells apart what doubles do not. Untried ones where stop is
/// asked for. How many of them are proven to be different classes.
std::size_t prove_errors(const Scene& scene, const ProofSetup& setup, std::vector<Candidate>& candidates);

/// What signs say of the real solution that is proven next to a figure: of its enclosure or, where that is too wide, of
/// one in a higher precision. Preconditions: the scene is general, the certificate is the figure's and proves it real.
SignVerdict proven_signs(const SceneEquations& equations, const std::vector<StatedSign>& signs,
                         const Figure& figure, const Certificate& certificate);

/// Sets proofs.at_infinity, of Assessment::escaping.
void prove_escaping(const Scene& scene, const std::vector<Figure>& escaping, const ProofSetup& setup,
                    Proofs& proofs);

/// Sets what no list is longer than.
void set_limit(const TheoreticalCounts& limits, Proofs& proofs);

/// Fills in `certified`, `error_bound`, `signs`, counts.certified and `proofs` of an assessment, and brings the
/// counts in line with `signs`. What cannot be proven becomes a failed check by the name of "certificate", or
/// "singular" where it is listed as multiple. Where certificates do not reach the scene proofs.why_none says why.
/// Stopped, it leaves the rest uncertified.
void certify(const Scene& scene, const TheoreticalCounts& limits, const std::optional<GenericMember>& generic,
             const ProofSetup& setup, Assessment& assessment);

}  // namespace gcs
