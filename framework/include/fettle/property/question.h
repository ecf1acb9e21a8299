#pragma once
// Questions: events that a module emits inside a step, when the next barrier would be too late.
// Handlers are called at once, in the order of registration, and may change some of the event's
// values; they may read the whole tree but must not change it (`Inquiry`).

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// While it lives, the tree cannot be changed: functions are called in the middle of a step, a
/// search, a snapshot or a change. They may read the tree. Calls that would change it throw
/// Error(rejected), and formulas keep their values.
class Inquiry {
  public:
    /// Errors read "`subject` `rule` delete an instance"; both must outlive this object.
    Inquiry(Tree& tree, std::string_view subject, std::string_view rule);
    ~Inquiry();
    Inquiry(const Inquiry&) = delete;
    Inquiry& operator=(const Inquiry&) = delete;

    /// Throws Error for a call that does `what`.
    [[noreturn]] void refuse(std::string_view what) const;

  private:
    Tree& tree_;
    std::string_view subject_, rule_;
    const Inquiry* outer_;
};

/// A question with its values, for a handler.
class Question {
  public:
    /// The first `changeable` fields are read-only.
    Question(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
             std::size_t changeable)
        : tree_(tree),
          instance_(instance),
          event_(event),
          values_(values),
          changeable_(changeable) {}

    const Event& event() const { return event_; }              ///< of the question
    std::span<const Value> values() const { return values_; }  ///< of its fields
    /// Changes the value of a field. Throws Error for a read-only field, for a value of another
    /// type, or outside the field's range.
    void answer(std::size_t field, const Value& value);

    /// The question whose handler is running on this thread; null if there is none.
    static Question* current();

  private:
    Tree& tree_;
    Handle instance_;
    const Event& event_;
    std::vector<Value>& values_;
    std::size_t changeable_;
};

/// Calls the handlers of an event of an instance. `values` are the values of the event's fields.
/// The handlers may change the fields from `changeable` on; each handler sees the changes of those
/// before it. Errors of handlers go to the tree's error sink, as at a barrier.
void call_handlers(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
                   std::size_t changeable);

}  // namespace fettle::property

FETTLE_PROPERTY_END
