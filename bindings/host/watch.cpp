#include <fettle/property/spelling.h>

#include "calls.h"

// Changes and events.

using namespace fettle::host;
namespace property = fettle::property;

namespace {

template <class Function>
Callback<Function> callback(Function function, void* user) {
    if (function == nullptr)
        throw Failure{FETTLE_INVALID, "the function: expected a pointer, got null"};
    return {function, user};
}

/// Keeps a connection and writes its number to `out`, which may be null.
void keep(Game& game, property::Connection connection, fettle_connection* out) {
    const fettle_connection number = ++game.last_connection;
    game.connections.emplace(number, std::move(connection));
    if (out != nullptr) *out = number;
}

property::ChangeHandler handler_of(Game& game, Callback<fettle_change_callback> called) {
    return [&game, called](const property::Change& change) {
        ReturnedData given;
        const fettle_hosted_change passed{.instance = converted(change.instance),
                                          .property = given.text(change.property->name),
                                          .cause = given.text(change.cause.text()),
                                          .step = change.cause.step,
                                          .old_value = given.value(change.old_value),
                                          .new_value = given.value(change.new_value)};
        game.call_out([&] { called.function(called.user, &passed); });
    };
}

property::ExistenceHandler handler_of(Game& game, Callback<fettle_existence_callback> called) {
    return [&game, called](const property::Existence& existence) {
        game.call_out([&] {
            called.function(called.user, converted(existence.instance),
                            existence.instance_class->name().c_str(), existence.path.c_str());
        });
    };
}

property::EventHandler handler_of(Game& game, Callback<fettle_event_callback> called) {
    return [&game, called](const property::Occurrence& occurrence) {
        ReturnedData given;
        std::vector<const char*> names;
        std::vector<fettle_hosted_value> values;
        for (std::size_t i = 0; i < occurrence.record.values.size(); ++i) {
            names.push_back(given.text((*occurrence.record.fields)[i].name));
            values.push_back(given.value(occurrence.record.values[i]));
        }
        const fettle_hosted_occurrence passed{.instance = converted(occurrence.instance),
                                              .step = occurrence.step,
                                              .event = given.text(occurrence.event->name),
                                              .fields = names.data(),
                                              .values = values.data(),
                                              .count = static_cast<std::uint32_t>(values.size())};
        game.call_out([&] { called.function(called.user, &passed); });
    };
}

const property::Event& event_of(const property::Class& of, const char* name) {
    const std::string_view wanted = text_of("event", name);
    const property::Event* const found = of.event(wanted);
    if (found != nullptr) return *found;
    std::vector<std::string> names;
    for (const property::Event* each : of.events()) names.emplace_back(each->name);
    throw Failure{FETTLE_INVALID, of.name() + " has no event \"" + std::string(wanted) + "\"" +
                                      property::suggestion(wanted, names)};
}

}  // namespace

fettle_code fettle_hosted_watch(fettle_hosted* hosted, const char* pattern,
                                fettle_change_callback changed, void* user,
                                fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const text = text_of("pattern", pattern);
        const auto called = callback(changed, user);
        keep(game, game.tree.watch_pattern(text, handler_of(game, called)), connection);
    });
}

fettle_code fettle_property_watch(fettle_hosted* hosted, fettle_property_id property,
                                  fettle_change_callback changed, void* user,
                                  fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const auto called = callback(changed, user);
        const PropertyHandle& held = found(hosted, property);
        game.tree.require(held.instance);
        keep(game, game.tree.watch(held.instance, *held.property, handler_of(game, called)),
             connection);
    });
}

fettle_code fettle_hosted_watch_made(fettle_hosted* hosted, const char* class_name,
                                     fettle_existence_callback made, void* user,
                                     fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Class& of = game.tree.class_named(text_of("class_name", class_name));
        const auto called = callback(made, user);
        keep(game, game.tree.watch_created(of, handler_of(game, called)), connection);
    });
}

fettle_code fettle_hosted_watch_deleted(fettle_hosted* hosted, const char* class_name,
                                        fettle_existence_callback deleted, void* user,
                                        fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Class& of = game.tree.class_named(text_of("class_name", class_name));
        const auto called = callback(deleted, user);
        keep(game, game.tree.watch_deleted(of, handler_of(game, called)), connection);
    });
}

fettle_code fettle_hosted_on(fettle_hosted* hosted, fettle_instance instance, const char* event,
                             fettle_event_callback happened, void* user,
                             fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Handle of = living(game, instance);
        const property::Event& which = event_of(game.tree.class_of(of), event);
        const auto called = callback(happened, user);
        keep(game, game.tree.on(of, which, handler_of(game, called)), connection);
    });
}

fettle_code fettle_hosted_on_all(fettle_hosted* hosted, const char* class_name, const char* event,
                                 fettle_event_callback happened, void* user,
                                 fettle_connection* connection) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Class& of = game.tree.class_named(text_of("class_name", class_name));
        const property::Event& which = event_of(of, event);
        const auto called = callback(happened, user);
        keep(game, game.tree.on(of, which, handler_of(game, called)), connection);
    });
}

fettle_code fettle_hosted_emit(fettle_hosted* hosted, fettle_instance instance, const char* event,
                               const fettle_hosted_value* values, uint32_t count) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Handle of = living(game, instance);
        const property::Event& which = event_of(game.tree.class_of(of), event);
        game.tree.emit(of, which, values_of("values", values, count));
    });
}

fettle_code fettle_hosted_disconnect(fettle_hosted* hosted, fettle_connection connection) {
    return with(__func__, hosted, [&](Game& game) {
        const auto found = game.connections.find(connection);
        if (found == game.connections.end())
            throw Failure{FETTLE_STALE, "connection " + std::to_string(connection) +
                                            ": there is none, or it was disconnected"};
        property::Connection ended = std::move(found->second);
        game.connections.erase(found);
        ended.stop();
    });
}
