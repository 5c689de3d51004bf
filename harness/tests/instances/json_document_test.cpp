#include "solvers/reading/json_document.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solvers/reading/element_taker.hpp"
#include "solvers/reading/json_build.hpp"

namespace {

using gcs::InputError;
using gcs::JsonValue;

JsonValue parsed(std::string_view text) { return gcs::parse_json(text, "file.json"); }

/// The text is refused at that pointer, and the message begins with the file and holds the word.
void check_refused(std::string_view text, const std::string& pointer, const std::string& word) {
  INFO("text: " << text.substr(0, 80));
  try {
    parsed(text);
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.pointer() == pointer);
    CHECK_THAT(error.what(), Catch::StartsWith("file.json: ") && Catch::Contains(word));
  }
}

}  // namespace

TEST_CASE("every number keeps its decimal text and has the nearest double") {
  const JsonValue value =
      parsed("[1, -5, 0, -0, 1e2, 1.50, 0.1, 2.1050, 18446744073709551616, -9223372036854775809, 1E+3]");
  const std::vector<std::pair<std::string, double>> expected{{"1", 1},
                                                             {"-5", -5},
                                                             {"0", 0},
                                                             {"-0", -0.0},
                                                             {"1e2", 100},
                                                             {"1.50", 1.5},
                                                             {"0.1", 0.1},
                                                             {"2.1050", 2.105},
                                                             {"18446744073709551616", 18446744073709551616.0},
                                                             {"-9223372036854775809", -9223372036854775808.0},
                                                             {"1E+3", 1000}};
  REQUIRE(value.elements.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(value.elements[i].kind == JsonValue::Kind::number);
    CHECK(value.elements[i].text == expected[i].first);
    CHECK(value.elements[i].number == expected[i].second);
  }
  CHECK(std::signbit(value.elements[3].number));
}

TEST_CASE("all kinds of values are read") {
  const JsonValue value = parsed(R"({"n": null, "t": true, "f": false, "s": "ä\u00e4\n", "a": [], "o": {}})");
  REQUIRE(value.kind == JsonValue::Kind::object);
  CHECK(value.find("n")->kind == JsonValue::Kind::null);
  CHECK(value.find("t")->boolean);
  CHECK_FALSE(value.find("f")->boolean);
  CHECK(value.find("s")->text == "ää\n");
  CHECK(value.find("a")->kind == JsonValue::Kind::array);
  CHECK(value.find("o")->kind == JsonValue::Kind::object);
  CHECK(value.find("x") == nullptr);
  CHECK(value.members.front().first == "n");
  CHECK(value.members.back().first == "o");
}

TEST_CASE("a value written out and read again is the same text") {
  const std::string text = R"({"b": [1.50, {"a": -0, "c": []}, "q\"\\/ä"], "a": {}, "n": null, "t": true})";
  CHECK(to_text(parsed(text), -1) == text);
  const std::string indented = to_text(parsed(text), 1);
  CHECK_THAT(indented, Catch::StartsWith("{\n \"b\": [\n  1.50,\n  {\n   \"a\": -0,"));
  CHECK(to_text(parsed(indented), -1) == text);
  CHECK(to_text(parsed(indented), 1) == indented);
}

