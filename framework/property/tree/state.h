#pragma once
// What a tree is made of, and the edits of it that take several of these parts.

#include <string>
#include <string_view>
#include <vector>

#include <history/history.h>

namespace fettle::property {

/// What of snapshots outlasts making them.
struct SnapshotState {
    std::vector<SnapshotPart*> parts;
    std::size_t size = 0;              // of the last one
    std::vector<std::string> remarks;  // what could not be as it was, of the last restore
};

struct Tree::State {
    explicit State(Tree& owner) : tree(owner) {}

    Tree& tree;
    const std::uint64_t number = next_number();  // no other tree of the process has it
    Lifetime lifetime{tree};
    Underway underway;
    Instances instances{tree};
    Changes changes{instances, lifetime};
    Formulas formulas{changes, underway};
    Structure structure{formulas, underway};
    History history{structure};
    const Event* restored_event = nullptr;  // of Game
    SnapshotState snapshots;

    static std::uint64_t next_number();
    /// Throws where nothing may be changed: formulas compute and functions that are asked answer.
    /// `what`: "delete an instance".
    void require_changeable(std::string_view what) const;

    // ad_hoc_edits.cpp
    const Property& ad_hoc_property(Symbol name);
    void put_ad_hoc(Handle instance, const Property& added, const Value& value);
    const Property& add_ad_hoc(Handle instance, std::string_view name, const Value& value);
};

}  // namespace fettle::property
