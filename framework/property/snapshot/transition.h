#pragma once
// The change from one state of a tree to another by a restore. The values of watched cells
// are stored before it, so that the differences can be reported afterwards.

#include <cstdint>
#include <span>
#include <vector>

#include <tree/state.h>

namespace fettle::property {

class Transition {
  public:
    explicit Transition(Tree::State& state);
    /// Called when the tree has its new state: queues the reports for watchers.
    void finish();

  private:
    struct Known {
        Handle instance;
        const Property* property;
        Value value;
    };
    struct Former {
        Handle instance;
        const Class* of;
        NodeName name;
        bool fresh;
    };
    void note(std::uint32_t index);
    /// Whether it is there still, as one of the same class.
    bool still_exists(const Former& former) const;
    const Former& before(Handle instance) const;
    std::span<const Known> known_of(Handle instance) const;
    bool watched(Handle self, const Node& node, const Property& property) const;
    void drop_queued();
    void end_instances();
    void restore_watchers();
    void notify_created();
    void notify_changed();

    Instances& instances_;
    Nodes& nodes_;
    Tree& tree_;
    Changes& changes_;
    const Event& restored_;
    std::vector<Known> known_;
    std::vector<Former> former_;               // all instances before the restore
    std::vector<Existence> deletion_notices_;  // of instances whose deletion is watched
    std::uint64_t step_before_ = 0;            // step before the restore
};

}  // namespace fettle::property
