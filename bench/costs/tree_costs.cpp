// The cost of the property tree in C++.

#include <fettle/property/path.h>
#include <fettle/property/tree.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "costs/cost_table.h"

namespace fettle::bench {
namespace {

using benchmark::DoNotOptimize;
using property::Handle;
using property::Property;
using property::Row;
using property::Tree;
using property::Value;
using property::Vec2;

constexpr std::size_t probes = 1024;

/// Data of a module for one instance.
struct Probe {
    float position[2] = {0, 0};
    float mass = 1;
    float spare = 0;
};

/// A tree with a class whose properties are in an array of its module, as for bodies.
class ProbeTree {
  public:
    ProbeTree() : array(probes) {
        const property::Class& probe = tree.define(describe());
        const Handle world = tree.create(tree.object_class(), tree.root(), "world");
        for (std::size_t i = 0; i < probes; ++i)
            handles.push_back(tree.create(probe, world, "probe_" + std::to_string(i)));
        mass = probe.property("mass");
        position = probe.property("position");
        drift = probe.property("drift");
        score = probe.property("score");
        tree.barrier();
    }

    std::vector<Probe> array;
    Row created = 0;
    Tree tree;
    std::vector<Handle> handles;
    const Property* mass = nullptr;
    const Property* position = nullptr;
    const Property* drift = nullptr;  // like position, but written by the simulation
    const Property* score = nullptr;  // stored by the tree

  private:
    property::ClassDescriptor describe() {
        const auto at_position = [](ProbeTree& t) noexcept { return &t.array[0].position; };
        property::ClassDescriptor probe{.name = "Probe", .doc = "Something to measure."};
        probe.properties = {
            {.name = "mass",
             .default_value = 1.0,
             .binding = column(*this, property::Native::f32, sizeof(Probe),
                               [](ProbeTree& t) noexcept { return &t.array[0].mass; })},
            {.name = "position",
             .type = property::Type::vec2,
             .default_value = Vec2(0, 0),
             .binding = column(*this, property::Native::vec2f, sizeof(Probe), at_position)},
            {.name = "drift",
             .type = property::Type::vec2,
             .default_value = Vec2(0, 0),
             .binding = column(*this, property::Native::vec2f, sizeof(Probe), at_position),
             .simulated = true},
            {.name = "score", .default_value = 0.0},
        };
        probe.lifecycle.context = this;
        probe.lifecycle.create = [](void* context, Tree&, Handle) {
            return static_cast<ProbeTree*>(context)->created++;
        };
        return probe;
    }
};

ProbeTree& shared_probes() {
    static ProbeTree tree;
    return tree;
}

/// Calls `body(i)` for all probes repeatedly.
template <class Body>
CostLoop each_probe(Body body) {
    return [body](benchmark::State& state) {
        for (auto _ : state) {
            for (std::size_t i = 0; i < probes; ++i) body(shared_probes(), i);
        }
    };
}

void add_reads(CostTable& table) {
    table.add("C++: read a float through a pointer", "", probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  const Probe* probe = &t.array[i];
                  DoNotOptimize(probe);  // prevents the compiler from knowing the address
                  float mass = probe->mass;
                  DoNotOptimize(mass);
              }));
    const std::string base = "C++: read a float through a pointer";
    table.add("C++: get a number by reference", base, probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  DoNotOptimize(t.tree.get(t.handles[i], *t.mass));
              }));
    table.add("C++: get a vec2 by reference", base, probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  DoNotOptimize(t.tree.get(t.handles[i], *t.position));
              }));
    table.add("C++: read a number, typed", base, probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  double mass = 0;
                  if (!t.tree.read(t.handles[i], *t.mass, mass)) throw std::logic_error("no mass");
                  DoNotOptimize(mass);
              }));
    table.add("C++: read a vec2, typed", base, probes, each_probe([](ProbeTree& t, std::size_t i) {
                  Vec2 position;
                  if (!t.tree.read(t.handles[i], *t.position, position))
                      throw std::logic_error("no position");
                  DoNotOptimize(position);
              }));
    table.add("C++: get a number the tree keeps", base, probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  DoNotOptimize(t.tree.get(t.handles[i], *t.score));
              }));
    table.add("C++: get a number by name", base, probes,
              each_probe([](ProbeTree& t, std::size_t i) {
                  DoNotOptimize(t.tree.get(t.handles[i], "mass"));
              }));
    table.add("C++: resolve a path", "C++: get a number by reference", 1,
              [](benchmark::State& state) {
                  for (auto _ : state)
                      DoNotOptimize(property::resolve(shared_probes().tree, "world.probe_77.mass"));
              });
    table.add("C++: get a number by path", "C++: get a number by reference", 1,
              [](benchmark::State& state) {
                  for (auto _ : state)
                      DoNotOptimize(property::get(shared_probes().tree, "world.probe_77.mass"));
              });
}

