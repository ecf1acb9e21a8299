#include <prompt/signature_help.h>

#include <algorithm>

#include <text/highlight.h>

namespace fettle::console {

namespace {

bool in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == ':';
}

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

/// The name that is called by a bracket at `end`; "" if there is none.
std::string_view name_before(std::string_view text, std::size_t end) {
    while (end > 0 && is_blank(text[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && in_name(text[begin - 1])) --begin;
    const std::string_view name = text.substr(begin, end - begin);
    return is_keyword(name) ? std::string_view() : name;
}

/// The key at the beginning of an entry of a table: "mass" in " mass = 2".
std::string_view key_of(std::string_view entry) {
    while (!entry.empty() && is_blank(entry.front())) entry.remove_prefix(1);
    std::size_t end = 0;
    while (end < entry.size() && in_name(entry[end])) ++end;
    std::size_t sign = end;
    while (sign < entry.size() && is_blank(entry[sign])) ++sign;
    const bool assigned = sign < entry.size() && entry[sign] == '=' &&
                          (sign + 1 == entry.size() || entry[sign + 1] != '=');
    return assigned ? entry.substr(0, end) : std::string_view();
}

std::string first_sentence(const std::string& doc) {
    const std::size_t end = doc.find(". ");
    return end == std::string::npos ? doc : doc.substr(0, end + 1);
}

/// The parameter without blanks, and without the brackets that mark it or the next one as optional:
/// "force" of "force [, point]". Those of a list, as in "vec[]", stay.
ParameterRange without_brackets(std::string_view text, ParameterRange of) {
    while (of.begin < of.end && (text[of.begin] == ' ' || text[of.begin] == '[')) ++of.begin;
    while (of.begin < of.end) {
        const char last = text[of.end - 1];
        const bool of_list = last == ']' && of.end - of.begin > 1 && text[of.end - 2] == '[';
        if (of_list || (last != ' ' && last != '[' && last != ']')) break;
        --of.end;
    }
    return of;
}

}  // namespace

std::optional<OpenCall> open_call(std::string_view text, std::size_t cursor) {
    struct Bracket {
        std::size_t at;
        std::size_t commas = 0;
        std::size_t entry = at + 1;  // where the present argument or entry begins
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
            open.push_back({.at = i});
        } else if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
            open.pop_back();
        } else if ((c == ',' || c == ';') && !open.empty()) {
            ++open.back().commas;
            open.back().entry = i + 1;
        }
    }
    // Inside a table or an index the call around it counts. A table right after a name is the
    // argument of a call.
    std::string_view key;
    for (; !open.empty(); open.pop_back()) {
        const Bracket& last = open.back();
        const char bracket = text[last.at];
        if (bracket == '[') continue;
        const bool table = bracket == '{';
        if (table) key = key_of(text.substr(last.entry, end - last.entry));
        const std::string_view callee = name_before(text, last.at);
        if (!callee.empty()) return OpenCall{callee, table ? 0 : last.commas, key};
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
        if (const ParameterRange bare = without_brackets(signature, {begin, i});
            bare.begin < bare.end)
            all.push_back(bare);
        begin = i + 1;
        if (depth == 0) break;
    }
    if (all.empty()) return {};
    const ParameterRange last = all.back();
    if (index >= all.size())
        return signature.substr(last.begin, 3) == "..." ? last : ParameterRange{};
    return all[index];
}

ParameterRange property_in(std::string_view constructor, std::string_view name) {
    if (name.empty()) return {};
    for (std::size_t at = constructor.find('{'); at < constructor.size();) {
        const std::size_t begin =
            std::min(constructor.find_first_not_of("{, ", at), constructor.size());
        const std::size_t end =
            std::min(constructor.find_first_of(", }", begin), constructor.size());
        if (constructor.substr(begin, end - begin) == name) return {begin, end};
        at = end + 1;
    }
    return {};
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
        doc_.clear();
        const std::string_view name =
            call->callee.substr(call->callee.find_last_of(".:") + 1);  // npos + 1 is 0
        for (const script::Completion& each : complete_(callee_, callee_.size())) {
            const bool constructs = each.detail.starts_with(each.label + " {");
            if (each.label != name || (!constructs && each.detail.find('(') == std::string::npos))
                continue;
            signature_ = each.detail.substr(0, each.detail.find('\n'));
            doc_ = first_sentence(each.doc);
            break;
        }
    }
    if (signature_.empty()) return std::nullopt;
    if (signature_.starts_with(callee_ + " {"))
        return Shown{signature_, property_in(signature_, call->key), doc_};
    // The receiver of a method is not among its arguments.
    std::size_t index = call->argument;
    if (callee_.find(':') != std::string::npos && signature_.find("(self") != std::string::npos)
        ++index;
    return Shown{signature_, parameter_of(signature_, index), doc_};
}

}  // namespace fettle::console
