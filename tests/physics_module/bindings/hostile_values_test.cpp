// Every property of every class of physics with extreme values: an accepted value must do no harm,
// wherever the instance is and whatever happens to it later; a refused value must be refused
// everywhere with the same message.

#include <cstdint>
#include <limits>
#include <random>

#include <fettle/property/bound_text.h>
#include <fettle/property/storage/scene.h>

#include "catch.h"
#include "game.h"
#include "thorough.h"

namespace hostile_values_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Class;
using property::Property;
using property::Type;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const double numbers[] = {0,    1e-320, 1e-45, 1e-30, 1e-5,  1,     -1,  64,   1e6, -1e6, 1e8,
                          -1e8, 1e9,    -1e9,  3e38,  -3e38, 1e300, inf, -inf, nan, 0.5};

std::vector<Value> values_of(const Property& property) {
    std::vector<Value> all;
    switch (property.type) {
        case Type::boolean:
            return {true, false};
        case Type::integer:
            for (const std::int64_t i :
                 {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1}, std::int64_t{65},
                  std::int64_t{INT32_MAX}, std::int64_t{INT64_MAX}, std::int64_t{INT64_MIN}})
                all.emplace_back(i);
            all.emplace_back(1e300);
            return all;
        case Type::number:
            for (const double x : numbers) all.emplace_back(x);
            return all;
        case Type::vec2:
            for (const double x : numbers) {
                all.emplace_back(Vec2(x, x));
                all.emplace_back(Vec2(x, 0));
                all.emplace_back(Vec2(1, -x));
            }
            return all;
        case Type::text:
            for (const std::string& name : property.enumerators) all.emplace_back(name);
            all.emplace_back("");
            return all;
        case Type::color:
            return {"red", "#00000000"};
        case Type::list:
            for (const double x : numbers) {
                all.emplace_back(List{Vec2(0, 0), Vec2(x, 0)});
                all.emplace_back(List{Vec2(-x, -x), Vec2(x, x)});
                all.emplace_back(List{Vec2(0, 0), Vec2(x, 0), Vec2(0, x)});
                all.emplace_back(List{Vec2(0, 0), Vec2(x, 0), Vec2(2 * x, 0)});
                all.emplace_back(List{Vec2(0, 0), Vec2(x, 0), Vec2(x, x), Vec2(0, x)});
                all.emplace_back(List{Vec2(0, 0), Vec2(x, 0), Vec2(x, 1e-5), Vec2(0, 1e-5)});
            }
            all.emplace_back(List{});
            all.emplace_back(List{Vec2(1, 1)});
            return all;
        default:
            return {Handle{}};
    }
}

enum class Where { acting, waiting, detached };

/// Two bodies, and an instance of the tested class between them or on one of them.
struct Hostile : Game {
    Handle branch, a, b, subject;

    /// If `where` is `waiting`, a joint has no bodies yet.
    void build(const Class& of, Where where) {
        const bool is_world = of.is_a(tree.class_named("World"));
        const Handle above = where == Where::detached ? Handle{} : is_world ? tree.root() : world();
        branch = tree.create(tree.class_named(is_world ? "World" : "Object"), above);
        a = make("Body", branch, {{"position", Vec2(0, 1)}});
        b = make("Body", branch, {{"position", Vec2(2, 1)}});
        make("Box", a);
        make("Circle", b);
        if (is_world) {
            subject = branch;
            return;
        }
        const bool is_shape = of.is_a(tree.class_named("Shape"));
        subject = tree.create(of, is_shape ? a : branch);
        if (where == Where::waiting) return;
        for (const char* side : {"body_a", "body_b", "body"})
            if (of.property(side) != nullptr)
                set(subject, side, side == std::string("body_b") ? b : a);
        if (where == Where::acting) step();
    }

    void read_everything() {
        tree.each_below(branch, [this](Handle each) {
            for (const Property* property : tree.properties(each)) {
                INFO(tree.path(each, *property));
                const Value value = tree.get(each, *property);
                if (value.is(Type::number)) CHECK_FALSE(std::isnan(value.number()));
                if (value.is(Type::vec2)) CHECK(value.vec2() == value.vec2());
            }
        });
    }

