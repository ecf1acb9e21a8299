#pragma once
// While one of these exists, `Tree::last_writer` gets the place of each write.

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The tree must outlive it. Its destructor restores what `Tree::locate_writes` had set.
class LocatedWrites {
  public:
    explicit LocatedWrites(Tree& tree);
    ~LocatedWrites();
    LocatedWrites(const LocatedWrites&) = delete;
    LocatedWrites& operator=(const LocatedWrites&) = delete;

  private:
    Tree& tree_;
    bool before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
