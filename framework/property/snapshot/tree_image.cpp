// Saving a tree as bytes, and reading and checking these bytes.

#include "tree_image.h"

#include <algorithm>
#include <set>

#include <fettle/property/error.h>
#include <fettle/property/snapshot_remarks.h>

#include <tree/state.h>

#include "restored_values.h"

namespace fettle::property {
namespace {

bool is_native(const Property& property) {
    return property.binding.kind == BindingKind::column ||
           property.binding.kind == BindingKind::accessor;
}

std::vector<const Property*> saved_by_value(const Class& of) {
    std::vector<const Property*> all;
    for (const Property* property : of.properties())
        if (is_native(*property) && !property->read_only && !property->transient &&
            property->owner->snapshots() == Snapshots::by_value)
            all.push_back(property);
    return all;
}

/// Throws the error for an undamaged save that does not fit the changed classes of a game.
[[noreturn]] void refuse_changed(const std::string& what) {
    throw Error(ErrorKind::rejected,
                "the classes of the game have changed since the snapshot was taken: " + what);
}

}  // namespace

bool belongs_to_the_present(const Class& of, const Property& property) {
    if (of.snapshots() == Snapshots::never) return property.binding.kind != BindingKind::ad_hoc;
    return is_native(property) && property.transient &&
           property.owner->snapshots() == Snapshots::by_value;
}

// --- Saving

std::size_t TreeMemory::bytes() const {
    std::size_t sum = sizeof *this + parts.capacity() * sizeof parts[0] +
                      content.capacity() * sizeof(TreeWeight::Content::value_type);
    for (const Formulas::Image& image : formulas)
        // The text belongs to the game.
        sum += sizeof image + bytes_of(image.formula) - image.formula.holds;
    return sum;
}

bool TreeMemory::is_of(const Tree::State& state) const {
    return state.lifetime.is_marked_by(of);
}

namespace {

void save_stored(const Instances& s, ByteWriter& to) {
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
}

void save_ad_hoc(const Instances& s, ByteWriter& to) {
    std::vector<std::uint32_t> owners;
    for (const auto& [index, own] : s.ad_hoc.of_instance) owners.push_back(index);
    std::sort(owners.begin(), owners.end());
    std::size_t count = 0;
    for (const std::uint32_t index : owners) count += s.ad_hoc.of_instance.at(index).size();
    to.put(std::uint64_t{count});
    for (const std::uint32_t index : owners)
        for (const auto& [name, own] : s.ad_hoc.of_instance.at(index)) {
            to.put(index);
            to.put(name);
            to.put(own.second);
        }
}

/// Saves the values of properties that snapshots read and write one by one.
void save_values(const Instances& s, ByteWriter& to) {
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
}

}  // namespace

std::shared_ptr<const TreeMemory> TreeImage::save(const Tree::State& state, ByteWriter& to) {
    const Instances& s = state.instances;
    to.put(state.changes.author.step);
    to.put(s.root);
    to.put(std::uint64_t{s.classes.size()});
    for (std::uint32_t i = 0; i < s.classes.size(); ++i) to.put(s.classes[i].name());
    s.nodes.save(to);
    save_stored(s, to);
    save_ad_hoc(s, to);
    save_values(s, to);

    auto memory = std::make_shared<TreeMemory>();
    memory->of = state.lifetime.mark;
    memory->parts = state.snapshots.numbers;
    memory->history = state.history.image();
    memory->formulas = state.formulas.images();
    memory->content = state.changes.weight.content_image();
    to.put(std::uint64_t{memory->formulas.size()});
    for (const Formulas::Image& image : memory->formulas) {
        to.put(image.instance);
        to.put(image.property.text());
        to.put(image.formula.not_saved.empty() ? image.formula.source : std::string());
    }
    for (std::uint32_t i = 0; i < s.classes.size(); ++i) to.put(maker_of(s.classes[i]).name());
    return memory;
}

/// The nearest class, itself or a base, whose module makes the rows of this class.
const Class& TreeImage::maker_of(const Class& of) {
    const Class* maker = &of;
    while (maker->base_ != nullptr && maker->lifecycle_ == maker->base_->lifecycle_)
        maker = maker->base_;
    return *maker;
}

std::vector<std::string> unsaved_formulas(const Tree& tree) {
    std::vector<std::string> all;
    for (const Formulas::Image& image : tree.state().formulas.images()) {
        const std::string& why = image.formula.not_saved;
        if (why.empty() && !image.formula.source.empty()) continue;
        if (const Property* property = tree.find(image.instance, image.property))
            all.push_back(tree.path(image.instance, *property) + ": its formula " +
                          (why.empty() ? "has no text" : why));
    }
    return all;
}

const std::vector<std::string>& restore_remarks(const Tree& tree) {
    return tree.state().snapshots.remarks;
}

// --- Reading

TreeImage::TreeImage(Tree::State& state, ByteReader& from, const Memory& memory)
    : state_(state), now_(state.instances) {
    step_ = from.get<std::uint64_t>();
    const auto root = from.get<Handle>();
    read_classes(from);
    nodes_ = Nodes::load(from, classes_);
    const Node* const top = nodes_.find(root);
    from.require(root == now_.root && top != nullptr && top->parent == 0, "it has another root");
    for (std::uint32_t i = 0; i < now_.nodes.end(); ++i)
        before_.push_back(now_.nodes[i].alive()
                              ? Before{now_.nodes[i].generation, now_.nodes[i].class_id}
                              : Before{});
    read_columns(from);
    add_columns();
    read_ad_hoc(from);
    check_instances(from);
    read_values(from);
    read_formulas(from, memory);
    if (!from.at_end()) read_makers(from);  // format 3 does not contain them
    check_rows(from);
    fit_values(from);
}

void TreeImage::read_classes(ByteReader& from) {
    for (std::size_t n = from.count(8); n > 0; --n) {
        const std::string name(from.text());
        const Class* here = now_.classes.find(name);
        if (here == nullptr)
            throw Error(ErrorKind::unknown_name,
                        "the snapshot has a class \"" + name + "\" that this game does not define");
        from.require(std::find(classes_.begin(), classes_.end(), here->id()) == classes_.end(),
                     "one class twice");
        classes_.push_back(static_cast<std::uint16_t>(here->id()));
    }
}

/// Checks that this game makes the rows by the same classes: a class may have another base now.
void TreeImage::read_makers(ByteReader& from) const {
    for (const std::uint16_t id : classes_) {
        const std::string then(from.text());
        const Class& of = now_.classes[id];
        const std::string& now = maker_of(of).name();
        if (then == now) continue;
        for (std::uint32_t i = 1; i < nodes_.end(); ++i)
            if (nodes_[i].alive() && nodes_[i].class_id == id)
                refuse_changed(of.name() + " was a kind of " + then + " and is now a kind of " +
                               now);
    }
}

/// Checks that every instance could have been made and could have its name.
void TreeImage::check_instances(const ByteReader& from) const {
    // Services belong to the framework, whose parts hold their handles. So they must be the same.
    for (std::uint32_t i = 1; i < now_.nodes.end(); ++i) {
        const Node& here = now_.nodes[i];
        if (!here.alive() || here.parent != now_.root.index ||
            now_.classes[here.class_id].creatable())
            continue;
        const Node* there = nodes_.find(now_.nodes.handle(i));
        from.require(there != nullptr && there->class_id == here.class_id &&
                         there->parent == here.parent && there->name == here.name,
                     "it is of a game with other services or modules");
    }
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        const Node& node = nodes_[i];
        if (!node.alive()) continue;
        const Class& of = now_.classes[node.class_id];
        now_.classes.require_living(of);
        // Modules that save their rows themselves check which instances are theirs.
        from.require(
            of.creatable() || of.snapshots() == Snapshots::natively || existed_before(i, node),
            "it is of a game with other services or modules");
        if (node.parent == 0) continue;
        const Class& above = now_.classes[nodes_[node.parent].class_id];
        const Symbol name = Symbol::find(node.name.text());
        if (name && (above.property(name) != nullptr || above.method(name) != nullptr))
            refuse_changed("an instance of " + above.name() + " has a child called \"" +
                           name.text() + "\", which is now a " +
                           (above.property(name) != nullptr ? "property" : "method") + " of " +
                           above.name());
    }
}

