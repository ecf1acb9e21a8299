// Records the changes of a tree and repeats them.

#include <fettle/property/write_log.h>

#include <bit>
#include <optional>
#include <utility>

#include <fettle/property/acceptance.h>

#include <tree/state.h>

#include "tree_image.h"

namespace fettle::property {

enum class WriteLog::EntryKind : std::uint8_t {
    plain,     // count, then that many PlainWrites
    value,     // handle, property, value
    computed,  // the same, written by the formula of the property
    reset,     // handle, property
    removed,
    element,        // handle, property, index, value; index 0: the last one was removed
    formula,        // handle, property, index of the formula
    formula_ended,  // handle, property
    created,        // handle, class, parent, name, named
    destroyed,      // handle, whether the slot was reserved for undo
    moved,          // handle, parent, sibling in front, name, named
    numbered,       // parent, stem, number
    called,         // handle, method, arguments, handles of made instances, answers of `accept`
    refreshed       // number of the part, argument: a part was brought up to date for a read
};

std::size_t LoggedWrites::memory() const {
    std::size_t sum = bytes.capacity() + history_bytes + (history != nullptr ? 128 : 0);
    for (const Formula& formula : formulas) sum += bytes_of(formula);
    return sum;
}

// --- Recording

WriteLog::WriteLog(Tree& tree) : tree_(tree), life_(tree.lifetime()) {
    tree_.observe(*this);
    tree_.state().changes.observers.logs.push_back(this);
    note_history();
}

WriteLog::~WriteLog() {
    if (life_.expired()) return;
    std::erase(tree_.state().changes.observers.logs, this);
    tree_.unobserve(*this);
}

LoggedWrites WriteLog::take() {
    tree_.state().changes.report_plain_writes();
    (void)notes();  // checks the size limit a last time
    LoggedWrites piece;
    piece.bytes = joined();
    piece.formulas = std::move(formulas_);
    piece.too_much = too_much_;
    forget();
    const History& history = tree_.state().history;
    if (history.version() != history_version_) {
        piece.history = history.image();
        piece.history_bytes = history.bytes_ever() + history.observed_bytes() - history_bytes_;
        note_history();
    }
    return piece;
}

void WriteLog::end_step() {
    tree_.state().changes.writes.end_step();
}

void WriteLog::note_history() {
    history_version_ = tree_.state().history.version();
    const History& history = tree_.state().history;
    history_bytes_ = history.bytes_ever() + history.observed_bytes();
}

void WriteLog::put_plain(std::vector<std::byte>& bytes, std::span<const PlainWrite> writes) {
    ByteWriter to(bytes);
    to.put(EntryKind::plain);
    to.put(static_cast<std::uint32_t>(writes.size()));
    const auto more = std::as_bytes(writes);
    bytes.insert(bytes.end(), more.begin(), more.end());
}

// The result is a copy, so the buffer is reused and the copy has the right size. The bytes contain
// symbols, classes and properties of this tree, so they begin with the number of the tree.
std::vector<std::byte> WriteLog::joined() const {
    std::vector<std::byte> all;
    if (!any()) return all;
    const std::uint64_t number = tree_.state().number;
    constexpr std::size_t head = sizeof(EntryKind) + sizeof(std::uint32_t);
    all.reserve(sizeof number + bytes_.size() + kept_.size() * head +
                kept_count_ * sizeof(PlainWrite));
    ByteWriter(all).put(number);
    auto from = bytes_.begin();
    const auto copy_up_to = [&](std::vector<std::byte>::const_iterator end) {
        all.insert(all.end(), from, end);
        from = end;
    };
    for (const Kept& kept : kept_) {
        copy_up_to(bytes_.begin() + static_cast<std::ptrdiff_t>(kept.at));
        put_plain(all, kept.writes.list);
    }
    copy_up_to(bytes_.end());
    return all;
}

void WriteLog::forget() {
    bytes_.clear();
    kept_.clear();
    kept_count_ = 0;
    formulas_.clear();
    formula_bytes_ = 0;
    too_much_ = false;
    if (bytes_.capacity() > max_kept) bytes_.shrink_to_fit();
}

bool WriteLog::notes() {
    if (memory() > limit_) {
        forget();
        bytes_.shrink_to_fit();
        too_much_ = true;
    }
    return calls_ == 0 && !too_much_;
}

std::size_t WriteLog::memory() const {
    return bytes_.size() + kept_count_ * sizeof(PlainWrite) + formula_bytes_;
}

void WriteLog::note(EntryKind what, Handle instance, const Property& property) {
    ByteWriter to(bytes_);
    to.put(what);
    to.put(instance);
    to.put(property.symbol.id());
}

namespace {

/// A property that is not saved is not written again. But a write to it may have changed the
/// properties from which it is computed, and those are saved: the zoom of a view changes its
/// height. Calls `visit` for each of those.
template <class Visit>
void each_source(const Tree& tree, Handle instance, const Property& property, Visit visit) {
    if (!property.transient || property.derives_from.empty() || !tree.alive(instance)) return;
    const Class& of = tree.class_of(instance);
    if (!belongs_to_the_present(of, property)) return;
    for (const std::string& name : property.derives_from) {
        const Property* const source = of.property(name);
        if (source != nullptr && !source->read_only && source->binding.kind != BindingKind::node)
            visit(*source);
    }
}

}  // namespace

void WriteLog::wrote_plain(const PlainWrites& writes) {
    if (!notes()) return;
    if (writes.list.size() < worth_keeping) {
        put_plain(bytes_, writes.list);
    } else {
        kept_.push_back({bytes_.size(), writes});
        kept_count_ += writes.list.size();
    }
    for (const PlainWrite& write : writes.list)
        if (write.instance) note_sources(write.instance, *write.property);
}

void WriteLog::wrote(Handle instance, const Property& property, const Value& now) {
    // A write to the name or the parent is recorded as a move.
    if (property.binding.kind == BindingKind::node || !notes()) return;
    const bool computed = tree_.state().changes.author.writer == Writer::formula;
    note(computed ? EntryKind::computed : EntryKind::value, instance, property);
    ByteWriter(bytes_).put(now);
    note_sources(instance, property);
}

void WriteLog::note_sources(Handle instance, const Property& property) {
    each_source(tree_, instance, property, [&](const Property& source) {
        note(EntryKind::value, instance, source);
        ByteWriter(bytes_).put(tree_.peek(instance, source));
    });
}

void WriteLog::wrote_element(Handle instance, const Property& property, std::size_t index,
                             const Value* element, const Value&) {
    if (!notes()) return;
    note(EntryKind::element, instance, property);
    ByteWriter to(bytes_);
    to.put(std::uint64_t{element != nullptr ? index : 0});
    if (element != nullptr) to.put(*element);
    note_sources(instance, property);
}

void WriteLog::was_reset(Handle instance, const Property& property) {
    if (notes()) note(EntryKind::reset, instance, property);
}

void WriteLog::removed(Handle instance, const Property& property) {
    if (notes()) note(EntryKind::removed, instance, property);
}

void WriteLog::formula_changed(Handle instance, const Property& property) {
    if (!notes()) return;
    const Formula* formula = tree_.formula(instance, property);
    note(formula != nullptr ? EntryKind::formula : EntryKind::formula_ended, instance, property);
    if (formula == nullptr) return;
    ByteWriter(bytes_).put(static_cast<std::uint32_t>(formulas_.size()));
    formulas_.push_back(*formula);
    formula_bytes_ += bytes_of(*formula);
}

void WriteLog::created(Handle instance) {
    if (calls_ > 0) {
        made_.push_back(instance);
        return;
    }
    if (!notes()) return;
    const Tree::State& s = tree_.state();
    const Node& node = s.instances.nodes[instance.index];
    ByteWriter to(bytes_);
    to.put(EntryKind::created);
    to.put(instance);
    to.put(node.class_id);
    to.put(s.instances.nodes.handle(node.parent));
    to.put(node.name);
    to.put(std::uint8_t{node.named});
}

void WriteLog::destroying(Handle instance) {
    if (!notes()) return;
    ByteWriter to(bytes_);
    to.put(EntryKind::destroyed);
    to.put(instance);
    to.put(std::uint8_t{tree_.state().instances.keep_slots});
}

void WriteLog::moved(Handle instance) {
    if (!notes()) return;
    const Position at = tree_.state().instances.nodes.position(instance.index);
    ByteWriter to(bytes_);
    to.put(EntryKind::moved);
    to.put(instance);
    to.put(at.parent);
    to.put(at.before);
    to.put(at.name);
    to.put(std::uint8_t{at.named});
}

void WriteLog::numbered(Handle parent, Symbol stem, std::uint32_t last) {
    if (!notes()) return;
    ByteWriter to(bytes_);
    to.put(EntryKind::numbered);
    to.put(parent);
    to.put(stem.id());
    to.put(last);
}

void WriteLog::call_begins(Handle instance, const Method& method,
                           std::span<const Value> arguments) {
    const bool outermost = notes();
    if (calls_++ > 0) return;
    made_.clear();
    call_noted_ = outermost;
    if (!outermost) return;
    ByteWriter to(bytes_);
    to.put(EntryKind::called);
    to.put(instance);
    to.put(method.symbol.id());
    to.put(std::uint64_t{arguments.size()});
    for (const Value& argument : arguments) to.put(argument);
}

void WriteLog::call_ends(Handle, const Method&) {
    if (--calls_ != 0 || !call_noted_) return;
    ByteWriter to(bytes_);
    to.put(made_);
    to.put(Acceptance::answers());
}

// A refresh inside a recorded call is not recorded: repeating the call refreshes the part.
void WriteLog::refreshing(SnapshotPart& part, std::uint64_t what) {
    if (!notes()) return;
    const std::uint64_t number = tree_.state().snapshots.number_of(part);
    if (number == 0) return;
    ByteWriter to(bytes_);
    to.put(EntryKind::refreshed);
    to.put(number);
    to.put(what);
}

// Writes since the last `take` belong to the abandoned state.
void WriteLog::restored() {
    forget();
    note_history();
}

// --- Playing

namespace {

[[noreturn]] void refuse_foreign() {
    throw Error(ErrorKind::rejected, "this piece of a log of writes belongs to another tree");
}

}  // namespace

class WriteLog::Player {
  public:
    Player(Tree& tree, const LoggedWrites& piece)
        : tree_(tree), s_(tree.state()), piece_(piece), from_(piece.bytes, "log of writes") {}

