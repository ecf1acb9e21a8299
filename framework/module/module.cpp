#include <fettle/module/module.h>

namespace fettle::module {

Module::~Module() = default;  // defined here so that exactly one library has the vtable

}  // namespace fettle::module
