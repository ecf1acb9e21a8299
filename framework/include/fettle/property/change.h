#pragma once
// Changes that watchers receive, and their causes.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The writer of a change.
enum class Writer : std::uint8_t {
    module,
    simulation,
    script,
    console,
    inspector,
    formula,
    undo,
    load,
    remote,
    restore  // a snapshot was restored
};

/// The name for users: "console".
std::string_view writer_name(Writer writer);

/// Who made a change, where and when.
struct Cause {
    Writer writer = Writer::module;  ///< who
    /// The place if it is known: "main.lua:30", name of a module; otherwise "".
    std::string where{};
    std::uint64_t step = 0;  ///< number of the step
    /// "console, step 412"; "main.lua:30, step 412".
    std::string text() const;
};

/// One property of one instance changed since the last barrier. Contains the first old and the last
/// new value.
struct Change {
    Handle instance;                     ///< that it is about; it may be deleted
    const Property* property = nullptr;  ///< that has changed
    Value old_value;                     ///< at the last barrier, or when the watcher began
    Value new_value;                     ///< now
    Cause cause;                         ///< of the last change
};

/// An instance was created or deleted.
struct Existence {
    Handle instance;                        ///< that it is about; it may be deleted
    const Class* instance_class = nullptr;  ///< its class
    std::string path;                       // current or last path
    Cause cause;                            ///< of the creation or the deletion
    /// After a deletion: the last values, in the order of the class's properties, then the ad-hoc
    /// ones.
    std::vector<std::pair<const Property*, Value>> last_values;
};

/// An event happened to an instance.
struct Occurrence {
    Handle instance;               ///< that it is about; it may be deleted
    const Event* event = nullptr;  ///< that happened
    Record record;                 ///< its data
    std::uint64_t step = 0;        ///< number of the step
};

/// Called at a barrier for each change.
using ChangeHandler = std::function<void(const Change&)>;
/// Called at a barrier for each instance that was created or deleted.
using ExistenceHandler = std::function<void(const Existence&)>;
/// Called at a barrier for each event.
using EventHandler = std::function<void(const Occurrence&)>;

/// How a handler is called.
struct WatchOptions {
    /// Deliver the current value at the next barrier, as a change from nil.
    bool initial = false;
    /// Name of the handler in error messages, e.g. "main.lua:12".
    std::string label{};
};

class FETTLE_PROPERTY_PRIVATE Watchers;

/// A watcher's registration. It can be copied. Its destructor does not end the watch; `stop` does.
class Connection {
  public:
    Connection() = default;  ///< of no watch
    void stop();             ///< ends the watch; the handler is called no more
    bool active() const;     ///< whether the watch goes on

  private:
    friend class Watchers;
    Connection(std::weak_ptr<Watchers*> watchers, std::uint64_t id)
        : watchers_(std::move(watchers)), id_(id) {}
    std::weak_ptr<Watchers*> watchers_;
    std::uint64_t id_ = 0;
};

/// Ends the watch in its destructor.
class ScopedConnection {
  public:
    ScopedConnection() = default;  ///< of no watch
    /// Takes over a connection.
    ScopedConnection(Connection connection) : connection_(std::move(connection)) {}
    ScopedConnection(ScopedConnection&& other) noexcept
        : connection_(std::move(other.connection_)) {
        other.connection_ = {};
    }
    /// Ends its own watch and takes over the other.
    ScopedConnection& operator=(ScopedConnection&& other) noexcept {
        connection_.stop();
        connection_ = std::move(other.connection_);
        other.connection_ = {};
        return *this;
    }
    ~ScopedConnection() { connection_.stop(); }

  private:
    Connection connection_;
};

/// An exception of a handler. `where`: label of the handler; `path`: the property or instance that
/// it was called for.
struct HandlerError {
    std::string path;              ///< the property or the instance
    std::string where;             ///< label of the handler
    std::string message;           ///< text of the exception
    std::exception_ptr exception;  ///< itself
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
