// The list of tweaks in random sessions with rewinds, branches, undo, keeps and drops, compared
// with a model. FETTLE_THOROUGH: 200 sessions in place of 40.

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "catch.h"
#include "thorough.h"
#include "tweaked.h"

namespace tweaks_model_test {

using namespace tweaked;

namespace {

/// The rule in its simplest form: everything that is known at a moment is copied for each moment.
struct Model {
    struct Change {
        std::string cell;
        double before, after;
    };
    struct State {
        std::map<std::string, double> values;
        std::map<std::string, int> last;       // the number of the last change of each cell
        std::map<std::string, double> edited;  // by that change
        std::vector<Change> done, undone;
        std::set<std::string> made, unmade;  // unmade: those whose making is undone
        bool operator==(const State&) const = delete;
    };
    struct Branch {
        std::map<std::int64_t, State> after;  // by step
        std::optional<State> tail;            // edited after the newest step
    };

    State now;
    std::int64_t here = 0;
    int changes = 0;
    // Listed edits of cells that `now` has no edit of: numbers and values.
    std::map<std::string, int> left_last;
    std::map<std::string, double> left_edited;
    std::set<std::string> left_made;
    std::string name = "1";
    std::map<std::string, Branch> branches;
    std::map<std::string, double> in_file;
    std::map<std::string, int> kept, dropped;

    std::int64_t newest() { return branches[name].after.rbegin()->first; }
    void change(const std::string& cell, double value) {
        now.values[cell] = now.edited[cell] = value;
        now.last[cell] = ++changes;
        forget(cell);
    }
    static double was(const State& state, const std::string& cell) {
        const auto found = state.values.find(cell);
        return found == state.values.end() ? 1 : found->second;
    }
    /// Cells without an edit in the new state keep the one that was listed.
    void become(const State& state) {
        const State before = std::exchange(now, state);
        for (const auto& [cell, last] : before.last) {
            left_last[cell] = last;
            left_edited[cell] = before.edited.at(cell);
        }
        for (const auto& [cell, last] : now.last) forget(cell);
        left_made.insert(before.made.begin(), before.made.end());
        for (const auto* known : {&now.made, &now.unmade})
            for (const std::string& instance : *known) left_made.erase(instance);
    }
    void forget(const std::string& cell) {
        left_last.erase(cell);
        left_edited.erase(cell);
    }
    void leave() {
        if (here == newest()) branches[name].tail = now;
    }
    void go_to(std::int64_t step) {
        leave();
        Branch& branch = branches[name];
        become(step == newest() && branch.tail ? *branch.tail : branch.after[step]);
        here = step;
    }
    /// `branch`: the name of the branch after the step.
    void stepped(std::int64_t step, const std::string& branch) {
        if (branch != name) {
            branches[branch] = {branches[name].after, {}};
            auto& after = branches[branch].after;
            after.erase(after.upper_bound(here), after.end());
            name = branch;
        }
        branches[name].after[step] = now;
        branches[name].tail.reset();
        here = step;
    }
    bool is_open(const std::string& cell, int last) const {
        const auto at = [&](const std::map<std::string, int>& of) {
            const auto found = of.find(cell);
            return found == of.end() ? 0 : found->second;
        };
        return last != at(kept) && last > at(dropped);
    }
    double listed(const std::string& cell) const {
        const auto found = now.edited.find(cell);
        return found == now.edited.end() ? left_edited.at(cell) : found->second;
    }
    int number(const std::string& cell) const {
        const auto found = now.last.find(cell);
        return found == now.last.end() ? left_last.at(cell) : found->second;
    }
    Lines open() const {
        Lines all;
        std::map<std::string, int> edits = now.last;
        edits.insert(left_last.begin(), left_last.end());
        for (const auto& [cell, last] : edits) {
            const auto file = in_file.find(cell);
            const double value = listed(cell);
            if (value != (file == in_file.end() ? 1 : file->second) && is_open(cell, last))
                all.push_back(cell + " " + std::to_string(static_cast<int>(value)));
        }
        for (const auto* made : {&now.made, &left_made})
            for (const std::string& instance : *made) all.push_back(instance + " made");
        std::sort(all.begin(), all.end());
        return all;
    }
};

struct Session : Tweaked {
    Model model;
    std::mt19937 random;
    struct Copy {
        property::Snapshot snapshot;
        Model::State state;
        std::int64_t step;
    };
    std::vector<Copy> copies;
    int instances = 0;

