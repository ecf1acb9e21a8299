#pragma once
// Classes in scripts: every class of the tree is an object that constructs when called; `class`
// makes new ones, whose functions are methods, callbacks and handlers of events.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

class ScriptClasses {
  public:
    explicit ScriptClasses(Machine& machine) : machine_(machine) {}

    /// Pushes the one object of the class.
    void push(lua_State* L, const property::Class& of);
    /// Pushes the function a script gave the class (or one of its bases) under a name; the name on
    /// the stack is given by its index.
    bool push_function(lua_State* L, const property::Class& of, int name);
    bool push_function(lua_State* L, const property::Class& of, std::string_view name);
    bool has_function(const property::Class& of, std::string_view name);
    void add_function_names(const property::Class& of, std::vector<std::string>& names);
    /// Of the class itself.
    std::vector<std::string> own_functions(const property::Class& of) const;
    /// The function on top of the stack becomes the class's own; taken.
    void set_function(lua_State* L, const property::Class& of, const std::string& name);

    struct Definition {
        std::string name;
        const property::Class* base = nullptr;
        std::string doc;
        std::vector<property::Property> properties;  // inherited names: another default
    };
    /// Makes the class, or on reloading takes the one that is there when its properties are the
    /// same.
    const property::Class& define(Definition definition);
    bool scripted(const property::Class& of) const;

    /// A new detached instance, with the defaults that the scripts' classes redeclare.
    property::Handle create(const property::Class& of);
    /// Throws for 2.5 assigned to a property that a class declared as `lives = 3`, saying so.
    void explain_integer(const property::Property& property, const property::Value& value) const;

    /// Tells everything that found its place since: calls `ready` of scripts' classes and emits the
    /// event; children first.
    bool deliver_ready();
    bool step(double dt);
    /// Calls `draw(pen)` of everything placed; the pen is a reference in the registry.
    bool draw(int pen);
    // Snapshots: the order in which instances are stepped, and the instances that are not ready
    // yet.
    void save(property::ByteWriter& to) const;
    std::function<void()> restore(property::ByteReader& from);
    /// Members since the last call, in order; the first call begins it.
    std::vector<property::Handle> take_adopted();
    void redo_adopted(const std::vector<property::Handle>& adopted);

    /// Functions go, classes stay: the game is loaded anew.
    void forget_functions();

  private:
    struct Info {
        int object = LUA_NOREF;
        int functions = LUA_NOREF;  // table of the class's own functions
        bool scripted = false;
        std::vector<std::string> function_names;
        std::vector<std::string> connected;  // events with a handler for this class
        // Of a class defined again with other defaults than the tree knows.
        std::vector<std::pair<const property::Property*, property::Value>> defaults;
    };

    Info& info(const property::Class& of) { return infos_[&of]; }
    const std::vector<int>& chain(const property::Class& of);
    const property::Class* definer(const property::Class& of, std::string_view name);
    void connect(const property::Class& of, const std::string& name);
    void observe(const property::Class& of);
    void adopt(property::Handle instance, bool announce);
    /// Calls the function of that name of everything placed; `push` adds its argument.
    template <class Push>
    bool call_all(const char* name, Push push);

    Machine& machine_;
    std::unordered_map<const property::Class*, Info> infos_;
    std::unordered_map<const property::Class*, std::vector<int>> chains_;
    bool any_functions_ = false;
    std::vector<property::Handle> members_;    // instances of scripts' classes, oldest first
    std::unordered_set<std::uint64_t> known_;  // the same, by handle
    std::size_t prune_at_ = 1024;              // deleted ones are looked for then
    bool calling_ = false;                     // `members_` is being walked
    std::vector<property::Handle> adopted_;    // for `take_adopted`, while it is used
    bool noting_ = false;
    struct Waiting {
        property::Handle instance;
        bool announce;  // no other code emits its `ready`
    };
    std::pair<std::uint64_t, std::size_t> looked_at_;  // structure of the tree, size of the next
    std::vector<Waiting> waiting_;                     // made, and not told yet that they are ready
};

}  // namespace fettle::script
