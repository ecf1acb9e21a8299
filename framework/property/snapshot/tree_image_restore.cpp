// Replaces the state of a tree by an image that was read and checked.

#include <algorithm>
#include <set>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include <tree/state.h>

#include "tree_image.h"

namespace fettle::property {
namespace {

/// True if the rows of the class are not part of the snapshot: its module makes rows for restored
/// instances and ends the rows of the others.
bool makes_rows(const Class& of) {
    return of.snapshots() != Snapshots::natively;
}

}  // namespace

void TreeImage::each(const std::function<void(Handle, const Class&, Row)>& visit) const {
    for (std::uint32_t i = 1; i < nodes_.end(); ++i)
        if (nodes_[i].alive())
            visit(nodes_.handle(i), now_.classes[nodes_[i].class_id], nodes_[i].row);
}

bool TreeImage::existed_before(std::uint32_t index, const Node& node) const {
    return index < before_.size() && before_[index].generation == node.generation &&
           before_[index].class_id == node.class_id;
}

void TreeImage::end_rows() {
    // The snapshot replaces exactly the instances that exist now, so modules must not make others.
    struct Ending {
        bool& flag;
        explicit Ending(bool& f) : flag(f) { flag = true; }
        ~Ending() { flag = false; }
    } ending(state_.underway.ending_rows);
    for (std::uint32_t i = 1; i < before_.size(); ++i) {
        if (before_[i].generation == 0) continue;
        const Handle self{i, before_[i].generation};
        const Node* const stays = nodes_.find(self);
        if (stays != nullptr && stays->class_id == before_[i].class_id) continue;
        const Class& of = now_.classes[before_[i].class_id];
        if (makes_rows(of)) {
            const std::string problem = end_row(self);
            if (!problem.empty())
                remarks_.push_back(
                    now_.tree.path(self) +
                    ": its module failed when it was notified of the removal: " + problem);
        }
        if (of.snapshots() == Snapshots::never && now_.stored[of.id()] != nullptr)
            now_.stored[of.id()]->remove(now_.nodes[i].stored_row);
    }
}

void TreeImage::put_nodes() {
    Tree::State& s = state_;
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        Node& node = nodes_[i];
        node.watched = node.fresh = node.has_formula = node.has_dependents = false;
        if (!node.alive()) continue;
        const Class& of = now_.classes[node.class_id];
        const bool lived = existed_before(i, node);
        // These rows are made again, or are those of the running game.
        if (makes_rows(of)) node.row = lived ? now_.nodes[i].row : 0;
        if (makes_rows(of) && !lived && of.lifecycle().create) s.underway.unmade.insert(i);
        if (of.snapshots() == Snapshots::never && now_.stored[of.id()] != nullptr)
            node.stored_row = lived ? now_.nodes[i].stored_row : now_.stored[of.id()]->add();
    }
    s.changes.weight.bytes -= s.weight_of_instances();
    // Formulas depend on cells of the table that is replaced.
    s.formulas.clear();
    now_.nodes.replace(std::move(nodes_));
    s.changes.queue.fresh.clear();
    put_columns();
    s.changes.weight.bytes += s.weight_of_instances();
    s.changes.weight.replace_content(content_ ? *content_ : TreeWeight::Content{});
    s.changes.report_plain_writes();
    s.changes.author.step = step_;
    s.changes.stepped = s.changes.edited = true;
    ++s.changes.invalidations;
    s.history.restore(history_);
}

void TreeImage::put_columns() {
    Tree::State& s = state_;
    for (auto& [id, columns] : columns_) now_.stored[id] = std::move(columns);
    // A class that the snapshot does not contain has no instances.
    for (std::uint32_t id = 0; id < now_.classes.size(); ++id) {
        const bool contained = std::find(classes_.begin(), classes_.end(), id) != classes_.end();
        if (!contained && now_.stored[id] != nullptr &&
            now_.classes[id].snapshots() != Snapshots::never)
            now_.stored[id] = std::make_unique<StoredColumns>(now_.classes[id]);
    }
    now_.ad_hoc.of_instance.clear();
    now_.ad_hoc.tracks.clear();
    for (AdHoc& own : ad_hoc_) {
        const Property& property = s.ad_hoc_property(Symbol(own.name));
        now_.ad_hoc.of_instance[own.index].emplace(own.name,
                                                   std::pair(&property, std::move(own.value)));
    }
}

void TreeImage::put_formulas() {
    Tree::State& s = state_;
    s.formulas.clear();
    for (Formulas::Image& image : formulas_) {
        if (now_.nodes.find(image.instance) == nullptr) continue;
        const Property* property = now_.tree.find(image.instance, image.property);
        if (property == nullptr) continue;
        put_formula(image, *property);
    }
}

