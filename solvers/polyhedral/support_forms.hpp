#pragma once
/// The affine forms by which points of one support are compared.

#include <vector>

#include "solvers/polyhedral/dictionary.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

class SupportForms {
 public:
  /// One lifting per point.
  SupportForms(const Support& support, const std::vector<double>& lifting);

  int points() const { return points_; }
  /// ω(c) − ω(a) + ⟨c − a, α⟩: not negative where a is lower than c or as low.
  const SparseForm& excess(int c, int a) const { return forms_[c * points_ + a]; }
  /// Whether there is an unknown in which points of either support differ.
  bool meets(const SupportForms& other) const;

 private:
  int points_;
  std::vector<SparseForm> forms_;
  std::vector<bool> differs_;  ///< one per unknown
};

/// Calls visit(b, polyhedron) for the points b > a that are `wanted(b)` and lowest together with a somewhere
/// in the polyhedron, which comes cut down to where a is lowest and ready for its face(b).
template <class Wanted, class Visit>
void visit_edges_from(int a, const Dictionary& polyhedron, const SupportForms& support, SimplexWork& work,
                      const Wanted& wanted, const Visit& visit) {
  int last = support.points() - 1;
  while (last > a && !wanted(last)) --last;
  if (last == a) return;
  Dictionary lowest = polyhedron;
  for (int c = 0; c < support.points(); ++c)
    if (c != a && !lowest.constrain(support.excess(c, a), c, work)) return;
  for (int b = a + 1; b <= last; ++b)
    if (wanted(b) && lowest.can_vanish(b, work)) visit(b, lowest);
}

}  // namespace gcs
