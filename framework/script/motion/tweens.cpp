#include <algorithm>
#include <cmath>
#include <exception>

#include <fettle/property/last_value.h>
#include <fettle/property/spelling.h>

#include <calls/protected.h>
#include <lua/machine.h>
#include <motion/ease.h>
#include <motion/interpolation.h>
#include <motion/tweens.h>
#include <writes/degree_notes.h>

namespace fettle::script {

using property::Tree;

namespace {

// Sums of steps have rounding errors, so a tween this near its end has reached it.
constexpr double tolerance = 1e-9;
constexpr std::size_t most_deleted_targets = 256;

std::pair<std::uint64_t, std::string> moved_by(const Tree& tree, const TweenClasses& classes,
                                               Handle tween) {
    return {last_value(tree, tween, classes.tween.target).reference().key(),
            last_value(tree, tween, classes.tween.property).text()};
}

std::function<std::string()>& where() {
    static std::function<std::string()> text = [] { return std::string("tween"); };
    return text;
}

}  // namespace

Tweens::Tweens(Machine& machine)
    : machine_(machine), classes_(define_tween_classes(machine.tree)) {}

// --- Making

Handle Tweens::holder() {
    Tree& tree = machine_.tree;
    if (const Handle known = tree.child(tree.root(), tweens_name)) {
        if (&tree.class_of(known) == &classes_.holder) return known;
        throw Error(ErrorKind::bad_name, std::string("tween: tweens are below game.") +
                                             tweens_name + ", but that is " +
                                             property::with_article(tree.class_of(known).name()) +
                                             " of the game; give it another name");
    }
    return tree.create(classes_.holder, tree.root(), tweens_name);
}

std::vector<Handle> Tweens::all() const {
    const Tree& tree = machine_.tree;
    const Handle known = tree.child(tree.root(), tweens_name);
    return known && &tree.class_of(known) == &classes_.holder ? tree.children(known)
                                                              : std::vector<Handle>();
}

Handle Tweens::make(const Class& of) {
    const Handle parent = holder();
    return machine_.tree.create(of, parent);
}

Value Tweens::require_possible(Handle target, const std::string& name, const Value& from,
                               const Value& to, const std::string& who) const {
    const Tree& tree = machine_.tree;
    const Property& property = tree.property(target, name);
    const auto refuse = [&](ErrorKind kind, const std::string& why) {
        throw Error(kind, who + ": " + tree.path(target, property) + why);
    };
    if (property.read_only) refuse(ErrorKind::read_only, " is read-only");
    if (tree.formula(target, property) != nullptr)
        refuse(ErrorKind::formula,
               " has a formula, which computes its value; assign a plain value first");
    const Value begin =
        from.is_nil() ? tree.get(target, property) : tree.coerce(target, property, from);
    Value end = tree.coerce(target, property, to);
    if (begin.is_nil())
        refuse(ErrorKind::wrong_type, " is nil; assign the value at which the tween begins first");
    if (!mixable(begin, end))
        refuse(ErrorKind::wrong_type,
               ": there are no values between " + tree.text(begin) + " and " + tree.text(end));
    return end;
}

void Tweens::require_valid(Handle made) const {
    const Tree& tree = machine_.tree;
    if (!tree.class_of(made).is_a(classes_.tween.of)) return;
    const std::string name = last_value(tree, made, classes_.tween.property).text();
    const Handle target = last_value(tree, made, classes_.tween.target).reference();
    const Value to = last_value(tree, made, classes_.tween.to);
    // What is missing may be assigned later.
    if (name.empty() || !tree.alive(target)) return;
    if (to.is_nil())
        (void)tree.property(target, name);
    else
        (void)require_possible(target, name, last_value(tree, made, classes_.tween.from), to,
                               tree.class_of(made).name());
}

/// The end of a tween. A property that was added to its instance has any type, so a text may name a
/// color only if its value is one.
Value Tweens::end_of(const Plan& plan) const {
    const Tree& tree = machine_.tree;
    property::Color named;
    if (plan.to.is(property::Type::text) && property::parse_color(plan.to.text(), named) &&
        tree.get(plan.target, tree.property(plan.target, plan.property)).is(property::Type::color))
        return Value(named);
    return plan.to;
}

Handle Tweens::add(const Plan& plan) {
    Tree& tree = machine_.tree;
    const Value to = require_possible(plan.target, plan.property, {}, end_of(plan), "tween");
    if (to.is_numeric())
        note_degrees(machine_, plan.target, tree.property(plan.target, plan.property),
                     to.as_double());
    const Handle made = make(classes_.tween.of);
    tree.set(made, classes_.tween.target, plan.target);
    tree.set(made, classes_.tween.property, plan.property);
    tree.set(made, classes_.tween.to, to);
    tree.set(made, classes_.tween.seconds, plan.seconds);
    tree.set(made, classes_.tween.ease, plan.ease);
    tree.set(made, classes_.tween.curve, plan.curve);
    return made;
}

Handle Tweens::add_pause(double seconds) {
    const Handle made = make(classes_.tween.of);
    machine_.tree.set(made, classes_.tween.seconds, seconds);
    return made;
}

bool Tweens::groupable(Handle each) const {
    const Tree& tree = machine_.tree;
    if (!tree.alive(each)) return false;
    const Class& of = tree.class_of(each);
    if (!of.is_a(classes_.tween.of) && !of.is_a(classes_.group.of)) return false;
    const Handle parent = tree.parent(each);
    return parent && &tree.class_of(parent) == &classes_.holder;
}

namespace {

int levels_below(const Tree& tree, Handle each, int depth) {
    int most = 0;
    if (depth > deepest_tweens) return most;
    for (const Handle child : tree.children(each))
        most = std::max(most, 1 + levels_below(tree, child, depth + 1));
    return most;
}

}  // namespace

Handle Tweens::add_group(const char* kind, const std::vector<Handle>& members) {
    Tree& tree = machine_.tree;
    for (const Handle member : members)
        if (levels_below(tree, member, 0) + 1 >= deepest_tweens)
            throw Error(ErrorKind::out_of_range, std::string("tween.") + kind +
                                                     ": groups within groups may be " +
                                                     std::to_string(deepest_tweens) + " deep");
    const Handle made = make(classes_.group.of);
    tree.set(made, classes_.group.kind, kind);
    for (const Handle member : members) tree.move(member, made);
    return made;
}

void Tweens::note_deleted(Handle target) {
    if (std::ranges::find(deleted_targets_, target) != deleted_targets_.end()) return;
    deleted_targets_.push_back(target);
    if (deleted_targets_.size() > most_deleted_targets) deleted_targets_.pop_front();
}

std::vector<Handle> Tweens::deleted_targets() {
    // Going back in time brings back an instance with its tweens.
    std::erase_if(deleted_targets_, [&](Handle each) { return machine_.tree.alive(each); });
    return {deleted_targets_.begin(), deleted_targets_.end()};
}

// --- Running

bool Tweens::over(Handle each) const {
    const Tree& tree = machine_.tree;
    const bool tween = tree.class_of(each).is_a(classes_.tween.of);
    return last_value(tree, each, tween ? classes_.tween.over : classes_.group.over).boolean();
}

/// What a game adds below `game.tweens` besides tweens is left alone.
bool Tweens::running(Handle each) const {
    const Tree& tree = machine_.tree;
    if (!tree.alive(each)) return false;
    const Class& of = tree.class_of(each);
    return of.is_a(classes_.tween.of) || of.is_a(classes_.group.of);
}

bool Tweens::pauses(Handle each) const {
    const Tree& tree = machine_.tree;
    const bool tween = tree.class_of(each).is_a(classes_.tween.of);
    return last_value(tree, each, tween ? classes_.tween.pauses : classes_.group.pauses).boolean();
}

/// `pausing`: those that pause with the game, else those in real time.
bool Tweens::run_those(double dt, bool pausing) {
    Tree& tree = machine_.tree;
    const Handle all = tree.child(tree.root(), tweens_name);
    if (!all || &tree.class_of(all) != &classes_.holder) return true;
    ok_ = true;
    begun_.reset();
    const Tree::CauseScope cause(tree, property::Writer::script, &where());
    for (const Handle each : tree.children(all)) {
        if (!running(each) || pauses(each) != pausing) continue;
        if (over(each))
            tree.destroy(each);
        else
            advance(each, dt, 0);
    }
    return ok_;
}

/// Deletes a tween that cannot continue. `why` is reported as an error unless it is empty.
void Tweens::end(Handle each, std::string_view why) {
    Tree& tree = machine_.tree;
    if (!why.empty())
        ok_ &= protected_run(machine_, Context("tween"), [&](lua_State*) {
            throw Error(ErrorKind::rejected,
                        tree.path(each) + " ends, since it fails: " + std::string(why));
        });
    if (tree.alive(each)) tree.destroy(each);
}

/// The part of `dt` that is left after its end; nothing if it goes on.
std::optional<double> Tweens::advance(Handle each, double dt, int depth) {
    if (machine_.tree.class_of(each).is_a(classes_.group.of)) return advance_group(each, dt, depth);
    try {
        return advance_tween(each, dt);
    } catch (const std::exception& error) {
        end(each, error.what());
        return dt;
    }
}

std::optional<double> Tweens::advance_group(Handle group, double dt, int depth) {
    constexpr int most_runs = 64;  // in a step
    Tree& tree = machine_.tree;
    if (depth >= deepest_tweens) return std::nullopt;
    if (last_value(tree, group, classes_.group.paused).boolean()) return std::nullopt;
    for (int run = 0; run < most_runs; ++run) {
        const std::optional<double> left = advance_run(group, dt, depth);
        if (!left) return std::nullopt;
        const std::int64_t loops = last_value(tree, group, classes_.group.loops).integer();
        const std::int64_t turn = last_value(tree, group, classes_.group.turn).integer() + 1;
        const std::vector<Handle> members = tree.children(group);
        const bool empty =
            std::ranges::none_of(members, [this](Handle member) { return running(member); });
        if (empty || (loops > 0 && turn >= loops)) {
            finish(group);
            return left;
        }
        tree.set(group, classes_.group.turn, turn);
        begin_run(group, depth);
        // One that takes no time makes one run a step.
        if (*left <= tolerance || *left >= dt) return std::nullopt;
        dt = *left;
    }
    return std::nullopt;
}

/// One run of the members, or what is left of it.
std::optional<double> Tweens::advance_run(Handle group, double dt, int depth) {
    Tree& tree = machine_.tree;
    const bool together = last_value(tree, group, classes_.group.kind).text() == in_parallel;
    const bool back = goes_back(group);
    std::vector<Handle> members = tree.children(group);
    if (back && !together) std::ranges::reverse(members);
    const double begun = together ? last_value(tree, group, classes_.group.run_time).number() : 0;
    const double length = together && back ? seconds_of_run(tree, group) : 0;
    double left = dt;
    bool all_over = true;
    for (const Handle member : members) {
        if (!running(member) || over(member)) continue;
        double given = together ? dt : left;
        if (together && back) {  // all end together: the beginning of the run that is gone back
            given = std::min(dt, begun + dt - (length - seconds_of(tree, member)));
            if (given <= tolerance) {
                all_over = false;
                continue;
            }
        }
        const std::optional<double> rest = advance(member, given, depth + 1);
        if (!rest && !together) return std::nullopt;
        all_over &= rest.has_value();
        if (rest) left = std::min(left, *rest);
    }
    if (together && tree.alive(group)) tree.set(group, classes_.group.run_time, begun + dt);
    return all_over ? std::optional(left) : std::nullopt;
}

/// Whether the members of the group run backwards now.
bool Tweens::goes_back(Handle group) const {
    const Tree& tree = machine_.tree;
    const bool reversed = last_value(tree, group, classes_.group.reversed).boolean();
    std::int64_t turn = last_value(tree, group, classes_.group.turn).integer();
    if (reversed)
        turn = std::max<std::int64_t>(1, last_value(tree, group, classes_.group.loops).integer()) -
               1 - turn;
    const bool back = last_value(tree, group, classes_.group.alternate).boolean() && turn % 2 != 0;
    return back != reversed;
}

/// Everything in the group begins again, with the values of its first run.
void Tweens::begin_run(Handle group, int depth) {
    Tree& tree = machine_.tree;
    if (depth > deepest_tweens) return;
    const bool back = goes_back(group);
    tree.set(group, classes_.group.run_time, 0.0);
    for (const Handle member : tree.children(group)) {
        if (!running(member)) continue;
        if (tree.class_of(member).is_a(classes_.group.of)) {
            tree.set(member, classes_.group.turn, 0);
            tree.set(member, classes_.group.reversed, back);
            tree.set(member, classes_.group.over, false);
            begin_run(member, depth + 1);
            continue;
        }
        tree.set(member, classes_.tween.turn, 0);
        tree.set(member, classes_.tween.progress, 0.0);
        tree.set(member, classes_.tween.shown, -1.0);
        tree.set(member, classes_.tween.reversed, back);
        tree.set(member, classes_.tween.over, false);
    }
}

std::optional<double> Tweens::advance_tween(Handle tween, double dt) {
    Tree& tree = machine_.tree;
    const bool moves = !last_value(tree, tween, classes_.tween.property).text().empty();
    const Handle moved = last_value(tree, tween, classes_.tween.target).reference();
    if (moves && !tree.alive(moved)) {
        note_deleted(moved);
        tree.destroy(tween);
        return dt;
    }
    const double shown = last_value(tree, tween, classes_.tween.shown).number();
    if (last_value(tree, tween, classes_.tween.paused).boolean()) {
        // A progress that was set meanwhile is shown.
        if (moves && shown >= 0 &&
            shown != last_value(tree, tween, classes_.tween.progress).number())
            show(tween);
        return std::nullopt;
    }
    if (moves && shown < 0 && !begin(tween)) return dt;
    const std::optional<double> left = pass_time(tween, dt);
    if (moves) {
        const Handle target = last_value(tree, tween, classes_.tween.target).reference();
        const Property& property =
            tree.property(target, last_value(tree, tween, classes_.tween.property).text());
        if (tree.formula(target, property) != nullptr) {  // it was given later, so it wins
            tree.destroy(tween);
            return dt;
        }
        show(tween);
    } else {
        tree.set(tween, classes_.tween.shown, 0.0);
    }
    if (left) finish(tween);
    return left;
}

/// Moves the progress on, and begins the next run where one ends.
std::optional<double> Tweens::pass_time(Handle tween, double dt) {
    Tree& tree = machine_.tree;
    const double seconds = last_value(tree, tween, classes_.tween.seconds).number();
    const std::int64_t loops = last_value(tree, tween, classes_.tween.loops).integer();
    std::int64_t turn = last_value(tree, tween, classes_.tween.turn).integer();
    double progress = last_value(tree, tween, classes_.tween.progress).number();
    // Without a duration, an endless tween makes one run a step.
    progress = seconds > 0 ? progress + dt / seconds : progress + 1;
    std::optional<double> left;
    if (progress >= 1 - tolerance) {
        double runs = std::floor(progress + tolerance);
        const auto wanted = static_cast<double>(loops);
        if (loops > 0 && static_cast<double>(turn) + runs >= wanted) {
            runs = std::max(wanted - static_cast<double>(turn), 1.0);
            left = seconds > 0 ? std::max(0.0, (progress - runs) * seconds) : dt;
            progress = 1;
            turn += static_cast<std::int64_t>(runs) - 1;
        } else {
            progress = std::clamp(progress - runs, 0.0, 1.0);
            turn += static_cast<std::int64_t>(std::min(runs, 1e15));
        }
        tree.set(tween, classes_.tween.turn, turn);
    }
    tree.set(tween, classes_.tween.progress, progress);
    return left;
}

/// The beginning: notes the value of the property, and ends other tweens of it. False if the tween
/// has ended.
bool Tweens::begin(Handle tween) {
    Tree& tree = machine_.tree;
    const Handle target = last_value(tree, tween, classes_.tween.target).reference();
    const std::string name = last_value(tree, tween, classes_.tween.property).text();
    const Property& property = tree.property(target, name);
    if (tree.formula(target, property) != nullptr) {  // it was given later, so it wins
        tree.destroy(tween);
        return false;
    }
    stop_others(tween, target, name);
    if (last_value(tree, tween, classes_.tween.from).is_nil())
        tree.set(tween, classes_.tween.from, tree.get(target, property));
    return true;
}

void Tweens::note_begun(Handle within, int depth) {
    const Tree& tree = machine_.tree;
    if (depth > deepest_tweens) return;
    for (const Handle each : tree.children(within)) {
        if (!running(each)) continue;
        if (tree.class_of(each).is_a(classes_.group.of))
            note_begun(each, depth + 1);
        else if (last_value(tree, each, classes_.tween.shown).number() >= 0)
            (*begun_)[moved_by(tree, classes_, each)].push_back(each);
    }
}

/// Deletes the tweens of that property that have begun and not ended.
void Tweens::stop_others(Handle tween, Handle target, const std::string& name) {
    Tree& tree = machine_.tree;
    if (!begun_) {
        begun_.emplace();
        note_begun(tree.child(tree.root(), tweens_name), 0);
    }
    std::vector<Handle>& others = (*begun_)[{target.key(), name}];
    for (const Handle other : others)
        if (other != tween && running(other) && !over(other)) tree.destroy(other);
    others = {tween};
}

/// Writes the value at the current progress to the property.
void Tweens::show(Handle tween) {
    Tree& tree = machine_.tree;
    const Handle target = last_value(tree, tween, classes_.tween.target).reference();
    const Property& property =
        tree.property(target, last_value(tree, tween, classes_.tween.property).text());
    const Value from = last_value(tree, tween, classes_.tween.from),
                to = last_value(tree, tween, classes_.tween.to);
    if (!mixable(from, to))
        throw Error(ErrorKind::wrong_type,
                    "there are no values between " + tree.text(from) + " and " + tree.text(to));
    const double progress = last_value(tree, tween, classes_.tween.progress).number();
    const bool reversed = last_value(tree, tween, classes_.tween.reversed).boolean();
    std::int64_t turn = last_value(tree, tween, classes_.tween.turn).integer();
    if (reversed)
        turn = std::max<std::int64_t>(1, last_value(tree, tween, classes_.tween.loops).integer()) -
               1 - turn;
    const bool back = last_value(tree, tween, classes_.tween.alternate).boolean() && turn % 2 != 0;
    const double time = back != reversed ? 1 - progress : progress;
    const std::string kind = last_value(tree, tween, classes_.tween.ease).text();
    const double part = kind == "curve"
                            ? ease(last_value(tree, tween, classes_.tween.curve).list(), time)
                            : ease(kind, time);
    tree.set(target, property, mix(from, to, part, property));
    tree.set(tween, classes_.tween.shown, progress);
}

void Tweens::finish(Handle each) {
    Tree& tree = machine_.tree;
    const bool tween = tree.class_of(each).is_a(classes_.tween.of);
    tree.set(each, tween ? classes_.tween.over : classes_.group.over, true);
    const property::Event& event = tween ? classes_.tween.finished : classes_.group.finished;
    if (tree.listens(each, event)) tree.emit(each, event, {});
}

}  // namespace fettle::script
