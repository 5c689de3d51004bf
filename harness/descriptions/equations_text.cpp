#include "harness/descriptions/equations_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "harness/descriptions/reduced_system.hpp"
#include "harness/descriptions/scene_forms.hpp"
#include "harness/descriptions/unknown_names.hpp"
#include "harness/solving/frame_view.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

using NameList = std::vector<std::string>;

/// How a number and a power are written, and what the unknowns are called.
struct Notation {
  std::string (*magnitude)(const ExactNumber& number);  ///< of a number that is not negative
  NameList names;
};

bool is_negative(const ExactNumber& number) { return rounded_to_double(number).real() < 0; }

/// Decimals that are not 0 do not round to it.
bool is_zero_number(const ExactNumber& number) { return number.value == 0.0 && !number.is_cosine_of_degrees; }

/// 1 or −1.
bool is_one(const ExactNumber& number) {
  const bool has_digits = number.decimal.find_first_not_of("-1") != std::string::npos;
  return !has_digits && !number.is_cosine_of_degrees && std::abs(rounded_to_double(number)) == 1;
}

std::string double_magnitude(const ExactNumber& number) {
  return fmt::format("{:.17g}", std::abs(rounded_to_double(number)));
}

/// The number as the file has it, times a power of two, squared.
std::string exact_magnitude(const ExactNumber& number) {
  if (number.decimal.empty() && !number.is_cosine_of_degrees) return double_magnitude(number);
  std::string text =
      number.decimal.empty() ? fmt::format("{:.17g}", std::abs(number.value.real())) : number.decimal;
  if (text.front() == '-') text.erase(0, 1);
  if (number.is_cosine_of_degrees) text = fmt::format("cos({}*pi/180)", text);
  const bool is_plain = number.exponent == 0 && !number.is_cosine_of_degrees;
  if (number.exponent > 0) text += fmt::format("*{:.17g}", std::ldexp(1.0, number.exponent));
  if (number.exponent < 0) text += fmt::format("/{:.17g}", std::ldexp(1.0, -number.exponent));
  if (!number.is_squared) return text;
  return is_plain ? text + "^2" : fmt::format("({})^2", text);
}

/// " + x" or " - x"; at the beginning "x" or "-x".
void append(std::string& sum, bool is_negative, const std::string& term) {
  if (sum.empty())
    sum = (is_negative ? "-" : "") + term;
  else
    sum += (is_negative ? " - " : " + ") + term;
}

std::string term_text(const ScaledUnknown& term, const Notation& notation) {
  const std::string& name = notation.names[static_cast<std::size_t>(term.unknown)];
  return is_one(term.coefficient) ? name : notation.magnitude(term.coefficient) + "*" + name;
}

std::string form_text(const LinearForm& form, const Notation& notation) {
  std::string text;
  for (const ScaledUnknown& term : form.terms)
    if (!is_zero_number(term.coefficient))
      append(text, is_negative(term.coefficient), term_text(term, notation));
  if (!is_zero_number(form.constant) || text.empty())
    append(text, is_negative(form.constant), notation.magnitude(form.constant));
  return text;
}

/// A form of one summand without its sign, or all of it in parentheses.
struct Factor {
  bool is_negative = false;
  std::string text;
};

Factor factor_of(const LinearForm& form, const Notation& notation) {
  if (form.terms.empty()) return {is_negative(form.constant), notation.magnitude(form.constant)};
  if (form.terms.size() == 1 && form.constant.is_zero())
    return {is_negative(form.terms[0].coefficient), term_text(form.terms[0], notation)};
  return {false, "(" + form_text(form, notation) + ")"};
}

bool is_number(const LinearForm& form) { return form.terms.empty(); }

bool is_nothing(const LinearForm& form) {
  return is_zero_number(form.constant) &&
         std::all_of(form.terms.begin(), form.terms.end(),
                     [](const ScaledUnknown& term) { return is_zero_number(term.coefficient); });
}

bool is_plus_one(const LinearForm& form) {
  return is_number(form) && is_one(form.constant) && !is_negative(form.constant);
}

/// Whether its factor may be followed by a power: an unknown, or a sum in parentheses.
bool is_power_base(const LinearForm& form) {
  if (is_number(form)) return false;
  return form.terms.size() > 1 || !form.constant.is_zero() || is_one(form.terms[0].coefficient);
}

void append_product(std::string& sum, const FormProduct& product, const Notation& notation) {
  if (is_nothing(product.left) || is_nothing(product.right)) return;
  const Factor left = factor_of(product.left, notation), right = factor_of(product.right, notation);
  const bool sign = left.is_negative != right.is_negative;
  if (is_plus_one(product.right))
    append(sum, sign, left.text);
  else if (is_plus_one(product.left))
    append(sum, sign, right.text);
  else if (left.text == right.text && is_power_base(product.left))
    append(sum, sign, left.text + "^2");
  else
    append(sum, sign, left.text + "*" + right.text);
}

std::string equation_text(const QuadraticEquation& equation, const Notation& notation) {
  std::string left;
  for (const FormProduct& product : equation.products) append_product(left, product, notation);
  const std::string right = form_text({{}, equation.given}, notation);
  return (left.empty() ? "0" : left) + " = " + right;
}

