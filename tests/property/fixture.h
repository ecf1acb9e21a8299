#pragma once
// A small module with its own memory, for tests of the tree: balls in an array of structs.

#include <stdexcept>
#include <vector>

#include <fettle/property/path.h>
#include <fettle/property/tree.h>

namespace fettle::property::testing {

struct Ball {
    float mass = 1;
    float velocity[2] = {0, 0};
    double charge = 0;
    std::uint8_t kind = 0;
    bool awake = true;
    bool dirty = false;
    int rebuilds = 0;
    double radius = 0.5;
    double area = 0;
    bool heavy = false;  // the mass was set
};

class BallModule {
  public:
    explicit BallModule(Tree& t) : tree(t) {
        ClassDescriptor d;
        d.name = "Ball";
        d.doc = "A test ball.";
        const auto base = [](BallModule& m) noexcept { return &m.balls[0].mass; };
        Property mass{.name = "mass",
                      .default_value = 1.0,
                      .unit = "kg",
                      .range = {0, 1e6},
                      .doc = "Its mass."};
        mass.binding = column(*this, Native::f32, sizeof(Ball), base);
        mass.infinity = false;
        mass.binding.invalidate = [](void* c, Row r) {
            static_cast<BallModule*>(c)->balls[r].awake = true;
        };
        Property velocity{.name = "velocity", .type = Type::vec2, .unit = "m/s"};
        velocity.simulated = true;
        velocity.binding = column(*this, Native::vec2f, sizeof(Ball),
                                  [](BallModule& m) noexcept { return &m.balls[0].velocity; });
        Property charge{.name = "charge", .range = {-10, 10}};
        charge.infinity = charge.clamp = true;
        charge.binding = column(*this, Native::f64, sizeof(Ball),
                                [](BallModule& m) noexcept { return &m.balls[0].charge; });
        Property kind{
            .name = "kind", .type = Type::text, .enumerators = {"dynamic", "static", "kinematic"}};
        kind.binding = column(*this, Native::enumeration, sizeof(Ball),
                              [](BallModule& m) noexcept { return &m.balls[0].kind; });
        Property radius{.name = "radius", .default_value = 0.5, .unit = "m", .range = {0, 100}};
        radius.binding = accessor(
            *this, [](BallModule& m, Row r) { return m.balls[r].radius; },
            [](BallModule& m, Row r, const Value& v) {
                if (v.number() == 13) throw std::invalid_argument("thirteen brings bad luck");
                m.balls[r].radius = v.number();
                m.balls[r].dirty = true;
            });
        Property area{.name = "area", .unit = "m²", .derives_from = {"radius"}};
        area.binding = accessor(*this, [](BallModule& m, Row r) { return m.area(r); });
        d.properties = {mass, velocity, charge, kind, radius, area};
        d.methods = {
            Method{.name = "grow",
                   .parameters = {{.name = "by", .type = Type::number}},
                   .required = 1,
                   .doc = "Grows.",
                   .context = this,
                   .call = [](void* c, Tree&, Handle, Row r, std::span<const Value> a) -> Result {
                       Ball& ball = static_cast<BallModule*>(c)->balls[r];
                       ball.radius += a[0].number();
                       return Value(ball.radius);
                   }}};
        d.events = {Event{.name = "bounced", .fields = {{.name = "speed", .type = Type::number}}}};
        d.lifecycle = {
            .context = this,
            .create = [](void* c, Tree&, Handle) { return static_cast<BallModule*>(c)->add(); },
            .place =
                [](void* c, Tree&, Handle, Row r) {
                    ++static_cast<BallModule*>(c)->placed;
                    return r;
                },
            .destroy = [](void* c, Tree&, Handle,
                          Row) { ++static_cast<BallModule*>(c)->destroyed; }};
        type = &tree.define(std::move(d));
    }

    Row add() {
        balls.emplace_back();
        return static_cast<Row>(balls.size() - 1);
    }
    double area(Row r) {
        Ball& ball = balls[r];
        if (ball.dirty || ball.area == 0) {
            ball.area = 3 * ball.radius * ball.radius;
            ball.dirty = false;
            ++ball.rebuilds;
        }
        return ball.area;
    }
    Ball& ball(Handle handle) { return balls[tree.row(handle)]; }

    Tree& tree;
    std::vector<Ball> balls;
    const Class* type = nullptr;
    int placed = 0;
    int destroyed = 0;
};

/// The message of the error that `f` throws; "" if it throws none.
template <class F>
std::string message_of(F f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace fettle::property::testing
