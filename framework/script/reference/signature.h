#pragma once
// Signatures of functions as they are written in descriptors: `quit(status?: integer)`.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

struct Parameter {
    std::string name;  // "..." for the rest
    std::string type;
    bool optional = false;
};

struct Signature {
    std::string name;
    std::vector<Parameter> parameters;
    std::vector<std::string> returns;  // types
};

/// Each line of `text`. Throws std::invalid_argument, naming the text, for one that is malformed.
std::vector<Signature> parse_signatures(std::string_view text);
/// As it was written, without a parameter `self`.
std::string typed(const Signature& signature);
/// Without types, and `self`, for lists: `quit([status])`.
std::string plain(const Signature& signature);
/// All of `text` without types, joined with " or ".
std::string plain_signatures(std::string_view text);
/// Where the list `a, b<c, d>, fun(e, f)` is to be cut: parts between commas outside of brackets.
std::vector<std::string> split_list(std::string_view text);

}  // namespace fettle::script
