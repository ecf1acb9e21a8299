// States of classes, and variables of scripts that are properties of the game.

#include <fettle/property/path.h>
#include <fettle/property/snapshot.h>

#include "stage.h"

namespace state_test {

using stage::joined;
using stage::Stage;
using stage::Value;

namespace {

constexpr const char* door = R"lua(
Door = class("Door", Body) {
    current_state = "shut",
    states = {
        shut = {
            enter = function(self, from) print("enter shut from [" .. from .. "]") end,
            leave = function(self, to) print("leave shut to " .. to) end,
        },
        open = {
            enter = function(self, from) print("enter open from " .. from) end,
            step = function(self, dt) self.open_for = self.open_for + 1 end,
        },
    },
    open_for = 0,
}
world.door = Door {}
)lua";

}  // namespace

TEST_CASE("the first state is entered before the first step") {
    Stage s;
    s.run(door);
    CHECK(s.printed.empty());
    s.step(3);
    CHECK(joined(s.printed) == "enter shut from []");
    CHECK(s.get("world.door.current_state") == Value("shut"));
}

TEST_CASE("state leaves one state and enters the other at once") {
    Stage s;
    s.run(door);
    s.step();
    CHECK(s.prints("world.door:state('open') print(world.door:state())") ==
          "leave shut to open|enter open from shut|open");
    s.step(3);
    CHECK(s.get("world.door.open_for") == Value(3));
    CHECK(s.prints("world.door:state('open')") == "");
    CHECK_THAT(s.fails("world.door:state('opne')"),
               contains("world.door: Door has no state \"opne\" (did you mean \"open\"?)"));
    CHECK(s.get("world.door.current_state") == Value("open"));
    s.run("world.door:state('')");
    s.step(3);
    CHECK(s.get("world.door.open_for") == Value(3));
}

TEST_CASE("a state that is assigned is entered at the next step") {
    Stage s;
    s.run(door);
    s.step();
    s.printed.clear();
    CHECK(s.console("world.door.current_state = 'open'") != "");
    CHECK(s.printed.empty());
    s.step();
    CHECK(joined(s.printed) == "leave shut to open|enter open from shut");
    CHECK(s.get("world.door.open_for") == Value(1));
    s.errors.clear();
    for (const char* const write :
         {"world.door.current_state = 'wide'", "world.door['current_state'] = 'wide'"})
        CHECK_THAT(s.fails(write),
                   contains("world.door.current_state: Door has no state \"wide\""));
    CHECK_THAT(s.console("world.door.current_state = 'opne'"),
               contains("(did you mean \"open\"?)"));
    s.errors.clear();
    // A write that is no script's is an error in the next step.
    fettle::property::set(*s.tree, "world.door.current_state", Value("wide"));
    s.step(2);
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors[0].message, contains("Door has no state \"wide\""));
    CHECK(s.get("world.door.current_state") == Value("open"));
    CHECK(s.get("world.door.open_for") == Value(3));
}

TEST_CASE("a restore brings back the state and enters nothing") {
    Stage s;
    s.run(door);
    s.step(2);
    const auto taken = s.tree->snapshot();
    s.run("world.door:state('open')");
    s.step(2);
    s.printed.clear();
    s.tree->restore(taken);
    s.tree->barrier();
    s.step(2);
    CHECK(s.get("world.door.current_state") == Value("shut"));
    CHECK(s.get("world.door.open_for") == Value(0));
    CHECK(s.printed.empty());
}

TEST_CASE("a derived class adds states and replaces functions of its base") {
    Stage s;
    s.run(door);
    s.run(R"lua(
Gate = class("Gate", Door) {
    states = {
        open = { enter = function(self) print("gate opens") end },
        locked = { step = function(self) print("locked") self:state("shut") end },
    },
    current_state = "locked",
}
world.gate = Gate {}
world.door:delete()
)lua");
    s.step();
    CHECK(joined(s.printed) == "locked|enter shut from [locked]");
    s.printed.clear();
    s.run("world.gate:state('open')");
    s.step(2);
    CHECK(joined(s.printed) == "leave shut to open|gate opens");
    CHECK(s.get("world.gate.open_for") == Value(2));  // the step of the base
}

TEST_CASE("the last state that leave or enter set is the state afterwards") {
    Stage s;
    s.run(R"lua(
A = class("A", Object) { current_state = "a", states = {
    a = { leave = function(self) if self:state() == "b" then self:state("c") end end },
    b = { enter = function() print("b") end },
    c = { enter = function(self) print("c") self:state("d") end },
    d = { enter = function(self) print("d") self:delete() end, step = function() print("no") end },
} }
world.a = A {}
)lua");
    s.step();
    s.run("local a = world.a a:state('b')");
    s.step(2);
    CHECK(joined(s.printed) == "c|d");
    CHECK(s.errors.empty());
}

TEST_CASE("functions of states are replaced while the game runs") {
    Stage s;
    s.run(door);
    s.run("world.door:state('open') function Door.states.open:step() print('new') end");
    s.step();
    CHECK(s.printed.back() == "new");
    s.run(
        "Door.states = { shut = {}, open = {}, ajar = { enter = function() print('ajar') end } } "
        "world.door:state('ajar')");
    CHECK(s.printed.back() == "ajar");
}

