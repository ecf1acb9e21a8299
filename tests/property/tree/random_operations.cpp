#include "random_operations.h"

#include <algorithm>
#include <ostream>

#include <fettle/property/error.h>

namespace fettle::property::testing {

namespace {

constexpr std::array<const char*, 5> names = {"mass", "radius", "charge", "lives", "score"};
constexpr std::array<const char*, 7> watched = {"mass",  "radius", "charge",  "lives",
                                                "score", "area",   "velocity"};
constexpr std::array<const char*, Operation::kinds> kind_names = {
    "create",  "destroy",  "move",       "set",      "set_formula", "clear", "read",
    "barrier", "simulate", "begin_edit", "end_edit", "undo",        "redo",  "watch",
    "stop",    "rename",   "explain",    "snapshot", "restore"};

double number_of(const Value& value) {
    return value.is(Type::vec2) ? value.vec2().y : value.as_double();
}

constexpr std::size_t max_instances = 12;

}  // namespace

std::ostream& operator<<(std::ostream& out, const Operation& operation) {
    out << "\n    {Operation::" << kind_names[operation.kind] << ", {";
    for (std::size_t i = 0; i < operation.numbers.size(); ++i)
        out << (i ? ", " : "") << operation.numbers[i];
    return out << "}}";
}

struct RandomRun::Watcher {
    int instance = 0;
    std::string property;
    Value known;  // the value that it got last
    int action = 0;
    int number = 0;
    int acts_left = 3;  // limited, because handlers could trigger each other without end
    Connection connection;
};

RandomRun::RandomRun(bool people) : people_(people) {
    tree_.on_handler_error([](const HandlerError& error) {
        throw Difference("a handler failed: " + error.path + ": " + error.message);
    });
}

RandomRun::~RandomRun() = default;

void RandomRun::check(bool holds, const std::string& what) const {
    if (!holds) throw Difference(what);
}

std::optional<int> RandomRun::pick(int number) const {
    const std::vector<int> alive = world_.alive();
    if (alive.empty()) return std::nullopt;
    return alive[static_cast<std::size_t>(number) % alive.size()];
}

bool RandomRun::present(int instance, const std::string& property) const {
    return world_.instances[static_cast<std::size_t>(instance)].values.contains(property);
}

// --- One operation on tree and model

void RandomRun::run(const Operation& operation) {
    run_alone(operation);
    check_lists();
}

// A list of children without end would block every loop over it.
void RandomRun::check_lists() const {
    const auto walk = [this](Handle parent) {
        std::size_t count = 0;
        for (Handle child = tree_.first_child(parent); child; child = tree_.next_sibling(child)) {
            check(tree_.alive(child) && tree_.parent(child) == parent, "a child of another");
            check(++count <= tree_.size(), "a list of children without an end");
        }
        check(count == tree_.child_count(parent), "children are counted wrongly");
    };
    walk(root_);
    for (const int instance : world_.alive())
        if (tree_.alive(handle(instance))) walk(handle(instance));
}

void RandomRun::run_alone(const Operation& operation) {
    const auto& [a, b, c, d] = operation.numbers;
    Tree::CauseScope scope(tree_, people_ ? Writer::console : Writer::script);
    const auto some = pick(a), other = pick(b);
    const std::string name = names[static_cast<std::size_t>(c) % names.size()];
    switch (operation.kind) {
        case Operation::create:
            return create("n" + std::to_string(world_.instances.size()));
        case Operation::barrier:
            return settle();
        case Operation::simulate:
            return simulate(a);
        case Operation::begin_edit:
        case Operation::end_edit:
            if (!people_ || in_edit_ == (operation.kind == Operation::begin_edit)) return;
            if (in_edit_) {
                tree_.end_edit();
                in_edit_ = false;
                if (wrote_) note(std::move(before_edit_));
            } else {
                tree_.begin_edit("edit");
                in_edit_ = true;
                wrote_ = false;
                before_edit_ = world_;
            }
            return;
        case Operation::undo:
        case Operation::redo:
            return step_in_history(operation.kind == Operation::undo);
        case Operation::snapshot:
            if (!in_edit_) kept_ = Kept{tree_.snapshot(), world_, done_, undone_};
            return;
        case Operation::restore:
            return restore();
        case Operation::stop:
            if (!watchers_.empty())
                watchers_[static_cast<std::size_t>(a) % watchers_.size()]->connection.stop();
            return;
        default:
            break;
    }
    if (!some) return;
    switch (operation.kind) {
        case Operation::destroy:
            return destroy(*some);
        case Operation::move:
            return move(*some, d % 3 == 0 ? -1 : *other);
        case Operation::set:
            return set(*some, name, d % 7 == 0 ? 13 : (d % 160) / 4.0 - 4);
        case Operation::set_formula: {
            // References may lead to deleted instances and to some that do not exist yet.
            Recipe recipe;
            recipe.kind = static_cast<Recipe::Kind>(d % Recipe::kinds);
            recipe.first = d / 7 % 5 == 0 ? b % static_cast<int>(world_.instances.size()) : *other;
            recipe.second = *pick(d / 3);
            recipe.first_name =
                d / 11 % 6 == 0 ? "speed" : names[static_cast<std::size_t>(d / 2) % 5];
            recipe.second_name = names[static_cast<std::size_t>(d / 5) % 5];
            recipe.by_path = d / 13 % 2 == 0;
            recipe.constant = d % 6;
            return set_formula(*some, name, recipe);
        }
        case Operation::clear:
            return clear(*some, name);
        case Operation::read:
            return check_cell(*some, name);
        case Operation::watch:
            return watch(*some, watched[static_cast<std::size_t>(c) % watched.size()], d % 8, b);
        case Operation::rename: {
            // A name that another instance has or had, so that paths may get another target.
            const std::string taken = "n" + std::to_string(b % static_cast<int>(handles_.size()));
            if (naive(*some).name == taken || tree_.child(tree_.parent(handle(*some)), taken))
                return;
            edit([&] {
                tree_.rename(handle(*some), taken);
                naive(*some).name = taken;
            });
            return;
        }
        case Operation::explain:
            return explain(*some, name);
        default:
            return;
    }
}

template <class Edit>
void RandomRun::edit(Edit edit) {
    NaiveWorld before = world_;
    edit();
    if (before == world_) return;
    if (in_edit_)
        wrote_ = true;
    else
        note(std::move(before));
}

void RandomRun::note(NaiveWorld before) {
    if (!people_) return;
    done_.push_back(std::move(before));
    undone_.clear();
}

void RandomRun::create(const std::string& name) {
    if (world_.alive().size() >= max_instances) return;
    edit([&] {
        const Handle made = tree_.create(*module_.type, root_, name);
        handles_.push_back(made);
        const int number = world_.create(tree_.name(made));
        check(number + 1 == static_cast<int>(handles_.size()), "instances are out of step");
    });
}

void RandomRun::destroy(int instance) {
    edit([&] {
        tree_.destroy(handle(instance));
        world_.destroy(instance);
    });
}

void RandomRun::move(int instance, int parent) {
    if (parent == naive(instance).parent || (parent >= 0 && world_.is_below(parent, instance)))
        return;
    const Handle to = parent < 0 ? root_ : handle(parent);
    if (tree_.child(to, naive(instance).name)) return;
    edit([&] {
        tree_.move(handle(instance), to);
        world_.move(instance, parent);
    });
}

void RandomRun::set(int instance, const std::string& property, double value) {
    edit([&] {
        std::string refused;
        try {
            tree_.set_or_add(handle(instance), property, value);
        } catch (const Error& error) {
            refused = error.what();
        }
        try {
            const double taken = NaiveWorld::coerced(property, value);
            check(refused.empty(), "refused though it is allowed: " + refused);
            naive(instance).values[property] = taken;
            naive(instance).formulas.erase(property);
        } catch (const InError&) {
            check(!refused.empty(), property + " took " + std::to_string(value));
        }
    });
}

void RandomRun::set_formula(int instance, const std::string& property, const Recipe& recipe) {
    const auto function = [this, recipe, instance, property](const Tree& tree) {
        ++runs_[{instance, property}];
        return Value(recipe([&](int from, const std::string& name) {
            const std::string read = name == "speed" ? "velocity" : name;
            if (recipe.by_path)
                return number_of(get(tree, "world.n" + std::to_string(from) + "." + read));
            return number_of(tree.get(handle(from), read));
        }));
    };
    edit([&] {
        tree_.set_formula(handle(instance), property, {function, "recipe"});
        naive(instance).values.try_emplace(property, 0.0);
        naive(instance).formulas[property] = recipe;
        if (in_edit_) wrote_ = true;
    });
}

void RandomRun::clear(int instance, const std::string& property) {
    edit([&] {
        if (NaiveWorld::declared(property)) {
            tree_.set(handle(instance), property, Value());
            naive(instance).values[property] = NaiveWorld::default_of(property);
        } else {
            tree_.remove_ad_hoc(handle(instance), property);
            naive(instance).values.erase(property);
        }
        naive(instance).formulas.erase(property);
    });
}

// The simulation writes into its memory without notifying the tree.
void RandomRun::simulate(int number) {
    settle();
    for (const int instance : world_.alive()) {
        number = (number * 31 + 7) % 10'000;
        if (number % 2 == 0) continue;
        const float speed = static_cast<float>(number % 9);
        module_.ball(handle(instance)).velocity[1] = speed;
        naive(instance).values["speed"] = static_cast<double>(speed);
    }
    tree_.set_step(++steps_);
    tree_.stepped();
    settle();
}

void RandomRun::step_in_history(bool back) {
    if (!people_ || in_edit_) return;
    auto& from = back ? done_ : undone_;
    const UndoResult result = back ? tree_.undo() : tree_.redo();
    check(result.done == !from.empty(), result.done ? "undid what was never done: " + result.name
                                                    : "there was something to undo");
    if (from.empty()) return;
    NaiveWorld then = std::move(from.back());
    from.pop_back();
    // Values written by the simulation since are not part of the edit: they stay, also for restored
    // instances.
    for (std::size_t i = 0; i < then.instances.size(); ++i)
        then.instances[i].values["speed"] = world_.instances[i].values["speed"];
    // Instances made since are deleted and remembered, because redo restores them.
    while (then.instances.size() < world_.instances.size()) {
        NaiveInstance gone = world_.instances[then.instances.size()];
        gone.alive = false;
        then.instances.push_back(std::move(gone));
    }
    (back ? undone_ : done_).push_back(world_);
    world_ = std::move(then);
}

// Restores everything, including the history; instances made since do not exist any more.
void RandomRun::restore() {
    if (!kept_ || in_edit_) return;
    settle();  // changes not yet reported would be lost
    tree_.restore(kept_->snapshot);
    NaiveWorld then = kept_->world;
    while (then.instances.size() < world_.instances.size()) {
        NaiveInstance gone = world_.instances[then.instances.size()];
        gone.alive = false;
        then.instances.push_back(std::move(gone));
    }
    world_ = std::move(then);
    done_ = kept_->done;
    undone_ = kept_->undone;
    settle();
}

// --- Watchers

void RandomRun::watch(int instance, const std::string& property, int action, int number) {
    if (watchers_.size() > 40 || !tree_.find(handle(instance), property)) return;
    settle();  // so that its first value is the current one
    if (!tree_.alive(handle(instance)) || !tree_.find(handle(instance), property)) return;
    auto made = std::make_unique<Watcher>();
    Watcher& watcher = *made;
    watcher.instance = instance;
    watcher.property = property;
    watcher.action = action;
    watcher.number = number;
    watcher.known = tree_.peek(handle(instance), tree_.property(handle(instance), property));
    watcher.connection = tree_.watch(handle(instance), property,
                                     [this, &watcher](const Change& c) { reported(watcher, c); });
    watchers_.push_back(std::move(made));
}

void RandomRun::reported(Watcher& watcher, const Change& change) {
    const std::string cell = "n" + std::to_string(watcher.instance) + "." + watcher.property;
    check(in_barrier_, "notified of " + cell + " outside of a barrier");
    check(change.instance == handle(watcher.instance),
          "notified of a change of another cell than " + cell);
    check(change.old_value == watcher.known, "notified that " + cell + " was " +
                                                 value_text(change.old_value) + ", knew " +
                                                 value_text(watcher.known));
    check(!(change.new_value == change.old_value), "notified of " + cell + " without a change");
    watcher.known = change.new_value;
    act(watcher);
}

void RandomRun::act(Watcher& watcher) {
    if (watcher.acts_left-- <= 0) return;
    Tree::CauseScope scope(tree_, Writer::script);
    const auto target = pick(watcher.number);
    const int action = people_ ? watcher.action % 3 : watcher.action;
    if (action > 2) handlers_wrote_ = true;
    switch (action) {
        case 1:
            return watcher.connection.stop();
        case 2:
            return watchers_[static_cast<std::size_t>(watcher.number) % watchers_.size()]
                ->connection.stop();
        case 3:
            if (target) set(*target, names[static_cast<std::size_t>(watcher.number) % 5], 3);
            return;
        case 4:
            if (target) destroy(*target);
            return;
        case 5:
            return create("h" + std::to_string(world_.instances.size()));
        case 6:
            if (target) clear(*target, names[static_cast<std::size_t>(watcher.number) % 5]);
            return;
        case 7:
            if (target) move(*target, -1);
            return;
        default:
            return;
    }
}

// --- Comparing

void RandomRun::settle() {
    runs_.clear();
    in_barrier_ = true;
    handlers_wrote_ = false;
    tree_.barrier();
    in_barrier_ = false;
    // No formula is computed twice, unless handlers wrote in between, even if one undid the write
    // of another. Only connected cycles need a few rounds until all of them have the same error.
    const auto runs = runs_;
    if (!handlers_wrote_)
        for (const auto& [cell, count] : runs) {
            const Handle of = handle(cell.first);
            const bool in_error = !tree_.problem(of, tree_.property(of, cell.second)).empty();
            check(count <= (in_error ? 8 : 1), "n" + std::to_string(cell.first) + "." +
                                                   cell.second + " was computed " +
                                                   std::to_string(count) + " times in one barrier" +
                                                   (in_error ? ", in error" : ""));
        }
    check_everything();
}

void RandomRun::check_cell(int instance, const std::string& property) {
    const std::string cell = "n" + std::to_string(instance) + "." + property;
    const Handle of = handle(instance);
    const Property* found = tree_.find(of, property);
    check((found != nullptr) == present(instance, property), cell + " is there or is not");
    if (found == nullptr) return;
    std::optional<double> expected;
    try {
        expected = world_.read(instance, property);
    } catch (const std::exception&) {
        // empty: the cell is in error
    }
    std::optional<double> got;
    std::string problem;
    try {
        got = number_of(tree_.get(of, *found));
    } catch (const Error& error) {
        problem = error.what();
    }
    const auto shown = [](const std::optional<double>& value) {
        return value ? std::to_string(*value) : std::string("in error");
    };
    check(got == expected,
          cell + " is " + shown(got) + ", expected " + shown(expected) + " " + problem);
    check(tree_.problem(of, *found).empty() == expected.has_value(), cell + ": problem disagrees");
    check((tree_.formula(of, *found) != nullptr) ==
              world_.instances[static_cast<std::size_t>(instance)].formulas.contains(property),
          cell + ": formula or not");
    if (expected)
        check(number_of(tree_.peek(of, *found)) == *expected, cell + ": memory is behind");
}

void RandomRun::explain(int instance, const std::string& property) {
    if (!present(instance, property)) return;
    const Handle of = handle(instance);
    const Explanation why = tree_.why(of, tree_.property(of, property));
    bool in_error = false;
    try {
        (void)world_.read(instance, property);
    } catch (const std::exception&) {
        in_error = true;
    }
    check(why.problem.empty() != in_error, why.path + ": why disagrees about the error");
    const bool formula = naive(instance).formulas.contains(property);
    check(why.source == (formula ? "recipe" : ""), why.path + ": why names no source");
    check(formula || why.from.empty(), why.path + ": a plain value comes from nowhere");
}

void RandomRun::check_everything() {
    std::size_t formulas = 0;
    for (std::size_t i = 0; i < world_.instances.size(); ++i) {
        const int number = static_cast<int>(i);
        const NaiveInstance& instance = world_.instances[i];
        check(tree_.alive(handles_[i]) == instance.alive,
              "n" + std::to_string(i) + (instance.alive ? " is dead" : " is alive"));
        if (!instance.alive) continue;
        formulas += instance.formulas.size();
        check(tree_.name(handles_[i]) == instance.name,
              "n" + std::to_string(i) + " is called " + tree_.name(handles_[i]));
        std::vector<Handle> children;
        for (const int child : instance.children) children.push_back(handle(child));
        check(tree_.children(handles_[i]) == children, "children of n" + std::to_string(i));
        for (const char* name : names) check_cell(number, name);
        check(module_.ball(handles_[i]).velocity[1] ==
                  static_cast<float>(instance.values.at("speed")),
              "speed of n" + std::to_string(i));
    }
    std::vector<Handle> children;
    for (const int child : world_.top) children.push_back(handle(child));
    check(tree_.children(root_) == children, "children of the world");
    check(tree_.formula_count() == formulas, "the number of formulas");
    for (const auto& watcher : watchers_) {
        if (!watcher->connection.active()) continue;
        const Handle of = handle(watcher->instance);
        check(tree_.alive(of), "a watcher outlived what it watches");
        const Property* property = tree_.find(of, watcher->property);
        const Value now = property != nullptr ? tree_.peek(of, *property) : Value();
        check(now == watcher->known, "no notification that n" + std::to_string(watcher->instance) +
                                         "." + watcher->property + " is " + value_text(now) +
                                         ", not " + value_text(watcher->known));
    }
}

}  // namespace fettle::property::testing
