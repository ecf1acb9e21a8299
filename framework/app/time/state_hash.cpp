#include <time/state_hash.h>

#include <bit>
#include <unordered_map>
#include <vector>

#include <fettle/property/split_mix.h>

namespace fettle::app {

using property::BindingKind;
using property::Type;

void StateHash::add(std::uint64_t bits) {
    state_ = property::split_mix(state_ ^ bits);
}

void StateHash::add(double number) {
    add(std::bit_cast<std::uint64_t>(number));
}

void StateHash::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        word = word << 8 | static_cast<unsigned char>(text[i]);
        if (i % 8 == 7) add(word), word = 0;
    }
    add(word);
}

void StateHash::add(const property::Value& value, const property::Tree& tree) {
    add(static_cast<std::uint64_t>(value.type()));
    switch (value.type()) {
        case Type::nil:
            break;
        case Type::boolean:
            add(std::uint64_t{value.boolean()});
            break;
        case Type::integer:
            add(static_cast<std::uint64_t>(value.integer()));
            break;
        case Type::number:
            add(value.number());
            break;
        case Type::text:
            add(std::string_view(value.text()));
            break;
        case Type::vec2:
            add(value.vec2().x);
            add(value.vec2().y);
            break;
        case Type::color:
            for (const float channel :
                 {value.color().r, value.color().g, value.color().b, value.color().a})
                add(double{channel});
            break;
        case Type::reference:
            // The path, because the number of a handle depends on the history of the run.
            add(std::string_view(tree.alive(value.reference()) ? tree.path(value.reference())
                                                               : std::string()));
            break;
        case Type::list:
            add(static_cast<std::uint64_t>(value.list().size()));
            for (const property::Value& element : value.list()) add(element, tree);
            break;
    }
}

namespace {

/// The saved values of a class that the tree itself stores, and a hash of their names.
struct SavedProperties {
    bool service = false;
    std::uint64_t names = 0;
    std::vector<const property::Property*> properties;
};

SavedProperties saved_properties(const property::Class& of) {
    SavedProperties values;
    values.service = !of.creatable();
    StateHash names;
    names.add(std::string_view(of.name()));
    for (const property::Property* property : of.properties()) {
        if (property->binding.kind != BindingKind::stored || property->transient) continue;
        names.add(std::string_view(property->name));
        values.properties.push_back(property);
    }
    values.names = names.result();
    return values;
}

}  // namespace

void StateHash::add_stored_values(const property::Tree& tree) {
    std::unordered_map<const property::Class*, SavedProperties> classes;
    const auto add_value = [&](property::Handle instance, const property::Property& property) {
        // This settles the value; a formula with an error has its last valid value.
        (void)tree.problem(instance, property);
        add(tree.peek(instance, property), tree);
    };
    tree.each_below(tree.root(), [&](property::Handle instance) {
        const property::Class& of = tree.class_of(instance);
        const auto [known, is_new] = classes.try_emplace(&of);
        if (is_new) known->second = saved_properties(of);
        // Services are skipped, because they may differ between programs (a console). Ad hoc
        // properties that a game added to them are included.
        if (const SavedProperties& values = known->second; !values.service) {
            add(std::string_view(tree.name(instance)));
            add(values.names);
            for (const property::Property* property : values.properties)
                add_value(instance, *property);
        }
        for (const property::Property* own : tree.ad_hoc(instance)) {
            add(std::string_view(own->name));
            add_value(instance, *own);
        }
    });
}

}  // namespace fettle::app
