#pragma once
// Creation, deletion, moving and renaming of instances. Permissions are checked elsewhere; these
// functions notify modules, watchers, observers and formulas.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <formulas/formulas.h>

namespace fettle::property {

struct Structure {
    Structure(Formulas& f, Underway& u)
        : changes(f.changes()),
          instances(changes.instances),
          nodes(instances.nodes),
          tree(instances.tree),
          formulas(f),
          underway(u) {}

    Changes& changes;
    Instances& instances;
    Nodes& nodes;
    Tree& tree;
    Formulas& formulas;
    Underway& underway;
    std::uint64_t version = 0;         // counts creations, deletions and moves
    std::vector<Handle> next_handles;  // handles for the instances of a repeated call

    /// Called when the children of `parent`, or their names, have changed.
    void changed(std::uint32_t parent, const NodeName& name);

    // creation.cpp
    /// `again`: the old handle of an instance that comes back.
    std::uint32_t make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                       Handle again = {});
    /// The next name of `stem_1`, `stem_2` ... that was never used under this parent.
    NodeName free_name(std::uint32_t parent, std::string_view stem);

    // deletion.cpp
    /// Returns the first exception text of a module; "" if there was none.
    std::string destroy_below(std::uint32_t top);

    // placing.cpp
    /// Changes only the links; the caller notifies modules.
    void relink(Handle instance, const Position& at);
    /// A module refused a place: moves the subtree back.
    void move_back(Handle instance, const Position& was);
    /// Moves the subtree; after an error it is where it was. Notifies no observers.
    void move_or_stay(Handle instance, const Position& at);
    /// Notifies the modules of the subtree.
    void place_subtree(Handle top);
    void notify_move(Handle instance);

  private:
    void undo_making(Handle self, const Class& of, bool has_row);
    void finish_making(Handle self, const Class& of);
    void unmake(Handle self);
    /// Logs the last number that was given, so that a repeated step gives the same numbers. Must be
    /// called where the number may have changed without a logged creation or move.
    void note_number(std::uint32_t parent, Symbol stem);
    /// Stores the first exception text of a module in `problem` and continues. `remember`: keep a
    /// tombstone with the cause, for error messages.
    void destroy_one(std::uint32_t index, const Cause& cause, bool remember, std::string& problem);
};

}  // namespace fettle::property
