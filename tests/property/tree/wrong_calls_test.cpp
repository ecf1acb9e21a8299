#include <functional>
#include <memory>
#include <optional>

#include <fettle/property/question.h>
#include <fettle/property/write_log.h>

#include "catch.h"
#include "fixture.h"

namespace wrong_calls_test {

// Wrong calls in C++: each gives an error with an explanation and changes nothing.

using namespace fettle::property;
using fettle::property::testing::BallModule;
using fettle::property::testing::message_of;

namespace {

Result do_nothing(void*, Tree&, Handle, Row, std::span<const Value>) {
    return Value();
}

/// A descriptor that is valid until `spoil` changes it.
std::string refusal(const std::function<void(ClassDescriptor&)>& spoil,
                    const std::string& base = "Object") {
    Tree tree;
    BallModule module(tree);
    ClassDescriptor described;
    described.name = "Crate";
    described.base = base;
    described.properties = {Property{.name = "width", .default_value = 1.0, .range = {0, 9}}};
    described.methods = {Method{.name = "open", .call = do_nothing}};
    described.events = {Event{.name = "opened"}};
    spoil(described);
    const std::string message = message_of([&] { tree.define(std::move(described)); });
    // A refused descriptor defines no class.
    REQUIRE((message.empty() || tree.find_class("Crate") == nullptr));
    return message;
}

std::string refused_property(Property property, const std::string& base = "Object") {
    return refusal([&](ClassDescriptor& d) { d.properties.push_back(std::move(property)); }, base);
}

}  // namespace

TEST_CASE("reading a value as another type is an error that names both types") {
    struct Accessor {
        Type type;
        std::function<void(const Value&)> read;
    };
    const std::vector<Accessor> accessors = {
        {Type::boolean, [](const Value& v) { (void)v.boolean(); }},
        {Type::integer, [](const Value& v) { (void)v.integer(); }},
        {Type::number, [](const Value& v) { (void)v.number(); }},
        {Type::text, [](const Value& v) { (void)v.text(); }},
        {Type::vec2, [](const Value& v) { (void)v.vec2(); }},
        {Type::color, [](const Value& v) { (void)v.color(); }},
        {Type::reference, [](const Value& v) { (void)v.reference(); }},
        {Type::list, [](const Value& v) { (void)v.list(); }},
    };
    const std::vector<Value> values = {Value(),        Value(true),         Value(3),
                                       Value(3.5),     Value("three"),      Value(Vec2(1, 2)),
                                       Value(Color{}), Value(Handle{4, 5}), Value(List{1, "two"})};
    for (const Value& value : values) {
        for (const Accessor& accessor : accessors) {
            const std::string message = message_of([&] { accessor.read(value); });
            INFO(type_name(value.type()) << " as " << type_name(accessor.type));
            if (value.type() == accessor.type) {
                CHECK(message.empty());
                continue;
            }
            CHECK_THAT(message, contains("of type " + std::string(type_name(value.type()))));
            CHECK_THAT(message, contains("read as " + std::string(type_name(accessor.type))));
        }
        if (!value.is_numeric())
            CHECK_THAT(message_of([&] { (void)value.as_double(); }), contains("read as number"));
    }
    CHECK(message_of([] { (void)Value(3.0).text(); }) ==
          "a value of type number (3) was read as text");
    Value moved = Value("gone");
    const Value taken = std::move(moved);
    CHECK_THAT(message_of([&] { (void)moved.text(); }), contains("of type nil"));
}

TEST_CASE("a text from a null pointer and lists of unlimited depth are refused") {
    const char* const nothing = nullptr;
    CHECK_THAT(message_of([&] { (void)Value(nothing); }), contains("null pointer"));
    Value nested;
    const std::string message = message_of([&] {
        for (int i = 0; i < 100'000; ++i) nested = Value(List{nested});
    });
    CHECK_THAT(message, contains("more than 64 deep"));
    CHECK(value_text(nested).size() > 64);
}

TEST_CASE("a class whose rows its base would use as its own is refused") {
    const auto with = [](const std::string& base, const std::function<void(Lifecycle&)>& set) {
        return refusal([&](ClassDescriptor& d) { set(d.lifecycle); }, base);
    };
    const auto makes = [](Lifecycle& rows) {
        rows.create = [](void*, Tree&, Handle) -> Row { return 12345; };
    };
    CHECK(with("Object", makes).empty());
    CHECK(with("Ball", makes) ==
          "class Crate: `lifecycle`: it inherits the property \"mass\" of Ball, which uses rows "
          "that the lifecycle of Ball makes: expected no lifecycle of its own, unless it makes "
          "such rows (`makes_base_rows`)");
    CHECK_THAT(with("Ball",
                    [](Lifecycle& rows) {
                        rows.draw = [](void*, const Tree&, Handle, Row, Painter&, double) {};
                    }),
               contains("`lifecycle`"));
    Tree tree;
    BallModule balls(tree);
    ClassDescriptor own{.name = "Own", .base = "Ball"};
    own.lifecycle = balls.type->lifecycle();
    own.makes_base_rows = true;
    const Class& made = tree.define(std::move(own));
    CHECK(tree.get(tree.create(made), "mass") == Value(1.0));
    CHECK_NOTHROW(tree.define({.name = "Plain", .base = "Ball"}));
    ClassDescriptor far{.name = "Far", .base = "Plain"};
    makes(far.lifecycle);
    CHECK_THAT(message_of([&] { tree.define(std::move(far)); }),
               contains("\"mass\" of Plain, which uses rows that the lifecycle of Ball makes"));
    // Methods get the row, too.
    ClassDescriptor doer{.name = "Doer"};
    makes(doer.lifecycle);
    doer.methods = {{.name = "act", .call = do_nothing}};
    tree.define(std::move(doer));
    ClassDescriptor other{.name = "Other", .base = "Doer"};
    makes(other.lifecycle);
    CHECK_THAT(message_of([&] { tree.define(std::move(other)); }),
               contains("it inherits the method \"act\" of Doer"));
    ClassDescriptor saved{.name = "Saved"};
    saved.snapshots = Snapshots::natively;
    tree.define(std::move(saved));
    ClassDescriptor never{.name = "Never", .base = "Saved"};
    never.snapshots = Snapshots::never;
    CHECK_THAT(message_of([&] { tree.define(std::move(never)); }),
               contains("Saved, from which it derives, is saved natively"));
    // A restore would forget the rows of such a class without `Lifecycle::destroy`.
    ClassDescriptor alone{.name = "Alone", .base = "Ball"};
    alone.snapshots = Snapshots::natively;
    CHECK(message_of([&] { tree.define(alone); }) ==
          "class Alone: `snapshots`: its rows are those of Ball, which is not saved natively: "
          "expected nothing, or a lifecycle of its own");
    alone.base = "Saved";
    CHECK_NOTHROW(tree.define(alone));
}

TEST_CASE("a class descriptor with an invalid or used name is refused by name") {
    CHECK(refusal([](ClassDescriptor&) {}).empty());
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.name = ""; }), contains("name of a class"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.name = "two words"; }), contains("two words"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.name = "Ball"; }), contains("already"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.base = "Bal"; }),
               contains("no class is called \"Bal\" (did you mean \"Ball\"?)"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.base = ""; }), contains("derives from no class"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.stem = "my crate"; }), contains("stem"));
    CHECK_THAT(refused_property({.name = ""}), contains("class Crate: property \"\""));
    CHECK_THAT(refused_property({.name = "a b"}), contains("letters, digits and underscores"));
    CHECK_THAT(refused_property({.name = "width"}),
               contains("property \"width\": it is declared twice"));
    CHECK_THAT(refused_property({.name = "grow"}, "Ball"), contains("Ball, from which it derives"));
    CHECK_THAT(refused_property({.name = "bounced"}, "Ball"), contains("an event of that name"));
    const auto with_method = [](const std::string& name, const std::string& base = "Object") {
        return refusal(
            [&](ClassDescriptor& d) { d.methods.push_back({.name = name, .call = do_nothing}); },
            base);
    };
    CHECK_THAT(with_method(""), contains("has no name"));
    CHECK_THAT(with_method("end"), contains("method \"end\""));
    CHECK_THAT(with_method("open"), contains("method \"open\": it is declared twice"));
    CHECK_THAT(with_method("width"), contains("the class has a property of that name"));
    CHECK_THAT(with_method("mass", "Ball"), contains("has a property of that name"));
    CHECK_THAT(with_method("name"), contains("Object, from which it derives"));
    CHECK(with_method("grow", "Ball").empty());  // a derived class may override a method
    const auto with_event = [](const std::string& name, const std::string& base = "Object") {
        return refusal([&](ClassDescriptor& d) { d.events.push_back({.name = name}); }, base);
    };
    CHECK_THAT(with_event(""), contains("has no name"));
    CHECK_THAT(with_event("opened"), contains("event \"opened\": it is declared twice"));
    CHECK_THAT(with_event("open"), contains("the class has a method of that name"));
    CHECK_THAT(with_event("bounced", "Ball"), contains("has that event already"));
    CHECK_THAT(with_event("deleted"), contains("has that event already"));
    CHECK_THAT(refusal([](ClassDescriptor& d) {
                   d.events[0].fields = {{.name = "by"}, {.name = "by"}};
               }),
               contains("\"by\" is there twice"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.methods[0].parameters = {{.name = ""}}; }),
               contains("a parameter has no name"));
}

