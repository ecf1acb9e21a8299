// Events that classes of scripts declare and send.

#include "stage.h"

namespace own_events_test {

using stage::Stage;

namespace {

const std::string foe =
    "Foe = class('Foe', Object) { hits = 0, "
    "events = { 'died', hit = { by = 'nobody', damage = 1, from = vec(0, 0) } } }\n";

/// What the game has printed, joined with '|'.
std::string printed(const Stage& s) {
    std::string text;
    for (const std::string& line : s.printed) text += (text.empty() ? "" : "|") + line;
    return text;
}

}  // namespace

TEST_CASE("an event that a class declares reaches its function and all handlers with its data") {
    Stage s;
    s.run(foe +
          "function Foe:hit(event) self.hits = self.hits + event.damage end\n"
          "function Foe:died(event) print(event.instance.name .. ' died') end\n"
          "world.ogre, world.troll = Foe {}, Foe {}\n"
          "world.ogre:on('hit', function(event) print('ogre', event.by, event.damage, "
          "event.from, event.instance == world.ogre) end)\n"
          "Foe:on('hit', function(event) print('any', event.instance.name) end)");
    s.run(
        "world.ogre:send('hit', { by = 'an arrow', damage = 3, from = vec(1, 2) }) "
        "world.troll:send('hit') world.troll:send('died') print(world.ogre.hits)");
    s.step();
    CHECK(printed(s) == "0|ogre\tan arrow\t3\tvec(1, 2)\ttrue|any\togre|any\ttroll|troll died");
    CHECK(s.get("world.ogre.hits").as_double() == 3);
    CHECK(s.get("world.troll.hits").as_double() == 1);
}

TEST_CASE("classes that derive from a class have its events and those that they declare") {
    Stage s;
    s.run(foe +
          "Boss = class('Boss', Foe) { events = { roared = { loud = true } } }\n"
          "world.boss = Boss { hit = function(event) print('own', event.by) end }\n"
          "world.boss:on('roared', function(event) print('roared', event.loud) end)\n"
          "world.boss:send('hit') world.boss:send('roared', { loud = false })");
    s.step();
    CHECK(printed(s) == "own\tnobody|roared\tfalse");
}

TEST_CASE("an event of an instance that is deleted in the same step is not delivered") {
    Stage s;
    s.run(foe +
          "world.ogre = Foe { hit = function() print('hit') end } "
          "world.ogre:send('hit') world.ogre:delete()");
    s.step();
    CHECK(s.printed.empty());
    CHECK(s.errors.empty());
}

TEST_CASE("sending what a class does not declare is an error that says what there is") {
    const auto [code, reason] = GENERATE(table<std::string, std::string>({
        {"world.ogre:send('hti')",
         "world.ogre:send: Foe declares no event \"hti\" (did you mean \"hit\"?)"},
        {"world.ogre:send('vanished')", "declares no event \"vanished\"; it has died, hit"},
        {"world.ogre:send('hit', { form = vec(1, 1) })",
         "the event \"hit\" has no \"form\" (did you mean \"from\"?)"},
        {"world.ogre:send('hit', { damage = 'much' })",
         "world.ogre:send: hit.damage: expected an integer, got text \"much\""},
        {"world.ogre:send('hit', 3)",
         "expected a table with the values of \"hit\", got an integer"},
        {"world.ogre:send('deleted')", "only the framework sends \"deleted\""},
        {"world.ogre:send('ready')", "only the framework sends \"ready\""},
        {"world.ogre:send()", "send: needs the name of an event"},
        {"world:send('begun')", "World declares no event \"begun\"; a class of the game declares "},
        {"class('Bat', Object) { } world:add(Bat { }):send('bit')",
         "; declare it in the class: Bat = class(\"Bat\", Object) { events = { \"bit\" } }"},
        {"world.x = formula(function() world.ogre:send('died') return 1 end) print(world.x)",
         "it cannot call send"},
        {"class('A', Object) { lost = 1, events = { 'lost' } }", "the event \"lost\": A has that"},
        {"class('A', Foe) { events = { 'hit' } }", "the event \"hit\": A has that name already"},
        {"class('A', Object) { events = { 'step' } }", "A.events: step: every instance has that"},
        {"class('A', Object) { events = { 'on' } }", "A.events: on: every instance has that"},
        {"class('A', Object) { events = { 'a', 'a' } }", "A.events: a: is there twice"},
        {"class('A', Object) { events = { 'so loud' } }", "cannot be the name of an event"},
        {"class('A', Object) { events = { hit = { step = 1 } } }", "every event has that"},
        {"class('A', Object) { events = { hit = { f = print } } }", "expected a value"},
        {"class('Foe', Object) { hits = 0, events = { 'died' } }",
         "exists already with other events: the second has no \"hit\""},
    }));
    CAPTURE(code);
    Stage s;
    s.run(foe + "world.ogre = Foe { }");
    CHECK_THAT(s.fails(code), contains(reason));
}

TEST_CASE("a property called events that holds other things than names is a property") {
    Stage s;
    s.run(
        "Month = class('Month', Object) { events = { 1, 2 } } Day = class('Day', Object) { events "
        "= "
        "{} } world.month, world.day = Month { }, Day { } world.day.events = { 'rain' } "
        "print(#world.month.events, world.day.events[1])");
    CHECK(printed(s) == "2\train");
}

TEST_CASE("a restored game has the handlers of an event once") {
    Stage s;
    s.run(foe +
          "world.ogre = Foe { } function Foe:hit(event) self.hits = self.hits + event.damage end\n"
          "before = snapshot()");
    s.step();
    s.run("world.ogre:send('hit')");
    s.step();
    CHECK(s.get("world.ogre.hits").as_double() == 1);
    s.run("restore(before)");
    s.step();
    CHECK(s.get("world.ogre.hits").as_double() == 0);
    s.run("world.ogre:send('hit', { damage = 5 })");
    s.step();
    CHECK(s.get("world.ogre.hits").as_double() == 5);
}

}  // namespace own_events_test
