#include <drawing/drawn_pose.h>

namespace fettle::physics_module {

property::Transform drawn_pose(void* context, const property::Tree&, Handle, Row row,
                               double alpha) {
    const auto [in, slot] = static_cast<Hosting*>(context)->at(row);
    const Frame frame(in, slot, alpha);
    return property::Transform::placed(frame.position(), frame.angle());
}

}  // namespace fettle::physics_module
