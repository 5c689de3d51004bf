#include "solvers/reading/cbor_document.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "solvers/reading/json_build.hpp"
#include "solvers/reading/json_document.hpp"

using namespace gcs;

namespace {

std::string bytes_of(const std::string& hexadecimal) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16));
  return bytes;
}

std::string json_of_cbor(const std::string& hexadecimal) {
  return to_text(parse_cbor(bytes_of(hexadecimal), "f.cbor"), -1);
}

std::string refusal(const std::string& bytes) {
  try {
    parse_cbor(bytes, "f.cbor");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct Example {
  std::string cbor;
  std::string json;
};

}  // namespace

// RFC 8949, appendix A: of its examples those that JSON has, with one spelling of each number.
TEST_CASE("the examples of the standard read as their values") {
  const std::vector<Example> examples{
      {"00", "0"},
      {"17", "23"},
      {"1818", "24"},
      {"1903e8", "1000"},
      {"1a000f4240", "1000000"},
      {"1b000000e8d4a51000", "1000000000000"},
      {"1bffffffffffffffff", "18446744073709551615"},
      {"20", "-1"},
      {"3863", "-100"},
      {"3903e7", "-1000"},
      {"fb3ff199999999999a", "1.1"},
      {"f93e00", "1.5"},
      {"fa47c35000", "100000"},
      {"fa7f7fffff", "3.4028234663852886e+38"},
      {"fb7e37e43c8800759c", "1e+300"},
      {"f90001", "5.960464477539063e-08"},
      {"fbc010666666666666", "-4.1"},
      {"f4", "false"},
      {"f5", "true"},
      {"f6", "null"},
      {"60", "\"\""},
      {"6449455446", "\"IETF\""},
      {"62225c", "\"\\\"\\\\\""},
      {"63e6b0b4", "\"水\""},
      {"8301820203820405", "[1, [2, 3], [4, 5]]"},
      {"a26161016162820203", "{\"a\": 1, \"b\": [2, 3]}"},
      {"9f018202039f0405ffff", "[1, [2, 3], [4, 5]]"},
      {"bf61610161629f0203ffff", "{\"a\": 1, \"b\": [2, 3]}"},
      {"bf6346756ef563416d7421ff", "{\"Fun\": true, \"Amt\": -2}"},
  };
  for (const Example& example : examples) CHECK(json_of_cbor(example.cbor) == example.json);
}

TEST_CASE("a value is written by the standard in as few bytes as its number takes") {
  const std::vector<Example> examples{
      {"00", "0"},
      {"1903e8", "1000"},
      {"1bffffffffffffffff", "18446744073709551615"},
      {"3863", "-100"},
      {"fb3ff199999999999a", "1.1"},
      {"fa3fc00000", "1.5"},
      {"fb7e37e43c8800759c", "1e+300"},
      {"a26161016162820203", "{\"a\": 1, \"b\": [2, 3]}"},
  };
  for (const Example& example : examples)
    CHECK(to_cbor(parse_json(example.json, "f")) == bytes_of(example.cbor));
}

TEST_CASE("whatever JSON says comes back from CBOR as it was written") {
  for (const std::string text :
       {"2.0", "-0", "1e5", "1E-3", "0.10", "18446744073709551616", "-9223372036854775808",
        "-9223372036854775809", "0.1234567890123456789012345678901234567890", "5e-324",
        "1.7976931348623157e+308", "9007199254740993", "[]", "{}",
        "{\"b\": null, \"a\": [\"é\\u0000\\n\", true, [[]]]}"}) {
    const JsonValue value = parse_json(text, "f");
    const JsonValue back = parse_cbor(to_cbor(value), "f");
    CHECK(to_text(back, -1) == to_text(value, -1));
    CHECK(back.number == value.number);
  }
}

TEST_CASE("computed numbers come back from CBOR as JSON shows them") {
  for (const double number : {0.0, -0.0, 3.0, -7.0, 0.1, -1e300, 5e-324, 9007199254740992.0, 1e17}) {
    const JsonValue value = json_number(number);
    CHECK(to_text(parse_cbor(to_cbor(value), "f"), -1) == to_text(value, -1));
  }
}

TEST_CASE("bytes that are no text are replaced as in JSON") {
  JsonValue value;
  value.kind = JsonValue::Kind::string;
  value.text = "a\xff";
  CHECK(parse_cbor(to_cbor(value), "f").text == "a\xef\xbf\xbd");
}

TEST_CASE("what is no document is refused with its place") {
  const std::vector<Example> examples{
      {"", "byte 1: not CBOR"},
      {"a1", "byte 2: not CBOR"},
      {"a16161fb3ff1", "not CBOR"},
      {"1c", "byte 1: not CBOR"},
      {"0000", "byte 2: not CBOR"},
      {"ff", "byte 1: not CBOR"},
      {"f7", "byte 1: not CBOR"},
      {"a10001", "not CBOR"},
      {"9bffffffffffffffff", "not CBOR"},
      {"7bffffffffffffffff61", "not CBOR"},
      {"c074323031332d30332d32315432303a30343a30305a", "not CBOR"},
      {"a16161f97e00", "f.cbor: /a: NaN and infinity"},
      {"a16161f97c00", "f.cbor: /a: NaN and infinity"},
      {"a161613bffffffffffffffff", "f.cbor: /a: the integer is below -2^63"},
      {"a2616101616102", "the key 'a' is given twice"},
      {"a16161423161", "f.cbor: /a: the byte string is no number"},
      {"a16161425b5d", "f.cbor: /a: the byte string is no number"},
      {"a1616162ff61", "no UTF-8"},
      {"a162ff6101", "no UTF-8"},
      {"7f657374726561646d696e67ff", "byte 1: a string in chunks"},
      {"a161615f423135ff", "byte 4: a string in chunks"},
  };
  for (const Example& example : examples) {
    INFO(example.cbor);
    CHECK_THAT(refusal(bytes_of(example.cbor)), Catch::Contains(example.json));
  }
}

TEST_CASE("no nesting exhausts the stack") {
  for (const char opening : {'\x81', '\x9f', '\x7f', '\x5f', '\xc1'})
    CHECK(refusal(std::string(std::size_t{1} << 22, opening)) != "");
  std::string maps;
  for (int i = 0; i < 1 << 20; ++i) maps += "\xa1\x60";
  CHECK_THAT(refusal(maps), Catch::Contains("nested deeper than 64"));
  // A string in chunks among the chunks of another, after an empty one.
  std::string chunks;
  for (int i = 0; i < 1 << 20; ++i) chunks += "\x7f\x60";
  CHECK_THAT(refusal(chunks), Catch::Contains("a string in chunks"));
}

TEST_CASE("a document is CBOR where it begins as a map of CBOR") {
  CHECK(to_text(parse_document(bytes_of("a1616101"), "f"), -1) == "{\"a\": 1}");
  CHECK(to_text(parse_document("{\"a\": 1}", "f"), -1) == "{\"a\": 1}");
  CHECK_FALSE(is_cbor_map(""));
  CHECK_FALSE(is_cbor_map("[]"));
}
