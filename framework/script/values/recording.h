#pragma once
// Records what one console command reads, writes and prints, for its result.

#include <set>
#include <string>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

namespace fettle::script {

struct Recording {
    struct Edit {
        property::Handle instance;
        property::Symbol symbol;
        std::string path;
        std::string unit;
        property::Precision precision{};
        property::Value before;
        property::Value after;
        bool replaced = false;  // the property had a formula
        std::string added;      // the name of the property, if it was added
        std::string note;       // instead of values: "new Body", "deleted"
    };
    bool active = false;  // while true, all reads and writes take the general path and are recorded
    bool declaring = false;       // the same while the top level of a game runs: see declarations.h
    bool drawing = false;         // while a function draws
    bool after_snapshot = false;  // from snapshot() to the end of the call
    bool late_change_noted = false;  // a note about a change after snapshot() was given
    property::Writer writer = property::Writer::script;  // the writer while a script runs
    std::vector<Edit> edits;
    const property::Property* last_read = nullptr;  // its unit is shown with the result
    std::vector<std::string> lines;                 // printed
    std::vector<std::size_t> texts;                 // which of the lines come from `print`
    std::vector<FoldedLines> folded;                // what some of the lines stand for
    std::string nothing;                  // the pattern of the last query that has found nothing
    std::string missing;                  // the callback that was read last and that the game lacks
    std::set<std::string> drawn_changes;  // of which `note_change` has given a note
    std::set<std::string> degrees;        // class and property that have a note about degrees
    std::size_t dropped = 0;              // edits beyond the limit
    std::size_t dropped_lines = 0;        // printed lines beyond the limit

    /// Whether writes take the general path, which may give a note about them.
    bool noting() const { return drawing || after_snapshot; }
    /// The record of a property, which the caller fills in; nullptr beyond the limit.
    Edit* edit_of(property::Handle of, property::Symbol written);
    /// Records another action; nullptr beyond the limit and if recording is not active.
    Edit* note(property::Handle of, std::string path, std::string text);

  private:
    Edit* add(property::Handle of);
};

}  // namespace fettle::script
