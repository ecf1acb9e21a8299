#pragma once
// State of a tree, and edits that involve several of its components.

#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/between_steps.h>
#include <fettle/property/explaining.h>

#include <history/history.h>
#include <values/process_data.h>

namespace fettle::property {

class AddedRules;
class PreparedParts;

/// State of snapshots that is kept between calls.
struct SnapshotState {
    std::vector<SnapshotPart*> parts;
    std::vector<std::uint64_t> numbers;  // of the parts, counted in the order of `add_part`
    std::uint64_t last_number = 0;
    /// 0 if it is not a part.
    std::uint64_t number_of(const SnapshotPart& part) const {
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i] == &part) return numbers[i];
        return 0;
    }
    std::vector<PreparedParts*> prepared;  // of the restores and checks that are going on
    std::size_t size = 0;                  // of the last snapshot
    std::vector<std::string> remarks;      // losses of the last restore
};

/// Throws Error(bad_name) if a member of the class has a reserved name (reserved_names.h).
void require_free_names(const std::vector<Symbol>& reserved, const ClassDescriptor& descriptor);

struct Tree::State {
    explicit State(Tree& owner) : tree(owner) {}

    CountedTree counted;
    Tree& tree;
    const std::uint64_t number = next_number();  // unique in the process
    Lifetime lifetime{tree};
    Underway underway;
    Instances instances{tree};
    Changes changes{instances, lifetime};
    Formulas formulas{changes, underway};
    Structure structure{formulas, underway};
    History history{structure};
    std::unordered_map<const Property*, Explainer> explainers;
    bool looked_at = false;                 // a tool shows an instance: explaining.h
    NotedSteps noted;                       // between_steps.h
    const Event* restored_event = nullptr;  // of Game
    SnapshotState snapshots;
    std::vector<std::pair<const Class*, AddedRules*>> added_rules;

    /// The name of an instance that takes the place of another now, by its index. Until the other
    /// is deleted, it has a name of its own, which no message shows.
    std::vector<std::pair<std::uint32_t, NodeName>> replacing;
    struct Replacing {
        State& in;
        Replacing(State& s, std::uint32_t index, const NodeName& name) : in(s) {
            in.replacing.emplace_back(index, name);
        }
        ~Replacing() { in.replacing.pop_back(); }
        Replacing(const Replacing&) = delete;
    };
    static const Symbol& name_while_replacing() {
        static const Symbol beside("\x1b replacing");
        return beside;
    }
    const NodeName& shown_name(std::uint32_t index, const Node& node) const {
        if (!replacing.empty() && node.name.base == name_while_replacing())
            for (const auto& [replaced, name] : replacing)
                if (replaced == index) return name;
        return node.name;
    }

    /// Rules for properties added to the instance, or nullptr.
    AddedRules* rules_of(Handle instance) const;

    // weight.cpp
    /// Notes how much memory the text or list has that was just written in place of `old`. It is
    /// read again, since the module may keep less: of a polygon, only the hull.
    void note_content(Handle instance, const Node& node, const Property& property,
                      const Value& old);

    /// The sum of `Instances::weight_of`.
    std::int64_t weight_of_instances() const;
    /// The texts and lists of all instances, as `TreeWeight::content` has them.
    TreeWeight::Content read_content() const;

    static std::uint64_t next_number();
    /// Throws if the tree must not be changed, because a formula or an inquiry runs. `what`:
    /// "delete an instance".
    void require_changeable(std::string_view what) const;

    // tree_placing.cpp
    /// Throws if the instance must not be moved or renamed now.
    void require_free(Handle instance, std::string_view what);
    /// Throws if the instance cannot be moved below `parent`, which may be null.
    void require_place(Handle instance, Handle parent);
    /// Moves the instance back if it can be moved now; never throws.
    void move_back(Handle instance, const Position& was) noexcept;

    // ad_hoc_edits.cpp
    const Property& ad_hoc_property(Symbol name);
    void put_ad_hoc(Handle instance, const Property& added, const Value& value);
    const Property& add_ad_hoc(Handle instance, std::string_view name, const Value& value);
};

}  // namespace fettle::property
