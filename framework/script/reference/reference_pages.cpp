// Writes the pages of the reference in Markdown.

#include <algorithm>

#include <fettle/script/reference.h>

#include <reference/language.h>
#include <reference/reference_facts.h>
#include <reference/signature.h>

namespace fettle::script {

using property::Class;
using property::Event;
using property::Field;
using property::Method;
using property::Property;
using property::Tree;

namespace {

constexpr const char* written_by = "*Written by `fettle docs` from the descriptors.*\n";

// Escapes bars, which separate the cells of a table.
std::string cell(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
    return out;
}

std::string code(const std::string& text) {
    return text.empty() ? "" : "`" + cell(text) + "`";
}

std::string row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& each : cells) text += " " + (each.empty() ? "–" : each) + " |";
    return text + "\n";
}

std::string head(const std::vector<std::string>& titles) {
    std::string rule = "|";
    for (std::size_t i = 0; i < titles.size(); ++i) rule += "---|";
    return row(titles) + rule + "\n";
}

// --- Classes

class ClassPage {
  public:
    ClassPage(const Tree& tree, const Class& of) : tree_(tree), of_(of) {}

    std::string text() {
        out_ = "# " + of_.name() + "\n\n" + of_.doc() + "\n\n";
        ancestry();
        making();
        properties();
        children();
        methods();
        events();
        inherited();
        out_ += "\n" + std::string(written_by);
        return out_;
    }

  private:
    static std::string type_in_page(const Property& property) {
        const bool long_list = !property.enumerators.empty() && !few_enumerators(property);
        return long_list ? "string" : annotated_type(property);
    }

    static std::string link(const Class& of) { return "[" + of.name() + "](" + of.name() + ".md)"; }

    void ancestry() {
        if (of_.base() == nullptr) {
            out_ += "Every other class derives from it.\n";
            return;
        }
        out_ += "Derives from ";
        for (const Class* base = of_.base(); base; base = base->base())
            out_ += link(*base) + (base->base() ? ", " : "");
        std::string derived;
        for (const Class* each : tree_.classes())
            if (each->base() == &of_) derived += (derived.empty() ? "" : ", ") + link(*each);
        out_ += derived.empty() ? ".\n" : ". Derived classes: " + derived + ".\n";
    }

    void making() {
        out_ += of_.creatable() ? "\nMake one with `" + of_.name() + " { ... }`.\n"
                                : "\nOnly the framework makes instances of it; games cannot.\n";
    }

    void properties() {
        const auto own = own_properties(of_);
        if (own.empty()) return;
        out_ += "\n## Properties\n\n" +
                head({"property", "type", "unit", "range", "default", "notes", "what it is"});
        for (const Property* property : own) {
            std::string doc = property->doc;
            if (!property->derives_from.empty()) {
                doc += " Computed from";
                for (const std::string& source : property->derives_from)
                    doc += (source == property->derives_from.front() ? " `" : ", `") + source + "`";
                doc += ".";
            }
            std::string flags = flags_text(*property);
            out_ += row({code(property->name), code(type_in_page(*property)),
                         unit_text(property->unit), cell(range_text(*property)),
                         code(default_text(tree_, *property)), flags, cell(doc)});
        }
    }

    void children() {
        const auto fixed = fixed_children(tree_, of_);
        if (fixed.empty()) return;
        out_ += "\n## Children\n\nIt has these children from the beginning.\n\n" +
                head({"child", "class", "what it is"});
        for (const auto& [name, of] : fixed) out_ += row({code(name), link(*of), cell(of->doc())});
    }

    static std::string fields(const std::vector<Field>& fields, std::size_t required) {
        std::string text = head({"name", "type", "unit", "what it is"});
        for (std::size_t i = 0; i < fields.size(); ++i)
            text += row({code(fields[i].name),
                         code(annotated_type(fields[i]) + (i >= required ? "?" : "")),
                         unit_text(fields[i].unit), cell(fields[i].doc)});
        return text;
    }

