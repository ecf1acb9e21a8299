#pragma once
// Compares the declarations of the top level of a game with the earlier ones, and applies the
// differences to the game.
//
// The top level has made detached instances. If the top level made an instance for the same place
// before, the detached one stands for that instance: only values that are declared differently are
// given to the living instance, and the detached one is deleted. All other detached ones are new.
// What a person has edited stays, unless the top level declares the same value differently.

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <classes/script_classes.h>
#include <writes/declarations.h>

namespace fettle::script {

struct Machine;

class Merge {
  public:
    using Declared = Declarations::Declared;
    using Assignment = Declarations::Assignment;

    /// `notes` gets a line for each value that could not be applied.
    Merge(Machine& machine, Declarations::All next, std::vector<std::string>& notes);

    void run(const std::vector<ScriptClasses::NewDefault>& defaults);
    /// The instance of the game for which a detached one stands; a deleted one if the game has
    /// deleted it. Any other instance is itself.
    property::Handle result_of(property::Handle instance) const;
    /// Variables of scripts refer to the instances of the game from now on. Deletes the detached
    /// ones, and keeps the declarations for the next time.
    void finish();
    /// Whether a value or an instance of the game was changed.
    bool has_changed() const { return changed_; }

  private:
    struct Waiting {
        property::Handle instance, parent;
        std::string name;
    };
    const Declared* declared_before(const std::string& path) const;
    const Declared* declared_before(property::Handle living, const std::string& path) const;
    void match(property::Handle made, property::Handle parent, const std::string& name);
    void match_below(property::Handle made, property::Handle living);
    void add_pair(property::Handle made, property::Handle living);
    void mark_deleted(property::Handle made);
    property::Handle living(const Declared& before, property::Handle parent,
                            const std::string& name) const;
    property::Value translated(const property::Value& value) const;
    void apply(const Declared& now, property::Handle to, const Declared* before);
    void apply_one(property::Handle to, const std::string& name, const Assignment* now,
                   const Assignment* before);
    bool is_declared_before(property::Handle to, const property::Property* property,
                            const Assignment& now, const Assignment* before) const;
    bool is_given_as_before(property::Handle made, const std::string& name) const;
    bool is_set_by_files(property::Handle to, const property::Property& property,
                         const Assignment* now);
    void set(property::Handle to, const std::string& name, const Assignment* now,
             const Assignment* before);
    std::string said(property::Handle of, const property::Property& property,
                     const Assignment* now) const;
    void drop_edits_below(const std::string& path);
    void remake_edits(property::Handle instance);
    bool has_kept(property::Handle instance) const;
    void refer_to_results();
    void delete_undeclared();
    void place_new();
    void note_orders();
    void put_in_order();
    void apply_defaults(const std::vector<ScriptClasses::NewDefault>& defaults);
    void call_new();
    void tell_scenes();
    void rebind(property::Handle made, property::Handle living);
    template <class Change>
    void attempt(property::Handle instance, const std::string& name, Change change);

    Machine& machine_;
    property::Tree& tree_;
    Declarations::All next_;
    std::vector<std::string>& notes_;
    std::unordered_map<std::uint64_t, const Declared*> next_by_handle_, last_by_handle_;
    std::unordered_map<std::string, const Declared*> last_by_path_;
    std::unordered_map<std::uint64_t, property::Handle> results_;
    std::vector<std::pair<property::Handle, property::Handle>> pairs_;  // made, living or deleted
    std::unordered_set<std::uint64_t> matched_;                         // living ones that stay
    std::vector<Waiting> waiting_;
    bool changed_ = false;
    /// Parents of the game, and the children that the top level gives them, in its order.
    std::vector<std::pair<property::Handle, std::vector<property::Handle>>> orders_;
};

}  // namespace fettle::script
