#pragma once
// Events that ask: what a module tells inside a step, where waiting for the barrier would be too
// late. Handlers are called at once, in the order they were registered, and may change some of the
// values they are told; of the tree they may read everything and change nothing (`Inquiry`).

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// While one lives, a function of a game is asked something in the middle of a step or of a search:
/// the memory of modules must stay as it is. The function may read the tree. Whatever would change
/// the tree throws Error(rejected), and formulas keep the values they have.
class Inquiry {
  public:
    /// Errors read "`subject` `rule` delete an instance"; both must outlive the inquiry.
    Inquiry(Tree& tree, std::string_view subject, std::string_view rule);
    ~Inquiry();
    Inquiry(const Inquiry&) = delete;
    Inquiry& operator=(const Inquiry&) = delete;

    [[noreturn]] void refuse(std::string_view what) const;

  private:
    Tree& tree_;
    std::string_view subject_, rule_;
    const Inquiry* outer_;
};

/// What a handler is being asked.
class Question {
  public:
    Question(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
             std::size_t changeable)
        : tree_(tree),
          instance_(instance),
          event_(event),
          values_(values),
          changeable_(changeable) {}

    const Event& event() const { return event_; }
    std::span<const Value> values() const { return values_; }
    /// Changes the value of a field. Throws Error: for one that is only told, a value that is none
    /// of the field's type, or one outside its range.
    void answer(std::size_t field, const Value& value);

    /// The question whose handler is running on this thread; null outside of one.
    static Question* current();

  private:
    Tree& tree_;
    Handle instance_;
    const Event& event_;
    std::vector<Value>& values_;
    std::size_t changeable_;
};

/// Asks those who listen to an event of an instance. `values` are those of the event's fields; the
/// fields from `changeable` on may be changed, and are handed from one handler to the next. Errors
/// of handlers go to the tree's error sink, as at a barrier.
void ask(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
         std::size_t changeable);

}  // namespace fettle::property

FETTLE_PROPERTY_END