TEST_CASE("invalid states are errors that name the place") {
    Stage s;
    CHECK_THAT(s.fails("class('A', Object) { states = { walk = { entr = print } } }"),
               contains("A.states.walk.entr: a state has enter, step and leave (did you mean "
                        "\"enter\"?)"));
    CHECK_THAT(s.fails("class('A', Object) { states = { walk = 3 } }"),
               contains("A.states.walk: expected a table"));
    CHECK_THAT(s.fails("class('A', Object) { states = { walk = { step = 3 } } }"),
               contains("A.states.walk.step: expected a function"));
    CHECK_THAT(s.fails("class('B', Object) { current_state = 'wlak', states = { walk = {} } }"),
               contains("there is no state \"wlak\" (did you mean \"walk\"?)"));
    CHECK_THAT(s.fails("class('C', Object) { current_state = 3, states = { walk = {} } }"),
               contains("has the name of a state there"));
    CHECK_THAT(s.fails("D = class('D', Object) {} D.states = { walk = {} }"),
               contains("the class declares no states"));
    s.run(
        "E = class('E', Object) { states = {1, 2} } world.e = E {} assert(world.e.states[2] == 2)");
}

TEST_CASE("states that call each other without end are an error and no crash") {
    Stage s;
    s.run(
        "A = class('A', Object) { states = { a = { enter = function(self) self:state('b') end }, "
        "b = { enter = function(self) self:state('a') end } } } world.a = A {}");
    CHECK_THAT(s.fails("world.a:state('a')"), contains("were entered by each other"));
    s.step(2);
}

TEST_CASE("a variable declared with state is a property of the game") {
    Stage s;
    CHECK(s.prints("print(state('score', 0)) score = score + 5 print(score, game.score)") ==
          "0|5\t5");
    CHECK(s.get("score") == Value(5));
    s.run("state('score', 0)");
    CHECK(s.get("score") == Value(5));
    CHECK(s.prints("game.score = 7 print(score)") == "7");
    CHECK(s.console("score = 8") != "");
    CHECK(s.get("score") == Value(8));
    const auto taken = s.tree->snapshot();
    s.run("score = 9 state('spot', vec(1, 2)) spot.x = 4");
    CHECK(s.prints("print(spot)") == "vec(4, 2)");
    s.tree->restore(taken);
    s.tree->barrier();
    CHECK(s.prints("print(score)") == "8");
}

TEST_CASE("a variable whose type state changes keeps its value and a note says so") {
    Stage s;
    std::vector<std::string> notes;
    s.runtime->on_note([&](std::string_view note) { notes.emplace_back(note); });
    s.run("state('best', 3) best = 7");
    s.run("state('best', 2.5)");
    CHECK(notes.empty());
    CHECK(s.prints("print(best)") == "7");
    s.run("state('best', 'none')");
    CHECK(s.prints("print(best)") == "7");
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], contains("game.best is 7 (integer) from before, and state(\"best\", ...) "
                                  "begins it as \"none\" (text) now: the old value stays"));
}

TEST_CASE("a state that a script adds later works like the others") {
    Stage s;
    s.run(door);
    s.step();
    s.run("Door.states.stuck = { enter = function(self) print('stuck') end }");
    CHECK(s.prints("world.door:state('stuck') print(world.door:state())") ==
          "leave shut to stuck|stuck|stuck");
    s.run("Door.states.stuck = nil");
    CHECK_THAT(s.fails("world.door:state('stuck')"), contains("Door has no state \"stuck\""));
}

TEST_CASE("a state is checked again when it is entered") {
    Stage s;
    s.run(door);
    s.step();
    s.run("Door.states.open.enter = 3");
    CHECK_THAT(s.fails("world.door:state('open')"),
               contains("Door.states.open.enter: expected a function, got an integer"));
    s.run("Door.states.open = { entr = print }");
    CHECK_THAT(s.fails("world.door:state('open')"), contains("did you mean \"enter\"?"));
    CHECK(s.prints("print(world.door:state())") == "shut");
}

TEST_CASE("states that enter each other without end are an error that names the instance") {
    Stage s;
    s.run(R"(
        Lamp = class("Lamp", Body) { current_state = "off", states = {
            off = { enter = function(self) self:state("on") end },
            on = { enter = function(self) self:state("off") end },
        } }
        world.lamp = Lamp {}
    )");
    CHECK_THAT(s.fails("world.lamp:state('on')"),
               contains("world.lamp: more than 40 states were entered by each other"));
    s.run("Lamp.states.off.enter = nil");
    CHECK(s.prints("world.lamp:state('on') print(world.lamp:state())") == "off");
}

TEST_CASE("names that a variable in the tree cannot have are refused") {
    Stage s;
    CHECK_THAT(s.fails("state('random', 0)"), contains("is a function of Fettle"));
    CHECK_THAT(s.fails("state('world', 0)"), contains("is a child of game"));
    CHECK_THAT(s.fails("state('Body', 0)"), contains("is a class"));
    CHECK_THAT(s.fails("state('step', 0)"), contains("is the name of a callback"));
    CHECK_THAT(s.fails("state('a b', 0)"), contains("is not a name for a variable"));
    CHECK_THAT(s.fails("state('name', 0)"), contains("is part of every game"));
    CHECK_THAT(s.fails("state('delete', 0)"), contains("is part of every game"));
    CHECK_THAT(s.fails("state('_ENV', 0)"), contains("is not a name for a variable"));
    CHECK_THAT(s.fails("state('it', 0)"), contains("has a meaning of its own in the console"));
    CHECK_THAT(s.fails("state('nothing')"), contains("needs a value to begin with"));
    CHECK_THAT(s.fails("state('fn', print)"), contains("state: fn"));
    CHECK_THAT(s.fails("mine = 3 state('mine', 0)"), contains("is a variable already"));
    CHECK_THAT(s.fails("state('score', 0) score = nil"), contains("cannot be nil"));
}

}  // namespace state_test
