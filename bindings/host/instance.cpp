#include <fettle/property/find_instance.h>
#include <fettle/property/spelling.h>

#include "calls.h"

// Instances of the tree and their classes.

using namespace fettle::host;
namespace property = fettle::property;
using property::Handle;

namespace {

/// The instance; 0 is a null handle.
Handle living_or_none(const Game& game, fettle_instance instance) {
    return instance == 0 ? Handle() : living(game, instance);
}

fettle_member member_of(const property::Class& declared_by, const std::string& name,
                        const std::string& doc, fettle_member_kind kind) {
    return {.name = name.c_str(),
            .doc = doc.c_str(),
            .unit = "",
            .declared_by = declared_by.name().c_str(),
            .kind = kind,
            .type = FETTLE_VALUE_NIL,
            .read_only = false};
}

std::vector<fettle_member> members_of(const property::Class& of) {
    std::vector<fettle_member> all;
    for (const property::Property* const each : of.properties()) {
        all.push_back(member_of(*each->owner, each->name, each->doc, FETTLE_MEMBER_PROPERTY));
        all.back().unit = each->unit.c_str();
        all.back().type = static_cast<std::int32_t>(each->type);
        all.back().read_only = each->read_only;
    }
    for (const property::Method* const each : of.methods())
        all.push_back(member_of(*each->owner, each->name, each->doc, FETTLE_MEMBER_METHOD));
    for (const property::Event* const each : of.events())
        all.push_back(member_of(*each->owner, each->name, each->doc, FETTLE_MEMBER_EVENT));
    return all;
}

}  // namespace

fettle_code fettle_hosted_find(fettle_hosted* hosted, const char* path, fettle_instance* found) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const name = text_of("path", path);
        fettle_instance& result = needed("found", found);
        result = converted(property::find_instance(game.tree, name));
    });
}

bool fettle_hosted_is_alive(const fettle_hosted* hosted, fettle_instance instance) {
    return hosted != nullptr && OneThread::is_here() && hosted->game != nullptr && instance != 0 &&
           hosted->game->tree.alive(handle_of(instance));
}

fettle_code fettle_hosted_make(fettle_hosted* hosted, const char* class_name,
                               fettle_instance parent, const char* name, fettle_instance* made) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Class& of = game.tree.class_named(text_of("class_name", class_name));
        const Handle instance =
            game.tree.create(of, living_or_none(game, parent), name == nullptr ? "" : name);
        if (made != nullptr) *made = converted(instance);
    });
}

fettle_code fettle_hosted_delete(fettle_hosted* hosted, fettle_instance instance) {
    return with(__func__, hosted, [&](Game& game) { game.tree.destroy(living(game, instance)); });
}

fettle_code fettle_hosted_move(fettle_hosted* hosted, fettle_instance instance,
                               fettle_instance parent, const char* name) {
    return with(__func__, hosted, [&](Game& game) {
        game.tree.move(living(game, instance), living_or_none(game, parent),
                       name == nullptr ? "" : name);
    });
}

fettle_code fettle_hosted_parent(fettle_hosted* hosted, fettle_instance instance,
                                 fettle_instance* parent) {
    return with(__func__, hosted, [&](Game& game) {
        needed("parent", parent) = converted(game.tree.parent(living(game, instance)));
    });
}

fettle_code fettle_hosted_child(fettle_hosted* hosted, fettle_instance instance, const char* name,
                                fettle_instance* child) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const wanted = text_of("name", name);
        needed("child", child) = converted(game.tree.child(living(game, instance), wanted));
    });
}

fettle_code fettle_hosted_children(fettle_hosted* hosted, fettle_instance instance,
                                   fettle_instance* out, uint32_t room, uint32_t* count) {
    return with(__func__, hosted, [&](Game& game) {
        const std::vector<Handle> all = game.tree.children(living(game, instance));
        write_list(
            all.size(), [&](std::size_t i) { return converted(all[i]); }, out, room, count);
    });
}

fettle_code fettle_hosted_name(fettle_hosted* hosted, fettle_instance instance, const char** name) {
    return with(__func__, hosted, [&](Game& game) {
        const char*& result = needed("name", name);
        const std::string found = game.tree.name(living(game, instance));
        game.given.clear();
        result = game.given.text(found);
    });
}

fettle_code fettle_hosted_path(fettle_hosted* hosted, fettle_instance instance, const char** path) {
    return with(__func__, hosted, [&](Game& game) {
        const char*& result = needed("path", path);
        const std::string found = game.tree.path(living(game, instance));
        game.given.clear();
        result = game.given.text(found);
    });
}

fettle_code fettle_hosted_class_of(fettle_hosted* hosted, fettle_instance instance,
                                   const char** class_name) {
    return with(__func__, hosted, [&](Game& game) {
        needed("class_name", class_name) =
            game.tree.class_of(living(game, instance)).name().c_str();
    });
}

fettle_code fettle_hosted_is_a(fettle_hosted* hosted, fettle_instance instance,
                               const char* class_name, bool* is_a) {
    return with(__func__, hosted, [&](Game& game) {
        const property::Class& of = game.tree.class_named(text_of("class_name", class_name));
        needed("is_a", is_a) = game.tree.class_of(living(game, instance)).is_a(of);
    });
}

fettle_code fettle_hosted_classes(fettle_hosted* hosted, const char** out, uint32_t room,
                                  uint32_t* count) {
    return with(__func__, hosted, [&](Game& game) {
        const std::vector<const property::Class*> all = game.tree.classes();
        write_list(
            all.size(), [&](std::size_t i) { return all[i]->name().c_str(); }, out, room, count);
    });
}

fettle_code fettle_hosted_members(fettle_hosted* hosted, const char* class_name, fettle_member* out,
                                  uint32_t room, uint32_t* count) {
    return with(__func__, hosted, [&](Game& game) {
        const std::vector<fettle_member> all =
            members_of(game.tree.class_named(text_of("class_name", class_name)));
        write_list(
            all.size(), [&](std::size_t i) { return all[i]; }, out, room, count);
    });
}

fettle_code fettle_hosted_call_method(fettle_hosted* hosted, fettle_instance instance,
                                      const char* method, const fettle_hosted_value* arguments,
                                      uint32_t count, fettle_hosted_value* result) {
    return with(__func__, hosted, [&](Game& game) {
        const Handle self = living(game, instance);
        const std::string_view name = text_of("method", method);
        const property::Class& of = game.tree.class_of(self);
        const property::Method* const found = of.method(name);
        if (found == nullptr)
            throw Failure{FETTLE_INVALID, game.tree.path(self) + " has no method \"" +
                                              std::string(name) + "\"" +
                                              property::suggestion(name, of.member_names())};
        const std::vector<property::Value> values = values_of("arguments", arguments, count);
        property::Result answer;
        game.run_scripts([&] { answer = game.tree.call(self, *found, values); });
        game.given.clear();
        if (result != nullptr) *result = game.given.result(answer);
    });
}
