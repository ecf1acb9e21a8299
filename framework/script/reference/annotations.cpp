// LuaCATS annotations, with which lua-language-server completes and checks a game.

#include <algorithm>
#include <string_view>

#include <fettle/property/path.h>
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

class Annotations {
  public:
    explicit Annotations(const Tree& tree) : tree_(tree) {}

    std::string all() {
        line("---@meta fettle");
        line("-- Written by `fettle docs`.");
        for (const TypeDoc& type : type_docs()) value(type);
        for (const Class* of : tree_.classes()) instance_class(*of);
        globals();
        for (const char* library : {"coroutine", "math", "os", "scene", "string", "table", "utf8"})
            gap(), line(std::string(library) + " = {}");
        for (const auto* docs : {&global_docs(), &library_docs()})
            for (const GlobalDoc& doc : *docs) function_or_constant(doc);
        for (const GlobalDoc& doc : callback_docs())
            function("", parse_signatures(doc.signature), doc.doc);
        return text_;
    }

  private:
    void line(const std::string& text) { text_ += text + "\n"; }
    void gap() { text_ += "\n"; }
    void comment(const std::string& text) { line("---" + text); }

    // --- Functions

    static std::string as_type(const Signature& signature) {
        std::string text = "fun(";
        for (const Parameter& parameter : signature.parameters) {
            if (text.back() != '(') text += ", ";
            text += parameter.name + (parameter.optional ? "?: " : ": ") + parameter.type;
        }
        text += ")";
        for (std::size_t i = 0; i < signature.returns.size(); ++i)
            text += (i == 0 ? ": " : ", ") + signature.returns[i];
        return text;
    }

    // `prefix`: "vec:", "" ...
    void function(const std::string& prefix, const std::vector<Signature>& signatures,
                  const std::string& doc, const std::vector<std::string>& overloads = {}) {
        const Signature& first = signatures.front();
        gap();
        comment(doc);
        std::string names;
        for (const Parameter& parameter : first.parameters) {
            if (parameter.name == "self") continue;
            line("---@param " + parameter.name + (parameter.optional ? "? " : " ") +
                 parameter.type);
            names += (names.empty() ? "" : ", ") + parameter.name;
        }
        for (const std::string& type : first.returns) line("---@return " + type);
        for (std::size_t i = 1; i < signatures.size(); ++i)
            line("---@overload " + as_type(signatures[i]));
        for (const std::string& overload : overloads) line("---@overload " + overload);
        line("function " + prefix + first.name + "(" + names + ") end");
    }

    void function_or_constant(const GlobalDoc& doc) {
        if (std::string_view(doc.signature).find('(') != std::string_view::npos)
            return function("", parse_signatures(doc.signature), doc.doc);
        gap();
        comment(doc.doc);
        line("---@type " + std::string(doc.signature));
        line(std::string(doc.name) + " = nil");
    }

    // --- Values

    void value(const TypeDoc& type) {
        gap();
        comment(type.doc);
        line("---@class " + std::string(type.name));
        for (const MemberDoc& member : type.members)
            if (!member.is_function())
                line("---@field " + std::string(member.name) + " " + member.signature + " " +
                     member.doc);
        for (const char* operation : type.operators) line("---@operator " + std::string(operation));
        const std::string local = "fettle_" + std::string(type.name);
        line("local " + local + " = {}");
        for (const MemberDoc& member : type.members)
            if (member.is_function())
                function(local + (type.by_dot ? "." : ":"), parse_signatures(member.signature),
                         member.doc);
    }

    // --- Classes

    static std::string field_name(const std::string& name) {
        return property::is_identifier(name) ? name : "[\"" + name + "\"]";
    }

    std::string facts(const Property& property) const {
        std::string text = property.doc;
        const auto add = [&](const std::string& part) { text += " · " + part; };
        if (!property.unit.empty()) add(property.unit);
        add(range_text(property));
        if (!property.read_only) add("default " + default_text(tree_, property));
        if (const std::string flags = flags_text(property); !flags.empty()) add(flags);
        return text;
    }

    static std::string facts(const Field& field) {
        return field.doc + (field.unit.empty() ? "" : " · " + field.unit);
    }

