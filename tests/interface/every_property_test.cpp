// Every property of every class of widgets: any value is accepted or refused. An accepted value can
// be drawn and is kept by snapshots.

#include <cmath>
#include <limits>

#include "screen.h"

namespace every_property_test {

using namespace fettle::interface::test;

namespace {

const char* const classes[] = {"Panel", "Row",    "Column", "List",      "Button",      "Label",
                               "Image", "Slider", "Toggle", "TextField", "ProgressBar", "Theme"};

std::vector<Value> values_for(const Property& property) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::vector<Value> all{Value(),
                           Value(true),
                           Value(7),
                           Value(-3),
                           Value(std::numeric_limits<std::int64_t>::max()),
                           Value(-1.5),
                           Value(1e300),
                           Value(std::nan("")),
                           Value(inf),
                           Value(""),
                           Value("no such thing"),
                           Value(std::string(300, 'x') + "\n\xff\xc3"),
                           Value(Vec2(1e9, -1e9)),
                           Value(Vec2(300, 0)),
                           Value(Vec2(std::nan(""), inf)),
                           Value(Color{0.5f, 2, -1, 0.5f}),
                           Value(Color{0.1f, 0.2f, 0.3f, 0.4f}),
                           Value(List{}),
                           Value(List{Value("a"), Value("b")}),
                           Value(List{Value("a"), Value(3)})};
    if (property.range.bounded())
        for (const double end : {property.range.min, property.range.max}) {
            all.emplace_back(end);
            all.emplace_back(Vec2(end, end));
        }
    for (const std::string& name : property.enumerators) all.emplace_back(name);
    return all;
}

struct Room : Screen {
    Room() {
        const Handle panel = tree.create(tree.class_named("Panel"), tree.root(), "stage");
        for (const char* of : classes) tree.create(tree.class_named(of), panel);
        turn();
    }
    std::vector<std::pair<const Property*, Value>> state(Handle of) {
        std::vector<std::pair<const Property*, Value>> all;
        for (const Property* property : tree.properties(of))
            if (!property->read_only && !property->transient)
                all.emplace_back(property, tree.get(of, *property));
        return all;
    }
    std::vector<Handle> things() { return tree.children(at("stage")); }
};

}  // namespace

TEST_CASE_METHOD(Room, "any value is refused or can be drawn and is kept by snapshots") {
    std::size_t taken = 0;
    for (const Handle thing : things())
        for (const Property* property : tree.properties(thing)) {
            if (property->read_only || property->binding.kind == BindingKind::node) continue;
            for (const Value& value : values_for(*property)) {
                INFO(tree.path(thing, *property) << " = " << tree.text(value));
                try {
                    tree.set(thing, *property, value);
                    ++taken;
                } catch (const Error&) {
                    continue;
                }
                turn();
                const auto before = state(thing);
                draw();
                const Snapshot snapshot = Snapshot::from_bytes(tree.snapshot().to_bytes());
                tree.reset(thing, *property);
                turn();
                tree.restore(snapshot);
                CHECK(state(thing) == before);
            }
            tree.reset(thing, *property);
        }
    CHECK(taken > 400);
    CHECK(errors.empty());
}

TEST_CASE_METHOD(Room, "every property begins with its default and can be explained") {
    for (const Handle thing : things())
        for (const Property* property : tree.properties(thing)) {
            INFO(tree.path(thing, *property));
            CHECK(property->doc.size() > 4);
            CHECK(property->doc.back() == '.');
            if (property->read_only || property->binding.kind == BindingKind::node) continue;
            CHECK(tree.get(thing, *property) == property->default_value);
        }
    for (const char* of : classes)
        for (const Event* event : tree.class_named(of).events()) CHECK(event->doc.back() == '.');
}

TEST_CASE_METHOD(Room, "deleting widgets while they are used does no harm") {
    for (const Handle thing : things()) {
        if (tree.find(thing, "screen_position") != nullptr) {
            set("interface.focus", Value(thing));
            const Vec2 corner = tree.get(thing, "screen_position").vec2();
            point(corner + Vec2(2, 2));
            set("input.mouse.left", true);
            turn();
        }
        tree.destroy(thing);
        set("input.mouse.left", false);
        turn();
        draw();
    }
    run("game.interface.theme = nil");
    run("game.l = Label { text = 'still here' }");
    turn();
    CHECK(draw().pictures_drawn > 5);
    set("input.keys.tab", true);
    turn();
    CHECK(draw().pictures_drawn > 5);
    CHECK(errors.empty());
}

TEST_CASE("the widgets end with the interface or with the tree") {
    fettle::visuals::Visuals visuals(nullptr);
    Tree tree;
    auto interface = std::make_unique<fettle::interface::Interface>(visuals.media());
    interface->attach(tree);
    const Handle panel = tree.create(tree.class_named("Panel"), tree.root(), "panel");
    CHECK_THROWS_AS(interface->attach(tree), std::logic_error);
    interface.reset();
    CHECK_FALSE(tree.alive(panel));
    CHECK_THROWS_AS(tree.create(tree.class_named("Button"), tree.root(), "b"), Error);
    fettle::interface::Interface longer(visuals.media());
    {
        Tree other;
        longer.attach(other);
        other.create(other.class_named("Button"), other.root(), "b");
    }
    Paper paper;
    longer.frame({0, 0}, {100, 100}, 0.1);
    longer.draw(paper);
    CHECK(paper.drawn == 0);
}

}  // namespace every_property_test
