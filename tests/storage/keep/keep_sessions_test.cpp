// Random sessions: a person edits, undoes, redoes and keeps in several runs of a game, whose
// instances are made partly by a scene file and partly by a script. If everything was kept, the
// next run begins with the last state of the run before; if nothing was kept, making the tweaks
// again gives that state.

#include <cstdlib>
#include <map>
#include <numeric>
#include <random>

#include <fettle/property/path.h>

#include "catch.h"
#include "game_folder.h"
#include "thorough.h"
#include "tweak_run.h"

namespace keep_sessions_test {

using namespace scene_test;

namespace {

const char* const level =
    "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", \"children\": [\n"
    "  {\"class\": \"Note\", \"name\": \"d\", \"properties\": {\"text\": \"1\"}, \"children\": [\n"
    "    {\"class\": \"Note\", \"name\": \"f\", \"properties\": {\"target\": \".e\"}}]},\n"
    "  {\"class\": \"Note\", \"name\": \"e\", \"properties\": {\"text\": \"2\"}},\n"
    "  {\"class\": \"Note\", \"name\": \"g\"}\n"
    "]}\n";

struct Session : Run {
    /// `twice`: another instance of the scene is at world.t.lvl.
    Session(const GameFolder& folder, unsigned seed, bool twice = false)
        : Run(folder), random(seed) {
        load(folder, "level.json");
        if (twice) load(folder, "level.json", add("Object", "t"));
        const Handle n = add("Note", "n");
        add("Note", n, "k");
        add("Note", "s");
        tweaks->game_loaded();
        barrier();
    }

    std::size_t below(std::size_t count) { return random() % count; }

    std::vector<Handle> notes() const {
        std::vector<Handle> all;
        tree.each_below(world, [&](Handle handle) {
            if (tree.class_of(handle).name() == "Note") all.push_back(handle);
        });
        return all;
    }

    /// Text and target of each note by its path; sorted, because children may be in another order.
    std::map<std::string, std::string> state() const {
        std::map<std::string, std::string> all;
        for (const Handle note : notes()) {
            const Value target = tree.get(note, "target");
            const bool leads = target.is(Type::reference) && tree.alive(target.reference());
            all[tree.path(note)] =
                tree.text(tree.get(note, "text")) + (leads ? " " + tree.text(target) : "");
        }
        return all;
    }

    std::string some_name() {
        static const std::vector<std::string> names{"d", "e", "f", "g", "h", "i", "n", "k", "s"};
        return names[below(names.size())];
    }

    void edit() {
        const std::vector<Handle> all = notes();
        if (all.empty()) return;
        const Handle note = all[below(all.size())];
        try {
            switch (below(11)) {
                case 0:
                case 1:
                case 2:
                    tree.set(note, "text", std::to_string(below(5)));
                    said = tree.path(note) + ".text = ...";
                    break;
                case 3:
                    tree.set(note, "target", all[below(all.size())]);
                    said = tree.path(note) + ".target = ...";
                    break;
                case 4:
                case 5: {
                    const Handle above = below(2) == 0 ? tree.parent(note) : note;
                    const std::string name = some_name();
                    if (tree.child(above, name)) return;
                    const Handle made = add("Note", Handle{}, name);
                    tree.set(made, "text", std::to_string(below(5)));
                    if (below(3) == 0) tree.set(made, "target", note);
                    tree.move(made, above, name);
                    said = "made " + tree.path(made);
                    break;
                }
                case 10: {
                    const Handle above = tree.parent(note);
                    const std::string name = tree.name(note);
                    said = "replaced " + tree.path(note);
                    tree.destroy(note);
                    tree.set(add("Note", above, name), "text", std::to_string(below(5)));
                    break;
                }
                case 6:
                    said = "deleted " + tree.path(note);
                    tree.destroy(note);
                    break;
                case 7:
                case 8: {
                    const std::string name = some_name();
                    if (tree.child(tree.parent(note), name)) return;
                    said = tree.path(note) + " is now " + name;
                    tree.rename(note, name);
                    break;
                }
                case 9: {
                    const Handle above = all[below(all.size())];
                    if (tree.child(above, tree.name(note))) return;
                    const std::string before = tree.path(note);
                    tree.move(note, above, tree.name(note));
                    said = before + " moved to " + tree.path(above);
                    break;
                }
            }
        } catch (const Error&) {  // moved below itself
        }
    }

    /// Makes one random action of the person, and adds a line that describes it to `done`.
    void step() {
        said.clear();
        switch (below(8)) {
            case 0:
            case 1: {
                const Tree::CauseScope scope(tree, Writer::console);
                (void)tree.undo();
                said = "undo";
                break;
            }
            case 2: {
                const Tree::CauseScope scope(tree, Writer::console);
                (void)tree.redo();
                said = "redo";
                break;
            }
            case 3:
                if (!may_keep) return;
                barrier();
                tweaks->keep("**");
                said = "keep";
                break;
            default:
                // A command makes one edit or several.
                std::string all;
                {
                    const Tree::CauseScope scope(tree, Writer::console);
                    tree.begin_edit("edit");
                    for (std::size_t edits = below(3) == 0 ? 3 : 1; edits > 0; --edits) {
                        said.clear();
                        edit();
                        if (!said.empty()) all += (all.empty() ? "" : "; ") + said;
                    }
                    tree.end_edit();
                }
                said = all;
        }
        barrier();
        if (!said.empty()) done += said + "\n";
    }

