#pragma once
// Notes for users of other engines. Scripts may add any properties and functions, so such code is
// not an error, but it has no effect and was probably meant to have one. Each note is given once.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Machine;

class Hints {
  public:
    explicit Hints(Machine& machine) : machine_(machine) {}

    /// To be called when a property that the class does not declare was added to an instance.
    void property_added(property::Handle instance, std::string_view name);
    /// ` (did you mean position = vec(x, y)?)` for a property that a native class does not have, or
    /// "".
    std::string did_you_mean(const property::Class& of, std::string_view name) const;
    /// A hint for a name that a person has just added at the console: ` (did you mean "mass"?)`,
    /// `; its Circle has radius`, or "". It is given each time.
    std::string of_added(property::Handle instance, std::string_view name) const;
    /// A hint at a child that has the property: "its Circle has radius", or "".
    std::string child_with(property::Handle instance, std::string_view name) const;
    /// `; its shapes have it, as in Circle { radius = ... }` for a property that a body does not
    /// have, or "" if no class of shapes has it. `exact`: not one that the name may mean.
    std::string of_shapes(const property::Class& of, const std::string& name,
                          bool exact = false) const;
    /// True while a command of the console runs whose first word is `word`: `gravity` in
    /// `gravity = 0`.
    bool begins_command(std::string_view word) const;
    /// What can be typed in place of the command that runs at the console, if its first word is
    /// `word`, a name that does not exist; or "".
    std::string of_command(std::string_view word) const;
    /// The path of the first instance with that name, below others; "" if there is none
    /// nearby.
    std::string path_of_instance(std::string_view name) const;
    /// The path of the declared property or method of that name, in any case, of the selected
    /// instance or of the first that has it; "" if there is none nearby, or for a name of one
    /// letter, which was meant as a variable.
    std::string path_of_member(std::string_view name) const;
    /// To be called when the game is loaded: notes functions that are never called although their
    /// names look like callbacks, names of keys that no key has, functions of Fettle that the game
    /// has replaced by values, instances that it has made and dropped, and bodies that it has made
    /// where none is in the tree.
    void game_loaded();
    /// To be called when a script rewinds: gives a note if no past is kept. A command is answered
    /// each time, also where no step was made yet.
    void rewinding();
    /// To be called when a script assigns a new global variable: gives a note if the name is nearly
    /// that of a state whose value has the same type.
    void variable_added(std::string_view name, const property::Value& value);
    /// To be called when a method assigns a new global variable with the name of a property of its
    /// instance. `hint`: what was probably meant.
    void variable_hides_property(std::string_view name, const std::string& hint);
    /// To be called when `state` finds a value of another type.
    void stated(const std::string& name, const std::string& problem);
    /// To be called before a game is loaded, also again: forgets all given notes.
    void forget();

  private:
    std::string path_of_first(const std::function<std::string(property::Handle)>& part) const;
    void report(const std::string& about, const std::string& note);
    std::string meaning(const property::Class& of, std::string_view name) const;
    // load_hints.cpp: the parts of `game_loaded`
    void check_globals();
    void check_unfinished_classes();
    void check_classes();
    void check_replaced();
    void check_local_callbacks();
    void check_keys();
    void check_dropped();
    void check_held();
    void check_formulas();
    std::map<std::string, std::string_view> files() const;
    bool is_called(const std::string& name) const;

    Machine& machine_;
    std::set<std::string> given_;
    // Unplaced instances of the code before a reload, which drops them.
    std::vector<property::Handle> earlier_;
    std::unordered_set<std::uint64_t> checked_;  // class and name
};

}  // namespace fettle::script
