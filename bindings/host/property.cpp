#include "calls.h"

// Values of properties, by path and by handle.

using namespace fettle::host;
namespace property = fettle::property;
using property::Type;
using property::Value;

namespace {

std::string path_of(const Game& game, const PropertyHandle& held) {
    return game.tree.path(held.instance, *held.property);
}

Value read(const Game& game, const PropertyHandle& held) {
    Value whole = game.tree.get(held.instance, *held.property);
    if (held.part.empty()) return whole;
    return property::part_of(whole, held.part, path_of(game, held));
}

void write(Game& game, const PropertyHandle& held, const Value& value) {
    // A copy, because a setter may run code that makes more handles.
    const PropertyHandle at = held;
    if (at.part.empty()) return game.tree.set(at.instance, *at.property, value);
    const Value whole = game.tree.get(at.instance, *at.property);
    game.tree.set(at.instance, *at.property,
                  property::with_part(whole, at.part, value, path_of(game, at)));
}

/// Reads a value of that type.
Value read(const Game& game, const PropertyHandle& held, Type type) {
    Value value = read(game, held);
    const bool fits = type == Type::number ? value.is_numeric() : value.is(type);
    if (!fits)
        throw Failure{FETTLE_INVALID, path_of(game, held) + ": expected a value of the type " +
                                          std::string(property::type_name(type)) + ", got " +
                                          std::string(property::type_name(value.type()))};
    return value;
}

std::int8_t component_of(const property::Place& place) {
    if (place.part.empty()) return -1;
    if (place.part.size() == 1 && place.property->type == Type::vec2 && !place.part[0].is_index()) {
        const std::string& name = std::get<std::string>(place.part[0].key);
        if (name == "x") return 0;
        if (name == "y") return 1;
    }
    return -2;
}

fettle_property_id make_handle(Game& game, const property::Place& place) {
    std::uint32_t at = 0;
    if (game.released.empty()) {
        at = static_cast<std::uint32_t>(game.held.size());
        game.held.emplace_back();
    } else {
        at = game.released.back();
        game.released.pop_back();
    }
    PropertyHandle& made = game.held[at];
    made.instance = place.instance;
    made.property = place.property;
    made.component = component_of(place);
    made.part = place.part;
    return fettle_property_id{made.generation} << 32 | at;
}

property::Place property_at(const Game& game, const char* path) {
    property::Place place = property::resolve(game.tree, path);
    if (place.property == nullptr)
        throw Failure{FETTLE_INVALID, std::string(path) + ": expected a property, got an instance"};
    return place;
}

/// The number of a property in the usual cases; false: it must be read as a value.
inline bool read_fast(const Game& game, const PropertyHandle& held, double& number) {
    if (held.component == -1) return game.tree.read(held.instance, *held.property, number);
    property::Vec2 vector(0, 0);
    if (held.component < 0 || !game.tree.read(held.instance, *held.property, vector)) return false;
    number = held.component == 0 ? vector.x : vector.y;
    return true;
}

}  // namespace

fettle_code fettle_hosted_get(fettle_hosted* hosted, const char* path, fettle_hosted_value* value) {
    return with(__func__, hosted, [&](Game& game) {
        fettle_hosted_value& result = needed("value", value);
        const Value read = property::get(game.tree, text_of("path", path));
        game.given.clear();
        result = game.given.value(read);
    });
}

fettle_code fettle_hosted_set(fettle_hosted* hosted, const char* path,
                              const fettle_hosted_value* value) {
    return with(__func__, hosted, [&](Game& game) {
        property::set(game.tree, text_of("path", path), value_of("value", needed("value", value)));
    });
}

fettle_code fettle_hosted_reset(fettle_hosted* hosted, const char* path) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Place place = property_at(game, text_of("path", path));
        if (!place.part.empty())
            throw Failure{FETTLE_INVALID,
                          std::string(path) + ": expected a whole property, got a part of one"};
        game.tree.reset(place.instance, *place.property);
    });
}

fettle_code fettle_property_at(fettle_hosted* hosted, const char* path,
                               fettle_property_id* property) {
    return with(__func__, hosted, [&](Game& game) {
        fettle_property_id& result = needed("property", property);
        result = make_handle(game, property_at(game, text_of("path", path)));
    });
}

fettle_code fettle_property_of(fettle_hosted* hosted, fettle_instance instance, const char* name,
                               fettle_property_id* property) {
    return with(__func__, hosted, [&](Game& game) {
        fettle_property_id& result = needed("property", property);
        const property::Handle of = living(game, instance);
        result = make_handle(game, {of, &game.tree.property(of, text_of("name", name)), {}});
    });
}

