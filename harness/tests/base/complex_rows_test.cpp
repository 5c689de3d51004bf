#include "harness/base/complex_rows.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "solvers/reading/json_build.hpp"
#include "solvers/reading/json_document.hpp"

using namespace gcs;

namespace {

JsonValue json_rows(const std::vector<ComplexVectorX>& rows) {
  return json_array_of(rows, [](const ComplexVectorX& row) { return json_array_of(row, json_complex); });
}

/// A finite double with any bits.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value) && std::abs(value) >= 1e-300) return value;
  }
}

bool is_taken(const std::string& array) {
  return take_complex_rows("{\"rows\": " + array + "}", "rows", 2).has_value();
}

}  // namespace

TEST_CASE("rows are read to the same bits as JSON values, in any layout") {
  std::mt19937_64 random(5);
  std::vector<ComplexVectorX> rows;
  for (int i = 0; i < 50; ++i) {
    ComplexVectorX& row = rows.emplace_back();
    for (int j = 0; j < 3; ++j) row.emplace_back(any_double(random), any_double(random));
  }
  const JsonValue document = json_object(
      {{"a", json_object({{"rows", json_number(1)}})}, {"rows", json_rows(rows)}, {"z", json_null()}});
  for (const int indent : {-1, 0, 3}) {
    const std::string text = to_text(document, indent);
    const auto taken = take_complex_rows(text, "rows", 3);
    REQUIRE(taken);
    CHECK(taken->rows == rows);
    const JsonValue slow = parse_json(text, "slow"), rest = parse_json(taken->rest, "rest");
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const JsonValue& pair = slow.find("rows")->elements[i].elements[j];
        CHECK(taken->rows[i][j] == std::complex(pair.elements[0].number, pair.elements[1].number));
      }
    CHECK(rest.find("rows")->elements.empty());
    CHECK(to_text(rest, -1) == "{\"a\": {\"rows\": 1}, \"rows\": [], \"z\": null}");
  }
}

TEST_CASE("what is JSON but not such rows, or no JSON, is left to the parser") {
  REQUIRE(is_taken("[[[1, -2.5e-3], [0, 1E+2]], [[-0.0, 10], [3, 4]]]"));
  REQUIRE(is_taken("[]"));
  for (const std::string number : {"01", "-01", ".5", "5.", "5.e1", "+1", "nan", "inf", "-inf", "0x1",
                                   "1e999", "1e-999", "-", "", "true", "\"1\"", "[1]", "1 2"}) {
    INFO(number);
    CHECK_FALSE(is_taken("[[[1, " + number + "], [0, 1]]]"));
  }
  for (const std::string array :
       {"[[[1, 2]]]", "[[[1, 2], [3, 4], [5, 6]]]", "[[[1, 2], [3]]]", "[[[1, 2], [3, 4, 5]]]",
        "[[[1, 2], [3, 4]]", "[[[1, 2], [3, 4]],]", "[1]"}) {
    INFO(array);
    CHECK_FALSE(is_taken(array));
  }
  CHECK_FALSE(take_complex_rows("{\"other\": []}", "rows", 2));
  CHECK_FALSE(take_complex_rows("{\"rows\"", "rows", 2));
}
