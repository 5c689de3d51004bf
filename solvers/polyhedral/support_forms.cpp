#include "solvers/polyhedral/support_forms.hpp"

namespace gcs {
namespace {

SparseForm difference(const Exponents& c, const Exponents& a, double lifting) {
  SparseForm form{lifting, {}};
  for (std::size_t v = 0; v < c.size(); ++v)
    if (c[v] != a[v]) form.terms.push_back({static_cast<int>(v), static_cast<double>(c[v] - a[v])});
  return form;
}

}  // namespace

SupportForms::SupportForms(const Support& support, const std::vector<double>& lifting)
    : points_(static_cast<int>(support.size())), differs_(support.front().size(), false) {
  for (int c = 0; c < points_; ++c)
    for (int a = 0; a < points_; ++a)
      forms_.push_back(difference(support[c], support[a], lifting[c] - lifting[a]));
  for (const SparseForm& form : forms_)
    for (const SparseForm::Term& term : form.terms) differs_[term.unknown] = true;
}

bool SupportForms::meets(const SupportForms& other) const {
  for (std::size_t v = 0; v < differs_.size(); ++v)
    if (differs_[v] && other.differs_[v]) return true;
  return false;
}

}  // namespace gcs
