#include "ad_hoc.h"

#include <fettle/property/error.h>

namespace fettle::property {
namespace {

constexpr std::size_t max_descriptors = 100'000;

}  // namespace

const AdHoc::Entry* AdHoc::find(std::uint32_t index, const std::string& name) const {
    const auto own = of_instance.find(index);
    if (own == of_instance.end()) return nullptr;
    const auto found = own->second.find(name);
    return found == own->second.end() ? nullptr : &found->second;
}

const Property& AdHoc::declare(Symbol name) {
    if (descriptors.size() >= max_descriptors)
        throw Error(ErrorKind::bad_name,
                    "\"" + name.text().substr(0, 80) + "\": properties of " +
                        std::to_string(max_descriptors) +
                        " different names were added already; keep what is counted in a list, "
                        "or in children");
    auto made = std::make_unique<Property>();
    made->name = name.text();
    made->symbol = name;
    made->type = Type::nil;
    made->any_type = made->infinity = true;
    made->doc = "Added to this instance by a user.";
    made->binding.kind = BindingKind::ad_hoc;
    return *(descriptors[name] = std::move(made));
}

}  // namespace fettle::property
