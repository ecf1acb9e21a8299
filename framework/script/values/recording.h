#pragma once
// What one console command read, wrote and printed, for its answer.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

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
        bool replaced = false;  // there was a formula
        std::string note;       // instead of values: "new Body", "deleted"
    };
    bool active = false;  // what happens is noted, so all goes the long way
    property::Writer writer = property::Writer::script;  // the writer while a script runs
    std::vector<Edit> edits;
    const property::Property* last_read = nullptr;  // property read last, for its unit
    std::vector<std::string> lines;                 // printed
    std::size_t dropped = 0;                        // lines and edits beyond the limit

    /// What was noted of a property, to be added to; nullptr beyond the limit.
    Edit* edit_of(property::Handle of, property::Symbol written);
    /// Something else that was done, if what happens is noted.
    void note(property::Handle of, std::string path, std::string text);

  private:
    Edit* add(property::Handle of);
};

}  // namespace fettle::script
