#include <joints/joint_handle.h>
#include <joints/joint_types.h>
#include <solver/joints/direct_row.h>

// Prevents collisions of two bodies: contacts/filter.cpp reads the joint. A step never lists such a
// joint (`JointRecord::moves`), so it has no constraint.

namespace fettle::physics {
namespace detail {

struct FilterSettings {
    static constexpr JointType type = JointType::filter;
    void check() const {}
};

struct FilterConstraint {
    using Settings = FilterSettings;
    struct Impulses {
        void scale(float) {}
    };

    JointEnds ends;
    Impulses impulses;

    void prepare(const Settings&, const JointFrame&, const JointStep&, const SolverBody&,
                 const SolverBody&) {}
    void warm_start(SolverBody&, SolverBody&) const {}
    template <bool biased>
    void pass(SolverBody&, SolverBody&, const JointStep&) {}
    void write_rows(RowWriter&, const SolverBody&, const SolverBody&) {}
    JointLoad load() const { return {}; }
};

constinit const JointKind filter_joint = JointFunctions<FilterConstraint>::kind("filter");

}  // namespace detail

using namespace detail;

namespace {

void define(FilterSettings&, const FilterJointDef&) {}

}  // namespace

FETTLE_CREATE_JOINT(Filter, create_filter_joint, )

}  // namespace fettle::physics
