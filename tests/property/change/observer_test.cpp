#include "catch.h"
#include "fixture.h"

#include <fettle/property/observer.h>

namespace observer_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
/// Records the notifications, one per line.
class Notes : public Observer {
  public:
    explicit Notes(Tree& tree) : tree_(tree) { tree.observe(*this); }
    ~Notes() override { tree_.unobserve(*this); }
    void wrote(Handle h, const Property& p, const Value& now) override {
        add(tree_.path(h, p) + " = " + tree_.text(now) + " by " +
            std::string(writer_name(tree_.cause().writer)));
    }
    void was_reset(Handle h, const Property& p) override { add(tree_.path(h, p) + " reset"); }
    void removed(Handle h, const Property& p) override { add(tree_.path(h, p) + " removed"); }
    void formula_changed(Handle h, const Property& p) override {
        add(tree_.path(h, p) + (tree_.formula(h, p) != nullptr ? " is a formula" : " is plain"));
    }
    void created(Handle h) override { add("created " + tree_.path(h)); }
    void destroying(Handle h) override { add("destroying " + tree_.path(h)); }
    void moved(Handle h) override { add("moved " + tree_.path(h)); }
    void call_begins(Handle, const Method& m, std::span<const Value>) override {
        add(m.name + " begins");
    }
    void call_ends(Handle, const Method& m) override { add(m.name + " ends"); }

    std::vector<std::string> take() { return std::exchange(lines_, {}); }

  private:
    void add(std::string line) { lines_.push_back(std::move(line)); }
    Tree& tree_;
    std::vector<std::string> lines_;
};

struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");
    Notes notes{tree};
};
using Lines = std::vector<std::string>;
}  // namespace

TEST_CASE_METHOD(Fixture, "an observer is notified of every write after it") {
    tree.set(ball, "mass", 5.0);
    tree.set(ball, "mass", 5.0);
    tree.set_or_add(ball, "lives", 3);
    tree.reset(ball, tree.property(ball, "mass"));
    tree.remove_ad_hoc(ball, "lives");
    const Lines reported = notes.take();
    REQUIRE(reported.size() == 4);
    CHECK(reported[0] == "world.ball.mass = 5 by module");
    CHECK(reported[1] == "world.ball.lives = 3 by module");
    CHECK(reported[2].find("world.ball.mass") == 0);
    CHECK(reported[3] == "world.ball.lives removed");
}

TEST_CASE_METHOD(Fixture, "an observer is notified of created and deleted and moved instances") {
    const Handle box = tree.create(tree.object_class(), world, "box");
    tree.rename(box, "crate");
    tree.move(box, tree.root());
    tree.destroy(box);
    CHECK(notes.take() ==
          Lines{"created world.box", "moved world.crate", "moved crate", "destroying crate"});
}

TEST_CASE_METHOD(Fixture, "an observer is notified of formulas and of their results") {
    const Property& mass = tree.property(ball, "mass");
    tree.set_or_add(world, "twice", 2.0);
    notes.take();
    tree.set_formula(ball, mass, {.function = [this](const Tree& t) {
                         return Value(2 * t.get(world, "twice").number());
                     }});
    CHECK(tree.get(ball, mass).number() == 4);
    tree.set(world, "twice", 5.0);
    CHECK(tree.get(ball, mass).number() == 10);
    tree.remove_formula(ball, mass);
    CHECK(notes.take() == Lines{"world.ball.mass is a formula", "world.ball.mass = 4 by formula",
                                "world.twice = 5 by module", "world.ball.mass = 10 by formula",
                                "world.ball.mass is plain"});
}

TEST_CASE_METHOD(Fixture, "an observer is notified of undo and redo like of other writes") {
    {
        const Tree::CauseScope console(tree, Writer::console);
        tree.set(ball, "mass", 5.0);
        tree.destroy(ball);
    }
    notes.take();
    tree.undo();
    tree.undo();
    const Lines reported = notes.take();
    CHECK(reported.front() == "created world.ball");
    CHECK(std::find(reported.begin(), reported.end(), "world.ball.mass = 5 by undo") !=
          reported.end());
    CHECK(tree.get(ball, "mass").number() == 1);
}

TEST_CASE_METHOD(Fixture,
                 "an observer is notified only of calls that change the memory of a module") {
    ClassDescriptor horn{.name = "Horn"};
    const auto method = [](std::string name, Effect effect) {
        return Method{.name = std::move(name),
                      .doc = "Nothing.",
                      .call = [](void*, Tree&, Handle, Row, std::span<const Value>) -> Result {
                          return Value();
                      },
                      .effect = effect};
    };
    horn.methods = {method("ask", Effect::nothing), method("honk", Effect::memory)};
    const Handle made = tree.create(tree.define(std::move(horn)), world, "horn");
    notes.take();
    tree.call(made, "ask", {});
    tree.call(made, "honk", {});
    CHECK(notes.take() == Lines{"honk begins", "honk ends"});
}

}  // namespace observer_test