    void methods() {
        const auto own = own_methods(of_);
        if (own.empty() && of_.base() != nullptr) return;
        out_ += "\n## Methods\n";
        for (const Method* method : own) {
            out_ += "\n### `:" + signature(*method) + "`\n\n" + method->doc +
                    (method->effect == property::Effect::nothing
                         ? " It changes nothing, so formulas can call it.\n"
                         : "\n");
            if (!method->parameters.empty())
                out_ += "\nTakes:\n\n" + fields(method->parameters, method->required);
            if (!method->returns.empty())
                out_ += "\nReturns " + result_kind(*method) + ":\n\n" +
                        fields(method->returns, method->returns.size());
        }
        if (of_.base() != nullptr) return;
        for (const GlobalDoc& method : instance_docs()) {
            out_ += "\n### `:" + plain_signatures(method.signature) + "`\n\n" +
                    std::string(method.doc) + "\n\n```lua\n";
            for (const Signature& each : parse_signatures(method.signature))
                out_ += ":" + typed(each) + "\n";
            out_ += "```\n";
        }
    }

    static std::string result_kind(const Method& method) {
        if (!returns_record(method)) return "a value";
        return method.many ? "a list of records" : "a record, or nil";
    }

    void events() {
        const auto own = own_events(of_);
        if (own.empty()) return;
        out_ +=
            "\n## Events\n\nListen with `:on(\"" + own.front()->name +
            "\", function(record) ... end)`. Besides the listed fields, `record.instance` is the "
            "instance of the event, and `record.step` the step in which it happened.\n";
        for (const Event* event : own) {
            out_ += "\n### `" + event->name + "`\n\n" + event->doc + "\n";
            if (!event->fields.empty()) out_ += "\n" + fields(event->fields, event->fields.size());
        }
    }

    void inherited() {
        if (of_.base() == nullptr) return;
        out_ += "\n## Inherited\n\n";
        for (const Class* base = of_.base(); base; base = base->base()) {
            std::string names;
            const auto add = [&](const std::string& text) {
                names += (names.empty() ? "`" : ", `") + text + "`";
            };
            for (const Property* property : own_properties(*base)) add(property->name);
            for (const Method* method : own_methods(*base)) add(":" + method->name);
            if (base->base() == nullptr)
                for (const GlobalDoc& method : instance_docs()) add(std::string(":") + method.name);
            out_ += "From " + link(*base) + ": " + names + ".\n\n";
        }
        out_.pop_back();
    }

    const Tree& tree_;
    const Class& of_;
    std::string out_;
};

// --- Functions, callbacks, values

std::string function_section(const GlobalDoc& doc) {
    const std::string signature = doc.signature;
    if (signature.find('(') == std::string::npos)
        return "\n### `" + std::string(doc.name) + "`\n\n" + doc.doc + " Type: `" + signature +
               "`.\n";
    std::string text = "\n### `" + std::string(doc.name) + "`\n\n```lua\n";
    for (const Signature& each : parse_signatures(signature)) text += typed(each) + "\n";
    return text + "```\n\n" + doc.doc + "\n";
}

std::string functions_page() {
    std::string text = "# Functions and globals\n\n## Of Fettle\n";
    for (const GlobalDoc& doc : global_docs()) text += function_section(doc);
    text += "\n## Variables\n";
    for (const GlobalDoc& doc : variable_docs()) text += function_section(doc);
    text +=
        "\n## Of Lua\n\nThe rest of Lua's library is missing: scripts can use no files, no "
        "bytecode, no `debug` and no other programs.\n";
    for (const GlobalDoc& doc : library_docs()) text += function_section(doc);
    return text + "\n" + written_by;
}

