// What editors and readers of the case format need, made from the tables of keys.
#pragma once

#include <string>

namespace hawser::io {

/// JSON Schema, draft 7, of a case file. What the file itself must contain is asked only of files
/// without `base` and `include`.
std::string case_schema();

/// A commented case with every key: sentence, kind, default, range. Keys that stand instead of
/// others are written as comments.
std::string reference_case();

}  // namespace hawser::io
