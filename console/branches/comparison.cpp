#include <branches/comparison.h>
#include <observed/game_time.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/fixed_text.h>
#include <fettle/property/path.h>
#include <fettle/property/pose.h>
#include <fettle/property/spelling.h>

#include <branches/branches.h>

namespace fettle::console {

using property::Handle;
using property::Type;
using property::Value;

bool has_position(const property::Tree& tree, Handle instance) {
    const property::Property* const position = tree.find(instance, "position");
    return position != nullptr && (position->type == Type::vec2 || position->any_type);
}

namespace {

/// Whether the children of the instance are on the screen, and not in the world.
bool is_on_screen(const property::Tree& tree, Handle instance) {
    const property::Property* const space = tree.class_of(instance).property("space");
    return space != nullptr && tree.peek(instance, *space) == Value("screen");
}

/// The topmost instances in the world with a position: bodies and sprites, not what belongs to
/// them.
std::vector<Handle> placed(const property::Tree& tree) {
    std::vector<Handle> all;
    const auto visit = [&](const auto& self, Handle top) -> void {
        for (Handle each = tree.first_child(top); each; each = tree.next_sibling(each)) {
            if (is_on_screen(tree, each)) continue;
            if (has_position(tree, each))
                all.push_back(each);
            else
                self(self, each);
        }
    };
    visit(visit, tree.root());
    return all;
}

std::string meters(double length) {
    return property::fixed_text(length, 2) + " m";
}

}  // namespace

const Pose* Comparison::Moment::find(Handle instance) const {
    const auto place = std::ranges::find(poses, instance, &Pose::instance);
    return place == poses.end() ? nullptr : &*place;
}

const Pose* Comparison::Moment::counterpart(const Moment& other, std::size_t pose) const {
    if (const Pose* const same = find(other.poses[pose].instance)) return same;
    if (pose >= other.paths.size()) return nullptr;
    const auto path = std::ranges::find(paths, other.paths[pose]);
    return path == paths.end() ? nullptr : &poses[static_cast<std::size_t>(path - paths.begin())];
}

void Comparison::request_change(const std::string& path, const Value& value, double seconds) {
    const property::Place place = property::resolve(tree_, path);
    if (place.property == nullptr)
        throw property::Error(property::ErrorKind::wrong_type,
                              "ab: " + path + " is an instance: expected a property");
    if (place.property->read_only)
        throw property::Error(property::ErrorKind::rejected, "ab: " + path + " is read-only");
    if (!(seconds >= 0.1 && seconds <= 60))
        throw property::Error(
            property::ErrorKind::out_of_range,
            "ab: " + property::number_text(seconds) + " seconds: expected a time from 0.1 to 60");
    end();
    change_request_ = {path, place.instance, value, seconds};
}

void Comparison::request_branch(const std::string& name) {
    const std::vector<OtherBranch> all = other_branches(tree_);
    const auto other = name.empty() ? (all.empty() ? all.end() : std::prev(all.end()))
                                    : std::ranges::find(all, name, &OtherBranch::name);
    if (other == all.end()) {
        std::vector<std::string> names;
        names.reserve(all.size());
        for (const OtherBranch& each : all) names.push_back(each.name);
        throw property::Error(
            property::ErrorKind::unknown_name,
            "compare_branch: " +
                (all.empty()
                     ? std::string("there are no other branches of the past")
                     : "there is no branch \"" + name + "\"" + property::suggestion(name, names)));
    }
    end();
    branch_request_ = BranchRequest{other->name, other->fork, other->newest};
}

void Comparison::end() {
    change_request_.reset();
    branch_request_.reset();
    a_.clear();
    b_.clear();
    if (drawn_) former_ = std::move(drawn_);
}

std::int64_t Comparison::first_step(const ChangeRequest& request) const {
    const Value dt = time_value(tree_, "dt"), oldest = time_value(tree_, "oldest");
    const auto here = static_cast<std::int64_t>(tree_.step());
    double steps = std::round(request.seconds / (dt.is(Type::number) ? dt.number() : 1.0 / 60));
    const auto poses = static_cast<double>(std::max<std::size_t>(1, placed(tree_).size()));
    steps = std::min(steps, std::max(1.0, static_cast<double>(most_poses) / poses));
    const std::int64_t first = here - static_cast<std::int64_t>(steps);
    return std::max(first, oldest.is(Type::integer) ? oldest.integer() : 0);
}

Comparison::Moment Comparison::moment(std::int64_t step, bool with_paths) {
    Moment made{.step = step};
    for (const Handle instance : placed(tree_)) {
        const auto at = property::place_below(tree_, instance, false, 1);
        if (at) made.poses.push_back({instance, at->origin, std::atan2(at->x.y, at->x.x)});
    }
    if (with_paths)
        for (const Pose& each : made.poses) made.paths.push_back(tree_.path(each.instance));
    if (seen) made.seen = seen();
    made.items = drawn_->note(tree_, made.poses, made.seen);
    return made;
}

void Comparison::between_frames(const Review& review, const RepeatWith& repeat_with,
                                const ReviewBranch& other) {
    former_.reset();
    if (waits()) drawn_ = std::make_unique<DrawnPast>();
    if (change_request_) compare_change(review, repeat_with);
    if (branch_request_) compare_branches(review, other);
}

/// Throws if the instance of the property that is meant now was made later than at this moment,
/// which is the first one: another may have had its path.
void Comparison::require_there(const ChangeRequest& request, std::int64_t first) const {
    try {
        if (property::resolve(tree_, request.path).instance == request.instance) return;
    } catch (const property::Error&) {
        // Nothing had this path.
    }
    throw property::Error(property::ErrorKind::unknown_name,
                          request.path + " was not yet there at the beginning, step " +
                              std::to_string(first) + ": ask for fewer seconds");
}

void Comparison::compare_change(const Review& review, const RepeatWith& repeat_with) {
    const ChangeRequest request = *std::exchange(change_request_, std::nullopt);
    const std::int64_t first = first_step(request);
    if (!review || !repeat_with || first >= static_cast<std::int64_t>(tree_.step()))
        return report_error("ab: there is no past to compare with");
    std::string written;
    const auto change = [&] {
        require_there(request, first);
        const property::Tree::CauseScope cause(tree_, property::Writer::console);
        property::set(tree_, request.path, request.value);
        const property::Place place = property::resolve(tree_, request.path);
        written = tree_.text(property::get(tree_, request.path), place.property->precision());
    };
    try {
        const auto here = static_cast<std::int64_t>(tree_.step());
        const auto into = [this, here](std::vector<Moment>& side) {
            return [this, here, &side](std::int64_t step) {
                side.push_back(moment(step, step == here));
            };
        };
        repeat_with(first, change, into(b_));
        review(first, here, into(a_));
    } catch (const std::exception& error) {
        end();
        return report_error("ab: " + property::exception_text(error));
    }
    cut_to_common_steps();
    original_ = "as it was";
    change_ = request.path + " = " + written;
    ++number_;
    report_difference("ab " + change_);
}

/// Keeps only the steps that both sides have.
void Comparison::cut_to_common_steps() {
    if (!shown()) return end();
    const std::int64_t first = std::max(a_.front().step, b_.front().step);
    const std::int64_t last = std::min(a_.back().step, b_.back().step);
    for (auto* side : {&a_, &b_})
        std::erase_if(*side,
                      [&](const Moment& each) { return each.step < first || each.step > last; });
}

void Comparison::compare_branches(const Review& review, const ReviewBranch& other) {
    const BranchRequest request = *std::exchange(branch_request_, std::nullopt);
    if (!review || !other) return report_error("compare_branch: this game keeps no past");
    const std::int64_t here = static_cast<std::int64_t>(tree_.step());
    const auto poses = static_cast<std::int64_t>(std::max<std::size_t>(1, placed(tree_).size()));
    const std::int64_t steps = std::max<std::int64_t>(1, most_poses / poses);
    const std::int64_t last = std::min({here, request.newest, request.fork + steps});
    if (last <= request.fork)
        return report_error("compare_branch: the game is at step " + std::to_string(here) +
                            ", before the branches part after step " +
                            std::to_string(request.fork));
    NotedValues of_a, of_b;
    const auto into = [&](std::vector<Moment>& side, NotedValues& values) {
        return [&, last](std::int64_t step) {
            if (step <= last) side.push_back(moment(step, step == last));
            if (step == last) values = NotedValues(tree_);
        };
    };
    try {
        other(request.name, request.fork, into(b_, of_b));
        review(request.fork, last, into(a_, of_a));
    } catch (const std::exception& error) {
        end();
        return report_error("compare_branch: " + property::exception_text(error));
    }
    cut_to_common_steps();
    if (!shown()) return report_error("compare_branch: the branches have no step in common");
    original_ = "branch " + time_value(tree_, "branch").text();
    change_ = "branch " + request.name;
    ++number_;
    report_difference("A " + original_ + ", B " + change_);
    report_values(of_a, of_b);
}

/// Logs values that differ and do not come from the simulation.
void Comparison::report_values(const NotedValues& a, const NotedValues& b) {
    constexpr std::size_t most_lines = 20;
    const std::vector<std::string> lines = differences(tree_, a, b);
    for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i) report(lines[i]);
    if (lines.size() > most_lines)
        report("… " + std::to_string(lines.size() - most_lines) + " more differences");
    if (!a.complete() || !b.complete())
        report("only the first " + std::to_string(NotedValues::most) + " values were compared");
}

