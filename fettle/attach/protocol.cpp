#include <attach/protocol.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include <command_line/answer.h>

namespace fettle::program {
namespace {

using Json = nlohmann::json;

constexpr std::string_view greeting_word = "fettle 1 ";

/// Text of a script may have any bytes; those that are not UTF-8 become U+FFFD.
std::string line_of(const Json& message) {
    return message.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Adds a text as JSON. Most lines are plain, and are not copied into a tree of values before.
void append_text(std::string& out, std::string_view text) {
    const bool plain = std::ranges::all_of(
        text, [](char c) { return c >= ' ' && c < 0x7f && c != '"' && c != '\\'; });
    if (plain)
        out.append("\"").append(text).append("\"");
    else
        out += Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// An object of a message. Anything nested deeper is not built in memory.
std::optional<Json> object_in(std::string_view line, int deepest) {
    bool fits = true;
    const Json::parser_callback_t shallow = [&](int depth, Json::parse_event_t, Json&) {
        fits = fits && depth <= deepest;
        return fits;
    };
    Json read = Json::parse(line.begin(), line.end(), shallow, /*allow_exceptions=*/false);
    if (!fits || !read.is_object()) return std::nullopt;
    return read;
}

std::string text_in(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::size_t number_in(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_unsigned() ? found->get<std::size_t>() : 0;
}

}  // namespace

std::string greeting(std::string_view token) {
    return std::string(greeting_word) + std::string(token) + '\n';
}

bool is_greeting(std::string_view line, std::string_view token) {
    if (token.empty() || line.size() != greeting_word.size() + token.size()) return false;
    unsigned char differs = line.starts_with(greeting_word) ? 0 : 1;
    for (std::size_t i = 0; i < token.size(); ++i)
        differs = static_cast<unsigned char>(differs | (line[greeting_word.size() + i] ^ token[i]));
    return differs == 0;
}

// --- Requests

std::string text_of(const Request& request) {
    if (request.kind == Request::Kind::run) return line_of({{"run", request.text}});
    if (request.kind == Request::Kind::stop) return line_of({{"stop", true}});
    return line_of({{"complete", request.text}, {"cursor", request.cursor}});
}

// --- Messages

std::string welcome_text(std::string_view game) {
    return line_of({{"game", game}});
}
std::string refusal_text(std::string_view why) {
    return line_of({{"refused", why}});
}
std::string print_text(std::string_view line) {
    return line_of({{"print", line.substr(0, longest_answer)}});
}
std::string lost_text(std::size_t lines) {
    return line_of({{"lost", lines}});
}

std::string answer_text(const script::Evaluation& said) {
    std::string text = said.incomplete ? R"({"incomplete":true,"said":[)" : R"({"said":[)";
    if (!said.incomplete) {
        const std::vector<std::string> all = lines_of(said);
        const auto add = [&](bool first, std::string_view line) {
            if (!first) text += ',';
            append_text(text, line);
        };
        std::size_t bytes = 0, taken = 0;
        for (; taken < all.size() && bytes + all[taken].size() <= longest_answer; ++taken) {
            bytes += all[taken].size() + 16;
            add(taken == 0, all[taken]);
        }
        if (taken < all.size())
            add(taken == 0, "  … " + std::to_string(all.size() - taken) + " more lines");
    }
    return text + "]}\n";
}

std::string candidates_text(const std::vector<script::Completion>& found) {
    std::string text = R"({"candidates":[)";
    std::size_t bytes = 0, count = 0;
    for (const script::Completion& each : found) {
        bytes += each.text.size() + each.label.size() + each.detail.size();
        if (count == most_candidates || bytes > longest_answer) break;
        text += count++ == 0 ? R"({"text":)" : R"(,{"text":)";
        append_text(text, each.text);
        text += R"(,"label":)";
        append_text(text, each.label);
        text += R"(,"detail":)";
        append_text(text, each.detail);
        text += R"(,"from":)" + std::to_string(each.replace_from) + '}';
    }
    return text + "]}\n";
}

std::optional<Message> read_message(std::string_view line) {
    const std::optional<Json> object = object_in(line, 3);
    if (!object) return std::nullopt;
    Message message;
    using Kind = Message::Kind;
    for (const auto& [kind, key] :
         {std::pair{Kind::welcome, "game"}, {Kind::refusal, "refused"}, {Kind::print, "print"}})
        if (object->contains(key)) {
            message.kind = kind;
            message.text = text_in(*object, key);
            return message;
        }
    if (object->contains("lost")) {
        message.kind = Kind::lost;
        message.count = number_in(*object, "lost");
        return message;
    }
    if (const auto said = object->find("said"); said != object->end() && said->is_array()) {
        message.kind = Kind::answer;
        message.incomplete = object->value("incomplete", Json()) == Json(true);
        for (const Json& each : *said)
            if (each.is_string()) message.lines.push_back(each.get<std::string>());
        return message;
    }
    const auto list = object->find("candidates");
    if (list == object->end() || !list->is_array()) return std::nullopt;
    message.kind = Kind::candidates;
    for (const Json& each : *list)
        if (each.is_object())
            message.found.push_back({.text = text_in(each, "text"),
                                     .label = text_in(each, "label"),
                                     .detail = text_in(each, "detail"),
                                     .doc = {},
                                     .replace_from = number_in(each, "from")});
    return message;
}

}  // namespace fettle::program
