#include <algorithm>
#include <cmath>

#include <fettle/property/bound_text.h>
#include <fettle/property/natural_order.h>

#include <reference/reference_facts.h>
#include <reference/signature.h>
#include <text/columns.h>

namespace fettle::script {

using property::Class;
using property::Field;
using property::Handle;
using property::Property;
using property::Type;

std::string with_unit(const property::Tree& tree, const property::Value& value,
                      const Property& property) {
    std::string text = tree.text(value, property.precision());
    if (!property.unit.empty() && (value.is_numeric() || value.is(Type::vec2)))
        text += " " + property.unit;
    return text;
}

std::string unit_text(const std::string& unit) {
    return unit.empty() ? "–" : unit;
}

std::string bounds_text(const Property& property) {
    const auto& [low, high] = property.range;
    const auto endless = [&](double bound) { return std::isinf(bound) && !property.infinity; };
    const auto text = [&](double bound) {
        return property::bound_text(bound, property.precision());
    };
    if (endless(high)) return "at least " + text(low);
    if (endless(low)) return "at most " + text(high);
    return text(low) + " to " + text(high);
}

bool has_range(const Property& property) {
    switch (property.type) {
        case property::Type::number:
        case property::Type::integer:
            return true;
        case property::Type::vec2:
        case property::Type::color:
        case property::Type::list:
            return property.range.bounded();
        default:
            return false;
    }
}

std::string range_text(const Property& property) {
    if (few_enumerators(property)) {
        std::string words;
        for (const std::string& word : property.enumerators)
            words += (words.empty() ? "\"" : ", \"") + word + "\"";
        return words;
    }
    if (!property.enumerators.empty())
        return std::to_string(property.enumerators.size()) + " texts";
    if (property.any_type) return "any value";
    if (has_range(property) && property.range.bounded()) return bounds_text(property);
    switch (property.type) {
        case Type::boolean:
            return "true or false";
        case Type::integer:
            return "any integer";
        case Type::number:
            return property.infinity ? "any number, infinite too" : "any finite number";
        case Type::vec2:
            return "any finite vec";
        case Type::color:
            return "channels 0 to 1";
        case Type::reference:
            return property.reference_class.empty() ? "any instance"
                                                    : "any " + property.reference_class;
        case Type::list:
            return "any length";
        case Type::text:
            return "any text";
        case Type::nil:
            break;
    }
    return "any value";
}

bool is_computed(const Property& property) {
    return property.read_only || property.binding.kind == property::BindingKind::node ||
           !property.derives_from.empty();
}

std::string default_text(const property::Tree& tree, const Property& property) {
    if (is_computed(property)) return "computed";
    return tree.text(property.default_value, property.precision());
}

std::string property_facts(const property::Tree& tree, const Property& property) {
    std::string text(property.any_type ? "any" : property::type_name(property.type));
    const auto add = [&](const std::string& part) { text += " · " + part; };
    if (!property.reference_class.empty()) add(property.reference_class);
    if (!property.unit.empty()) add(property.unit);
    if (property.range.bounded()) add(bounds_text(property));
    if (!property.enumerators.empty() && !few_enumerators(property)) {
        add("one of " + std::to_string(property.enumerators.size()) + " texts like \"" +
            property.enumerators.front() + "\" and \"" + property.enumerators.back() + "\"");
    } else if (!property.enumerators.empty()) {
        std::string words;
        for (const std::string& word : property.enumerators)
            words += (words.empty() ? "" : ", ") + word;
        add(words);
    }
    if (!is_computed(property) && !property.any_type)
        add("default " + cut(tree.text(property.default_value, property.precision()), 40));
    if (property.read_only) add("read-only");
    if (property.simulated) add("simulated");
    return text;
}

std::string shown_doc(std::string_view doc) {
    std::string shown;
    for (std::size_t at = 0; at < doc.size();) {
        const std::size_t open = doc.find('`', at);
        const std::size_t close = open == doc.npos ? open : doc.find('`', open + 1);
        if (close == doc.npos) return shown.append(doc.substr(at));
        shown.append(doc.substr(at, open - at)).append(doc.substr(open + 1, close - open - 1));
        at = close + 1;
    }
    return shown;
}

std::string constructor_text(const Class& of) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    // Its own properties say most; each instance has those of Object.
    for (const Class* at = &of; at->base() != nullptr; at = at->base())
        for (const Property* each : of.properties())
            if (each->owner == at && !each->hidden && !each->read_only) names.push_back(each->name);
    std::string text = of.name() + " {";
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
        text += (i > 0 ? ", " : " ") + names[i];
    return text + (names.size() > most ? ", … }" : " }");
}

