#include "history.h"

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include "state.h"

namespace fettle::property {
namespace {

std::size_t size_of(const History::CellState& state) {
    return sizeof state + size_of(state.value) +
           (state.formula ? state.formula->source.size() + 64 : 0);
}

std::string short_text(std::string text) {
    if (text.size() > 48) text = text.substr(0, 45) + "...";
    return text;
}

}  // namespace

// --- Recording
// -------------------------------------------------------------------------------------------------------

bool History::recording() const {
    return !tree_.state().replaying && recording(tree_.state().writer);
}

void History::begin(std::string name, bool scripts) {
    scripts_.push_back(scripts);
    script_edits_ += scripts;
    tree_.state().note_recording();
    if (depth_++ > 0) return;
    open_ = {};
    written_.clear();
    open_.name = std::move(name);
    open_.cause = tree_.cause();
}

void History::end() {
    if (depth_ == 0) return;
    script_edits_ -= scripts_.back();
    scripts_.pop_back();
    tree_.state().note_recording();
    if (--depth_ > 0) return;
    close();
}

void History::close() {
    if (open_.steps.empty()) return;
    for (const Shared& transaction : undone_) forget(*transaction);
    undone_.clear();
    bytes_ += open_.bytes;
    done_.push_back(std::make_shared<Transaction>(std::move(open_)));
    open_ = {};
    ++version_;
    trim();
}

void History::add(Step step, const std::string& name) {
    const bool single = depth_ == 0;
    if (single) begin(name, false);
    std::size_t bytes = sizeof(Step);
    if (const auto* edit = std::get_if<CellEdit>(&step))
        bytes += size_of(edit->before) + size_of(edit->after);
    if (const auto* existence = std::get_if<Existence>(&step))
        for (const Image& image : existence->images) {
            bytes += sizeof image;
            for (const auto& [symbol, state] : image.cells) bytes += size_of(state);
        }
    open_.bytes += bytes;
    tree_.add_weight(static_cast<std::int64_t>(bytes));
    if (const auto* edit = std::get_if<CellEdit>(&step))
        written_[{edit->instance.index, edit->property}] = open_.steps.size();
    else
        written_.clear();
    open_.steps.push_back(std::move(step));
    if (single) end();
}

History::CellState History::capture(Handle instance, const Property& property) const {
    CellState state;
    state.present = true;
    state.overridden = tree_.overridden(instance, property);
    state.value = tree_.peek(instance, property);
    if (const Formula* formula = tree_.formula(instance, property)) state.formula = *formula;
    return state;
}

History::Position History::position(Handle instance) const {
    const Tree::State& s = tree_.state();
    const Node& node = s.nodes[instance.index];
    Position at{.parent = s.nodes.handle(node.parent),
                .before = {},
                .name = node.name,
                .named = node.named != 0};
    if (node.parent != 0 && s.nodes[node.parent].first_child != instance.index)
        at.before = s.nodes.handle(node.previous);
    return at;
}

void History::edited(Handle instance, const Property& property, CellState before) {
    if (observer_ != nullptr) observer_->edited(instance, property, before);
    CellState after;
    if (tree_.find(instance, property.symbol) != nullptr) after = capture(instance, property);
    // A drag is many edits of one cell: only its ends are kept.
    const Cell cell{instance.index, property.symbol};
    if (const auto step = written_.find(cell); depth_ > 0 && step != written_.end()) {
        auto& edit = std::get<CellEdit>(open_.steps[step->second]);
        if (edit.instance == instance) {
            edit.after = std::move(after);
            return;
        }
    }
    const std::string name = tree_.path(instance, property) + ": " +
                             short_text(tree_.text(before.value, property.precision())) + " → " +
                             short_text(tree_.text(after.value, property.precision()));
    add(CellEdit{instance, property.symbol, std::move(before), std::move(after)}, name);
}

void History::moved(Handle instance, const Position& before) {
    if (observer_ != nullptr) observer_->moved(instance, before.parent, before.name.text());
    add(Move{instance, before, position(instance)}, "move " + tree_.path(instance));
}

void History::born(Handle instance) {
    if (observer_ != nullptr) observer_->born(instance);
    Existence existence;
    existence.top = instance;
    existence.birth = true;
    add(std::move(existence), "create " + tree_.path(instance));
}

void History::dying(Handle instance) {
    if (observer_ != nullptr) observer_->dying(instance);
    Existence existence;
    existence.top = instance;
    existence.images = images_of(instance);
    for (const Image& image : existence.images) {
        const Node& node = tree_.state().nodes[image.handle.index];
        if (node.watched) ++existence.lost_watchers;
    }
    keep_slots_ = true;
    add(std::move(existence), "delete " + tree_.path(instance));
}

std::vector<History::Image> History::images_of(Handle top) const {
    std::vector<Image> images;
    tree_.each_below(top, [&](Handle handle) {
        Image image;
        image.handle = handle;
        image.of = &tree_.class_of(handle);
        image.position = position(handle);
        for (const Property* property : tree_.properties(handle))
            if (!property->read_only && property->binding.kind != BindingKind::node)
                image.cells.emplace_back(property->symbol, capture(handle, *property));
        images.push_back(std::move(image));
    });
    return images;
}

// --- Forgetting
// ------------------------------------------------------------------------------------------------------

void History::forget(const Transaction& transaction) {
    bytes_ -= std::min(bytes_, transaction.bytes);
    for (const Step& step : transaction.steps)
        if (const auto* existence = std::get_if<Existence>(&step))
            for (const Image& image : existence->images)
                if (!tree_.alive(image.handle)) tree_.state().nodes.free_kept(image.handle);
}

void History::trim() {
    while (bytes_ > limit_ && done_.size() > 1) {
        forget(*done_.front());
        done_.pop_front();
        ++version_;
    }
}

void History::set_limit(std::size_t bytes) {
    limit_ = bytes;
    trim();
}

void History::clear() {
    for (const Shared& transaction : done_) forget(*transaction);
    for (const Shared& transaction : undone_) forget(*transaction);
    done_.clear();
    undone_.clear();
    bytes_ = 0;
    ++version_;
}

namespace {
template <class Done, class Undone>
struct HistoryImage {
    Done done;
    Undone undone;
    std::size_t bytes = 0;
};
}  // namespace

Memory History::image() const {
    using Lists = HistoryImage<decltype(done_), decltype(undone_)>;
    return std::make_shared<const Lists>(Lists{done_, undone_, bytes_});
}

// The slots of the dead that may come back are kept in the nodes' own image.
void History::restore(const Memory& image) {
    using Lists = HistoryImage<decltype(done_), decltype(undone_)>;
    static const Lists nothing;
    const Lists& lists = image == nullptr ? nothing : *static_cast<const Lists*>(image.get());
    done_ = lists.done;
    undone_ = lists.undone;
    bytes_ = lists.bytes;
    open_.steps.clear();  // an edit that is under way goes on from here
    written_.clear();
    open_.bytes = 0;
    ++version_;
}

std::vector<HistoryEntry> History::entries() const {
    std::vector<HistoryEntry> all;
    for (const Shared& t : done_) all.push_back({t->name, t->cause, t->steps.size(), false});
    for (auto t = undone_.rbegin(); t != undone_.rend(); ++t)
        all.push_back({(*t)->name, (*t)->cause, (*t)->steps.size(), true});
    return all;
}

// --- Undoing
// ---------------------------------------------------------------------------------------------------------

UndoResult History::undo() {
    if (depth_ > 0 && !open_.steps.empty())
        throw Error(ErrorKind::bad_structure, "nothing can be undone in the middle of an edit");
    if (done_.empty()) return {};
    Transaction transaction = *done_.back();
    done_.pop_back();
    UndoResult result = run(transaction, true);
    undone_.push_back(std::make_shared<Transaction>(std::move(transaction)));
    ++version_;
    return result;
}

UndoResult History::redo() {
    if (depth_ > 0 && !open_.steps.empty())
        throw Error(ErrorKind::bad_structure, "nothing can be done again in the middle of an edit");
    if (undone_.empty()) return {};
    Transaction transaction = *undone_.back();
    undone_.pop_back();
    UndoResult result = run(transaction, false);
    done_.push_back(std::make_shared<Transaction>(std::move(transaction)));
    ++version_;
    return result;
}

UndoResult History::run(Transaction& transaction, bool back) {
    UndoResult result{.done = true, .name = transaction.name, .notes = {}};
    const Tree::CauseScope scope(tree_, Writer::undo);
    struct Applying {
        bool& flag;
        explicit Applying(bool& f) : flag(f) { flag = true; }
        ~Applying() { flag = false; }
    } applying(applying_);
    const auto one = [&](Step& step) {
        std::visit([&](auto& what) { apply(what, back, result); }, step);
    };
    if (back)
        for (auto step = transaction.steps.rbegin(); step != transaction.steps.rend(); ++step)
            one(*step);
    else
        for (Step& step : transaction.steps) one(step);
    return result;
}

void History::set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result) {
    try {
        const Property* property = tree_.find(instance, name);
        if (!state.present) {
            if (property != nullptr) tree_.remove_ad_hoc(instance, name.text());
            return;
        }
        if (property == nullptr) {
            tree_.set_or_add(instance, name.text(),
                             state.value.is_nil() ? Value(false) : state.value);
            property = tree_.find(instance, name);
        }
        if (property == nullptr) return;
        // A formula that is in error leaves the default where it was, and is to go all the same.
        const bool stands =
            tree_.overridden(instance, *property) || tree_.formula(instance, *property) != nullptr;
        if (!state.overridden && stands)
            tree_.reset(instance, *property);
        else if (state.overridden && !(state.formula && state.value.is_nil()))
            tree_.set(instance, *property, state.value);
        if (state.formula) tree_.set_formula(instance, *property, *state.formula);
    } catch (const std::exception& error) {
        result.notes.push_back(exception_text(error));
    }
}