    Handle home() {
        return tree.class_of(branch).is_a(tree.class_named("World")) ? tree.root() : world();
    }

    /// Changes that happen in a game: moving, stepping, sleeping.
    void change_game() {
        if (!tree.parent(branch)) tree.move(branch, home());
        for (const char* side : {"body_a", "body_b", "body"})
            if (tree.find(subject, side) != nullptr)
                set(subject, side, side == std::string("body_b") ? b : a);
        step(2);
        read_everything();
        const std::string text = property::scene_text(tree, branch);
        const Handle again = property::load_scene_text(tree, text, "again.json", home());
        CHECK(property::scene_text(tree, again).size() > 10);
        step();
        tree.destroy(again);
        const property::Snapshot saved = tree.snapshot();
        step();
        tree.restore(saved);
        step();
        tree.move(branch, {});
        read_everything();
        step();
        tree.move(branch, home());
        step();
        read_everything();
        CHECK_FALSE(physics.world(subject).validate());
    }

    /// The reason why a value is refused, without the path; "" if it is accepted.
    std::string write(const Property& property, const Value& value) {
        try {
            tree.set(subject, property, value);
            return "";
        } catch (const property::Error& error) {
            const std::string text = error.what();
            return text.substr(text.find(": "));
        }
    }

    std::vector<const Class*> classes() {
        std::vector<const Class*> all;
        for (const Class* of : tree.classes())
            for (const char* base : {"World", "Body", "Shape", "Joint", "Field"})
                if (of->creatable() && of->is_a(tree.class_named(base))) all.push_back(of);
        return all;
    }
    static bool can_be_written(const Property& property) {
        return !property.read_only && property.binding.kind != property::BindingKind::node &&
               property.name != "threads";
    }
};

}  // namespace

TEST_CASE_METHOD(Hostile, "every value that a property of physics accepts does no harm") {
    int accepted = 0, refused = 0;
    std::size_t tried = 0;
    REQUIRE(classes().size() >= 1 + 1 + 8 + 12 + 4);
    for (const Class* of : classes()) {
        for (const Property* property : of->properties()) {
            if (!can_be_written(*property)) continue;
            for (const Value& value : values_of(*property)) {
                if (!is_tested(tried++, 7)) continue;
                std::vector<std::string> answers;
                for (const Where where : {Where::acting, Where::waiting, Where::detached}) {
                    INFO(of->name() << "." << property->name << " = " << tree.text(value)
                                    << " where " << static_cast<int>(where));
                    build(*of, where);
                    answers.push_back(write(*property, value));
                    ++(answers.back().empty() ? accepted : refused);
                    if (answers.back().empty()) REQUIRE_NOTHROW(change_game());
                    tree.destroy(branch);
                }
                INFO(of->name() << "." << property->name << " = " << tree.text(value));
                CHECK(answers[0] == answers[1]);
                CHECK(answers[0] == answers[2]);
            }
        }
    }
    CHECK(accepted > (thorough() ? 3000 : 430));
    CHECK(refused > (thorough() ? 3000 : 430));
}

TEST_CASE_METHOD(Hostile, "several accepted values at once do no harm") {
    std::mt19937 random(11);
    for (int round = 0; round < 30; ++round) {
        for (const Class* of : classes()) {
            const auto where = static_cast<Where>(random() % 3);
            build(*of, where);
            std::string done = of->name() + " where " + std::to_string(static_cast<int>(where));
            const Handle own = subject;
            for (int i = 0; i < 12; ++i) {
                // Half of the edits are of the bodies: far away, heavy, with another center of
                // mass.
                subject = random() % 2 == 0 ? own : random() % 2 == 0 ? a : b;
                const auto properties = tree.class_of(subject).properties();
                const Property& property = *properties[random() % properties.size()];
                if (!can_be_written(property) || property.type == Type::reference) continue;
                const std::vector<Value> values = values_of(property);
                const Value& value = values[random() % values.size()];
                if (write(property, value).empty())
                    done += "\n" + tree.path(subject, property) + " = " + tree.text(value);
            }
            subject = own;
            INFO(done);
            REQUIRE_NOTHROW(change_game());
            tree.destroy(branch);
        }
    }
}

