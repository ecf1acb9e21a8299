#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "hosted.h"

namespace tree_test {

using namespace hosted;

namespace {

const char* const ball = "world.ball = Body { Circle {}, position = vec(1, 5) }";

fettle_instance find(const Game& game, const char* path) {
    fettle_instance found = 0;
    require(fettle_hosted_find(game.get(), path, &found));
    return found;
}
fettle_property_id property(const Game& game, const char* path) {
    fettle_property_id held = 0;
    require(fettle_property_at(game.get(), path, &held));
    return held;
}

}  // namespace

TEST_CASE("values of each type are read and written by path and by handle") {
    const Game game = make(std::string(ball) + " world.other = Body { Circle {} }");
    fettle_hosted* const g = game.get();
    const fettle_hosted_value vector = get(g, "world.ball.position");
    REQUIRE(vector.type == FETTLE_VALUE_VEC2);
    CHECK(vector.as.vec2[1] == 5);

    const auto y = property(game, "world.ball.position.y");
    double number = 0, x = 0;
    require(fettle_property_set_number(g, y, 7.5));
    require(fettle_property_get_number(g, y, &number));
    CHECK(number == 7.5);
    const auto position = property(game, "world.ball.position");
    require(fettle_property_get_vec2(g, position, &x, &number));
    CHECK(x == 1);
    CHECK(number == 7.5);
    require(fettle_property_set_vec2(g, position, -2, 3));
    CHECK(get(g, "world.ball.position").as.vec2[0] == -2);

    const auto bullet = property(game, "world.ball.bullet");
    bool truth = false;
    require(fettle_property_set_boolean(g, bullet, true));
    require(fettle_property_get_boolean(g, bullet, &truth));
    CHECK(truth);
    const auto type = property(game, "world.ball.type");
    const char* text = nullptr;
    require(fettle_property_set_text(g, type, "static"));
    require(fettle_property_get_text(g, type, &text));
    CHECK(text == std::string("static"));

    require(fettle_hosted_run(g, "game.goal = world.ball", "start"));
    const auto goal = property(game, "goal");
    fettle_instance instance = 0;
    require(fettle_property_get_instance(g, goal, &instance));
    CHECK(instance == find(game, "world.ball"));
    require(fettle_property_set_instance(g, goal, find(game, "world.other")));
    CHECK(get(g, "goal").as.instance == find(game, "world.other"));

    const fettle_hosted_value points[] = {hosted::number(1), hosted::text("two")};
    require(fettle_hosted_run(g, "game.list = {}", "start"));
    fettle_hosted_value list{};
    list.type = FETTLE_VALUE_LIST;
    list.count = 2;
    list.as.list = points;
    require(fettle_hosted_set(g, "list", &list));
    const fettle_hosted_value back = get(g, "list");
    REQUIRE(back.count == 2);
    CHECK(back.as.list[1].as.text == std::string("two"));
}

TEST_CASE("errors name the path and the value and the nearest name") {
    const Game game = make(ball);
    fettle_hosted_value value = hosted::number(-1);
    CHECK(fettle_hosted_set(game.get(), "world.ball.mass", &value) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("world.ball.mass: expected a number of at least"));
    CHECK(fettle_hosted_get(game.get(), "world.bal.mass", &value) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("did you mean \"ball\"?"));
    fettle_instance instance = 0;
    CHECK(fettle_hosted_find(game.get(), "wrld.ball", &instance) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(),
               contains("wrld.ball: game has no child \"wrld\" (did you mean \"world\"?)"));
    CHECK(fettle_hosted_find(game.get(), "world.ball.mass", &instance) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(),
               contains("world.ball.mass: expected an instance, got a property"));
    const auto mass = property(game, "world.ball.mass");
    CHECK(fettle_property_set_number(game.get(), mass, std::nan("")) == FETTLE_INVALID);
    bool truth = false;
    CHECK(fettle_property_get_boolean(game.get(), mass, &truth) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(),
               contains("world.ball.mass: expected a value of the type boolean"));
    fettle_property_id held = 0;
    CHECK(fettle_property_at(game.get(), "world.ball", &held) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("expected a property, got an instance"));
    value.type = 99;
    CHECK(fettle_hosted_set(game.get(), "world.ball.mass", &value) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("fettle_value_type"));
    // A list that contains itself.
    fettle_hosted_value inner[3];
    for (fettle_hosted_value& each : inner) {
        each = {};
        each.type = FETTLE_VALUE_LIST;
        each.count = 3;
        each.as.list = inner;
    }
    CHECK(fettle_hosted_set(game.get(), "world.ball.mass", inner) == FETTLE_INVALID);
}

TEST_CASE("a handle ends with its instance and with its release") {
    const Game game = make(ball);
    const auto mass = property(game, "world.ball.mass");
    const auto friction = property(game, "world.ball.circle.friction");
    double number = 0;
    require(fettle_property_release(game.get(), friction));
    CHECK(fettle_property_get_number(game.get(), friction, &number) == FETTLE_STALE);
    CHECK(fettle_property_release(game.get(), friction) == FETTLE_STALE);
    CHECK(property(game, "world.ball.circle.friction") != friction);
    const fettle_instance body = find(game, "world.ball");
    require(fettle_hosted_delete(game.get(), body));
    CHECK(fettle_property_get_number(game.get(), mass, &number) == FETTLE_STALE);
    CHECK_THAT(fettle_last_error(), contains("world.ball was deleted"));
    CHECK_FALSE(fettle_hosted_is_alive(game.get(), body));
    CHECK(fettle_hosted_delete(game.get(), body) == FETTLE_STALE);
    CHECK(fettle_hosted_delete(game.get(), 99) == FETTLE_STALE);  // a number that never was one
    CHECK(std::string(fettle_last_error()) == "fettle_hosted_delete: instance 99: there is none");
    CHECK(fettle_property_get_number(game.get(), 0, &number) == FETTLE_STALE);
    CHECK(fettle_property_get_number(game.get(), ~0ull, &number) == FETTLE_STALE);
}

TEST_CASE("instances are made and found and moved and listed") {
    const Game game = make(ball);
    fettle_hosted* const g = game.get();
    fettle_instance made = 0, found = 0;
    require(fettle_hosted_make(g, "Body", find(game, "world"), "box", &made));
    require(fettle_hosted_make(g, "Box", made, nullptr, nullptr));
    CHECK(find(game, "world.box") == made);
    const char* text = nullptr;
    require(fettle_hosted_path(g, made, &text));
    CHECK(text == std::string("world.box"));
    require(fettle_hosted_name(g, made, &text));
    CHECK(text == std::string("box"));
    require(fettle_hosted_class_of(g, made, &text));
    CHECK(text == std::string("Body"));
    bool is_a = true;
    require(fettle_hosted_is_a(g, made, "Shape", &is_a));
    CHECK_FALSE(is_a);
    require(fettle_hosted_parent(g, made, &found));
    CHECK(found == find(game, "world"));
    require(fettle_hosted_child(g, found, "ball", &found));
    CHECK(found == find(game, "world.ball"));
    require(fettle_hosted_child(g, found, "nobody", &found));
    CHECK(found == 0);
    require(fettle_hosted_move(g, made, find(game, "world"), "crate"));
    CHECK(find(game, "world.crate") == made);
    fettle_instance out[8];
    uint32_t count = 0;
    require(fettle_hosted_children(g, find(game, "world.crate"), out, 8, &count));
    CHECK(count == 1);
    CHECK(fettle_hosted_make(g, "Bdy", 0, nullptr, &made) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("did you mean \"Body\"?"));
}

TEST_CASE("classes and their members are listed and methods are called") {
    const Game game = make(ball);
    fettle_hosted* const g = game.get();
    uint32_t count = 0;
    require(fettle_hosted_classes(g, nullptr, 0, &count));
    std::vector<const char*> names(count);
    require(fettle_hosted_classes(g, names.data(), count, &count));
    CHECK(std::ranges::any_of(names, [](const char* name) { return name == std::string("Body"); }));
    std::vector<fettle_member> members(200);
    require(fettle_hosted_members(g, "Body", members.data(), 200, &count));
    members.resize(std::min(count, 200u));
    const auto member = [&](const char* name) {
        return *std::ranges::find_if(
            members, [&](const fettle_member& each) { return each.name == std::string(name); });
    };
    CHECK(member("mass").type == FETTLE_VALUE_NUMBER);
    CHECK(member("mass").unit == std::string("kg"));
    CHECK(member("apply_impulse").kind == FETTLE_MEMBER_METHOD);

    fettle_hosted_value impulse{};
    impulse.type = FETTLE_VALUE_VEC2;
    impulse.as.vec2[0] = 3 * number_at(g, "world.ball.mass");
    require(fettle_hosted_call_method(g, find(game, "world.ball"), "apply_impulse", &impulse, 1,
                                      nullptr));
    CHECK(number_at(g, "world.ball.velocity.x") == Approx(3));
    CHECK(fettle_hosted_call_method(g, find(game, "world.ball"), "aply_impulse", &impulse, 1,
                                    nullptr) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("did you mean \"apply_impulse\"?"));
}

TEST_CASE("changes and creations and deletions and events are reported to functions in C") {
    const Game game = make(ball);
    fettle_hosted* const g = game.get();
    std::vector<std::string> seen;
    fettle_connection watching = 0;
    const auto changed = [](void* user, const fettle_hosted_change* change) {
        static_cast<std::vector<std::string>*>(user)->push_back(
            change->property + std::string(" ") + std::to_string(int(change->old_value.as.number)) +
            " " + std::to_string(int(change->new_value.as.number)));
    };
    const auto existence = [](void* user, fettle_instance, const char* of, const char* path) {
        static_cast<std::vector<std::string>*>(user)->push_back(of + std::string(" ") + path);
    };
    const auto happened = [](void* user, const fettle_hosted_occurrence* occurrence) {
        static_cast<std::vector<std::string>*>(user)->push_back(
            occurrence->event + std::string(" ") + occurrence->fields[0]);
    };
    require(fettle_hosted_watch(g, "world.*.gravity_scale", changed, &seen, &watching));
    require(fettle_hosted_watch_made(g, "Body", existence, &seen, nullptr));
    require(fettle_hosted_watch_deleted(g, "Body", existence, &seen, nullptr));
    require(fettle_hosted_run(g, "world.ball.gravity_scale = 3", "start"));
    CHECK(seen.empty());
    require(fettle_hosted_barrier(g));
    CHECK(seen == std::vector<std::string>{"gravity_scale 1 3"});
    require(fettle_hosted_disconnect(g, watching));
    CHECK(fettle_hosted_disconnect(g, watching) == FETTLE_STALE);
    seen.clear();
    require(fettle_hosted_run(g, "world.ball.gravity_scale = 1", "start"));
    require(fettle_hosted_make(g, "Body", find(game, "world"), "floor", nullptr));
    require(fettle_hosted_barrier(g));
    CHECK(seen == std::vector<std::string>{"Body world.floor"});
    require(fettle_hosted_delete(g, find(game, "world.floor")));
    require(fettle_hosted_barrier(g));
    CHECK(seen.size() == 2);

    seen.clear();
    require(fettle_hosted_run(
        g, "world.floor = Body { Box { width = 20, height = 1 }, type = 'static' }", "start"));
    require(fettle_hosted_barrier(g));
    seen.clear();
    require(
        fettle_hosted_on(g, find(game, "world.ball"), "contact_begin", happened, &seen, nullptr));
    for (int i = 0; i < 120; ++i) require(fettle_hosted_step(g));
    REQUIRE_FALSE(seen.empty());
    CHECK(seen[0].starts_with("contact_begin "));
    CHECK(fettle_hosted_on(g, find(game, "world.ball"), "contact_begins", happened, &seen,
                           nullptr) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("contact_begin"));
    CHECK(fettle_hosted_on(g, find(game, "world.ball"), "contact_bgin", happened, &seen, nullptr) ==
          FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("did you mean \"contact_begin\"?"));
}

TEST_CASE("a handler that throws is an error of its barrier") {
    const Game game = make(ball);
    const auto throws = [](void*, const fettle_hosted_change*) {
        throw std::runtime_error("the watcher has failed");
    };
    const auto mass = property(game, "world.ball.gravity_scale");
    require(fettle_property_watch(game.get(), mass, throws, nullptr, nullptr));
    require(fettle_property_set_number(game.get(), mass, 2));
    CHECK(fettle_hosted_barrier(game.get()) == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("the watcher has failed"));
}

TEST_CASE("a game goes back and repeats the same future") {
    const Game game = make(std::string(ball) + " world.ball.restitution = 0.8");
    fettle_hosted* const g = game.get();
    for (int i = 0; i < 90; ++i) require(fettle_hosted_step(g));
    uint64_t hash = 0, again = 1;
    require(fettle_hosted_hash(g, &hash));
    int64_t step = 0, oldest = -1, newest = 0;
    require(fettle_hosted_rewind(g, 1));
    require(fettle_hosted_steps(g, &step, &oldest, &newest));
    CHECK(step == 30);
    CHECK(newest == 90);
    require(fettle_hosted_go_to(g, 90));
    require(fettle_hosted_hash(g, &again));
    CHECK(again == hash);
    CHECK(fettle_hosted_go_to(g, 1000) == FETTLE_INVALID);

    const void* bytes = nullptr;
    size_t size = 0;
    require(fettle_hosted_snapshot(g, &bytes, &size));
    std::vector<char> saved(static_cast<const char*>(bytes),
                            static_cast<const char*>(bytes) + size);
    for (int i = 0; i < 30; ++i) require(fettle_hosted_step(g));
    require(fettle_hosted_hash(g, &hash));
    require(fettle_hosted_restore(g, saved.data(), saved.size()));
    for (int i = 0; i < 30; ++i) require(fettle_hosted_step(g));
    require(fettle_hosted_hash(g, &again));
    CHECK(again == hash);
    // Where the game goes on from: the last step that is kept, before and after the next step.
    require(fettle_hosted_restore(g, saved.data(), saved.size()));
    for (int made = 0; made < 2; ++made) {
        require(fettle_hosted_steps(g, &step, &oldest, &newest));
        CHECK(step == 90 + made);
        CHECK(oldest == 0);
        CHECK(newest == step);
        require(fettle_hosted_go_to(g, newest));
        require(fettle_hosted_step(g));
    }
    for (int i = 0; i < 28; ++i) require(fettle_hosted_step(g));
    const Game other = make(ball);
    require(fettle_hosted_step(other.get()));
    require(fettle_hosted_restore(other.get(), saved.data(), saved.size()));
    require(fettle_hosted_steps(other.get(), &step, &oldest, &newest));
    CHECK(step == 90);
    CHECK(oldest == 90);
    CHECK(newest == 90);
    saved[saved.size() / 2] ^= 1;
    CHECK(fettle_hosted_restore(g, saved.data(), saved.size()) == FETTLE_INVALID);
    require(fettle_hosted_hash(g, &again));
    CHECK(again == hash);
}

}  // namespace tree_test