/// PHCpack multiplies no numbers: those that stand alone are added up.
std::string polynomial_text(const QuadraticEquation& equation, const Notation& notation) {
  std::string text;
  double number = -rounded_to_double(equation.given).real();
  for (const FormProduct& product : equation.products)
    if (is_number(product.left) && is_number(product.right))
      number += (rounded_to_double(product.left.constant) * rounded_to_double(product.right.constant)).real();
    else
      append_product(text, product, notation);
  if (number != 0 || text.empty()) append(text, number < 0, double_magnitude(exactly(number)));
  return text + ";";
}

/// Letters, digits and _; never begins as i, the imaginary unit, or as an exponent does.
std::string phc_name(std::string name) {
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  const bool is_read = std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
                       std::string_view("iIeE").find(name.front()) == std::string_view::npos;
  return is_read ? name : "v_" + name;
}

/// Different ones stay different, and none is longer than PHCpack reads.
NameList phc_names(const NameList& names) {
  constexpr std::size_t longest = 60;
  NameList result;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const std::string wanted = phc_name(name).substr(0, longest);
    std::string free = wanted;
    for (int i = 2; !taken.insert(free).second; ++i) free = fmt::format("{}_{}", wanted, i);
    result.push_back(free);
  }
  return result;
}

/// Where elements are, in the words of the unknowns.
class Positions {
 public:
  Positions(const Scene& scene, const SceneForms& forms, const Notation& notation,
            const std::map<int, LinearForm>& replaced)
      : problem_(scene.problem()),
        dimension_(scene.dimension()),
        forms_(forms),
        notation_(notation),
        replaced_(replaced) {}

  std::string json() const {
    JsonMembers points, lines, planes;
    for (std::size_t i = 0; i < forms_.points.size(); ++i)
      points.emplace_back(problem_.points[i], vector(forms_.points[i]));
    for (std::size_t i = 0; i < forms_.lines.size(); ++i)
      lines.emplace_back(problem_.lines[i], json_object({{"point", vector(forms_.lines[i].foot)},
                                                         {"direction", vector(forms_.lines[i].direction)}}));
    for (std::size_t i = 0; i < forms_.planes.size(); ++i)
      planes.emplace_back(problem_.planes[i], json_object({{"normal", vector(forms_.planes[i].normal)},
                                                           {"offset", form(forms_.planes[i].offset)}}));
    return to_text(json_object({{"points", json_object(points)},
                                {"lines", json_object(lines)},
                                {"planes", json_object(planes)}}),
                   -1);
  }

 private:
  JsonValue vector(const VectorForm& forms) const {
    std::vector<JsonValue> components;
    for (int axis = 0; axis < dimension_; ++axis)
      components.push_back(form(forms[static_cast<std::size_t>(axis)]));
    return json_array(components);
  }

  JsonValue form(const LinearForm& form) const {
    return json_text(form_text(substituted(form, replaced_), notation_));
  }

  const ProblemStatement& problem_;
  int dimension_;
  const SceneForms& forms_;
  const Notation& notation_;
  const std::map<int, LinearForm>& replaced_;
};

std::string frame_words(const Scene& scene) {
  std::vector<std::string> parts;
  for (const auto& [part, name] : frame_parts(scene)) parts.push_back(part + " " + name);
  return parts.empty() ? "positions are fixed" : fmt::format("{}", fmt::join(parts, ", "));
}

/// What the names and numbers do not say.
std::string remark(const Scene& scene) {
  return fmt::format("{}: lengths in units of {:.17g}; frame: {}",
                     scene.problem().dimension == 2 ? "plane" : "space",
                     std::ldexp(1.0, scene.unit_exponent()), frame_words(scene));
}

std::string plain_text(const Scene& scene, const QuadraticSystem& system, const Notation& notation) {
  std::string text = "# " + remark(scene) + "\n";
  for (const QuadraticEquation& equation : system.equations) text += equation_text(equation, notation) + "\n";
  return text;
}

std::string phc_text(const ReducedSystem& reduced, const Notation& notation) {
  const std::size_t equations = reduced.system.equations.size();
  const std::size_t unknowns = static_cast<std::size_t>(reduced.system.unknowns) - reduced.replaced.size();
  std::string text =
      fmt::format("{}{}\n", equations, equations == unknowns ? "" : fmt::format(" {}", unknowns));
  for (const QuadraticEquation& equation : reduced.system.equations)
    text += polynomial_text(equation, notation) + "\n";
  return text;
}

}  // namespace

std::string_view word(EquationsForm form) {
  constexpr std::array<std::string_view, all_equations_forms.size()> words{"text", "phc", "reduced"};
  return words[static_cast<std::size_t>(form)];
}

std::optional<std::string> why_no_equations(const Scene& scene) {
  return scene.problem().is_general() ? why_no_system(scene) : why_not_certified(scene);
}

std::string equations_text(const Scene& scene, EquationsForm form) {
  const SceneEquations equations(scene);
  const NameList names = unknown_names(scene, equations);
  if (form == EquationsForm::text) return plain_text(scene, equations.system(), {exact_magnitude, names});
  ReducedSystem reduced{equations.system(), {}};
  if (form == EquationsForm::reduced) reduced = reduced_system(reduced.system);
  const SceneForms forms = in_file(scene_forms(scene, equations), scene);
  const Notation notation{double_magnitude, phc_names(names)};
  return phc_text(reduced, notation) + "\n" + remark(scene) + "\n" +
         Positions(scene, forms, notation, reduced.replaced).json() + "\n";
}

}  // namespace gcs
