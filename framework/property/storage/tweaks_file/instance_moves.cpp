#include <tweaks_file/instance_moves.h>

#include <functional>
#include <map>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace fettle::property {

namespace {

// The mark, a zero byte at the start of a name, as it is written in paths.
constexpr std::string_view mark_in_paths = R"(["\000)";
constexpr std::string_view mark_in_json = R"([\"\\000)";

struct Replaced {
    std::string beginning, rest;
};

/// Replaces the longest beginning of `path` that is a key of `paths`.
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
    std::string home = beginning + rest;
    for (std::size_t end = beginning.size() + 1; !nows_.empty() && end <= home.size(); ++end) {
        if (end < home.size() && home[end] != '.' && home[end] != '[') continue;
        if (!nows_.contains(home.substr(0, end))) continue;
        const auto [parent, name] = split_path(home.substr(0, end));
        return path_below(parent, impossible_name(name)) + home.substr(end);
    }
    return home;
}

bool is_marked(const std::string& home) {
    return home.find(mark_in_paths) != std::string::npos;
}

bool may_have_marked_path(std::string_view json) {
    return json.find(mark_in_json) != std::string_view::npos;
}

std::string without_marks(const std::string& home) {
    if (!is_marked(home)) return home;
    const bool from_top = is_from_top(home);
    std::string path = from_top ? "" : "game";
    for (const Segment& segment : parse_path(from_top ? "game" + home : home)) {
        const auto& marked = std::get<std::string>(segment.key);
        const std::string name = is_impossible(marked) ? marked.substr(1) : marked;
        path = from_top ? path + path_suffix(name) : path_below(path, name);
    }
    return path;
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

InstanceMoves combined_moves(const std::vector<MoveStep>& moves) {
    std::unordered_map<std::string, std::string> targets;
    for (const MoveStep& move : moves) targets[move.from] = move.to;
    std::size_t depth = 0;
    const std::function<std::string(const std::string&)> now = [&](const std::string& path) {
        const auto [beginning, rest] = replaced(targets, path);
        if (beginning.empty()) return path;
        if (++depth > moves.size())
            throw Error(ErrorKind::rejected, path + " would be moved below itself");
        const auto [parent, name] = split_path(beginning);  // the parent may have moved too
        std::string whole = path_below(now(parent), name) + rest;
        --depth;
        return whole;
    };
    InstanceMoves all;
    for (const MoveStep& move : moves) all.add(move.from, now(move.from));
    return all;
}

namespace {

/// Orders moves of instances with the same depth.
void order_moves(std::vector<MoveStep> moves, std::vector<MoveStep>& ordered) {
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
            const std::string name = impossible_name(std::to_string(++in_between));
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
    for (auto& [depth, its] : by_depth) order_moves(std::move(its), ordered);
    return ordered;
}

}  // namespace fettle::property
