#pragma once
// Classes in scripts. Every class of the tree is an object that constructs an instance when called.
// `class` defines new classes, whose functions are methods, callbacks and event handlers.

#include <functional>
#include <map>
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

/// The properties of a class with states: the current one, and the one that was entered last.
std::vector<property::Property> state_properties();

/// The state of an instance of a class with states.
std::string current_state(const property::Tree& tree, property::Handle instance);

class ScriptClasses {
  public:
    explicit ScriptClasses(Machine& machine) : machine_(machine) {}

    /// Pushes the object of a class; each class has exactly one.
    void push(lua_State* L, const property::Class& of);
    /// Pushes the function that a script defined for the class or one of its bases; returns false
    /// if there is none. `name` is the stack index of the name.
    bool push_function(lua_State* L, const property::Class& of, int name);
    bool push_function(lua_State* L, const property::Class& of, std::string_view name);
    bool has_function(const property::Class& of, std::string_view name);
    void add_function_names(const property::Class& of, std::vector<std::string>& names);
    /// Names of functions of the class itself, without its bases.
    std::vector<std::string> own_functions(const property::Class& of) const;
    /// Pops the function at the top of the stack and adds it to the class.
    void set_function(lua_State* L, const property::Class& of, const std::string& name);

    /// To be called by `class(name, base)`, which is not complete before its table follows. `place`
    /// is that of the call: "main.lua:3: ".
    void begin(const std::string& name, const std::string& place) { unfinished_[name] = place; }
    /// What a reload has left without effect: instances in a state that their class has no more.
    std::vector<std::string> lost_states() const;
    /// The same: instances of classes that the files do not define any more.
    std::vector<std::string> lost_classes() const;
    /// Name and place of each class whose table has not followed.
    const std::map<std::string, std::string, std::less<>>& unfinished() const {
        return unfinished_;
    }

    /// An event that a class of a script declares. The default of a field is its value in an event
    /// that is sent without it.
    struct OwnEvent {
        std::string name;
        std::string doc;
        std::vector<property::Property> fields;
    };
    struct Definition {
        std::string name;
        const property::Class* base = nullptr;
        std::string doc;
        std::vector<property::Property> properties;  // an inherited name sets another default
        std::vector<OwnEvent> events;
    };
    /// Defines a class. If it exists: during a reload it gets these properties; otherwise they must
    /// be the same.
    const property::Class& define(Definition definition);
    bool scripted(const property::Class& of) const;

    /// The event of an instance that scripts may send: null if no class of a script declares it.
    const OwnEvent* own_event(const property::Event& event) const;
    /// Counts what an event takes that is going to be sent, until the end of the next barrier.
    void weigh_sent(const std::vector<property::Value>& values);

    /// Pops the table of states at the top of the stack and gives it to the class, which must have
    /// `state_properties`.
    void set_states(lua_State* L, const property::Class& of);
    /// Pushes the table of the class itself; returns false if there is none.
    bool push_states(lua_State* L, const property::Class& of) const;
    /// Whether the class or one of its bases has states.
    bool has_states(const property::Class& of) const;
    /// The names of the states that the class and its bases have now, in order: scripts may add
    /// some to `states` at any time.
    std::vector<std::string> states_of(const property::Class& of) const;
    /// Leaves the state of the instance and enters the other, at once. Throws for an unknown one.
    void change_state(lua_State* L, property::Handle self, const std::string& name);
    /// To be called before a script writes a property: throws for an unknown state.
    void require_known_state(property::Handle self, const property::Property& property,
                             const property::Value& value) const;

    /// Creates a detached instance with the defaults of the scripts' classes.
    property::Handle create(const property::Class& of);
    /// Throws if a number such as 2.5 is assigned to a property declared as `lives = 3`, which made
    /// it an integer; the message explains this.
    void explain_integer(const property::Property& property, const property::Value& value) const;

    /// For each instance that was placed since the last call, children first: calls `ready` of
    /// scripts' classes and emits the event.
    bool deliver_ready();
    bool step(double dt);
    /// Enters the states that were assigned, and calls `step` of the current ones.
    bool step_states(double dt);
    /// Calls `draw(pen)` of one instance; `pen` is a reference in the registry. False after an
    /// error.
    bool draw(property::Handle instance, int pen);
    // Snapshots contain the order in which instances are stepped, and those that are not ready yet.
    void save(property::ByteWriter& to) const;
    std::function<void()> restore(property::ByteReader& from);
    /// An instance whose `ready` was not called yet.
    struct Waiting {
        property::Handle instance;
        bool announce;  // true: `ready` must be emitted here, because no other code does it
    };
    /// What was added and became ready since the last call, in order; the first call starts
    /// recording.
    struct Changes {
        std::vector<property::Handle> adopted, ready;
        std::vector<Waiting> waiting;
        std::size_t bytes() const;
    };
    Changes take_changes();
    void redo(const Changes& changes);

