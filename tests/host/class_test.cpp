#include <string>

#include "catch.h"
#include "hosted.h"

namespace class_test {

using namespace hosted;

namespace {

fettle_property_def number_property(const char* name, double value) {
    fettle_property_def made{};
    made.name = name;
    made.type = FETTLE_VALUE_NUMBER;
    made.unit = "N";
    made.doc = "How hard it pulls.";
    made.default_value = hosted::number(value);
    made.min = 0;
    made.max = 100;
    return made;
}

fettle_code pull(void* user, fettle_instance self, const fettle_hosted_value* arguments,
                 uint32_t count, fettle_hosted_value* result) {
    auto* const game = static_cast<fettle_hosted*>(user);
    if (count < 1 || arguments[0].as.number < 0) {
        *result = hosted::text("a magnet does not push");
        return FETTLE_INVALID;
    }
    const fettle_hosted_value by = hosted::number(arguments[0].as.number);
    if (fettle_hosted_emit(game, self, "pulled", &by, 1) != FETTLE_DONE) return FETTLE_FAILED;
    *result = hosted::number(2 * by.as.number);
    return FETTLE_DONE;
}

struct Magnet {
    explicit Magnet(fettle_hosted* game) {
        require(fettle_class_def_init(&def, sizeof def));
        def.name = "Magnet";
        def.doc = "Pulls.";
        def.properties = &strength;
        def.property_count = 1;
        def.methods = &method;
        def.method_count = 1;
        def.events = &pulled;
        def.event_count = 1;
        method.user = game;
    }
    Magnet(const Magnet&) = delete;

    fettle_property_def strength = number_property("strength", 20);
    fettle_parameter_def by{"by", "N", "How hard.", FETTLE_VALUE_NUMBER};
    fettle_method_def method{"pull", "Pulls once.", &by, 1, 1, pull, nullptr};
    fettle_event_def pulled{"pulled", "It has pulled.", &by, 1};
    fettle_class_def def;
};

}  // namespace

TEST_CASE("a class of the program has values and methods and events in scripts and in the past") {
    const Game game = make();
    fettle_hosted* const g = game.get();
    const Magnet magnet(g);
    require(fettle_hosted_define(g, &magnet.def));
    require(fettle_hosted_run(g,
                              "world.iron = Magnet { strength = 3 } game.sum = 0 "
                              "world.iron:on('pulled', function(e) game.sum = game.sum + e.by end)",
                              "start"));
    CHECK(number_at(g, "world.iron.strength") == 3);
    for (int i = 0; i < 10; ++i) require(fettle_hosted_step(g));
    fettle_hosted_value result;
    require(fettle_hosted_evaluate(g, "world.iron:pull(4)", &result, nullptr));
    CHECK(result.as.number == 8);
    require(fettle_hosted_run(g, "world.iron.strength = 50", "start"));
    require(fettle_hosted_step(g));
    CHECK(number_at(g, "sum") == 4);
    require(fettle_hosted_go_to(g, 5));
    CHECK(number_at(g, "world.iron.strength") == 3);
    CHECK(fettle_hosted_evaluate(g, "world.iron:pull(-1)", nullptr, nullptr) == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("a magnet does not push"));
    const fettle_hosted_value much = hosted::number(101);
    CHECK(fettle_hosted_set(g, "world.iron.strength", &much) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("world.iron.strength: expected"));
}

TEST_CASE("a class that is wrong is refused and changes nothing") {
    const Game game = make();
    fettle_hosted* const g = game.get();
    Magnet magnet(g);
    magnet.def.base = "Objekt";
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("Objekt"));
    magnet.def.base = nullptr;
    magnet.strength.default_value = hosted::number(-5);
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("strength"));
    magnet.strength.default_value = hosted::number(5);
    magnet.method.required = 2;
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("required = 2"));
    magnet.method.required = 1;
    magnet.by.type = 42;
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    magnet.by.type = FETTLE_VALUE_NUMBER;
    magnet.def.size = 4;
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    magnet.def.size = sizeof magnet.def;
    require(fettle_hosted_define(g, &magnet.def));
    CHECK(fettle_hosted_define(g, &magnet.def) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("Magnet"));
}

TEST_CASE("a property whose name is nearly one of the base class is refused") {
    const Game game = make();
    const auto define = [&](const char* base, const char* name) {
        fettle_property_def property = number_property(name, 1);
        fettle_class_def def;
        require(fettle_class_def_init(&def, sizeof def));
        def.name = "Near";
        def.base = base;
        def.properties = &property;
        def.property_count = 1;
        return fettle_hosted_define(game.get(), &def);
    };
    for (const char* name : {"gravity_scal", "Mass", "linear_dampin"}) {
        INFO(name);
        CHECK(define("Body", name) == FETTLE_INVALID);
    }
    CHECK(std::string(fettle_last_error()) ==
          "fettle_hosted_define: Near.linear_dampin: Body has no such property (did you mean "
          "\"linear_damping\"?)");
    CHECK(define(nullptr, "Name") == FETTLE_INVALID);
    CHECK(define("Body", "strength") == FETTLE_DONE);
}

}  // namespace class_test
