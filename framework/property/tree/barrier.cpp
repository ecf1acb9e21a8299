// The barrier delivers the queue in generations. Writes by handlers are queued for the next
// generation.

#include <exception>
#include <utility>

#include <change/generations.h>

#include "state.h"

namespace fettle::property {

bool Tree::listens(const Event& event) const {
    if (event.listeners == 0) return false;
    if (event.owner != nullptr) state_->instances.require_own(*event.owner);
    return true;
}

bool Tree::listens(Handle instance, const Event& event) const {
    if (!alive(instance)) return false;
    state_->instances.require_event(instance, event);
    return event.listeners != 0 &&
           !state_->changes.watchers.of_event(instance, event, state_->changes.watchers.last_id())
                .empty();
}

void Tree::emit(Handle instance, const Event& event, std::vector<Value> values) {
    State& s = *state_;
    s.instances.require_event(instance, event);
    s.instances.require_values(instance, event, values);
    s.require_changeable("emit an event");
    if (event.listeners == 0) return;
    s.changes.queue_item({.kind = QueueItem::Kind::event,
                          .what = Occurrence{.instance = instance,
                                             .event = &event,
                                             .record = {event.record_fields, std::move(values)},
                                             .step = s.changes.author.step}});
}

namespace {

/// While it lives, the queue is being delivered.
class Delivering {
  public:
    explicit Delivering(Changes& changes) : queue_(changes.queue), handlers_(changes.watchers) {
        queue_.delivering = true;
    }
    ~Delivering() {
        queue_.delivering = false;
        queue_.item = -1;
        queue_.part = 0;
    }
    Delivering(const Delivering&) = delete;

  private:
    Queue& queue_;
    Watchers::HandlersRun handlers_;
};

/// Queues the changes by formulas and by the simulation. False if the tree was destroyed meanwhile.
bool find_changes(Tree::State& s, bool stepped) {
    s.formulas.settle_all(stepped);
    s.formulas.report_problems();
    if (s.lifetime.ending) return false;
    s.changes.compare_shadows();
    return true;
}

void deliver_all(Tree::State& s, std::exception_ptr& first_error) {
    Queue& queue = s.changes.queue;
    s.changes.report_plain_writes();
    if (!find_changes(s, s.changes.stepped)) return;
    if (queue.items.empty()) return s.changes.forget_fresh();

    const Delivering delivering(s.changes);
    Generations generations;
    while (!queue.items.empty()) {
        if (generations.size() == max_generations) return refuse_overrun(s.changes, generations);
        std::vector<QueueItem>& batch = generations.emplace_back(s.changes.take_items());
        s.changes.forget_fresh(batch);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            queue.item = static_cast<std::ptrdiff_t>(i);
            s.changes.deliver(batch[i], first_error);
        }
        queue.item = -1;
        if (s.lifetime.ending || !find_changes(s, false)) return;
    }
}

void run_actions(Changes& changes, std::exception_ptr& first_error) {
    // Actions that are posted meanwhile wait for the next barrier.
    const std::vector<std::function<void()>> actions = std::exchange(changes.queue.actions, {});
    for (const auto& action : actions) {
        if (changes.lifetime.ending) return;
        try {
            action();
        } catch (...) {
            changes.errors.report(first_error, [] { return std::string("barrier"); });
        }
    }
}

}  // namespace

void Tree::at_barrier(std::function<void()> action) {
    require_changeable("order anything for the next barrier");
    if (!action) throw Error(ErrorKind::wrong_type, "at_barrier: a function is needed");
    state_->changes.queue.actions.push_back(std::move(action));
}

void Tree::barrier(bool between_steps) {
    State& s = *state_;
    if (s.changes.queue.delivering)
        throw Error(ErrorKind::bad_structure, "a handler cannot start a barrier: it runs in one");
    if (s.underway.restoring)
        throw Error(ErrorKind::bad_structure,
                    "no barrier can start while a snapshot is restored: wait until that has ended");
    const Use use(s.lifetime);
    s.require_changeable("start a barrier");
    std::exception_ptr first_error;
    const HandlerErrors::Collect collect(s.changes.errors, first_error);
    deliver_all(s, first_error);
    if (between_steps && !s.lifetime.ending && !s.changes.queue.actions.empty()) {
        run_actions(s.changes, first_error);
        if (!s.lifetime.ending) deliver_all(s, first_error);
    }
    if (first_error) std::rethrow_exception(first_error);
    use.finish();
}

void Tree::on_handler_error(std::function<void(const HandlerError&)> sink) {
    state_->changes.errors.sink = std::move(sink);
}

}  // namespace fettle::property