    void record(const std::string& name, const std::string& doc, const std::vector<Field>& fields,
                const std::vector<std::string>& more) {
        gap();
        comment(doc);
        line("---@class " + name);
        for (const Field& field : fields)
            line("---@field " + field_name(field.name) + " " + annotated_type(field) + " " +
                 facts(field));
        for (const std::string& field : more) line("---@field " + field);
    }

    // The fields that every event has besides its own.
    static std::vector<std::string> common_fields(const Event& event) {
        std::vector<std::string> fields = {"instance " + event.owner->name() +
                                           " The instance with the event."};
        if (std::ranges::find(event.fields, "step", &Field::name) == event.fields.end())
            fields.emplace_back("step integer The fixed step in which it happened.");
        return fields;
    }

    void instance_class(const Class& of) {
        const std::string& name = of.name();
        for (const Event* event : own_events(of))
            if (event->name != "deleted")
                record(name + "." + event->name, event->doc, event->fields, common_fields(*event));
        for (const Method* method : own_methods(of))
            if (returns_record(*method))
                record(result_name(*method), method->doc, method->returns, {});
        gap();
        comment(of.doc());
        line("---@class " + name + (of.base() ? " : " + of.base()->name() : ""));
        for (const Property* property : own_properties(of))
            line("---@field " + field_name(property->name) + " " + annotated_type(*property) + " " +
                 facts(*property));
        for (const auto& [child, child_class] : fixed_children(tree_, of))
            line("---@field " + field_name(child) + " " + child_class->name() + " " +
                 child_class->doc());
        line("local " + variable(of) + " = {}");
        if (!of.base()) object_methods();
        for (const Method* each : own_methods(of)) method(of, *each);
        if (of.base() && !own_events(of).empty()) subscription(of);
        class_object(of);
    }

    // The annotation type of the instances; the class object has other members and another type.
    static std::string variable(const Class& of) { return "fettle_" + of.name(); }

    void class_object(const Class& of) {
        gap();
        comment(of.doc());
        line("---@class Class." + of.name() + " : Class");
        if (of.creatable()) line("---@overload fun(members?: table): " + of.name());
        line(of.name() + " = {}");
    }

    void method(const Class& of, const Method& method) {
        gap();
        comment(method.doc);
        std::string names;
        for (std::size_t i = 0; i < method.parameters.size(); ++i) {
            const Field& parameter = method.parameters[i];
            line("---@param " + parameter.name + (i >= method.required ? "? " : " ") +
                 annotated_type(parameter) + " " + facts(parameter));
            names += (names.empty() ? "" : ", ") + parameter.name;
        }
        if (!method.returns.empty())
            line("---@return " + annotated_result(method) +
                 (returns_record(method)
                      ? ""
                      : " " + method.returns.front().name + " " + facts(method.returns.front())));
        line("function " + variable(of) + ":" + method.name + "(" + names + ") end");
    }

    static std::vector<std::string> handlers(const Class& of) {
        std::vector<std::string> overloads;
        for (const Event* event : of.events()) {
            const std::string record_type =
                event->name == "deleted" ? "Existence" : event->owner->name() + "." + event->name;
            overloads.push_back("fun(self: " + of.name() + ", event: \"" + event->name +
                                "\", handler: fun(record: " + record_type + ")): Connection");
        }
        return overloads;
    }

    void subscription(const Class& of) {
        for (const GlobalDoc& each : instance_docs())
            if (std::string_view(each.name) == "on")
                function(variable(of) + ":", parse_signatures(each.signature), each.doc,
                         handlers(of));
    }

    // Methods that every instance has; class objects also have `on` and `watch`.
    void object_methods() {
        const Class& object = tree_.object_class();
        for (const GlobalDoc& each : instance_docs())
            function(variable(object) + ":", parse_signatures(each.signature), each.doc,
                     std::string_view(each.name) == "on" ? handlers(object)
                                                         : std::vector<std::string>{});
    }

    // --- Globals

    void globals() {
        for (const GlobalDoc& doc : variable_docs()) function_or_constant(doc);
        for (const auto& [name, of] : fixed_children(tree_, tree_.class_of(tree_.root()))) {
            gap();
            comment(of->doc());
            line("---@type " + of->name());
            line(name + " = nil");
        }
    }

    const Tree& tree_;
    std::string text_;
};

}  // namespace

std::string annotations(const Tree& tree) {
    return Annotations(tree).all();
}

}  // namespace fettle::script
