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

/// What is kept of an enclosure, which is twice as large as the figure it belongs to.
struct ProvenPlace {
  double reach = 0;   ///< no unknown of the solution is further from the figure's
  double unique = 0;  ///< no other solution has all unknowns so near to these; may be negative
};

/// Of the solution that is proven next to the unknowns x.
Enclosure box_around(std::vector<std::complex<double>> x, const ProvenPlace& place);

/// One solution of a list and what is proven about it.
struct SolutionProof {
  Certificate certificate;  ///< without its enclosure
  ProvenPlace place;        ///< of an isolated one
  double distance = 0;  ///< at most so far from the figure, in the scene's unit; see SceneEquations::distance
  int same_as = -1;     ///< the first solution of the list that is not proven to be another class; −1: none
  bool is_proven_same = false;  ///< and it is proven to be the same class
  int least = 1;                ///< so many classes at least, with multiplicities, are in its enclosure
  int cluster = 0;              ///< so many of a cluster that no earlier solution stands for
  /// It is proven, of a general scene, and none of its own images by changes of signs in the frame.
  bool has_image = false;
  SignVerdict signs{};  ///< of one that is proven to be real

  /// Whether it is a solution of its own.
  bool counts() const { return certificate.holds_one() && same_as < 0; }

  /// Whether a solution may be listed with that multiplicity. Of its own mirror image it is not known whether
  /// that is it, or another solution in the enclosure.
  bool fits(int multiplicity) const {
    return certificate.is_proven ? multiplicity == 1
                                 : least <= multiplicity && multiplicity <= certificate.cluster;
  }
};

/// Adds the clusters and mirror images to `proofs`.
void count_clusters_and_images(const std::vector<SolutionProof>& solutions, Proofs& proofs);

/// Proofs for figures in the scene's unit and frame. Precondition: !why_not_certified(scene), and `signs` are stated in
/// general scenes alone. Stopped, some are not tried.
std::vector<SolutionProof> prove_solutions(const SceneEquations& equations,
                                           const std::vector<StatedSign>& signs,
                                           const std::vector<Figure>& figures, const ProofSetup& setup);

struct ProvenErrors {
  std::vector<double> errors;  ///< as of candidates: infinite where nothing is proven
  std::size_t different = 0;   ///< so many are proven to be different classes
};

/// Of figures in the scene's unit and frame, so that assess tells apart what doubles do not. Nothing where certificates do
/// not reach the scene; untried ones where stop is asked for.
ProvenErrors prove_errors(const Scene& scene, const ProofSetup& setup, const std::vector<Figure>& figures);

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
