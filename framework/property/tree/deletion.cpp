// How instances go, with all that is below them; and what their modules, which are told of it, may
// not do meanwhile.

#include <fettle/property/exception_text.h>
#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

void Tree::State::require_no_deletion(std::string_view what) const {
    if (deletions != 0)
        throw Error(ErrorKind::bad_structure, "a module is told of a deletion: it cannot " +
                                                  std::string(what) + " meanwhile");
}

void Tree::State::require_staying(Handle instance, std::string_view what) const {
    if (deletions == 0) return;
    visit_below(instance.index, [&](std::uint32_t i) {
        if (nodes[i].dying)
            throw Error(ErrorKind::bad_structure, tree.path(nodes.handle(i)) +
                                                      " is being deleted: its module, which is "
                                                      "told of that, cannot " +
                                                      std::string(what) + " meanwhile");
    });
}

void Tree::State::require_made(Handle instance, std::string_view what) const {
    for (const Handle self : making)
        if (self == instance || (nodes.find(self) != nullptr && tree.is_below(self, instance)))
            throw Error(ErrorKind::bad_structure,
                        tree.path(self) + " is being made: its module, which makes it, cannot " +
                            std::string(what) + " meanwhile");
}

std::string Tree::State::destroy_below(std::uint32_t top) {
    const Pin pin(*this, "a lifecycle function");
    struct Deleting {
        int& count;
        explicit Deleting(int& c) : count(c) { ++count; }
        ~Deleting() { --count; }
    } deleting(deletions);
    std::vector<std::uint32_t> order;
    visit_below(top, [&](std::uint32_t i) {
        order.push_back(i);
        nodes[i].dying = 1;
    });
    const Cause by = tree.cause();
    std::string problem;
    for (std::size_t left = order.size(); left > 0; --left)
        destroy_one(order[left - 1], by, left <= most_tombstones, problem);
    return problem;
}

void Tree::State::destroy_one(std::uint32_t index, const Cause& cause, bool remember,
                              std::string& problem) {
    const Handle self = nodes.handle(index);
    const Class& of = classes[nodes[index].class_id];
    const auto of_module = [&](const auto& call) {
        try {
            call();
        } catch (...) {
            if (problem.empty()) problem = tree.path(self) + ": " + exception_text();
        }
    };
    of_module([&] { queue_deletion(self, of, cause); });
    if (remember) bury({self, &of, nodes[index].name.text(), tree.path(self), cause});
    shadows.forget(tree, self);
    note_listeners();
    if (nodes[index].has_formula)
        for (const Property* property : tree.properties(self)) drop_formula(self, *property);
    const std::uint32_t parent = nodes[index].parent;
    const NodeName name = nodes[index].name;
    const bool has_dependents = nodes[index].has_dependents;
    const Lifecycle& lifecycle = of.lifecycle();
    if (lifecycle.destroy)
        of_module([&] { lifecycle.destroy(lifecycle.context, tree, self, nodes[index].row); });
    if (stored[of.id_]) stored[of.id_]->remove(nodes[index].stored_row);
    add_weight(-weight_of_instance);
    if (nodes[index].has_ad_hoc) {
        const auto own = ad_hoc.find(index);
        for (const auto& [name_of_own, cell] : own->second)
            add_weight(-weight_of_own_property - weight_beside(cell.second));
        ad_hoc.erase(own);
    }
    nodes.unlink(index);
    nodes.release(index, history.keeps_slots());
    structure_changed(parent, name);
    if (has_dependents) formulas.instance_gone(index);
}

void Tree::destroy(Handle instance) {
    State& s = *state_;
    s.require(instance);
    s.require_changeable("delete an instance");
    if (instance == s.root && !s.ending)
        throw Error(ErrorKind::bad_structure, "the root cannot be deleted");
    s.require_staying(instance, "delete it");
    if (!s.ending) s.require_made(instance, "delete it");
    // Nobody will undo the end of the tree, and its modules may be gone already.
    if (!s.ending && s.history.recording()) s.history.dying(instance);
    if (!s.ending) s.tell([&](Observer& o) { o.destroying(instance); });
    const std::string problem = s.destroy_below(instance.index);
    s.history.deletion_done();
    if (!problem.empty() && !s.ending)
        throw Error(ErrorKind::rejected,
                    problem + " (thrown by its module as it was deleted; it is gone)");
}

}  // namespace fettle::property