std::string callbacks_page() {
    std::string text =
        "# Callbacks\n\nGlobal functions that a game may define. They are called in the order "
        "input, `update`, `step` for each fixed step that is due, `draw`.\n";
    for (const GlobalDoc& doc : callback_docs()) text += function_section(doc);
    text +=
        "\n## Of classes\n\nFunctions that a class made with `class(...)` may define, besides one "
        "for each event: `function Ball:contact_begin(contact) ... end`.\n";
    for (const GlobalDoc& doc : class_callback_docs()) text += function_section(doc);
    return text + "\n" + written_by;
}

std::string values_page() {
    std::string text = "# Values\n\nTypes of values in scripts, besides instances.\n";
    for (const TypeDoc& type : type_docs()) {
        text += "\n## " + std::string(type.name) + "\n\n" + type.doc + "\n";
        if (!type.members.empty()) text += "\n" + head({"member", "type", "what it is"});
        for (const MemberDoc& member : type.members) {
            if (!member.is_function()) {
                text += row({code(member.name), code(member.signature), cell(member.doc)});
                continue;
            }
            std::string signatures;
            for (const Signature& each : parse_signatures(member.signature))
                signatures += (signatures.empty() ? "" : " or ") +
                              code((type.by_dot ? "." : ":") + typed(each));
            text += row({code(std::string(type.by_dot ? "." : ":") + member.name), signatures,
                         cell(member.doc)});
        }
        if (type.operators.empty()) continue;
        text += "\nOperators:";
        for (const char* operation : type.operators) text += std::string(" `") + operation + "`";
        text += ".\n";
    }
    return text + "\n" + written_by;
}

// --- Index

void add_tree(const Tree& tree, const Class& of, int depth, std::string& text) {
    text += std::string(static_cast<std::size_t>(2 * depth), ' ') + "- [" + of.name() +
            "](classes/" + of.name() + ".md)" + (of.doc().empty() ? "" : " – " + of.doc()) + "\n";
    for (const Class* each : tree.classes())
        if (each->base() == &of) add_tree(tree, *each, depth + 1, text);
}

std::string index_page(const Tree& tree) {
    std::string text =
        "# Reference\n\nEverything a game can use. The console knows the same: `help(Body)`, "
        "`world.ball.mass?`, `find(\"fric\")`; and so does a script: `Body.properties.mass.unit`."
        "\n\n- [Functions and globals](functions.md)\n- [Callbacks](callbacks.md)\n- "
        "[Values](values.md)\n- [Annotations for editors](fettle.lua): set `workspace.library` of "
        "lua-language-server to the folder with that file\n";
    text +=
        "\n## Classes\n\nA page gives the range of each property. The properties of physics are "
        "stored in single precision: where no limit is given, they accept numbers up to 3.4e38, "
        "and they are rounded to seven digits.\n\n";
    add_tree(tree, tree.object_class(), 0, text);
    text += "\n## From the beginning\n\nChildren of `game`; each is a global too.\n\n" +
            head({"name", "class", "what it is"});
    const auto fixed = fixed_children(tree, tree.class_of(tree.root()));
    for (const auto& [name, of] : fixed)
        text += row(
            {code(name), "[" + of->name() + "](classes/" + of->name() + ".md)", cell(of->doc())});
    const bool plugged = std::any_of(fixed.begin(), fixed.end(),
                                     [](const auto& each) { return each.first == "modules"; });
    if (!plugged)
        text +=
            "\nIn a game that plugs in modules there is `modules` as well: `modules.NAME` has "
            "`version`, `file`, `reloads`, `problem`, `follow` (it is reloaded whenever its "
            "file has changed) and `reload()`. `fettle docs FOLDER GAME` writes their pages.\n";
    return text + "\n" + written_by;
}

}  // namespace

std::vector<ReferencePage> reference_pages(const Tree& tree) {
    std::vector<ReferencePage> pages = {{"README.md", index_page(tree)},
                                        {"callbacks.md", callbacks_page()},
                                        {"functions.md", functions_page()},
                                        {"values.md", values_page()}};
    for (const Class* of : tree.classes())
        pages.push_back({"classes/" + of->name() + ".md", ClassPage(tree, *of).text()});
    return pages;
}

}  // namespace fettle::script