TEST_CASE("a class descriptor with a member without functions or memory is refused by name") {
    Property made{.name = "made"};
    made.binding.kind = BindingKind::accessor;
    CHECK_THAT(refused_property(made), contains("property \"made\": its accessor has no `get`"));
    made.binding.kind = BindingKind::column;
    CHECK_THAT(refused_property(made), contains("its column has no `base`"));
    made.binding.base = [](void*) -> std::byte* { return nullptr; };
    made.binding.stride = 8;
    made.type = Type::text;
    CHECK_THAT(refused_property(made), contains("of type number, and it is of type text"));
    made.binding.native = Native::enumeration;
    CHECK_THAT(refused_property(made), contains("needs 1 to 256 enumerators"));
    made.enumerators = {"a", "b", "a"};
    CHECK_THAT(refused_property(made), contains("the enumerator \"a\" is there twice"));
    made.enumerators = {"a", ""};
    CHECK_THAT(refused_property(made), contains("the enumerator \"\" has no name"));
    made.enumerators = {"a", "b"};
    made.nullable = true;
    CHECK_THAT(refused_property(made), contains("a column cannot hold nil"));
    made = {.name = "made"};
    made.binding.kind = BindingKind::node;
    CHECK_THAT(refused_property(made), contains("no `node_get`"));
    made.binding.kind = BindingKind::ad_hoc;
    CHECK_THAT(refused_property(made), contains("what users add"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.methods[0].call = nullptr; }),
               contains("method \"open\": it has no `call`"));
    CHECK_THAT(refusal([](ClassDescriptor& d) { d.methods[0].required = 2; }),
               contains("2 of its 0 parameters are required"));
}

