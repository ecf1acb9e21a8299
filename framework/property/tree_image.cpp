#include "tree_image.h"

#include <algorithm>
#include <stdexcept>

#include <fettle/property/error.h>

#include "state.h"

namespace fettle::property {
namespace {

/// Properties behind which is memory that nobody else saves.
std::vector<const Property*> saved_by_value(const Class& of) {
    std::vector<const Property*> all;
    for (const Property* property : of.properties()) {
        const BindingKind kind = property->binding.kind;
        const bool native = kind == BindingKind::column || kind == BindingKind::accessor;
        if (native && !property->read_only && !property->transient &&
            property->owner->snapshots() == Snapshots::by_value)
            all.push_back(property);
    }
    return all;
}

bool by_value(const Class& of) {
    return of.snapshots() == Snapshots::by_value;
}

}  // namespace

// --- Saving
// -----------------------------------------------------------------------------------------------------------

Memory TreeImage::save(const Tree::State& s, ByteWriter& to) {
    to.put(s.step);
    to.put(s.root);
    to.put(std::uint64_t{s.classes.size()});
    for (std::uint32_t i = 0; i < s.classes.size(); ++i) to.put(s.classes[i].name());
    s.nodes.save(to);

    std::vector<std::uint32_t> stored;
    for (std::uint32_t i = 0; i < s.classes.size(); ++i)
        if (s.stored[i] != nullptr && s.classes[i].snapshots() != Snapshots::never)
            stored.push_back(i);
    to.put(std::uint64_t{stored.size()});
    for (const std::uint32_t i : stored) {
        to.put(i);
        const std::size_t block = to.begin_block();
        s.stored[i]->save(to);
        to.end_block(block);
    }

    std::vector<std::uint32_t> owners;
    for (const auto& [index, own] : s.ad_hoc) owners.push_back(index);
    std::sort(owners.begin(), owners.end());
    std::size_t count = 0;
    for (const std::uint32_t index : owners) count += s.ad_hoc.at(index).size();
    to.put(std::uint64_t{count});
    for (const std::uint32_t index : owners)
        for (const auto& [name, own] : s.ad_hoc.at(index)) {
            to.put(index);
            to.put(name);
            to.put(own.second);
        }

    std::vector<std::vector<const Property*>> by_class(s.classes.size());
    for (std::uint32_t i = 0; i < s.classes.size(); ++i) by_class[i] = saved_by_value(s.classes[i]);
    const std::size_t values = to.begin_block();
    for (std::uint32_t i = 1; i < s.nodes.end(); ++i) {
        const Node& node = s.nodes[i];
        if (!node.alive() || by_class[node.class_id].empty()) continue;
        to.put(s.nodes.handle(i));
        to.put(std::uint64_t{by_class[node.class_id].size()});
        for (const Property* property : by_class[node.class_id]) {
            to.put(property->name);
            to.put(s.read(i, node, *property));
        }
    }
    to.end_block(values);

    auto memory = std::make_shared<TreeMemory>();
    memory->history = s.history.image();
    memory->formulas = s.formulas.images();
    to.put(std::uint64_t{memory->formulas.size()});
    for (const Formulas::Image& image : memory->formulas) {
        to.put(image.instance);
        to.put(image.property.text());
        to.put(image.formula.not_saved.empty() ? image.formula.source : std::string());
    }
    return memory;
}

// --- Reading
// ----------------------------------------------------------------------------------------------------------

TreeImage::TreeImage(Tree::State& state, ByteReader& from, const Memory& memory) : state_(state) {
    step_ = from.get<std::uint64_t>();
    const auto root = from.get<Handle>();
    read_classes(from);
    nodes_ = Nodes::load(from, classes_);
    from.require(root == state_.root && nodes_.find(root) != nullptr, "it has another root");
    check_services(from);
    read_columns(from);
    read_ad_hoc(from);
    read_values(from);
    read_formulas(from, memory);
    for (std::uint32_t i = 0; i < state_.nodes.end(); ++i)
        before_.push_back(state_.nodes[i].alive() ? state_.nodes[i].generation : 0);
}

void TreeImage::read_classes(ByteReader& from) {
    for (std::size_t n = from.count(8); n > 0; --n) {
        const std::string name(from.text());
        const Class* here = state_.classes.find(name);
        if (here == nullptr)
            throw Error(ErrorKind::unknown_name,
                        "the snapshot has a class \"" + name + "\" that this game does not define");
        classes_.push_back(static_cast<std::uint16_t>(here->id()));
    }
}

// Services are the framework's own: its parts hold their handles.
void TreeImage::check_services(const ByteReader& from) const {
    for (std::uint32_t i = 1; i < state_.nodes.end(); ++i) {
        const Node& here = state_.nodes[i];
        if (!here.alive() || here.parent != state_.root.index ||
            state_.classes[here.class_id].creatable())
            continue;
        const Node* there = nodes_.find(state_.nodes.handle(i));
        from.require(there != nullptr && there->class_id == here.class_id,
                     "it is of a game with other services or modules");
    }
}

void TreeImage::read_columns(ByteReader& from) {
    for (std::size_t n = from.count(12); n > 0; --n) {
        const auto there = from.get<std::uint32_t>();
        from.require(there < classes_.size(), "values of no class");
        const std::uint32_t here = classes_[there];
        ByteReader block = from.block();
        if (state_.stored[here] == nullptr || state_.classes[here].snapshots() == Snapshots::never)
            continue;
        columns_.emplace_back(here, std::make_unique<StoredColumns>(StoredColumns::load(
                                        block, state_.classes[here], nodes_.end())));
        block.finish();
    }
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        const Node& node = nodes_[i];
        if (!node.alive() || state_.stored[node.class_id] == nullptr ||
            state_.classes[node.class_id].snapshots() == Snapshots::never)
            continue;
        const auto column = std::find_if(columns_.begin(), columns_.end(),
                                         [&](const auto& c) { return c.first == node.class_id; });
        from.require(column != columns_.end() && node.stored_row < column->second->rows(),
                     "an instance without values");
    }
}

