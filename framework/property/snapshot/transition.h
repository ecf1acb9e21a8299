#pragma once
// From one state of a tree to another without a way between them: a restore. What watchers know
// is noted before it, so that afterwards they can be told what is different.

#include <cstdint>
#include <span>
#include <vector>

#include <tree/state.h>

namespace fettle::property {

class Transition {
  public:
    explicit Transition(Tree::State& state);
    /// The tree is what it is going to be: queues what its watchers are to hear.
    void finish();

  private:
    struct Known {
        Handle instance;
        const Property* property;
        Value value;
    };
    struct Lived {
        Handle instance;
        const Class* of;
        NodeName name;
        bool fresh;
    };
    void note(std::uint32_t index);
    std::span<const Known> known_of(Handle instance) const;
    bool watched(Handle self, const Node& node, const Property& property) const;
    void drop_queued();
    void end_instances();
    void watch_again();
    void tell_created();
    void tell_changed();

    Instances& instances_;
    Nodes& nodes_;
    Tree& tree_;
    Changes& changes_;
    const Event& restored_;
    std::vector<Known> known_;
    std::vector<Lived> lived_;          // everybody
    std::vector<Existence> farewells_;  // of those whose end somebody wants to hear of
    std::uint64_t left_ = 0;            // the step
};

}  // namespace fettle::property
