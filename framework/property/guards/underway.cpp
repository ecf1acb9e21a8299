#include "underway.h"

#include <instances/instances.h>

namespace fettle::property {

void Underway::require_no_deletion(std::string_view what) const {
    if (deletions != 0)
        throw Error(ErrorKind::bad_structure,
                    "a module is being notified of a deletion: it cannot " + std::string(what) +
                        " meanwhile");
}

void Underway::require_no_rows_ending(std::string_view what) const {
    if (ending_rows)
        throw Error(
            ErrorKind::bad_structure,
            "a module is being notified of the instances that a restore removes: it cannot " +
                std::string(what) + " before the restore is over");
}

void Underway::require_all_rows(std::string_view what) const {
    require_no_rows_ending(what);
    if (!unmade.empty())
        throw Error(ErrorKind::bad_structure,
                    "a module makes the instances of a snapshot again: it cannot " +
                        std::string(what) + " before the restore is over");
}

namespace {

[[noreturn]] void refuse_unmade(const Instances& instances, std::uint32_t index,
                                std::string_view what) {
    throw Error(ErrorKind::bad_structure,
                instances.tree.path(instances.nodes.handle(index)) +
                    " is still to be made by its module, as a snapshot is restored: nothing can " +
                    std::string(what) + " meanwhile");
}

}  // namespace

void Underway::require_rows(const Instances& instances, Handle instance,
                            std::string_view what) const {
    require_no_rows_ending(what);
    if (unmade.empty()) return;
    instances.visit_below(instance.index, [&](std::uint32_t i) {
        if (unmade.contains(i)) refuse_unmade(instances, i, what);
    });
}

void Underway::require_row_above(const Instances& instances, Handle parent,
                                 std::string_view what) const {
    require_no_rows_ending(what);
    if (unmade.contains(parent.index)) refuse_unmade(instances, parent.index, what);
}

void Underway::require_staying(const Instances& instances, Handle instance,
                               std::string_view what) const {
    if (deletions == 0) return;
    instances.visit_below(instance.index, [&](std::uint32_t i) {
        if (instances.nodes[i].being_deleted)
            throw Error(ErrorKind::bad_structure, instances.tree.path(instances.nodes.handle(i)) +
                                                      " is being deleted: its module cannot " +
                                                      std::string(what) + " meanwhile");
    });
}

void Underway::require_settled(const Instances& instances, Handle instance,
                               std::string_view what) const {
    for (const auto& [self, state] : held)
        if (instances.nodes.find(self) != nullptr &&
            (self == instance || instances.tree.is_below(self, instance)))
            throw Error(ErrorKind::bad_structure, instances.tree.path(self) + " " + state +
                                                      ": its module cannot " + std::string(what) +
                                                      " meanwhile");
}

}  // namespace fettle::property
