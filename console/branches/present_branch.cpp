#include <branches/present_branch.h>

#include <algorithm>
#include <utility>

#include <branches/branches.h>
#include <observed/game_time.h>

namespace fettle::console {

std::optional<std::int64_t> PresentBranch::left_after() {
    const property::Value now = time_value(tree_, "branch");
    if (!now.is(property::Type::text) || now.text() == name_) return std::nullopt;
    const std::string before = std::exchange(name_, now.text());
    if (before.empty()) return std::nullopt;
    const std::vector<OtherBranch> others = other_branches(tree_);
    const auto left = std::ranges::find(others, before, &OtherBranch::name);
    return left == others.end() ? -1 : left->fork;
}

}  // namespace fettle::console
