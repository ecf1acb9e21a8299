#include <prompt/signature_help.h>

#include <algorithm>

namespace fettle::console {

namespace {

bool in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == ':';
}

/// The name that ends at `end`.
std::string_view name_before(std::string_view text, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0 && in_name(text[begin - 1])) --begin;
    return text.substr(begin, end - begin);
}

}  // namespace

std::optional<OpenCall> open_call(std::string_view text, std::size_t cursor) {
    struct Bracket {
        std::size_t at;
        std::size_t commas;
    };
    std::vector<Bracket> open;
    char quote = 0;
    const std::size_t end = std::min(cursor, text.size());
    for (std::size_t i = 0; i < end; ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == '\\')
                ++i;
            else if (c == quote)
                quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[' || c == '{') {
            open.push_back({i, 0});
        } else if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
            open.pop_back();
        } else if (c == ',' && !open.empty()) {
            ++open.back().commas;
        }
    }
    // Inside a table or an index the call around it counts.
    for (; !open.empty(); open.pop_back()) {
        if (text[open.back().at] != '(') continue;
        const std::string_view callee = name_before(text, open.back().at);
        if (!callee.empty()) return OpenCall{callee, open.back().commas};
    }
    return std::nullopt;
}

ParameterRange parameter_of(std::string_view signature, std::size_t index) {
    const std::size_t first = signature.find('(');
    if (first == std::string_view::npos) return {};
    std::vector<ParameterRange> all;
    int depth = 0;
    std::size_t begin = first + 1;
    for (std::size_t i = first; i < signature.size(); ++i) {
        const char c = signature[i];
        if (c == '(' || c == '<' || c == '{') ++depth;
        if (c == ')' || c == '>' || c == '}') --depth;
        const bool ends = depth == 0 || (depth == 1 && c == ',');
        if (!ends || i == first) continue;
        while (begin < i && signature[begin] == ' ') ++begin;
        if (begin < i) all.push_back({begin, i});
        begin = i + 1;
        if (depth == 0) break;
    }
    if (all.empty()) return {};
    const ParameterRange last = all.back();
    if (index >= all.size())
        return signature.substr(last.begin, 3) == "..." ? last : ParameterRange{};
    return all[index];
}

std::optional<SignatureHelp::Shown> SignatureHelp::at(std::string_view text, std::size_t cursor) {
    const std::optional<OpenCall> call = open_call(text, cursor);
    if (!call || !complete_) {
        callee_.clear();
        return std::nullopt;
    }
    if (call->callee != callee_) {
        callee_ = call->callee;
        signature_.clear();
        const std::string_view name =
            call->callee.substr(call->callee.find_last_of(".:") + 1);  // npos + 1 is 0
        for (const script::Completion& each : complete_(callee_, callee_.size())) {
            if (each.label != name || each.detail.find('(') == std::string::npos) continue;
            signature_ = each.detail.substr(0, each.detail.find('\n'));
            break;
        }
    }
    if (signature_.empty()) return std::nullopt;
    // The receiver of a method is not among its arguments.
    std::size_t index = call->argument;
    if (callee_.find(':') != std::string::npos && signature_.find("(self") != std::string::npos)
        ++index;
    return Shown{signature_, parameter_of(signature_, index)};
}

}  // namespace fettle::console
