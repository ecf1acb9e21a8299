#include "instances.h"

#include <values/weight.h>

namespace fettle::property {

const Cell Reads::structure{0, Symbol("*")};

void Reads::add(Cell cell, Handle instance, const Property* property) const {
    list_->push_back({cell, instance, property});
}

std::int64_t Instances::weight_of(std::uint32_t index) const {
    const Node& node = nodes[index];
    std::int64_t sum = weight_of_instance + std::int64_t{class_of(node).weight()};
    if (node.has_ad_hoc)
        for (const auto& [name, cell] : ad_hoc.of_instance.at(index))
            sum += weight_of_own_property + weight_beside(cell.second);
    return sum;
}

void Instances::throw_deleted(Handle handle) const {
    // A formula that looks for a deleted instance runs again when undo may have brought it back.
    reads.note_structure();
    if (!handle) throw Error(ErrorKind::deleted, "no instance: the reference is empty");
    if (const Tombstone* t = tombstones.find(handle))
        throw Error(ErrorKind::deleted,
                    t->path + " was deleted at step " + std::to_string(t->cause.step) + " by " +
                        (t->cause.where.empty() ? std::string(writer_name(t->cause.writer))
                                                : t->cause.where));
    throw Error(ErrorKind::deleted, "the instance was deleted");
}

void Instances::visit_below(std::uint32_t top,
                            const std::function<void(std::uint32_t)>& visit) const {
    // A loop without recursion, so that a long chain of parents cannot overflow the stack.
    std::uint32_t index = top;
    while (index != 0) {
        const std::uint32_t here = index;
        visit(here);
        if (nodes[here].first_child != 0) {
            index = nodes[here].first_child;
            continue;
        }
        while (index != top && nodes[index].next == 0) index = nodes[index].parent;
        if (index == top) return;
        index = nodes[index].next;
    }
}

}  // namespace fettle::property
