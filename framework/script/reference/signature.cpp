#include <algorithm>
#include <stdexcept>

#include <reference/signature.h>
#include <text/words.h>

namespace fettle::script {

namespace {

int depth_change(char c) {
    return c == '(' || c == '<' || c == '{' || c == '['   ? 1
           : c == ')' || c == '>' || c == '}' || c == ']' ? -1
                                                          : 0;
}

/// Position of the bracket that closes the one at `open`.
std::size_t closing(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += depth_change(text[i]);
        if (depth == 0) return i;
    }
    return std::string_view::npos;
}

Parameter parse_parameter(const std::string& text) {
    Parameter parameter;
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon == 0)
        throw std::invalid_argument("parameter without a type");
    parameter.name = trimmed(std::string_view(text).substr(0, colon));
    parameter.type = trimmed(std::string_view(text).substr(colon + 1));
    if (!parameter.name.empty() && parameter.name.back() == '?') {
        parameter.optional = true;
        parameter.name.pop_back();
    }
    if (parameter.name.empty() || parameter.type.empty())
        throw std::invalid_argument("parameter without a name or a type");
    return parameter;
}

Signature parse_signature(std::string_view text) {
    Signature signature;
    const std::size_t open = text.find('(');
    const std::size_t close = open == std::string_view::npos ? open : closing(text, open);
    if (open == 0 || close == std::string_view::npos) throw std::invalid_argument("no parameters");
    signature.name = std::string(text.substr(0, open));
    for (const std::string& part : split_list(text.substr(open + 1, close - open - 1)))
        signature.parameters.push_back(parse_parameter(part));
    const std::string_view rest = trimmed(text.substr(close + 1));
    if (rest.empty()) return signature;
    if (rest.front() != ':') throw std::invalid_argument("unexpected text after the parameters");
    signature.returns = split_list(rest.substr(1));
    if (signature.returns.empty()) throw std::invalid_argument("no type after the colon");
    return signature;
}

}  // namespace

std::vector<std::string> split_list(std::string_view text) {
    std::vector<std::string> parts;
    int depth = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        if (i < text.size()) depth += depth_change(text[i]);
        if (i < text.size() && (text[i] != ',' || depth != 0)) continue;
        std::string part(trimmed(text.substr(start, i - start)));
        if (!part.empty()) parts.push_back(std::move(part));
        start = i + 1;
    }
    return parts;
}

std::vector<Signature> parse_signatures(std::string_view text) {
    std::vector<Signature> signatures;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, end - start);
        try {
            signatures.push_back(parse_signature(line));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("signature \"" + std::string(line) + "\": " + error.what());
        }
        start = end + 1;
    }
    return signatures;
}

std::string typed(const Signature& signature) {
    std::string text = signature.name + "(";
    bool first = true;
    for (const Parameter& parameter : signature.parameters) {
        if (parameter.name == "self") continue;
        text += (first ? "" : ", ") + parameter.name + (parameter.optional ? "?: " : ": ") +
                parameter.type;
        first = false;
    }
    text += ")";
    for (std::size_t i = 0; i < signature.returns.size(); ++i)
        text += (i == 0 ? ": " : ", ") + signature.returns[i];
    return text;
}

std::string plain(const Signature& signature) {
    std::string text = signature.name + "(";
    bool first = true;
    for (const Parameter& parameter : signature.parameters) {
        if (parameter.name == "self") continue;
        if (parameter.optional)
            text += (first ? "[" : " [, ") + parameter.name + "]";
        else
            text += (first ? "" : ", ") + parameter.name;
        first = false;
    }
    return text + ")";
}

std::string plain_signatures(std::string_view text) {
    std::string joined, last;
    for (const Signature& signature : parse_signatures(text)) {
        // Two may differ in their types only.
        if (plain(signature) == last) continue;
        last = plain(signature);
        joined += (joined.empty() ? "" : " or ") + last;
    }
    return joined;
}

}  // namespace fettle::script
