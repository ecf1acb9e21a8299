// A module: wind, which blows on every body beside it. `fettle run game --module wind.so`.

#include <cmath>
#include <memory>
#include <vector>

#include <fettle/module/guest.h>

using namespace fettle;
using property::accessor;
using property::Handle;
using property::Native;
using property::Row;
using property::Type;
using property::Value;
using property::Vec2;

struct Wind {
    Vec2 velocity{4, 0};
    double drag = 1, gusts = 0, time = 0;
    Handle self;  // null: a free row
    Vec2 now() const { return velocity * (1 + gusts * std::sin(2.0 * time)); }
};

class WindModule : public module::Module {
  public:
    std::string_view name() const override { return "wind"; }

    void attach(property::Tree& tree) override {
        tree_ = &tree;
        property::ClassDescriptor wind;
        wind.name = "Breeze";
        wind.doc = "Blows on every body below its parent.";
        const auto at = [this](const char* called, Type type, Native native, Value usual,
                               const char* unit, const char* doc, auto base) {
            return property::Property{.name = called,
                                      .type = type,
                                      .default_value = usual,
                                      .unit = unit,
                                      .doc = doc,
                                      .binding = column(*this, native, sizeof(Wind), base)};
        };
        wind.properties = {
            at("velocity", Type::vec2, Native::vec2d, Vec2(4, 0), "m/s", "Of the air, on average.",
               [](WindModule& m) { return &m.winds_.data()->velocity; }),
            at("drag", Type::number, Native::f64, 1.0, "kg/s", "Force for each m/s of difference.",
               [](WindModule& m) { return &m.winds_.data()->drag; }),
            at("gusts", Type::number, Native::f64, 0.0, "", "How far it swells and dies, 0 to 1.",
               [](WindModule& m) { return &m.winds_.data()->gusts; }),
            {.name = "now",
             .type = Type::vec2,
             .unit = "m/s",
             .doc = "Of the air at the moment.",
             .binding = accessor(*this, [](WindModule& m, Row r) { return m.winds_[r].now(); }),
             .simulated = true}};
        wind.properties[1].range = {.min = 0};
        wind.properties[2].range = {.min = 0, .max = 1};
        wind.lifecycle = {
            .context = this,
            .create = [](void* m, property::Tree&,
                         Handle self) { return static_cast<WindModule*>(m)->create(self); },
            .destroy = [](void* m, property::Tree&, Handle,
                          Row row) { static_cast<WindModule*>(m)->winds_[row] = {}; }};
        tree.define(std::move(wind));
    }

    void step(double dt) override {
        const property::Class* body = tree_->find_class("Body");
        for (Wind& wind : winds_) {
            if (!wind.self || body == nullptr) continue;
            wind.time += dt;
            tree_->each_below(tree_->parent(wind.self), [&](Handle at) {
                if (!tree_->class_of(at).is_a(*body)) return;
                if (tree_->get(at, "type").text() != "dynamic") return;
                const Vec2 difference = wind.now() - tree_->get(at, "velocity").vec2();
                tree_->call(at, "apply_force", {Value(Vec2(wind.drag * difference))});
            });
        }
    }
    void report(property::Tree& tree) override { tree.stepped(); }
    std::uint64_t hash() const override {
        std::uint64_t all = 0;
        for (const Wind& wind : winds_) all = all * 31 + std::uint64_t(wind.time * 1e6);
        return all;
    }

  private:
    Row create(Handle self) {
        Row row = 0;
        while (row < winds_.size() && winds_[row].self) ++row;
        if (row == winds_.size()) winds_.emplace_back();
        winds_[row] = Wind{.self = self};
        return row;
    }
    property::Tree* tree_ = nullptr;
    std::vector<Wind> winds_;
};

FETTLE_GUEST(WindModule, "1.0")
