#include <fettle/physics/damaged.h>
#include <world/world_data.h>

#include <algorithm>

// A change of a world is several changes of its lists. If memory runs out between two of them, the
// lists contradict each other, and a step that follows them would access memory outside of the
// arrays.

namespace fettle::physics::detail {

void WorldSelf::throw_damaged() {
    throw Damaged(
        "there was not enough memory in the middle of a change of this world, so its state is "
        "incomplete: restore a copy or a saved state, or destroy the world");
}

void WorldSelf::set_damaged() {
    work_.fetch_or(damage, std::memory_order_relaxed);
    thrown_ = nullptr;  // of a step that is not completed
}

void WorldData::mark_damaged_and_rethrow() {
    stepping = false;
    part<StepScratch>(*this) = StepScratch();  // a step relies on what the last one left
    self.set_damaged();
    for (auto* generations : {&body_generations, &shape_generations, &joint_generations})
        std::fill(generations->begin(), generations->end(), 0u);
    for (FieldRecord& field : fields) field.generation = 0;
    throw;
}

}  // namespace fettle::physics::detail
