#pragma once
// Random operations on a tree and on a model in parallel; after each barrier both must be equal,
// all formulas must be settled, and every watcher must have the current value.

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/snapshot.h>

#include "fixture.h"
#include "naive_world.h"

namespace fettle::property::testing {

/// The numbers of an operation, which a failing run prints and which reproduce it.
struct Operation {
    enum Kind {
        create,
        destroy,
        move,
        set,
        set_formula,
        clear,
        read,
        barrier,
        simulate,
        begin_edit,
        end_edit,
        undo,
        redo,
        watch,
        stop,
        rename,
        explain,
        snapshot,
        restore,
        kinds
    };
    Kind kind = barrier;
    std::array<int, 4> numbers{};  // each from 0 to 9999; the meaning depends on the kind
};
std::ostream& operator<<(std::ostream& out, const Operation& operation);

/// A difference between tree and model.
class Difference : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

class RandomRun {
  public:
    /// `people`: all edits are made by a person and can be undone; otherwise scripts write, and
    /// handlers create, delete and edit, too.
    explicit RandomRun(bool people);
    ~RandomRun();
    /// Throws Difference.
    void run(const Operation& operation);
    /// Runs a barrier and compares everything.
    void settle();

  private:
    struct Watcher;

    void run_alone(const Operation& operation);
    std::optional<int> pick(int number) const;
    Handle handle(int instance) const { return handles_[static_cast<std::size_t>(instance)]; }
    NaiveInstance& naive(int instance) {
        return world_.instances[static_cast<std::size_t>(instance)];
    }
    bool present(int instance, const std::string& property) const;

    void create(const std::string& name);
    void destroy(int instance);
    void move(int instance, int parent);
    void set(int instance, const std::string& property, double value);
    void set_formula(int instance, const std::string& property, const Recipe& recipe);
    void clear(int instance, const std::string& property);
    void simulate(int number);
    void step_in_history(bool back);
    void restore();
    void watch(int instance, const std::string& property, int action, int number);
    void reported(Watcher& watcher, const Change& change);
    void act(Watcher& watcher);
    void explain(int instance, const std::string& property);

    /// Runs a function that may be an edit, and records the world before it if it was one.
    template <class Edit>
    void edit(Edit edit);
    void note(NaiveWorld before);

    void check_cell(int instance, const std::string& property);
    void check_lists() const;
    void check_everything();
    void check(bool holds, const std::string& what) const;

    Tree tree_;
    BallModule module_{tree_};
    Handle root_ = tree_.create(tree_.object_class(), tree_.root(), "world");
    NaiveWorld world_;
    std::vector<Handle> handles_;
    std::vector<std::unique_ptr<Watcher>> watchers_;
    std::vector<NaiveWorld> done_, undone_;
    struct Kept {
        Snapshot snapshot;
        NaiveWorld world;
        std::vector<NaiveWorld> done, undone;
    };
    std::optional<Kept> kept_;
    bool people_, in_edit_ = false, wrote_ = false, in_barrier_ = false;
    bool handlers_wrote_ = false;  // at the last barrier
    NaiveWorld before_edit_;
    std::uint64_t steps_ = 0;
    std::map<std::pair<int, std::string>, int>
        runs_;  // number of calls of formulas since the last barrier began
};

}  // namespace fettle::property::testing
