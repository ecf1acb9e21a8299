#include <fettle/physics/host_access.h>
#include <algorithm>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <sstream>
#include <thread>

#include "catch.h"
#include "every_method.h"
#include "patterns.h"

namespace locked_test {

// Calls that functions of the user may make while a function of the library runs, and the state of
// a world after a forbidden call.

using namespace scenes;

namespace {

using Act = std::function<void()>;

/// A way to be called by the world: `call(world, things, act)` lets the world call `act` at least
/// once.
struct Way {
    std::string name;
    bool in_the_middle;  ///< of a step or an edit
    std::function<void(World&, Things&, const Act&)> call;
};

QueryFilter asking(const Act& act) {
    return {.accept = [act](const Shape&) {
        act();
        return true;
    }};
}

Way query(const std::string& name, std::function<void(World&, const QueryFilter&)> ask) {
    return {"QueryFilter::accept of " + name, false,
            [ask](World& world, Things&, const Act& act) { ask(world, asking(act)); }};
}

const std::vector<Way>& every_way() {
    static const std::vector<Way> all = {
        {"set_filter", true,
         [](World& world, Things&, const Act& act) {
             bool now = false;
             world.set_filter([act, &now](const Shape&, const Shape&) {
                 if (now) act();
                 return true;
             });
             now = true;
             world.step(frame);  // its first: all pairs are new
             now = false;
         }},
        {"set_filter", true,
         [](World& world, Things&, const Act& act) {
             world.step(frame);
             world.set_filter([act](const Shape&, const Shape&) {
                 act();
                 return true;
             });
         }},
        {"set_filter", true,
         [](World& world, Things&, const Act& act) {
             world.step(frame);
             bool now = false;
             world.set_filter([act, &now](const Shape&, const Shape&) {
                 if (now) act();
                 return true;
             });
             now = true;
             world.shapes()[1].set_category(3);  // of a heap that touches
             now = false;
         }},
        {"set_mixing", true,
         [](World& world, Things&, const Act& act) {
             world.set_mixing([act](ContactEdit&) { act(); });
             world.step(frame);
         }},
        {"set_before_solve", true,
         [](World& world, Things&, const Act& act) {
             world.set_before_solve([act](ContactEdit&) { act(); });
             world.step(frame);
         }},
        {"set_velocity_function", true,
         [](World& world, Things& things, const Act& act) {
             things.body.set_velocity_function([act](VelocityEdit&) { act(); });
             world.step(frame);
             things.body.set_velocity_function({});
         }},
        {"set_position_function", true,
         [](World& world, Things& things, const Act& act) {
             things.body.set_position_function([act](PositionEdit&) { act(); });
             world.step(frame);
             things.body.set_position_function({});
         }},
        {"start_recording", false,
         [](World& world, Things&, const Act& act) {
             world.start_recording([act](std::span<const std::byte>) { act(); });
             world.stop_recording();
         }},
        {"start_recording", true,
         [](World& world, Things&, const Act& act) {
             bool now = false;
             world.start_recording([act, &now](std::span<const std::byte>) {
                 if (std::exchange(now, false)) act();
             });
             now = true;
             world.step(frame);
             world.stop_recording();
         }},
        {"on_refresh", false,
         [](World& world, Things& things, const Act& act) {
             HostAccess::on_refresh(world, [act](const Refresh&) { act(); });
             things.box.set_width(1.1f);
             (void)things.body.mass();
         }},
        query("a point",
              [](World& w, const QueryFilter& f) {
                  (void)w.query_point({5, 2}, f);
              }),
        query("a box",
              [](World& w, const QueryFilter& f) {
                  (void)w.query_aabb({{-50, -50}, {50, 50}}, f);
              }),
        query("a ray",
              [](World& w, const QueryFilter& f) {
                  (void)w.cast_ray({-9, 1}, {9, 1}, f);
              }),
        query("all on a ray",
              [](World& w, const QueryFilter& f) {
                  (void)w.cast_ray_all({-9, 1}, {9, 1}, f);
              }),
        query("an overlap",
              [](World& w, const QueryFilter& f) {
                  (void)w.query_overlap(Circle{.radius = 9}, {}, f);
              }),
        query("an overlap with a shape of the world",
              [](World& w, const QueryFilter& f) { (void)w.query_overlap(w.shapes()[1], f); }),
        query("a shape cast",
              [](World& w, const QueryFilter& f) {
                  (void)w.cast_shape(Circle{}, {{-9, 1}}, {9, 0}, f);
              }),
        query("a cast of a shape of the world",
              [](World& w, const QueryFilter& f) {
                  (void)w.cast_shape(w.shapes()[1], {9, 0}, f);
              }),
        query("the closest",
              [](World& w, const QueryFilter& f) {
                  (void)w.closest({0, 9}, 99, f);
              }),
        query("an explosion",
              [](World& w, const QueryFilter& f) {
                  w.explode({0, 0}, 9, 1, f);
              }),
    };
    return all;
}

/// The message of what `act` throws, which has to be Locked.
std::string refusal(const Act& act) {
    try {
        act();
    } catch (const Locked& refused) {
        return refused.what();
    }
    return "it was allowed";
}

std::string text_of(const std::string& file) {
    std::ifstream in("physics/include/fettle/physics/" + file);
    std::stringstream text;
    text << in.rdbuf();
    return patterns::without(text.str(), "//[^\n]*");
}

/// "Body::mass" and whether it is const, for each public method that the header declares.
std::set<std::pair<std::string, bool>> declared_in(const std::string& file) {
    std::set<std::pair<std::string, bool>> found;
    const std::string text = text_of(file);
    const std::string method = "(\\w+)\\(([^()]|\\([^()]*\\))*\\)\\s*(const)?\\s*(;|\\{)";
    for (size_t at = text.find("\nclass "); at != std::string::npos;
         at = text.find("\nclass ", at + 1)) {
        const size_t end = text.find("\n};", at), forward = text.find(';', at);
        const size_t begin = text.find("public:", at);
        if (begin > end || forward < begin) continue;
        const std::string head = text.substr(at + 7, begin - at);
        const std::string name = head.substr(0, head.find_first_of(" :{\n"));
        std::string body = text.substr(begin, end - begin);
        for (const char* part : {"\n  protected:", "\n  private:"})
            body = body.substr(0, body.find(part));
        for (const patterns::Match& match : patterns::all(body, method))
            found.emplace(name + "::" + match[1], !match[3].empty());
    }
    return found;
}

}  // namespace

TEST_CASE("the list of methods in these tests has every method of the headers") {
    std::set<std::string> listed;
    for (const Method& method : every_method()) listed.emplace(method.name);
    size_t seen = 0;
    for (const char* file : {"body.h", "shape.h", "joint.h", "sliding_joints.h",
                             "coupling_joints.h", "field.h", "world.h"}) {
        for (const auto& [name, is_const] : declared_in(file)) {
            const std::string type = name.substr(0, name.find(':')),
                              method = name.substr(name.rfind(':') + 1);
            const bool plain = method == type || method == "is_valid" || method == "id" ||
                               method == "index" || method == "operator" || method == "bool" ||
                               method == "self" || method == "uint32_t";
            if (plain || (type == "World" && is_const) || type == "MouseJoint") continue;
            INFO(name);
            CHECK(listed.contains(name));
            ++seen;
        }
    }
    REQUIRE(seen > 280);
}

TEST_CASE("no edit is possible inside a function that the world is calling") {
    for (const Way& way : every_way()) {
        World world, plain;
        Things things = make_things(world);
        Things same = make_things(plain);
        bool done = false;
        way.call(world, things, [&] {
            if (std::exchange(done, true)) return;
            for (const Method& method : every_method()) {
                if (!method.edits) continue;
                INFO(way.name << ": " << method.name);
                const std::string message = refusal([&] { method.call(things); });
                CHECK_THAT(message, contains(way.name.substr(0, way.name.find(' '))));
                const std::string function(method.name.substr(method.name.rfind(':') + 1));
                // MouseJoint has names of its own for functions that all joints have.
                if (!method.name.starts_with("MouseJoint")) CHECK_THAT(message, contains(function));
            }
            World other;
            CHECK_THAT(refusal([&] { world.restore(other); }), contains("World::restore"));
            CHECK_THAT(refusal([&] { world = std::move(other); }), contains("operator="));
            CHECK_THAT(refusal([&] { other = std::move(world); }), contains("operator="));
            CHECK_THAT(refusal([&] { other.take(std::move(world)); }), contains("World::take"));
            const uint32_t slot = things.body.index();
            CHECK_THAT(refusal([&] {
                           HostAccess::set_velocity(world, slot, {1, 1});
                       }),
                       contains("HostAccess::set_velocity"));
            CHECK_THAT(refusal([&] { HostAccess::on_refresh(world, {}); }),
                       contains("HostAccess::on_refresh"));
            CHECK_THAT(refusal([&] { HostAccess::refresh(world, {}); }),
                       contains("HostAccess::refresh"));
            CHECK(HostAccess::write_velocity(world, slot, {1, 1}) == Written::refused);
            CHECK(HostAccess::write<BodyNumber::torque>(world, slot, 5.0f) == Written::refused);
        });
        INFO(way.name);
        REQUIRE(done);
        way.call(plain, same, [] {});
        for (World* each : {&world, &plain}) {
            each->set_filter({});
            each->set_mixing({});
            each->set_before_solve({});
            HostAccess::on_refresh(*each, {});
            run(*each, 0.5f);
            REQUIRE_FALSE(each->validate());
        }
        REQUIRE(world.hash() == plain.hash());
        REQUIRE(world.threads() == 1);
    }
}

TEST_CASE("inside a function that the world is calling everything can be read") {
    for (const Way& way : every_way()) {
        World world;
        Things things = make_things(world);
        bool done = false;
        way.call(world, things, [&] {
            if (std::exchange(done, true)) return;
            INFO(way.name);
            for (const Method& method : every_method())
                if (!method.edits) CHECK_NOTHROW(method.call(things));
            CHECK(world.query_point({5, 2}).size() >= 2);
            CHECK(world.cast_ray({-9, 0.5f}, {9, 0.5f})->point.x < -3);
            CHECK(world.query_overlap(Circle{.radius = 0.2f}, {{-4, 0.5f}}).size() == 1);
            CHECK(world.closest({-4, 9})->distance > 1);
            CHECK(world.cast_shape(things.circle, {0, -9}));
            CHECK(world.bodies().size() == world.body_count());
            CHECK(world.hash() == world.hash());
            int inner = 0;
            QueryFilter filter = asking([&inner] { ++inner; });
            CHECK_FALSE(world.query_aabb({{-50, -50}, {50, 50}}, filter).empty());
            CHECK(inner > 5);
            filter = asking([&world] { world.wake_all(); });
            CHECK_THAT(refusal([&] {
                           (void)world.query_point({5, 2}, filter);
                       }),
                       contains("accept"));
        });
        REQUIRE(done);
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("a world is copied and saved inside a query and not inside a step") {
    for (const Way& way : every_way()) {
        World world;
        Things things = make_things(world);
        std::unique_ptr<World> copy;
        bool done = false;
        way.call(world, things, [&] {
            if (std::exchange(done, true)) return;
            INFO(way.name);
            std::vector<std::byte> bytes;
            if (way.in_the_middle) {
                CHECK_THAT(refusal([&] { copy = std::make_unique<World>(world.clone()); }),
                           contains("copying a World is not allowed inside"));
                CHECK_THAT(refusal([&] { world.save(bytes); }), contains("World::save"));
                CHECK_THAT(refusal([&] { (void)world.validate(); }), contains("World::validate"));
                World other;
                CHECK_THAT(refusal([&] { other.restore(world); }), contains("copying a World"));
                return;
            }
            copy = std::make_unique<World>(world.clone());
            world.save(bytes);
            CHECK_FALSE(world.validate());
            World other;
            other.restore(bytes);
            CHECK(other.hash() == world.hash());
        });
        REQUIRE(done);
        if (way.in_the_middle) continue;
        HostAccess::on_refresh(world, {});
        run(*copy, 0.5f);
        REQUIRE_FALSE(copy->validate());
    }
}

TEST_CASE("the exception of a callback reaches the caller and the world stays valid") {
    for (const int threads : {1, 3}) {
        for (const Way& way : every_way()) {
            INFO(way.name << " with threads " << threads);
            World world, plain;
            world.set_threads(threads);
            Things things = make_things(world), same = make_things(plain);
            int calls = 0, calls_there = 0;
            // Of any type, and the first of them.
            int caught = 0;
            try {
                way.call(world, things, [&] { throw ++calls; });
            } catch (const int thrown) {
                caught = thrown;
            }
            REQUIRE(caught == 1);
            HostAccess::on_refresh(world, {});
            world.set_filter({});
            world.set_mixing({});
            world.set_before_solve({});
            for (Body body : {things.body, same.body}) {
                body.set_velocity_function({});
                body.set_position_function({});
            }
            REQUIRE_FALSE(world.validate());
            // As if no callback had been set.
            if (way.in_the_middle) {
                way.call(plain, same, [&] { ++calls_there; });
                REQUIRE(calls == calls_there);  // the other callbacks are called all the same
                plain.set_filter({});
                plain.set_mixing({});
                plain.set_before_solve({});
                REQUIRE(world.hash() == plain.hash());
                REQUIRE(world.statistics().steps == plain.statistics().steps);
                run(plain, 0.5f);
                run(world, 0.5f);
                REQUIRE(world.hash() == plain.hash());
            }
            run(world, 0.5f);
            REQUIRE_FALSE(world.validate());
            Body later = add_ball(world, {0, 20});
            REQUIRE(later.is_valid());
        }
    }
}

TEST_CASE("a function that destroys the world that calls it ends the call with an error") {
    for (const int threads : {1, 3}) {
        for (const Way& way : every_way()) {
            INFO(way.name << " with threads " << threads);
            auto world = std::make_unique<World>();
            world->set_threads(threads);
            Things things = make_things(*world);
            int calls = 0;
            std::string inside;
            const std::string message = refusal([&] {
                way.call(*world, things, [&] {
                    ++calls;
                    world.reset();
                    try {
                        (void)things.body.position();
                    } catch (const std::invalid_argument& refused) {
                        inside = refused.what();
                    }
                });
            });
            REQUIRE(calls == 1);
            REQUIRE_THAT(message, contains("the world was destroyed inside"));
            REQUIRE_THAT(message, contains(way.name.substr(0, way.name.find(' '))));
            REQUIRE_THAT(inside, contains("its world was destroyed"));
            REQUIRE_FALSE(things.body.is_valid());
        }
    }
}

TEST_CASE("a callback may edit and step other worlds but not the world that calls it") {
    World outer, inner;
    Things things = make_things(outer), others = make_things(inner);
    std::string refused;
    int edits = 0;
    inner.set_before_solve([&](ContactEdit&) {
        refused = refusal([&] { things.body.set_velocity({0, 1}); });
    });
    outer.set_before_solve([&](ContactEdit&) {
        others.body.set_velocity({0, float(++edits)});
        inner.create_body().add(Circle{});
        if (edits % 8 == 0) inner.step(frame);
        if (edits % 32 == 20) inner.restore(inner.clone());
    });
    for (int i = 0; i < 30 && edits <= 64; ++i) outer.step(frame);
    REQUIRE(edits > 20);
    REQUIRE_THAT(refused, contains("Body::set_velocity is not allowed inside the before-solve"));
    REQUIRE_FALSE(outer.validate());
    REQUIRE_FALSE(inner.validate());
}

TEST_CASE("a world cannot be edited during a query of another world with one of its shapes") {
    World asked, asks;
    Things things = make_things(asked), others = make_things(asks);
    int asked_for = 0;
    const QueryFilter filter = asking([&] {
        ++asked_for;
        CHECK_THAT(refusal([&] { asks.clear(); }), contains("World::clear is not allowed inside"));
        CHECK_THAT(refusal([&] { others.circle.set_radius(3); }), contains("Shape::set_radius"));
    });
    others.circle.set_radius(30);
    REQUIRE_FALSE(asked.query_overlap(others.circle, filter).empty());
    REQUIRE(asked.cast_shape(others.circle, {1, 0}, filter));
    REQUIRE(asked_for > 5);
    auto gone = std::make_unique<World>();
    Shape shape = gone->create_body().add(Circle{.radius = 30});
    const QueryFilter ends = asking([&] { gone.reset(); });
    REQUIRE_THAT(refusal([&] { (void)asked.query_overlap(shape, ends); }),
                 contains("was destroyed"));
    REQUIRE_FALSE(shape.is_valid());
    REQUIRE_FALSE(asked.validate());
}

TEST_CASE("worlds of several threads call their callbacks at the same time") {
    std::vector<std::thread> threads;
    std::vector<uint64_t> hashes(4);
    std::vector<int> refused(4);
    for (size_t i = 0; i < hashes.size(); ++i) {
        threads.emplace_back([&, i] {
            World world;
            Things things = make_things(world);
            world.set_before_solve([&](ContactEdit&) {
                try {
                    things.body.set_velocity({1, 1});
                } catch (const Locked&) {
                    ++refused[i];
                }
            });
            run(world, 0.5f);
            hashes[i] = world.hash();
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (size_t i = 0; i < hashes.size(); ++i) {
        REQUIRE(hashes[i] == hashes[0]);
        REQUIRE(refused[i] == refused[0]);
        REQUIRE(refused[i] > 0);
    }
}

}  // namespace locked_test