    void play() {
        if (from_.at_end()) return;
        if (from_.get<std::uint64_t>() != s_.number) refuse_foreign();
        while (!from_.at_end()) {
            const auto kind = from_.get<EntryKind>();
            auto times = kind == EntryKind::plain ? from_.get<std::uint32_t>() : 1u;
            for (; times > 0; --times) try {
                    repeat_entry(kind);
                } catch (const Error& error) {
                    // A write that is refused now was refused then too; the log itself is valid.
                    if (error.kind() == ErrorKind::damaged) throw;
                }
        }
    }

  private:
    void refresh();
    void repeat_entry(EntryKind kind);
    void value(EntryKind kind, Handle instance, Symbol name);
    void structure(EntryKind kind, Handle instance);
    void create(Handle instance);
    void move(Handle instance);
    void number(Handle parent);
    void call(Handle instance);
    void write(Handle instance, Symbol name, const Value& now) {
        if (const Property* property = tree_.find(instance, name)) {
            if (!is_of_the_present(instance, *property)) tree_.set(instance, *property, now);
        } else {
            s_.put_ad_hoc(instance, s_.ad_hoc_property(name), now);
        }
    }
    /// True if the property must not be written again: this would press a key, or change a
    /// setting that the player has changed since.
    bool is_of_the_present(Handle instance, const Property& property) const {
        return belongs_to_the_present(tree_.class_of(instance), property);
    }