// nlohmann's writer says how.
TEST_CASE("every byte of a text is written as JSON has it") {
  const auto written = [](const std::string& text) { return to_text(gcs::json_text(text), -1); };
  for (int byte = 0; byte < 256; ++byte)
    for (const std::string& around : {std::string(), std::string("ab")}) {
      const std::string text = around + static_cast<char>(byte) + around;
      CHECK(written(text) ==
            nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
  CHECK(written("") == "\"\"");
}

TEST_CASE("numbers that a double cannot hold are refused") {
  check_refused("[1, 1e400]", "/1", "'1e400' is too large");
  check_refused(R"({"a": {"b": -1e400}})", "/a/b", "too large");
  check_refused(R"({"a": [0, 1e-400]})", "/a/1", "'1e-400' is too small");
  check_refused("[0." + std::string(400, '0') + "1]", "/0", "too small");
  CHECK(parsed("[0e-999]").elements[0].number == 0);
  CHECK(parsed("[1e-320]").elements[0].number > 0);
}

TEST_CASE("numbers that JSON does not have are refused") {
  for (const char* word : {"NaN", "nan", "Infinity", "-Infinity", "-inf"}) {
    check_refused(std::string(R"({"x": )") + word + "}", "/x", "NaN and Infinity");
  }
  for (const char* word : {"01", "+1", ".5", "1.", "0x10", "1e", "--1"}) {
    check_refused(std::string("\n[") + word + "]", word[0] == '0' ? "/1" : "/0", "line 2, column ");
  }
}

TEST_CASE("a key given twice is refused with its place") {
  check_refused(R"({"a": 1, "b": {"c": 1, "c": 2}})", "/b/c", "'c' is given twice");
  check_refused(R"([{"x/~y": 1, "x/~y": 1}])", "/0/x~1~0y", "given twice");
  CHECK(parsed(R"([{"a": 1}, {"a": 2}])").elements.size() == 2);
}

TEST_CASE("nesting is limited to 64 levels") {
  CHECK(parsed(std::string(64, '[') + std::string(64, ']')).kind == JsonValue::Kind::array);
  check_refused(std::string(65, '[') + std::string(65, ']'), "", "nested deeper than 64");
  check_refused(std::string(10'000'000, '['), "", "nested deeper than 64");
}

TEST_CASE("text that is not JSON is refused with line and column") {
  check_refused("{\n \"a\": 1,\n \"b\": ]\n}", "/b", "line 3, column 7: not JSON: unexpected ']'");
  check_refused("{'a': 1}", "", "line 1, column 2");
  check_refused("[1,]", "/1", "line 1, column 4");
  check_refused("[1 2]", "/1", "expected ']'");
  check_refused("[1", "/1", "unexpected end of input");
  check_refused("// comment\n[]", "", "line 1, column 1");
}

TEST_CASE("anything after the value is refused") {
  check_refused("{} {}", "", "expected end of input");
  check_refused("1 x", "", "line 1, column 3");
  check_refused(std::string_view("{}\0{}", 5), "", "line 1, column 3: not JSON: a zero byte");
}

TEST_CASE("empty input has its own message") {
  check_refused("", "", "the input is empty");
  check_refused(" \n\t", "", "the input is empty");
}

TEST_CASE("invalid UTF-8 is refused and not repeated") {
  check_refused("[\"\xff\"]", "/0", "ill-formed UTF-8");
  check_refused("[\"\xc0\xaf\"]", "/0", "ill-formed UTF-8");
  check_refused(R"(["\ud800"])", "/0", "surrogate");
  check_refused("[\"\xed\xa0\x80\"]", "/0", "ill-formed UTF-8");
}

TEST_CASE("elements of one list are handed on, and counted in the places of what follows") {
  std::vector<std::size_t> numbers;
  std::string seen;
  const gcs::ElementTaker odd{"long",
                              [&](const JsonValue& document, const JsonValue& element, std::size_t n) {
                                CHECK(document.find("first")->number == 7);
                                CHECK(document.find("last") == nullptr);
                                numbers.push_back(n);
                                if (n % 2 == 0) return false;
                                seen += to_text(element, -1) + " ";
                                return true;
                              }};
  const std::string text =
      R"({"first": 7, "long": [1, {"a": 2}, 3, ["long"]], "other": {"long": [5]}, "last": 0})";
  CHECK(to_text(gcs::parse_json(text, "f", odd), -1) ==
        R"({"first": 7, "long": [1, 3], "other": {"long": [5]}, "last": 0})");
  CHECK(seen == R"({"a": 2} ["long"] )");
  CHECK(numbers == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(to_text(gcs::parse_json(text, "f"), -1) == text);
  const gcs::ElementTaker all{"long", [](const JsonValue&, const JsonValue&, std::size_t) { return true; }};
  try {
    gcs::parse_json(R"({"long": [0, 1, {"a": 1e999}]})", "f", all);
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.pointer() == "/long/2/a");
  }
}

TEST_CASE("messages repeat only the beginning of what is wrong") {
  const std::string key(1000, 'k');
  try {
    parsed("[\"" + std::string(1'000'000, 'x'));
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).size() < 300);
  }
  check_refused("{\"" + key + "\": 1, \"" + key + "\": 2}", "/" + key, std::string(40, 'k') + "…'");
}

TEST_CASE("an error says file, place, what is wrong and what would be right") {
  CHECK(InputError("f.json", "/a/0", "wrong", "right").what() == std::string("f.json: /a/0: wrong; right"));
  CHECK(InputError("f.json", "", "wrong", "").what() == std::string("f.json: wrong"));
}
