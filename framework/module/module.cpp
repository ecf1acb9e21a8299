#include <fettle/module/module.h>

namespace fettle::module {

Module::~Module() = default;  // here, so that one library holds the type for all

}  // namespace fettle::module
