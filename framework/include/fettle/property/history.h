#pragma once
// History: what people have edited, to be undone and done again.

#include <string>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// One step of undo: a console command, a drag from press to release, an `edit("name", fn)` block.
struct HistoryEntry {
    std::string name;
    Cause cause;
    std::size_t edits = 0;
    bool undone = false;     // can be done again
    bool too_large = false;  // it took more memory than the history may, and cannot be undone
};

struct UndoResult {
    bool done = false;  // false: there was nothing to undo
    std::string name;
    /// What could not be brought back, a line each: watchers that ended with their instance, values
    /// their owner refused, instances their module would not make, or that the game has deleted
    /// since. The rest of the step is undone all the same.
    std::vector<std::string> notes;
};

/// Who wrote a property last. Edits by people, and changes of what is watched, keep file and line;
/// anything else keeps writer and step, as long as it is among the last quarter of a million
/// writes.
struct Provenance {
    bool known = false;
    Cause cause;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