    bool all_kept() const {
        for (const Tweak& tweak : tweaks->list())
            if (!tweak.kept) return false;
        return true;
    }

    bool may_keep = true;
    std::mt19937 random;
    std::string said, done;
};

/// The default seeds, of which a quick run has a sixth, and those that found errors;
/// FETTLE_SESSIONS=n: the first n, or n from FETTLE_FIRST_SESSION; FETTLE_SESSION=n: only n.
std::vector<unsigned> seeds() {
    if (const char* const only = std::getenv("FETTLE_SESSION")) return {unsigned(std::stoul(only))};
    const char* const wanted = std::getenv("FETTLE_SESSIONS");
    std::vector<unsigned> all(wanted != nullptr ? std::stoul(wanted) : thorough() ? 200 : 33);
    const char* const first = std::getenv("FETTLE_FIRST_SESSION");
    std::iota(all.begin(), all.end(), first == nullptr ? 0U : unsigned(std::stoul(first)));
    if (first != nullptr) return all;
    for (const unsigned seed :
         {1023U, 1312U, 1377U, 1641U, 1681U, 1693U, 1856U,  1912U, 1934U, 2656U,
          2868U, 2921U, 3069U, 3261U, 3390U, 4082U, 4464U,  4825U, 4901U, 6272U,
          6612U, 7091U, 7842U, 8349U, 8941U, 9583U, 11525U, 13907U})
        if (seed >= all.size()) all.push_back(seed);
    return all;
}

std::string text(const std::map<std::string, std::string>& state) {
    std::string out;
    for (const auto& [path, value] : state) out += path + ": " + value + "\n";
    return out;
}

void check_that_next_runs_begin_with_the_last_state(bool twice) {
    std::size_t compared = 0;
    for (const unsigned seed : seeds()) {
        const GameFolder folder;
        folder.write("level.json", level);
        std::string done;
        for (unsigned run = 0; run < 3; ++run) {
            Session session(folder, seed * 3 + run, twice);
            const auto began = text(session.state());
            for (std::size_t steps = 1 + session.below(12); steps > 0; --steps) session.step();
            const TweakReport report = session.tweaks->keep("**");
            session.barrier();
            const std::string ended = text(session.state());
            std::string problems;
            for (const std::string& problem : report.problems) problems += problem + "\n";
            done += "begins with\n" + began + session.done + "keep " + problems;
            const bool all_kept = problems.empty() && session.all_kept();
            session.tweaks.reset();
            INFO("seed " << seed << "\n"
                         << done << folder.text("level.json") << "\n"
                         << (std::filesystem::exists(folder / "main.tweaks.json")
                                 ? folder.text("main.tweaks.json")
                                 : ""));
            const Session next(folder, 0, twice);
            INFO((next.reported.empty() ? std::string() : next.reported.front()));
            if (!all_kept) break;
            ++compared;
            CHECK(text(next.state()) == ended);
            CHECK(next.reported.empty());
        }
    }
    CHECK(compared > seeds().size() / 4);
}

}  // namespace

TEST_CASE("after random sessions of edits and keeps the next run begins with the last state") {
    check_that_next_runs_begin_with_the_last_state(false);
}

TEST_CASE(
    "after random sessions with two instances of a scene the next run begins as the last ended") {
    check_that_next_runs_begin_with_the_last_state(true);
}

TEST_CASE("making the tweaks of a random session again gives its last state") {
    std::size_t compared = 0;
    for (const unsigned seed : seeds()) {
        const GameFolder folder;
        folder.write("level.json", level);
        std::string done, ended;
        {
            Session session(folder, seed);
            session.may_keep = false;
            for (std::size_t steps = 1 + session.below(12); steps > 0; --steps) session.step();
            done = session.done;
            ended = text(session.state());
        }
        Session next(folder, 0);
        const std::string began = text(next.state());
        TweakReport report;
        const auto reapply = [&] {
            const Tree::CauseScope scope(next.tree, Writer::console);
            report = next.tweaks->reapply("**");
        };
        reapply();
        next.barrier();
        std::string problems;
        for (const std::string& problem : report.problems) problems += problem + "\n";
        std::string lines;
        for (const std::string& line : next.lines()) lines += line + "\n";
        INFO("seed " << seed << "\n" << done << problems << lines);
        CHECK(problems.empty());
        CHECK(text(next.state()) == ended);
        ++compared;
        if (report.count == 0) continue;
        // All tweaks are one step of undo. After the undo they are tweaks of an earlier run again.
        {
            const Tree::CauseScope scope(next.tree, Writer::console);
            if (began != ended) (void)next.tree.undo();
        }
        next.barrier();
        CHECK(text(next.state()) == began);
        bool undone = true;  // a reference to an instance that was deleted before may differ
        for (const Tweak& tweak : next.tweaks->list()) undone = undone && tweak.earlier;
        if (!undone) continue;
        reapply();
        next.barrier();
        CHECK(text(next.state()) == ended);
    }
    CHECK(compared == seeds().size());
}

}  // namespace keep_sessions_test
