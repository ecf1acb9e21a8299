// Classes of scripts during a reload of the game.

#include <map>
#include <set>
#include <utility>

#include <fettle/property/redefinition.h>

#include <classes/script_classes.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <text/words.h>
#include <values/members.h>

namespace fettle::script {

/// The properties as they were declared. A default may have been replaced since.
std::vector<Property> ScriptClasses::own_properties(const Class& of) const {
    std::vector<Property> own;
    for (const Property* property : of.properties())
        if (property->owner == &of) own.push_back(*property);
    return own;
}

void ScriptClasses::begin_reload() {
    unfinished_.clear();
    earlier_places_ = std::exchange(places_, {});
    for (auto& [of, own] : infos_) {
        Earlier& earlier = earlier_[of];
        earlier.functions = std::exchange(own.functions, LUA_NOREF);
        earlier.states = std::exchange(own.states, LUA_NOREF);
        earlier.function_names = std::exchange(own.function_names, {});
        if (own.scripted) {
            earlier.properties = own_properties(*of);
            earlier.events = own.events;
        }
    }
    chains_.clear();
}

void ScriptClasses::end_reload(bool keep) {
    lua_State* const L = machine_.lua.main;
    if (!keep) places_ = std::move(earlier_places_);
    for (auto& [of, earlier] : earlier_) {
        Info& own = info(*of);
        if (!keep) {
            std::swap(own.functions, earlier.functions);
            std::swap(own.states, earlier.states);
            own.function_names = std::move(earlier.function_names);
            if (own.scripted) {
                // Without events first: a property may take the name of one, and the other way.
                declare_events(*of, {});
                property::redefine(machine_.tree, *of, std::move(earlier.properties));
                declare_events(*of, std::move(earlier.events));
            }
        }
        luaL_unref(L, LUA_REGISTRYINDEX, earlier.functions);
        luaL_unref(L, LUA_REGISTRYINDEX, earlier.states);
    }
    earlier_.clear();
    chains_.clear();
    machine_.members.clear();
    any_functions_ = any_states_ = false;
    for (const auto& [of, own] : infos_) {
        any_functions_ |= own.functions != LUA_NOREF;
        any_states_ |= own.states != LUA_NOREF;
    }
}

std::vector<std::string> ScriptClasses::lost_classes() const {
    const property::Tree& tree = machine_.tree;
    std::vector<std::string> notes;
    for (const auto& [name, place] : earlier_places_) {
        const Class* const of = places_.contains(name) ? nullptr : tree.find_class(name);
        if (of == nullptr) continue;
        const auto left = std::ranges::count_if(members_, [&](Handle member) {
            return tree.alive(member) && &tree.class_of(member) == of;
        });
        const std::string where = place.empty()
                                      ? std::string()
                                      : ", which was at " + place.substr(0, place.size() - 2) + ",";
        notes.push_back("reload: class " + name + where + " is no longer defined; " +
                        std::to_string(left) +
                        (left == 1 ? " instance of it is" : " instances of it are") +
                        " left, without its functions");
    }
    return notes;
}

std::vector<std::string> ScriptClasses::lost_states() const {
    const property::Tree& tree = machine_.tree;
    std::vector<std::string> notes;
    std::map<const Class*, std::vector<std::string>> known;
    std::set<std::pair<const Class*, std::string>> reported;
    for (const Handle member : members_) {
        if (!tree.alive(member) || !tree.is_below(member, tree.root())) continue;
        const Class& of = tree.class_of(member);
        if (!has_states(of)) continue;
        const auto [states, is_new] = known.try_emplace(&of);
        if (is_new) states->second = states_of(of);
        const std::string state = current_state(tree, member);
        if (state.empty() || among(states->second, state)) continue;
        if (reported.emplace(&of, state).second)
            notes.push_back("reload: " + tree.path(member) + " is in the state \"" + state +
                            "\", which " + of.name() +
                            " has no more: no function is called for it until :state(name) "
                            "enters another");
    }
    return notes;
}

std::vector<ScriptClasses::NewDefault> ScriptClasses::new_defaults() const {
    std::vector<NewDefault> all;
    for (const Class* of : machine_.tree.classes()) {
        const auto found = earlier_.find(of);
        if (found == earlier_.end()) continue;
        for (const Property& before : found->second.properties) {
            const Property* const now = of->property(before.name);
            if (now != nullptr && now->owner == of && now->type == before.type &&
                !(now->default_value == before.default_value))
                all.push_back({now, before.default_value});
        }
    }
    return all;
}

}  // namespace fettle::script
