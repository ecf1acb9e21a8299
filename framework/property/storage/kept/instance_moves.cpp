#include <kept/instance_moves.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace fettle::property {

namespace {

constexpr std::string_view new_mark = "_new_";

struct Replaced {
    std::string beginning, rest;
};

/// `path` with the beginning that `paths` has for the longest of its beginnings.
Replaced replaced(const std::unordered_map<std::string, std::string>& paths,
                  const std::string& path) {
    if (paths.empty()) return {{}, path};
    for (std::size_t end = path.size(); end > 0; --end) {
        if (end < path.size() && path[end] != '.' && path[end] != '[') continue;
        if (const auto found = paths.find(path.substr(0, end)); found != paths.end())
            return {found->second, path.substr(end)};
    }
    return {{}, path};
}

}  // namespace

void InstanceMoves::add(const std::string& home, const std::string& now) {
    homes_[now] = home;
    nows_[home] = now;
}

std::string InstanceMoves::home(const std::string& now) const {
    const auto [beginning, rest] = replaced(homes_, now);
    const std::string home = beginning + rest;
    for (std::size_t end = beginning.size() + 1; !nows_.empty() && end <= home.size(); ++end) {
        if (end < home.size() && home[end] != '.' && home[end] != '[') continue;
        if (!nows_.contains(home.substr(0, end))) continue;
        const auto [parent, name] = split_path(home.substr(0, end));
        return path_below(parent, std::string(new_mark) + name) + home.substr(end);
    }
    return home;
}

bool is_marked(const std::string& home) {
    return home.find(new_mark) != std::string::npos;
}

std::string without_marks(std::string home) {
    for (std::size_t at; (at = home.find(new_mark)) != std::string::npos;)
        home.erase(at, new_mark.size());
    return home;
}

std::string InstanceMoves::now(const std::string& home) const {
    const auto [beginning, rest] = replaced(nows_, home);
    return beginning + rest;
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

std::vector<MoveStep> parents_first(std::vector<MoveStep> moves) {
    std::sort(moves.begin(), moves.end(), [](const MoveStep& a, const MoveStep& b) {
        return a.from < b.from;  // the path of a parent is the beginning of the child's
    });
    return moves;
}

InstanceMoves whole_moves(const std::vector<MoveStep>& moves) {
    std::unordered_map<std::string, std::string> targets;
    for (const MoveStep& move : moves) targets[move.from] = move.to;
    const std::function<std::string(const std::string&)> now = [&](const std::string& path) {
        const auto [beginning, rest] = replaced(targets, path);
        if (beginning.empty()) return path;
        const auto [parent, name] = split_path(beginning);  // the parent may have moved, too
        return path_below(now(parent), name) + rest;
    };
    InstanceMoves all;
    for (const MoveStep& move : moves) all.add(move.from, now(move.from));
    return all;
}

namespace {

/// Moves of one depth.
void put_in_order(std::vector<MoveStep> moves, std::vector<MoveStep>& ordered) {
    std::unordered_set<std::string> taken;
    for (const MoveStep& move : moves) taken.insert(move.from);
    std::size_t in_between = 0;
    while (!moves.empty()) {
        std::vector<MoveStep> blocked;
        for (MoveStep& move : moves)
            if (move.to != move.from && taken.contains(move.to)) {
                blocked.push_back(std::move(move));
            } else {
                taken.erase(move.from);
                ordered.push_back(std::move(move));
            }
        if (blocked.size() == moves.size()) {
            MoveStep& first = blocked.front();
            const std::string name = "_in_between_" + std::to_string(++in_between);
            ordered.push_back(
                {first.which, first.from, path_below(split_path(first.from).first, name)});
            taken.erase(first.from);
            first.from = ordered.back().to;
        }
        moves = std::move(blocked);
    }
}

}  // namespace

std::vector<MoveStep> in_order(const std::vector<MoveStep>& moves) {
    std::map<std::size_t, std::vector<MoveStep>, std::greater<>> by_depth;
    for (const MoveStep& move : moves) by_depth[parse_path(move.from).size()].push_back(move);
    std::vector<MoveStep> ordered;
    for (auto& [depth, its] : by_depth) put_in_order(std::move(its), ordered);
    return ordered;
}

}  // namespace fettle::property
