#include "stage.h"

#include <stdexcept>

#include <fettle/property/path.h>

namespace stage {

using namespace fettle::property;

namespace {

ClassDescriptor world_class(Module& module) {
    ClassDescriptor c;
    c.name = "World";
    c.doc = "Where bodies live.";
    c.creatable = false;
    Property gravity{.name = "gravity",
                     .type = Type::vec2,
                     .default_value = Vec2(0, -10),
                     .unit = "m/s²",
                     .doc = "Pulls everything."};
    Property bounds{.name = "bounds", .type = Type::list, .doc = "Edges."};
    bounds.nullable = true;
    Property view{.name = "scale", .default_value = 1.0, .unit = "px/m"};
    c.properties = {gravity, bounds, view};
    static const std::vector<Field> hit = {{.name = "body", .type = Type::reference},
                                           {.name = "point", .type = Type::vec2},
                                           {.name = "fraction"},
                                           {.name = "note", .type = Type::text}};
    Method raycast;
    raycast.name = "raycast";
    raycast.parameters = {{.name = "from", .type = Type::vec2}, {.name = "to", .type = Type::vec2}};
    raycast.required = 2;
    raycast.returns = hit;
    raycast.doc = "The first body a ray meets.";
    raycast.call = [](void*, Tree& tree, Handle self, Row, std::span<const Value> a) -> Result {
        if (a[0].vec2() == a[1].vec2()) throw std::invalid_argument("the ray has no length");
        const Handle first = tree.first_child(self);
        if (!first) return Value();
        return Record{&hit, {first, Vec2((a[0].vec2() + a[1].vec2()) / 2), 0.5, Value()}};
    };
    Method all = raycast;
    all.name = "raycast_all";
    all.call = [](void*, Tree& tree, Handle self, Row, std::span<const Value>) -> Result {
        std::vector<Record> records;
        for (const Handle child : tree.children(self))
            records.push_back(Record{&hit, {child, Vec2(0, 0), 1.0, Value("x")}});
        return records;
    };
    c.methods = {raycast, all};
    (void)module;
    return c;
}

ClassDescriptor body_class(Module& module) {
    ClassDescriptor c;
    c.name = "Body";
    c.doc = "A thing that moves.";
    c.lifecycle.context = &module;
    c.lifecycle.create = [](void* m, Tree&, Handle) -> Row {
        auto& bodies = static_cast<Module*>(m)->bodies;
        bodies.emplace_back();
        return static_cast<Row>(bodies.size() - 1);
    };
    const auto of = [&](Native native, auto base) {
        return column(module, native, sizeof(Module::Body), base);
    };
    Property position{.name = "position", .type = Type::vec2, .unit = "m"};
    position.binding = of(Native::vec2d, [](Module& m) { return &m.bodies.data()->position; });
    position.simulated = true;
    Property velocity{.name = "velocity", .type = Type::vec2, .unit = "m/s"};
    velocity.binding = of(Native::vec2f, [](Module& m) { return &m.bodies.data()->velocity; });
    Property friction{.name = "friction",
                      .default_value = 0.6,
                      .range = {0, 10},
                      .doc = "How rough the surface is."};
    friction.binding = of(Native::f32, [](Module& m) { return &m.bodies.data()->friction; });
    friction.binding.invalidate = [](void* m, Row row) {
        ++static_cast<Module*>(m)->bodies[row].wakes;
    };
    Property type{.name = "type", .type = Type::text, .default_value = "dynamic"};
    type.enumerators = {"static", "kinematic", "dynamic"};
    type.binding = of(Native::enumeration, [](Module& m) { return &m.bodies.data()->type; });
    Property awake{.name = "awake", .type = Type::boolean, .default_value = true};
    awake.binding = of(Native::boolean, [](Module& m) { return &m.bodies.data()->awake; });
    Property serial{.name = "serial", .type = Type::integer};
    serial.binding = of(Native::i64, [](Module& m) { return &m.bodies.data()->serial; });
    Property color{.name = "color", .type = Type::color, .default_value = Color{1, 1, 1, 1}};
    color.binding = of(Native::color, [](Module& m) { return &m.bodies.data()->color; });
    Property mass{.name = "mass", .default_value = 1.0, .unit = "kg", .range = {0, INFINITY}};
    mass.infinity = true;
    mass.doc = "How hard it is to move.";
    mass.binding = accessor(
        module, [](Module& m, Row row) { return m.bodies[row].mass; },
        [](Module& m, Row row, const Value& v) { m.bodies[row].mass = v.as_double(); });
    Property energy{.name = "energy", .unit = "J"};
    energy.binding = accessor(module, [](Module& m, Row row) {
        const auto& b = m.bodies[row];
        return 0.5 * b.mass * (b.velocity[0] * b.velocity[0] + b.velocity[1] * b.velocity[1]);
    });
    Property target{.name = "target", .type = Type::reference};
    target.nullable = true;
    Property title{.name = "title", .type = Type::text};
    Property number{.name = "number"};
    number.infinity = true;
    Property counter{.name = "counter", .type = Type::integer};
    c.properties = {position, velocity, friction, type,  awake,  serial, color,
                    mass,     energy,   target,   title, number, counter};
    Method nudge;
    nudge.name = "nudge";
    nudge.parameters = {{.name = "by", .type = Type::vec2}, {.name = "times"}};
    nudge.required = 1;
    nudge.context = &module;
    nudge.call = [](void* m, Tree&, Handle, Row row, std::span<const Value> a) -> Result {
        const double times = a[1].is_nil() ? 1 : a[1].as_double();
        auto& b = static_cast<Module*>(m)->bodies[row];
        b.position[0] += a[0].vec2().x * times;
        b.position[1] += a[0].vec2().y * times;
        return Value();
    };
    c.methods = {nudge};
    c.events = {Event{
        .name = "contact_begin",
        .fields = {{.name = "other", .type = Type::reference}, {.name = "speed", .unit = "m/s"}},
        .doc = "It began to touch another."}};
    return c;
}

ClassDescriptor polygon_class(Module& module) {
    ClassDescriptor c;
    c.name = "Polygon";
    c.lifecycle.context = &module;
    c.lifecycle.create = [](void* m, Tree&, Handle) -> Row {
        auto& polygons = static_cast<Module*>(m)->polygons;
        polygons.emplace_back();
        return static_cast<Row>(polygons.size() - 1);
    };
    Property vertices{.name = "vertices", .type = Type::list, .unit = "m"};
    vertices.default_value = List{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    vertices.element = Type::vec2;
    vertices.binding = accessor(
        module,
        [](Module& m, Row row) {
            List list;
            for (const Vec2& v : m.polygons[row].vertices) list.emplace_back(v);
            return list;
        },
        [](Module& m, Row row, const Value& v) {
            if (v.list().size() < 3) throw std::invalid_argument("vertices: needs three vertices");
            m.polygons[row].vertices.clear();
            for (const Value& each : v.list()) m.polygons[row].vertices.push_back(each.vec2());
            ++m.polygons[row].rebuilds;
        });
    c.properties = {vertices};
    return c;
}

}  // namespace

void Module::attach(Tree& tree) {
    tree.define(world_class(*this));
    tree.define(body_class(*this));
    tree.define(polygon_class(*this));
    ClassDescriptor circle;
    circle.name = "Circle";
    circle.properties = {{.name = "radius", .default_value = 0.5, .unit = "m", .range = {0, 100}}};
    tree.define(circle);
}

Stage::Stage(fettle::script::Options options) {
    module.attach(*tree);
    world = tree->create(tree->class_named("World"), tree->root(), "world");
    runtime = std::make_unique<fettle::script::Runtime>(*tree, options);
    runtime->on_print([this](std::string_view text) { printed.emplace_back(text); });
    runtime->on_error([this](const ScriptError& error) { errors.push_back(error); });
}

Stage::~Stage() {
    runtime.reset();
    tree.reset();
}

void Stage::run(const std::string& chunk) {
    errors.clear();
    const bool ok = runtime->run(chunk, "main.lua");
    if (!ok) FAIL((errors.empty() ? std::string("no error reported") : errors.front().message));
}

std::string Stage::fails(const std::string& chunk) {
    errors.clear();
    const bool ok = runtime->run(chunk, "main.lua");
    CHECK_FALSE(ok);
    REQUIRE(errors.size() == 1);
    return errors.front().message;
}

std::string Stage::prints(const std::string& chunk) {
    printed.clear();
    run(chunk);
    return joined(printed);
}

void Stage::step(int count) {
    for (int i = 0; i < count; ++i) {
        tree->set_step(tree->step() + 1);
        tree->stepped();
        now += 1.0 / 60.0;
        runtime->step(now, 1.0 / 60.0);
        tree->barrier();
    }
}

std::string Stage::console(const std::string& command) {
    const Evaluation e = runtime->evaluate(command);
    if (e.incomplete) return "incomplete";
    if (!e.ok) return "error: " + (e.error ? e.error->message : std::string());
    return joined(e.lines);
}

Value Stage::get(const std::string& path) const {
    return fettle::property::get(*tree, path);
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "|") + line;
    return text;
}

}  // namespace stage
