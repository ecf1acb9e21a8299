// The body with the outlines of the solid cells. Any module may define its classes `Body` and
// `Chain`; without them, nothing is solid.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <string_view>
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

struct WantedChain {
    Value points{};
    bool closed = false;
    double friction = 0, restitution = 0;
};

namespace {

constexpr const char* body_name = "collisions";
constexpr std::size_t most_chains = 50'000;  // separate outlines; each is an instance

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
        add(point.vec2().x);
        add(point.vec2().y);
    }
    return key;
}

/// The same number for the same outlines at the same place, in any run; 0 for no outlines.
std::int64_t number_of(const std::vector<WantedChain>& chains, const Vec2& at) {
    if (chains.empty()) return 0;
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](std::string_view bytes) {
        for (const char byte : bytes)
            hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    };
    for (const WantedChain& chain : chains) add(key_of(chain));
    for (const double x : {at.x, at.y}) {
        char bytes[sizeof x];
        std::memcpy(bytes, &x, sizeof x);
        add({bytes, sizeof x});
    }
    return std::bit_cast<std::int64_t>(hash);
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

std::vector<WantedChain> Tilemaps::wanted_chains(Handle map) {
    std::vector<WantedChain> wanted;
    const auto file = loaded(map);
    if (file == nullptr) return wanted;
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
                points.emplace_back(
                    Vec2(rounded(p.x * unit + offset.x), rounded(p.y * unit + offset.y)));
            chain.points = Value(std::move(points));
            wanted.push_back(std::move(chain));
        }
    }
    return wanted;
}

Handle Tilemaps::make_body(Handle map, const property::Class& of) {
    const Handle body = tree_->create(of);
    tree_->set(body, "type", Value("static"));
    tree_->move(body, map, body_name);
    List made = tree_->peek(map, *of_.made).list();
    std::erase_if(made, [&](const Value& each) { return !tree_->alive(each.reference()); });
    made.emplace_back(body);
    tree_->set(map, *of_.made, Value(std::move(made)));
    return body;
}

void Tilemaps::update_bodies(Handle map) {
    rows_[tree_->row(map)].outdated = false;
    const property::Class* const body_class = tree_->find_class("Body");
    const property::Class* const chain_class = tree_->find_class("Chain");
    if (body_class == nullptr || chain_class == nullptr) return;
    const auto file = loaded(map);
    std::vector<WantedChain> wanted;
    try {
        wanted = wanted_chains(map);
    } catch (const property::Error& error) {
        report(map, std::string("collisions: ") + error.what() + "; nothing of it is solid");
    }
    if (wanted.size() > most_chains) {
        report(map, "collisions: the solid tiles have " + std::to_string(wanted.size()) +
                        " separate outlines, and a map may have " + std::to_string(most_chains) +
                        "; nothing of it is solid");
        wanted.clear();
    }
    const Vec2 at = file != nullptr ? upper_left(map, file->map()) : Vec2(0, 0);
    // After a restore, this runs for every map. What a game did to the body itself must stay then,
    // so the body is only changed if the outlines are others than at the last update.
    const std::int64_t followed = number_of(wanted, at);
    if (tree_->peek(map, *of_.followed).integer() == followed) return;
    Handle body = tree_->child(map, body_name);
    if (body && !tree_->class_of(body).is_a(*body_class)) return;
    if (wanted.empty() && !body) {
        tree_->set(map, *of_.followed, Value(followed));
        return;
    }
    try {
        if (!body) body = make_body(map, *body_class);
        if (file != nullptr &&
            tree_->get(body, "position").vec2() != Vec2(rounded(at.x), rounded(at.y)))
            tree_->set(body, "position", Value(at));
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
        tree_->set(map, *of_.followed, Value(followed));
    } catch (const std::exception& error) {
        report(map, std::string("collisions: ") + error.what());
    }
}

}  // namespace fettle::visuals
