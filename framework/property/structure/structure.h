#pragma once
// How instances come, go, and get another place or name. What may be done is checked elsewhere;
// here modules, watchers, observers and formulas learn of it.

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
    std::uint64_t version = 0;         // counts comings, goings and moves
    std::vector<Handle> next_handles;  // of the instances that a repeated call makes again

    /// The children of `parent` are others, or one has another name.
    void changed(std::uint32_t parent, const NodeName& name);

    // making.cpp
    /// `again`: the instance comes back with its old identity.
    std::uint32_t make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                       Handle again = {});
    /// `stem_1`, `stem_2` ...: never one used before under this parent.
    NodeName free_name(std::uint32_t parent, std::string_view stem);

    // deletion.cpp
    /// Returns what modules have thrown, the first of it; "": nothing.
    std::string destroy_below(std::uint32_t top);

    // placing.cpp
    /// Links alone; modules are to be told.
    void hang(Handle instance, const Position& at);
    /// A module refused a place: those that had taken theirs go back, and nothing has happened.
    void hang_back(Handle instance, const Position& was);
    /// Hangs it there with all that is below it, or leaves it where it is. Nobody is told.
    void hang_or_leave(Handle instance, const Position& at);
    /// Tells the modules of all from there down.
    void place_subtree(Handle top);
    void tell_of_move(Handle instance);

  private:
    void take_back(Handle self, const Class& of, bool has_row);
    void finish_making(Handle self, const Class& of);
    void unmake(Handle self);
    /// Logs note the number that was given last, so that a step that is made again gives the same
    /// ones. To be called where it may have changed and nothing is told that changes it again.
    void note_number(std::uint32_t parent, Symbol stem);
    /// What a module throws is kept in `problem`, the first of it, and the deletion goes on.
    /// `remember`: who asks for it later is told who deleted it.
    void destroy_one(std::uint32_t index, const Cause& cause, bool remember, std::string& problem);
};

}  // namespace fettle::property
