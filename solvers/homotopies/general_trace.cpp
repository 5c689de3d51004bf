#include "solvers/homotopies/general_trace.hpp"

#include <algorithm>

#include "solvers/homotopies/precise_zero.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// In E; a few random ones are generic enough, and more cost time.
constexpr std::size_t most_products = 10;

/// Equations for (x, s, E).
class GeneralTrace {
 public:
  GeneralTrace(const GeneralEquations& equations, std::mt19937_64& random)
      : equations_(equations),
        s_(equations.system.unknowns),
        direction_(random_complex_vector(equations.system.equations(), random)) {
    choose_products(random);
    const ComplexVectorX weights = random_complex_vector(static_cast<int>(products_.size()) + 1, random);
    system_.unknowns = s_ + 2;
    add_equations();
    for (std::size_t i = 0; i < products_.size(); ++i) add(products_[i], weights[i]);
    add({e(), -1}, -1);
    add({-1, -1}, weights.back());
    end_equation();
    add({e(), s_}, 1);
    product_ = static_cast<int>(coefficients_.size());
    add({-1, -1}, 0);
    end_equation();
  }

  const MonomialSystem& system() const { return system_; }

  TraceProblem problem() const {
    SignMasks signs = equations_.signs;
    signs.push_back(0);
    signs.push_back(0);
    std::vector<bool> is_free(coefficients_.size(), false);
    for (const int j : values_) is_free[j] = true;
    is_free[product_] = true;
    std::vector<Monomial> terms = products_;
    terms.push_back({s_, -1});
    return {{std::move(signs), std::move(is_free), false,
             [this](std::mt19937_64& random) { return random_member(random); }},
            s_,
            product_,
            std::move(terms),
            [this](const ComplexVectorX& coefficients, const ComplexVectorX& x) {
              return precise_zero(system_, coefficients, x);
            }};
  }

  FamilyMember random_member(std::mt19937_64& random) const {
    const FamilyMember base = gcs::random_member(equations_, random);
    FamilyMember member{base.x, coefficients_};
    const Complex s = random_complex_vector(1, random).front();
    member.x.push_back(s);
    Complex value = 0;
    for (int j = system_.first[system_.equations() - 2]; j < system_.first[system_.equations() - 1]; ++j)
      if (system_.monomials[j].u != e())
        value += coefficients_[j] * monomial_at(system_.monomials[j], member.x);
    member.x.push_back(value);
    for (std::size_t i = 0; i < values_.size(); ++i)
      member.parameters[values_[i]] =
          base.parameters[equations_.value_monomial[valued_[i]]] + s * direction_[i];
    member.parameters[product_] = -s * value;
    return member;
  }

 private:
  int e() const { return s_ + 1; }
  void add(const Monomial& monomial, Complex coefficient) {
    system_.monomials.push_back(monomial);
    coefficients_.push_back(coefficient);
  }
  void end_equation() { system_.first.push_back(static_cast<int>(coefficients_.size())); }

  /// The equations of the scene, less s·V where they have a value.
  void add_equations() {
    const MonomialSystem& own = equations_.system;
    for (int equation = 0; equation < own.equations(); ++equation) {
      for (int j = own.first[equation]; j < own.first[equation + 1]; ++j) {
        if (j == equations_.value_monomial[equation]) {
          values_.push_back(static_cast<int>(coefficients_.size()));
          valued_.push_back(equation);
        }
        add(own.monomials[j], equations_.coefficients[j]);
      }
      if (equations_.value_monomial[equation] >= 0) add({s_, -1}, -direction_[values_.size() - 1]);
      end_equation();
    }
  }

  /// Unknowns at random, each with another one of its mask or squared.
  void choose_products(std::mt19937_64& random) {
    const auto n = static_cast<std::size_t>(s_);
    for (std::size_t i = 0; i < most_products; ++i) {
      const auto a = static_cast<int>(random() % n);
      std::vector<int> alike;
      for (int b = 0; b < s_; ++b)
        if (equations_.signs[b] == equations_.signs[a]) alike.push_back(b);
      const int b = i % 2 == 0 ? a : alike[random() % alike.size()];
      const Monomial product{std::max(a, b), std::min(a, b)};
      if (std::none_of(products_.begin(), products_.end(),
                       [&](const Monomial& known) { return known.u == product.u && known.v == product.v; }))
        products_.push_back(product);
      if (const Monomial alone{a, -1};
          equations_.signs[a] == 0 &&
          std::none_of(products_.begin(), products_.end(),
                       [&](const Monomial& known) { return known.u == alone.u && known.v == alone.v; }))
        products_.push_back(alone);
    }
  }

  const GeneralEquations& equations_;
  int s_;
  ComplexVectorX direction_;  // V, one per equation with a value
  std::vector<Monomial> products_;
  MonomialSystem system_;
  ComplexVectorX coefficients_;
  std::vector<int> values_;  // the monomials whose coefficients are minus A
  std::vector<int> valued_;  // and their equations
  int product_ = 0;
};

}  // namespace

TraceTest test_trace(const GeneralEquations& equations, const TrackingSetup& setup,
                     const MonodromyOptions& options, std::mt19937_64& random,
                     const std::function<bool()>& stopped, const std::function<void(int)>& progress,
                     WorkCounters& work) {
  const GeneralTrace trace(equations, random);
  const TraceProblem problem = trace.problem();
  const Elimination elimination = order_elimination(trace.system(), problem.family, random);
  LegTracking tracking(trace.system(), elimination, setup);
  return test_trace(problem, tracking, options, random, stopped, progress, work);
}

}  // namespace gcs
