// The body with the outlines of the solid cells. Its classes are those of whatever module defines
// `Body` and `Chain`; without one, nothing is solid.

#include <cstddef>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <properties/properties.h>
#include <tilemaps/solid_outlines.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::Handle;
using property::List;
using property::Value;
using property::Vec2;

namespace {

constexpr const char* body_name = "collisions";

struct WantedChain {
    Value points{};
    bool closed = false;
    double friction = 0, restitution = 0;
};

/// Values as the chain keeps them, so that they can be compared.
double rounded(double x) {
    return static_cast<double>(static_cast<float>(x));
}

/// Bytes by which equal chains are found.
std::string key_of(const WantedChain& chain) {
    std::string key(chain.closed ? "c" : "o");
    const auto add = [&](double x) {
        char bytes[sizeof x];
        std::memcpy(bytes, &x, sizeof x);
        key.append(bytes, sizeof x);
    };
    add(chain.friction);
    add(chain.restitution);
    for (const Value& point : chain.points.list()) {
        add(point.vec2().x());
        add(point.vec2().y());
    }
    return key;
}

void add_chain(property::Tree& tree, const property::Class& of, Handle body,
               const WantedChain& wanted) {
    const Handle made = tree.create(of);
    try {
        tree.set(made, "points", wanted.points);
        tree.set(made, "closed", Value(wanted.closed));
        tree.set(made, "friction", Value(wanted.friction));
        tree.set(made, "restitution", Value(wanted.restitution));
        tree.set(made, "visible", Value(false));
        tree.move(made, body);
    } catch (...) {
        tree.destroy(made);
        throw;
    }
}

}  // namespace

std::vector<Handle> Tilemaps::solid_layers(Handle map) const {
    std::vector<Handle> all;
    for (const Handle layer : tile_layers(map))
        if (Reader(*tree_, layer).flag(in_layer_.solid)) all.push_back(layer);
    return all;
}

void Tilemaps::update_bodies(Handle map) {
    rows_[tree_->row(map)].outdated = false;
    const property::Class* const body_class = tree_->find_class("Body");
    const property::Class* const chain_class = tree_->find_class("Chain");
    if (body_class == nullptr || chain_class == nullptr) return;
    const auto file = loaded(map);
    std::vector<WantedChain> wanted;
    if (file != nullptr)
        for (const Handle layer : solid_layers(map)) {
            const Grid* const cells = grid(layer);
            if (cells == nullptr) continue;
            const Reader read(*tree_, layer);
            const Vec2 offset = read.vec2(in_layer_.offset);
            const double unit = 1 / pixels_per_unit(map);
            for (const SolidLine& line : solid_lines(*cells, *file)) {
                WantedChain chain{.closed = line.closed,
                                  .friction = rounded(read.number(in_layer_.friction)),
                                  .restitution = rounded(read.number(in_layer_.restitution))};
                List points;
                points.reserve(line.points.size());
                for (const Vec2& p : line.points)
                    points.emplace_back(Vec2(rounded(p.x() * unit + offset.x()),
                                             rounded(p.y() * unit + offset.y())));
                chain.points = Value(std::move(points));
                wanted.push_back(std::move(chain));
            }
        }
    Handle body = tree_->child(map, body_name);
    if (body && !tree_->class_of(body).is_a(*body_class)) return;
    if (wanted.empty() && !body) return;
    try {
        if (!body) {
            body = tree_->create(*body_class);
            tree_->set(body, "type", Value("static"));
            tree_->move(body, map, body_name);
            List made = tree_->peek(map, *of_.made).list();
            made.emplace_back(body);
            tree_->set(map, *of_.made, Value(std::move(made)));
        }
        if (file != nullptr) {
            const Vec2 at = upper_left(map, file->map());
            if (tree_->get(body, "position").vec2() != Vec2(rounded(at.x()), rounded(at.y())))
                tree_->set(body, "position", Value(at));
        }
        // Chains that are as they should be stay, with their contacts.
        std::map<std::string, std::vector<Handle>> there;
        for (const Handle child : tree_->children(body)) {
            if (!tree_->class_of(child).is_a(*chain_class)) continue;
            there[key_of({.points = tree_->get(child, "points"),
                          .closed = tree_->get(child, "closed").boolean(),
                          .friction = tree_->get(child, "friction").as_double(),
                          .restitution = tree_->get(child, "restitution").as_double()})]
                .push_back(child);
        }
        std::vector<const WantedChain*> missing;
        for (const WantedChain& chain : wanted) {
            auto& same = there[key_of(chain)];
            if (same.empty())
                missing.push_back(&chain);
            else
                same.pop_back();
        }
        for (const auto& [key, chains] : there)
            for (const Handle chain : chains) tree_->destroy(chain);
        for (const WantedChain* chain : missing) add_chain(*tree_, *chain_class, body, *chain);
    } catch (const std::exception& error) {
        tell(map, std::string("collisions: ") + error.what());
    }
}

}  // namespace fettle::visuals
