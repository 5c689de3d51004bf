#pragma once
/// Solutions that differ by a change of signs, such as a reflection in a coordinate plane of the frame, are one class.

#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "solvers/lanes/square_system.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// As many unknowns whose reflections are not divided out.
std::vector<int> divided_by_none(const std::vector<int>& axes);

/// How many solutions a class has at generic lengths: 2 to the number of axes.
int image_count(const std::vector<int>& axes);

/// What the uncertainty of a solution x is relative to: 1 + the largest |x_i|, or for every entry |x_i| itself.
enum class RelativeTo { largest, each };

/// Finds solutions of one system again, up to changes of signs, in a list that somebody else keeps.
class SolutionIndex {
 public:
  /// Of the list, by number.
  using SolutionAt = std::function<const ComplexVectorX&(int)>;

  SolutionIndex(SignMasks signs, std::mt19937_64& random);

  /// The number of the solution that equals x up to signs, or −1.
  int find(const ComplexVectorX& x, double uncertainty, RelativeTo size, const SolutionAt& at) const;
  /// Of the next one in the list.
  void add(const ComplexVectorX& x, double uncertainty, RelativeTo size);

  int size() const { return static_cast<int>(accuracies_.size()); }

 private:
  struct Key {
    double value = 0;   ///< the same for all signs
    double window = 0;  ///< how far those of equal solutions may be apart
  };

  struct Accuracy {
    double uncertainty = 0;
    RelativeTo size = RelativeTo::largest;
  };

  Key key_of(const ComplexVectorX& x, double uncertainty) const;
  bool equal(const ComplexVectorX& x, const ComplexVectorX& y, const Accuracy& accuracy) const;

  SignMasks signs_;
  std::vector<std::size_t>
      kind_;  ///< of each unknown: which of the different masks it has, 0: its sign stays
  std::size_t kinds_;
  std::vector<double> weights_;
  std::vector<Accuracy> accuracies_;
  std::multimap<double, int> by_key_;
};

/// Distinct solutions of one system, up to changes of signs.
class SolutionSet {
 public:
  SolutionSet(SignMasks signs, std::mt19937_64& random) : index_(std::move(signs), random) {}

  /// The number of the solution that equals x up to signs, or −1.
  int find(const ComplexVectorX& x, double uncertainty, RelativeTo size = RelativeTo::largest) const;
  /// The number of x, which is a new one where `find` knows none.
  int insert(const ComplexVectorX& x, double uncertainty, RelativeTo size = RelativeTo::largest);

  int size() const { return index_.size(); }
  const ComplexVectorX& operator[](int i) const { return solutions_[i]; }
  const std::vector<ComplexVectorX>& solutions() const { return solutions_; }

 private:
  SolutionIndex index_;
  std::vector<ComplexVectorX> solutions_;
};

/// The first of each class, of solutions that are regular.
std::vector<ComplexVectorX> one_of_each_class(const std::vector<ComplexVectorX>& solutions,
                                              const std::vector<int>& axes, std::mt19937_64& random);

}  // namespace gcs
