#pragma once
// Formulas of a tree. Push dirty, pull values:
//
//   - a write marks the formulas that read the cell as *dirty*, and those that depend on these as
//   to *check*;
//   - a read settles: a formula to check asks its sources first and runs only when the version of
//   one is new.
//
// So a diamond is computed once and never half, and an unchanged result stops there. What a formula
// read is found by running it and found anew each time, so a branch not taken is no dependency; a
// name that did not exist is one, so a formula recovers when it appears. Cells that nobody
// announces (the simulation's, derived ones) are compared with what was read of them.

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/formula.h>
#include <fettle/property/formula_problems.h>
#include <fettle/property/tree.h>

#include <change/changes.h>
#include <guards/underway.h>

namespace fettle::property {

/// Whether the property can have a formula. What is read only cannot, nor can what tells where an
/// instance is (its name and its parent): a formula computes a value, it moves nothing.
bool takes_formula(const Property& property);

class Formulas {
  public:
    Formulas(Changes& changes, const Underway& underway)
        : changes_(changes), underway_(underway), tree_(changes.instances.tree) {}

    Changes& changes() { return changes_; }

    /// Makes formulas of their text; empty where nobody knows their language.
    FormulaCompiler compiler;

    void set(Handle instance, const Property& property, Formula formula);
    void remove(Cell cell);
    const Formula* find(Cell cell) const;

    /// For snapshots: all of them in order of making; and none of them.
    struct Image {
        Handle instance;
        Symbol property;
        Formula formula;
    };
    std::vector<Image> images() const;
    void clear();
    std::size_t size() const { return entries_.size(); }

    /// The path of the property whose formula runs.
    std::string running() const;

    /// A cell was written: what follows from that, for formulas and for all others.
    void written(Handle handle, const Node& node, const Property& property, const Value& old_value);
    /// An instance below `parent` has come, gone or been renamed.
    void name_changed(std::uint32_t parent, const NodeName& name);
    void instance_gone(std::uint32_t index);

    /// Makes the cell's value current. Throws Error(formula) when it is in error.
    void settle(Cell cell);
    /// All of them, in order of making; errors stay with the cells.
    void settle_all(bool stepped);
    std::string problem(Cell cell);
    /// To whom problems are told, and that what is wrong with a formula was told.
    std::function<void(const FormulaProblem&)> problem_sink;
    void tell_problems();
    void problem_told(Cell cell);
    /// Formulas of formulas are told `levels` deep: whoever reads that goes down by calls.
    Explanation why(Handle instance, const Property& property, std::vector<Cell>& seen,
                    int levels = most_levels);
    static constexpr int most_levels = 3000;

  private:
    enum class State : std::uint8_t { clean, check, dirty };
    struct Dependency : Read {
        std::uint64_t version = 0;  // of a cell with a formula
        bool formula = false;
        bool observed = false;
        std::uint32_t place = 0;  // of its formula among the dependents of the cell
        Value seen{};             // of an observed cell
    };
    struct Entry {
        Cell cell;
        Handle instance;
        const Property* property = nullptr;
        Formula formula;
        std::vector<Dependency> dependencies;
        std::string error;
        std::string cycle;  // found while it ran
        std::uint64_t number = 0;
        std::uint64_t version = 1;
        Value value;                // the last good result
        std::uint64_t checked = 0;  // epoch at which it was last known to be settled
        State state = State::dirty;
        bool volatile_sources =
            false;  // reads cells that nobody announces, itself or through another formula
        bool running = false;
        bool queued = false;   // on the way of `settle_known`
        bool removed = false;  // while it ran
    };

    /// A formula that read a cell, and which of its dependencies that is.
    struct Dependent {
        Entry* formula = nullptr;
        std::uint32_t dependency = 0;
    };
    struct Dependents {
        std::vector<Dependent> list;
        std::uint64_t marked = 0;  // `settlings_` when all of them were marked: they still are
    };

    Entry* entry(Cell cell) const;
    using Places = std::unordered_map<Cell, std::size_t, CellHash>;
    void enter_dependencies(Entry& e, std::vector<Dependency> found, const Places& places);
    void depend(Entry& e, std::uint32_t dependency);
    void depend_no_more(const Dependency& gone);
    bool settled(const Entry& e) const;
    /// What stands between an entry and being settled, as far as its sources of the last run tell.
    enum class Finding : std::uint8_t { unchanged, changed, unsettled_source };
    Finding look_at_sources(const Entry& e, Entry*& unsettled) const;
    void settle(Entry& e);
    void settle_known(Entry& e);
    void run(Entry& e);
    void note_settled(Entry& e);
    /// Where what is read now is noted; nullptr: nowhere. Returns where it was before.
    std::vector<Read>* note_in(std::vector<Read>* reads);
    void finish(Entry& e, const Value& result);
    void fail(Entry& e, const std::string& error);
    void set_dependencies(Entry& e, const std::vector<Read>& found);
    void make_volatile(Entry& e);
    void mark_dependents(Cell cell);
    bool fails_by_another(const Entry& e) const;
    std::string note_cycle(const Entry& again);

    Changes& changes_;
    const Underway& underway_;
    Tree& tree_;
    std::unordered_map<Cell, std::shared_ptr<Entry>, CellHash> entries_;
    std::vector<std::shared_ptr<Entry>> order_;  // of making; removed ones are passed over
    std::unordered_map<Cell, Dependents, CellHash> dependents_;
    // Errors that were told; they stay over a restore, which makes all formulas again.
    std::unordered_map<Cell, std::string, CellHash> told_;
    bool problems_changed_ = false;
    std::uint64_t settlings_ = 1;  // how often a formula was settled
    std::unordered_map<std::uint32_t, std::unordered_set<Symbol>>
        read_of_;                // index -> names with dependents
    std::vector<Entry*> stack_;  // those running, outermost first
    Entry* too_deep_ = nullptr;  // to be settled first, before the stack is climbed again
    bool pending_ = false;       // some entry is not clean
    std::size_t volatile_ = 0;
    std::uint64_t made_ = 0;
};

}  // namespace fettle::property
