#include <branches/branches.h>

#include <variant>

namespace fettle::console {

std::vector<OtherBranch> other_branches(property::Tree& tree) {
    std::vector<OtherBranch> all;
    const property::Handle time = tree.child(tree.root(), "time");
    if (!time || tree.class_of(time).method("branches") == nullptr) return all;
    try {
        const property::Result result = tree.call(time, "branches", {});
        const auto* const records = std::get_if<std::vector<property::Record>>(&result);
        if (records == nullptr) return all;
        for (const property::Record& record : *records)
            all.push_back({record.get("name").text(), record.get("fork").integer(),
                           record.get("newest").integer()});
    } catch (const std::exception&) {
        // This game has no timeline.
    }
    return all;
}

}  // namespace fettle::console