    Tree& tree_;
    Tree::State& s_;
    const LoggedWrites& piece_;
    ByteReader from_;
};

void WriteLog::Player::refresh() {
    const auto number = from_.get<std::uint64_t>();
    const auto what = from_.get<std::uint64_t>();
    const SnapshotState& snapshots = s_.snapshots;
    for (SnapshotPart* part : snapshots.parts)
        if (snapshots.number_of(*part) == number) return part->refresh(what);
}

void WriteLog::Player::repeat_entry(EntryKind kind) {
    if (kind == EntryKind::refreshed) return refresh();
    if (kind == EntryKind::plain) {
        const auto done = from_.get<PlainWrite>();
        if (done.instance) write(done.instance, done.property->symbol, done.value());
        return;
    }
    const auto instance = from_.get<Handle>();
    if (kind >= EntryKind::created) return structure(kind, instance);
    value(kind, instance, std::bit_cast<Symbol>(from_.get<std::uint32_t>()));
}

/// Reads all operands first, so that the reader is at the next entry if the write fails.
void WriteLog::Player::value(EntryKind kind, Handle instance, Symbol name) {
    const auto index = kind == EntryKind::element ? from_.get<std::uint64_t>() : 0;
    const bool has_value = kind == EntryKind::value || kind == EntryKind::computed || index > 0;
    const Value now = has_value ? from_.value() : Value();
    const Formula* const formula =
        kind == EntryKind::formula ? &piece_.formulas.at(from_.get<std::uint32_t>()) : nullptr;
    const Property* property = tree_.find(instance, name);
    const bool is_past = property != nullptr && !is_of_the_present(instance, *property);
    switch (kind) {
        case EntryKind::value:
            return write(instance, name, now);
        case EntryKind::computed:
            if (is_past)
                s_.instances.write(instance.index, s_.instances.require(instance), *property, now);
            return;
        case EntryKind::reset:
            return is_past ? tree_.reset(instance, *property) : void();
        case EntryKind::element:
            if (is_past && index == 0) tree_.remove_last_element(instance, *property);
            if (is_past && index > 0) tree_.set_element(instance, *property, index, now);
            return;
        case EntryKind::removed:
            return tree_.remove_ad_hoc(instance, name.text());
        case EntryKind::formula:
            return tree_.set_formula(instance, name.text(), *formula);
        case EntryKind::formula_ended:
            return property != nullptr ? tree_.remove_formula(instance, *property) : void();
        default:
            from_.fail("an unknown kind of write");
    }
}

void WriteLog::Player::structure(EntryKind kind, Handle instance) {
    switch (kind) {
        case EntryKind::created:
            return create(instance);
        case EntryKind::destroyed:
            s_.instances.keep_slots = from_.boolean();
            std::erase(s_.structure.next_handles, instance);
            return tree_.destroy(instance);
        case EntryKind::moved:
            return move(instance);
        case EntryKind::numbered:
            return number(instance);
        default:
            return call(instance);
    }
}

void WriteLog::Player::create(Handle instance) {
    const auto class_id = from_.get<std::uint16_t>();
    const auto parent = from_.get<Handle>();
    const auto name = from_.get<NodeName>();
    const bool named = from_.boolean();
    // A child that its parent makes is recorded before the parent. It is made together with the
    // parent.
    if (parent && !tree_.alive(parent)) {
        s_.structure.next_handles.push_back(instance);
        return;
    }
    s_.structure.make(s_.instances.classes[class_id], parent.index, name, named, instance);
}

void WriteLog::Player::move(Handle instance) {
    const auto parent = from_.get<Handle>();
    const auto before = from_.get<Handle>();
    const auto name = from_.get<NodeName>();
    const bool named = from_.boolean();
    const std::uint32_t left = s_.instances.require(instance).parent;
    if (parent) s_.instances.require(parent);
    const std::uint32_t there = parent ? s_.instances.nodes.child(parent.index, name) : 0;
    if (parent && (parent == instance || tree_.is_below(parent, instance) ||
                   (there != 0 && there != instance.index)))
        throw Error(ErrorKind::bad_structure, "it cannot be moved there any more");
    // An instance with the same parent and name changes only its place among its siblings.
    if (left != parent.index || s_.instances.nodes[instance.index].name != name) {
        s_.instances.nodes.unlink(instance.index);
        s_.instances.nodes.link(instance.index, parent.index, name);
    }
    s_.instances.nodes[instance.index].named = named;
    s_.instances.nodes.reorder(instance.index, before.index);
    if (left != parent.index) s_.structure.place_subtree(instance);
}

/// If the parent does not exist yet, its children are made and counted together with it.
void WriteLog::Player::number(Handle parent) {
    const auto stem = std::bit_cast<Symbol>(from_.get<std::uint32_t>());
    const auto last = from_.get<std::uint32_t>();
    if (tree_.alive(parent)) s_.instances.nodes.set_last_number(parent.index, stem, last);
}

void WriteLog::Player::call(Handle instance) {
    const auto name = std::bit_cast<Symbol>(from_.get<std::uint32_t>());
    std::vector<Value> arguments(from_.count());
    for (Value& argument : arguments) argument = from_.value();
    for (const Handle made : from_.list<Handle>()) s_.structure.next_handles.push_back(made);
    const auto answers = from_.list<std::uint8_t>();
    std::optional<Acceptance> acceptance;
    if (!answers.empty())
        acceptance.emplace(tree_, name.text(), [&, asked = std::size_t{0}](Handle) mutable {
            return asked < answers.size() && answers[asked++] != 0;
        });
    try {
        if (const Method* method = tree_.class_of(instance).method(name))
            tree_.call(instance, *method, arguments);
    } catch (...) {
        // The call failed in the recording too.
    }
    s_.structure.next_handles.clear();
}

void WriteLog::play(const LoggedWrites& piece) {
    if (life_.expired()) throw Error(ErrorKind::deleted, "the tree of this log of writes is gone");
    tree_.state().underway.require_all_rows("play a log of writes");
    if (piece.history != nullptr && !tree_.state().history.owns(piece.history)) refuse_foreign();
    Player(tree_, piece).play();
    if (piece.history != nullptr) tree_.state().history.restore(piece.history);
}

}  // namespace fettle::property