void History::apply(CellEdit& edit, bool back, UndoResult& result) {
    if (!tree_.alive(edit.instance)) {
        result.notes.push_back("an edit of \"" + edit.property.text() +
                               "\" is void: its instance was deleted since");
        return;
    }
    const Property* property = tree_.find(edit.instance, edit.property);
    CellState found;
    if (property != nullptr) found = capture(edit.instance, *property);
    set_cell(edit.instance, edit.property, back ? edit.before : edit.after, result);
    if (property == nullptr) property = tree_.find(edit.instance, edit.property);
    if (observer_ != nullptr && property != nullptr)
        observer_->edited(edit.instance, *property, found);
}

void History::apply(Move& move, bool back, UndoResult& result) {
    if (!tree_.alive(move.instance)) {
        result.notes.emplace_back("a move is void: its instance was deleted since");
        return;
    }
    const Position found = position(move.instance);
    place(move.instance, back ? move.before : move.after, result);
    if (observer_ != nullptr) observer_->moved(move.instance, found.parent, found.name.text());
}

void History::apply(Existence& existence, bool back, UndoResult& result) {
    if (existence.birth == back)
        bury(existence, result);
    else
        revive(existence, result);
}

void History::bury(Existence& existence, UndoResult& result) {
    if (!tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance to be deleted is gone already");
        return;
    }
    if (observer_ != nullptr) observer_->dying(existence.top);
    existence.images = images_of(existence.top);
    existence.lost_watchers = 0;
    for (const Image& image : existence.images)
        if (tree_.state().nodes[image.handle.index].watched) ++existence.lost_watchers;
    keep_slots_ = true;
    tree_.destroy(existence.top);
    keep_slots_ = false;
}

