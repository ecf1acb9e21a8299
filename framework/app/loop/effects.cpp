#include <loop/effects.h>

#include <array>
#include <exception>
#include <string_view>
#include <vector>

namespace fettle::app {

using property::Handle;
using property::Type;
using property::Value;

namespace {

constexpr std::array<std::string_view, 2> endings{".frag", ".glsl"};

bool fits(const Value& value, const std::string& type) {
    if (type == "float" || type == "int") return value.is(Type::number) || value.is(Type::integer);
    if (type == "bool") return value.is(Type::boolean);
    if (type == "vec2") return value.is(Type::vec2);
    return (type == "vec3" || type == "vec4") && value.is(Type::color);
}

/// Comments become blanks.
std::string without_comments(const std::string& code) {
    std::string text;
    for (std::size_t i = 0; i < code.size();) {
        const bool line = code.compare(i, 2, "//") == 0;
        if (!line && code.compare(i, 2, "/*") != 0) {
            text += code[i++];
            continue;
        }
        const std::size_t end = line ? code.find('\n', i) : code.find("*/", i + 2);
        text += ' ';
        i = end == std::string::npos ? code.size() : line ? end : end + 2;
    }
    return text;
}

/// Names, and other characters one by one.
std::vector<std::string> words_of(const std::string& text) {
    const auto in_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    std::vector<std::string> words;
    bool joined = false;
    for (const char c : text) {
        if (in_name(c) && joined)
            words.back() += c;
        else if (c > ' ')
            words.emplace_back(1, c);
        joined = in_name(c);
    }
    return words;
}

}  // namespace

std::map<std::string, std::string> uniforms_in(const std::string& code) {
    std::map<std::string, std::string> all;
    const std::vector<std::string> words = words_of(without_comments(code));
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] != "uniform") continue;
        for (++i; i < words.size() &&
                  (words[i] == "lowp" || words[i] == "mediump" || words[i] == "highp");)
            ++i;
        if (i >= words.size()) break;
        const std::string& type = words[i];
        // Names are at the beginning, and after a comma that is not between parentheses.
        int depth = 0;
        bool named = false;
        for (++i; i < words.size() && words[i] != ";"; ++i) {
            if (!named) all[words[i]] = type;
            named = true;
            if (words[i] == "(") ++depth;
            if (words[i] == ")") --depth;
            if (words[i] == "," && depth == 0) named = false;
        }
    }
    return all;
}

Effects::Effects(property::Tree& tree, const View& view, property::Assets* assets)
    : tree_(tree), view_(view), assets_(assets) {
    const property::Class& uniforms = tree.define(
        {.name = "Uniforms",
         .doc = "Values for the uniforms of `view.effect`: each property that is added here is the "
                "uniform of that name. A number is a float or an int, a boolean a bool, a vec a "
                "vec2, a color a vec3 or vec4.",
         .creatable = false});
    tree.create(uniforms, tree.child(tree.root(), "view"), "uniforms");
}

void Effects::report(const std::string& problem) {
    if (reported_.insert(problem).second && report_) report_(problem);
}

void Effects::renew(const std::string& name) {
    if (name == effect_.name) changed_ = true;
}

void Effects::read() {
    changed_ = false;
    reported_.clear();
    if (effect_.name != view_.effect) {
        effect_ = {.name = view_.effect};
        readable_ = false;
    }
    if (effect_.name.empty()) return;
    if (assets_ == nullptr) return report("view.effect: this program has no files");
    try {
        effect_.code = assets_->read("view.effect", effect_.name, endings);
        declared_ = uniforms_in(effect_.code);
        readable_ = true;
    } catch (const std::exception& error) {
        report(error.what());
    }
}

void Effects::set_uniforms() {
    effect_.uniforms.clear();
    wrong_uniforms_.clear();
    for (const auto& [name, type] : declared_)
        if (type.starts_with("sampler"))
            wrong_uniforms_.push_back("view.effect: " + effect_.name + " declares a " + type +
                                      " \"" + name +
                                      "\", which has no picture; picture(point) is "
                                      "the color at a point, in pixels");
    const Handle uniforms = tree_.child(tree_.child(tree_.root(), "view"), "uniforms");
    if (!uniforms) return;
    for (const property::Property* each : tree_.ad_hoc(uniforms)) {
        const std::string& name = each->name;
        const Value value = tree_.peek(uniforms, *each);
        const auto found = declared_.find(name);
        if (found == declared_.end())
            wrong_uniforms_.push_back("view.uniforms." + name + ": " + effect_.name +
                                      " declares no uniform of that name");
        else if (!fits(value, found->second))
            wrong_uniforms_.push_back("view.uniforms." + name + ": " + effect_.name +
                                      " declares a " + found->second + ", got " +
                                      property::value_text(value));
        else
            effect_.uniforms.push_back({name, value, found->second});
    }
}

void Effects::step() {
    if (changed_ || effect_.name != view_.effect) read();
}

const Effect* Effects::now(double time) {
    step();
    if (!readable_) return nullptr;
    effect_.time = time;
    set_uniforms();
    return &effect_;
}

void Effects::drawn(const std::string& problem) {
    if (!problem.empty()) return report("view.effect: " + problem);
    for (const std::string& wrong : wrong_uniforms_) report(wrong);
}

}  // namespace fettle::app