void add_writes(CostTable& table) {
    const std::string base = "C++: write a float through a pointer";
    table.add(base, "", probes, [](benchmark::State& state) {
        float mass = 1;
        for (auto _ : state) {
            mass = mass == 1 ? 2 : 1;
            for (Probe& probe : shared_probes().array) {
                Probe* at = &probe;
                DoNotOptimize(at);
                at->mass = mass;
            }
            benchmark::ClobberMemory();
        }
    });
    table.add("C++: set a number by reference", base, probes, [](benchmark::State& state) {
        ProbeTree& t = shared_probes();
        double mass = 1;
        for (auto _ : state) {
            mass = mass == 1 ? 2 : 1;  // a write of an equal value would stop early
            for (const Handle probe : t.handles) t.tree.set(probe, *t.mass, mass);
        }
    });
    table.add("C++: set a vec2 by reference", base, probes, [](benchmark::State& state) {
        ProbeTree& t = shared_probes();
        Vec2 position(0, 0);
        for (auto _ : state) {
            position.x = position.x == 1 ? 2 : 1;
            for (const Handle probe : t.handles) t.tree.set(probe, *t.position, position);
        }
    });
    table.add("C++: write a number, typed", base, probes, [](benchmark::State& state) {
        ProbeTree& t = shared_probes();
        double mass = 1;
        for (auto _ : state) {
            mass = mass == 1 ? 2 : 1;
            for (const Handle probe : t.handles)
                if (!t.tree.write(probe, *t.mass, mass)) throw std::logic_error("not written");
        }
    });
    table.add("C++: write a vec2, typed", base, probes, [](benchmark::State& state) {
        ProbeTree& t = shared_probes();
        Vec2 position(0, 0);
        for (auto _ : state) {
            position.x = position.x == 1 ? 2 : 1;
            for (const Handle probe : t.handles)
                if (!t.tree.write(probe, *t.position, position))
                    throw std::logic_error("not written");
        }
    });
    table.add("C++: set a number by path", "C++: set a number by reference", 1,
              [](benchmark::State& state) {
                  double mass = 1;
                  for (auto _ : state) {
                      mass = mass == 1 ? 2 : 1;
                      property::set(shared_probes().tree, "world.probe_77.mass", mass);
                  }
              });
}

/// A tree of probes; each of them has a watched property.
struct WatchedProbes : ProbeTree {
    explicit WatchedProbes(const Property* ProbeTree::*watched) {
        for (const Handle probe : handles)
            tree.watch(probe, *(this->*watched), [this](const property::Change&) { ++changes; });
        tree.barrier();
    }
    std::uint64_t changes = 0;
};

void add_watching(CostTable& table) {
    table.add("Watching: set a watched number", "C++: set a number by reference", probes,
              [](benchmark::State& state) {
                  WatchedProbes t(&ProbeTree::mass);
                  double mass = 1;
                  for (auto _ : state) {
                      mass = mass == 1 ? 2 : 1;
                      for (const Handle probe : t.handles) t.tree.set(probe, *t.mass, mass);
                      state.PauseTiming();
                      t.tree.barrier();
                      state.ResumeTiming();
                  }
              });
    table.add("Watching: deliver a change", "", probes, [](benchmark::State& state) {
        WatchedProbes t(&ProbeTree::mass);
        double mass = 1;
        for (auto _ : state) {
            state.PauseTiming();
            mass = mass == 1 ? 2 : 1;
            for (const Handle probe : t.handles) t.tree.set(probe, *t.mass, mass);
            state.ResumeTiming();
            t.tree.barrier();
        }
        if (t.changes == 0) throw std::logic_error("nothing was delivered");
    });
    table.add("Watching: a simulated vec2 that did not change", "", probes,
              [](benchmark::State& state) {
                  WatchedProbes t(&ProbeTree::drift);
                  for (auto _ : state) {
                      t.tree.set_step(t.tree.step() + 1);  // otherwise nothing is compared
                      t.tree.stepped();
                      t.tree.barrier();
                  }
              });
    table.add("Watching: a simulated vec2 that changed", "", probes, [](benchmark::State& state) {
        WatchedProbes t(&ProbeTree::drift);
        for (auto _ : state) {
            for (Probe& probe : t.array) probe.position[0] += 1;
            t.tree.set_step(t.tree.step() + 1);
            t.tree.stepped();
            t.tree.barrier();
        }
        if (t.changes == 0) throw std::logic_error("nothing was delivered");
    });
    table.add("A barrier with nothing to do", "", 1, [](benchmark::State& state) {
        for (auto _ : state) shared_probes().tree.barrier();
    });
}

void add_creation(CostTable& table) {
    table.add("Create an instance", "", probes, [](benchmark::State& state) {
        Tree tree;
        const Handle world = tree.create(tree.object_class(), tree.root(), "world");
        std::vector<Handle> made(probes);
        for (auto _ : state) {
            for (Handle& handle : made) handle = tree.create(tree.object_class(), world);
            state.PauseTiming();
            for (const Handle handle : made) tree.destroy(handle);
            tree.barrier();
            state.ResumeTiming();
        }
    });
}

}  // namespace

void add_tree_costs(CostTable& table) {
    add_reads(table);
    add_writes(table);
    add_watching(table);
    add_creation(table);
}

}  // namespace fettle::bench
