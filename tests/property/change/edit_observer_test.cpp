#include <fettle/property/edits.h>

#include "catch.h"
#include "fixture.h"

namespace edit_observer_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// Records the notifications.
class Notes : public EditObserver {
  public:
    explicit Notes(Tree& tree) : tree_(tree) { tree.observe_edits(this); }
    ~Notes() override { tree_.observe_edits(nullptr); }
    Notes(const Notes&) = delete;
    void edited(Handle instance, const Property& property, const CellState& before) override {
        const bool there = tree_.find(instance, property.symbol) != nullptr;
        lines.push_back(tree_.path(instance, property) + ": " +
                        (before.present ? tree_.text(before.value) : "nothing") + " to " +
                        (there ? tree_.text(tree_.peek(instance, property)) : "nothing") +
                        (there && tree_.formula(instance, property) ? " by formula" : ""));
    }
    void instance_created(Handle instance) override {
        lines.push_back("born " + tree_.path(instance));
    }
    void instance_deleting(Handle instance) override {
        lines.push_back("dying " + tree_.path(instance));
    }
    void moved(Handle instance, Handle parent, const std::string& name) override {
        lines.push_back(tree_.path(instance) + " was " + name +
                        (parent ? " of " + tree_.path(parent) : " of nobody"));
    }
    std::vector<std::string> take() { return std::exchange(lines, {}); }
    std::vector<std::string> lines;

  private:
    Tree& tree_;
};

using Lines = std::vector<std::string>;

struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");
    Notes notes{tree};

    template <class F>
    Lines console(F f) {
        {
            const Tree::CauseScope scope(tree, Writer::console);
            f();
        }
        return notes.take();
    }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "an observer of edits is notified of the edits by a person only") {
    tree.set(ball, "mass", 2);
    {
        const Tree::CauseScope scope(tree, Writer::script);
        tree.set(ball, "mass", 3);
        tree.set_or_add(ball, "lives", 3);
    }
    CHECK(notes.take().empty());
    CHECK(console([&] { tree.set(ball, "mass", 5); }) == Lines{"world.ball.mass: 3 to 5"});
    CHECK(console([&] { tree.set(ball, "mass", 5); }).empty());
    CHECK(console([&] { tree.set_or_add(ball, "score", 1); }) ==
          Lines{"world.ball.score: nothing to 1"});
    CHECK(console([&] { tree.remove_ad_hoc(ball, "lives"); }) ==
          Lines{"world.ball.lives: 3 to nothing"});
    CHECK(console([&] {
              tree.set_formula(ball, "score", {[](const Tree&) { return Value(7); }, "7"});
          }) == Lines{"world.ball.score: 1 to 1 by formula"});
}

TEST_CASE_METHOD(Fixture, "an observer of edits is notified of the changes by undo and redo") {
    console([&] { tree.set(ball, "mass", 5); });
    console([&] { tree.set_or_add(ball, "score", 1); });
    tree.undo();
    CHECK(notes.take() == Lines{"world.ball.score: 1 to nothing"});
    tree.undo();
    CHECK(notes.take() == Lines{"world.ball.mass: 5 to 1"});
    tree.redo();
    tree.redo();
    CHECK(notes.take() == Lines{"world.ball.mass: 1 to 5", "world.ball.score: nothing to 1"});
}

TEST_CASE_METHOD(Fixture,
                 "an observer of edits is notified of created and deleted and moved instances") {
    CHECK(console([&] { tree.create(*module.type, world, "b"); }) == Lines{"born world.b"});
    CHECK(console([&] { tree.rename(tree.child(world, "b"), "c"); }) ==
          Lines{"world.c was b of world"});
    CHECK(console([&] { tree.destroy(tree.child(world, "c")); }) == Lines{"dying world.c"});
    tree.undo();
    CHECK(notes.take() == Lines{"born world.c"});
    tree.undo();
    CHECK(notes.take() == Lines{"world.b was c of world"});
    tree.undo();
    CHECK(notes.take() == Lines{"dying world.b"});
    tree.redo();
    CHECK(notes.take() == Lines{"born world.b"});
}

}  // namespace edit_observer_test