fettle_code fettle_property_release(fettle_hosted* hosted, fettle_property_id property) {
    return with(__func__, hosted, [&](Game& game) {
        (void)found(hosted, property);
        const auto place = static_cast<std::uint32_t>(property);
        game.released.push_back(place);
        PropertyHandle& held = game.held[place];
        held.property = nullptr;
        held.part.clear();
        ++held.generation;
    });
}

fettle_code fettle_property_get(fettle_hosted* hosted, fettle_property_id property,
                                fettle_hosted_value* value) {
    return with(__func__, hosted, [&](Game& game) {
        fettle_hosted_value& result = needed("value", value);
        const Value got = read(game, found(hosted, property));
        game.given.clear();
        result = game.given.value(got);
    });
}

fettle_code fettle_property_set(fettle_hosted* hosted, fettle_property_id property,
                                const fettle_hosted_value* value) {
    return with(__func__, hosted, [&](Game& game) {
        write(game, found(hosted, property), value_of("value", needed("value", value)));
    });
}

fettle_code fettle_property_get_number(fettle_hosted* hosted, fettle_property_id property,
                                       double* number) {
    return with(__func__, hosted, [&](Game& game) {
        const PropertyHandle& held = found(hosted, property);
        double& result = needed("number", number);
        double value = 0;
        result = read_fast(game, held, value) ? value : read(game, held, Type::number).as_double();
    });
}

fettle_code fettle_property_set_number(fettle_hosted* hosted, fettle_property_id property,
                                       double number) {
    return with(__func__, hosted, [&](Game& game) {
        const PropertyHandle& held = found(hosted, property);
        if (held.component == -1 && game.tree.write(held.instance, *held.property, number)) return;
        write(game, found(hosted, property), number);
    });
}

fettle_code fettle_property_get_boolean(fettle_hosted* hosted, fettle_property_id property,
                                        bool* boolean) {
    return with(__func__, hosted, [&](Game& game) {
        bool& result = needed("boolean", boolean);
        result = read(game, found(hosted, property), Type::boolean).boolean();
    });
}

fettle_code fettle_property_set_boolean(fettle_hosted* hosted, fettle_property_id property,
                                        bool boolean) {
    return with(__func__, hosted,
                [&](Game& game) { write(game, found(hosted, property), flag(boolean)); });
}

fettle_code fettle_property_get_vec2(fettle_hosted* hosted, fettle_property_id property, double* x,
                                     double* y) {
    return with(__func__, hosted, [&](Game& game) {
        const PropertyHandle& held = found(hosted, property);
        double& left = needed("x", x);
        double& up = needed("y", y);
        property::Vec2 vector(0, 0);
        if (held.component != -1 || !game.tree.read(held.instance, *held.property, vector))
            vector = read(game, held, Type::vec2).vec2();
        left = vector.x;
        up = vector.y;
    });
}

fettle_code fettle_property_set_vec2(fettle_hosted* hosted, fettle_property_id property, double x,
                                     double y) {
    return with(__func__, hosted, [&](Game& game) {
        const PropertyHandle& held = found(hosted, property);
        const property::Vec2 vector(x, y);
        if (held.component == -1 && game.tree.write(held.instance, *held.property, vector)) return;
        write(game, found(hosted, property), vector);
    });
}

fettle_code fettle_property_get_text(fettle_hosted* hosted, fettle_property_id property,
                                     const char** text) {
    return with(__func__, hosted, [&](Game& game) {
        const char*& result = needed("text", text);
        const Value value = read(game, found(hosted, property), Type::text);
        game.given.clear();
        result = game.given.text(value.text());
    });
}

fettle_code fettle_property_set_text(fettle_hosted* hosted, fettle_property_id property,
                                     const char* text) {
    return with(__func__, hosted,
                [&](Game& game) { write(game, found(hosted, property), text_of("text", text)); });
}

fettle_code fettle_property_get_instance(fettle_hosted* hosted, fettle_property_id property,
                                         fettle_instance* instance) {
    return with(__func__, hosted, [&](Game& game) {
        fettle_instance& result = needed("instance", instance);
        const Value value = read(game, found(hosted, property));
        result = value.is_nil()
                     ? 0
                     : converted(read(game, found(hosted, property), Type::reference).reference());
    });
}

fettle_code fettle_property_set_instance(fettle_hosted* hosted, fettle_property_id property,
                                         fettle_instance instance) {
    return with(__func__, hosted, [&](Game& game) {
        write(game, found(hosted, property), instance == 0 ? Value() : Value(handle_of(instance)));
    });
}