    explicit Session(unsigned seed) : random(seed) {
        tree.set_history_limit(std::size_t{64} << 20);
        run(1);
        for (std::int64_t step = time().oldest(); step <= services.clock.step; ++step)
            model.branches["1"].after[step] = {};
        model.here = services.clock.step;
    }
    std::size_t below(std::size_t count) { return random() % count; }
    std::string some_cell() { return std::string("world.") + "abc"[below(3)] + ".gravity_scale"; }
    Lines open() {
        barrier();
        Lines all;
        for (const Tweak& each : tweaks.list())
            if (!each.kept)
                all.push_back(each.path + " " + (each.value ? each.now : std::string("made")));
        std::sort(all.begin(), all.end());
        return all;
    }
    std::string act();
    void undo(bool back);
    void restore();
    std::string go();
};

void Session::undo(bool back) {
    const bool done = (back ? tree.undo() : tree.redo()).done;
    std::vector<Model::Change>& from = back ? model.now.done : model.now.undone;
    REQUIRE(done == !from.empty());
    if (!done) return;
    const Model::Change change = from.back();
    from.pop_back();
    (back ? model.now.undone : model.now.done).push_back(change);
    if (change.cell.find(".gravity") != std::string::npos) {
        model.change(change.cell, back ? change.before : change.after);
    } else {
        (back ? model.now.made : model.now.unmade).erase(change.cell);
        (back ? model.now.unmade : model.now.made).insert(change.cell);
        model.left_made.erase(change.cell);
    }
}

void Session::restore() {
    const Copy& copy = copies[below(copies.size())];
    const std::int64_t oldest = time().oldest(), newest = time().newest();
    tree.restore(copy.snapshot);
    time().go_near(copy.step);  // the timeline notices the restored state now
    Model::Branch& branch = model.branches[model.name];
    if (copy.step < oldest || copy.step > newest) {
        model.branches.clear();
    } else {
        branch.after.erase(branch.after.lower_bound(copy.step), branch.after.end());
        branch.tail.reset();
    }
    model.become(copy.state);
    model.here = copy.step;
    model.branches[model.name].after[copy.step] = model.now;
}

std::string Session::go() {
    if (const auto others = time().branches(); !others.empty() && below(3) == 0) {
        const std::string to = others[below(others.size())].name;
        model.leave();
        time().switch_to(to);
        model.name = to;
        model.here = -1;
        model.go_to(model.newest());
        return "switch to " + to;
    }
    const std::int64_t oldest = time().oldest();
    const std::int64_t step =
        oldest +
        static_cast<std::int64_t>(below(static_cast<std::size_t>(time().newest() - oldest + 1)));
    time().go_to(step);
    model.go_to(step);
    return "go to " + std::to_string(step);
}

std::string Session::act() {
    switch (below(12)) {
        case 0:
        case 1:
        case 2: {
            const std::string cell = some_cell();
            const double value = 1 + static_cast<double>(below(4));
            const double before = Model::was(model.now, cell);
            if (value == before) return "nothing";
            edit(cell, value);
            model.now.done.push_back({cell, before, value});
            model.now.undone.clear();
            model.change(cell, value);
            return cell + " = " + std::to_string(value);
        }
        case 3: {
            const std::string name = "made" + std::to_string(++instances);
            person([&] { make(name); });
            model.now.done.push_back({"world." + name, 0, 0});
            model.now.undone.clear();
            model.now.made.insert("world." + name);
            return "make " + name;
        }
        case 4:
            undo(true);
            return "undo";
        case 5:
            undo(false);
            return "redo";
        case 6:
        case 7:
            for (std::size_t n = 1 + below(5); n > 0; --n) {
                loop->turn();
                model.stepped(services.clock.step, services.clock.branch);
            }
            return "steps to " + std::to_string(services.clock.step);
        case 8: {
            const std::string cell = some_cell();
            const std::size_t count = tweaks.keep(cell).count;
            const Lines open = model.open();
            const bool listed = std::any_of(open.begin(), open.end(), [&](const std::string& line) {
                return line.starts_with(cell);
            });
            REQUIRE(count == listed);
            if (listed) {
                model.in_file[cell] = model.listed(cell);
                model.kept[cell] = model.number(cell);
            }
            return "keep " + cell;
        }
        case 9: {
            const std::string cell = some_cell();
            const bool listed = tweaks.drop(cell).count > 0;
            if (listed) model.dropped[cell] = model.changes;
            return "drop " + cell;
        }
        case 10:
            if (copies.size() < 4 || below(3) == 0)
                copies.push_back({tree.snapshot(), model.now, services.clock.step});
            else
                restore();
            return "copy or restore at " + std::to_string(services.clock.step);
        default:
            return go();
    }
}

}  // namespace

TEST_CASE("at every moment of random sessions the list has the edits that hold or that were left") {
    const unsigned seeds = thorough() ? 200 : 20;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Session session(seed);
        std::string done;
        for (int i = 0; i < 120; ++i) {
            done += session.act() + "\n";
            CAPTURE(seed, done);
            for (const auto& [cell, value] : session.model.now.values)
                REQUIRE(session.get(cell) == Value(value));
            REQUIRE(session.open() == session.model.open());
        }
        REQUIRE(session.errors.empty());
        REQUIRE(session.warnings.empty());
    }
}

}  // namespace tweaks_model_test
