#include <fettle/property/spelling.h>

#include "calls.h"

// Classes that a program adds to a game.

using namespace fettle::host;
namespace property = fettle::property;

namespace {

constexpr std::uint32_t most_members = 10'000;

std::string text_or_empty(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

property::Type type_of(const std::string& name, std::int32_t type) {
    if (type < FETTLE_VALUE_NIL || type > FETTLE_VALUE_LIST)
        throw Failure{FETTLE_INVALID, name + ": type = " + std::to_string(type) +
                                          ": expected one of fettle_value_type"};
    return static_cast<property::Type>(type);
}

/// Calls `read` for each element of an array.
template <class Element, class Read>
void each(const char* what, const Element* elements, std::uint32_t count, Read read) {
    if (count > most_members)
        throw Failure{FETTLE_INVALID, std::string(what) + ": expected at most 10000 of them, got " +
                                          std::to_string(count)};
    if (count > 0) needed(what, elements);
    for (std::uint32_t i = 0; i < count; ++i) read(elements[i]);
}

property::Property property_of(const fettle_property_def& def) {
    property::Property made;
    made.name = text_of("name of a property", def.name);
    made.type = type_of(made.name, def.type);
    made.any_type = made.type == property::Type::nil;
    made.nullable = flag(def.nullable) || made.any_type;
    made.default_value = value_of("default_value", def.default_value);
    made.unit = text_or_empty(def.unit);
    made.doc = text_or_empty(def.doc);
    if (def.min != 0 || def.max != 0) made.range = {def.min, def.max};
    return made;
}

std::vector<property::Field> fields_of(const char* what, const fettle_parameter_def* fields,
                                       std::uint32_t count) {
    std::vector<property::Field> made;
    each(what, fields, count, [&](const fettle_parameter_def& def) {
        property::Field field;
        field.name = text_of("name of a field", def.name);
        field.type = type_of(field.name, def.type);
        if (field.type == property::Type::nil)
            throw Failure{FETTLE_INVALID, field.name + ": expected a field with a type"};
        field.nullable = true;
        field.unit = text_or_empty(def.unit);
        field.doc = text_or_empty(def.doc);
        made.push_back(std::move(field));
    });
    return made;
}

property::Result call_method(void* context, property::Tree&, property::Handle self, property::Row,
                             std::span<const property::Value> arguments) {
    const BoundMethod method = *static_cast<const BoundMethod*>(context);
    return answer_of(*method.game, arguments, [&](auto passed, auto count, auto result) {
        return method.call(method.user, converted(self), passed, count, result);
    });
}

/// Removes the methods that were made for a class, unless the class was defined.
class MethodRollback {
  public:
    explicit MethodRollback(Game& game) : game_(game), before_(game.methods.size()) {}
    ~MethodRollback() {
        if (!done) game_.methods.resize(before_);
    }
    MethodRollback(const MethodRollback&) = delete;
    bool done = false;

  private:
    Game& game_;
    std::size_t before_;
};

property::Method method_of(Game& game, const fettle_method_def& def) {
    property::Method made;
    made.name = text_of("name of a method", def.name);
    if (def.call == nullptr)
        throw Failure{FETTLE_INVALID, made.name + ": expected a function, got null"};
    made.doc = text_or_empty(def.doc);
    made.parameters = fields_of("parameters", def.parameters, def.parameter_count);
    if (def.required > made.parameters.size())
        throw Failure{FETTLE_INVALID, made.name + ": required = " + std::to_string(def.required) +
                                          ": expected at most the number of parameters, " +
                                          std::to_string(made.parameters.size())};
    made.required = def.required;
    made.effect = property::Effect::tree;
    made.context = &game.methods.emplace_back(BoundMethod{&game, def.call, def.user});
    made.call = call_method;
    return made;
}

/// Refuses a property whose name is nearly that of one of the base class, as Lua does: "velocty" is
/// meant to be `velocity`.
void refuse_near_misses(const property::Tree& tree, const property::ClassDescriptor& made) {
    const property::Class* const base = tree.find_class(made.base);
    if (base == nullptr) return;  // the tree refuses the class
    for (const property::Property& own : made.properties)
        for (const property::Property* known : base->properties())
            if (property::misspells(own.name, own.type, known->name, known->type))
                throw Failure{FETTLE_INVALID, made.name + "." + own.name + ": " + base->name() +
                                                  " has no such property (did you mean \"" +
                                                  known->name + "\"?)"};
}

}  // namespace

fettle_code fettle_class_def_init(fettle_class_def* def, size_t size) {
    return init(__func__, def, size, fettle_class_def{});
}

fettle_code fettle_hosted_define(fettle_hosted* hosted, const fettle_class_def* def) {
    return outside(__func__, hosted, "get a class", [&](Game& game) {
        const fettle_class_def& wanted = needed("def", def);
        check_size(wanted);
        MethodRollback rollback(game);
        property::ClassDescriptor made;
        made.name = text_of("name", wanted.name);
        if (wanted.base != nullptr) made.base = wanted.base;
        made.doc = text_or_empty(wanted.doc);
        each(
            "properties", wanted.properties, wanted.property_count,
            [&](const fettle_property_def& each) { made.properties.push_back(property_of(each)); });
        each("events", wanted.events, wanted.event_count, [&](const fettle_event_def& each) {
            made.events.push_back({.name = text_of("name of an event", each.name),
                                   .fields = fields_of("fields", each.fields, each.field_count),
                                   .doc = text_or_empty(each.doc)});
        });
        each("methods", wanted.methods, wanted.method_count,
             [&](const fettle_method_def& each) { made.methods.push_back(method_of(game, each)); });
        refuse_near_misses(game.tree, made);
        game.tree.define(std::move(made));
        rollback.done = true;
    });
}