/// Checks that every instance has a row of its own in the columns of its class.
void TreeImage::check_rows(const ByteReader& from) const {
    struct Rows {
        const StoredColumns* columns = nullptr;
        std::vector<bool> taken{};
    };
    std::vector<Rows> of_class(now_.classes.size());
    for (const auto& [id, columns] : columns_) of_class[id] = {columns.get(), columns->free_rows()};
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        const Node& node = nodes_[i];
        if (!node.alive() || now_.stored[node.class_id] == nullptr ||
            now_.classes[node.class_id].snapshots() == Snapshots::never)
            continue;
        Rows& rows = of_class[node.class_id];
        from.require(rows.columns != nullptr && node.stored_row < rows.columns->rows() &&
                         !rows.taken[node.stored_row],
                     "an instance without values of its own");
        rows.taken[node.stored_row] = true;
    }
}

/// Converts the values to the current properties. Values that do not fit become defaults.
void TreeImage::fit_values(const ByteReader& from) {
    const RestoredValues values(now_.tree, nodes_, from);
    std::vector<StoredColumns*> of_class(now_.classes.size());
    for (const auto& [id, columns] : columns_) of_class[id] = columns.get();
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        const Node& node = nodes_[i];
        if (!node.alive() || of_class[node.class_id] == nullptr) continue;
        StoredColumns& columns = *of_class[node.class_id];
        for (const Property* property : ClassRegistry::stored(now_.class_of(node))) {
            const Value saved = columns.get(*property, node.stored_row);
            const std::optional<Value> fitted = values.fitted(*property, saved);
            if (fitted && *fitted == saved) continue;
            if (!fitted) unfit_.add(*property, saved);
            columns.set(*property, node.stored_row, fitted ? *fitted : property->default_value);
        }
    }
    for (const AdHoc& own : ad_hoc_) values.check_ad_hoc(own.value);
    for (std::string& line : unfit_.lines()) remarks_.push_back(std::move(line));
}

