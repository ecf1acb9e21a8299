#pragma once
// Errors that a user of the tree can cause. The message contains the path, the value, the
// expectation and, for a wrong name, the nearest spelling.

#include <stdexcept>
#include <string>
#include <string_view>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The kind of an error.
enum class ErrorKind {
    unknown_name,    // no such property, child, class, method, event
    near_miss,       // would add an ad-hoc property with a name similar to a declared one
    wrong_type,      // value cannot become the property's type
    out_of_range,    // outside the property's range
    not_finite,      // NaN anywhere; infinity where the property does not allow it
    read_only,       // derived or read-only property
    deleted,         // the handle's instance was deleted
    bad_name,        // name empty, taken, or reserved
    bad_structure,   // a parent inside its own child, class that may not be created, ...
    bad_path,        // path does not parse
    formula,         // the value is a formula that failed or depends on itself
    rejected,        // the owner of the value refused it; the message has the reason
    no_barrier_end,  // handlers kept changing values
    damaged          // a snapshot or save that is incomplete, changed or of another version
};

/// A message as people read it. Of a quoted text and of a word that are longer than 300 bytes, only
/// the first 200 and "…" are kept: callers may give texts of any length. Zero bytes are written as
/// "\0", because one would end the message.
std::string message_text(std::string_view message);

/// A refused call: nothing has changed. Its text names the path, the value and the expected kind of
/// value.
class Error : public std::runtime_error {
  public:
    /// With a text for the user.
    Error(ErrorKind kind, const std::string& message)
        : std::runtime_error(message_text(message)), kind_(kind) {}
    ErrorKind kind() const { return kind_; }  ///< what was wrong

  private:
    ErrorKind kind_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