std::string signature(const property::Method& method) {
    Signature shown{.name = method.name, .parameters = {}, .returns = {}};
    for (std::size_t i = 0; i < method.parameters.size(); ++i)
        shown.parameters.push_back(
            {.name = method.parameters[i].name, .type = {}, .optional = i >= method.required});
    return plain(shown);
}

std::string flags_text(const Property& property) {
    std::string text;
    const auto add = [&](bool holds, const char* word) {
        if (holds) text += (text.empty() ? "" : ", ") + std::string(word);
    };
    add(property.read_only, "read-only");
    add(property.simulated, "simulated");
    add(property.clamp, "clamped");
    add(property.infinity, "may be infinite");
    add(property.nullable, "may be nil");
    add(property.transient && !property.read_only, "not saved");
    return text;
}

namespace {

std::string plain_type(Type type, const std::string& reference_class) {
    switch (type) {
        case Type::boolean:
            return "boolean";
        case Type::integer:
            return "integer";
        case Type::number:
            return "number";
        case Type::text:
            return "string";
        case Type::vec2:
            return "vec";
        case Type::color:
            return "color";
        case Type::reference:
            return reference_class.empty() ? "Object" : reference_class;
        default:
            return "any";
    }
}

template <class Described>
std::string type_of(const Described& described) {
    return described.type == Type::list
               ? plain_type(described.element, described.reference_class) + "[]"
               : plain_type(described.type, described.reference_class);
}

template <class Member>
std::vector<const Member*> own(const Class& of, const std::vector<const Member*>& all) {
    std::vector<const Member*> members;
    for (const Member* member : all)
        if (member->owner == &of) members.push_back(member);
    std::sort(members.begin(), members.end(), [](const Member* a, const Member* b) {
        return property::NaturalOrder{}(a->name, b->name);
    });
    return members;
}

}  // namespace

bool few_enumerators(const Property& property) {
    return !property.enumerators.empty() && property.enumerators.size() <= 16;
}

std::string annotated_type(const Property& property) {
    if (property.any_type) return "any";
    if (!property.enumerators.empty()) {
        std::string words;
        for (const std::string& word : property.enumerators)
            words += (words.empty() ? "\"" : "|\"") + word + "\"";
        return words;
    }
    const bool is_optional = property.nullable || property.type == Type::reference;
    return type_of(property) + (is_optional ? "?" : "");
}

std::string annotated_type(const Field& field) {
    return type_of(field) + (field.nullable ? "?" : "");
}

bool returns_record(const property::Method& method) {
    return method.returns.size() > 1;
}

std::string result_name(const property::Method& method) {
    return method.owner->name() + "." + method.name + ".result";
}

std::string annotated_result(const property::Method& method) {
    if (method.returns.empty()) return "nil";
    if (!returns_record(method)) return annotated_type(method.returns.front());
    return result_name(method) + (method.many ? "[]" : "?");
}

std::vector<const Property*> own_properties(const Class& of) {
    std::vector<const Property*> properties = own(of, of.properties());
    std::erase_if(properties, [](const Property* property) { return property->hidden; });
    return properties;
}

std::vector<const property::Method*> own_methods(const Class& of) {
    return own(of, of.methods());
}

std::vector<const property::Event*> own_events(const Class& of) {
    return own(of, of.events());
}

std::vector<std::pair<std::string, const Class*>> fixed_children(const property::Tree& tree,
                                                                 const Class& of) {
    std::vector<std::pair<std::string, const Class*>> children;
    const auto visit = [&](Handle handle) {
        if (&tree.class_of(handle) != &of || !children.empty()) return;
        for (const Handle child : tree.children(handle)) {
            const std::string name = tree.name(child);
            const Class& made = tree.class_of(child);
            // Instances of creatable classes belong to the game, except for the world that every
            // game has.
            const bool own = made.creatable() && (handle != tree.root() || name != "world");
            if (of.property(name) == nullptr && !own) children.emplace_back(name, &made);
        }
    };
    visit(tree.root());
    tree.each_below(tree.root(), visit);
    std::sort(children.begin(), children.end());
    return children;
}

}  // namespace fettle::script