void TreeImage::read_columns(ByteReader& from) {
    for (std::size_t n = from.count(12); n > 0; --n) {
        const auto there = from.get<std::uint32_t>();
        from.require(there < classes_.size(), "values of no class");
        const std::uint32_t here = classes_[there];
        for (const auto& [id, columns] : columns_) from.require(id != here, "one class twice");
        ByteReader block = from.block();
        if (now_.stored[here] == nullptr || now_.classes[here].snapshots() == Snapshots::never)
            continue;
        columns_.emplace_back(here, std::make_unique<StoredColumns>(StoredColumns::load(
                                        block, now_.classes[here], nodes_.end(), unfit_)));
        block.finish();
    }
}

/// Adds columns for classes that had no stored values at the time of the snapshot but have some
/// now.
void TreeImage::add_columns() {
    for (const std::uint16_t here : classes_) {
        if (now_.stored[here] == nullptr || now_.classes[here].snapshots() == Snapshots::never)
            continue;
        const bool there = std::any_of(columns_.begin(), columns_.end(),
                                       [&](const auto& each) { return each.first == here; });
        if (there) continue;
        auto columns = std::make_unique<StoredColumns>(now_.classes[here]);
        for (std::uint32_t i = 1; i < nodes_.end(); ++i)
            if (nodes_[i].alive() && nodes_[i].class_id == here)
                nodes_[i].stored_row = columns->add();
        columns_.emplace_back(here, std::move(columns));
    }
}