TEST_CASE("a class descriptor with contradictory values is refused by name") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(refused_property({.name = "x", .range = {2, 1}}),
               contains("property \"x\": its range begins at 2 and ends at 1"));
    CHECK_THAT(refused_property({.name = "x", .range = {nan, 1}}), contains("range begins at nan"));
    CHECK_THAT(refused_property({.name = "x", .default_value = 12.0, .range = {0, 9}}),
               contains("class Crate: default of x"));
    CHECK_THAT(
        refused_property({.name = "x", .range = {1, 9}}),
        contains("class Crate: default of x"));  // the default is missing, and 0 is out of range
    CHECK_THAT(refused_property({.name = "x", .default_value = "wide"}), contains("default of x"));
    CHECK_THAT(refused_property({.name = "x", .default_value = nan}), contains("default of x"));
    CHECK_THAT(
        refused_property(
            {.name = "x", .type = Type::text, .default_value = "c", .enumerators = {"a", "b"}}),
        contains("default of x"));
    CHECK_THAT(refused_property({.name = "x", .enumerators = {"a"}}),
               contains("enumerators are for a text"));
    CHECK_THAT(refused_property({.name = "x", .type = Type::text, .range = {0, 1}}),
               contains("a range is for numbers"));
    CHECK_THAT(refused_property({.name = "x", .element = Type::number}),
               contains("elements are of a list"));
    CHECK_THAT(refused_property({.name = "x", .reference_class = "Ball"}),
               contains("class of references"));
    CHECK_THAT(refused_property({.name = "x", .type = Type::nil}), contains("of no type"));
}

