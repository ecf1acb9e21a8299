#include "lifetime.h"

#include <string>

namespace fettle::property {

void Lifetime::require_unpinned() const {
    if (pinned != nullptr)
        throw Error(ErrorKind::bad_structure,
                    std::string("the tree is destroyed by ") + pinned +
                        " that it is calling, which must not do so (see \"Lifetimes\" in tree.h)");
}

void Lifetime::require_going_on(const char* what) const {
    if (ending)
        throw Error(ErrorKind::deleted,
                    std::string("the tree is being destroyed: it cannot ") + what + " any more");
}

void Use::finish() const {
    if (lifetime_.ending)
        throw Error(ErrorKind::deleted, "the tree was destroyed by a function that it called");
}

}  // namespace fettle::property