TEST_CASE_METHOD(Hostile, "the bound in an error message is accepted when it is typed") {
    int tried = 0;
    for (const Class* of : classes()) {
        for (const Property* property : of->properties()) {
            if (!can_be_written(*property) || !property->range.bounded()) continue;
            for (const double bound : {property->range.min, property->range.max}) {
                if (std::isinf(bound)) continue;
                build(*of, Where::detached);
                const std::string typed = property::bound_text(bound, property->precision());
                INFO(of->name() << "." << property->name << " = " << typed);
                const double x = std::strtod(typed.c_str(), nullptr);
                Value value = x, beyond = bound == property->range.min ? x - 1 - std::fabs(x) * 1e-5
                                                                       : x + 1 + x * 1e-5;
                if (property->type == Type::integer) {
                    value = static_cast<std::int64_t>(x);
                    beyond = std::floor(beyond.number());
                } else if (property->type == Type::vec2) {
                    value = Vec2(x, x);
                    beyond = Vec2(0, beyond.number());
                } else if (property->type == Type::list && property->element != Type::vec2) {
                    if (property->element == Type::integer)
                        value = List{static_cast<std::int64_t>(x)};
                    else
                        value = List{x};
                    beyond = List{std::floor(beyond.number())};
                } else if (property->type == Type::list) {
                    value = List{Vec2(0, 0), Vec2(x, x), Vec2(x, 0)};
                    beyond = List{Vec2(0, 0), Vec2(1, 1), Vec2(beyond.number(), 0)};
                    if (property->name == "bounds" || property->name == "region")
                        value = List{Vec2(0, 0), Vec2(x, x)};
                }
                CHECK(write(*property, value) == "");
                // The message for a value beyond the bound contains the bound and the unit.
                const std::string message = write(*property, beyond);
                CHECK_THAT(message, contains(typed));
                CHECK_THAT(message, contains(property->unit));
                tree.destroy(branch);
                ++tried;
            }
        }
    }
    CHECK(tried > 150);
}

TEST_CASE_METHOD(Hostile,
                 "the message about a number that no float can hold names range and unit") {
    for (const Class* of : classes()) {
        for (const Property* property : of->properties()) {
            const bool number = property->type == Type::number, vec2 = property->type == Type::vec2;
            if (!can_be_written(*property) || (!number && !vec2)) continue;
            build(*of, Where::waiting);
            const std::string message =
                write(*property, number ? Value(1e300) : Value(Vec2(0, 1e300)));
            INFO(of->name() << ": " << message);
            CHECK_THAT(message, contains(" to ") && contains("1e+300"));
            CHECK_THAT(message, contains(property->unit));
            tree.destroy(branch);
        }
    }
}

TEST_CASE_METHOD(Hostile, "bodies as far apart as possible can be connected by every joint") {
    for (const Class* of : classes()) {
        if (!of->is_a(tree.class_named("Joint"))) continue;
        for (const bool at_once : {true, false}) {
            INFO(of->name() << at_once);
            build(*of, at_once ? Where::acting : Where::waiting);
            set(a, "position", Vec2(1e8, -1e8));
            set(a, "center", Vec2(-1e8, 1e8));
            set(a, "angle", 1e8);
            set(b, "position", Vec2(-1e8, 1e8));
            set(b, "center", Vec2(1e8, 1e8));
            if (of->property("ratio") != nullptr) set(subject, "ratio", 1000);
            if (of->property("anchor_a") != nullptr) set(subject, "anchor_a", Vec2(1e8, 1e8));
            if (of->property("target") != nullptr) set(subject, "target", Vec2(-1e8, 1e8));
            REQUIRE_NOTHROW(change_game());
            tree.destroy(branch);
        }
    }
}

}  // namespace hostile_values_test