TEST_CASE("a derived class may change only the default of an inherited property") {
    CHECK(
        refused_property({.name = "radius", .default_value = 3.0, .doc = "Wide."}, "Ball").empty());
    CHECK_THAT(refused_property({.name = "radius", .type = Type::text}, "Ball"),
               contains("Ball declares it"));
    CHECK_THAT(refused_property({.name = "radius", .range = {0, 5}}, "Ball"),
               contains("another default and another text of help"));
    CHECK_THAT(refused_property({.name = "radius", .default_value = 101.0}, "Ball"),
               contains("default of radius"));
    CHECK_THAT(refused_property({.name = "area", .default_value = 3.0}, "Ball"),
               contains("a value that has no default"));
    CHECK_THAT(refused_property({.name = "name", .type = Type::text, .default_value = "bob"}),
               contains("a value that has no default"));
    Tree tree;
    BallModule module(tree);
    tree.define(
        {.name = "Told", .base = "Ball", .properties = {{.name = "mass", .doc = "Heavy."}}});
    CHECK(tree.class_named("Told").property("mass")->default_value == Value(1.0));
    // The module refuses a default after an instance was created: the instance is removed.
    tree.define({.name = "Unlucky",
                 .base = "Ball",
                 .properties = {{.name = "radius", .default_value = 13.0}}});
    const std::size_t before = tree.size();
    CHECK_THROWS_AS(tree.create(tree.class_named("Unlucky"), tree.root()), std::exception);
    CHECK(tree.size() == before);
    CHECK(module.destroyed == 1);
    CHECK_FALSE(tree.child(tree.root(), "unlucky_1"));
    CHECK(tree.alive(tree.create(*module.type, tree.root())));
}

TEST_CASE("members of another class or another tree are refused") {
    Tree tree, other;
    BallModule module(tree), elsewhere(other);
    const Class& crate = tree.define({.name = "Crate",
                                      .properties = {{.name = "width"}},
                                      .methods = {{.name = "open", .call = do_nothing}},
                                      .events = {{.name = "opened"}}});
    const Handle ball = tree.create(*module.type, tree.root(), "ball");
    const Handle box = tree.create(crate, tree.root(), "box");
    const Property& width = *crate.property("width");
    const Property& mass = *elsewhere.type->property("mass");
    Property unregistered{.name = "mass"};
    for (const Property* property : std::vector<const Property*>{&width, &mass, &unregistered}) {
        const auto refused = [&](const std::function<void()>& act) {
            CHECK_THAT(message_of(act), contains("the property \"" + property->name + "\" is of"));
        };
        refused([&] { tree.get(ball, *property); });
        refused([&] { tree.peek(ball, *property); });
        refused([&] { tree.set(ball, *property, 2.0); });
        refused([&] { tree.reset(ball, *property); });
        refused([&] { tree.overridden(ball, *property); });
        refused([&] { tree.watch(ball, *property, [](const Change&) {}); });
        refused(
            [&] { tree.set_formula(ball, *property, {[](const Tree&) { return Value(1.0); }}); });
        refused([&] { tree.remove_formula(ball, *property); });
        refused([&] { tree.problem(ball, *property); });
        refused([&] { tree.why(ball, *property); });
        refused([&] { tree.last_writer(ball, *property); });
    }
    CHECK_THAT(message_of([&] { tree.get(ball, mass); }), contains("of Ball of another tree"));
    CHECK_THAT(message_of([&] { tree.call(ball, *crate.method("open"), {}); }),
               contains("no such method"));
    CHECK_THAT(message_of([&] { tree.on(ball, *crate.event("opened"), [](const Occurrence&) {}); }),
               contains("no such event"));
    CHECK_THAT(message_of([&] { tree.create(*elsewhere.type, tree.root()); }),
               contains("class Ball belongs to another tree"));
    CHECK_THAT(message_of([&] { tree.watch_created(*elsewhere.type, [](const Existence&) {}); }),
               contains("belongs to another tree"));
    CHECK_THAT(message_of([&] { tree.watch_deleted(*elsewhere.type, [](const Existence&) {}); }),
               contains("belongs to another tree"));
    CHECK_THAT(message_of([&] { tree.watch(crate, &mass, [](const Change&) {}); }),
               contains("no such property"));
    const Event& bounced = *module.type->event("bounced");
    CHECK_THAT(message_of([&] { tree.on(crate, bounced, [](const Occurrence&) {}); }),
               contains("Crate has no such event"));
    const Connection heard = tree.on(ball, bounced, [](const Occurrence&) {});
    CHECK_THAT(message_of([&] { tree.emit(box, bounced, {1.0}); }), contains("no such event"));
    CHECK_THAT(message_of([&] { tree.emit(ball, bounced, {}); }), contains("it has 1 values"));
    // An inherited member belongs to the instance.
    CHECK(tree.get(ball, *tree.object_class().property("name")) == Value("ball"));
}

