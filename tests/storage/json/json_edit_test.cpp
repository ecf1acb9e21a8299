// Edits of any JSON text: the edit is made, every comment outside of the removed text stays, and
// the rest is unchanged.

#include <json/json_edit.h>

#include <algorithm>
#include <random>

#include "catch.h"

namespace json_edit_test {

using fettle::property::Document;
using fettle::property::JsonEdit;

namespace {

using Members = std::vector<std::pair<std::string, std::string>>;

/// Writes an object in varied forms: on one line or on many, with comments in any place.
class Scribe {
  public:
    explicit Scribe(std::mt19937& random) : random_(random) {}
    std::string object(const Members& members) {
        const bool lines = chance(70);
        std::string out = space(lines) + "{";
        for (std::size_t i = 0; i < members.size(); ++i) {
            out += lines ? newline() + "  " + (chance(20) ? comment() + newline() + "  " : "")
                         : std::string(chance(50) ? " " : "");
            out +=
                "\"" + members[i].first + "\"" + (chance(30) ? " " : "") + ": " + members[i].second;
            if (chance(15)) out += " ";
            if (chance(15)) out += "/* in between " + number() + " */";
            if (i + 1 < members.size()) out += ",";
            if (lines && chance(25)) out += "  " + comment();
        }
        if (lines) out += newline() + (chance(15) ? "  " + comment() + newline() : "");
        return out + (!lines && chance(30) ? " }" : "}") + newline();
    }
    bool chance(int percent) { return static_cast<int>(random_() % 100) < percent; }
    bool windows = false;

  private:
    std::string newline() const { return windows ? "\r\n" : "\n"; }
    std::string number() { return std::to_string(++numbered_); }
    std::string comment() {
        return chance(70) ? "// \"note\": {" + number() : "/* , } " + number() + " */";
    }
    std::string space(bool lines) { return lines && chance(20) ? comment() + newline() : ""; }
    std::mt19937& random_;
    int numbered_ = 0;
};

Members members_of(const JsonEdit& edit) {
    Members found;
    const Document& document = edit.document();
    for (auto* node = document.first(document.root()); node; node = document.next(*node))
        found.emplace_back(document.key(*node), std::string(document.raw(*node)));
    return found;
}

std::size_t lines_in(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("any sequence of edits of a JSON text changes only the edited values") {
    std::mt19937 random(12345);
    for (int round = 0; round < 3000; ++round) {
        Scribe scribe(random);
        scribe.windows = scribe.chance(20);
        Members model;
        for (std::size_t i = random() % 6; i > 0; --i)
            model.emplace_back("k" + std::to_string(i), std::to_string(random() % 100));
        const std::string begun = scribe.object(model);
        JsonEdit edit(begun, "any.json");
        REQUIRE(members_of(edit) == model);
        for (int step = 0; step < 6; ++step) {
            const std::string before = edit.text();
            INFO("round " << round << "\n"
                          << begun << "\n---\n"
                          << before << "\n---\n"
                          << edit.text());
            const Document& document = edit.document();
            std::vector<const Document::Node*> nodes;
            for (auto* node = document.first(document.root()); node; node = document.next(*node))
                nodes.push_back(node);
            const std::size_t at = nodes.empty() ? 0 : random() % nodes.size();
            const std::string value = std::to_string(1000 + random() % 9000);
            const int what = static_cast<int>(random() % 4);
            if (what == 0 && !nodes.empty()) {
                edit.replace(*nodes[at], value);
                model[at].second = value;
                CHECK(lines_in(edit.text()) == lines_in(before));
            } else if (what == 1 && !nodes.empty()) {
                edit.remove(document.root(), *nodes[at]);
                model.erase(model.begin() + static_cast<std::ptrdiff_t>(at));
                CHECK(edit.text().size() < before.size());
            } else {
                const std::string key = "n" + std::to_string(round) + "_" + std::to_string(step);
                const int where = static_cast<int>(random() % 3);
                if (nodes.empty() || where == 0) {
                    edit.add_member(document.root(), key, value);
                    model.emplace_back(key, value);
                } else if (where == 1) {
                    edit.add_member(document.root(), key, value, &document.root());
                    model.insert(model.begin(), {key, value});
                } else {
                    edit.add_member(document.root(), key, value, nodes[at]);
                    model.insert(model.begin() + static_cast<std::ptrdiff_t>(at) + 1, {key, value});
                }
                // Nothing of the old text is missing.
                std::size_t from = 0;
                bool all = true;
                for (const char c : before) {
                    from = edit.text().find(c, from);
                    all = all && from != std::string::npos;
                    if (!all) break;
                    ++from;
                }
                CHECK((all || before.find("{ ") != std::string::npos));
            }
            REQUIRE(members_of(edit) == model);
        }
        if (scribe.windows && lines_in(begun) > 1)
            CHECK(lines_in(edit.text()) == static_cast<std::size_t>(std::count(
                                               edit.text().begin(), edit.text().end(), '\r')));
    }
}

}  // namespace json_edit_test
