#pragma once
// A tree whose instances the tests of snapshots save and change, and snapshots as in a file.

#include "fixture.h"

#include <fettle/property/snapshot.h>

namespace fettle::property::testing {

struct SnapshotRig {
    Tree tree;
    BallModule module{tree};  // saved by value
    const Class& thing = define();

    const Class& define() {
        ClassDescriptor d;
        d.name = "Thing";
        d.properties = {{.name = "lives", .type = Type::integer, .default_value = 3},
                        {.name = "label", .type = Type::text, .default_value = ""},
                        {.name = "at", .type = Type::vec2},
                        {.name = "owner", .type = Type::reference}};
        return tree.define(std::move(d));
    }
    Handle make(std::string_view name, Handle parent = {}) {
        return tree.create(thing, parent ? parent : tree.root(), name);
    }
    Handle ball(std::string_view name) {
        return tree.create(tree.class_named("Ball"), tree.root(), name);
    }
};

/// The same bytes as in a save file, without the memory that only this process has.
inline Snapshot through_bytes(const Snapshot& snapshot) {
    return Snapshot::from_bytes(snapshot.to_bytes());
}

}  // namespace fettle::property::testing
