#pragma once
// A tree as bytes: instances, values that the tree keeps, formulas. The bytes are read and checked
// completely before anything changes; then the result replaces the tree.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/tree.h>

#include <formulas/formulas.h>

namespace fettle::property {

/// Parts of a snapshot that bytes cannot represent. They are used only in the tree that made them:
/// functions belong to the scripts of that tree, and edits to its classes.
struct TreeMemory {
    std::weak_ptr<const Tree*> of;
    std::vector<std::uint64_t> parts;  // the numbers of those that there were
    Memory history;
    std::vector<Formulas::Image> formulas;
    TreeWeight::Content content;
    /// Approximate memory in bytes. The history has a limit of its own.
    std::size_t bytes() const;
    /// Whether it was made by this tree.
    bool is_of(const Tree::State& state) const;
};

/// Whether the property is in no snapshot, so that a restore does not change it.
bool belongs_to_the_present(const Class& of, const Property& property);

class TreeImage {
  public:
    static std::shared_ptr<const TreeMemory> save(const Tree::State& state, ByteWriter& to);

    /// Throws Error(damaged, unknown_name); changes nothing.
    TreeImage(Tree::State& state, ByteReader& from, const Memory& memory);
    /// Visits all instances of the image.
    void each(const std::function<void(Handle, const Class&, Row)>& visit) const;
    /// Ends the rows of instances that the restore deletes, where modules make rows by value.
    /// Called before `put_nodes`.
    void end_rows();
    /// Replaces the nodes, the stored columns, and the history.
    void put_nodes();
    /// Makes rows and sets the values that modules hold. Called after the parts are restored.
    void put_values();

  private:
    struct AdHoc {
        std::uint32_t index;
        std::string name;
        Value value;
    };
    struct ByValue {
        Handle instance;
        std::vector<std::pair<const Property*, Value>> values;
    };
    struct SavedFormula {
        Handle instance;
        std::string property;
        Formula formula;
    };
    void read_classes(ByteReader& from);
    void read_columns(ByteReader& from);
    void add_columns();
    void read_ad_hoc(ByteReader& from);
    void read_values(ByteReader& from);
    void set_from_ad_hoc(const Property& property, AdHoc own);
    void read_formulas(ByteReader& from, const Memory& memory);
    const Formula* formula_of_game(const Formulas::Image& image) const;
    static const Class& maker_of(const Class& of);
    void read_makers(ByteReader& from) const;
    void put_formula(Formulas::Image& image, const Property& property);
    void check_instances(const ByteReader& from) const;
    void check_rows(const ByteReader& from) const;
    void fit_values(const ByteReader& from);
    void put_columns();
    void put_formulas();
    void make_rows();
    void drop(std::uint32_t index);
    std::string end_row(Handle self);
    /// Whether the slot had the same instance before, with the same class: in another tree the
    /// same handle may belong to an instance of another class.
    bool existed_before(std::uint32_t index, const Node& node) const;

    Tree::State& state_;
    Instances& now_;
    std::vector<std::uint16_t> classes_;  // by their number in the bytes
    Nodes nodes_;
    std::vector<std::pair<std::uint32_t, std::unique_ptr<StoredColumns>>> columns_;  // by class id
    std::vector<AdHoc> ad_hoc_;
    std::vector<ByValue> values_;
    std::vector<Formulas::Image> formulas_;
    std::optional<TreeWeight::Content> content_;  // none: it is read from the restored values
    std::vector<std::string> remarks_;            // one line for each loss
    UnfitValues unfit_;
    std::uint64_t step_ = 0;
    Memory history_;
    struct Before {
        std::uint32_t generation = 0;  // 0: the slot was free
        std::uint16_t class_id = 0;
    };
    std::vector<Before> before_;  // by slot: the instance before the restore
};

}  // namespace fettle::property