/// Logs how many instances end elsewhere, and the farthest one.
void Comparison::report_difference(const std::string& what) {
    if (!shown()) return;
    lacks_drawing_ = scripts_draw && scripts_draw();
    const Moment &a = a_.back(), &b = b_.back();
    std::size_t moved = 0, only_b = 0, only_a = 0, farthest = 0;
    double most = 0;
    for (std::size_t i = 0; i < b.poses.size(); ++i) {
        const Pose* const other = a.counterpart(b, i);
        if (other == nullptr) {
            ++only_b;
            continue;
        }
        const double way = (b.poses[i].position - other->position).length();
        if (way > apart) ++moved;
        if (way > most) most = way, farthest = i;
    }
    for (std::size_t i = 0; i < a.poses.size(); ++i)
        only_a += b.counterpart(a, i) == nullptr ? 1 : 0;
    std::string line = what + " since step " + std::to_string(a_.front().step) + ": " +
                       std::to_string(moved) + " of " + std::to_string(b_.back().poses.size()) +
                       " end elsewhere";
    if (moved > 0 && farthest < b.paths.size())
        line += ", " + b.paths[farthest] + " by " + meters(most);
    for (const auto& [count, side] : {std::pair{only_a, "A"}, {only_b, "B"}})
        if (count > 0)
            line += "; " + std::to_string(count) + (count == 1 ? " exists in " : " exist in ") +
                    side + " only";
    if (const std::size_t looks = count_different_looks())
        line += "; " + std::to_string(looks) + (looks == 1 ? " looks" : " look") + " different";
    report(line);
}

/// How many of the instances that both have at the end are drawn in another way there.
std::size_t Comparison::count_different_looks() const {
    using Looks = std::unordered_map<std::uint64_t, std::vector<DrawnPast::Item>>;
    const auto looks_of = [](const Moment& moment) {
        Looks looks;
        for (const DrawnPast::Item& item : *moment.items)
            if (item.pose != DrawnPast::nowhere)
                looks[moment.poses[item.pose].instance.key()].push_back(item);
        return looks;
    };
    const Looks a = looks_of(a_.back()), b = looks_of(b_.back());
    const auto same = [this](const DrawnPast::Item& p, const DrawnPast::Item& q) {
        return drawn_->same(p, q);
    };
    return static_cast<std::size_t>(std::ranges::count_if(a, [&](const auto& each) {
        const auto other = b.find(each.first);
        return other != b.end() && !std::ranges::equal(each.second, other->second, same);
    }));
}

void Comparison::report(const std::string& line) {
    log_.note(line);
    if (on_result) on_result(line);
}

void Comparison::report_error(const std::string& problem) {
    log_.error(problem);
    if (on_result) on_result("✗ " + problem);
}

}  // namespace fettle::console
