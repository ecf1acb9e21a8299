#pragma once
// Edits: what people do to a tree, told to whoever keeps it. Scripts' own writes are none of these,
// so listening costs the game nothing.

#include <optional>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/formula.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Everything a property of an instance can be: absent, its default, a value, a formula.
struct CellState {
    bool present = false;
    bool overridden = false;
    Value value{};
    std::optional<Formula> formula{};
};

/// Told of every edit by a person (console, inspector, remote, a script's `edit` block), and of
/// what undo and redo make of it, at the moment it has been done. Members must not throw and must
/// not change the tree; who edits is `Tree::cause()`.
class EditObserver {
  public:
    virtual ~EditObserver() = default;
    /// The property is something else now; `before` is what it was. An ad-hoc one may be gone.
    virtual void edited(Handle, const Property&, const CellState& /*before*/) {}
    /// It was created, and has no place in the tree yet unless it was brought back by undo.
    virtual void born(Handle) {}
    /// Before the instance, and everything below it, goes.
    virtual void dying(Handle) {}
    /// It has another name or parent. Null parent: it hung nowhere.
    virtual void moved(Handle, Handle /*old_parent*/, const std::string& /*old_name*/) {}
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
