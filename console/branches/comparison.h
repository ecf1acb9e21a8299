#pragma once
// Compares two runs: the last seconds as they were (A) and with one property changed from their
// beginning on (B); or the present branch of the past (A) and another branch (B).

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <observed/drawn_past.h>
#include <observed/noted_values.h>
#include <observed/review.h>
#include <text/log.h>

namespace fettle::console {

class Comparison {
  public:
    using Look = std::function<void(std::int64_t step)>;
    using RepeatWith = std::function<void(std::int64_t from, const std::function<void()>& change,
                                          const Look& visit)>;
    using ReviewBranch =
        std::function<void(const std::string& branch, std::int64_t from, const Look& visit)>;
    static constexpr std::size_t most_poses = 1'000'000;  // of one side
    static constexpr double apart = 0.01;                 // m; nearer poses count as the same

    struct Moment {
        std::int64_t step = 0;
        std::vector<Pose> poses{};         // in the order of the tree
        std::vector<std::string> paths{};  // of the poses; only at the present step
        property::Seen seen{};             // the visible part of the world
        DrawnPast::Items items{};
        const Pose* find(property::Handle instance) const;
        /// The pose of the same instance as one of another run. What was made in both runs after
        /// they parted has the same path.
        const Pose* counterpart(const Moment& other, std::size_t pose) const;
    };

    Comparison(property::Tree& tree, Log& log) : tree_(tree), log_(log) {}

    /// Receives the results and errors, in addition to the log; optional.
    std::function<void(const std::string& line)> on_result;

    /// Whether scripts draw by themselves; optional.
    std::function<bool()> scripts_draw;

    /// The part of the world that the game shows now; optional.
    std::function<property::Seen()> seen;

    /// Compares at the next `between_frames`. Throws Error for a path that names no writable
    /// property, and for another time than 0.1 to 60 s.
    void request_change(const std::string& path, const property::Value& value, double seconds);
    /// Compares the present branch of the past with another one; "": the one that was left last.
    /// Throws Error(unknown_name) if there is no such branch.
    void request_branch(const std::string& name);
    void end();
    void between_frames(const Review& review, const RepeatWith& repeat_with,
                        const ReviewBranch& other);

    /// Whether a request waits for `between_frames`.
    bool waits() const { return change_request_.has_value() || branch_request_.has_value(); }
    /// Whether there is something to show.
    bool shown() const { return !a_.empty() && !b_.empty(); }
    const std::vector<Moment>& a() const { return a_; }
    const std::vector<Moment>& b() const { return b_; }
    /// What was drawn at the moments of both. There is one while both are shown.
    const DrawnPast& drawn() const { return *drawn_; }
    /// The name of A: "as it was", or the name of a branch.
    const std::string& original() const { return original_; }
    /// The name of B: "world.ball.mass = 3 kg", or the name of a branch.
    const std::string& change() const { return change_; }
    /// Whether there is more in the game's pictures than in those of the runs: what scripts draw by
    /// themselves. Their functions read variables that have no past, and may change them.
    bool lacks_drawing() const { return lacks_drawing_; }
    /// The number of comparisons so far.
    int number() const { return number_; }

  private:
    struct ChangeRequest {
        std::string path;
        property::Handle instance;  // with the property
        property::Value value;
        double seconds;
    };
    struct BranchRequest {
        std::string name;
        std::int64_t fork, newest;  // steps
    };
    void require_there(const ChangeRequest& request, std::int64_t first) const;
    void compare_change(const Review& review, const RepeatWith& repeat_with);
    void compare_branches(const Review& review, const ReviewBranch& other);
    void cut_to_common_steps();
    std::int64_t first_step(const ChangeRequest& request) const;
    Moment moment(std::int64_t step, bool with_paths);
    std::size_t count_different_looks() const;
    void report_difference(const std::string& what);
    void report_values(const NotedValues& a, const NotedValues& b);
    void report(const std::string& line);
    void report_error(const std::string& problem);

    property::Tree& tree_;
    Log& log_;
    std::optional<ChangeRequest> change_request_;
    std::optional<BranchRequest> branch_request_;
    std::vector<Moment> a_, b_;
    std::unique_ptr<DrawnPast> drawn_;
    std::unique_ptr<DrawnPast> former_;  // the frame that is built now may have its pictures
    std::string original_, change_;
    bool lacks_drawing_ = false;
    int number_ = 0;
};

}  // namespace fettle::console
