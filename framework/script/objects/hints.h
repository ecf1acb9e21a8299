#pragma once
// Notes for users of other engines: code that is no error, since a script may add any properties
// and functions, but has no effect and was surely meant to have one. Each note is given once.

#include <set>
#include <string>
#include <string_view>
#include <unordered_set>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Machine;

class Hints {
  public:
    explicit Hints(Machine& machine) : machine_(machine) {}

    /// A property that its class does not declare was added to an instance.
    void property_added(property::Handle instance, std::string_view name);
    /// The game is loaded: functions that nothing calls and whose names say what they are for.
    void game_loaded();
    /// The game is loaded anew.
    void forget();

  private:
    void tell(const std::string& about, const std::string& note);
    std::string meaning(const property::Class& of, std::string_view name) const;
    std::string child_with(property::Handle instance, std::string_view name) const;
    void look_at_globals();
    void look_at_classes();
    bool is_called(const std::string& name) const;

    Machine& machine_;
    std::set<std::string> told_;
    std::unordered_set<std::uint64_t> looked_at_;  // class and name
};

}  // namespace fettle::script
