#pragma once

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// While it lives, a function is called that must not destroy the tree, because work on the tree
/// continues when it returns. If the function does destroy it, the program ends with a message that
/// contains `what`, which must outlive this object: "the function given to on_print".
class Pinned {
  public:
    /// From now on, the tree must not be destroyed.
    Pinned(Tree& tree, const char* what);
    ~Pinned();
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

  private:
    Tree& tree_;
    const char* outer_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
