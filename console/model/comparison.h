#pragma once
// The last seconds of the game twice: A as they were, B with one property changed from their
// beginning on.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <model/log.h>

namespace fettle::console {

class Comparison {
  public:
    using Look = std::function<void(std::int64_t step)>;
    using Review = std::function<void(std::int64_t from, const Look& look)>;
    using Branch = std::function<void(std::int64_t from, const std::function<void()>& change,
                                      const Look& look)>;
    static constexpr std::size_t most_poses = 1'000'000;  // of one side
    static constexpr double apart = 0.01;                 // m; nearer poses count as the same

    struct Pose {
        property::Handle instance;
        property::Vec2 position{0, 0};  // m
        double angle = 0;               // rad
    };
    struct Moment {
        std::int64_t step = 0;
        std::vector<Pose> poses;  // in the order of the tree
        const Pose* find(property::Handle instance) const;
    };

    Comparison(property::Tree& tree, Log& log) : tree_(tree), log_(log) {}

    /// Receives what was found, in addition to the log; optional.
    std::function<void(const std::string& line)> found;

    /// Compares at the next `between_frames`. Throws Error for a path that names no writable
    /// property, and for another time than 0.1 to 60 s.
    void ask(const std::string& path, const property::Value& value, double seconds);
    void end();
    void between_frames(const Review& review, const Branch& branch);

    /// Whether there is something to show.
    bool shown() const { return !a_.empty() && !b_.empty(); }
    const std::vector<Moment>& a() const { return a_; }
    const std::vector<Moment>& b() const { return b_; }
    /// "world.ball.mass = 3 kg"
    const std::string& change() const { return change_; }
    /// Counts the comparisons.
    int number() const { return number_; }

  private:
    struct Asked {
        std::string path;
        property::Value value;
        double seconds;
    };
    std::int64_t first_step(const Asked& asked) const;
    Moment moment(std::int64_t step) const;
    void tell_difference();
    void tell(const std::string& line);

    property::Tree& tree_;
    Log& log_;
    std::optional<Asked> asked_;
    std::vector<Moment> a_, b_;
    std::string change_;
    int number_ = 0;
};

}  // namespace fettle::console
