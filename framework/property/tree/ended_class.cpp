// Classes whose modules have ended.

#include <fettle/property/ended_class.h>
#include <fettle/property/error.h>

#include "state.h"

namespace fettle::property {
namespace {

/// Exceptions of lifecycle functions below are ignored, unless the instance still exists.
void destroy_despite_errors(Tree& tree, Handle instance) {
    try {
        tree.destroy(instance);
    } catch (...) {
        if (tree.alive(instance)) throw;
    }
}

}  // namespace

void end_class(Tree& tree, const Class& ended) {
    Tree::State& s = tree.state();
    s.require_changeable("end a class");
    s.instances.require_own(ended);
    if (tree.class_of(tree.root()).is_a(ended))
        throw Error(ErrorKind::bad_structure,
                    "class " + ended.name() + " cannot end: the root is one of its instances");
    // First, so that no function that is called below makes another instance.
    s.instances.classes.end(ended);
    for (std::uint32_t i = 1; i < s.instances.nodes.end(); ++i) {
        const Node& node = s.instances.nodes[i];
        if (node.alive() && s.instances.class_of(node).is_a(ended))
            destroy_despite_errors(tree, s.instances.nodes.handle(i));
    }
}

}  // namespace fettle::property