void TreeImage::put_formula(Formulas::Image& image, const Property& property) {
    Tree::State& s = state_;
    const auto lost = [&](const std::string& why) {
        remarks_.push_back(now_.tree.path(image.instance, property) + ": its formula " + why +
                           "; it keeps the value that it had");
    };
    if (!image.formula.function) {
        if (image.formula.source.empty()) return lost("was not saved");
        if (!s.formulas.compiler) return lost("cannot be compiled here");
        try {
            const FormulaCompiler compile = s.formulas.compiler;  // the compiler may replace itself
            image.formula = compile(image.formula.source);
        } catch (...) {
            return lost("does not compile any more: " + exception_text());
        }
        if (now_.nodes.find(image.instance) == nullptr) return;  // the compiler has deleted it
    }
    s.formulas.set(image.instance, property, image.formula);
}

/// Makes the rows of classes that are saved by value; parents before children.
void TreeImage::make_rows() {
    Tree::State& s = state_;
    if (s.underway.unmade.empty()) return;
    // An instance that a module makes below its own meanwhile has its row already.
    std::vector<Handle> all;
    for (std::uint32_t top = 1; top < now_.nodes.end(); ++top)
        if (now_.nodes[top].alive() && now_.nodes[top].parent == 0)
            now_.visit_below(top, [&](std::uint32_t i) { all.push_back(now_.nodes.handle(i)); });
    std::vector<Handle> refused;  // parents before children
    std::set<std::uint32_t> without;
    const auto make = [&](Handle self) {
        const std::uint32_t i = self.index;
        const Lifecycle& lifecycle = now_.class_of(now_.nodes[i]).lifecycle();
        const bool below = without.contains(now_.nodes[i].parent);  // deleted with its parent
        if (below) without.insert(i);
        if (s.underway.unmade.erase(i) == 0) return;
        bool has_row = false;
        try {
            if (!below) {
                const Hold making(s.underway, self, being_made);
                const Row made = lifecycle.create(lifecycle.context, now_.tree, self);
                now_.nodes[i].row = made;
                has_row = true;
                if (!lifecycle.place || now_.nodes[i].parent == 0) return;
                const Row row = lifecycle.place(lifecycle.context, now_.tree, self, made);
                now_.nodes[i].row = row;
                return;
            }
        } catch (...) {  // the module refuses it, for lack of room perhaps
            remarks_.push_back(now_.tree.path(self) +
                               ": it cannot be made, and is missing with all " +
                               "that was below it: " + exception_text());
            if (has_row) (void)end_row(self);
        }
        without.insert(i);
        refused.push_back(self);
    };
    for (const Handle self : all)
        if (now_.nodes.find(self) != nullptr) make(self);
    for (auto self = refused.rbegin(); self != refused.rend(); ++self)
        if (now_.nodes.find(*self) != nullptr) drop(self->index);
}

/// Ends a row. Returns the text of the exception that its module threw; "" if there was none.
std::string TreeImage::end_row(Handle self) {
    const Node& node = now_.nodes[self.index];
    const Lifecycle& lifecycle = now_.classes[node.class_id].lifecycle();
    if (!lifecycle.destroy) return "";
    try {
        lifecycle.destroy(lifecycle.context, now_.tree, self, node.row);
    } catch (...) {
        const std::string problem = exception_text();
        return problem.empty() ? "an error without a text" : problem;
    }
    return "";
}

/// Deletes an instance whose row could not be made, with everything below it.
void TreeImage::drop(std::uint32_t index) {
    Tree::State& s = state_;
    while (now_.nodes[index].first_child != 0)
        s.structure.destroy_below(now_.nodes[index].first_child);
    const Class& of = now_.classes[now_.nodes[index].class_id];
    s.changes.weight.add(-now_.weight_of(index));
    s.changes.weight.remove_content(index);
    if (now_.stored[of.id()]) now_.stored[of.id()]->remove(now_.nodes[index].stored_row);
    if (now_.nodes[index].has_ad_hoc) now_.ad_hoc.of_instance.erase(index);
    now_.nodes.unlink(index);
    now_.nodes.release(index);
}

void TreeImage::put_values() {
    make_rows();
    Tree::State& s = state_;
    for (const ByValue& each : values_)
        for (const auto& [property, value] : each.values) {
            if (now_.nodes.find(each.instance) == nullptr) break;  // deleted by `drop`
            const Node& node = now_.nodes[each.instance.index];
            try {
                if (now_.read(each.instance.index, node, *property) == value) continue;
                // A reference to an instance that was deleted when the snapshot was taken is nil
                // now.
                const bool gone =
                    value.is(Type::reference) && now_.nodes.find(value.reference()) == nullptr;
                now_.write(
                    each.instance.index, node, *property,
                    now_.tree.coerce(each.instance, *property, gone ? Value(Handle{}) : value));
            } catch (...) {
                // The module refuses its former value and keeps the current one.
                remarks_.push_back(now_.tree.path(each.instance, *property) + ": the saved value " +
                                   now_.tree.text(value) + " is refused: " + exception_text());
            }
        }
    put_formulas();
    if (!content_) s.changes.weight.replace_content(s.read_content());
    s.snapshots.remarks = std::move(remarks_);
}

}  // namespace fettle::property
