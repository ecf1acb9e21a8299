#pragma once
// History: the edits of people, for undo and redo.

#include <string>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// One step of undo: a console command, a drag from press to release, an `edit("name", fn)` block.
struct HistoryEntry {
    std::string name;        ///< of the step of undo
    Cause cause;             ///< of its first write
    std::size_t edits = 0;   ///< number of its changes
    bool undone = false;     // can be redone
    bool too_large = false;  // over the memory limit: it cannot be undone
};

/// A property or an instance that undo or redo has changed. The values are as printed, with the
/// unit after `to`; "is ..." for a formula, "nil" where there is no such property. For an instance
/// that was made, deleted, renamed or moved, `from` is "" and `to` says what has become of it.
struct UndoChange {
    std::string path, from, to;  ///< what has changed, the value before and the value now
};

/// The result of `Tree::undo` and `Tree::redo`.
struct UndoResult {
    static constexpr std::size_t max_changes =
        1020;                ///< listed ones; a console shows the first and folds the others
    bool done = false;       // false: there was nothing to undo
    std::string name;        ///< of the step of undo
    bool too_large = false;  ///< it took more memory than the history may; nothing was changed
    /// The first changes, those of instances before those of values, and the number of the others.
    std::vector<UndoChange> changes{};
    std::size_t more_changes = 0;  ///< number of changes that are not listed
    /// One line for each thing that could not be restored: watchers that ended with their instance,
    /// values that their owner refused, instances that their module refused to create or that the
    /// game has deleted since. The rest of the step is undone.
    std::vector<std::string> notes;
};

/// The last writer of a property. Edits by people, and changes of watched properties, include file
/// and line. Other writes include writer and step, if they are among the last 250 000 writes.
struct Provenance {
    bool known = false;  ///< whether the writer is known
    Cause cause;         ///< of the last write
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
