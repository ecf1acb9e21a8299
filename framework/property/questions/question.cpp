// Calls of the handlers of questions.

#include <fettle/property/question.h>

#include <exception>
#include <utility>

#include <classes/coerce.h>
#include <tree/state.h>

namespace fettle::property {
namespace {

thread_local Question* asked = nullptr;

constexpr std::string_view question_rule =
    "is asked inside a step: a handler can change fields of its record, but it cannot";

/// While it lives, a question is being asked on this thread.
class Asking {
  public:
    explicit Asking(Question& question) : before_(std::exchange(asked, &question)) {}
    ~Asking() { asked = before_; }
    Asking(const Asking&) = delete;

  private:
    Question* before_;
};

}  // namespace

Inquiry::Inquiry(Tree& tree, std::string_view subject, std::string_view rule)
    : tree_(tree),
      subject_(subject),
      rule_(rule),
      outer_(std::exchange(tree.state().underway.inquiry, this)) {
    tree_.state().changes.writes.close(WritesLog::Reason::inquiry, true);
}

Inquiry::~Inquiry() {
    tree_.state().underway.inquiry = outer_;
    tree_.state().changes.writes.close(WritesLog::Reason::inquiry, outer_ != nullptr);
}

void Inquiry::refuse(std::string_view what) const {
    throw Error(ErrorKind::rejected,
                std::string(subject_) + " " + std::string(rule_) + " " + std::string(what));
}

Question* Question::current() {
    return asked;
}

void Question::answer(std::size_t field, const Value& value) {
    if (field >= event_.fields.size() || field >= values_.size())
        throw Error(ErrorKind::unknown_name, tree_.path(instance_) + " " + event_.name +
                                                 ": it has no value number " +
                                                 std::to_string(field));
    const Field& of = event_.fields[field];
    const Value& now = values_[field];
    const bool is_empty = now.is(Type::reference) && !now.reference();
    // Scripts see an empty reference as nil.
    if (value == now || (value.is_nil() && is_empty)) return;
    struct Where {
        std::string event, field;
    } place{tree_.path(instance_) + " " + event_.name, of.name};
    const auto name = [](const void* what) {
        const auto& at = *static_cast<const Where*>(what);
        return at.event + ": " + at.field;
    };
    if (field < changeable_) throw Error(ErrorKind::read_only, name(&place) + " is read-only");
    values_[field] =
        coerce_value(property_like(of), value, {.tree = &tree_, .path = name, .what = &place});
}

void call_handlers(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
                   std::size_t changeable) {
    if (!tree.alive(instance)) return;
    Tree::State& s = tree.state();
    s.instances.require_event(instance, event);
    s.instances.require_values(instance, event, values);
    if (event.listeners == 0) return;
    Question question(tree, instance, event, values, changeable);
    const Inquiry inquiry(tree, event.name, question_rule);
    const Asking asking(question);
    // A handler may stop watchers, also its own.
    const Watchers::HandlersRun running(s.changes.watchers);
    std::exception_ptr first_error;
    const HandlerErrors::Collect collect(s.changes.errors, first_error);
    for (const Watcher* watcher :
         s.changes.watchers.of_event(instance, event, s.changes.watchers.last_id()))
        if (watcher->active)
            s.changes.call(*watcher, Occurrence{.instance = instance,
                                                .event = &event,
                                                .record = {event.record_fields, values},
                                                .step = s.changes.author.step});
    if (first_error) std::rethrow_exception(first_error);
}

}  // namespace fettle::property
