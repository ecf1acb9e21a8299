#pragma once
// Formulas of a tree. Dirty marks are pushed, values are pulled:
//
//   - a write marks the formulas that read the cell as *dirty*, and the formulas that depend on
//     those as *check*;
//   - a read settles: a formula marked *check* settles its sources first and runs only if the
//     version of one of them is new.
//
// So a formula with two paths to one source runs once, with current values, and an unchanged result
// marks nothing further. The dependencies of a formula are the cells that its last run read: a
// branch that was not taken is not a dependency. A name that did not exist is one, so the formula
// recovers when the name appears. Cells without announced changes (simulated and derived ones) are
// compared with the values that were read.

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

/// Whether the property can have a formula. Read-only properties cannot, nor can name and parent: a
/// formula computes a value, it does not move an instance.
bool takes_formula(const Property& property);

class Formulas {
  public:
    Formulas(Changes& changes, const Underway& underway)
        : changes_(changes), underway_(underway), tree_(changes.instances.tree) {}

    Changes& changes() { return changes_; }

    /// Compiles the text of a formula; empty if no language is registered.
    FormulaCompiler compiler;

    void set(Handle instance, const Property& property, Formula formula);
    void remove(Cell cell);
    const Formula* find(Cell cell) const;

    /// For snapshots: all formulas in the order of creation.
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

    /// Called when a cell was written: marks the dependents and reports the change.
    void written(Handle handle, const Node& node, const Property& property, const Value& old_value);
    /// Called when a child of `parent` was made, deleted or renamed.
    void name_changed(std::uint32_t parent, const NodeName& name);
    void instance_gone(std::uint32_t index);

    /// Makes the value of the cell current. Throws Error(formula) if the formula fails.
    void settle(Cell cell);
    /// Settles all formulas in the order of creation. Errors are stored in the cells.
    void settle_all(bool stepped);
    std::string problem(Cell cell);
    /// Receives errors of formulas, and the news that an error is over.
    std::function<void(const FormulaProblem&)> problem_sink;
    void report_problems();
    void problem_reported(Cell cell);
    /// `levels`: how many formulas of formulas are explained. The limit exists because a reader of
    /// the result may recurse.
    Explanation why(Handle instance, const Property& property, std::vector<Cell>& seen,
                    int levels = max_levels);
    static constexpr int max_levels = 3000;

  private:
    enum class State : std::uint8_t { clean, check, dirty };
    struct Dependency : Read {
        std::uint64_t version = 0;  // set if the cell has a formula
        bool formula = false;
        bool observed = false;
        std::uint32_t place = 0;  // index in the cell's list of dependents
        Value seen{};             // value of an observed cell
    };
    struct Entry {
        Cell cell;
        Handle instance;
        const Property* property = nullptr;
        Formula formula;
        std::vector<Dependency> dependencies;
        std::string error;
        std::string origin;  // the message of the formula that it read and where the error began
        std::string cycle;   // a cycle that was found during the run
        std::uint64_t number = 0;
        std::uint64_t version = 1;
        Value value;                // the last good result
        std::uint64_t checked = 0;  // epoch at which it was last settled
        State state = State::dirty;
        bool volatile_sources = false;  // depends on unannounced cells, directly or not
        bool running = false;
        bool queued = false;   // is in the list of `settle_known`
        bool removed = false;  // removed during its run
    };

    /// A formula that read a cell, and the index of that dependency.
    struct Dependent {
        Entry* formula = nullptr;
        std::uint32_t dependency = 0;
    };
    struct Dependents {
        std::vector<Dependent> list;
        std::uint64_t marked = 0;  // `settlings_` when all of them were marked
    };

    Entry* entry(Cell cell) const;
    using Places = std::unordered_map<Cell, std::size_t, CellHash>;
    void enter_dependencies(Entry& e, std::vector<Dependency> found, const Places& places);
    void depend(Entry& e, std::uint32_t dependency);
    void remove_dependent(const Dependency& gone);
    bool settled(const Entry& e) const;
    /// Whether the sources of the last run changed, or must be settled first.
    enum class Finding : std::uint8_t { unchanged, changed, unsettled_source };
    Finding check_sources(const Entry& e, Entry*& unsettled) const;
    void settle(Entry& e);
    void settle_known(Entry& e);
    void run(Entry& e);
    void note_settled(Entry& e);
    /// Sets the list that receives reads; nullptr: reads are not noted. Returns the previous list.
    std::vector<Read>* note_in(std::vector<Read>* reads);
    void finish(Entry& e, const Value& result);
    void fail_in_long_cycle(Entry& e);
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
    std::vector<std::shared_ptr<Entry>> order_;  // in order of creation; removed ones are skipped
    std::unordered_map<Cell, Dependents, CellHash> dependents_;
    // Errors that were reported. The map outlives a restore, which makes all formulas again.
    std::unordered_map<Cell, std::string, CellHash> reported_;
    bool problems_changed_ = false;
    std::uint64_t settlings_ = 1;  // number of settled formulas so far
    std::unordered_map<std::uint32_t, std::unordered_set<Symbol>>
        read_of_;                // slot -> names with dependents
    std::string passed_on_;      // where the error began that a read of a formula threw last
    std::vector<Entry*> stack_;  // running formulas, outermost first
    Entry* too_deep_ = nullptr;  // is settled first, then the stack is built again
    bool pending_ = false;       // some entry is not clean
    std::size_t volatile_ = 0;
    std::uint64_t made_ = 0;
};

}  // namespace fettle::property