    /// Removes all functions and keeps the classes, before a game is loaded.
    void forget_functions();

    // For a reload. `begin_reload` removes all functions and states. `end_reload` keeps those that
    // were defined since (`keep`), or restores the old ones and the old properties.
    void begin_reload();
    void end_reload(bool keep);
    /// Properties whose default has changed since `begin_reload`.
    struct NewDefault {
        const property::Property* property;
        property::Value before;
    };
    std::vector<NewDefault> new_defaults() const;

  private:
    struct Info {
        int object = LUA_NOREF;
        int functions = LUA_NOREF;  // table of the class's own functions
        int states = LUA_NOREF;     // table of the class's own states
        bool scripted = false;
        std::vector<std::string> function_names;
        std::vector<std::string> connected;  // events with a handler for this class
        // Defaults that differ from those in the tree, because the class was defined again.
        std::vector<std::pair<const property::Property*, property::Value>> defaults;
        std::vector<OwnEvent> events;
    };

    /// The former definition of a class, which `end_reload` may restore.
    struct Earlier {
        int functions = LUA_NOREF, states = LUA_NOREF;
        std::vector<std::string> function_names;
        std::vector<property::Property> properties;  // of the class itself
        std::vector<OwnEvent> events;
    };
    std::vector<property::Property> own_properties(const property::Class& of) const;
    void declare_events(const property::Class& of, std::vector<OwnEvent> events);
    [[noreturn]] void refuse_base(const property::Class& existing, const std::string& first) const;
    void note_second(const std::string& name, const std::string& first,
                     const std::string& second) const;

    Info& info(const property::Class& of) { return infos_[&of]; }
    const std::vector<int>& chain(const property::Class& of);
    const property::Class* definer(const property::Class& of, std::string_view name);
    void connect(const property::Class& of, const std::string& name);
    void observe(const property::Class& of);
    /// Adds the instance to those that are stepped. False if it is one of them already.
    bool adopt(property::Handle instance);
    void forget_ended();
    void wait_for(property::Handle instance, bool announce);
    bool push_state_function(lua_State* L, const property::Class& of, std::string_view state,
                             const char* name) const;
    /// Throws for an unknown state, and for one whose table holds something else than functions.
    void require_state(const property::Class& of, const std::string& where,
                       const std::string& name) const;
    void enter_state(lua_State* L, property::Handle self);
    bool enter_assigned_state(property::Handle self);
    /// Calls the function of that name of all placed instances; `push` adds its argument.
    template <class Push>
    bool call_all(const char* name, Push push);

    Machine& machine_;
    std::unordered_map<const property::Class*, Info> infos_;
    std::unordered_map<const property::Class*, std::vector<int>> chains_;
    std::unordered_map<const property::Class*, Earlier> earlier_;
    std::map<std::string, std::string, std::less<>> unfinished_;
    std::map<std::string, std::string> places_;  // of the classes that this load has defined
    std::map<std::string, std::string> earlier_places_;  // during a reload: those of the last load
    bool any_functions_ = false;
    bool any_states_ = false;
    std::shared_ptr<std::int64_t> sent_ = std::make_shared<std::int64_t>(0);  // bytes
    int changing_states_ = 0;                  // changes of states in progress
    std::vector<property::Handle> members_;    // instances of scripts' classes, oldest first
    std::unordered_set<std::uint64_t> known_;  // the same, by handle
    std::size_t prune_at_ = 1024;              // size at which deleted members are removed
    Changes changes_;                          // for `take_changes`, once it is used
    bool noting_ = false;
    // Structure of the tree and size of `waiting_` at the last check.
    std::pair<std::uint64_t, std::size_t> last_check_;
    std::vector<Waiting> waiting_;
};

/// The end of a message about a name that is a class without its table, or "".
std::string hint_of_unfinished_class(const ScriptClasses& classes, std::string_view name);

}  // namespace fettle::script
