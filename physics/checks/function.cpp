#include <fettle/physics/function.h>

#include <stdexcept>

namespace fettle::physics::detail {

void refuse_empty_call() {
    throw std::logic_error("Function: expected a function to call, found an empty one");
}

}  // namespace fettle::physics::detail
