#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/condition.h>
#include <fettle/property/natural_order.h>
#include <fettle/property/spelling.h>

#include <console/find.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/instance_set.h>
#include <other_languages/foreign_classes.h>
#include <reference/language.h>
#include <reference/reference_facts.h>
#include <reference/signature.h>
#include <sandbox/sandbox.h>
#include <text/columns.h>
#include <text/folded_rows.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

using property::Method;

namespace {

constexpr std::size_t max_lines = 50;

/// Lines for the rows of what was found, of which there are `total`.
std::vector<std::string> found_lines(std::vector<std::vector<std::string>>& rows, std::size_t total,
                                     FoldedLines& folded) {
    rows.resize(std::min(rows.size(), max_lines + max_folded));
    std::vector<std::string> lines = columns(rows);
    fold_rows(lines, {.shown = max_lines, .total = total, .what = "found"}, folded);
    return lines;
}

class Search {
  public:
    explicit Search(std::string_view word) : word_(lower(word)) {}

    void look(const std::string& name, const std::string& shown, const std::string& written) {
        const std::string doc = shown_doc(written);
        known_.insert(name);
        const bool by_name = lower(name).find(word_) != std::string::npos;
        if (!by_name && lower(doc).find(word_) == std::string::npos) return;
        (by_name ? names_ : docs_).push_back({"  " + shown, doc});
    }

    std::vector<std::string> lines(FoldedLines& folded) {
        std::sort(names_.begin(), names_.end(), property::NaturalOrder{});
        std::sort(docs_.begin(), docs_.end(), property::NaturalOrder{});
        names_.insert(names_.end(), docs_.begin(), docs_.end());
        return found_lines(names_, names_.size(), folded);
    }

    /// Names that were looked at.
    std::set<std::string>& known() { return known_; }

  private:
    std::string word_;
    std::set<std::string> known_;
    std::vector<std::vector<std::string>> names_, docs_;  // found by name, or by documentation only
};

}  // namespace

std::vector<std::string> find_lines(const property::Tree& tree, std::string_view word,
                                    FoldedLines& folded) {
    Search search(word);
    for (const Class* of : tree.classes()) {
        search.look(of->name(), of->name(), of->doc());
        for (const Property* property : of->properties())
            if (property->owner == of && !property->hidden)
                search.look(property->name, of->name() + "." + property->name, property->doc);
        for (const Method* method : of->methods())
            if (method->owner == of)
                search.look(method->name, of->name() + ":" + signature(*method), method->doc);
        for (const property::Event* event : of->events())
            if (event->owner == of)
                search.look(event->name, of->name() + " event " + event->name, event->doc);
    }
    for (const GlobalDoc& method : instance_docs())
        search.look(method.name, "any instance:" + plain_signatures(method.signature), method.doc);
    for (const auto* docs : {&global_docs(), &library_docs(), &callback_docs(), &variable_docs()})
        for (const GlobalDoc& doc : *docs) search.look(doc.name, shown_name(doc), doc.doc);
    for (const TypeDoc& type : type_docs())
        for (const MemberDoc& member : type.members)
            search.look(member.name, std::string(type.name) + "." + member.name, member.doc);
    std::size_t instances = 0;
    tree.each_below(tree.root(), [&](Handle handle) {
        if (handle == tree.root() || instances >= 200) return;
        const std::string name = tree.name(handle);
        if (lower(name).find(lower(word)) == std::string::npos) return;
        ++instances;
        search.look(name, tree.path(handle), tree.class_of(handle).name());
    });
    std::vector<std::string> lines = search.lines(folded);
    if (!lines.empty()) return lines;
    const std::string quoted = property::message_text("nothing has \"" + std::string(word) + "\"");
    if (const std::string hint = hint_for_class(word); !hint.empty()) return {quoted + hint};
    std::set<std::string>& known = search.known();
    tree.each_below(tree.root(), [&](Handle handle) { known.insert(tree.name(handle)); });
    return {quoted +
            property::suggestion(word, std::vector<std::string>(known.begin(), known.end()))};
}

namespace {

/// Paths with classes.
std::vector<std::string> lines_of(const property::Tree& tree, const std::vector<Handle>& found,
                                  FoldedLines& folded) {
    if (found.empty()) return {"it holds for nothing"};
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < std::min(found.size(), max_lines + max_folded); ++i)
        rows.push_back({"  " + tree.path(found[i]), tree.class_of(found[i]).name()});
    return found_lines(rows, found.size(), folded);
}

int search(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING) refuse_type(L, 1, "find: needs a text");
    Machine& machine = machine_of(L);
    const std::string text = string_at(L, 1);
    FoldedLines folded;
    std::vector<std::string> lines =
        property::Condition::is_meant(text)
            ? lines_of(machine.tree, instances_matching(L, text), folded)
            : find_lines(machine.tree, text, folded);
    print_folded(machine, std::move(lines), std::move(folded));
    return 0;
}

}  // namespace

void open_find(lua_State* L) {
    add_function<search>(L, "find");
}

}  // namespace fettle::script