TEST_CASE("watching without a function is refused at once") {
    Tree tree;
    BallModule module(tree);
    const Handle ball = tree.create(*module.type, tree.root(), "ball");
    const auto refused = [&](const std::function<void()>& act) {
        CHECK_THAT(message_of(act), contains("function"));
    };
    refused([&] { tree.watch(ball, "mass", {}); });
    refused([&] { tree.watch(ball, ChangeHandler()); });
    refused([&] { tree.watch(*module.type, nullptr, {}); });
    refused([&] { tree.watch_pattern("ball.*", {}); });
    refused([&] { tree.watch_created(*module.type, {}); });
    refused([&] { tree.watch_deleted(ball, ExistenceHandler()); });
    refused([&] { tree.watch_deleted(*module.type, {}); });
    refused([&] { tree.on(ball, *module.type->event("bounced"), {}); });
    refused([&] { tree.at_barrier({}); });
    refused([&] { tree.set_formula(ball, "mass", {}); });
    CHECK(tree.watcher_count() == 0);
}

TEST_CASE("connections and logs may outlive their tree") {
    auto tree = std::make_unique<Tree>();
    const Handle node = tree->create(tree->object_class(), tree->root(), "node");
    Connection plain = tree->watch(node, [](const Change&) {});
    auto scoped = std::make_unique<ScopedConnection>(tree->watch(node, [](const Change&) {}));
    auto log = std::make_unique<WriteLog>(*tree);
    const Snapshot snapshot = tree->snapshot();
    const std::weak_ptr<const Tree*> life = tree->lifetime();
    CHECK_FALSE(life.expired());
    const Value kept = tree->get(node, "name");
    tree.reset();
    CHECK(life.expired());
    CHECK_FALSE(plain.active());
    plain.stop();
    plain.stop();
    scoped.reset();
    log.reset();
    CHECK(kept.text() == "node");
    CHECK(snapshot.step() == 0);
}

TEST_CASE("the record of an event may outlive the tree") {
    auto tree = std::make_unique<Tree>();
    tree->define({.name = "Gong",
                  .events = {{.name = "rang", .fields = {{.name = "loudness"}, {.name = "n"}}}}});
    const Class& gong = tree->class_named("Gong");
    const Handle one = tree->create(gong, tree->root(), "one");
    Record told, asked;
    tree->on(one, *gong.event("rang"), [&](const Occurrence& occurrence) {
        (Question::current() == nullptr ? told : asked) = occurrence.record;
    });
    tree->emit(one, *gong.event("rang"), {1.5, 2.0});
    tree->barrier();
    std::vector<Value> values{2.5, 3.0};
    call_handlers(*tree, one, *gong.event("rang"), values, 0);
    tree.reset();
    const std::string refill(4096, 'x');  // takes the place of what was freed
    CHECK(told.get("loudness") == Value(1.5));
    CHECK(asked.get("n") == Value(3.0));
    REQUIRE(told.fields->size() == 2);
    CHECK(told.fields->front().name == "loudness");
    // Trees with the same fields share them, so that nothing grows with the number of trees.
    Tree next;
    next.define({.name = "Bell",
                 .events = {{.name = "rang", .fields = {{.name = "loudness"}, {.name = "n"}}}}});
    CHECK(next.class_named("Bell").event("rang")->record_fields == told.fields);
}

