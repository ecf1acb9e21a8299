#include "instance_moves.h"

#include <algorithm>
#include <utility>

namespace fettle::property {

namespace {

/// `path` with the beginning that `paths` has for the longest of its beginnings.
std::string replaced(const std::map<std::string, std::string>& paths, const std::string& path) {
    const std::pair<const std::string, std::string>* longest = nullptr;
    for (const auto& each : paths)
        if (is_at_or_below(path, each.first) &&
            (longest == nullptr || each.first.size() > longest->first.size()))
            longest = &each;
    return longest == nullptr ? path : longest->second + path.substr(longest->first.size());
}

}  // namespace

void InstanceMoves::add(const std::string& home, const std::string& now) {
    homes_[now] = home;
    nows_[home] = now;
}

std::string InstanceMoves::home(const std::string& now) const {
    return replaced(homes_, now);
}

std::string InstanceMoves::now(const std::string& home) const {
    return replaced(nows_, home);
}

std::string InstanceMoves::moved_from(const std::string& home) const {
    const auto found = nows_.find(home);
    return found == nows_.end() ? std::string() : found->second;
}

std::string InstanceMoves::moved_out_of(const std::string& home) const {
    for (const auto& [from, to] : nows_)
        if (from != home && is_at_or_below(from, home)) return to;
    return {};
}

std::vector<MoveStep> in_order(std::vector<MoveStep> moves) {
    std::vector<MoveStep> ordered;
    const auto depth = [](const MoveStep& move) { return parse_path(move.from).size(); };
    std::stable_sort(moves.begin(), moves.end(),
                     [&](const MoveStep& a, const MoveStep& b) { return depth(a) > depth(b); });
    std::size_t temporary = 0;
    while (!moves.empty()) {
        // Those of one depth: what is above them waits.
        const auto deepest = moves.begin();
        const auto end = std::find_if(deepest, moves.end(), [&](const MoveStep& move) {
            return depth(move) < depth(*deepest);
        });
        const auto next = std::find_if(deepest, end, [&](const MoveStep& move) {
            return std::none_of(deepest, end, [&](const MoveStep& other) {
                return &other != &move && other.from == move.to;
            });
        });
        if (next == end) {
            MoveStep& move = moves.front();
            const std::string name = "_in_between_" + std::to_string(++temporary);
            ordered.push_back(
                {move.which, move.from, path_below(split_path(move.from).first, name)});
            move.from = ordered.back().to;
            continue;
        }
        ordered.push_back(*next);
        moves.erase(next);
    }
    return ordered;
}

}  // namespace fettle::property