void TreeImage::read_ad_hoc(ByteReader& from) {
    for (std::size_t n = from.count(13); n > 0; --n) {
        AdHoc own;
        own.index = from.get<std::uint32_t>();
        own.name = from.text();
        own.value = from.value();
        from.require(own.index < nodes_.end() && nodes_[own.index].alive() && !own.name.empty(),
                     "a property of nobody");
        ad_hoc_.push_back(std::move(own));
    }
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) nodes_[i].has_ad_hoc = false;
    for (const AdHoc& own : ad_hoc_) nodes_[own.index].has_ad_hoc = true;
}

void TreeImage::read_values(ByteReader& from) {
    ByteReader block = from.block();
    while (!block.at_end()) {
        ByValue each;
        each.instance = block.get<Handle>();
        const Node* node = nodes_.find(each.instance);
        block.require(node != nullptr, "values of nobody");
        const Class& of = state_.classes[node->class_id];
        for (std::size_t n = block.count(9); n > 0; --n) {
            const Property* property = of.property(block.text());
            Value value = block.value();
            if (property != nullptr) each.values.emplace_back(property, std::move(value));
        }
        values_.push_back(std::move(each));
    }
}

void TreeImage::read_formulas(ByteReader& from, const Memory& memory) {
    for (std::size_t n = from.count(24); n > 0; --n) {
        Formulas::Image image;
        image.instance = from.get<Handle>();
        image.property = Symbol(from.text());
        image.formula.source = from.text();
        from.require(nodes_.find(image.instance) != nullptr, "a formula of nobody");
        formulas_.push_back(std::move(image));
    }
    if (memory == nullptr) return;
    const auto& held = *static_cast<const TreeMemory*>(memory.get());
    history_ = held.history;
    formulas_ = held.formulas;
}

// --- Putting into place
// -----------------------------------------------------------------------------------------------

void TreeImage::each(const std::function<void(Handle, const Class&, Row)>& visit) const {
    for (std::uint32_t i = 1; i < nodes_.end(); ++i)
        if (nodes_[i].alive())
            visit(nodes_.handle(i), state_.classes[nodes_[i].class_id], nodes_[i].row);
}

bool TreeImage::lived_before(Handle instance) const {
    return instance.index < before_.size() && before_[instance.index] == instance.generation;
}

void TreeImage::end_rows() {
    Tree::State& s = state_;
    for (std::uint32_t i = 1; i < s.nodes.end(); ++i) {
        if (before_[i] == 0) continue;
        const Handle gone = s.nodes.handle(i);
        const Class& of = s.classes[s.nodes[i].class_id];
        const Lifecycle& lifecycle = of.lifecycle();
        if (nodes_.find(gone) == nullptr && by_value(of) && lifecycle.destroy) {
            try {
                lifecycle.destroy(lifecycle.context, s.tree, gone, s.nodes[i].row);
            } catch (const std::exception&) {
                // Its module knows nothing of it; nothing is left to end.
            }
        }
        if (nodes_.find(gone) == nullptr && of.snapshots() == Snapshots::never &&
            s.stored[of.id()] != nullptr)
            s.stored[of.id()]->remove(s.nodes[i].stored_row);
    }
}

