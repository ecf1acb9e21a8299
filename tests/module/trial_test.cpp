// The process in which a module is tried out: the program that is started, and the game that the
// module finds there.

#include <catch.h>
#include <pthread.h>

#include <cstdlib>
#include <string>
#include <unordered_map>

#include <fettle/module/trial_program.h>

#include "weather.h"

namespace trial_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Row;
using property::Type;
using property::Value;

namespace {

/// While it lives, the program of trials is this one.
class ProgramAt {
  public:
    explicit ProgramAt(const std::string& file) { module::set_trial_program(file); }
    ~ProgramAt() { module::set_trial_program({}); }
    ProgramAt(const ProgramAt&) = delete;
};

/// The classes of a game that is written in C++.
struct Buoys {
    std::unordered_map<Row, double> depths;
    Row last = 0;
};

void define_buoys(property::Tree& tree, Buoys& buoys) {
    property::ClassDescriptor buoy;
    buoy.name = "Buoy";
    buoy.properties = {
        {.name = "depth",
         .default_value = 1.0,
         .unit = "m",
         .range = {0, 100},
         .binding = property::accessor(
             buoys, [](Buoys& b, Row row) { return b.depths[row]; },
             [](Buoys& b, Row row, const Value& v) { b.depths[row] = v.number(); })},
        {.name = "wear", .binding = property::accessor(buoys, [](Buoys&, Row) { return 7.0; })},
        {.name = "charge"},
        {.name = "neighbors",
         .type = Type::list,
         .element = Type::reference,
         .reference_class = "Buoy"}};
    const auto nothing = [](void*, property::Tree&, Handle, Row,
                            std::span<const Value>) -> property::Result {
        throw std::logic_error("a method of the game was called in a trial");
    };
    buoy.methods = {
        {.name = "spawn",
         .returns = {{.name = "made", .type = Type::reference, .reference_class = "Beacon"}},
         .call = nothing},
        {.name = "measure",
         .parameters = {{.name = "how", .type = Type::text}},
         .returns = {{.name = "depth"}, {.name = "ground", .type = Type::text}},
         .call = nothing}};
    buoy.events = {{.name = "rang", .fields = {{.name = "times", .type = Type::integer}}}};
    buoy.lifecycle.context = &buoys;
    buoy.lifecycle.create = [](void* context, property::Tree&, Handle) {
        auto& b = *static_cast<Buoys*>(context);
        b.depths[++b.last] = 1;
        return b.last;
    };
    tree.define(std::move(buoy));
    property::ClassDescriptor beacon;
    beacon.name = "Beacon";
    beacon.base = "Buoy";
    beacon.properties = {{.name = "depth", .default_value = 3.0}};
    tree.define(std::move(beacon));
}

}  // namespace

TEST_CASE("a module finds classes and instances and values of the game in its trial") {
    Buoys buoys;
    module::Plugins plugins;
    property::Tree tree;
    define_buoys(tree, buoys);
    const Handle one = tree.create(tree.class_named("Buoy"), tree.root(), "one");
    const Handle two = tree.create(tree.class_named("Beacon"), one, "two");
    tree.set(one, "depth", 5.0);
    tree.set(one, "neighbors", property::List{Value(two)});
    tree.set(two, "charge", 0.5);
    tree.set_or_add(one, "extra", 2.5);
    tree.set_step(12);
    int rang = 0;
    const auto connection = tree.on(one, *tree.class_of(one).event("rang"),
                                    [&](const property::Occurrence&) { ++rang; });
    CHECK_NOTHROW(plugins.open(built("visitor")).attach(tree));
    // What the module has changed there has not changed here.
    CHECK(tree.get(one, "depth") == Value(5.0));
    CHECK(buoys.last == 2);
    CHECK(tree.find_class("Visit") != nullptr);
    tree.set(one, "depth", 6.0);
    module::Plugins others;
    property::Tree other;
    CHECK_THROWS_WITH(others.open(built("visitor")).attach(other), contains("visitor: instances"));
}

TEST_CASE("a module is reloaded below and above instances of the game") {
    const ModuleFile file("weather");
    Buoys buoys;
    module::Plugins plugins;
    property::Tree tree;
    define_buoys(tree, buoys);
    module::Plugin& weather = plugins.open(file.path());
    weather.attach(tree);
    const Handle buoy = tree.create(tree.class_named("Beacon"), tree.root(), "buoy");
    const Handle cloud = tree.create(tree.class_named("Cloud"), buoy, "cloud");
    const Handle above = tree.create(tree.class_named("Buoy"), cloud, "above");
    tree.set(cloud, "water", 12.0);
    tree.set(cloud, "kind", "cirrus");
    tree.set(cloud, "label", "gray");
    file.become("other_layout");
    const module::Reloaded reloaded = weather.reload();
    CHECK(reloaded.instances == 2);
    CHECK(tree.get(cloud, "water") == Value(12.0));
    CHECK(tree.get(cloud, "kind") == Value("cirrus"));
    CHECK(tree.get(cloud, "label") == Value("gray"));
    CHECK(tree.parent(above) == cloud);
    file.become("crash_in_check");
    CHECK_THROWS_WITH(weather.reload(), contains("crashed (Segmentation fault) in its own test"));
    file.become("retyped");
    CHECK_THROWS_WITH(weather.reload(), contains("Cloud.water has another type than before"));
    CHECK(tree.get(cloud, "water") == Value(12.0));
}

TEST_CASE("no process of a trial is a copy of this one") {
    // In a copy, a lock that another thread held would never be released.
    static int copies = 0;
    REQUIRE(pthread_atfork([] { ++copies; }, nullptr, nullptr) == 0);
    const ModuleFile file("weather");
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& weather = plugins.open(file.path());
    weather.attach(tree);
    weather.reload();
    CHECK(copies == 0);
}

TEST_CASE("a missing program for trials is an error with the places") {
    {
        const ProgramAt nowhere("/nowhere/fettle-trial");
        const std::string reported = refusal(built("weather"));
        INFO(reported);
        CHECK(reported.starts_with(built("weather").string() + ": "));
        CHECK_THAT(reported, contains("expected it at /nowhere/fettle-trial; "));
        CHECK_THAT(reported, contains("FETTLE_TRIAL"));
        CHECK_THAT(reported, contains("set_trial_program"));
    }
    setenv("FETTLE_TRIAL", "/elsewhere/fettle-trial", 1);
    CHECK_THAT(refusal(built("weather")), contains("expected it at /elsewhere/fettle-trial; "));
    unsetenv("FETTLE_TRIAL");
    CHECK(refusal(built("weather")) == "");
    CHECK(module::trial_program_places().size() > 2);
}

TEST_CASE("another program in the place of that for trials is an error") {
    const ProgramAt other("/bin/true");
    CHECK_THAT(refusal(built("weather")),
               contains("/bin/true does not answer as fettle-trial does"));
    const ProgramAt folder("/bin");
    CHECK_THAT(refusal(built("weather")), contains("expected it at /bin; "));
}

}  // namespace trial_test
