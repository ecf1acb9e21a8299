#pragma once
// Parses signatures of functions in descriptors: `quit(status?: integer)`.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

struct Parameter {
    std::string name;  // "..." for variable arguments
    std::string type;
    bool optional = false;
};

struct Signature {
    std::string name;
    std::vector<Parameter> parameters;
    std::vector<std::string> returns;  // types
};

/// Parses each line of `text`. Throws std::invalid_argument, which contains the text, if one is
/// malformed.
std::vector<Signature> parse_signatures(std::string_view text);
/// The signature with types, without a parameter `self`.
std::string typed(const Signature& signature);
/// The signature without types and without `self`, for lists: `quit([status])`.
std::string plain(const Signature& signature);
/// All signatures in `text` without types, joined with " or ".
std::string plain_signatures(std::string_view text);
/// Splits `a, b<c, d>, fun(e, f)` at the commas outside of brackets.
std::vector<std::string> split_list(std::string_view text);

}  // namespace fettle::script