TEST_CASE("a handler that owns the connection of another one ends with the tree") {
    Tree tree;
    const Handle node = tree.create(tree.object_class(), tree.root(), "node");
    for (int i = 0; i < 50; ++i) {
        auto held = std::make_shared<ScopedConnection>(tree.watch(node, [](const Change&) {}));
        tree.watch(node, [held](const Change&) {});
    }
    REQUIRE(tree.watcher_count() == 100);
}

TEST_CASE("a handler or an action or a method may destroy the tree that calls it") {
    const auto says_so = [](const std::function<void()>& act) {
        CHECK_THAT(message_of(act),
                   contains("the tree was destroyed by a function that it called"));
    };
    for (const bool by_action : {false, true}) {
        auto owned = std::make_unique<Tree>();
        Tree* const tree = owned.get();
        const Handle node = tree->create(tree->object_class(), tree->root(), "node");
        int calls = 0;
        Connection connection;
        const auto destroy = [&] {
            ++calls;
            owned.reset();
        };
        if (by_action) {
            tree->at_barrier(destroy);
            tree->at_barrier([&] { ++calls; });
        } else {
            connection = tree->watch(node, [&](const Change&) { destroy(); });
            tree->watch(node, [&](const Change&) { ++calls; });
            tree->set_or_add(node, "speed", 3);
            tree->set_or_add(node, "width", 3);
        }
        says_so([&] { tree->barrier(); });
        CHECK(calls == 1);
        CHECK_FALSE(connection.active());
    }
    {
        auto owned = std::make_unique<Tree>();
        Tree* const tree = owned.get();
        static std::unique_ptr<Tree>* to_destroy = &owned;
        to_destroy = &owned;
        const Class& bomb = tree->define(
            {.name = "Bomb",
             .methods = {{.name = "explode",
                          .call = [](void*, Tree&, Handle, Row, std::span<const Value>) -> Result {
                              to_destroy->reset();
                              return Value(1);
                          }}}});
        const Handle one = tree->create(bomb, tree->root(), "bomb");
        says_so([&] { tree->call(one, "explode", {}); });
        CHECK(owned == nullptr);
    }
    {
        // The exception of the handler has priority.
        auto owned = std::make_unique<Tree>();
        Tree* const tree = owned.get();
        const Handle node = tree->create(tree->object_class(), tree->root(), "node");
        tree->on_handler_error([](const HandlerError&) {});
        tree->watch(node, [&](const Change&) {
            owned.reset();
            throw std::runtime_error("and now");
        });
        tree->set_or_add(node, "speed", 3);
        CHECK_THROWS_WITH(tree->barrier(), contains("and now"));
    }
}

TEST_CASE(
    "a handler that stops itself while a question calls it inside of another handler stays valid") {
    Tree tree;
    BallModule module(tree);
    const Handle ball = tree.create(*module.type, tree.root(), "ball");
    const Event& bounced = *module.type->event("bounced");
    std::string said;
    Connection asked = tree.on(ball, bounced, [&](const Occurrence&) { said += "asked "; });
    Connection outer;
    std::string kept(100, 'x');
    outer = tree.watch(ball, "mass", [&, kept](const Change&) {
        outer.stop();
        std::vector<Value> values = {1.0};
        call_handlers(tree, ball, bounced, values, 0);
        said += kept.substr(0, 3);  // its captures still exist
    });
    tree.set(ball, "mass", 2.0);
    tree.barrier();
    CHECK(said == "asked xxx");
    asked.stop();
    CHECK(tree.watcher_count() == 0);
}

}  // namespace wrong_calls_test
