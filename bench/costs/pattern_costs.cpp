// Watchers of many instances: patterns that match a hundred thousand instances.

#include <fettle/property/tree.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "costs/cost_table.h"

namespace fettle::bench {
namespace {

using property::Handle;
using property::Row;
using property::Tree;
using property::Vec2;

constexpr std::size_t groups = 100;
constexpr std::size_t in_a_group = 1000;
constexpr std::size_t all = groups * in_a_group;

/// `world.group_1.speck_1` ... with a property that the simulation writes.
class SpeckTree {
  public:
    SpeckTree() : array(all + 1) {
        property::ClassDescriptor speck{.name = "Speck"};
        speck.properties = {{.name = "drift",
                             .type = property::Type::vec2,
                             .binding = column(*this, property::Native::vec2f, sizeof(Speck),
                                               [](SpeckTree& t) { return &t.array[0].drift; }),
                             .simulated = true},
                            {.name = "score"}};
        speck.lifecycle.context = this;
        speck.lifecycle.create = [](void* context, Tree&, Handle) {
            auto& self = *static_cast<SpeckTree*>(context);
            return self.made < all ? self.made++ : Row{all};
        };
        type = &tree.define(std::move(speck));
        const Handle world = tree.create(tree.object_class(), tree.root(), "world");
        for (std::size_t g = 0; g < groups; ++g) {
            above.push_back(
                tree.create(tree.object_class(), world, "group_" + std::to_string(g + 1)));
            for (std::size_t i = 0; i < in_a_group; ++i) tree.create(*type, above.back());
        }
        tree.barrier();
    }

    property::Connection watch(const std::string& pattern) {
        return tree.watch_pattern(pattern, [this](const property::Change&) { ++changes; });
    }

    struct Speck {
        float drift[2] = {0, 0};
    };
    std::vector<Speck> array;
    Row made = 0;
    Tree tree;
    const property::Class* type = nullptr;
    std::vector<Handle> above;
    std::uint64_t changes = 0;
};

SpeckTree& specks() {
    static SpeckTree tree;
    return tree;
}

/// One pattern for each group of a thousand specks.
struct ManyPatterns {
    ManyPatterns() {
        for (std::size_t g = 0; g < groups; ++g)
            connections.emplace_back(
                specks().watch("world.group_" + std::to_string(g + 1) + ".*.drift"));
    }
    std::vector<property::ScopedConnection> connections;
};

void create_and_delete(benchmark::State& state) {
    SpeckTree& t = specks();
    for (auto _ : state) t.tree.destroy(t.tree.create(*t.type, t.above.front()));
    t.tree.barrier();
}

void step(benchmark::State& state, bool moving) {
    SpeckTree& t = specks();
    const std::uint64_t before = t.changes;
    for (auto _ : state) {
        if (moving)
            for (SpeckTree::Speck& speck : t.array) speck.drift[0] += 1;
        t.tree.stepped();
        t.tree.barrier();
    }
    if ((t.changes != before) != moving) throw std::logic_error("wrong changes were delivered");
}

}  // namespace

void add_pattern_costs(CostTable& table) {
    const std::string created = "Patterns: create and delete an instance, no pattern";
    table.add(
        "Patterns: watch and stop, each of 100 000 instances", "", all,
        [](benchmark::State& state) {
            for (auto _ : state)
                const property::ScopedConnection connection(specks().watch("world.*.*.drift"));
        });
    table.add("Patterns: one of 100, each of 100 000 instances", "", double{all} * groups,
              [](benchmark::State& state) {
                  for (auto _ : state) const ManyPatterns patterns;
              });
    table.add(created, "", 1, create_and_delete);
    table.add("Patterns: create and delete an instance, 100 patterns", created, 1,
              [](benchmark::State& state) {
                  const ManyPatterns patterns;
                  create_and_delete(state);
              });
    table.add("Patterns: a simulated vec2 that did not change, of 100 000", "", all,
              [](benchmark::State& state) {
                  const property::ScopedConnection connection(specks().watch("world.*.*.drift"));
                  step(state, false);
              });
    table.add("Patterns: a simulated vec2 that changed, of 100 000", "", all,
              [](benchmark::State& state) {
                  const property::ScopedConnection connection(specks().watch("world.*.*.drift"));
                  step(state, true);
              });
}

}  // namespace fettle::bench