void TreeImage::put_nodes() {
    Tree::State& s = state_;
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        Node& node = nodes_[i];
        node.watched = node.fresh = node.has_formula = node.has_dependents = false;
        if (!node.alive()) continue;
        const Class& of = s.classes[node.class_id];
        const bool lived = lived_before({i, node.generation});
        // Rows that are made anew, or that the present knows.
        if (by_value(of) && of.lifecycle().create && lived) node.row = s.nodes[i].row;
        if (of.snapshots() == Snapshots::never && s.stored[of.id()] != nullptr)
            node.stored_row = lived ? s.nodes[i].stored_row : s.stored[of.id()]->add();
    }
    s.nodes.replace(std::move(nodes_));
    s.fresh.clear();
    put_columns();
    s.tell_plain_writes();
    s.step = step_;
    s.stepped = s.edited = true;
    ++s.upheavals;
    s.history.restore(history_);
    if (history_ == nullptr) s.nodes.free_all_kept();
}

void TreeImage::put_columns() {
    Tree::State& s = state_;
    for (auto& [id, columns] : columns_) s.stored[id] = std::move(columns);
    // A class that the snapshot does not know has nobody in it.
    for (std::uint32_t id = 0; id < s.classes.size(); ++id) {
        const bool told = std::find(classes_.begin(), classes_.end(), id) != classes_.end();
        if (!told && s.stored[id] != nullptr && s.classes[id].snapshots() != Snapshots::never)
            s.stored[id] = std::make_unique<StoredColumns>(s.classes[id]);
    }
    s.ad_hoc.clear();
    for (AdHoc& own : ad_hoc_) {
        const Property& property = s.ad_hoc_property(Symbol(own.name));
        s.ad_hoc[own.index].emplace(own.name, std::pair(&property, std::move(own.value)));
    }
}

void TreeImage::put_formulas() {
    Tree::State& s = state_;
    s.formulas.clear();
    for (Formulas::Image& image : formulas_) {
        const Property* property = s.tree.find(image.instance, image.property);
        if (property == nullptr) continue;
        if (!image.formula.function) {
            if (!s.formula_compiler || image.formula.source.empty()) continue;
            try {
                image.formula = s.formula_compiler(image.formula.source);
            } catch (const std::exception&) {
                continue;  // its last value stays
            }
        }
        s.formulas.set(image.instance, *property, image.formula);
    }
}

/// Rows of those whose module makes them anew; parents before children.
void TreeImage::make_rows() {
    Tree::State& s = state_;
    const auto make = [&](std::uint32_t i) {
        const Class& of = s.classes[s.nodes[i].class_id];
        const Lifecycle& lifecycle = of.lifecycle();
        const Handle self = s.nodes.handle(i);
        if (!by_value(of) || !lifecycle.create || lived_before(self)) return;
        try {
            const Row row = lifecycle.create(lifecycle.context, s.tree, self);
            s.nodes[i].row = row;
            if (!lifecycle.place || s.nodes[i].parent == 0) return;
            const Row placed = lifecycle.place(lifecycle.context, s.tree, self, row);
            s.nodes[i].row = placed;
        } catch (const std::exception&) {
            // Its module has no room for it any more: it stays as the module left it.
        }
    };
    for (std::uint32_t top = 1; top < s.nodes.end(); ++top)
        if (s.nodes[top].alive() && s.nodes[top].parent == 0) s.visit_below(top, make);
}

void TreeImage::put_values() {
    make_rows();
    Tree::State& s = state_;
    for (const ByValue& each : values_)
        for (const auto& [property, value] : each.values) {
            const Node& node = s.nodes[each.instance.index];
            try {
                if (!(s.read(each.instance.index, node, *property) == value))
                    s.write(each.instance.index, node, *property,
                            s.tree.coerce(each.instance, *property, value));
            } catch (const std::exception&) {
                // Its owner refuses what it once held; what it holds now stays.
            }
        }
    put_formulas();
}

}  // namespace fettle::property
