#include <fettle/property/reserved_names.h>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

void reserve_names(Tree& tree, const std::vector<std::string>& names) {
    std::vector<Symbol>& reserved = tree.state().instances.reserved_names;
    reserved.clear();
    for (const std::string& name : names) reserved.emplace_back(name);
}

}  // namespace fettle::property