void TreeImage::read_ad_hoc(ByteReader& from) {
    std::set<std::pair<std::uint32_t, std::string>> seen;
    for (std::size_t n = from.count(13); n > 0; --n) {
        AdHoc own;
        own.index = from.get<std::uint32_t>();
        own.name = from.text();
        own.value = from.value();
        from.require(own.index < nodes_.end() && nodes_[own.index].alive() && !own.name.empty(),
                     "a property of no instance");
        from.require(seen.emplace(own.index, own.name).second, "one property twice");
        const Class& of = now_.classes[nodes_[own.index].class_id];
        from.require(nodes_.child(own.index, NodeName::look_up(own.name)) == 0,
                     "a property called like a child");
        if (of.method(own.name) != nullptr)
            refuse_changed("an instance of " + of.name() + " has a property called \"" + own.name +
                           "\", which is now a method of " + of.name());
        if (const Property* property = of.property(own.name))
            set_from_ad_hoc(*property, std::move(own));
        else
            ad_hoc_.push_back(std::move(own));
    }
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) nodes_[i].has_ad_hoc = false;
    for (const AdHoc& own : ad_hoc_) nodes_[own.index].has_ad_hoc = true;
}

/// The class has declared a property that was ad-hoc at the time of the snapshot. The property of
/// the class gets the value.
void TreeImage::set_from_ad_hoc(const Property& property, AdHoc own) {
    const Node& node = nodes_[own.index];
    if (property.binding.kind != BindingKind::stored) {
        remarks_.push_back(property.owner->name() + "." + property.name + ": the saved value " +
                           value_text(own.value) +
                           " belonged to an ad-hoc property; the class now gives the value");
        return;
    }
    for (const auto& [id, columns] : columns_)
        if (id == node.class_id && node.stored_row < columns->rows())
            columns->set(property, node.stored_row,
                         fit_saved_value(property, std::move(own.value), unfit_));
}

void TreeImage::read_values(ByteReader& from) {
    ByteReader block = from.block();
    while (!block.at_end()) {
        ByValue each;
        each.instance = block.get<Handle>();
        const Node* node = nodes_.find(each.instance);
        block.require(node != nullptr, "values of no instance");
        const Class& of = now_.classes[node->class_id];
        for (std::size_t n = block.count(9); n > 0; --n) {
            const std::string_view name = block.text();
            const Property* property = of.property(name);
            Value value = block.value();
            if (property == nullptr)
                unfit_.add_removed(of, name, std::move(value));
            else
                each.values.emplace_back(property, std::move(value));
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
        const Node* const node = nodes_.find(image.instance);
        from.require(node != nullptr, "a formula of no instance");
        const Property* const property = now_.classes[node->class_id].property(image.property);
        from.require(property == nullptr || takes_formula(*property),
                     "a formula of what can have none");
        formulas_.push_back(std::move(image));
    }
    if (memory == nullptr) {
        for (Formulas::Image& image : formulas_)
            if (const Formula* own = formula_of_game(image)) image.formula = *own;
        return;
    }
    const auto& held = *static_cast<const TreeMemory*>(memory.get());
    history_ = held.history;
    formulas_ = held.formulas;
    content_ = held.content;
}

/// A formula that has no text in the file: returns the formula that the running game has at the
/// same path. nullptr: the game has none there, or the formula has a text.
const Formula* TreeImage::formula_of_game(const Formulas::Image& image) const {
    if (!image.formula.source.empty()) return nullptr;
    std::vector<NodeName> way;
    std::uint32_t top = image.instance.index;
    for (; nodes_[top].parent != 0; top = nodes_[top].parent) way.push_back(nodes_[top].name);
    const Node* const here = now_.nodes.find(nodes_.handle(top));
    if (here == nullptr || here->parent != 0) return nullptr;
    for (; !way.empty() && top != 0; way.pop_back()) top = now_.nodes.child(top, way.back());
    if (top == 0) return nullptr;
    return state_.formulas.find({top, image.property});
}

}  // namespace fettle::property