bool History::hangs_too_deep(const Existence& existence) const {
    const Nodes& nodes = tree_.state().nodes;
    std::unordered_map<std::uint32_t, std::size_t> depths;  // parents come before their children
    for (const Image& image : existence.images) {
        const std::uint32_t parent = image.position.parent.index;
        const auto above = depths.find(parent);
        const std::size_t depth = above != depths.end() ? above->second : nodes.depth(parent);
        if (depth + 1 > Nodes::deepest) return true;
        depths[image.handle.index] = depth + 1;
    }
    return false;
}

void History::revive(Existence& existence, UndoResult& result) {
    Tree::State& s = tree_.state();
    if (existence.images.empty() || tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance cannot be brought back: nothing is known of it");
        return;
    }
    if (!std::all_of(existence.images.begin(), existence.images.end(),
                     [&s](const Image& image) { return s.nodes.keeps(image.handle); })) {
        result.notes.emplace_back("an instance cannot be brought back: its place was given away");
        return;
    }
    if (const Handle parent = existence.images.front().position.parent;
        parent && !tree_.alive(parent)) {
        result.notes.push_back("\"" + existence.images.front().position.name.text() +
                               "\" cannot be brought back: what it hung under is gone");
        return;
    }
    if (hangs_too_deep(existence)) {
        result.notes.push_back("\"" + existence.images.front().position.name.text() +
                               "\" cannot be brought back: what it hung under hangs deeper now");
        return;
    }
    for (const Image& image : existence.images) {
        NodeName name = image.position.name;
        const std::uint32_t parent = image.position.parent.index;
        if (const std::uint32_t there = parent == 0 ? 0 : s.nodes.child(parent, name); there != 0) {
            // Below, it can only be what the parent made for itself just now; at the top, the
            // game's own.
            if (&image != &existence.images.front())
                tree_.destroy(s.nodes.handle(there));
            else
                name = s.nodes.free_name(parent, name.base.text());
        }
        s.make(*image.of, parent, name, image.position.named, image.handle);
    }
    // Values when all are there, so that references find whom they mean.
    for (const Image& image : existence.images)
        for (const auto& [symbol, state] : image.cells)
            set_cell(image.handle, symbol, state, result);
    place(existence.top, existence.images.front().position, result);
    if (observer_ != nullptr) observer_->born(existence.top);
    // Whoever buries them next has newer images, and the slots to give back.
    existence.images.clear();
    if (existence.lost_watchers > 0)
        result.notes.push_back("watchers of " + tree_.path(existence.top) +
                               " ended when it was deleted; they are not brought back");
}

void History::place(Handle instance, const Position& at, UndoResult& result) {
    Tree::State& s = tree_.state();
    if (at.parent && !tree_.alive(at.parent)) {
        result.notes.push_back(tree_.path(instance) + " stays: where it was is gone");
        return;
    }
    try {
        const bool taken = at.parent && s.nodes.child(at.parent.index, at.name) != 0 &&
                           s.nodes.child(at.parent.index, at.name) != instance.index;
        if (tree_.parent(instance) != at.parent)
            tree_.move(instance, at.parent, taken ? std::string() : at.name.text());
        else if (!taken)
            tree_.rename(instance, at.name.text());
        s.nodes[instance.index].named = at.named;
        if (at.parent)
            s.nodes.reorder(instance.index, tree_.alive(at.before) ? at.before.index : 0);
        s.tell([&](Observer& o) { o.moved(instance); });
    } catch (const Error& error) {
        result.notes.emplace_back(error.what());
    }
}

}  // namespace fettle::property
