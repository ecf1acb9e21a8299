#pragma once
// Edits: changes of a tree by people, reported to one observer. Writes by scripts are not reported,
// so the observer costs a game nothing.

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/formula.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// The states of a property of an instance: absent, default, value, or formula.
struct CellState {
    bool present = false;              ///< whether the instance has the property
    bool overridden = false;           ///< whether it has another value than the default
    Value value{};                     ///< the plain value
    std::optional<Formula> formula{};  ///< in place of a plain value
};

/// What an observer of edits knows at one moment.
struct EditMoment {
    std::shared_ptr<const void> state{};  ///< never changes; null: nothing
    std::size_t bytes = 0;  ///< that it takes besides earlier states of the observer, estimated
};

/// Receives every edit by a person (console, inspector, remote, an `edit` block of a script), and
/// the changes by undo and redo, right after they are made. Members must not throw and must not
/// change the tree; `Tree::cause()` is the writer.
class EditObserver {
  public:
    virtual ~EditObserver() = default;
    /// The property has changed; `before` is its old state. An ad-hoc property may have been
    /// removed.
    virtual void edited(Handle, const Property&, const CellState& /*before*/) {}
    /// The instance was created; it has no place in the tree yet unless undo restored it.
    virtual void instance_created(Handle) {}
    /// Called before the instance and everything below it is deleted.
    virtual void instance_deleting(Handle) {}
    /// The instance has another name or parent. Null parent: it was detached.
    virtual void moved(Handle, Handle /*old_parent*/, const std::string& /*old_name*/) {}
    /// Snapshots, and the log from which steps are repeated, contain this state.
    virtual EditMoment moment() { return {}; }
    /// The tree is at the moment of that `state` of `moment` again; the steps of a log may follow.
    /// Null: the state of a file or of another tree. Called while the tree is being restored, so
    /// the observer must not read it.
    virtual void went_to(const std::shared_ptr<const void>& /*state*/) {}
};

/// How many edits have ended so far that cannot be undone, because they took more memory than the
/// history may.
std::size_t edits_without_undo(const Tree& tree);
/// What the console and scripts print about such an edit.
inline constexpr std::string_view no_undo_message = "this edit took too much memory to be undone";

}  // namespace fettle::property

FETTLE_PROPERTY_END
