#include "naive_world.h"

#include <algorithm>

namespace fettle::property::testing {

std::vector<int>& NaiveWorld::children_of(int parent) {
    return parent < 0 ? top : instances[static_cast<std::size_t>(parent)].children;
}

int NaiveWorld::create(const std::string& name) {
    const int made = static_cast<int>(instances.size());
    NaiveInstance instance;
    instance.name = name;
    for (const char* property : {"mass", "radius", "charge", "speed"})
        instance.values[property] = default_of(property);
    instances.push_back(std::move(instance));
    top.push_back(made);
    return made;
}

void NaiveWorld::destroy(int instance) {
    NaiveInstance& dead = instances[static_cast<std::size_t>(instance)];
    while (!dead.children.empty()) destroy(dead.children.back());
    dead.alive = false;
    std::erase(children_of(dead.parent), instance);
}

void NaiveWorld::move(int instance, int parent) {
    NaiveInstance& moved = instances[static_cast<std::size_t>(instance)];
    std::erase(children_of(moved.parent), instance);
    moved.parent = parent;
    children_of(parent).push_back(instance);
}

bool NaiveWorld::is_below(int instance, int ancestor) const {
    for (int up = instance; up >= 0; up = instances[static_cast<std::size_t>(up)].parent)
        if (up == ancestor) return true;
    return false;
}

std::vector<int> NaiveWorld::alive() const {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (instances[i].alive) numbers.push_back(static_cast<int>(i));
    return numbers;
}

int NaiveWorld::named(const std::string& name) const {
    for (const int child : top)
        if (instances[static_cast<std::size_t>(child)].name == name) return child;
    return -1;
}

double NaiveWorld::read(int instance, const std::string& property) const {
    Results results;
    return evaluate({instance, property}, results);
}

// Computes each cell once; otherwise the time would double with every formula of a chain.
double NaiveWorld::evaluate(const Cell& cell, Results& results) const {
    if (cell.first < 0 || !instances[static_cast<std::size_t>(cell.first)].alive)
        throw InError("there is no such instance");
    const NaiveInstance& instance = instances[static_cast<std::size_t>(cell.first)];
    const auto formula = instance.formulas.find(cell.second);
    if (formula == instance.formulas.end()) {
        const auto value = instance.values.find(cell.second);
        if (value == instance.values.end()) throw InError("there is no such property");
        return value->second;
    }
    // A cell counts as in error until it is computed: a second visit before that is a cycle.
    const auto [known, first] = results.emplace(cell, std::nullopt);
    if (!first) {
        if (!known->second) throw InError("a source in error, or a cycle");
        return *known->second;
    }
    const Recipe& recipe = formula->second;
    const double result = recipe([&](int from, const std::string& name) {
        return evaluate({recipe.by_path ? named("n" + std::to_string(from)) : from, name}, results);
    });
    return *(known->second = coerced(cell.second, result));
}

double NaiveWorld::coerced(const std::string& property, double value) {
    if (property == "mass") {
        const auto narrow = static_cast<double>(static_cast<float>(value));
        if (narrow < 0 || narrow > 1e6) throw InError("out of range");
        return narrow;
    }
    if (property == "radius") {
        if (value < 0 || value > 100 || value == 13) throw InError("refused");
        return value;
    }
    if (property == "charge") return std::clamp(value, -10.0, 10.0);
    return value;
}

double NaiveWorld::default_of(const std::string& property) {
    return property == "mass" ? 1.0 : property == "radius" ? 0.5 : 0.0;
}

bool NaiveWorld::declared(const std::string& property) {
    return property == "mass" || property == "radius" || property == "charge";
}

}  // namespace fettle::property::testing
