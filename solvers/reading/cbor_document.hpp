#pragma once
/// Documents as CBOR (RFC 8949): the same values as in JSON, in fewer bytes. A number is the integer or the float whose
/// shortest text it is; one that is written otherwise, as 1.50 or with more digits than a double has, is a byte string of
/// its decimal text, which JSON leaves no other use for.

#include <string>
#include <string_view>

#include "solvers/reading/element_taker.hpp"
#include "solvers/reading/json_value.hpp"

namespace gcs {

/// Whether the bytes begin as a map of CBOR does, and no text in UTF-8.
bool is_cbor_map(std::string_view bytes);

/// The value in `bytes`: parse_json of to_cbor's value is that of its JSON text. Refuses (InputError with the place) what
/// parse_json does, and what JSON has no word for: NaN and infinity, tags, strings in chunks, integers beyond 64 bits.
/// `file` is only used in messages.
JsonValue parse_cbor(std::string_view bytes, const std::string& file, const ElementTaker& taker = {});

/// The value in `bytes`, CBOR where is_cbor_map(), else JSON, less what is taken. Throws InputError.
JsonValue parse_document(std::string_view bytes, const std::string& file, const ElementTaker& taker = {});

/// The value as CBOR, every length known.
std::string to_cbor(const JsonValue& value);

}  // namespace gcs
